#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <fstream>
#include <ostream>

#include "core/maths/constants.hpp"
#include "scene/script/writer.hpp"
#include "signal/sar/image_test_value.hpp"
#include "support/test_folder.hpp"
#include "workflow/focus/focus.hpp"
#include "workflow/focus/measure.hpp"
#include "workflow/focus/sar_test_scene.hpp"

namespace sarsim::workflow {
namespace spaceborne_test {

constexpr double orbit_radius_m = 6371e3 + 700e3;
constexpr double speed_mps = 7508.07;
constexpr double carrier_hz = 9.65e9;

// A circle about the middle of the Earth, which lies 6371 km below the scene.
core::Vec3 orbit_m(double time_s) {
  const double angle = speed_mps / orbit_radius_m * time_s;
  return {orbit_radius_m * std::sin(angle), 0.0, orbit_radius_m * std::cos(angle) - 6371e3};
}

const std::array<core::Vec3, 3> points_m{core::Vec3{0, 400e3, 0}, core::Vec3{90, 400.15e3, 0},
                                         core::Vec3{-110, 399.8e3, 0}};

// X band from 806 km: 100 MHz, pulses of 20 us, 0.2 s and 1.5 km of flight, which turn the antenna's way by 38 mm.
scene::Scene spaceborne_scene() {
  scene::Scene scene = sar_scene(3000.0, {points_m.begin(), points_m.end()}, 0.1);
  scene.platforms[1] = simulate::moving("Plane", {}, {});
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::vector<core::Knot> knots;
    for (int i = -4; i <= 4; ++i) {
      const core::Vec3 place = orbit_m(i);
      knots.push_back({static_cast<double>(i), axis == 0 ? place.x : axis == 1 ? place.y : place.z});
    }
    scene.platforms[1].trajectory_m.part[axis] = {core::Interpolation::cubic, knots};
  }
  scene.options.cubic_ends = core::CubicEnds::not_a_knot;
  for (scene::Target& target : scene.targets) target.rcs_m2 = 1e4;
  scene.radars[0].carrier_hz = carrier_hz;
  scene.radars[0].pulse_width_s = 20e-6;
  scene.simulations[0].range_start_m = 806.1e3;
  scene.simulations[0].range_end_m = 806.37e3;
  return scene;
}

// The mean of the radar equation over the pulses, with the ways out and home of light, by steps of the equations.
double mean_amplitude(const core::Vec3& point) {
  const double c = core::exact_light_speed_mps;
  double sum = 0.0;
  int pulses = 0;
  for (int n = -300; n < 300; ++n, ++pulses) {
    const double sent_s = n / 3000.0;
    const double out_m = core::norm(point - orbit_m(sent_s));
    double home_m = out_m;
    for (int i = 0; i < 4; ++i) home_m = core::norm(point - orbit_m(sent_s + (out_m + home_m) / c));
    sum += std::sqrt(1000.0 * 1e4) * c / carrier_hz / (std::pow(4.0 * core::pi, 1.5) * out_m * home_m);
  }
  return sum / pulses;
}

class Spaceborne : public testing::TestWithParam<FocusAlgorithm> {};

INSTANTIATE_TEST_SUITE_P(Methods, Spaceborne,
                         testing::Values(FocusAlgorithm::automatic, FocusAlgorithm::omega_k,
                                         FocusAlgorithm::back_projection));

// Recorded, focused and measured: each point has the phase -4 pi R/lambda of its closest distance, which the light time
// of a radar at rest misses by 0.2 rad, and the amplitude of its echoes.
TEST_P(Spaceborne, PointsHavePlacePhaseAndAmplitude) {
  const test::TestFolder folder;
  std::ofstream(folder / "orbit.scr") << scene::write_script(spaceborne_scene());
  FocusRequest request;
  request.input.path = (folder / "orbit.scr").string();
  request.output = folder / "orbit.img";
  request.algorithm = GetParam();
  request.azimuth_area = signal::AxisInterval{-160.0, 160.0};
  request.threads = 2;
  const FocusReport report = focus(request, {});
  const signal::FocusedImage image = signal::in_memory(report.image);
  for (const core::Vec3& point : points_m) {
    const signal::ImagePlace place = signal::place_of(image.frame, point);
    const std::complex<double> value = signal::test::value_at(image, place);
    EXPECT_NEAR(20.0 * std::log10(std::abs(value) / mean_amplitude(point)), 0.0, 0.1);
    const double turns = 2.0 * place.range_m * carrier_hz / core::exact_light_speed_mps;
    EXPECT_NEAR(std::remainder(std::arg(value) + 2.0 * core::pi * turns, 2.0 * core::pi), 0.0, 0.01);
  }
  MeasureRequest measured;
  measured.image = request.output;
  measured.threads = 2;
  for (const MeasuredTarget& target : measure(measured, {}).targets) {
    ASSERT_TRUE(target.found);
    EXPECT_NEAR(target.amplitude_error_db(), 0.0, 0.1);
    EXPECT_NEAR(target.phase_error_rad(), 0.0, 0.01);
    EXPECT_NEAR(target.found->place.azimuth_m, target.theory.place.azimuth_m, 0.05);
    EXPECT_NEAR(target.found->place.range_m, target.theory.place.range_m, 0.01);
  }
}

// While an echo is under way the antenna flies on by 38 m, under a squint 1.4 m towards the point: half of it in range.
TEST(SpaceborneSquint, EveryMethodHasTheFlightBetweenSendingAndReceiving) {
  const test::TestFolder folder;
  scene::Scene scene = sar_scene(2000.0, {{29.5e3, 398e3, 0.0}}, 0.25);
  scene.platforms[1] = simulate::moving("Plane", {0.0, 0.0, 700e3}, {7000.0, 0.0, 0.0});
  scene.targets[0].rcs_m2 = 1e4;
  scene.radars[0].carrier_hz = 1.25e9;
  scene.radars[0].bandwidth_hz = 85e6;
  scene.radars[0].pulse_width_s = 20e-6;
  scene.simulations[0].sample_rate_hz = 110e6;
  scene.simulations[0].range_start_m = 805.3e3;
  scene.simulations[0].range_end_m = 806.5e3;
  std::ofstream(folder / "orbit.scr") << scene::write_script(scene);
  for (const FocusAlgorithm method : {FocusAlgorithm::range_doppler, FocusAlgorithm::chirp_scaling,
                                      FocusAlgorithm::omega_k, FocusAlgorithm::back_projection}) {
    FocusRequest request;
    request.input.path = (folder / "orbit.scr").string();
    request.output = folder / "orbit.img";
    request.force = true;
    request.algorithm = method;
    request.threads = 2;
    static_cast<void>(focus(request, {}));
    MeasureRequest question;
    question.image = request.output;
    const MeasuredTarget found = measure(question, {}).targets.at(0);
    ASSERT_TRUE(found.found);
    EXPECT_NEAR(found.found->place.range_m, found.theory.place.range_m, 0.02) << static_cast<int>(method);
    EXPECT_NEAR(found.amplitude_error_db(), 0.0, 0.1) << static_cast<int>(method);
  }
}

}  // namespace spaceborne_test
}  // namespace sarsim::workflow
