#include "simulate/survey/meetings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/task/stop_points.hpp"
#include "simulate/plan/pulse_geometry.hpp"

namespace sarsim::simulate {

namespace {

constexpr std::size_t max_candidates = 64;

// A target and, of the sampled pulses, the one at which it is nearest.
struct Candidate {
  std::size_t target = 0;
  std::size_t nearest = 0;  // among the sampled pulses
  double distance_m = std::numeric_limits<double>::infinity();
  bool possible_at_first = true;
};

class MeetingSearch {
 public:
  MeetingSearch(const Acquisition& acquisition, const EchoSurvey& survey, std::span<const std::int64_t> pulses,
                const core::WorkControl& control)
      : acquisition_(acquisition),
        survey_(survey),
        pulses_(pulses),
        control_(control),
        geometry_(*acquisition.scene, acquisition.link) {}

  std::vector<ImpossiblePulse> run() {
    choose();
    if (candidates_.empty()) return {};
    look_at_samples();
    std::vector<ImpossiblePulse> found;
    for (const Candidate& candidate : candidates_) {
      core::end_if_asked(control_.stop);
      if (!candidate.possible_at_first) continue;
      const std::int64_t pulse = nearest_pulse(candidate);
      geometry_.set_pulse(pulse);
      const EchoExtremes echo = echo_of(candidate.target);
      if (possible_echo(echo, acquisition_.light_speed_mps())) continue;
      found.push_back({candidate.target, pulse, acquisition_.link.repetition.send_time_s(pulse), echo});
    }
    std::ranges::sort(found, {}, &ImpossiblePulse::target);
    return found;
  }

 private:
  void choose() {
    double gap_s = 0.0;
    for (std::size_t i = 1; i < pulses_.size(); ++i)
      gap_s = std::max(gap_s, acquisition_.link.repetition.send_time_s(pulses_[i]) -
                                  acquisition_.link.repetition.send_time_s(pulses_[i - 1]));
    constexpr double reach = 2.0;  // Speeds change between two samples.
    for (std::size_t i = 0; i < survey_.targets.size(); ++i) {
      const TargetSurvey& target = survey_.targets[i];
      if (!(target.nearest_m > reach * gap_s * target.largest_speed_mps)) candidates_.push_back({.target = i});
    }
    const auto nearer = [&](const Candidate& a, const Candidate& b) {
      const double a_m = survey_.targets[a.target].nearest_m;
      const double b_m = survey_.targets[b.target].nearest_m;
      return a_m < b_m || (a_m == b_m && a.target < b.target);
    };
    std::ranges::sort(candidates_, nearer);
    candidates_.resize(std::min(candidates_.size(), max_candidates));
  }

  void look_at_samples() {
    for (std::size_t p = 0; p < pulses_.size(); ++p) {
      geometry_.set_pulse(pulses_[p]);
      for (Candidate& candidate : candidates_) {
        const EchoExtremes echo = echo_of(candidate.target);
        if (p == 0) candidate.possible_at_first = possible_echo(echo, acquisition_.light_speed_mps());
        if (!(echo.distance_m < candidate.distance_m)) continue;
        candidate.distance_m = echo.distance_m;
        candidate.nearest = p;
      }
    }
  }

  // Between the samples around the nearest one the distance falls and rises again.
  std::int64_t nearest_pulse(const Candidate& candidate) {
    std::int64_t low = pulses_[candidate.nearest - std::min<std::size_t>(candidate.nearest, 1)];
    std::int64_t high = pulses_[std::min(candidate.nearest + 1, pulses_.size() - 1)];
    while (high - low > 2) {
      const std::int64_t third = (high - low) / 3;
      if (distance_m(candidate.target, low + third) < distance_m(candidate.target, high - third))
        high -= third;
      else
        low += third;
    }
    std::int64_t best = low;
    for (std::int64_t pulse = low + 1; pulse <= high; ++pulse)
      if (distance_m(candidate.target, pulse) < distance_m(candidate.target, best)) best = pulse;
    return best;
  }

  double distance_m(std::size_t target, std::int64_t pulse) {
    geometry_.set_pulse(pulse);
    return geometry_.view(target).distance_m;
  }

  [[nodiscard]] EchoExtremes echo_of(std::size_t target) const {
    const ScattererView view = geometry_.view(target);
    return {view.distance_m > closest_echo_m ? view.distance_m : 0.0, view.speed_mps, view.amplitude_sqrt_w};
  }

  const Acquisition& acquisition_;
  const EchoSurvey& survey_;
  std::span<const std::int64_t> pulses_;
  const core::WorkControl& control_;
  PulseGeometry geometry_;
  std::vector<Candidate> candidates_;
};

}  // namespace

std::vector<ImpossiblePulse> impossible_pulses(const Acquisition& acquisition, const EchoSurvey& survey,
                                               std::span<const std::int64_t> pulses, const core::WorkControl& control) {
  if (pulses.size() < 2) return {};
  return MeetingSearch(acquisition, survey, pulses, control).run();
}

}  // namespace sarsim::simulate
