#include "signal/sar/swath_loss.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/maths/constants.hpp"
#include "signal/sar/image_test_value.hpp"
#include "signal/sar/sar_test_scene.hpp"

namespace sarsim::signal {
namespace swath_loss_test {

using namespace sar_test;

// 600 MHz at X band from 8 km, 20 degrees ahead.
Setting wide_band(double squint_deg) {
  Setting setting;
  setting.speed_mps = 100.0;
  setting.height_m = 3000.0;
  setting.ground_m = 7400.0;
  setting.prf_hz = 900.0;
  setting.squint_rad = squint_deg * core::pi / 180.0;
  setting.pulses = 1200;
  setting.swath_m = 420.0;
  setting.waveform = {9.6e9, 600e6, 2e-6, 1200e6, 299792458.0};
  return setting;
}

struct Found {
  SwathLoss loss;
  std::complex<double> value;  // at the place of the peak that the loss predicts, carried to the true one
};

Found found_at(double squint_deg, FocusMethod method, double from_middle_m) {
  const Setting setting = wide_band(squint_deg);
  const core::Vec3 point = point_at(setting, 0.0, setting.closest_m() + from_middle_m);
  const SarEchoes echoes = make_echoes(setting, {{point, 1.0, {}}});
  FocusOptions options{.method = method};
  options.doppler_centroid_hz = doppler_centroid_hz(setting.waveform, setting.speed_mps, setting.squint_rad);
  std::vector<SeenDirection> seen;
  for (const TrackPoint& antenna : echoes.track) {
    const core::Vec3 sight = point - antenna.position_m;
    seen.push_back({sight.y / core::norm(sight), 1.0});
  }
  Found found{PointLosses(rows_of(echoes), options).of(setting.closest_m() + from_middle_m, seen), {}};
  const FocusedImage image = focus(echoes, options, {.threads = 2});
  ImagePlace place = place_of(image.frame, point);
  const double turns = 2.0 * place.range_m / setting.wavelength_m();
  place.azimuth_m += found.loss.shift.azimuth_m;
  place.range_m += found.loss.shift.range_m;
  const double carried = image.azimuth.spectrum_centre_per_m * found.loss.shift.azimuth_m +
                         image.range.spectrum_centre_per_m * found.loss.shift.range_m;
  found.value = test::value_at(image, place) * std::polar(1.0, 2.0 * core::pi * (turns - carried));
  return found;
}

// 0.4 dB 37 m off the middle, 1.6 dB at 71 m, 5.9 dB at 141 m; 0.3 dB at 148 m under 10 degrees.
TEST(SwathLoss, IsWhatFocusingLosesOffTheMiddleOfTheSwath) {
  for (const FocusMethod method : {FocusMethod::range_doppler, FocusMethod::chirp_scaling})
    for (const auto& [squint_deg, from_middle_m] : {std::pair(20.0, 0.0), std::pair(20.0, 37.0), std::pair(20.0, -71.0),
                                                    std::pair(20.0, 141.0), std::pair(10.0, 148.0)}) {
      const Found found = found_at(squint_deg, method, from_middle_m);
      EXPECT_NEAR(found.loss.from_middle_m, from_middle_m, 0.1);
      EXPECT_NEAR(20.0 * std::log10(found.loss.amplitude), 20.0 * std::log10(std::abs(found.value)), 0.05);
      EXPECT_NEAR(found.loss.phase_rad, std::arg(found.value), 0.01);
    }
}

}  // namespace swath_loss_test
}  // namespace sarsim::signal
