// The direct kernel with pulses that are more than a tone: envelopes, user-defined and band-limited pulses.

#include <string>

#include "echo/direct_kernel.hpp"
#include "echo/echo_test_support.hpp"

namespace sarsim {
namespace {

// Low, and the rows early: phases of some hundred turns, lest their rounding hide what the shapes contribute.
constexpr double carrier_hz = 1e8;
SampleGrid early_grid(std::size_t count) { return {1.3e-6, test_interval_s, count}; }

struct Method {
  std::string name;
  Interpolation interpolation;
  LowPassRule rule = LowPassRule::first_knot;
};

const std::vector<Method> methods{{"linear", Interpolation::linear},
                                  {"cubic", Interpolation::cubic},
                                  {"low pass", Interpolation::low_pass},
                                  {"low pass of 1998", Interpolation::low_pass, LowPassRule::origin}};

// Random knots, the first and last of them on the edges of the pulse unless `inside`.
Interpolator curve(const Method& method, int knots, bool uniform = true, unsigned seed = 1, bool inside = false) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  SampledFunction f;
  f.method = method.interpolation;
  for (int i = 0; i < knots; ++i) {
    const double off = uniform || i == 0 || i == knots - 1 ? 0.0 : 0.4 * unit(random);
    const double x = (i + off) / (knots - 1);
    f.knots.push_back({inside ? 0.1 + 0.7 * x : x, unit(random)});
  }
  return Interpolator(f, method.rule);
}

EchoPulse user_pulse(double samples, const Method& method, int knots, bool uniform = true) {
  EchoPulse pulse = test_pulse(Pulse::Kind::user, samples);
  pulse.pulse.in_phase = curve(method, knots, uniform, 1);
  pulse.pulse.quadrature = curve(method, knots + 2, uniform, 2);
  return pulse;
}

EchoPulse with_ramps(EchoPulse pulse, double rise_samples, double fall_samples) {
  pulse.pulse.envelope = Pulse::Envelope::linear;
  pulse.pulse.rise_s = rise_samples * test_interval_s;
  pulse.pulse.fall_s = fall_samples * test_interval_s;
  return pulse;
}

EchoPulse with_envelope(EchoPulse pulse, const Interpolator& gain) {
  pulse.pulse.envelope = Pulse::Envelope::user;
  pulse.pulse.envelope_gain = gain;
  return pulse;
}

double cycle_mps(const EchoPulse& pulse) { return exact_light_speed_mps / (2.0 * carrier_hz * pulse.pulse.width_s); }

// What overhangs: echoes that miss the row, begin before it, end after it, lie on the grid or inside; each a different
// share of `cycles` of Doppler over the pulse, of either sign.
EchoBatch all_sorts_of_echoes(const EchoPulse& pulse, const SampleGrid& grid, double cycles) {
  const double first = pulse.first_s() / grid.interval_s;
  const double last = pulse.last_s() / grid.interval_s;
  const auto row = static_cast<double>(grid.count);
  const double speed = cycles * cycle_mps(pulse);
  EchoBatch echoes;
  const auto add = [&](double position, double amplitude, double share) {
    echoes.add(grid.first_s + position * grid.interval_s, amplitude, share * speed);
  };
  add(-last - 3.3, 1.0, 1.0);
  add(-last + 0.7, 0.7, -1.0);
  add(0.5 * row - 0.5 * (first + last) + 0.43, -1.0, 1.0);
  add(-0.5 * (first + last) - 0.21, 0.5, -0.5);
  add(row - first - 1.1, 0.9, 0.8);
  add(row - 0.5 * (first + last) + 0.37, -0.3, -0.1);
  add(row - first + 5.0, 1.0, 1.0);
  add(std::round(0.3 * row), 0.6, 0.3);
  return echoes;
}

// Largest magnitude of a shape, from samples and knots.
double largest_of(const EchoPulse& pulse, double interval_s) {
  double largest = 0.0;
  const double step = pulse.band_limited ? 0.1 * interval_s : std::min(0.1 * interval_s, 1e-3 * pulse.pulse.width_s);
  const double lead = pulse.lead_s;
  for (double t = pulse.first_s() + lead; t < pulse.last_s() + lead; t += step)
    largest = std::max(largest, std::abs(pulse.band_limited ? pulse.band_limited->value(t) : pulse.pulse.value(t)));
  return largest;
}

// Largest error of a sample over what is allowed: the promise for each echo that touches it, and in double the rounding
// of `turns` of phase of the reference and of the kernel.
double worst_share(const EchoPulse& pulse, const SampleGrid& grid, const EchoBatch& echoes, double tolerance,
                   double turns) {
  const double promise = tolerance >= 1e-6 ? 5e-7 : 1e-11 + 2.0 * pi * 2.3e-16 * 4.0 * turns;
  const double largest = largest_of(pulse, grid.interval_s);
  std::vector<double> allowed(grid.count);
  for (std::size_t k = 0; k < echoes.size(); ++k) {
    const SampleSpan on = touched_samples(pulse, grid, echoes.delay_s[k]);
    for (std::size_t n = on.begin; n < on.end; ++n)
      allowed[n] += promise * largest * std::abs(echoes.amplitude_sqrt_w[k]);
  }
  DirectKernel kernel(pulse, grid, tolerance);
  const ComplexRow got = row_of(kernel, grid, carrier_hz, echoes);
  const ComplexRow expected = reference_row(pulse, grid, carrier_hz, echoes);
  double worst = 0.0;
  for (std::size_t n = 0; n < grid.count; ++n) {
    const double error = std::abs(got[n] - expected[n]);
    if (error > 0.0) worst = std::max(worst, allowed[n] > 0.0 ? error / allowed[n] : 1e300);
  }
  return worst;
}

void expect_reference(const EchoPulse& pulse, const SampleGrid& grid, double cycles, const std::string& what) {
  const EchoBatch echoes = all_sorts_of_echoes(pulse, grid, cycles);
  for (const double tolerance : {1e-6, 1e-9}) {
    EXPECT_LE(worst_share(pulse, grid, echoes, tolerance, 1e3), 1.0)
        << what << ", " << cycles << " cycles of Doppler, " << tolerance;
  }
}

// Both origins of an echo's delay, rest and either sign of Doppler up to a cycle per pulse.
void expect_reference_at_all_speeds(EchoPulse pulse, const SampleGrid& grid, const std::string& what) {
  for (const double lead : {0.0, 0.5}) {
    pulse.lead_s = lead * pulse.pulse.width_s;
    for (const double cycles : {0.0, 0.5, -1.0}) expect_reference(pulse, grid, cycles, what);
  }
}

TEST(DirectKernelShapes, RampsOfAnyKindOfPulse) {
  at_every_simd_level([] {
    for (const Pulse::Kind kind : {Pulse::Kind::mono, Pulse::Kind::chirp, Pulse::Kind::code})
      for (const double samples : {1.6, 13.0, 90.7, 400.0}) {
        const EchoPulse plain = test_pulse(kind, samples, kind == Pulse::Kind::chirp ? 0.7 : 0.0);
        for (const auto& [rise, fall] : std::vector<std::array<double, 2>>{
                 {0.1, 0.2}, {0.0, 0.5}, {0.25, 0.0}, {0.5, 0.5}, {0.8, 0.7}, {1.0, 1.0}, {0.0, 0.0}})
          expect_reference_at_all_speeds(with_ramps(plain, rise * samples, fall * samples), early_grid(250),
                                         "ramps " + std::to_string(rise) + " " + std::to_string(samples));
      }
  });
}

TEST(DirectKernelShapes, EnvelopesOfAnyInterpolation) {
  at_every_simd_level([] {
    for (const Method& method : methods)
      for (const Pulse::Kind kind : {Pulse::Kind::mono, Pulse::Kind::chirp, Pulse::Kind::code})
        for (const double samples : {5.3, 120.0}) {
          const EchoPulse plain = test_pulse(kind, samples, kind == Pulse::Kind::chirp ? 0.7 : 0.0);
          for (const int knots : {1, 2, 5, 13})
            for (const bool uniform : {true, false})
              expect_reference_at_all_speeds(with_envelope(plain, curve(method, knots, uniform)), early_grid(90),
                                             method.name);
        }
  });
}

TEST(DirectKernelShapes, UserPulsesOfAnyInterpolation) {
  at_every_simd_level([] {
    for (const Method& method : methods)
      for (const double samples : {0.7, 3.0, 21.3, 150.0})
        for (const int knots : {2, 7, 40})
          for (const bool uniform : {true, false})
            expect_reference_at_all_speeds(user_pulse(samples, method, knots, uniform), early_grid(100),
                                           method.name + " " + std::to_string(samples) + " " + std::to_string(knots));
  });
}

TEST(DirectKernelShapes, BandLimited) {
  at_every_simd_level([] {
    for (const Pulse::Kind kind : {Pulse::Kind::mono, Pulse::Kind::chirp, Pulse::Kind::code, Pulse::Kind::user})
      for (const double samples : {4.4, 90.0})
        for (const double band : {0.1, 0.5, 0.8})
          for (const double kept : {0.0, 0.6, 1.0, 1.73}) {
            EchoPulse pulse = test_pulse(kind, samples, kind == Pulse::Kind::chirp ? 0.7 : 0.0);
            if (kind == Pulse::Kind::user) pulse = user_pulse(samples, methods[1], 5);
            pulse.band_limited.emplace(pulse.pulse, band / test_interval_s, 1.0 / test_interval_s,
                                       kept * pulse.pulse.width_s);
            expect_reference_at_all_speeds(pulse, early_grid(200),
                                           "band " + std::to_string(band) + " kept " + std::to_string(kept));
          }
  });
}

}  // namespace
}  // namespace sarsim
