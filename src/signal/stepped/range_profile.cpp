#include "signal/stepped/range_profile.hpp"

#include <cmath>

#include "core/maths/constants.hpp"
#include "core/maths/window.hpp"
#include "core/report/expect.hpp"
#include "radar/path/path.hpp"

namespace sarsim::signal {

RangeProfiler::RangeProfiler(std::vector<double> gates_m, int steps, double step_hz, const WindowFunction& window,
                             double light_speed_mps)
    : gate_turns_(std::move(gates_m)),
      weights_(static_cast<std::size_t>(steps)),
      fft_(static_cast<std::size_t>(steps)) {
  CORE_EXPECT(steps >= 1);
  CORE_EXPECT(light_speed_mps > 0.0);
  CORE_EXPECT(std::isfinite(step_hz));
  for (double& gate : gate_turns_) gate *= radar::turns_per_m(step_hz, light_speed_mps);
  double sum = 0.0;
  double magnitudes = 0.0;
  for (std::size_t n = 0; n < weights_.size(); ++n) {
    weights_[n] = steps > 1 ? window(static_cast<double>(n) / (steps - 1)) : 1.0;
    sum += weights_[n];
    magnitudes += std::abs(weights_[n]);
  }
  if (!core::weights_cancel(sum, magnitudes))
    for (double& w : weights_) w /= sum;
}

void RangeProfiler::profile(std::span<const std::complex<double>> sums, std::span<std::complex<double>> out) const {
  CORE_EXPECT(sums.size() == gates() * steps());
  CORE_EXPECT(out.size() == gates() * steps());
  for (std::size_t g = 0; g < gates(); ++g) {
    const auto bins = out.subspan(g * steps(), steps());
    for (std::size_t n = 0; n < steps(); ++n) {
      const double cycles = gate_turns_[g] * static_cast<double>(n);
      bins[n] = sums[n * gates() + g] * (weights_[n] * std::polar(1.0, 2.0 * core::pi * (cycles - std::round(cycles))));
    }
    fft_.inverse(bins);
  }
}

}  // namespace sarsim::signal
