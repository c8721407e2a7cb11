#pragma once

#include <optional>

#include "radar/earth/earth_frame.hpp"
#include "radar/earth/instant.hpp"
#include "radar/earth/turning_frame.hpp"
#include "scene/ephemeris/ephemeris_file.hpp"
#include "scene/model/scene.hpp"

namespace sarsim::workflow {

/// Turns states of files into the world of a scene: the one place where inertial axes become Earth-fixed ones.
class WorldAxes {
 public:
  /// @param world  with a sound epoch, or none
  explicit WorldAxes(const scene::World& world);

  [[nodiscard]] const std::optional<radar::EarthFrame>& earth() const { return earth_; }
  [[nodiscard]] const std::optional<radar::Instant>& epoch() const { return epoch_; }
  [[nodiscard]] const radar::EarthOrientation& orientation() const { return orientation_; }

  /// A state over the Earth in the world; over a flat world the same.
  [[nodiscard]] radar::StateVector from_ecef(const radar::StateVector& state) const;
  /// A state in a frame, at a time of the scene; other frames than ITRF need Earth and epoch.
  [[nodiscard]] radar::StateVector from(scene::Frame frame, const radar::StateVector& state, double time_s) const;
  /// World axes of a vector in the axes of a frame, at a time of the scene; needs Earth and epoch.
  [[nodiscard]] core::Mat3 world_from(scene::Frame frame, double time_s) const;

 private:
  [[nodiscard]] radar::TurningFrame ecef_from(scene::Frame frame, double time_s) const;

  std::optional<radar::EarthFrame> earth_;
  std::optional<radar::Instant> epoch_;
  radar::EarthOrientation orientation_;
};

}  // namespace sarsim::workflow
