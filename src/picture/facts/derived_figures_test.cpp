#include "picture/facts/derived_figures.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "scene/schema/fields.hpp"
#include "scene/script/random_scene_test_support.hpp"
#include "support/processor_time.hpp"

namespace sarsim::picture {

namespace derived_figures_test {

constexpr scene::ObjectKind all_kinds[] = {scene::ObjectKind::platform,   scene::ObjectKind::target,
                                           scene::ObjectKind::surface,    scene::ObjectKind::radar,
                                           scene::ObjectKind::simulation, scene::ObjectKind::geometry};

scene::Scene small_scene() {
  scene::Scene scene;
  scene.platforms.emplace_back();
  scene::Radar radar;
  radar.pulse_width_s = 1e-6;
  radar.noise_temperature_k = 100.0;
  scene.radars.push_back(radar);
  scene::Target target;
  target.position_m = {0.0, 1000.0, 0.0};
  scene.targets.push_back(target);
  scene::Simulation simulation;
  simulation.radar = "Radar1";
  simulation.range_end_m = 1500.0;
  simulation.sample_rate_hz = 2e6;
  scene.simulations.push_back(simulation);
  scene.geometries.push_back({.radar = "Radar1"});
  scene.surfaces.emplace_back();
  return scene;
}

std::string text_of(const std::vector<DerivedFigure>& figures, std::string_view label) {
  const auto found = std::ranges::find(figures, label, &DerivedFigure::label);
  return found == figures.end() ? "" : found->text;
}

std::string figure(const scene::Scene& scene, scene::ObjectKind kind, std::string_view label, double time_s = 0.0) {
  return text_of(derived_figures(scene, {kind, 0}, time_s), label);
}

TEST(DerivedFigures, OfARadarAreTheOnesOfItsEquations) {
  const scene::Scene scene = small_scene();  // 1 GHz, 1 kHz, 1 us, 1 kW, 100 K
  EXPECT_EQ(figure(scene, scene::ObjectKind::radar, "Wavelength"), "299.8 mm");
  EXPECT_EQ(figure(scene, scene::ObjectKind::radar, "Bandwidth"), "1 MHz");
  EXPECT_EQ(figure(scene, scene::ObjectKind::radar, "Range resolution"), "149.9 m");
  EXPECT_EQ(figure(scene, scene::ObjectKind::radar, "Unambiguous range"), "149.9 km");
  EXPECT_EQ(figure(scene, scene::ObjectKind::radar, "Unambiguous velocity"), "+/- 74.95 m/s");
  EXPECT_EQ(figure(scene, scene::ObjectKind::radar, "Duty cycle"), "0.1 %");
  EXPECT_EQ(figure(scene, scene::ObjectKind::radar, "Mean power"), "1 W");
  EXPECT_EQ(figure(scene, scene::ObjectKind::radar, "Synthetic range resolution"), "");
}

TEST(DerivedFigures, OfSteppedCarriersIncludeTheSyntheticResolution) {
  scene::Scene scene = small_scene();
  scene.radars[0].carrier = scene::Radar::Carrier::stepped;
  scene.radars[0].carrier_step_hz = 1e6;
  scene.radars[0].carrier_steps = 100;
  EXPECT_EQ(figure(scene, scene::ObjectKind::radar, "Synthetic range resolution"), "1.499 m");
  EXPECT_EQ(figure(scene, scene::ObjectKind::radar, "Wavelength"), "272.8 mm to 299.8 mm");
}

// The worked example of thesis 4.4: 4.53e-14 W against 1.38e-15 W, 15.2 dB.
TEST(DerivedFigures, OfATargetAgreeWithTheExampleOfTheThesis) {
  const scene::Scene scene = small_scene();
  EXPECT_EQ(figure(scene, scene::ObjectKind::target, "Range"), "1 km");
  EXPECT_EQ(figure(scene, scene::ObjectKind::target, "Delay"), "6.671 us");
  EXPECT_EQ(figure(scene, scene::ObjectKind::target, "Radial speed"), "0 m/s");
  EXPECT_EQ(figure(scene, scene::ObjectKind::target, "SNR").substr(0, 4), "15.1");
}

TEST(DerivedFigures, OfATargetAreThoseOfTheTime) {
  scene::Scene scene = small_scene();
  scene::Platform ship;
  ship.name = "Ship";
  ship.path = scene::Platform::Path::trajectory;
  ship.trajectory_m.part[0] = {core::Interpolation::linear, {{0.0, 0.0}}};
  ship.trajectory_m.part[1] = {core::Interpolation::linear, {{0.0, 0.0}, {1.0, 10.0}}};
  ship.trajectory_m.part[2] = {core::Interpolation::linear, {{0.0, 0.0}}};
  ship.position_error = scene::Platform::MotionError::gaussian;
  ship.position_stddev_m = {100.0, 100.0, 100.0};
  scene.platforms.push_back(ship);
  scene.targets[0].platform = "Ship";
  EXPECT_EQ(figure(scene, scene::ObjectKind::target, "Range", 20.0), "1.2 km");
  EXPECT_EQ(figure(scene, scene::ObjectKind::target, "Range", -20.0), "800 m");
  EXPECT_EQ(figure(scene, scene::ObjectKind::target, "Radial speed", 20.0), "10 m/s");
  EXPECT_EQ(text_of(derived_figures(scene, {scene::ObjectKind::platform, 1}, 20.0), "Speed"), "10 m/s");
  EXPECT_EQ(text_of(derived_figures(scene, {scene::ObjectKind::platform, 1}, 20.0), "Position"), "0 m, 200 m, 0 m");
  scene.radars[0].prf_hz = 0.001;  // the nearest pulse leaves long before and after
  EXPECT_EQ(figure(scene, scene::ObjectKind::target, "Range", 20.0), "1.2 km");
}

TEST(DerivedFigures, OfATargetNameTheRadarWhereThereAreSeveral) {
  scene::Scene scene = small_scene();
  scene.radars.push_back(scene.radars[0]);
  scene.radars[1].name = "Far";
  EXPECT_EQ(figure(scene, scene::ObjectKind::target, "Range (Far)"), "1 km");
  EXPECT_EQ(figure(scene, scene::ObjectKind::target, "Range"), "");
}

TEST(DerivedFigures, TheCarrierOfATargetsSnrIsThatOfThePulse) {
  scene::Scene scene = small_scene();
  scene::Radar& radar = scene.radars[0];
  radar.carrier = scene::Radar::Carrier::user;
  radar.carrier_list_hz.part[0].knots = {{0, 1e9}, {1, 10e9}};
  const std::string even = figure(scene, scene::ObjectKind::target, "SNR", 0.0104);
  const std::string odd = figure(scene, scene::ObjectKind::target, "SNR", 0.0114);
  EXPECT_NEAR(std::stod(even) - std::stod(odd), 20.0, 0.02);  // 10 times the wavelength
}

TEST(DerivedFigures, OfASimulationAreItsSizeAndSampling) {
  scene::Scene scene = small_scene();
  EXPECT_EQ(figure(scene, scene::ObjectKind::simulation, "Range samples"), "20");
  EXPECT_EQ(figure(scene, scene::ObjectKind::simulation, "Pulses"), "11 (0 to 10)");
  EXPECT_EQ(figure(scene, scene::ObjectKind::simulation, "Size"), "11 rows of 20 samples");
  EXPECT_EQ(figure(scene, scene::ObjectKind::simulation, "File"), "440 bytes");
  EXPECT_EQ(figure(scene, scene::ObjectKind::simulation, "Sampling ratio"), "2 x Nyquist");
  EXPECT_EQ(figure(scene, scene::ObjectKind::simulation, "Unambiguous range"), "149.9 km, the window lies within");
  EXPECT_EQ(figure(scene, scene::ObjectKind::geometry, "Pulses"), "101 (0 to 100)");
  scene.simulations[0].bits = 12;
  EXPECT_EQ(figure(scene, scene::ObjectKind::simulation, "File"), "880 bytes");
  scene.simulations[0].format = scene::FileFormat::ascii;
  EXPECT_TRUE(figure(scene, scene::ObjectKind::simulation, "File").starts_with("up to "));
  scene.simulations[0].range_end_m = 200e3;
  EXPECT_EQ(figure(scene, scene::ObjectKind::simulation, "Unambiguous range"), "149.9 km, the window reaches beyond");
}

TEST(DerivedFigures, OfASyntheticProfileCountBurstsAndBins) {
  scene::Scene scene = small_scene();
  scene.radars[0].carrier = scene::Radar::Carrier::stepped;
  scene.radars[0].carrier_steps = 4;
  scene.radars[0].pulses_per_step = 1;
  scene.simulations[0].processing = scene::Processing::srp;
  EXPECT_EQ(figure(scene, scene::ObjectKind::simulation, "Size"), "2 rows of 80 samples");
}

TEST(DerivedFigures, OfASurfaceAreItsAreaAndPoints) {
  const scene::Scene scene = small_scene();  // 20 m wide, 10 m high
  EXPECT_EQ(figure(scene, scene::ObjectKind::surface, "Area"), "100 m2");
  EXPECT_EQ(figure(scene, scene::ObjectKind::surface, "Scatterers"), "100");
}

TEST(DerivedFigures, AFaultyPartTakesOnlyWhatDependsOnItAway) {
  scene::Scene scene = small_scene();
  scene.radars[0].carrier_hz = -1.0;
  EXPECT_EQ(figure(scene, scene::ObjectKind::radar, "Wavelength"), "");
  EXPECT_EQ(figure(scene, scene::ObjectKind::radar, "Unambiguous velocity"), "");
  EXPECT_EQ(figure(scene, scene::ObjectKind::radar, "Range resolution"), "149.9 m");
  EXPECT_EQ(figure(scene, scene::ObjectKind::target, "Range"), "1 km");
  EXPECT_EQ(figure(scene, scene::ObjectKind::target, "SNR"), "");
  scene = small_scene();
  scene.radars[0].transmit_antenna.pattern = scene::Antenna::Pattern::user;  // without points
  EXPECT_EQ(figure(scene, scene::ObjectKind::radar, "Wavelength"), "299.8 mm");
  EXPECT_EQ(figure(scene, scene::ObjectKind::target, "SNR"), "");
  scene = small_scene();
  scene.targets[0].rcs_m2 = std::nan("");
  EXPECT_EQ(figure(scene, scene::ObjectKind::target, "Range"), "1 km");
  EXPECT_EQ(figure(scene, scene::ObjectKind::target, "SNR"), "");
}

TEST(DerivedFigures, FaultsElsewhereInTheSceneDoNotMatter) {
  scene::Scene scene = small_scene();
  scene.platforms.emplace_back();
  scene.platforms[1].name = "Broken";
  scene.platforms[1].position_m.x = std::nan("");
  scene.targets.emplace_back();
  scene.targets[1].platform = "Nowhere";
  EXPECT_EQ(figure(scene, scene::ObjectKind::target, "Range"), "1 km");
  EXPECT_TRUE(derived_figures(scene, {scene::ObjectKind::target, 1}, 0.0).empty());
  EXPECT_TRUE(derived_figures(scene, {scene::ObjectKind::platform, 1}, 0.0).empty());
}

TEST(DerivedFigures, OfNothingAreNone) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const scene::ObjectKind kind : all_kinds) {
    EXPECT_TRUE(derived_figures(scene::Scene{}, {kind, 0}, 0.0).empty());
    EXPECT_NO_THROW(static_cast<void>(derived_figures(small_scene(), {kind, 0}, nan)));
  }
}

