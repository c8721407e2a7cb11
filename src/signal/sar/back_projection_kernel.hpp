#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "core/maths/vector.hpp"

namespace sarsim::signal {

/// What all pulses of a back-projection have in common.
struct ProjectionConstants {
  double carrier_hz = 0.0;
  double light_speed_mps = 0.0;
  double first_delay_s = 0.0;
  double records_per_s = 0.0;     ///< EchoRecords::factor times the sampling rate.
  double doppler_delay_s2 = 0.0;  ///< 1/K: the peak of a chirp of rate K lies fd/K before its delay. 0: it does not.
  bool moving = true;             ///< Delay 2 (d - r.V/c)/(c (1 - V^2/c^2)), else 2 d/c.
  std::size_t record_count = 0;   ///< Of a pulse.
};

/// Where a pulse was sent and how fast the antenna flew.
struct ProjectionPulse {
  core::Vec3 position_m;
  core::Vec3 velocity_mps;
  const float* records = nullptr;  ///< signal/sar/echo_records.hpp.
  double carrier_hz = 0.0;         ///< 0: that of the constants.
  double later_s = 0.0;            ///< By how much its first record is later than that of the constants.
  bool bistatic = false;           ///< Received at `receiver_m`: the delay is the sum of both ways. At rest.
  core::Vec3 receiver_m{};

  [[nodiscard]] double carrier_of(const ProjectionConstants& constants) const {
    return carrier_hz > 0.0 ? carrier_hz : constants.carrier_hz;
  }
};

/// Which pulses a point takes, by a number `place` that runs from -1/2 to 1/2 along the aperture.
struct ProjectionAperture {
  /// All pulses; those from whose heading the point lies at some angles; those sent at some times.
  enum class Kind { all, angle, time } kind = Kind::all;
  core::Vec3 heading;       ///< Length 1; 0: that of each pulse's velocity.
  double squint_rad = 0.0;  ///< Of the middle: ahead of the plane perpendicular to the heading.
  double extent = 0.0;      ///< angle: rad, time: s.
  bool uniform = true;      ///< No weight but 0 and 1.
  static constexpr std::size_t pieces = 512;
  std::vector<float> weights;  ///< pieces + 1 values from place -1/2 to 1/2 and one more; empty where uniform.
};

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

/// Adds to the tile, for each of its points x and each pulse,
///
///     w s(tau(x) - fd/K) exp(+j 2 pi (f tau(x) + fd^2/(2 K))),      fd = -2 v f/c,
///
/// s the pulse's echo between records and w its weight; tau is the light time there and back to the antenna as it flies
/// on, exact for an even flight (radar/path/light_time.hpp). Distances, delays and the reference of every phase are in
/// double precision at the middle of each stretch; from there a polynomial in float leads on, with whole turns per
/// point taken out of its linear term: within 1.3e-5 cycles of the exact phase and 1e-3 of a record. SIMD with run-time
/// choice of the instruction set.
/// @param tile  with as many pieces of a surface as stretches, if it has a surface and no points
void project(std::span<const ProjectionPulse> pulses, const ProjectionConstants& constants,
             const ProjectionAperture& aperture, Stretch stretch, ProjectionTile& tile);

}  // namespace sarsim::signal
