#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/maths/vector.hpp"
#include "radar/echo/curve_tables.hpp"
#include "radar/echo/echo_batch.hpp"
#include "radar/path/light_time.hpp"

namespace sarsim::radar {

/// Gaussian deviations of points, drawn anew for every pulse. Columns that are empty stand for no deviation.
struct PointJitter {
  std::vector<double> x_stddev_m, y_stddev_m;  ///< In the platform's frame; both or none.
  std::vector<double> z_stddev_m;
  std::vector<std::uint64_t> position_key;  ///< RandomStream::key() of the point's RandomKind::target_position.

  std::vector<double> rcs_m2, rcs_stddev_m2;  ///< Instead of PointArrays::root_rcs_m; negative sums count as 0.
  std::vector<std::uint64_t> rcs_key;

  std::vector<double> azimuth_rad, elevation_rad;  ///< Of the normal, instead of PointArrays::normal_x, y and z.
  std::vector<double> azimuth_stddev_rad, elevation_stddev_rad;
  std::vector<std::uint64_t> pointing_key;
};

/// Point scatterers of one platform, structure of arrays, in the platform's frame.
struct PointArrays {
  /// Cross-section against the angle from the normal: always the same; its cosine, 0 behind; a table.
  enum class Law { isotropic, cosine, curve };

  Law law = Law::isotropic;
  std::vector<double> x_m, y_m, z_m;
  std::vector<double> root_rcs_m;                    ///< Square root of the cross-section, facing the radar.
  std::vector<double> normal_x, normal_y, normal_z;  ///< Unit normals; not for Law::isotropic.
  std::vector<double> curve_cell;                    ///< First cell of the point's table; Law::curve.
  PointJitter jitter;

  [[nodiscard]] std::size_t size() const { return x_m.size(); }
};

/// What a radar's antennas do to an echo, transmit times receive; made once per radar.
struct AntennaView {
  enum class Offsets {
    antenna_frame,  ///< Azimuth and elevation in the antenna's frame.
    world_angles,   ///< Differences between azimuth and elevation in the world and those of the axis.
  };

  Offsets offsets = Offsets::antenna_frame;
  /// 0.88/(2 beamwidth) of sin(x)/x cuts, turns per unit of the offset's sine: transmit azimuth, transmit elevation,
  /// receive azimuth, receive elevation; 0 stands for no such cut.
  std::array<double, 4> cut{};
  bool roots = false;  ///< Take the root of the magnitude of each antenna's sin(x)/x.
  /// Decibels against degrees of user-defined cuts, in the order of `cut`: the first cell of a table, or below 0 for no
  /// such cut.
  CurveTables curves;
  std::array<double, 4> curve_cell{-1.0, -1.0, -1.0, -1.0};
};

/// One pulse's view of a platform: everything relative to the radar as it sends, world axes.
struct ViewFrame {
  LightTime light_time = LightTime::exact;
  core::Mat3 world_from_platform;  ///< At the anchor.
  core::Mat3 world_from_platform_rate;
  core::Vec3 origin_m;           ///< Platform's origin at the anchor less the radar's position as it sends.
  core::Vec3 velocity_mps;       ///< Platform's velocity at the anchor; LightTime::thesis: less the radar's.
  double anchor_s = 0.0;         ///< After sending: when about the pulse meets the platform; 0 by LightTime::thesis.
  core::Vec3 radar_mps;          ///< The radar's way until about the echo is back over that time; LightTime::exact,
  core::Vec3 radar_slope_mps;    ///< and the mean of its velocities then.
  bool moves = false;            ///< Whether any point of the platform has a velocity; LightTime::exact.
  bool bends = false;            ///< Whether bends are asked for; LightTime::exact.
  core::Vec3 acceleration_mps2;  ///< Of the platform at the anchor, for bends,
  core::Mat3 world_from_platform_acceleration{{core::Vec3{}, core::Vec3{}, core::Vec3{}}};
  core::Vec3 radar_mps2;          ///< and of the radar.
  double back_s = 0.0;            ///< After sending: when about the echo is back, to where `radar_mps` is the mean.
  core::Mat3 antenna_from_world;  ///< AntennaView::Offsets::antenna_frame.
  double axis_azimuth_rad = 0.0;  ///< AntennaView::Offsets::world_angles.
  double axis_elevation_rad = 0.0;
  std::int64_t pulse = 0;  ///< Counter of the random deviations.
  double light_speed_mps = 0.0;
  double amplitude_scale = 0.0;  ///< sqrt(P Gt Gr/L) lambda/(4 pi)^1.5.
  bool spreading = true;         ///< Divide by the way out times the way home.
};

/// Echoes from closer than this, or stronger than that, may be impossible.
inline constexpr double doubtful_distance_m = 1e-6;
inline constexpr double doubtful_amplitude = 1e29;

/// A run of points, [begin, end).
struct PointSpan {
  std::size_t begin = 0;
  std::size_t end = 0;

  [[nodiscard]] std::size_t size() const { return end - begin; }
};

/// Computes the echoes of a run of points in SIMD: delay, stretch and bend of the flight, amplitude of the radar
/// equation with antenna, reflectivity and random deviations, as `PulseGeometry::view` has them: delays and stretches
/// to rounding, amplitudes to rounding and the tables' tolerance. A point that shows its back (Law::cosine) has
/// amplitude 0.
/// @param curves      of Law::curve
/// @param[out] echoes elements [first, first + run.size()), which must be there, are replaced; bends where there are
///                    some
/// @return whether all are certain to be possible: not closer than `doubtful_distance_m`, slower than 0.999 c, not
///         stronger than `doubtful_amplitude`; false for NaN
[[nodiscard]] bool write_echoes(const PointArrays& points, const PointSpan& run, const ViewFrame& frame,
                                const AntennaView& antenna, const CurveTables& curves, EchoBatch& echoes,
                                std::size_t first);

}  // namespace sarsim::radar
