#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "math/interpolator.hpp"

namespace sarsim {

/// Functions of an angle of 0 to 180 degrees as polynomials piece by piece, laid out for look-up in SIMD.
///
/// Pieces end at the knots, so that linear and cubic curves are met to rounding, kinks and all; low-pass curves, which
/// are smooth between points of their grid, are cut further until the error is small enough. To find the piece of an
/// angle, the angles are divided into equal cells: a cell names the piece at its left end, and few halvings find the
/// right one among those that begin in the cell.
struct CurveTables {
  /// Two fields of a piece's record; the coefficients of powers of (angle - centre), lowest first, follow.
  enum Field : std::size_t { left_end, centre, coefficients };

  std::vector<std::uint32_t> number;      ///< Of the table of each given curve; equal curves share one.
  std::size_t count = 0;                  ///< Tables.
  std::size_t cells = 1;                  ///< Of each table.
  std::size_t degree = 1;                 ///< Of all polynomials.
  std::size_t first_stride = 0;           ///< Of the search among the pieces of a cell, in pieces; halved down to 1.
  std::vector<std::int64_t> cell_record;  ///< Table by table, cell by cell: offset in `records` of the cell's piece.
  std::vector<double> records;            ///< Piece by piece; each table ends with records that begin at infinity.
  bool sound = true;                      ///< All curves are finite everywhere; otherwise there are no tables.

  [[nodiscard]] std::size_t record_size() const { return Field::coefficients + degree + 1; }
};

/// Tabulates curves over 0 to 180 degrees.
/// @param curves        decibels against degrees
/// @param tolerance_db  largest error; not below the rounding of the curves themselves, 1e-13 of their ordinates
[[nodiscard]] CurveTables tabulate(std::span<const Interpolator* const> curves, double tolerance_db);

}  // namespace sarsim
