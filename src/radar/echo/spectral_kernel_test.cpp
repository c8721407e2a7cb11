#include "radar/echo/spectral_kernel.hpp"

#include <algorithm>
#include <numeric>

#include "radar/echo/echo_test_support.hpp"

namespace sarsim::radar {
namespace spectral_kernel_test {

constexpr double carrier_hz = 2e9;
constexpr double tolerances[] = {1e-3, 1e-5, 1e-6, 1e-7, 1e-9};

// One cycle of Doppler over `samples` samples.
double cycle_mps(double samples) {
  return core::exact_light_speed_mps / (2.0 * carrier_hz * samples * test_interval_s);
}

void expect_promise(const EchoPulse& pulse, const SampleGrid& grid, const EchoBatch& echoes) {
  const ComplexRow expected = reference_row(pulse, grid, carrier_hz, echoes);
  const double strength = strength_of(pulse, grid, echoes);
  for (const double tolerance : tolerances) {
    SpectralKernel kernel(pulse, grid, tolerance);
    EXPECT_LT(relative_error(row_of(kernel, grid, carrier_hz, echoes), expected, strength), tolerance);
  }
}

TEST(SpectralKernel, KeepsItsPromiseAtEverySimdLevel) {
  at_every_simd_level([] {
    const SampleGrid grid = test_grid(300);
    expect_promise(test_pulse(Pulse::Kind::chirp, 100.4, 0.9), grid,
                   random_echoes(40, grid, 120.0, 0.1 * cycle_mps(100.0)));
  });
}

TEST(SpectralKernel, AddsEveryKindOfPulseLikeTheReference) {
  EchoPulse user = test_pulse(Pulse::Kind::user, 190.0);
  user.pulse.in_phase = core::Interpolator({core::Interpolation::linear, {{0.0, 0.3}, {0.4, 1.0}, {1.0, -0.5}}});
  user.pulse.quadrature = core::Interpolator({core::Interpolation::cubic, {{0.0, 1.0}, {0.5, -1.0}, {1.0, 0.0}}});
  EchoPulse ramps = test_pulse(Pulse::Kind::chirp, 190.0, 0.7);
  ramps.pulse.envelope = Pulse::Envelope::linear;
  ramps.pulse.rise_s = ramps.pulse.fall_s = 40.0 * test_interval_s;
  EchoPulse led = test_pulse(Pulse::Kind::chirp, 200.0, -1.2);
  led.lead_s = 100.0 * test_interval_s;
  EchoPulse led_band = band_limited_test_pulse(60.0, 0.9);
  led_band.lead_s = 30.0 * test_interval_s;
  const SampleGrid grid = test_grid(400);
  for (const EchoPulse& pulse : {user, ramps, led, led_band, test_pulse(Pulse::Kind::mono, 111.0),
                                 test_pulse(Pulse::Kind::code, 350.0), test_pulse(Pulse::Kind::chirp, 300.0, 2.5)})
    expect_promise(pulse, grid, random_echoes(30, grid, 250.0, 20.0));
}

// A wrong decision would be an error of a whole sample.
TEST(SpectralKernel, DecidesEdgesExactlyOnSamplesLikeTheReference) {
  for (const EchoPulse& pulse : {test_pulse(Pulse::Kind::chirp, 100.0, 0.8), test_pulse(Pulse::Kind::code, 325.0)})
    for (int k = 0; k < 20; ++k) {
      SampleGrid grid = test_grid(500);
      grid.first_s = 3.3e-6 + k * 0.7e-6;
      EchoBatch echoes;
      for (const double off : {0.0, -0.9e-9, 0.9e-9, 1e-12})  // in intervals, within the tolerance of an edge
        echoes.add(grid.first_s + (20.0 + 3.0 * k + off) * test_interval_s, 1.0, k % 2 == 0 ? 0.0 : 30.0);
      const ComplexRow expected = reference_row(pulse, grid, carrier_hz, echoes);
      SpectralKernel kernel(pulse, grid, 1e-6);
      ASSERT_LT(largest_difference(row_of(kernel, grid, carrier_hz, echoes), expected), 4.0 * 1e-5) << k;
    }
}

TEST(SpectralKernel, EchoesThatOverhangAnEndChangeTheSamplesInsideOnly) {
  const EchoPulse pulse = test_pulse(Pulse::Kind::chirp, 100.3, 0.8);
  const SampleGrid grid = test_grid(150);
  for (const double position :
       {-100.29, -99.0, -97.5, -92.0, -50.0, -3.3, -1e-3, 0.0, 60.0, 140.5, 146.0, 148.5, 148.9, 149.0}) {
    EchoBatch echoes;
    echoes.add(grid.first_s + position * test_interval_s, 1.0, 3e-8);
    expect_promise(pulse, grid, echoes);
  }
  for (const double position : {-70.0, 149.0}) {  // longer than the row, on both sides
    EchoBatch echoes;
    echoes.add(grid.first_s + position * test_interval_s, 1.0, 3e-8);
    expect_promise(test_pulse(Pulse::Kind::chirp, 400.0, 0.8), grid, echoes);
  }
}

EchoBatch moving_echoes(const SampleGrid& grid, double common_mps, double spread_mps) {
  EchoBatch echoes = random_echoes(25, grid, 100.0, spread_mps);
  for (double& d : echoes.doppler) d += 2.0 * common_mps / core::exact_light_speed_mps;
  return echoes;
}

TEST(SpectralKernel, FollowsCommonAndSpreadDopplerOfEitherSign) {
  const SampleGrid grid = test_grid(300);
  const double cycle = cycle_mps(120.0);
  for (const EchoPulse& pulse : {test_pulse(Pulse::Kind::chirp, 120.0, 0.9), test_pulse(Pulse::Kind::mono, 120.0),
                                 band_limited_test_pulse(40.0, 0.9)})
    for (const double common : {0.0, 0.7, -2.0})
      for (const double spread : {0.0, 1e-3, 0.2, 1.0})
        expect_promise(pulse, grid, moving_echoes(grid, common * cycle, spread * cycle));
}

// More Doppler than an expansion can take: added directly, to the direct kernel's error.
TEST(SpectralKernel, AddsDirectlyWhatTurnsTooOften) {
  const SampleGrid grid = test_grid(300);
  const EchoPulse pulse = test_pulse(Pulse::Kind::mono, 120.0);
  expect_promise(pulse, grid, moving_echoes(grid, 0.0, 12.0 * cycle_mps(120.0)));
  EXPECT_GT(SpectralKernel::cost(pulse, grid, 1e-6, carrier_hz, -1e-3, 1e-3).doppler_terms, 24u);
}

TEST(SpectralKernel, AddsShortPulsesLikeTheReference) {
  const SampleGrid grid = test_grid(200);
  for (const double samples : {1.0, 5.5, 15.0, 16.5, 23.5, 24.5})
    for (const Pulse::Kind kind : {Pulse::Kind::mono, Pulse::Kind::chirp, Pulse::Kind::code})
      expect_promise(test_pulse(kind, samples, 0.8), grid, random_echoes(20, grid, samples, 100.0));
}

// A pulse may keep a band of its own that the samples do not hold: it folds as the reference folds it.
TEST(SpectralKernel, FoldsBandLimitedPulsesOfMoreThanTheSampledBand) {
  const SampleGrid grid = test_grid(150);
  for (const double half_band : {0.575, 0.74, 1.3})
    for (const double kept : {0.0, 1.5}) {
      EchoPulse pulse = test_pulse(Pulse::Kind::chirp, 60.0, 2.0 * half_band);
      pulse.band_limited.emplace(pulse.pulse, half_band / test_interval_s, 1.0 / test_interval_s,
                                 kept * pulse.pulse.width_s);
      SCOPED_TRACE(half_band);
      expect_promise(pulse, grid, random_echoes(20, grid, 60.0, 20.0));
    }
}

// A third of a sample in which the pulse goes through five cycles.
TEST(SpectralKernel, FollowsBandLimitedPulsesThatAreFarShorterThanASample) {
  const SampleGrid grid = test_grid(50);
  EchoPulse pulse = test_pulse(Pulse::Kind::chirp, 0.34, 30.0);
  pulse.band_limited.emplace(pulse.pulse, 15.0 / test_interval_s, 1.0 / test_interval_s, pulse.pulse.width_s);
  expect_promise(pulse, grid, random_echoes(60, grid, 1.0, 20.0));
}

// The filter's tails last a hundred times as long as the pulse, and there a steep sweep is shifted by a hundred times
// as much as at the carrier.
TEST(SpectralKernel, MakesRoomForTheShiftOfTheTailsOfVeryShortChirps) {
  const SampleGrid grid = test_grid(50);
  const EchoPulse pulse = band_limited_test_pulse(0.34, 1.06);
  for (const double speed_mps : {-cycle_mps(500.0), cycle_mps(500.0)}) {
    EchoBatch echoes;
    echoes.add(grid.first_s + 20.3 * test_interval_s, 1.0, 2.0 * speed_mps / core::exact_light_speed_mps);
    expect_promise(pulse, grid, echoes);
  }
}

// Spectra are kept from call to call; they must follow the carrier as it steps, and the span of Doppler.
TEST(SpectralKernel, FollowsSteppedCarriersAndChangingSpeeds) {
  const EchoPulse pulse = test_pulse(Pulse::Kind::chirp, 120.0, 0.9);
  const SampleGrid grid = test_grid(300);
  SpectralKernel kernel(pulse, grid, 1e-9);
  for (int round = 0; round < 3; ++round)
    for (int step = 0; step < 9; ++step) {
      const double f = 1e9 + 4e8 * step;
      for (const double spread : {0.0, 0.3}) {
        const EchoBatch echoes =
            moving_echoes(grid, (step % 3 - 1) * 0.4 * cycle_mps(120.0), spread * cycle_mps(120.0));
        ASSERT_LT(relative_error(row_of(kernel, grid, f, echoes), reference_row(pulse, grid, f, echoes),
                                 strength_of(pulse, grid, echoes)),
                  1e-9)
            << round << ' ' << step << ' ' << spread;
      }
    }
}

TEST(SpectralKernel, GivesTheSameBytesWhateverItDidBefore) {
  for (const double tolerance : {1e-6, 1e-9}) {
    const EchoPulse pulse = test_pulse(Pulse::Kind::chirp, 120.0, 0.9);
    const SampleGrid grid = test_grid(300);
    const EchoBatch echoes = random_echoes(33, grid, 120.0, 0.1 * cycle_mps(120.0));
    SpectralKernel fresh(pulse, grid, tolerance), used(pulse, grid, tolerance);
    const ComplexRow once = row_of(fresh, grid, carrier_hz, echoes);
    for (const double speed : {0.0, 1.0, 500.0, 1e5})
      for (const int count : {0, 1, 200}) row_of(used, grid, 3e9, random_echoes(count, grid, 120.0, speed));
    EXPECT_EQ(row_of(used, grid, carrier_hz, echoes), once);
    EXPECT_EQ(row_of(fresh, grid, carrier_hz, echoes), once);
    SpectralKernel moved = std::move(used);
    EXPECT_EQ(row_of(moved, grid, carrier_hz, echoes), once);
  }
}

TEST(SpectralKernel, AddsToWhatIsThere) {
  const EchoPulse pulse = test_pulse(Pulse::Kind::chirp, 60.0, 0.9);
  const SampleGrid grid = test_grid(100);
  const EchoBatch echoes = random_echoes(3, grid, 60.0, 0.0);
  SpectralKernel kernel(pulse, grid, 1e-9);
  const ComplexRow once = row_of(kernel, grid, carrier_hz, echoes);
  ComplexRow row(grid.count, {3.0, -4.0});
  kernel.add(row, carrier_hz, echoes);
  for (std::size_t n = 0; n < grid.count; ++n)  // body and edges are added one after the other
    EXPECT_LT(std::abs(row[n] - std::complex(3.0, -4.0) - once[n]), 1e-14);
}

// The far echo widens the span of Doppler and fills the same grid, yet where it is not, samples stay.
TEST(SpectralKernel, AFarEchoLeavesTheSamplesOfTheOthersAlone) {
  const EchoPulse pulse = test_pulse(Pulse::Kind::chirp, 100.0, 0.9);
  const SampleGrid grid = test_grid(1000);
  EchoBatch near;
  for (int k = 0; k < 10; ++k) near.add(grid.first_s + (20.0 + 3.3 * k) * test_interval_s, 1.0, 2.0 * k);
  EchoBatch both = near;
  both.add(grid.first_s + 801.7 * test_interval_s, 1.0, 0.3 * cycle_mps(100.0));
  for (const double tolerance : tolerances) {
    SpectralKernel kernel(pulse, grid, tolerance);
    const ComplexRow without = row_of(kernel, grid, carrier_hz, near), with = row_of(kernel, grid, carrier_hz, both);
    double change = 0.0;
    for (std::size_t n = 0; n < 800; ++n) change += std::norm(with[n] - without[n]);
    EXPECT_LT(std::sqrt(change), tolerance * strength_of(pulse, grid, both)) << tolerance;
  }
}

TEST(SpectralKernel, LeavesARowAloneThatNoEchoTouches) {
  const SampleGrid grid = test_grid(100);
  const EchoPulse pulse = test_pulse(Pulse::Kind::chirp, 80.0, 0.8);
  EchoBatch outside;
  for (const double position : {-1e9, -80.0 - 1e-6, 100.0 + 1e-6, 1e9})
    outside.add(grid.first_s + position * test_interval_s, 1.0, 10.0);
  for (const EchoBatch& echoes : {EchoBatch(), outside})
    for (const double tolerance : tolerances) {
      SpectralKernel kernel(pulse, grid, tolerance);
      for (const auto& s : row_of(kernel, grid, carrier_hz, echoes)) EXPECT_EQ(s, 0.0);
    }
}

// A row through a filter, sum by sum.
ComplexRow filtered(const ComplexRow& row, const RowFilter& filter) {
  ComplexRow out(filter.output_index.size());
  for (std::size_t i = 0; i < out.size(); ++i)
    for (std::size_t k = 0; k < filter.taps.size(); ++k) out[i] += filter.taps[k] * row.at(filter.output_index[i] + k);
  return out;
}

// The filter's largest gain: its error is at most that of the row times this.
double largest_gain(const ComplexRow& taps) {
  double largest = 0.0;
  for (int i = 0; i < 4096; ++i) {
    std::complex<double> sum = 0.0;
    for (std::size_t k = 0; k < taps.size(); ++k)
      sum += taps[k] * std::polar(1.0, 2.0 * core::pi * std::remainder(static_cast<double>(k) * i / 4096.0, 1.0));
    largest = std::max(largest, std::abs(sum));
  }
  return largest;
}

void add_filtered(SpectralKernel& kernel, ComplexRow& out, const EchoBatch& echoes) {
  kernel.begin(carrier_hz);
  kernel.take(echoes);
  kernel.finish_filtered(out);
}

void expect_filtered(const EchoPulse& pulse, const SampleGrid& grid, const EchoBatch& echoes,
                     const std::vector<std::size_t>& index, const ComplexRow& taps) {
  const RowFilter filter{taps, index};
  const ComplexRow expected = filtered(reference_row(pulse, grid, carrier_hz, echoes), filter);
  const double strength = strength_of(pulse, grid, echoes) * largest_gain(taps);
  for (const double tolerance : tolerances) {
    SpectralKernel kernel(pulse, grid, tolerance, filter);
    ComplexRow out(index.size(), {0.5, -2.0});  // is added to
    add_filtered(kernel, out, echoes);
    for (auto& z : out) z -= std::complex(0.5, -2.0);
    EXPECT_LT(relative_error(out, expected, strength), tolerance) << tolerance;
    const ComplexRow raw = row_of(kernel, grid, carrier_hz, echoes);  // and the row is still to be had
    EXPECT_LT(relative_error(raw, reference_row(pulse, grid, carrier_hz, echoes), strength_of(pulse, grid, echoes)),
              tolerance);
  }
}

ComplexRow replica(const EchoPulse& pulse, std::size_t count) {
  ComplexRow taps(count);
  for (std::size_t k = 0; k < count; ++k)
    taps[k] = std::conj(pulse.pulse.value(static_cast<double>(k) * test_interval_s)) / static_cast<double>(count);
  return taps;
}

std::vector<std::size_t> every(std::size_t stride, std::size_t count) {
  std::vector<std::size_t> index;
  for (std::size_t i = 0; i < count; i += stride) index.push_back(i);
  return index;
}

TEST(SpectralKernel, FiltersEchoesInTheSpectrumLikeASumOverTheRow) {
  const SampleGrid grid = test_grid(400);
  const EchoPulse chirp = test_pulse(Pulse::Kind::chirp, 100.4, 0.9);
  const EchoPulse code = test_pulse(Pulse::Kind::code, 350.0);
  const EchoPulse band = band_limited_test_pulse(60.0, 0.9);
  const double moving = 0.3 * cycle_mps(100.0);
  for (const EchoPulse& pulse : {chirp, code, band, test_pulse(Pulse::Kind::mono, 40.0)})
    for (const double speed : {0.0, moving}) {
      const EchoBatch echoes = random_echoes(30, grid, 120.0, speed);  // some overhang either end
      expect_filtered(pulse, grid, echoes, every(1, 300), replica(chirp, 101));
      expect_filtered(pulse, grid, echoes, every(3, 400), ComplexRow{{0.0, 2.0}});
    }
}

// 1e-32 behind a filter of 1e-10 is below what single precision holds, but neither is by itself.
TEST(SpectralKernel, FiltersOfLittleGainKeepWeakEchoes) {
  const SampleGrid grid = test_grid(300);
  const EchoPulse chirp = test_pulse(Pulse::Kind::chirp, 100.4, 0.9);
  EchoBatch echoes = random_echoes(10, grid, 100.0, 0.0);
  for (double& amplitude : echoes.amplitude_sqrt_w) amplitude *= 1e-32;
  ComplexRow taps = replica(chirp, 101);
  for (auto& tap : taps) tap *= 1e-10;
  const std::vector<std::size_t> index = every(1, 200);
  SpectralKernel kernel(chirp, grid, 1e-6, {taps, index});
  ComplexRow out(index.size());
  add_filtered(kernel, out, echoes);
  const ComplexRow expected = filtered(reference_row(chirp, grid, carrier_hz, echoes), {taps, index});
  EXPECT_LT(relative_error(out, expected, strength_of(chirp, grid, echoes) * largest_gain(taps)), 1e-6);
}

// Pulses without a body and pulses that turn too often are added as samples before they are filtered.
TEST(SpectralKernel, FiltersWhatItAddsDirectly) {
  const SampleGrid grid = test_grid(300);
  const EchoPulse chip = test_pulse(Pulse::Kind::chirp, 7.5, 0.8);
  expect_filtered(chip, grid, random_echoes(20, grid, 9.0, 100.0), every(1, 290), replica(chip, 8));
  const EchoPulse mono = test_pulse(Pulse::Kind::mono, 120.0);
  expect_filtered(mono, grid, moving_echoes(grid, 0.0, 12.0 * cycle_mps(120.0)), every(1, 181), replica(mono, 120));
}

TEST(SpectralKernel, FiltersTheSameBytesWhateverItDidBefore) {
  const SampleGrid grid = test_grid(300);
  const EchoPulse mono = test_pulse(Pulse::Kind::mono, 120.0);
  const ComplexRow taps = replica(mono, 120);
  const std::vector<std::size_t> index = every(1, 181);
  const EchoBatch slow = random_echoes(20, grid, 120.0, 10.0);
  const EchoBatch direct = moving_echoes(grid, 0.0, 12.0 * cycle_mps(120.0));
  const auto filtered_by = [&](SpectralKernel& kernel, const EchoBatch& echoes) {
    ComplexRow out(index.size());
    add_filtered(kernel, out, echoes);
    return out;
  };
  SpectralKernel fresh(mono, grid, 1e-6, {taps, index}), used(mono, grid, 1e-6, {taps, index});
  const ComplexRow of_direct = filtered_by(fresh, direct);
  const ComplexRow of_slow = filtered_by(fresh, slow);
  EXPECT_EQ(filtered_by(used, slow), of_slow);
  EXPECT_EQ(filtered_by(used, direct), of_direct);
  EXPECT_EQ(filtered_by(used, slow), of_slow);
}

TEST(SpectralKernel, FiltersNothingWhereNoEchoTouchesTheRow) {
  const SampleGrid grid = test_grid(100);
  const EchoPulse pulse = test_pulse(Pulse::Kind::chirp, 80.0, 0.8);
  const ComplexRow taps = replica(pulse, 80);
  const std::vector<std::size_t> index = every(1, 20);
  SpectralKernel kernel(pulse, grid, 1e-6, {taps, index});
  ComplexRow out(20, {1.0, 1.0});
  add_filtered(kernel, out, {});
  for (const auto& z : out) EXPECT_EQ(z, std::complex(1.0, 1.0));
}

// Echoes in order of their speeds, so that every part asks for more than the last.
std::vector<EchoBatch> parts_of(const EchoBatch& echoes, std::size_t count) {
  std::vector<std::size_t> order(echoes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t k) { return echoes.doppler[k]; });
  std::vector<EchoBatch> parts(count);
  for (std::size_t i = 0; i < order.size(); ++i)
    parts[i * count / order.size()].add(echoes.delay_s[order[i]], echoes.amplitude_sqrt_w[order[i]],
                                        echoes.doppler[order[i]]);
  return parts;
}

void take_all(SpectralKernel& kernel, const std::vector<EchoBatch>& parts) {
  kernel.begin(carrier_hz);
  for (const EchoBatch& part : parts) kernel.take(part);
}

TEST(SpectralKernelParts, GiveTheRowOfAllEchoes) {
  const SampleGrid grid = test_grid(400);
  const ComplexRow taps = replica(test_pulse(Pulse::Kind::chirp, 100.4, 0.9), 101);
  const std::vector<std::size_t> index = every(1, 300);
  const RowFilter filter{taps, index};
  const EchoPulse chirp = test_pulse(Pulse::Kind::chirp, 100.4, 0.9);
  const EchoPulse band = band_limited_test_pulse(60.0, 0.9);
  const EchoPulse mono = test_pulse(Pulse::Kind::mono, 120.0);
  for (const EchoPulse& pulse : {chirp, band, mono})
    for (const double cycles : {0.0, 0.3, 12.0}) {  // the last: some parts go through the grid, the others directly
      const EchoBatch echoes = moving_echoes(grid, 0.0, cycles * cycle_mps(100.0));
      const ComplexRow expected = reference_row(pulse, grid, carrier_hz, echoes);
      const double strength = strength_of(pulse, grid, echoes);
      for (const double tolerance : tolerances)
        for (const std::size_t count : {1u, 2u, 7u}) {
          SpectralKernel kernel(pulse, grid, tolerance, filter);
          take_all(kernel, parts_of(echoes, count));
          ComplexRow row(grid.count);
          kernel.finish(row);
          EXPECT_LT(relative_error(row, expected, strength), tolerance) << count << " parts, " << cycles << " cycles";
          take_all(kernel, parts_of(echoes, count));
          ComplexRow out(index.size());
          kernel.finish_filtered(out);
          EXPECT_LT(relative_error(out, filtered(expected, filter), strength * largest_gain(taps)), tolerance);
        }
    }
}

TEST(SpectralKernelParts, OfOnePulseAreForgottenWhenTheNextBegins) {
  const SampleGrid grid = test_grid(300);
  const EchoPulse chirp = test_pulse(Pulse::Kind::chirp, 100.4, 0.9);
  const EchoBatch echoes = random_echoes(20, grid, 120.0, 10.0);
  SpectralKernel fresh(chirp, grid, 1e-6), used(chirp, grid, 1e-6);
  const ComplexRow expected = row_of(fresh, grid, carrier_hz, echoes);
  take_all(used, {echoes, moving_echoes(grid, 0.0, 0.3 * cycle_mps(100.0))});
  EXPECT_EQ(row_of(used, grid, carrier_hz, echoes), expected);
  used.begin(carrier_hz);
  ComplexRow nothing(grid.count);
  used.finish(nothing);
  EXPECT_EQ(nothing, ComplexRow(grid.count));
}

TEST(SpectralKernelCost, TellsWidthEdgesTransformAndDopplerTerms) {
  const SampleGrid grid = test_grid(1000);
  const EchoPulse pulse = test_pulse(Pulse::Kind::chirp, 200.0, 0.8);
  const SpectralCost resting = SpectralKernel::cost(pulse, grid, 1e-6, carrier_hz, 0.0, 0.0);
  EXPECT_EQ(resting.gridding_width, 8u);  // 10^(1 - 8) for an eighth of the promise
  EXPECT_EQ(resting.edge_samples, 16u);
  EXPECT_EQ(resting.doppler_terms, 1u);
  EXPECT_GT(resting.transform_size, 4u * 1200u / 2u);
  EXPECT_EQ(SpectralKernel::cost(pulse, grid, 1e-9, carrier_hz, 0.0, 0.0).edge_samples, 24u);
  // A hundredth of a cycle over the pulse takes a few terms, one cycle about a dozen (at 1e-6).
  const double cycle = 1.0 / (carrier_hz * pulse.pulse.width_s);
  const std::size_t few = SpectralKernel::cost(pulse, grid, 1e-6, carrier_hz, 0.0, 0.01 * cycle).doppler_terms;
  EXPECT_GE(few, 3u);
  EXPECT_LE(few, 5u);
  const std::size_t more = SpectralKernel::cost(pulse, grid, 1e-6, carrier_hz, 0.0, cycle).doppler_terms;
  EXPECT_GE(more, 8u);
  EXPECT_LE(more, 16u);
  EXPECT_EQ(SpectralKernel::cost(test_pulse(Pulse::Kind::mono, 5.0), grid, 1e-6, carrier_hz, 0.0, 0.0).doppler_terms,
            25u);
  // A shift of a tenth of the sampling rate widens the band by an eighth on either side, whatever the span.
  const double tenth = 0.1 / (carrier_hz * test_interval_s);
  const SpectralCost fast = SpectralKernel::cost(pulse, grid, 1e-6, carrier_hz, -tenth, -tenth);
  EXPECT_EQ(fast.doppler_terms, 1u);
  EXPECT_NEAR(static_cast<double>(fast.transform_size - resting.transform_size), 4.0 * 0.125 * 1200.0, 2.0);
  EXPECT_EQ(SpectralKernel::cost(band_limited_test_pulse(60.0, 0.9), grid, 1e-6, carrier_hz, 0.0, 0.0).edge_samples,
            0u);
}

}  // namespace spectral_kernel_test
}  // namespace sarsim::radar
