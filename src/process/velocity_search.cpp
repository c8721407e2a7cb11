#include "process/velocity_search.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace sarsim {

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

// The best of evenly spaced speeds, moved to the top of the parabola through its neighbours.
Candidate best_of(const Sharpness& cost, double from_mps, double step_mps, std::size_t count,
                  const WorkControl& control, std::size_t most_bursts) {
  std::vector<double> entropy(count);
  parallel_ranges(count, 1, control, [&](std::size_t i, std::size_t) {
    entropy[i] = cost.entropy(from_mps + static_cast<double>(i) * step_mps, most_bursts);
  });
  const auto least = std::ranges::min_element(entropy);
  const auto i = static_cast<std::size_t>(least - entropy.begin());
  Candidate best{from_mps + static_cast<double>(i) * step_mps, *least};
  if (i == 0 || i + 1 == count) return best;
  const double bend = entropy[i - 1] - 2.0 * *least + entropy[i + 1];
  if (bend > 0.0) best.speed_mps += step_mps * std::clamp(0.5 * (entropy[i - 1] - entropy[i + 1]) / bend, -0.5, 0.5);
  return best;
}

}  // namespace

std::vector<PulseMotion> motion_of_speed(std::span<const double> time_s, double at_s, double speed_mps,
                                         double light_speed_mps) {
  std::vector<PulseMotion> motion;
  motion.reserve(time_s.size());
  for (const double t : time_s)
    motion.push_back({2.0 * speed_mps * (t - at_s) / (light_speed_mps - speed_mps), speed_mps});
  return motion;
}

double middle_of(std::span<const double> time_s) { return 0.5 * (time_s.front() + time_s.back()); }

VelocityEstimate estimate_velocity(const ProfileMaker& maker, const BurstEchoes& echoes, double from_mps, double to_mps,
                                   const WorkControl& control) {
  constexpr std::size_t most_bursts = 16;
  const SteppedBand& band = maker.band();
  const std::size_t bursts = echoes.bursts(band);
  if (bursts == 0 || echoes.values.size() != bursts * band.values_per_burst())
    throw std::invalid_argument("velocity search: the echoes are not those of whole bursts");
  if (!(to_mps > from_mps)) throw std::invalid_argument("velocity search: the interval of speeds is empty");
  const double cell_m = 0.5 * band.waveform().light_speed_mps / band.band_hz();
  std::size_t used = 1;
  double low = from_mps, high = to_mps;
  VelocityEstimate estimate;
  for (;; used = std::min(2 * used, bursts)) {
    const Sharpness cost(maker, echoes, (bursts - used) / 2, used);
    // Half a cell: of smear, which goes with twice the time, or of walk.
    const double resolved = 0.25 * cell_m / cost.span_s();
    const double step = std::min(resolved, (high - low) / 8.0);
    const auto count = static_cast<std::size_t>(std::ceil((high - low) / step)) + 1;
    const double exact = (high - low) / static_cast<double>(count - 1);
    Candidate best = best_of(cost, low, exact, count, control, most_bursts);
    // Once more, finer, about it: the valley is narrower than what the parabola was laid through.
    best = best_of(cost, best.speed_mps - exact, 0.25 * exact, 9, control, most_bursts);
    estimate = {std::clamp(best.speed_mps, from_mps, to_mps), best.entropy, cost.entropy(0.0, most_bursts),
                0.125 * exact};
    if (used == bursts) return estimate;
    low = std::max(low, best.speed_mps - 2.0 * resolved);
    high = std::min(high, best.speed_mps + 2.0 * resolved);
  }
}

}  // namespace sarsim
