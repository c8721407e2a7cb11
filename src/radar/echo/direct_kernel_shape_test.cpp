// The direct kernel with pulses that are more than a tone: envelopes, user-defined and band-limited pulses.

#include <string>

#include "radar/echo/direct_kernel.hpp"
#include "radar/echo/echo_test_support.hpp"

namespace sarsim::radar {
namespace direct_kernel_shape_test {

// Low, and the rows early: phases of some hundred turns, lest their rounding hide what the shapes contribute.
constexpr double carrier_hz = 1e8;
SampleGrid early_grid(std::size_t count) { return {1.3e-6, test_interval_s, count}; }

struct Method {
  std::string name;
  core::Interpolation interpolation;
  core::LowPassRule rule = core::LowPassRule::first_knot;
};

const std::vector<Method> methods{{"linear", core::Interpolation::linear},
                                  {"cubic", core::Interpolation::cubic},
                                  {"low pass", core::Interpolation::low_pass},
                                  {"low pass of 1998", core::Interpolation::low_pass, core::LowPassRule::origin}};

// Random knots, the first and last of them on the edges of the pulse unless `inside`.
core::Interpolator curve(const Method& method, int knots, bool uniform = true, unsigned seed = 1, bool inside = false) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  core::SampledFunction f;
  f.method = method.interpolation;
  for (int i = 0; i < knots; ++i) {
    const double off = uniform || i == 0 || i == knots - 1 ? 0.0 : 0.4 * unit(random);
    const double x = (i + off) / (knots - 1);
    f.knots.push_back({inside ? 0.1 + 0.7 * x : x, unit(random)});
  }
  return core::Interpolator(f, method.rule);
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

EchoPulse with_envelope(EchoPulse pulse, const core::Interpolator& gain) {
  pulse.pulse.envelope = Pulse::Envelope::user;
  pulse.pulse.envelope_gain = gain;
  return pulse;
}

// D of one cycle over the pulse.
double doppler_of_cycle(const EchoPulse& pulse) { return 1.0 / (carrier_hz * pulse.pulse.width_s); }

// What overhangs: echoes that miss the row, begin before it, end after it, lie on the grid or inside; each a different
// share of `cycles` of Doppler over the pulse, of either sign.
EchoBatch all_sorts_of_echoes(const EchoPulse& pulse, const SampleGrid& grid, double cycles, double bend = 0.0) {
  const double first = pulse.first_s() / grid.interval_s;
  const double last = pulse.last_s() / grid.interval_s;
  const auto row = static_cast<double>(grid.count);
  const double doppler = cycles * doppler_of_cycle(pulse);
  EchoBatch echoes;
  const auto add = [&](double position, double amplitude, double share) {
    echoes.add(grid.first_s + position * grid.interval_s, amplitude, PulseClock{share * doppler, share * bend});
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

// What an error may be: the promise for each echo that touches a sample, and in double the rounding of phases of some
// hundred turns in the reference and in the kernel.
std::vector<double> allowed_errors(const EchoPulse& pulse, const SampleGrid& grid, const EchoBatch& echoes,
                                   double tolerance) {
  const double promise = tolerance >= 1e-6 ? 5e-7 : 1e-11 + 2.0 * core::pi * 2.3e-16 * 4.0 * 1e3;
  const double largest = largest_of(pulse, grid.interval_s);
  std::vector<double> allowed(grid.count);
  for (std::size_t k = 0; k < echoes.size(); ++k) {
    const SampleSpan on = touched_samples(pulse, grid, echoes.delay_s[k], pulse.clock_of(echoes, k));
    for (std::size_t n = on.begin; n < on.end; ++n)
      allowed[n] += promise * largest * std::abs(echoes.amplitude_sqrt_w[k]);
  }
  return allowed;
}

// In both precisions and on every instruction set.
void expect_reference(const EchoPulse& pulse, const SampleGrid& grid, const EchoBatch& echoes,
                      const std::string& what) {
  const ComplexRow expected = reference_row(pulse, grid, carrier_hz, echoes);
  for (const double tolerance : {1e-6, 1e-9}) {
    const std::vector<double> allowed = allowed_errors(pulse, grid, echoes, tolerance);
    DirectKernel kernel(pulse, grid, tolerance);
    at_every_simd_level([&] {
      const ComplexRow got = row_of(kernel, grid, carrier_hz, echoes);
      for (std::size_t n = 0; n < grid.count; ++n)
        ASSERT_LE(std::abs(got[n] - expected[n]), allowed[n]) << what << ", sample " << n << ", " << tolerance;
    });
    if (testing::Test::HasFatalFailure()) return;
  }
}

// Both origins of an echo's delay, rest and either sign of Doppler up to a cycle per pulse.
void expect_reference_at_all_speeds(EchoPulse pulse, const SampleGrid& grid, const std::string& what) {
  for (const double lead : {0.0, 0.5}) {
    pulse.lead_s = lead * pulse.pulse.width_s;
    for (const double cycles : {0.0, 0.5, -1.0})
      expect_reference(pulse, grid, all_sorts_of_echoes(pulse, grid, cycles),
                       what + ", " + std::to_string(cycles) + " cycles of Doppler");
    // A tenth of a cycle more at the ends.
    const double half_s = 0.5 * (pulse.last_s() - pulse.first_s());
    expect_reference(pulse, grid, all_sorts_of_echoes(pulse, grid, 0.5, 0.2 / (carrier_hz * half_s * half_s)),
                     what + ", bent");
  }
}

TEST(DirectKernelShapes, AddsRampsOfAnyKindOfPulseLikeTheReference) {
  for (const Pulse::Kind kind : {Pulse::Kind::mono, Pulse::Kind::chirp, Pulse::Kind::code})
    for (const double samples : {1.6, 13.0, 90.7, 400.0}) {
      const EchoPulse plain = test_pulse(kind, samples, kind == Pulse::Kind::chirp ? 0.7 : 0.0);
      // Of the width; the last ones overlap.
      for (const auto& [rise, fall] : std::vector<std::array<double, 2>>{
               {0.1, 0.2}, {0.0, 0.5}, {0.25, 0.0}, {0.5, 0.5}, {0.8, 0.7}, {1.0, 1.0}, {0.0, 0.0}})
        expect_reference_at_all_speeds(with_ramps(plain, rise * samples, fall * samples), early_grid(250),
                                       "ramps of " + std::to_string(rise) + ", samples: " + std::to_string(samples));
    }
}

TEST(DirectKernelShapes, AddsEnvelopesOfAnyInterpolationLikeTheReference) {
  for (const Method& method : methods)
    for (const Pulse::Kind kind : {Pulse::Kind::mono, Pulse::Kind::chirp, Pulse::Kind::code})
      for (const double samples : {5.3, 120.0}) {
        const EchoPulse plain = test_pulse(kind, samples, kind == Pulse::Kind::chirp ? 0.7 : 0.0);
        for (const int knots : {1, 2, 5, 13})
          for (const bool uniform : {true, false})
            expect_reference_at_all_speeds(with_envelope(plain, curve(method, knots, uniform)), early_grid(90),
                                           method.name + ", knots: " + std::to_string(knots));
      }
}

// From a knot every fourth sample to dozens of knots per sample.
TEST(DirectKernelShapes, AddsUserPulsesOfAnyInterpolationLikeTheReference) {
  for (const Method& method : methods)
    for (const double samples : {0.7, 3.0, 21.3, 150.0})
      for (const int knots : {2, 7, 40})
        for (const bool uniform : {true, false})
          expect_reference_at_all_speeds(
              user_pulse(samples, method, knots, uniform), early_grid(100),
              method.name + ", samples: " + std::to_string(samples) + ", knots: " + std::to_string(knots));
}

TEST(DirectKernelShapes, AddsUserPulsesWithAnEnvelopeLikeTheReference) {
  for (const Method& method : methods) {
    const EchoPulse plain = user_pulse(61.2, method, 9);
    expect_reference_at_all_speeds(with_ramps(plain, 10.3, 20.1), early_grid(150), method.name + " with ramps");
    for (const Method& other : methods)
      expect_reference_at_all_speeds(with_envelope(plain, curve(other, 6, false, 4)), early_grid(150),
                                     method.name + " times " + other.name);
  }
}

TEST(DirectKernelShapes, AddsCurvesThatDoNotReachTheEdgesLikeTheReference) {
  for (const Method& method : methods) {
    EchoPulse pulse = test_pulse(Pulse::Kind::user, 70.4);
    pulse.pulse.in_phase = curve(method, 9, false, 5, true);  // the quadrature has no knots: 0
    expect_reference_at_all_speeds(pulse, early_grid(120), method.name);
    expect_reference_at_all_speeds(
        with_envelope(test_pulse(Pulse::Kind::chirp, 70.4, -0.6), curve(method, 4, true, 6, true)), early_grid(120),
        method.name);
  }
}

TEST(DirectKernelShapes, AddsBandLimitedPulsesLikeTheReference) {
  for (const Pulse::Kind kind : {Pulse::Kind::mono, Pulse::Kind::chirp, Pulse::Kind::code, Pulse::Kind::user})
    for (const double samples : {4.4, 90.0})
      for (const double half_band : {0.1, 0.5, 0.8, 2.2})
        for (const double kept : {0.0, 0.6, 1.0, 1.73}) {
          EchoPulse pulse = test_pulse(kind, samples, kind == Pulse::Kind::chirp ? 0.7 : 0.0);
          if (kind == Pulse::Kind::user) pulse = user_pulse(samples, methods[1], 5);
          pulse.band_limited.emplace(pulse.pulse, half_band / test_interval_s, 1.0 / test_interval_s,
                                     kept * pulse.pulse.width_s);
          expect_reference_at_all_speeds(pulse, early_grid(200),
                                         "half band " + std::to_string(half_band) + ", kept " + std::to_string(kept));
        }
}

// Delays that are whole samples, or off by less than the tolerance of an edge, in grids that round them either way.
EchoBatch echoes_on_samples(const SampleGrid& grid) {
  EchoBatch echoes;
  for (const double off : {0.0, -0.9e-9, 0.9e-9, -0.5, 0.25})
    for (const double place : {-6.0, 0.0, 13.0}) echoes.add(grid.first_s + (place + off) * test_interval_s, 1.0, 0.0);
  return echoes;
}

TEST(DirectKernelShapes, DecidesSamplesOnEdgesBordersAndJumpsLikeTheReference) {
  std::vector<EchoPulse> pulses;
  for (const Pulse::Kind kind : {Pulse::Kind::mono, Pulse::Kind::code})
    pulses.push_back(with_ramps(test_pulse(kind, 26.0), 4.0, 3.0));
  for (const Method& method : methods) {
    // Knots stand on even samples, the jumps of the rule of 1998 on odd ones.
    pulses.push_back(test_pulse(Pulse::Kind::user, 80.0));
    pulses.back().pulse.in_phase = curve(method, 41);
    pulses.push_back(user_pulse(20.0, method, 6));
  }
  // Knots as close as numbers come: a step for all purposes.
  EchoPulse steps = test_pulse(Pulse::Kind::user, 16.0);
  steps.pulse.in_phase = core::Interpolator(
      {core::Interpolation::linear, {{0.0, 1.0}, {0.25, 1.0}, {0.25 + 1e-15, -1.0}, {0.5, -1.0}, {0.5 + 1e-9, 1.0}}});
  pulses.push_back(steps);
  for (const double kept : {8.0, 21.0}) {
    EchoPulse cut = test_pulse(Pulse::Kind::chirp, 16.0, 0.8);
    cut.band_limited.emplace(cut.pulse, 0.5 / test_interval_s, 1.0 / test_interval_s, kept * test_interval_s);
    pulses.push_back(cut);
  }
  for (std::size_t i = 0; i < pulses.size(); ++i)
    for (int k = 0; k < 20; ++k) {
      SampleGrid grid = early_grid(100);
      grid.first_s += k * 0.07e-6;
      expect_reference(pulses[i], grid, echoes_on_samples(grid), "pulse " + std::to_string(i));
      if (HasFatalFailure()) return;
    }
}

TEST(DirectKernelShapes, AddsLongFlatTopsLikeTheReference) {
  const SampleGrid grid = early_grid(4000);
  for (const Pulse::Kind kind : {Pulse::Kind::mono, Pulse::Kind::chirp, Pulse::Kind::code}) {
    const EchoPulse plain = test_pulse(kind, 2600.3, kind == Pulse::Kind::chirp ? 0.1 : 0.0);
    expect_reference_at_all_speeds(with_ramps(plain, 300.0, 411.1), grid, "ramps");
    const core::Interpolator gain({core::Interpolation::linear, {{0.0, 0.2}, {0.3, 0.7}, {0.8, 0.7}, {1.0, -0.7}}});
    expect_reference_at_all_speeds(with_envelope(plain, gain), grid, "a flat curve");
  }
}

// Hundreds of echoes fill several sums in single precision, and blocks of 32 768 samples have centres of their own.
TEST(DirectKernelShapes, AddsManyEchoesInLongRowsLikeTheReference) {
  EchoPulse cut = test_pulse(Pulse::Kind::chirp, 60.0, 0.7);
  cut.band_limited.emplace(cut.pulse, 0.5 / test_interval_s, 1.0 / test_interval_s, cut.pulse.width_s);
  const SampleGrid grid = early_grid(33'500);
  for (const EchoPulse& pulse :
       {with_ramps(test_pulse(Pulse::Kind::chirp, 60.5, 0.8), 6.0, 8.0),
        with_ramps(test_pulse(Pulse::Kind::code, 60.5), 6.0, 8.0), user_pulse(40.0, methods[1], 7), cut}) {
    EchoBatch echoes = random_echoes(200, grid, 50.0, 0.05 * core::exact_light_speed_mps * doppler_of_cycle(pulse));
    for (std::size_t k = 0; k < 40; ++k)
      echoes.add(grid.first_s + (32'768.3 - 1.7 * static_cast<double>(k)) * test_interval_s, 1.0, 6.7e-6);
    const ComplexRow expected = reference_row(pulse, grid, carrier_hz, echoes);
    for (const double tolerance : {1e-6, 1e-9}) {
      DirectKernel kernel(pulse, grid, tolerance);
      // Up to 40 echoes in a sample; phases of 3e4 turns of the carrier and, against the block's centre, 3e6 of a
      // sweep.
      const double bound = 40.0 * (tolerance >= 1e-6 ? 5e-7 : 1e-11 + 2.0 * core::pi * 3e6 * 2.3e-16);
      EXPECT_LT(largest_difference(row_of(kernel, grid, carrier_hz, echoes), expected), bound) << tolerance;
    }
  }
}

TEST(DirectKernelShapes, GiveTheSameNumbersWhateverTheKernelDidBefore) {
  const SampleGrid grid = early_grid(300);
  EchoPulse band = band_limited_test_pulse(50.0, 0.8);
  for (const EchoPulse& pulse :
       {user_pulse(80.0, methods[0], 30), with_ramps(test_pulse(Pulse::Kind::chirp, 90.0, 0.7), 9.0, 8.0), band})
    for (const double tolerance : {1e-6, 1e-9}) {
      const EchoBatch echoes = all_sorts_of_echoes(pulse, grid, 0.3);
      DirectKernel kernel(pulse, grid, tolerance);
      const ComplexRow once = row_of(kernel, grid, carrier_hz, echoes);
      row_of(kernel, grid, 3.3 * carrier_hz, random_echoes(150, grid, 80.0, 900.0, 77));
      row_of(kernel, grid, carrier_hz, EchoBatch());
      EXPECT_EQ(row_of(kernel, grid, carrier_hz, echoes), once);
      ComplexRow row(grid.count, {3.0, -4.0});
      kernel.add(row, carrier_hz, echoes);
      for (std::size_t n = 0; n < grid.count; ++n) ASSERT_EQ(row[n], std::complex(3.0, -4.0) + once[n]);
    }
}

// A table for 500 000 samples in double precision is not made.
TEST(DirectKernelShapes, LeavePulsesTooLongForATableToTheReference) {
  EchoPulse pulse = with_ramps(test_pulse(Pulse::Kind::mono, 500'000.0), 1000.0, 1000.0);
  const SampleGrid grid = early_grid(50);
  EchoBatch echoes;
  echoes.add(grid.first_s - 200.0 * test_interval_s, 1.0, 10.0);
  DirectKernel kernel(pulse, grid, 1e-9);
  EXPECT_EQ(row_of(kernel, grid, carrier_hz, echoes), reference_row(pulse, grid, carrier_hz, echoes));
}

}  // namespace direct_kernel_shape_test
}  // namespace sarsim::radar
