// The fast kernels against the reference: what they promise, on random rows of every kind.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <map>
#include <random>
#include <string>

#include "radar/echo/direct_kernel.hpp"
#include "radar/echo/reference_kernel.hpp"
#include "radar/echo/spectral_kernel.hpp"

namespace sarsim::radar {
namespace kernel_accuracy_test {

constexpr double light_mps = 299'792'458.0;

struct RandomRow {
  EchoPulse pulse;
  SampleGrid grid;
  double carrier_hz = 1e9;
  EchoBatch echoes;
  std::string kind;
};

class RowGenerator {
 public:
  explicit RowGenerator(unsigned seed) : random_(seed) {}

  RandomRow row() {
    RandomRow r;
    const double rate_hz = std::exp(uniform(std::log(1e6), std::log(1e9)));
    const double samples =
        std::floor(std::exp(uniform(std::log(20.0), std::log(1500.0)))) + (chance(0.5) ? uniform(0.0, 1.0) : 0.0);
    r.carrier_hz = rate_hz * uniform(5.0, 50.0);
    r.grid = {uniform(1.0, 100.0) * 1e-6, 1.0 / rate_hz,
              static_cast<std::size_t>(std::exp(uniform(std::log(200.0), std::log(3000.0))))};
    r.pulse.doppler_rule = chance(0.3) ? DopplerRule::thesis : DopplerRule::stretch;
    r.pulse.pulse = pulse(samples / rate_hz, rate_hz, r.kind);
    r.pulse.lead_s = chance(0.5) ? 0.0 : 0.5 * r.pulse.pulse.width_s;
    if (chance(0.4)) {
      const bool nominal = chance(0.3) && bandwidth_hz(r.pulse.pulse) < rate_hz;
      const double half_band = 0.5 * (nominal ? bandwidth_hz(r.pulse.pulse) : rate_hz);
      r.pulse.band_limited.emplace(r.pulse.pulse, half_band, rate_hz,
                                   nominal ? uniform(1.0, 3.0) * r.pulse.pulse.width_s : 0.0);
      r.kind += nominal ? ", cut band" : ", band-limited";
    }
    add_echoes_to(r, samples);
    return r;
  }

 private:
  double uniform(double low, double high) { return std::uniform_real_distribution<>(low, high)(random_); }
  bool chance(double p) { return uniform(0.0, 1.0) < p; }

  core::Interpolator curve(int knots, double low, double high) {
    core::SampledFunction f;
    f.method = chance(0.5) ? core::Interpolation::linear : core::Interpolation::cubic;
    for (int i = 0; i < knots; ++i) f.knots.push_back({static_cast<double>(i) / (knots - 1), uniform(low, high)});
    return core::Interpolator(f);
  }

  Pulse pulse(double width_s, double rate_hz, std::string& kind) {
    Pulse p;
    p.width_s = width_s;
    switch (static_cast<int>(uniform(0.0, 6.0))) {
      case 0: kind = "mono"; break;
      case 1:
        kind = "code";
        p.kind = Pulse::Kind::code;
        p.code = barker_code(static_cast<int>(uniform(0.0, 6.99)));
        break;
      case 2:
        kind = "user";
        p.kind = Pulse::Kind::user;
        p.in_phase = curve(4, -1.0, 1.0);
        p.quadrature = curve(3, -1.0, 1.0);
        break;
      default:
        kind = "chirp";
        p.kind = Pulse::Kind::chirp;
        p.sweep_hz = (chance(0.5) ? -1.0 : 1.0) * rate_hz / uniform(0.8, 3.0);
        break;
    }
    if (chance(0.15)) {
      kind += ", ramps";
      p.envelope = Pulse::Envelope::linear;
      p.rise_s = uniform(0.0, 0.4) * width_s;
      p.fall_s = uniform(0.0, 0.4) * width_s;
    } else if (chance(0.1)) {
      kind += ", envelope";
      p.envelope = Pulse::Envelope::user;
      p.envelope_gain = curve(4, 0.0, 1.0);
    }
    return p;
  }

  // Echoes inside, overhanging either end and outside; Doppler up to one cycle per pulse, common or spread, or none.
  void add_echoes_to(RandomRow& r, double samples) {
    const double most = std::clamp(2e5 / samples, 1.0, 2500.0);
    const auto count = static_cast<int>(std::exp(uniform(0.0, std::log(most))));
    const double row_s = static_cast<double>(r.grid.count) * r.grid.interval_s;
    const double cycle_mps = light_mps / (2.0 * r.carrier_hz * r.pulse.pulse.width_s);  // one cycle per pulse
    const double largest = chance(0.3) ? 0.0 : std::exp(uniform(std::log(1e-4), 0.0)) * std::min(cycle_mps, 3000.0);
    const double common = chance(0.5) ? uniform(-1.0, 1.0) * largest : 0.0;
    // Bends up to a quarter of a cycle at the ends, common or spread, or none.
    const double half_s = 0.5 * (r.pulse.last_s() - r.pulse.first_s());
    const bool bends = r.pulse.doppler_rule == DopplerRule::stretch && chance(0.4);
    const double bend =
        bends ? std::exp(uniform(std::log(1e-9), std::log(0.25))) / (0.5 * r.carrier_hz * half_s * half_s) : 0.0;
    const double spread = chance(0.5) ? 0.1 : 1.0;
    for (int i = 0; i < count; ++i) {
      const double delay_s = r.grid.first_s + row_s * uniform(-0.5, 1.2);
      const double amplitude = std::exp(uniform(-3.0, 3.0));
      const double doppler = (common + largest * uniform(-1.0, 1.0)) / light_mps;
      if (bends)
        r.echoes.add(delay_s, amplitude, PulseClock{doppler, bend * (1.0 - spread * uniform(0.0, 1.0))});
      else
        r.echoes.add(delay_s, amplitude, doppler);
    }
  }

