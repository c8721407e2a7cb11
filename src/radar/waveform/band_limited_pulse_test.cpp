#include "radar/waveform/band_limited_pulse.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "core/maths/constants.hpp"
#include "core/maths/fft.hpp"

namespace sarsim::radar {
namespace band_limited_pulse_test {

constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr double half_band_hz = 5e6;
constexpr double sample_rate_hz = 10e6;
constexpr double reach_s = 28.0 / half_band_hz;
constexpr double table_error = 1e-9;  // the documented accuracy

Pulse mono() {
  Pulse pulse;
  pulse.width_s = 3e-6;
  return pulse;
}

Pulse chirp() {
  Pulse pulse;
  pulse.kind = Pulse::Kind::chirp;
  pulse.sweep_hz = 6e6;
  pulse.width_s = 10e-6;
  return pulse;
}

Pulse code() {
  Pulse pulse;
  pulse.kind = Pulse::Kind::code;
  pulse.code = barker_code(3);
  pulse.width_s = 4e-6;
  return pulse;
}

Pulse user() {
  Pulse pulse;
  pulse.kind = Pulse::Kind::user;
  pulse.width_s = 4e-6;
  pulse.in_phase =
      core::Interpolator(core::SampledFunction{core::Interpolation::linear, {{0.0, 0.0}, {0.3, 1.0}, {1.0, -0.5}}});
  pulse.quadrature = core::Interpolator(core::SampledFunction{core::Interpolation::linear, {{0.0, 1.0}, {1.0, 0.0}}});
  return pulse;
}

// The defining integral at t by Simpson's rule between the pulse's breaks, 2000 intervals in each piece of at most
// 25 cycles of the product: an error of (2 pi 25/2000)^4/180 = 2e-7 of the value's oscillating part would be too much,
// so pieces are split into tenths: 2e-11.
std::complex<double> integral(const Pulse& pulse, double t_s) {
  const auto filter = [](double lag_s) {
    const double cut_hz = 0.92 * half_band_hz;
    const double x = 2.0 * core::pi * cut_hz * lag_s;
    const double z = lag_s / reach_s;
    if (std::abs(z) > 1.0) return 0.0;
    return 2.0 * cut_hz * (x == 0.0 ? 1.0 : std::sin(x) / x) * std::exp(14.0 * (std::sqrt(1.0 - z * z) - 1.0));
  };
  std::vector<double> edges = pulse.breaks_s();
  for (int i = 0; i <= 10; ++i) edges.push_back(pulse.width_s * i / 10.0);
  edges.push_back(t_s - reach_s);
  edges.push_back(t_s + reach_s);
  std::ranges::sort(edges);
  std::complex<double> sum = 0.0;
  for (std::size_t e = 0; e + 1 < edges.size(); ++e) {
    const double a = std::max(0.0, edges[e]), b = std::min(pulse.width_s, edges[e + 1]);
    if (!(a < b)) continue;
    constexpr int intervals = 2000;
    for (int i = 0; i <= intervals; ++i) {
      const double weight = i == 0 || i == intervals ? 1.0 : (i % 2 == 1 ? 4.0 : 2.0);
      // The end points belong to this piece, whatever the pulse does on the other side of a jump.
      const double u = std::clamp(a + (b - a) * i / intervals, a + 1e-9 * (b - a), b - 1e-9 * (b - a));
      sum += weight * (b - a) / (3.0 * intervals) * pulse.value(u) * filter(t_s - u);
    }
  }
  return sum;
}

TEST(BandLimitedPulse, IsTheDocumentedIntegral) {
  std::mt19937 random(2);
  for (const Pulse& pulse : {mono(), chirp(), code(), user()}) {
    const BandLimitedPulse limited(pulse, half_band_hz, sample_rate_hz, 0.0);
    std::uniform_real_distribution<double> time(limited.first_s(), limited.last_s());
    for (int i = 0; i < 25; ++i) {
      const double t = time(random);
      EXPECT_LT(std::abs(limited.value(t) - integral(pulse, t)), table_error) << "t = " << t;
    }
  }
}

// Of a sweep beyond what the grid of the table holds, all of the integral is made of quadrature nodes.
TEST(BandLimitedPulse, IsTheDocumentedIntegralOfASweepMuchWiderThanTheBand) {
  Pulse wide = chirp();
  wide.sweep_hz = 60e6;
  wide.width_s = 2e-6;  // a tenth is 7 cycles: an error of 5e-11
  const BandLimitedPulse limited(wide, half_band_hz, sample_rate_hz, 0.0);
  for (double t = limited.first_s(); t < limited.last_s(); t += 0.317e-6)
    EXPECT_LT(std::abs(limited.value(t) - integral(wide, t)), table_error) << "t = " << t;
}

TEST(BandLimitedPulse, ServesAnySamplingRateWithTheSameShape) {
  const BandLimitedPulse slow(chirp(), half_band_hz, 3e6, 0.0);
  const BandLimitedPulse fast(chirp(), half_band_hz, 170e6, 0.0);
  for (double t = -5e-6; t < 15e-6; t += 0.1234e-6)
    EXPECT_LT(std::abs(slow.value(t) - fast.value(t)), 2.0 * table_error);
}

TEST(BandLimitedPulse, ManyValuesAreTheSingleOnes) {
  for (const double rate_hz : {7e6, 10e6, 64e6}) {
    const BandLimitedPulse limited(chirp(), half_band_hz, rate_hz, 0.0);
    std::vector<std::complex<double>> row(static_cast<std::size_t>(25e-6 * rate_hz));
    const double start_s = limited.first_s() - 1.3e-6;
    limited.values(start_s, row);
    for (std::size_t i = 0; i < row.size(); ++i)
      // A table position of some thousand is rounded to 1e4 epsilon of a step, over which the pulse turns by less
      // than 1.
      EXPECT_LT(std::abs(row[i] - limited.value(start_s + static_cast<double>(i) / rate_hz)), 1e5 * epsilon);
  }
}

TEST(BandLimitedPulse, EndsTwentyEightOverFBeforeAndAfterThePulse) {
  const BandLimitedPulse limited(mono(), half_band_hz, sample_rate_hz, 0.0);
  EXPECT_EQ(limited.first_s(), -reach_s);
  EXPECT_EQ(limited.last_s(), 3e-6 + reach_s);
  EXPECT_EQ(limited.value(limited.first_s() - 1e-9), 0.0);
  EXPECT_EQ(limited.value(limited.last_s() + 1e-9), 0.0);
  EXPECT_EQ(limited.value(1.0), 0.0);
  EXPECT_EQ(limited.value(-1.0), 0.0);
}

TEST(BandLimitedPulse, OfASymmetricPulseIsSymmetric) {
  for (const Pulse& pulse : {mono(), chirp()}) {
    const BandLimitedPulse limited(pulse, half_band_hz, sample_rate_hz, 0.0);
    for (double t = 0.013e-6; t < 8e-6; t += 0.17e-6)
      EXPECT_LT(std::abs(limited.value(0.5 * pulse.width_s + t) - limited.value(0.5 * pulse.width_s - t)),
                2.0 * table_error);
  }
}

// A pulse sampled 8 times faster than its band needs, and its spectrum on a fine grid.
struct Spectrum {
  double step_hz = 0.0;
  std::vector<std::complex<double>> bins;  // times the sampling interval: the Fourier integral
  [[nodiscard]] double frequency_hz(std::size_t k) const {
    const auto size = bins.size();
    return step_hz * (k < size / 2 ? static_cast<double>(k) : static_cast<double>(k) - static_cast<double>(size));
  }
  [[nodiscard]] double energy(double from_hz, double to_hz) const {
    double sum = 0.0;
    for (std::size_t k = 0; k < bins.size(); ++k)
      if (std::abs(frequency_hz(k)) >= from_hz && std::abs(frequency_hz(k)) < to_hz) sum += std::norm(bins[k]);
    return sum * step_hz;
  }
};

template <class Shape>
Spectrum spectrum_of(const Shape& value, double from_s, double to_s, double rate_hz) {
  const std::size_t size = core::good_fft_size(static_cast<std::size_t>(4.0 * (to_s - from_s) * rate_hz));
  Spectrum s{rate_hz / static_cast<double>(size), std::vector<std::complex<double>>(size)};
  const auto count = static_cast<std::size_t>((to_s - from_s) * rate_hz);
  for (std::size_t i = 0; i < count; ++i) s.bins[i] = value(from_s + static_cast<double>(i) / rate_hz) / rate_hz;
  core::Fft(size).forward(s.bins);
  for (std::size_t k = 0; k < size; ++k) s.bins[k] *= std::polar(1.0, -2.0 * core::pi * s.frequency_hz(k) * from_s);
  return s;
}

Spectrum spectrum_of(const BandLimitedPulse& limited) {
  return spectrum_of([&](double t) { return limited.value(t); }, limited.first_s(), limited.last_s(),
                     16.0 * half_band_hz);
}

// The response beyond F is below 1e-6; the table adds an error of 1e-8 over the whole length.
TEST(BandLimitedPulse, HasNoEnergyOutsideItsBand) {
  for (const Pulse& pulse : {mono(), chirp(), code(), user()}) {
    const BandLimitedPulse limited(pulse, half_band_hz, sample_rate_hz, 0.0);
    const Spectrum s = spectrum_of(limited);
    const double total = s.energy(0.0, 1e99);
    const double length_s = limited.last_s() - limited.first_s();
    EXPECT_LT(s.energy(half_band_hz, 1e99), 1e-12 * pulse.width_s + table_error * table_error * length_s);
    EXPECT_LT(s.energy(half_band_hz, 1e99), 1e-6 * total);  // -60 dB, whatever the derivation above says
  }
}

// Up to 0.84 F the spectrum is that of the rectangle, Tp sinc(f Tp) exp(-j pi f Tp), to 1e-6.
TEST(BandLimitedPulse, HasTheSpectrumOfTheHardPulseInItsPassBand) {
  const Pulse pulse = mono();
  const BandLimitedPulse limited(pulse, half_band_hz, sample_rate_hz, 0.0);
  const Spectrum s = spectrum_of(limited);
  const double length_s = limited.last_s() - limited.first_s();
  for (std::size_t k = 0; k < s.bins.size(); ++k) {
    const double f = s.frequency_hz(k);
    if (std::abs(f) > 0.84 * half_band_hz) continue;
    const double x = core::pi * f * pulse.width_s;
    const std::complex<double> hard = std::polar(pulse.width_s, -x) * (x == 0.0 ? 1.0 : std::sin(x) / x);
    EXPECT_LT(std::abs(s.bins[k] - hard), 1e-6 * pulse.width_s + table_error * length_s) << f;
  }
}

// Parseval: the squared difference to the hard pulse is the hard pulse's energy weighted with |1 - response|^2, which
// is 0 up to 0.84 F, at most 1 in between and 1 beyond F. Both sides are sums over equally dense samples, so that the
// tail that these fold back, an energy of 1/64 of that beyond F, is on both; a percent covers its uneven place.
TEST(BandLimitedPulse, DiffersFromTheHardPulseByTheEnergyOutsideTheBand) {
  const Pulse pulse = chirp();
  const BandLimitedPulse limited(pulse, half_band_hz, sample_rate_hz, 0.0);
  const auto hard = [&](double t) { return t >= 0.0 && t < pulse.width_s ? pulse.value(t) : 0.0; };
  constexpr double rate_hz = 128.0 * half_band_hz;
  const Spectrum s = spectrum_of(hard, limited.first_s(), limited.last_s(), rate_hz);
  double difference = 0.0, inside = 0.0;
  const double skirt_s = 10.0 / half_band_hz;
  for (double t = limited.first_s() + 0.5 / rate_hz; t < limited.last_s(); t += 1.0 / rate_hz) {
    const double squared = std::norm(limited.value(t) - hard(t)) / rate_hz;
    difference += squared;
    if (t > skirt_s && t < pulse.width_s - skirt_s) inside += squared;
  }
  EXPECT_LT(difference, 1.01 * s.energy(0.84 * half_band_hz, 1e99));
  EXPECT_GT(difference, 0.99 * s.energy(half_band_hz, 1e99));
  // Well inside the pulse the two agree far better than at the edges: the ripples of an edge decay like the inverse of
  // the distance, 10/F away to below 1/(2 pi 10) of their height of 0.5.
  EXPECT_LT(std::sqrt(inside / (pulse.width_s - 2.0 * skirt_s)), 0.5 / (2.0 * core::pi * 10.0));
}

TEST(BandLimitedPulse, KeptWidthCutsHardAboutTheCentreAndChangesNothingInside) {
  const Pulse pulse = chirp();
  const BandLimitedPulse whole(pulse, half_band_hz, sample_rate_hz, 0.0);
  const BandLimitedPulse kept(pulse, half_band_hz, sample_rate_hz, 1.5 * pulse.width_s);
  EXPECT_NEAR(kept.first_s(), -2.5e-6, 1e-6 * 4.0 * epsilon);
  EXPECT_NEAR(kept.last_s(), 12.5e-6, 1e-5 * 4.0 * epsilon);
  for (double t = -4e-6; t < 15e-6; t += 0.113e-6)
    EXPECT_EQ(kept.value(t), t >= kept.first_s() && t < kept.last_s() ? whole.value(t) : 0.0);
  const BandLimitedPulse wide(pulse, half_band_hz, sample_rate_hz, 100.0 * pulse.width_s);
  EXPECT_EQ(wide.first_s(), whole.first_s());
  EXPECT_EQ(wide.last_s(), whole.last_s());
}

}  // namespace band_limited_pulse_test
}  // namespace sarsim::radar
