#pragma once

#include <memory>
#include <optional>

#include "core/maths/vector.hpp"
#include "radar/atmosphere/atmosphere_table.hpp"
#include "radar/earth/sagnac.hpp"
#include "scene/model/world.hpp"

namespace sarsim::simulate {

/// What the atmosphere does to an echo on its way out and home.
struct AirEffect {
  double delay_s = 0.0;  ///< Added to the delay: of the group, where the envelope is.
  /// By how much the carrier's phase is ahead of that delay: two-way, by twice what electrons delay the group by.
  double ahead_turns = 0.0;
  double factor = 1.0;  ///< Of the amplitude: losses, and Faraday rotation of a linear polarisation, cos(2 x rotation).
};

/// The atmosphere of a scene between one radar and its scatterers. Const members are safe to call from many threads.
class AirPaths {
 public:
  /// @param carrier_hz  that the tables are for: the middle of the radar's carriers
  /// @param turning  of the world: the axis and centre of its Earth; at rest over a flat world, where height is z
  /// @param heights  of scatterers and radar, for which tables are made; others take longer
  AirPaths(const scene::Atmosphere& atmosphere, double carrier_hz, double light_speed_mps,
           const radar::TurningAxes& turning, radar::HeightSpan scatterers, radar::HeightSpan radars);

  /// Of the straight line between two points, world, for a carrier: what electrons do falls with its square, losses are
  /// those of the tables.
  [[nodiscard]] AirEffect between(const core::Vec3& radar_m, const core::Vec3& point_m, double carrier_hz) const;
  /// Whether any echo may have a phase that is ahead of its delay.
  [[nodiscard]] bool advances() const { return table_.model().atmosphere().vertical_tec_per_m2 > 0.0; }

  /// One way, as the tables have it.
  [[nodiscard]] radar::PathEffect one_way(const core::Vec3& radar_m, const core::Vec3& point_m) const;

  /// Optical path along the straight line of `one_way` minus that along the bent ray, m, one way; 0 without refraction.
  /// Accuracy of `radar::bending_gain_m`.
  [[nodiscard]] double bending_m(const core::Vec3& radar_m, const core::Vec3& point_m) const;

  /// Elevation of the straight line at its lower end, rad.
  [[nodiscard]] double elevation_rad(const core::Vec3& radar_m, const core::Vec3& point_m) const;

  /// Height above the ellipsoid, or above the plane: within 1e-5 of itself.
  [[nodiscard]] double height_m(const core::Vec3& point_m) const;

 private:
  [[nodiscard]] radar::StraightPath path(const core::Vec3& radar_m, const core::Vec3& point_m) const;

  radar::AtmosphereTable table_;
  double carrier_hz_;
  double light_speed_mps_;
  core::Vec3 centre_m_;
  core::Vec3 axis_;  // of the Earth, length 1; 0 over a flat world
};

/// Whether anything of it is on.
[[nodiscard]] bool is_on(const scene::Atmosphere& atmosphere);

}  // namespace sarsim::simulate
