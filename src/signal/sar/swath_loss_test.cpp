#include "signal/sar/swath_loss.hpp"
#include "signal/sar/back_projection.hpp"

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

// The recorded ranges end so many metres before and behind the echoes of a point in the middle of the swath.
SarEchoes tight_echoes(const Setting& setting, const core::Vec3& point, double spare_m) {
  SarEchoes echoes = make_echoes(setting, {{point, 1.0, {}}});
  double near_m = INFINITY, far_m = 0.0;
  for (const TrackPoint& antenna : echoes.track) {
    near_m = std::min(near_m, core::norm(point - antenna.position_m));
    far_m = std::max(far_m, core::norm(point - antenna.position_m));
  }
  const SarWaveform& wave = echoes.waveform;
  const double sample_m = 0.5 * wave.light_speed_mps / wave.sample_rate_hz;
  const double begin_m = 0.5 * wave.light_speed_mps * echoes.first_delay_s;
  const auto first = static_cast<std::size_t>(std::max(0.0, std::floor((near_m - spare_m - begin_m) / sample_m)));
  const auto end = static_cast<std::size_t>(std::ceil((far_m + spare_m - begin_m) / sample_m));
  SarEchoes tight = echoes;
  tight.samples = std::min(end, echoes.samples) - first;
  tight.first_delay_s += static_cast<double>(first) / wave.sample_rate_hz;
  tight.volts.clear();
  for (std::size_t p = 0; p < echoes.track.size(); ++p) {
    const auto row = echoes.volts.begin() + static_cast<std::ptrdiff_t>(p * echoes.samples + first);
    tight.volts.insert(tight.volts.end(), row, row + static_cast<std::ptrdiff_t>(tight.samples));
  }
  return tight;
}

// Echoes that squint by 20 degrees with 600 MHz are gathered from 30 m to either side: a window that ends before costs
// range-Doppler the edges of the band, and chirp scaling, whose rows have room beyond the window, less.
// Back-projection, which takes each echo where it is, loses nothing.
TEST(SwathLoss, IsWhatFocusingLosesOfWindowsThatAreTight) {
  const Setting setting = wide_band(20.0);
  const core::Vec3 point = point_at(setting, 0.0, setting.closest_m());
  for (const double spare_m : {3.0, 8.0}) {
    const SarEchoes echoes = tight_echoes(setting, point, spare_m);
    std::vector<SeenDirection> seen;
    for (const TrackPoint& antenna : echoes.track) {
      const core::Vec3 sight = point - antenna.position_m;
      seen.push_back({sight.y / core::norm(sight), 1.0});
    }
    const PointGrid grid{point, {0.1, 0.0, 0.0}, {0.0, 0.1, 0.0}, 1, 1};
    const double by_projection = std::abs(test::reference_back_projection(echoes, grid).front());
    EXPECT_NEAR(by_projection, 1.0, 0.01);
    for (const FocusMethod method : {FocusMethod::range_doppler, FocusMethod::chirp_scaling}) {
      FocusOptions options{.method = method};
      options.doppler_centroid_hz = doppler_centroid_hz(setting.waveform, setting.speed_mps, setting.squint_rad);
      const SwathLoss loss = PointLosses(rows_of(echoes), options).of(setting.closest_m(), seen);
      const FocusedImage image = focus(echoes, options, {.threads = 2});
      ImagePlace place = place_of(image.frame, point);
      place.azimuth_m += loss.shift.azimuth_m;
      place.range_m += loss.shift.range_m;
      const double lost_db = -20.0 * std::log10(std::abs(test::value_at(image, place)) / by_projection);
      if (method == FocusMethod::range_doppler) {
        EXPECT_GT(lost_db, 0.5) << spare_m;
      }
      EXPECT_NEAR(-20.0 * std::log10(loss.amplitude), lost_db, 0.4) << spare_m << " " << static_cast<int>(method);
    }
  }
}

}  // namespace swath_loss_test
}  // namespace sarsim::signal