  std::mt19937_64 random_;
};

double energy(const RandomRow& row) {
  double sum = 0.0;
  const auto samples = static_cast<int>(row.pulse.pulse.width_s / row.grid.interval_s) + 1;
  for (int i = 0; i < samples; ++i)
    sum += std::norm(row.pulse.pulse.value(std::min(i * row.grid.interval_s, row.pulse.pulse.width_s * (1 - 1e-12))));
  return sum;
}

using Row = std::vector<std::complex<double>>;

template <class Kernel>
Row made(const RandomRow& row, double tolerance) {
  Row got(row.grid.count);
  Kernel kernel(row.pulse, row.grid, tolerance);
  kernel.add(got, row.carrier_hz, row.echoes);
  return got;
}

// As one part of very many echoes, which are summed bin by bin where the pulse allows it.
Row made_as_of_many(const RandomRow& row, double tolerance) {
  Row got(row.grid.count);
  SpectralKernel kernel(row.pulse, row.grid, tolerance);
  kernel.begin(row.carrier_hz, 1'000'000'000);
  kernel.take(row.echoes);
  kernel.finish(got);
  return got;
}

// || s - s_ref || / sqrt(sum |a|^2 ||p||^2) over the echoes that touch the row (docs/decisions: relative error).
double relative_error(const RandomRow& row, const Row& expected, const Row& got) {
  double error = 0.0;
  for (std::size_t n = 0; n < got.size(); ++n) error += std::norm(got[n] - expected[n]);
  double strength = 0.0;
  for (std::size_t k = 0; k < row.echoes.size(); ++k) {
    const SampleSpan on =
        touched_samples(row.pulse, row.grid, row.echoes.delay_s[k], row.pulse.clock_of(row.echoes, k));
    if (on.begin < on.end) strength += row.echoes.amplitude_sqrt_w[k] * row.echoes.amplitude_sqrt_w[k];
  }
  return strength == 0.0 ? std::sqrt(error) : std::sqrt(error / (strength * energy(row)));
}

TEST(FastKernels, KeepTheirPromiseOnRandomRows) {
  constexpr int rows = 200;
  const std::vector<double> tolerances{1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-9};
  std::map<double, double> worst_direct, worst_spectral, worst_of_many;
  std::map<std::string, int> kinds;
  RowGenerator generator(7);
  for (int i = 0; i < rows; ++i) {
    const RandomRow row = generator.row();
    ++kinds[row.kind];
    std::vector<std::complex<double>> expected(row.grid.count);
    add_echoes(expected, row.grid, row.pulse, row.carrier_hz, row.echoes);
    for (const double tolerance : tolerances) {
      // The direct kernel knows two precisions only.
      const bool two = tolerance == 1e-6 || tolerance == 1e-9;
      const double direct = two ? relative_error(row, expected, made<DirectKernel>(row, tolerance)) : 0.0;
      const double spectral = relative_error(row, expected, made<SpectralKernel>(row, tolerance));
      const double of_many = relative_error(row, expected, made_as_of_many(row, tolerance));
      EXPECT_LT(direct, tolerance) << "row " << i << ": " << row.kind << ", " << row.echoes.size() << " echoes";
      EXPECT_LT(spectral, tolerance) << "row " << i << ": " << row.kind << ", " << row.echoes.size() << " echoes";
      EXPECT_LT(of_many, tolerance) << "row " << i << ": " << row.kind << ", " << row.echoes.size() << " of many";
      worst_direct[tolerance] = std::max(worst_direct[tolerance], direct);
      worst_spectral[tolerance] = std::max(worst_spectral[tolerance], spectral);
      worst_of_many[tolerance] = std::max(worst_of_many[tolerance], of_many);
    }
  }
  std::printf("promise    direct     spectral   of many    (largest relative error of %d rows)\n", rows);
  for (const double tolerance : tolerances)
    std::printf("%.0e      %.1e    %.1e    %.1e\n", tolerance, worst_direct[tolerance], worst_spectral[tolerance],
                worst_of_many[tolerance]);
  EXPECT_GE(kinds.size(), 10u);
}

}  // namespace kernel_accuracy_test
}  // namespace sarsim::radar
