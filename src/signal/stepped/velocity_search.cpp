#include "signal/stepped/velocity_search.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

#include "core/report/expect.hpp"
#include "radar/path/path.hpp"

namespace sarsim::signal {

namespace {

// Bursts [first, first + count) of the echoes, as one cost of the search.
class Sharpness {
 public:
  Sharpness(const ProfileMaker& maker, const BurstEchoes& echoes, std::size_t first, std::size_t count)
      : maker_(maker), echoes_(echoes), pulses_(maker.band().waveform().burst_pulses()), first_(first), count_(count) {}

  // Of at most so many bursts, evenly spread.
  [[nodiscard]] double entropy(double speed_mps, std::size_t most) const {
    const std::size_t used = std::min(most, count_);
    const double at_s = middle_of(times(first_ + count_ / 2));
    std::vector<double> power(maker_.period());
    for (std::size_t i = 0; i < used; ++i) {
      const std::size_t burst = first_ + (used > 1 ? i * (count_ - 1) / (used - 1) : 0);
      const std::size_t size = maker_.band().values_per_burst();
      maker_.add_power(std::span(echoes_.values).subspan(burst * size, size),
                       motion_of_speed(times(burst), at_s, speed_mps, maker_.band().waveform().light_speed_mps), power);
    }
    return entropy_of(power);
  }

  [[nodiscard]] double span_s() const {
    const auto last = times(first_ + count_ - 1);
    return last.back() - times(first_).front();
  }

 private:
  [[nodiscard]] std::span<const double> times(std::size_t burst) const {
    return std::span(echoes_.time_s).subspan(burst * pulses_, pulses_);
  }

  const ProfileMaker& maker_;
  const BurstEchoes& echoes_;
  std::size_t pulses_;
  std::size_t first_;
  std::size_t count_;
};

struct Candidate {
  double speed_mps = 0.0;
  double entropy = 0.0;
};

constexpr std::size_t max_bursts = 16;
constexpr std::size_t max_candidates = 8;

// Evenly spaced speeds about a middle.
std::vector<double> speeds_about(double middle_mps, double step_mps, int to_either_side) {
  std::vector<double> speeds;
  for (int i = -to_either_side; i <= to_either_side; ++i) speeds.push_back(middle_mps + i * step_mps);
  return speeds;
}

std::vector<Candidate> judged(const Sharpness& cost, const std::vector<double>& speeds,
                              const core::WorkControl& control) {
  std::vector<Candidate> candidates(speeds.size());
  core::parallel_ranges(speeds.size(), 1, control, [&](std::size_t i, std::size_t) {
    candidates[i] = {speeds[i], cost.entropy(speeds[i], max_bursts)};
  });
  return candidates;
}

// The sharpest of them, no two nearer than `apart_mps`, sharpest first.
std::vector<Candidate> sharpest(std::vector<Candidate> all, double apart_mps) {
  std::ranges::stable_sort(all, {}, &Candidate::entropy);
  std::vector<Candidate> best;
  for (const Candidate& candidate : all) {
    if (best.size() == max_candidates) break;
    const auto near = [&](const Candidate& b) { return std::abs(b.speed_mps - candidate.speed_mps) < apart_mps; };
    if (std::ranges::none_of(best, near)) best.push_back(candidate);
  }
  return best;
}

// The sharpest speed within a step of another one, to a sixty-fourth of the step.
Candidate refined(const Sharpness& cost, Candidate best, double step_mps, const core::WorkControl& control) {
  for (int round = 0; round < 3; ++round) {
    step_mps *= 0.25;
    best = sharpest(judged(cost, speeds_about(best.speed_mps, step_mps, 4), control), 0.0).front();
  }
  return best;
}

}  // namespace

std::vector<PulseMotion> motion_of_speed(std::span<const double> time_s, double at_s, double speed_mps,
                                         double light_speed_mps) {
  CORE_EXPECT(light_speed_mps > 0.0);
  CORE_EXPECT(std::abs(speed_mps) < light_speed_mps);
  std::vector<PulseMotion> motion;
  motion.reserve(time_s.size());
  for (const double t : time_s)
    motion.push_back(
        {radar::moving_delay_of(radar::there_and_back(speed_mps * (t - at_s)), speed_mps, light_speed_mps), speed_mps});
  return motion;
}

double middle_of(std::span<const double> time_s) {
  CORE_EXPECT(!time_s.empty());
  return 0.5 * (time_s.front() + time_s.back());
}

double first_speed_step_mps(const SteppedBand& band, double span_s) {
  CORE_EXPECT(span_s >= 0.0);
  const double cell_m = radar::range_of_cycle(band.band_hz(), band.waveform().light_speed_mps);
  return 0.25 * cell_m / span_s;
}

VelocityEstimate estimate_velocity(const ProfileMaker& maker, const BurstEchoes& echoes, double from_mps, double to_mps,
                                   const core::WorkControl& control) {
  const SteppedBand& band = maker.band();
  const std::size_t bursts = echoes.bursts(band);
  if (bursts == 0 || echoes.values.size() != bursts * band.values_per_burst())
    throw std::invalid_argument("velocity search: the echoes are not those of whole bursts");
  if (!(to_mps > from_mps)) throw std::invalid_argument("velocity search: the interval of speeds is empty");
  std::vector<double> speeds;
  double open_mps = 0.0;  // How far from each candidate of the round before the speed may be.
  std::vector<Candidate> kept;
  for (std::size_t used = 1;; used = std::min(2 * used, bursts)) {
    const Sharpness cost(maker, echoes, (bursts - used) / 2, used);
    // Half a cell: of smear, which goes with twice the time, or of walk.
    const double step = std::min(first_speed_step_mps(band, cost.span_s()), (to_mps - from_mps) / 8.0);
    if (kept.empty() && (to_mps - from_mps) / step > max_searched_speeds)
      throw std::invalid_argument("velocity search: the interval holds too many speeds to try");
    speeds.clear();
    if (kept.empty()) {
      speeds = speeds_about(0.5 * (from_mps + to_mps), step, static_cast<int>(0.5 * (to_mps - from_mps) / step));
    } else {
      for (const Candidate& candidate : kept)
        std::ranges::copy(speeds_about(candidate.speed_mps, step, static_cast<int>(std::ceil(open_mps / step))),
                          std::back_inserter(speeds));
      std::erase_if(speeds, [&](double v) { return v < from_mps || v > to_mps; });
    }
    kept = sharpest(judged(cost, speeds, control), step);
    open_mps = 1.5 * step;
    if (used < bursts) continue;
    const Candidate best = refined(cost, kept.front(), step, control);
    return {std::clamp(best.speed_mps, from_mps, to_mps), best.entropy, cost.entropy(0.0, max_bursts), step / 64.0};
  }
}

}  // namespace sarsim::signal
