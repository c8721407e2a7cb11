#pragma once

#include <cstddef>
#include <vector>

#include "process/focusing.hpp"
#include "process/sar_track.hpp"
#include "simulate/plan.hpp"

namespace sarsim {

/// One pulse's sight of one target, as focusing takes it: from where the antenna was, or, where its motion is
/// compensated, from the nearest point of the straight line.
struct SarLook {
  double time_s = 0.0;  ///< From the track's middle.
  double distance_m = 0.0;
  double doppler_hz = 0.0;
  double delay_s = 0.0;
  double amplitude = 0.0;  ///< Of the echo, volts.
};

/// The pulses of a plan as looks at each of its targets; of more than 2048 pulses, some that are evenly spaced.
class SarLooks {
 public:
  /// Keeps a reference to the plan.
  /// @param echoes  their track, and whether they are compensated to its line; no rows are read
  SarLooks(const Plan& plan, const EchoRows& echoes);

  [[nodiscard]] std::size_t targets() const { return looks_.size(); }
  [[nodiscard]] const std::vector<SarLook>& of(std::size_t target) const { return looks_[target]; }
  [[nodiscard]] const StraightTrack& track() const { return track_; }
  /// Pulse of the echoes that look number i is at.
  [[nodiscard]] std::size_t pulse(std::size_t i) const { return i * step_; }

  /// Where echoes of this look are focused to when they are taken to have that Doppler frequency.
  [[nodiscard]] ImagePlace place(const SarLook& look, double doppler_hz) const;

 private:
  [[nodiscard]] SarLook from_line(SarLook look, const Pose& radar, const Pose& platform, const Vec3& point_m) const;

  const Plan& plan_;
  StraightTrack track_;
  std::size_t step_ = 1;
  std::vector<std::vector<SarLook>> looks_;
};

}  // namespace sarsim
