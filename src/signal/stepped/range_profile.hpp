#pragma once

#include <complex>
#include <span>
#include <vector>

#include "core/maths/fft.hpp"
#include "signal/compress/range_compression.hpp"

namespace sarsim::signal {

/// Synthetic range profiles from bursts of stepped frequencies (decision 22; thesis abstract; Wehner 1995, ch. 5).
///
/// For each range gate the samples s[n] at the carriers f0 + n step, n = 0 ... S - 1, become the S range bins
///
///     p[k] = (1/sum w) sum over n of w[n] s[n] exp(+j 2 pi n step 2 R/c) exp(+j 2 pi k n/S),
///
/// R the gate's range. Bin k lies at R + k c/(2 S step), modulo c/(2 step); a point target keeps its amplitude and the
/// phase it has at f0.
class RangeProfiler {
 public:
  /// @param gates_m          range of each gate
  /// @param steps, step_hz   S and the frequency step
  /// @param window           weights over the steps, argument n/(S - 1)
  RangeProfiler(std::vector<double> gates_m, int steps, double step_hz, const WindowFunction& window,
                double light_speed_mps);

  [[nodiscard]] std::size_t gates() const { return gate_turns_.size(); }
  [[nodiscard]] std::size_t steps() const { return weights_.size(); }

  /// @param sums        gates() * steps() samples, step-major: sums[n * gates + g], the mean over the pulses of a step
  /// @param[out] out    gates() * steps() bins, gate-major: out[g * steps + k]
  void profile(std::span<const std::complex<double>> sums, std::span<std::complex<double>> out) const;

 private:
  std::vector<double> gate_turns_;  // step 2 R/c, in cycles, of each gate
  std::vector<double> weights_;     // window over the steps, sum 1
  core::Fft fft_;
};

}  // namespace sarsim::signal
