#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "echo/echo_batch.hpp"
#include "math/vector.hpp"

namespace sarsim {

/// Point scatterers of one platform, structure of arrays, in the platform's frame.
struct PointArrays {
  std::vector<double> x_m, y_m, z_m;
  std::vector<double> root_rcs_m;                    ///< Square root of the cross-section, facing the radar.
  std::vector<double> normal_x, normal_y, normal_z;  ///< Unit normals of the cosine law; empty: isotropic.

  [[nodiscard]] std::size_t size() const { return x_m.size(); }
};

/// One pulse's view of a platform: everything relative to the radar.
struct SightFrame {
  Mat3 world_from_platform;
  Mat3 world_from_platform_rate;
  Vec3 origin_m;      ///< Platform's origin less the radar's position, world axes.
  Vec3 velocity_mps;  ///< Platform's velocity less the radar's.
  double light_speed_mps = 0.0;
  double amplitude_scale = 0.0;  ///< sqrt(P Gt Gr/L) lambda/(4 pi)^1.5.
  bool spreading = true;         ///< Divide by the distance squared.
};

/// A sin(x)/x pattern in the antenna's own frame (antenna/pattern.hpp, PatternRule::amplitude), transmit times receive.
struct SinxBeam {
  Mat3 antenna_from_world;
  /// 0.88/(2 beamwidth) of each cut, turns per unit of sine: transmit azimuth, transmit elevation, receive azimuth,
  /// receive elevation; 0 stands for a cut of gain 1.
  double cut[4] = {0.0, 0.0, 0.0, 0.0};
};

/// Appends the echoes of points [first, first + count) in SIMD: range, radial speed, delay 2 d/(c - v), amplitude of
/// the radar equation, as `PulseGeometry::view` has them, to rounding. A point at the radar's own position gets an
/// infinite amplitude, which the caller looks for. A point that shows its back has amplitude 0.
/// @param beam  null: isotropic
void append_echoes(const PointArrays& points, std::size_t first, std::size_t count, const SightFrame& frame,
                   const SinxBeam* beam, EchoBatch& echoes);

}  // namespace sarsim
