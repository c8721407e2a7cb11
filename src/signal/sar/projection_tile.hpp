#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "core/maths/vector.hpp"

namespace sarsim::signal {

/// Positions of the points of one stretch of all rows of a tile on a curved surface:
///
///     sum over a, b of terms[a][b] (row - middle_row)^a j^b,     a and b from 0 to 3,
///
/// with j the column counted from the middle of the stretch; m, world.
struct StretchSurface {
  static constexpr double middle_row = 15.5;

  std::array<std::array<core::Vec3, 4>, 4> terms{};

  /// The point of a row and a column j, world.
  [[nodiscard]] core::Vec3 point_m(double row, double j) const;
};

/// Rows and columns of points and their sums: in a plane, corner + row * row_step + column * column_step, or on a
/// curved surface.
struct ProjectionTile {
  static constexpr std::size_t rows = 32;
  static constexpr std::size_t columns = 64;

  core::Vec3 corner_m;
  core::Vec3 row_step_m;
  core::Vec3 column_step_m;
  std::span<const StretchSurface> surface{};  ///< Of each stretch of columns, kept elsewhere; empty: the plane.
  std::span<const core::Vec3> points_m{};     ///< Of each point, row by row, for Stretch::by_point; empty: as above.
  std::size_t used_rows = rows;               ///< The others are not computed.
  std::size_t used_columns = columns;         ///< The others are computed in part.
  alignas(64) std::array<float, rows * columns> re{};
  alignas(64) std::array<float, rows * columns> im{};
  alignas(64) std::array<float, rows * columns> weight{};  ///< Sum of weights; left alone by Kind::all.

  /// Position of a point, world.
  [[nodiscard]] core::Vec3 point_m(std::size_t row, std::size_t column) const;
};

/// How delays vary along a stretch of a row: as a polynomial of degree 3 about its middle, or point by point, in double
/// precision, where that is not exact enough.
enum class Stretch : std::size_t { by_point = 0, of_16 = 16, of_32 = 32, of_64 = 64 };

/// The longest stretch whose neglected term of degree 4, (h s)^4/(8 d^3) for points s apart, h = half the stretch, and
/// a distance d, turns the phase by less than 1e-5 cycles.
[[nodiscard]] Stretch stretch_for(double nearest_m, double column_step_m, double wavelength_m);

}  // namespace sarsim::signal
