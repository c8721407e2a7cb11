// From a scene to a focused point: what the simulator records, back-projection turns into its closed form.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "signal/measure/response_test_support.hpp"
#include "signal/sar/autofocus.hpp"
#include "signal/sar/back_projection.hpp"
#include "signal/sar/motion_compensation.hpp"
#include "signal/sar/sar_test_support.hpp"
#include "support/scenes.hpp"

namespace sarsim {
namespace scene_test {

using signal::test::CutFigures;

constexpr double prf_hz = 600.0;
constexpr double carrier_hz = 5.3e9;
constexpr double rate_hz = 180e6;
constexpr double speed_mps = 200.0;
const double range_m = std::hypot(10e3, 2e3);

// The aircraft of thesis chapter 7 on a line, or wavering about it, that looks ahead by `squint_rad` to the origin.
scene::Platform aircraft(double squint_rad, double wavering_m) {
  scene::Platform platform;
  platform.name = "Aircraft";
  platform.path = scene::Platform::Path::trajectory;
  const double start_m = -range_m * std::tan(squint_rad);
  for (core::SampledFunction& axis : platform.trajectory_m.part) axis.method = core::Interpolation::cubic;
  for (double t = -1.5; t <= 1.5001; t += 0.05) {
    platform.trajectory_m.part[0].knots.push_back({t, start_m + speed_mps * t + 0.3 * wavering_m * std::sin(3.0 * t)});
    platform.trajectory_m.part[1].knots.push_back({t, -10e3 + wavering_m * std::sin(4.0 * t)});
    platform.trajectory_m.part[2].knots.push_back({t, 2e3 + 0.5 * wavering_m * std::cos(5.0 * t)});
  }
  return platform;
}

struct Flight {
  double squint_rad = 0.0;
  double wavering_m = 0.0;
  double pulse_width_s = 1.6e-6;
};

// A point of 1 m2 at `point_m`, recorded for two seconds.
signal::SarEchoes recorded_echoes(const Flight& flight, const core::Vec3& point_m) {
  scene::Scene scene = test::radar_at_origin();
  scene.platforms.push_back(aircraft(flight.squint_rad, flight.wavering_m));
  scene::Radar& radar = scene.radars[0];
  radar.platform = "Aircraft";
  radar.pulse = scene::Radar::Pulse::chirp;
  radar.bandwidth_hz = 50e6;
  radar.pulse_width_s = flight.pulse_width_s;
  radar.prf_hz = prf_hz;
  radar.carrier_hz = carrier_hz;
  test::add_target(scene, point_m);
  const double middle_m = range_m / std::cos(flight.squint_rad);
  test::set_window(scene, middle_m - 400.0, middle_m + 400.0, rate_hz);
  test::set_pulses(scene, -600, 600);
  scene.simulations[0].processing = scene::Processing::matched_filter;
  const simulate::Recording recording = test::recorded(scene);

  signal::SarEchoes echoes;
  echoes.waveform = {carrier_hz, radar.bandwidth_hz, radar.pulse_width_s, rate_hz, core::exact_light_speed_mps};
  echoes.samples = recording.report.columns;
  echoes.first_delay_s = 2.0 * (middle_m - 400.0) / core::exact_light_speed_mps;
  // Every echo over the amplitude that the radar equation gives one from the middle.
  const double wavelength_m = core::exact_light_speed_mps / carrier_hz;
  const double amplitude = std::sqrt(1000.0) * wavelength_m / (std::pow(4.0 * core::pi, 1.5) * middle_m * middle_m);
  for (const auto& sample : recording.samples) echoes.volts.push_back(std::complex<float>(sample / amplitude));
  const auto& path = scene.platforms.back().trajectory_m.part;
  const core::Interpolator x(path[0]), y(path[1]), z(path[2]);
  for (int p = -600; p <= 600; ++p) {
    const double t = p / prf_hz;
    const core::Jet jx = x.jet(t), jy = y.jet(t), jz = z.jet(t);
    echoes.track.push_back({t, {jx.value, jy.value, jz.value}, {jx.slope, jy.slope, jz.slope}});
  }
  return echoes;
}

CutFigures cut(const signal::SarEchoes& echoes, const core::Vec3& point_m, const core::Vec3& direction, double null_m,
               std::complex<double>& peak) {
  const core::Vec3 step = null_m / 50.0 * direction;
  const auto values = signal::back_project(echoes, {point_m - 520.0 * step, {}, step, 1, 1041}, {}, {2, nullptr});
  peak = values[520];
  return signal::test::measure_cut({values.begin(), values.end()}, 50.0);
}

void expect_focused(const Flight& flight) {
  const core::Vec3 point_m{4.3, 7.1, 0.0};
  const signal::SarEchoes echoes = recorded_echoes(flight, point_m);
  const signal::ReferenceTrack line = signal::fitted_track(echoes.track);
  const core::Vec3 sight = point_m - line.position_m;
  const core::Vec3 range_axis = (1.0 / core::norm(sight)) * sight;
  core::Vec3 azimuth_axis = line.velocity_mps - core::dot(line.velocity_mps, range_axis) * range_axis;
  azimuth_axis = (1.0 / core::norm(azimuth_axis)) * azimuth_axis;
  std::complex<double> peak;

  const double range_null_m = 0.5 * core::exact_light_speed_mps / 50e6;
  const CutFigures range = cut(echoes, point_m, range_axis, range_null_m, peak);
  // The autocorrelation of a chirp of 80 cycles (Cook and Bernfeld 1967): -13.42 dB, 0.8844/B.
  EXPECT_NEAR(range.peak, 520.0, 1.0);
  EXPECT_NEAR(range.width, 0.8844 * 50.0, 0.01 * 44.2);
  EXPECT_NEAR(range.pslr_db, -13.42, 0.2);

  const double azimuth_null_m = core::exact_light_speed_mps / carrier_hz * core::norm(sight) /
                                (2.0 * 1201.0 / prf_hz * core::norm(line.velocity_mps) * std::cos(flight.squint_rad));
  const CutFigures azimuth = cut(echoes, point_m, azimuth_axis, azimuth_null_m, peak);
  EXPECT_NEAR(azimuth.peak, 520.0, 1.0);
  EXPECT_NEAR(azimuth.width, 0.8859 * 50.0, 0.01 * 44.3);
  EXPECT_NEAR(azimuth.pslr_db, -13.26, 0.2);
  EXPECT_NEAR(azimuth.islr_db, -10.11, 0.3);
  EXPECT_NEAR(std::arg(peak), 0.0, 0.01);
  EXPECT_NEAR(std::abs(peak), 1.0, 0.005);
  std::printf(
      "squint %.2f rad, wavering %.1f m: range %+.4f cells, %.4f/B, %.2f dB, %.2f dB; azimuth %+.4f, %.4f, %.2f, "
      "%.2f; peak %.5f, %+.5f rad\n",
      flight.squint_rad, flight.wavering_m, (range.peak - 520.0) / 50.0, range.width / 50.0, range.pslr_db,
      range.islr_db, (azimuth.peak - 520.0) / 50.0, azimuth.width / 50.0, azimuth.pslr_db, azimuth.islr_db,
      std::abs(peak), std::arg(peak));
}

TEST(SimulatedPoint, IsFocusedToItsClosedFormAtBroadside) { expect_focused({}); }

TEST(SimulatedPoint, IsFocusedToItsClosedFormUnderASquintOfTwentyDegrees) { expect_focused({20.0 * core::pi / 180.0}); }

TEST(SimulatedPoint, IsFocusedFromAWaveringTrackAsFromAStraightOne) { expect_focused({0.0, 1.0}); }

TEST(SimulatedPoint, IsRestoredByMotionCompensation) {
  const signal::SarEchoes ideal = recorded_echoes({}, {});
  const signal::SarEchoes wavering = recorded_echoes({0.0, 0.7}, {});
  signal::MotionCompensation how;
  how.reference = signal::fitted_track(ideal.track);
  const signal::SarEchoes compensated = signal::compensate_motion(wavering, how, {2, nullptr});
  std::complex<double> peak, want_peak;
  const double null_m = 0.72;
  const CutFigures want = cut(ideal, {}, {1.0, 0.0, 0.0}, null_m, want_peak);
  // On a grid of the reference track alone: back-projection as a plain azimuth compression.
  const CutFigures got = cut(compensated, {}, {1.0, 0.0, 0.0}, null_m, peak);
  EXPECT_NEAR(got.peak, want.peak, 1.0);
  EXPECT_NEAR(got.width, want.width, 0.01 * want.width);
  EXPECT_NEAR(got.pslr_db, want.pslr_db, 0.2);
  EXPECT_NEAR(got.height, want.height, 0.01);
  EXPECT_NEAR(std::arg(peak), 0.0, 0.02);
  signal::SarEchoes untold = wavering;
  untold.track = ideal.track;
  EXPECT_LT(cut(untold, {}, {1.0, 0.0, 0.0}, null_m, peak).height, 0.5);
}

// The track is believed straight; what it really was shows in the phases of the image.
TEST(SimulatedPoint, IsSharpenedByAutofocus) {
  const signal::SarEchoes ideal = recorded_echoes({}, {});
  signal::SarEchoes wavering = recorded_echoes({0.0, 0.01}, {});
  wavering.track = ideal.track;
  signal::ImageFrame frame;
  frame.origin_m = {0.0, -10e3, 2e3};
  frame.across = (1.0 / range_m) * core::Vec3{0.0, 10e3, -2e3};
  const signal::ImageAxis azimuth{-60.0, 0.5, 241}, range{range_m - 6.0, 1.5, 9};
  const signal::FocusedImage sharp = signal::back_project(ideal, frame, azimuth, range, {}, {2, nullptr});
  const signal::FocusedImage blurred = signal::back_project(wavering, frame, azimuth, range, {}, {2, nullptr});
  // A point alone: nothing else disturbs a wide window.
  signal::AutofocusOptions options;
  options.min_window = 31;
  const signal::AutofocusResult result = signal::autofocus(blurred, options, {2, nullptr});
  std::printf("entropy %.4f sharp, %.4f blurred, %.4f corrected\n", signal::image_entropy(sharp),
              signal::image_entropy(blurred), signal::image_entropy(result.image));
  EXPECT_GT(signal::image_entropy(blurred), 1.1 * signal::image_entropy(sharp));
  EXPECT_NEAR(signal::image_entropy(result.image), signal::image_entropy(sharp), 0.02 * signal::image_entropy(sharp));
}

}  // namespace scene_test
}  // namespace sarsim
