#include "simulate/survey/beam_passes.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/maths/constants.hpp"
#include "core/report/expect.hpp"
#include "simulate/plan/pulse_geometry.hpp"

namespace sarsim::simulate {

namespace {

class BeamPasses {
 public:
  BeamPasses(const ResolvedScene& scene, const Link& radar, const radar::PulseRange& pulses)
      : scene_(scene), radar_(radar), pulses_(pulses), geometry_(scene, radar) {
    first_s_ = radar.repetition.send_time_s(pulses.first);
    last_s_ = radar.repetition.send_time_s(pulses.last);
    turn_s_ = 2.0 * core::pi / radar.beam.rate_rad_per_s;
  }

  [[nodiscard]] double first_s() const { return first_s_; }
  [[nodiscard]] double last_s() const { return last_s_; }

  // Up to `most` pulses; of all targets one pass, then another, at times spread over the recording.
  [[nodiscard]] std::vector<std::int64_t> pulses(std::size_t most) {
    std::vector<std::int64_t> found;
    for (std::size_t round = 0; round < max_passes; ++round)
      for (std::size_t i = 0; i < scene_.scatterers.size(); ++i) {
        if (found.size() >= most) return found;
        const double share = static_cast<double>(round) / static_cast<double>(max_passes - 1);
        if (const auto pulse = met(i, first_s_ + share * (last_s_ - first_s_))) found.push_back(*pulse);
      }
    return found;
  }

  // The pulse near a time at which the beam points nearest to a target: the beam gets there in the time that it takes
  // for what is missing of the angle. Both move meanwhile, hence the second look.
  [[nodiscard]] std::optional<std::int64_t> met(std::size_t target, double time_s) {
    for (int look = 0; look < 2; ++look) {
      geometry_.set_pulse(pulse_at(time_s));
      const Scatterer& s = scene_.scatterers[target];
      const core::Vec3 look_world_m =
          radar::world_position_m(geometry_.pose(s.platform), s.position_m) - geometry_.radar_pose().position_world_m;
      const double offset_rad = std::remainder(geometry_.pointing().offset(look_world_m).azimuth_rad, 2.0 * core::pi);
      if (!std::isfinite(offset_rad)) return std::nullopt;  // of positions that no number holds
      const auto moved = recorded(geometry_.send_time_s() + offset_rad / (2.0 * core::pi) * turn_s_);
      if (!moved) return std::nullopt;
      time_s = *moved;
    }
    return pulse_at(time_s);
  }

 private:
  static constexpr std::size_t max_passes = 5;  // of each target

  [[nodiscard]] std::int64_t pulse_at(double time_s) const {
    const double half_s = 0.5 * radar_.repetition.mean_interval_s();
    const radar::PulseRange near = radar_.repetition.pulses_in(time_s - half_s, time_s + half_s);
    return std::clamp(near.first, pulses_.first, pulses_.last);
  }

  // A time, or one some turns before or after it, that is within the recording.
  [[nodiscard]] std::optional<double> recorded(double time_s) const {
    const double turn_s = std::abs(turn_s_);
    if (time_s < first_s_) time_s += turn_s * std::ceil((first_s_ - time_s) / turn_s);
    if (time_s > last_s_) time_s -= turn_s * std::ceil((time_s - last_s_) / turn_s);
    if (time_s < first_s_) return std::nullopt;
    return time_s;
  }

  const ResolvedScene& scene_;
  const Link& radar_;
  radar::PulseRange pulses_;
  PulseGeometry geometry_;
  double first_s_ = 0.0;
  double last_s_ = 0.0;
  double turn_s_ = 0.0;  // negative where the beam turns the other way
};

}  // namespace

bool is_scanning(const radar::Beam& beam) {
  return beam.kind == radar::Beam::Kind::rotating && beam.rate_rad_per_s != 0.0;
}

std::vector<std::int64_t> pulses_on_targets(const Acquisition& acquisition, std::size_t most) {
  CORE_EXPECT(acquisition.scene != nullptr);
  return BeamPasses(*acquisition.scene, acquisition.link, acquisition.timing.pulses).pulses(most);
}

std::optional<std::int64_t> pulse_on_target(const ResolvedScene& scene, const Link& radar,
                                            const radar::PulseRange& pulses, std::size_t target) {
  CORE_EXPECT(target < scene.scatterers.size());
  BeamPasses passes(scene, radar, pulses);
  return passes.met(target, 0.5 * (passes.first_s() + passes.last_s()));
}

}  // namespace sarsim::simulate
