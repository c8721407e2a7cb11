#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "core/maths/constants.hpp"
#include "signal/sar/focusing.hpp"
#include "signal/sar/image_spectrum.hpp"
#include "signal/sar/image_test_value.hpp"
#include "signal/sar/sar_test_scene.hpp"
#include "signal/sar/swath_loss.hpp"

namespace sarsim::signal {
namespace focusing_amplitude_test {

using namespace sar_test;

// A point on the plane of the flight, seen by all pulses of a straight flight past it.
struct Geometry {
  SarWaveform waveform;
  double speed_mps = 100.0;
  double closest_m = 0.0;
  double half_flight_m = 0.0;
  double near_m = 0.0;
  double far_m = 0.0;

  [[nodiscard]] double widest_sine() const { return half_flight_m / std::hypot(half_flight_m, closest_m); }
};

SarEchoes echoes_of(const Geometry& geometry) {
  const SarWaveform& wave = geometry.waveform;
  // 1.4 times what tells the Doppler frequencies at the upper end of the band.
  const double highest_hz = wave.carrier_hz + 0.5 * wave.bandwidth_hz;
  const double prf_hz = 1.4 * 4.0 * geometry.speed_mps * geometry.widest_sine() * highest_hz / wave.light_speed_mps;
  const auto half = static_cast<std::ptrdiff_t>(geometry.half_flight_m / geometry.speed_mps * prf_hz);
  SarEchoes echoes;
  echoes.waveform = wave;
  echoes.first_delay_s = 2.0 * geometry.near_m / wave.light_speed_mps;
  echoes.samples =
      static_cast<std::size_t>(2.0 * (geometry.far_m - geometry.near_m) / wave.light_speed_mps * wave.sample_rate_hz);
  for (std::ptrdiff_t p = -half; p <= half; ++p) {
    const double time_s = static_cast<double>(p) / prf_hz;
    echoes.track.push_back({time_s, {0.0, geometry.speed_mps * time_s, 0.0}, {0.0, geometry.speed_mps, 0.0}});
  }
  echoes.volts.resize(echoes.track.size() * echoes.samples);
  for (std::size_t p = 0; p < echoes.track.size(); ++p)
    add_echo(echoes.volts.data() + p * echoes.samples, echoes, echoes.track[p],
             {{geometry.closest_m, 0.0, 0.0}, 1.0, {}});
  return echoes;
}

std::vector<SeenDirection> directions_of(const SarEchoes& echoes, const Geometry& geometry) {
  std::vector<SeenDirection> seen;
  for (const TrackPoint& antenna : echoes.track)
    seen.push_back({-antenna.position_m.y / std::hypot(antenna.position_m.y, geometry.closest_m), 1.0});
  return seen;
}

// The image at the point, which is to be 1 with the phase of its distance taken away.
std::complex<double> peak_of(const SarEchoes& echoes, const Geometry& geometry, FocusOptions options) {
  options.spectrum = spectrum_of(directions_of(echoes, geometry), echoes.waveform, 0.003);
  const FocusedImage image = focus(echoes, options, {.threads = 2});
  const double turns = 2.0 * geometry.closest_m * echoes.waveform.carrier_hz / echoes.waveform.light_speed_mps;
  return test::value_at(image, {0.0, geometry.closest_m}) * std::polar(1.0, 2.0 * core::pi * turns);
}

double decibels(double amplitude) { return 20.0 * std::log10(amplitude); }

// What is promised. Of it 0.06 dB are the 0.3 % of echoes that the image's spectrum leaves out at each end.
constexpr double max_db = 0.1;
constexpr double max_rad = 0.02;

// 300 MHz at 500 m, 150 MHz wide, and a flight of several hundred metres.
Geometry low_band(double half_flight_m, double near_m, double far_m) {
  return {.waveform = {300e6, 150e6, 1e-6, 300e6, 299792458.0},
          .closest_m = 500.0,
          .half_flight_m = half_flight_m,
          .near_m = near_m,
          .far_m = far_m};
}

TEST(FocusingAmplitude, DoesNotDependOnTheNearEdgeOfTheWindowNorOnTheTime) {
  for (const auto& [half_flight_m, near_m, far_m] :
       {std::array{300.0, 490.0, 650.0}, std::array{300.0, 480.0, 1000.0}, std::array{300.0, 300.0, 1000.0},
        std::array{300.0, 1.0, 1000.0}, std::array{100.0, 300.0, 1000.0}, std::array{450.0, 300.0, 1000.0}}) {
    const Geometry geometry = low_band(half_flight_m, near_m, far_m);
    const SarEchoes echoes = echoes_of(geometry);
    const std::complex<double> peak = peak_of(echoes, geometry, {});
    EXPECT_NEAR(decibels(std::abs(peak)), 0.0, max_db) << half_flight_m << " " << near_m << " " << far_m;
    EXPECT_NEAR(std::arg(peak), 0.0, max_rad) << half_flight_m << " " << near_m << " " << far_m;
    const auto middle_m = 0.5 * (near_m + far_m);
    for (const FocusMethod method : {FocusMethod::range_doppler, FocusMethod::chirp_scaling}) {
      // In the middle of the swath they leave nothing.
      Geometry there = low_band(half_flight_m, near_m, far_m);
      there.closest_m = std::round(middle_m);
      there.far_m = 2.0 * there.closest_m - near_m;
      if (std::hypot(half_flight_m, there.closest_m) > there.far_m - 20.0) continue;
      const SarEchoes seen = echoes_of(there);
      EXPECT_NEAR(decibels(std::abs(peak_of(seen, there, {.method = method}))), 0.0, max_db)
          << half_flight_m << " " << near_m << " " << far_m;
    }
  }
}

// 50 to 150 MHz over 60 degrees: a Doppler frequency is that of other directions at other frequencies.
TEST(FocusingAmplitude, IsRightOverABandAsWideAsItsCarrier) {
  Geometry geometry{.waveform = {100e6, 100e6, 1e-6, 200e6, 299792458.0},
                    .closest_m = 500.0,
                    .half_flight_m = 500.0 * std::tan(core::pi / 6.0),
                    .near_m = 400.0,
                    .far_m = 800.0};
  for (const double near_m : {30.0, 400.0, 490.0}) {
    geometry.near_m = near_m;
    const std::complex<double> peak = peak_of(echoes_of(geometry), geometry, {});
    EXPECT_NEAR(decibels(std::abs(peak)), 0.0, max_db) << near_m;
    EXPECT_NEAR(std::arg(peak), 0.0, max_rad) << near_m;
  }
}

// Carriers of 30 MHz to 10 GHz, bands of 0.1 to 100 % of it, apertures of 2 to 90 degrees, windows from 1 cell to 0.95
// of the distance.
Geometry random_geometry(std::mt19937_64& random) {
  std::uniform_real_distribution<double> even(0.0, 1.0);
  const auto between = [&](double low, double high) { return low * std::pow(high / low, even(random)); };
  for (;;) {
    Geometry geometry;
    const double carrier_hz = between(30e6, 10e9);
    const double band_hz = carrier_hz * between(1e-3, 1.0);
    geometry.waveform = {carrier_hz, band_hz, 150.0 / band_hz, 2.0 * band_hz, 299792458.0};
    const double cell_m = 0.5 * 299792458.0 / band_hz;
    geometry.closest_m = cell_m * between(30.0, 120.0);
    geometry.half_flight_m = geometry.closest_m * std::tan(0.5 * between(2.0, 90.0) * core::pi / 180.0);
    const double farthest_m = std::hypot(geometry.half_flight_m, geometry.closest_m);
    geometry.near_m = std::min(between(cell_m, 0.95 * geometry.closest_m), geometry.closest_m - 12.0 * cell_m);
    geometry.far_m = farthest_m + 12.0 * cell_m + even(random) * (farthest_m - geometry.near_m);
    const double zones = geometry.half_flight_m * geometry.widest_sine() * carrier_hz / 299792458.0;
    if (zones > 8.0 && zones < 60.0) return geometry;
  }
}

TEST(FocusingAmplitude, OfRandomGeometriesIsThatOfTheEchoesOrWhatIsPredicted) {
  std::mt19937_64 random(11);
  for (int i = 0; i < 16; ++i) {
    const Geometry geometry = random_geometry(random);
    const SarEchoes echoes = echoes_of(geometry);
    const std::complex<double> peak = peak_of(echoes, geometry, {});
    const std::string words =
        std::to_string(geometry.waveform.carrier_hz) + " Hz, band " + std::to_string(geometry.waveform.bandwidth_hz) +
        ", closest " + std::to_string(geometry.closest_m) + ", flight " + std::to_string(geometry.half_flight_m) +
        ", near " + std::to_string(geometry.near_m) + ", far " + std::to_string(geometry.far_m);
    EXPECT_NEAR(decibels(std::abs(peak)), 0.0, max_db) << words;
    EXPECT_NEAR(std::arg(peak), 0.0, max_rad) << words;
    for (const FocusMethod method : {FocusMethod::range_doppler, FocusMethod::chirp_scaling}) {
      FocusOptions options{.method = method};
      options.spectrum = spectrum_of(directions_of(echoes, geometry), echoes.waveform, 0.003);
      const SwathLoss loss =
          PointLosses(rows_of(echoes), options).of(geometry.closest_m, directions_of(echoes, geometry));
      if (decibels(loss.amplitude) < -3.0) continue;  // What is left of the peak is no peak.
      const FocusedImage image = focus(echoes, options, {.threads = 2});
      const double turns = 2.0 * geometry.closest_m * geometry.waveform.carrier_hz / 299792458.0 -
                           image.azimuth.spectrum_centre_per_m * loss.shift.azimuth_m -
                           image.range.spectrum_centre_per_m * loss.shift.range_m;
      const std::complex<double> found =
          test::value_at(image, {loss.shift.azimuth_m, geometry.closest_m + loss.shift.range_m}) *
          std::polar(1.0, 2.0 * core::pi * turns);
      EXPECT_NEAR(decibels(std::abs(found)), decibels(loss.amplitude), 0.1 - 0.2 * decibels(loss.amplitude)) << words;
      EXPECT_NEAR(std::remainder(std::arg(found) - loss.phase_rad, 2.0 * core::pi), 0.0,
                  std::max(0.02, 0.2 * std::abs(loss.phase_rad)))
          << words;
    }
  }
}

}  // namespace focusing_amplitude_test
}  // namespace sarsim::signal
