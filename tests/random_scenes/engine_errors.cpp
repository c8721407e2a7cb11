#include "random_scenes/engine_errors.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

#include "core/maths/constants.hpp"
#include "simulate/plan/row_maker.hpp"

namespace sarsim::test {

namespace {

using Row = std::vector<std::complex<double>>;

double norm_of(const Row& row) {
  double sum = 0.0;
  for (const std::complex<double>& sample : row) sum += std::norm(sample);
  return std::sqrt(sum);
}

// ||p||^2 in samples, of the pulse before it is confined to a band. One that is shorter than a sample counts as one.
double pulse_energy(const simulate::Plan& plan) {
  constexpr std::size_t points = 2000;
  const radar::Pulse& pulse = plan.acquisition.reception.pulse.pulse;
  double sum = 0.0;
  double largest = 0.0;
  for (std::size_t i = 0; i < points; ++i) {
    const double share = (static_cast<double>(i) + 0.5) / static_cast<double>(points);
    const double power = std::norm(pulse.value(share * pulse.width_s));
    sum += power;
    largest = std::max(largest, power);
  }
  return std::max(sum / static_cast<double>(points) * pulse.width_s / plan.acquisition.reception.raw_grid.interval_s,
                  largest);
}

// Largest magnitude of a filter's response.
double filter_gain(const signal::RangeCompressor& compressor) {
  const auto& taps = compressor.filter().taps;
  const core::Fft fft(core::good_fft_size(8 * taps.size()));
  Row response(fft.size());
  std::ranges::copy(taps, response.begin());
  fft.forward(response);
  double largest = 0.0;
  for (const std::complex<double>& value : response) largest = std::max(largest, std::abs(value));
  return largest;
}

// Largest singular value of a range profile's sum over the steps: a discrete transform behind weights.
double profile_gain(const signal::RangeProfiler& profiler) {
  Row sums(profiler.gates() * profiler.steps());
  Row bins(sums.size());
  double largest = 0.0;
  for (std::size_t n = 0; n < profiler.steps(); ++n) {
    std::ranges::fill(sums, std::complex<double>());
    sums[n * profiler.gates()] = 1.0;
    profiler.profile(sums, bins);
    largest = std::max(largest, norm_of(bins));
  }
  return largest;
}

// What is allowed for the rows of a plan.
class Allowance {
 public:
  Allowance(const simulate::Plan& plan, double tolerance)
      : plan_(plan),
        tolerance_(tolerance),
        geometry_(*plan.acquisition.scene, plan.acquisition.link),
        energy_(pulse_energy(plan)) {
    longer_.first_s -= margin * longer_.interval_s;
    longer_.count += 2 * margin;
    if (plan.acquisition.reception.compressor) gain_ *= filter_gain(*plan.acquisition.reception.compressor);
    if (plan.acquisition.reception.profiler) gain_ *= profile_gain(*plan.acquisition.reception.profiler);
    double largest = plan.acquisition.reception.stc_gain.empty() ? 1.0 : 0.0;
    for (const double gain : plan.acquisition.reception.stc_gain) largest = std::max(largest, std::abs(gain));
    gain_ *= largest;
  }

  // Largest gain of what follows the echoes.
  [[nodiscard]] double gain() const { return gain_; }

  double of_row(std::size_t row) {
    const std::int64_t first = plan_.acquisition.timing.first_pulse_of_row(row);
    if (!plan_.acquisition.reception.profiler) return gain_ * of_pulse(first);
    const std::int64_t per_step = plan_.acquisition.link.carrier.pulses_per_step();
    double squares = 0.0;
    for (std::int64_t step = 0; step < plan_.acquisition.link.carrier.steps(); ++step) {
      double sum = 0.0;
      for (std::int64_t p = 0; p < per_step; ++p) sum += of_pulse(first + step * per_step + p);
      squares += std::pow(sum / static_cast<double>(per_step), 2);
    }
    return gain_ * std::sqrt(squares);
  }

 private:
  // The promise for one pulse, and the rounding of its phases: f tau turns in double precision. An echo that begins or
  // ends just outside the row counts as well: an engine's error need not end where the echo does.
  double of_pulse(std::int64_t pulse) {
    double sum = of_echoes(pulse, pulse);
    for (const simulate::RangeAmbiguity& other : plan_.sources.range_ambiguities.pulses)
      sum += of_echoes(pulse, pulse - other.back);
    return sum;
  }

  // Of what the row of `pulse` receives of a pulse that was sent.
  double of_echoes(std::int64_t pulse, std::int64_t sent) {
    geometry_.set_pulse(sent);
    geometry_.echoes(echoes_);
    const double since_s = plan_.acquisition.link.repetition.send_time_s(pulse) - geometry_.send_time_s();
    double squares = 0.0;
    double longest_s = 0.0;
    for (std::size_t k = 0; k < echoes_.size(); ++k) {
      const radar::SampleSpan on =
          radar::touched_samples(plan_.acquisition.reception.pulse, longer_, echoes_.delay_s[k] - since_s,
                                 plan_.acquisition.reception.pulse.clock_of(echoes_, k));
      if (on.begin >= on.end) continue;
      squares += echoes_.amplitude_sqrt_w[k] * echoes_.amplitude_sqrt_w[k];
      longest_s = std::max(longest_s, std::abs(echoes_.delay_s[k]));
    }
    const double rounding = 1e-14 * geometry_.carrier_hz() * longest_s;
    return (tolerance_ + rounding) * std::sqrt(squares * energy_);
  }

  static constexpr std::size_t margin = 2;  // Samples.

  const simulate::Plan& plan_;
  radar::SampleGrid longer_ = plan_.acquisition.reception.raw_grid;
  double tolerance_;
  simulate::PulseGeometry geometry_;
  radar::EchoBatch echoes_;
  double energy_;
  double gain_ = 1.0;
};

bool all_finite(const Row& row) {
  return std::ranges::all_of(row, [](const std::complex<double>& sample) {
    return std::isfinite(sample.real()) && std::isfinite(sample.imag());
  });
}

}  // namespace

EngineErrors compare_rows(const simulate::Plan& fast, const simulate::Plan& reference, double tolerance) {
  constexpr double vanishing_v = 1e-37;  // Echoes of this size are no numbers of single precision.
  constexpr double rounding = 1e-13;     // Of whatever else stands in the row, such as noise.
  simulate::RowMaker fast_rows(fast);
  simulate::RowMaker plain_rows(reference);
  Allowance allowance(reference, tolerance);
  Row got(fast.acquisition.reception.columns);
  Row expected(reference.acquisition.reception.columns);
  EngineErrors errors;
  for (std::size_t row = 0; row < reference.acquisition.timing.rows; ++row) {
    fast_rows.make_row(row, got);
    plain_rows.make_row(row, expected);
    errors.finite = errors.finite && all_finite(got) && all_finite(expected);
    const double vanishing = vanishing_v * allowance.gain() * std::sqrt(static_cast<double>(got.size()));
    const double allowed = allowance.of_row(row) + rounding * norm_of(expected) + vanishing;
    for (std::size_t i = 0; i < got.size(); ++i) got[i] -= expected[i];
    const double error = norm_of(got);
    if (error == 0.0) continue;
    const double share = error / allowed;  // Infinite where nothing should have been there.
    if (share <= errors.worst_share) continue;
    errors.worst_share = share;
    errors.worst_row = row;
  }
  return errors;
}

}  // namespace sarsim::test
