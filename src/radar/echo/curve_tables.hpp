#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/maths/angle_function.hpp"

namespace sarsim::radar {

/// Functions of an angle as polynomials piece by piece, laid out for look-up in SIMD: over 0 to 180 degrees if all are
/// even, otherwise over -180 to 180 degrees.
///
/// Pieces end at the knots, so that linear and cubic curves are met to rounding, kinks and all; low-pass curves, which
/// are smooth between points of their grid, are cut further until the error is small enough. To find the piece of an
/// angle, the angles are divided into equal cells. Where no piece begins inside a cell, as with knots at whole degrees,
/// or one, the cell holds its one or two pieces; otherwise (`crowded`) it names the piece at its left end, and few
/// halvings find the right one among those that begin in the cell.
struct CurveTables {
  /// A piece's record of 4 or 8 numbers: where it begins, what its powers are about, and their coefficients, lowest
  /// first.
  enum Field : std::size_t { left_end, centre, coefficients };

  double first_deg = 0.0;                 ///< First angle of all tables: 0, or -180 if they are signed.
  double span_deg = 180.0;                ///< Range of angles from there. Records count from `first_deg`.
  std::vector<std::uint32_t> number;      ///< Of the table of each given curve; equal curves share one.
  std::size_t count = 0;                  ///< Tables.
  std::size_t cells = 1;                  ///< Of each table; a table's first cell is its number times `cells`.
  std::size_t degree = 1;                 ///< Of all polynomials: 1 or 5.
  std::size_t first_stride = 0;           ///< Of the search among the pieces of a cell, in pieces; halved down to 1.
  bool crowded = false;                   ///< The pieces of a cell are found by `cell_record` and have centres.
  std::vector<std::int64_t> cell_record;  ///< Cell by cell: offset in `records` of the cell's first piece; if crowded.
  std::vector<double> records;            ///< If crowded, table by table, each ended by records that begin at infinity;
                                          ///< otherwise cell by cell, with powers about the middle of the cell.
  bool sound = true;                      ///< All curves are finite everywhere; otherwise there are no tables.

  [[nodiscard]] std::size_t record_size() const { return Field::coefficients + degree + 1; }
  /// Distance from a cell to the next, in numbers of `cell_record` or of `records`.
  [[nodiscard]] std::size_t cell_stride() const { return crowded ? 1 : (first_stride + 1) * record_size(); }
};

/// Tabulates curves over 0 to 180 degrees.
/// @param curves        decibels against degrees
/// @param tolerance_db  largest error; not below the rounding of the curves themselves, 1e-13 of their ordinates
[[nodiscard]] CurveTables tabulate(std::span<const core::Interpolator* const> curves, double tolerance_db);
/// The same for curves that need not be even.
[[nodiscard]] CurveTables tabulate(std::span<const core::AngleFunction* const> curves, double tolerance_db);

}  // namespace sarsim::radar