// Any numbers in any member, names that mean nothing or something: nothing may be thrown and no figure may be nan.
TEST(DerivedFigures, AreComputedWithoutFailingForAnyScene) {
  scene::test::RandomScenes random(21);
  std::mt19937_64 engine(22);
  const double odd[] = {
      std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), -1.0, 0.0, 1e300, 1e-300};
  for (int round = 0; round < 300; ++round) {
    scene::Scene scene = random.scene();
    for (scene::Target& target : scene.targets) {
      if (!scene.platforms.empty()) target.platform = scene.platforms.front().name;
      if (engine() % 3 == 0) target.position_m.x = odd[engine() % std::size(odd)];
    }
    for (scene::Radar& radar : scene.radars) {
      radar.platform = "Earth";
      if (engine() % 3 == 0) radar.carrier_hz = odd[engine() % std::size(odd)];
      if (engine() % 3 == 0) radar.pulse_width_s = odd[engine() % std::size(odd)];
      if (engine() % 3 == 0) radar.prf_hz = odd[engine() % std::size(odd)];
    }
    for (scene::Simulation& simulation : scene.simulations) {
      if (!scene.radars.empty()) simulation.radar = scene.radars.front().name;
      if (engine() % 3 == 0) simulation.sample_rate_hz = odd[engine() % std::size(odd)];
      if (engine() % 3 == 0) simulation.bits = static_cast<int>(engine() % 100) - 10;
    }
    for (const scene::ObjectKind kind : all_kinds)
      for (std::size_t i = 0; i < scene::count_of(scene, kind); ++i)
        for (const double time_s : {0.0, 1.5, -1e12, 1e300, 1e-320}) {
          const auto figures = derived_figures(scene, {kind, i}, time_s);
          for (const DerivedFigure& f : figures) {
            EXPECT_EQ(f.text.find("nan"), std::string::npos) << f.label << ": " << f.text;
            EXPECT_EQ(f.text.find("inf"), std::string::npos) << f.label << ": " << f.text;
            EXPECT_FALSE(f.formula.empty()) << f.label;
          }
        }
  }
}

TEST(DerivedFigures, TakeMillisecondsWithTenThousandTargets) {
  scene::Scene scene = small_scene();
  scene.targets.resize(10000, scene.targets[0]);
  scene.surfaces[0].corner_m = {core::Vec3{0, 0, 0}, core::Vec3{4000, 0, 0}, core::Vec3{0, 4000, 0}};
  const sarsim::test::ProcessorTime time;
  constexpr int rounds = 20;
  for (int i = 0; i < rounds; ++i)
    for (const scene::ObjectKind kind : all_kinds) static_cast<void>(derived_figures(scene, {kind, 0}, 0.5));
  EXPECT_LT(time.seconds() / (rounds * std::size(all_kinds)), 0.02);  // some 0.1 ms
}

}  // namespace derived_figures_test

}  // namespace sarsim::picture
