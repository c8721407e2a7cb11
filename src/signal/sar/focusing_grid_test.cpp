#include <gtest/gtest.h>

#include <cmath>
#include <ostream>

#include "core/maths/constants.hpp"
#include "signal/measure/image_quality.hpp"
#include "signal/sar/focusing.hpp"
#include "signal/sar/image_test_value.hpp"
#include "signal/sar/sar_test_scene.hpp"

namespace sarsim::signal {
namespace focusing_grid_test {

using namespace sar_test;
using test::value_at;

// An aircraft at 3 km from its scene at X band, with pulses whose spectra have hardly any flanks.
struct GridCase {
  const char* name;
  double squint_deg;
  double aperture_m;
  double bandwidth_hz;
  double sample_rate_hz;
  FocusMethod method = FocusMethod::omega_k;
  double prf_hz = 1400.0;
};

void PrintTo(const GridCase& one, std::ostream* out) { *out << one.name; }

Setting setting_of(const GridCase& grid) {
  Setting setting;
  setting.speed_mps = 100.0;
  setting.height_m = 1000.0;
  setting.ground_m = std::sqrt(3000.0 * 3000.0 - 1e6);
  setting.prf_hz = grid.prf_hz;
  setting.squint_rad = grid.squint_deg * core::pi / 180.0;
  setting.pulses = static_cast<std::size_t>(grid.aperture_m / setting.speed_mps * setting.prf_hz);
  setting.swath_m = 260.0;
  setting.waveform = {9.6e9, grid.bandwidth_hz, 500.0 / grid.bandwidth_hz, grid.sample_rate_hz, 299792458.0};
  return setting;
}

std::vector<SeenDirection> directions(const SarEchoes& echoes, const core::Vec3& point) {
  std::vector<SeenDirection> seen;
  for (const TrackPoint& antenna : echoes.track) {
    const core::Vec3 sight = point - antenna.position_m;
    seen.push_back({sight.y / core::norm(sight), 1.0});
  }
  return seen;
}

FocusOptions options_of(const GridCase& grid, const Setting& setting, const SarEchoes& echoes,
                        const core::Vec3& point) {
  FocusOptions options{.method = grid.method};
  options.doppler_centroid_hz = doppler_centroid_hz(setting.waveform, setting.speed_mps, setting.squint_rad);
  options.spectrum = spectrum_of(directions(echoes, point), setting.waveform, 0.003);
  return options;
}

// What the mean of all echoes gives beside the point, by the definition of the image: the sum over pulses.
double ideal_response(const Setting& setting, const SarEchoes& echoes, const core::Vec3& point, double azimuth_m,
                      double range_m) {
  const double closest_m = std::hypot(point.x, setting.height_m);
  const core::Vec3 beside = point_at(setting, point.y + azimuth_m, closest_m + range_m);
  std::complex<double> sum;
  for (const TrackPoint& antenna : echoes.track) {
    const double delay_s = 2.0 / setting.waveform.light_speed_mps *
                           (core::norm(beside - antenna.position_m) - core::norm(point - antenna.position_m));
    sum += compressed_chirp(delay_s, setting.waveform) *
           std::polar(1.0, 2.0 * core::pi * setting.waveform.carrier_hz * delay_s);
  }
  return std::abs(sum) / static_cast<double>(echoes.track.size());
}

// Between the points at -3 dB along a direction.
double ideal_width_m(const Setting& setting, const SarEchoes& echoes, const core::Vec3& point, double azimuth,
                     double range) {
  const auto crossing = [&](double sign) {
    double inside = 0.0;
    double outside = 0.02;
    const auto value = [&](double at) {
      return ideal_response(setting, echoes, point, sign * at * azimuth, sign * at * range);
    };
    while (value(outside) > std::sqrt(0.5)) inside = outside, outside += 0.02;
    for (int i = 0; i < 20; ++i) {
      const double middle = 0.5 * (inside + outside);
      (value(middle) > std::sqrt(0.5) ? inside : outside) = middle;
    }
    return inside;
  };
  return crossing(1.0) + crossing(-1.0);
}

class FocusingGrid : public testing::TestWithParam<GridCase> {};

INSTANTIATE_TEST_SUITE_P(
    Cases, FocusingGrid,
    testing::Values(GridCase{"Squint20Band100", 20.0, 190.0, 100e6, 150e6},
                    GridCase{"Squint20Band50", 20.0, 190.0, 50e6, 75e6},
                    GridCase{"Squint10Band50", 10.0, 190.0, 50e6, 75e6},
                    GridCase{"Broadside500Band50", 0.0, 500.0, 50e6, 75e6},
                    GridCase{"Broadside500Band30", 0.0, 500.0, 30e6, 45e6},
                    GridCase{"RangeDoppler", 20.0, 190.0, 100e6, 150e6, FocusMethod::range_doppler},
                    GridCase{"RangeDopplerBroadside", 0.0, 500.0, 30e6, 45e6, FocusMethod::range_doppler},
                    GridCase{"ChirpScaling", 20.0, 190.0, 100e6, 150e6, FocusMethod::chirp_scaling},
                    GridCase{"FewPulses", 20.0, 190.0, 600e6, 900e6, FocusMethod::omega_k, 420.0},
                    GridCase{"FewPulsesRangeDoppler", 20.0, 190.0, 600e6, 900e6, FocusMethod::range_doppler, 420.0}),
    [](const auto& instance) { return instance.param.name; });

// Range frequencies spread by f0 (cos a1 - cos a2) over the aperture: beyond the sampling rate in each of these cases
// but for those of few pulses. There Doppler frequencies of 474 Hz, 137 of them from the pulse's band, meet 420 pulses
// a second.
TEST_P(FocusingGrid, HoldsTheSpectrumThatSquintAndApertureSpread) {
  const Setting setting = setting_of(GetParam());
  const core::Vec3 point = point_at(setting, 0.0, setting.closest_m());
  const SarEchoes echoes = make_echoes(setting, {{point, 1.0, {}}});
  const FocusOptions options = options_of(GetParam(), setting, echoes, point);
  const FocusedImage image = focus(echoes, options, {.threads = 2});
  const double coarse_m = setting.waveform.light_speed_mps / (2.0 * setting.waveform.sample_rate_hz);
  EXPECT_TRUE(image.range.step_m < 0.999 * coarse_m ||
              image.azimuth.step_m < 0.999 * setting.speed_mps / setting.prf_hz);
  const std::complex<double> value = value_at(image, place_of(image.frame, point));
  EXPECT_NEAR(20.0 * std::log10(std::abs(value)), 0.0, 0.1);
  const double phase = -4.0 * core::pi * setting.closest_m() * setting.waveform.carrier_hz / 299792458.0;
  EXPECT_NEAR(std::remainder(std::arg(value) - phase, 2.0 * core::pi), 0.0, 0.01);
  const auto found = measure_point(image, reader_of(image), place_of(image.frame, point), 1.0);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->place.range_m, setting.closest_m(), 0.01);
  const double sine = std::sin(setting.squint_rad);
  const double cosine = std::cos(setting.squint_rad);
  const double azimuth_m = ideal_width_m(setting, echoes, point, cosine, -sine);
  const double range_m = ideal_width_m(setting, echoes, point, sine, cosine);
  EXPECT_NEAR(found->azimuth.width / azimuth_m, 1.0, 0.01);
  EXPECT_NEAR(found->range.width / range_m, 1.0, 0.01);
}

}  // namespace focusing_grid_test
}  // namespace sarsim::signal
