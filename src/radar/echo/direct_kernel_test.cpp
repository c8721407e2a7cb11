#include "radar/echo/direct_kernel.hpp"

#include "radar/echo/echo_test_support.hpp"

namespace sarsim::radar {
namespace direct_kernel_test {

constexpr double carrier_hz = 2e9;

// Per echo and sample: what the header promises of the tones, and the rounding of phases of `turns` in double.
double bound(const EchoBatch& echoes, double tolerance, double turns) {
  double sum = 0.0;
  for (const double a : echoes.amplitude_sqrt_w) sum += std::abs(a);
  return sum * ((tolerance >= 1e-6 ? 3e-7 : 1e-11) + 2.0 * core::pi * 2.3e-16 * 4.0 * turns);
}

// Largest difference to the reference; a carrier of 6e4 cycles and phases of up to 1e4 cycles against the row's centre.
void expect_reference(const EchoPulse& pulse, const SampleGrid& grid, const EchoBatch& echoes) {
  const ComplexRow expected = reference_row(pulse, grid, carrier_hz, echoes);
  for (const double tolerance : {1e-6, 1e-9}) {
    DirectKernel kernel(pulse, grid, tolerance);
    EXPECT_LT(largest_difference(row_of(kernel, grid, carrier_hz, echoes), expected), bound(echoes, tolerance, 1e5))
        << tolerance;
  }
}

TEST(DirectKernel, AddsChirpsLikeTheReference) {
  at_every_simd_level([] {
    for (const double sweep : {0.9, -1.4})
      for (const double speed_mps : {0.0, 250.0, 9000.0})
        for (const double lead : {0.0, 60.0}) {
          EchoPulse pulse = test_pulse(Pulse::Kind::chirp, 120.3, sweep);
          pulse.lead_s = lead * test_interval_s;
          const SampleGrid grid = test_grid(501);
          expect_reference(pulse, grid, random_echoes(30, grid, 150.0, speed_mps));
        }
  });
}

// Whatever else stands in the row stays, bit for bit, outside of the samples that are said; row after row.
TEST(DirectKernel, LeavesSamplesAloneThatNoEchoReaches) {
  at_every_simd_level([] {
    for (const EchoPulse& pulse : {test_pulse(Pulse::Kind::chirp, 20.3, 0.9), test_pulse(Pulse::Kind::mono, 20.3),
                                   test_pulse(Pulse::Kind::code, 20.3), band_limited_test_pulse(20.3, 0.4)})
      for (const double tolerance : {1e-6, 1e-9}) {
        const SampleGrid grid = test_grid(400);
        DirectKernel kernel(pulse, grid, tolerance);
        const ComplexRow given(grid.count, {0.3, -0.7});
        for (const double at : {-300.0, 100.4, 333.0, -3.5, 390.2}) {
          EchoBatch echoes;
          echoes.add(grid.first_s + at * grid.interval_s, 1.0, 1e-6);
          const SampleSpan on = touched_samples(pulse, grid, echoes.delay_s[0], pulse.clock_of(echoes, 0));
          ComplexRow row = given;
          const SampleSpan touched = kernel.add(row, carrier_hz, echoes);
          if (on.is_empty()) {
            EXPECT_TRUE(touched.is_empty());
          } else {
            EXPECT_EQ(touched.begin, on.begin);
            EXPECT_EQ(touched.end, on.end);
          }
          const ComplexRow expected = reference_row(pulse, grid, carrier_hz, echoes);
          for (std::size_t i = 0; i < row.size(); ++i)
            if (i < touched.begin || i >= touched.end)
              EXPECT_EQ(row[i], given[i]) << i;
            else
              EXPECT_LT(std::abs(row[i] - given[i] - expected[i]), 6e-7) << i;
        }
      }
  });
}

TEST(DirectKernel, AddsMonochromePulsesLikeTheReference) {
  at_every_simd_level([] {
    for (const double samples : {1.0, 3.7, 200.0, 2000.0})
      for (const double speed_mps : {0.0, 250.0, 9000.0}) {
        const SampleGrid grid = test_grid(300);
        expect_reference(test_pulse(Pulse::Kind::mono, samples), grid, random_echoes(30, grid, samples, speed_mps));
      }
  });
}

TEST(DirectKernel, AddsEveryBarkerCodeLikeTheReference) {
  at_every_simd_level([] {
    for (int code = 0; code < 7; ++code)
      for (const double speed_mps : {0.0, 400.0})
        for (const double samples : {7.3, 77.77, 156.0}) {
          EchoPulse pulse = test_pulse(Pulse::Kind::code, samples);
          pulse.pulse.code = barker_code(code);
          pulse.lead_s = code % 2 == 0 ? 0.0 : 0.5 * pulse.pulse.width_s;
          const SampleGrid grid = test_grid(400);
          expect_reference(pulse, grid, random_echoes(40, grid, samples, speed_mps));
        }
  });
}

// Delays that are whole samples, in grids that round them either way: a sample on the border of two chips or on an edge
// must be decided as the reference does; a wrong sign would be an error of 2.
TEST(DirectKernel, DecidesSamplesOnBordersOfChipsAndOnEdgesLikeTheReference) {
  for (int code = 0; code < 7; ++code)
    for (const double chip : {1.0, 3.0, 10.0})
      for (int k = 0; k < 60; ++k) {
        EchoPulse pulse = test_pulse(Pulse::Kind::code, chip * static_cast<double>(barker_code(code).size()));
        pulse.pulse.code = barker_code(code);
        SampleGrid grid = test_grid(200);
        grid.first_s = 3.3e-6 + k * 0.7e-6;
        EchoBatch echoes;
        for (const double off : {0.0, -0.9e-9, 0.9e-9})  // in intervals: within the tolerance of 1e-9 of an edge
          echoes.add(grid.first_s + (20.0 + k + off) * test_interval_s, 1.0, 0.0);
        const ComplexRow expected = reference_row(pulse, grid, 0.0, echoes);
        DirectKernel kernel(pulse, grid, 1e-6);
        ASSERT_LT(largest_difference(row_of(kernel, grid, 0.0, echoes), expected), 1e-6) << code << ' ' << chip << k;
      }
}

// Phases against the centre of a row of a million samples would be 1e8 cycles.
TEST(DirectKernel, KeepsItsAccuracyInRowsOfAMillionSamples) {
  const SampleGrid grid = test_grid(1'000'000);
  for (const Pulse::Kind kind : {Pulse::Kind::chirp, Pulse::Kind::mono, Pulse::Kind::code}) {
    const EchoPulse pulse = test_pulse(kind, 1000.0, 1.0);
    EchoBatch echoes;
    for (const double at : {3.3, 32768.0 - 500.0, 65536.0, 500'000.7, 999'500.2})  // some across the borders of blocks
      echoes.add(grid.first_s + at * test_interval_s, 1.0, 20.0);
    const ComplexRow expected = reference_row(pulse, grid, carrier_hz, echoes);
    DirectKernel kernel(pulse, grid, 1e-9);
    // Carrier: 2e7 cycles; sweep: 1e6 cycles against the block's centre; times: 1e-2 s, to 2e-10 samples of half a
    // cycle.
    EXPECT_LT(largest_difference(row_of(kernel, grid, carrier_hz, echoes), expected),
              2.0 * core::pi * (2e7 * 2.3e-16 + 1e6 * 5e-16 + 4e-10));
  }
}

TEST(DirectKernel, TakesTheCarrierOfEachCall) {
  const EchoPulse pulse = test_pulse(Pulse::Kind::chirp, 80.0, 0.8);
  const SampleGrid grid = test_grid(200);
  const EchoBatch echoes = random_echoes(10, grid, 80.0, 500.0);
  DirectKernel kernel(pulse, grid, 1e-9);
  for (const double f : {1e9, 1.3e9, 1e9})
    EXPECT_LT(largest_difference(row_of(kernel, grid, f, echoes), reference_row(pulse, grid, f, echoes)), 1e-9);
}

TEST(DirectKernel, AddsToWhatIsThereAndRemembersNothing) {
  const EchoPulse pulse = test_pulse(Pulse::Kind::code, 80.0);
  const SampleGrid grid = test_grid(200);
  const EchoBatch echoes = random_echoes(10, grid, 80.0, 500.0);
  DirectKernel kernel(pulse, grid, 1e-6);
  const ComplexRow once = row_of(kernel, grid, carrier_hz, echoes);
  row_of(kernel, grid, carrier_hz, random_echoes(200, grid, 80.0, 9.0, 77));
  EXPECT_EQ(row_of(kernel, grid, carrier_hz, echoes), once);
  ComplexRow row(grid.count, {3.0, -4.0});
  kernel.add(row, carrier_hz, echoes);
  for (std::size_t n = 0; n < grid.count; ++n) EXPECT_EQ(row[n], std::complex(3.0, -4.0) + once[n]);
}

TEST(DirectKernel, LeavesARowAloneThatNoEchoTouches) {
  const SampleGrid grid = test_grid(100);
  EchoBatch outside;
  for (const double position : {-1e9, -80.0, 100.0, 1e9}) outside.add(grid.time_s(0) + position * 1e-8, 1.0, 10.0);
  for (const EchoBatch& echoes : {EchoBatch(), outside}) {
    const EchoPulse pulse = test_pulse(Pulse::Kind::chirp, 80.0, 0.8);
    DirectKernel kernel(pulse, grid, 1e-6);
    for (const auto& s : row_of(kernel, grid, carrier_hz, echoes)) EXPECT_EQ(s, 0.0);
  }
}

}  // namespace direct_kernel_test
}  // namespace sarsim::radar
