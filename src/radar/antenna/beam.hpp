#pragma once

#include <array>

#include "core/maths/interpolator.hpp"
#include "core/maths/vector.hpp"

namespace sarsim::radar {

/// How a beam follows the platform's rotation, and how offsets from it are measured (decision 11).
enum class PointingRule {
  boresight,     ///< The antenna frame turns with the platform; offsets are angles in that frame.
  added_angles,  ///< Platform yaw and pitch are added to the beam's angles; offsets are differences of world angles
                 ///< (1998).
};

/// Where an antenna points (thesis 4.4; decision 11). Angles in the platform's frame, azimuth from +y towards
/// +x.
struct Beam {
  /// Always the same angles; an azimuth that turns at a constant rate; a point that is looked at; angles against time.
  enum class Kind { fixed, rotating, spot, user };

  Kind kind = Kind::fixed;
  double azimuth_rad = 0.0;                          ///< Kind::fixed.
  double elevation_rad = 0.0;                        ///< Kind::fixed, Kind::rotating.
  double rate_rad_per_s = 0.0;                       ///< Kind::rotating: azimuth = rate t.
  core::Vec3 spot_world_m;                           ///< Kind::spot.
  std::array<core::Interpolator, 3> target_world_m;  ///< Kind::user: world point looked at against time [s].
};

/// The offset of a direction from the beam's axis.
struct BeamOffset {
  double azimuth_rad = 0.0;
  double elevation_rad = 0.0;
};

/// Where the beam of one pulse points; tells how far any direction lies off its axis.
class Pointing {
 public:
  /// @param time_s                the pulse's send time
  /// @param radar_world_m         the radar's position
  /// @param world_from_platform   the rotation of its platform
  /// @param rotation_rad          the angles of that rotation (PointingRule::added_angles)
  ///
  /// PointingRule::boresight: the antenna frame has y along the boresight and z up as far as possible: up is the
  /// platform's z for fixed and rotating beams, which are mounted on it (so that a roll of the platform rolls the
  /// pattern), and the world's z for beams that are steered to a point of the world.
  Pointing(const Beam& beam, PointingRule rule, double time_s, const core::Vec3& radar_world_m,
           const core::Mat3& world_from_platform, const std::array<double, 3>& rotation_rad);

  /// Offset of the direction `look_world` (need not be a unit vector) from the axis. Boresight rule: azimuth
  /// atan2(x, y) and elevation asin(z) in the antenna frame. Added angles: differences of azimuth and of elevation.
  [[nodiscard]] BeamOffset offset(const core::Vec3& look_world) const;

  /// Rows are the antenna's axes x, y (boresight), z in the world; PointingRule::boresight only.
  [[nodiscard]] const core::Mat3& antenna_from_world() const { return antenna_from_world_; }

  /// Angles of the axis in the world, not wrapped; PointingRule::added_angles only.
  [[nodiscard]] double axis_azimuth_rad() const { return azimuth_rad_; }
  [[nodiscard]] double axis_elevation_rad() const { return elevation_rad_; }

  /// Unit vector along the axis.
  [[nodiscard]] core::Vec3 axis_world() const;

 private:
  PointingRule rule_;
  core::Mat3 antenna_from_world_;
  double azimuth_rad_ = 0.0;
  double elevation_rad_ = 0.0;
};

}  // namespace sarsim::radar
