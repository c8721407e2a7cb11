#include "simulate/plan/pulse_geometry.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>

#include "simulate/plan/simulate_test_scene.hpp"
#include "simulate/resolve/impossible_echo.hpp"

namespace sarsim::simulate {
namespace pulse_geometry_test {

constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr double c = core::exact_light_speed_mps;

// A scene together with the geometry of its first radar.
class Sky {
 public:
  explicit Sky(const scene::Scene& scene)
      : scene_(std::make_unique<ResolvedScene>(resolve(scene))),
        radar_(std::make_unique<Link>(resolve_radar(scene, *scene_, 0))),
        geometry_(*scene_, *radar_) {}

  ScattererView view(std::int64_t pulse, std::size_t target = 0) {
    geometry_.set_pulse(pulse);
    return geometry_.view(target);
  }
  PulseGeometry& geometry() { return geometry_; }

 private:
  std::unique_ptr<ResolvedScene> scene_;
  std::unique_ptr<Link> radar_;
  PulseGeometry geometry_;
};

// Where a point of a platform is, by its track.
core::Vec3 place_of(const ResolvedPlatform& platform, const core::Vec3& point_m, double time_s) {
  return radar::world_position_m(platform.track.at(time_s, 0), point_m);
}

// Two-way delay of what leaves at `sent_s`, by iteration of the light-time equation on the tracks themselves.
double iterated_delay(const ResolvedScene& scene, const Link& radar, double sent_s) {
  const Scatterer& target = scene.scatterers.front();
  const core::Vec3 from_m = place_of(scene.platforms[radar.platform], {}, sent_s);
  double out_s = 0.0;
  double delay_s = 0.0;
  core::Vec3 met_m;
  for (int round = 0; round < 8; ++round) {
    met_m = place_of(scene.platforms[target.platform], target.position_m, sent_s + out_s);
    out_s = core::norm(met_m - from_m) / c;
  }
  for (int round = 0; round < 8; ++round)
    delay_s = out_s + core::norm(place_of(scene.platforms[radar.platform], {}, sent_s + delay_s) - met_m) / c;
  return delay_s;
}

// Delay, stretch and bend against the light-time equation. Arms of 100 m at up to 2 rad/s and curves of seconds have
// third derivatives below 1e4 m/s^3; distances up to 1e4 m are rounded.
void expect_flight_solves_the_light_time_equation(scene::Scene scene) {
  constexpr double h = 1e-4;
  scene.radars[0].prf_hz = 1.0 / h;
  scene.options.tolerance = 1e-12;  // so that bends count
  const ResolvedScene resolved = resolve(scene);
  const Link radar = resolve_radar(scene, resolved, 0);
  Sky sky(scene);
  for (const std::int64_t pulse : {-7000, -1234, 5, 3210, 9000}) {
    const ScattererView now = sky.view(pulse);
    const double t = sky.geometry().send_time_s();
    const auto delay = [&](double later_s) { return iterated_delay(resolved, radar, t + later_s); };
    EXPECT_NEAR(now.delay_s, delay(0.0), now.delay_s * 8.0 * epsilon);
    const double slope = (delay(h) - delay(-h)) / (2.0 * h);
    EXPECT_NEAR(now.clock.doppler, slope / (1.0 + slope), (h * h / 6.0 * 2e4 + 8.0 * 1e4 * epsilon / h) / c);
    EXPECT_NEAR(now.speed_mps, c * slope / (2.0 + slope), h * h / 6.0 * 1e4 + 8.0 * 1e4 * epsilon / h);
    constexpr double wide = 2e-3;
    const double bend = (delay(wide) - 2.0 * delay(0.0) + delay(-wide)) / (wide * wide);
    EXPECT_NEAR(now.clock.dilation_rate, bend, 1e-4 * std::abs(bend) + (1e-2 + 8e4 * epsilon / (wide * wide)) / c);
  }
}

// A winding path, knots 1 s apart, splines.
scene::Platform winding(std::string name) {
  scene::Platform platform = moving(std::move(name), {}, {});
  const auto spline = [](std::vector<double> y) {
    core::SampledFunction f{core::Interpolation::cubic, {}};
    for (std::size_t i = 0; i < y.size(); ++i) f.knots.push_back({static_cast<double>(i) - 1.5, y[i]});
    return f;
  };
  platform.trajectory_m.part = {spline({0, 60, 90, 180}), spline({2000, 2050, 2030, 2100}), spline({50, 80, 90, 60})};
  return platform;
}

TEST(PulseGeometry, FlightSolvesTheLightTimeEquationToAMovingTarget) {
  scene::Scene scene = one_target_scene();
  scene.platforms.push_back(winding("Plane"));
  scene.targets[0].platform = "Plane";
  expect_flight_solves_the_light_time_equation(scene);
}

TEST(PulseGeometry, FlightSolvesTheLightTimeEquationFromAMovingRadar) {
  scene::Scene scene = one_target_scene();
  scene.platforms.push_back(winding("Plane"));
  scene.radars[0].platform = "Plane";
  expect_flight_solves_the_light_time_equation(scene);
}

TEST(PulseGeometry, FlightSolvesTheLightTimeEquationToAPointOfARotatingPlatform) {
  scene::Scene scene = one_target_scene();
  scene::Platform drum = resting("Drum", {500, -400, 30});
  drum.rotation = {core::Angle::from_deg(10), core::Angle::from_deg(-20), core::Angle::from_deg(70)};
  drum.rotation_rate = {core::Angle::from_deg(30), core::Angle::from_deg(-45), core::Angle::from_deg(90)};
  scene.platforms.push_back(drum);
  scene.targets[0] = target_on("Drum", {60, -50, 20});
  expect_flight_solves_the_light_time_equation(scene);
}

TEST(PulseGeometry, FlightSolvesTheLightTimeEquationUnderUserRotation) {
  scene::Scene scene = one_target_scene();
  scene::Platform drum = resting("Drum", {500, -400, 30});
  drum.rotation_kind = scene::Platform::Rotation::user;
  for (auto& part : drum.rotation_deg.part)
    part = {core::Interpolation::cubic, {{-1.5, 5}, {-0.4, -20}, {0.3, 40}, {1.5, 10}}};
  scene.platforms.push_back(drum);
  scene.targets[0] = target_on("Drum", {60, -50, 20});
  expect_flight_solves_the_light_time_equation(scene);
}

TEST(PulseGeometry, FlightSolvesTheLightTimeEquationToAPointOfAnAlignedPlatform) {
  scene::Scene scene = one_target_scene();
  scene::Platform ship = winding("Ship");
  ship.aligned = true;
  scene.platforms.push_back(ship);
  scene.targets[0] = target_on("Ship", {60, -50, 20});
  expect_flight_solves_the_light_time_equation(scene);
}

TEST(PulseGeometry, ApproachingMirrorsReceding) {
  for (const double v : {0.001, 50.0, 3000.0}) {
    scene::Scene scene = one_target_scene();
    scene.platforms.push_back(moving("Plane", {}, {v, 0, 0}));
    scene.platforms.push_back(moving("Missile", {}, {-v, 0, 0}));
    scene.targets = {target_on("Plane", {5000, 0, 0}), target_on("Missile", {5000, 0, 0})};
    Sky sky(scene);
    EXPECT_NEAR(sky.view(0, 0).speed_mps, v, 2e4 * epsilon);  // slope of two knots of some thousand metres
    EXPECT_NEAR(sky.view(0, 1).speed_mps, -sky.view(0, 0).speed_mps, 4e4 * epsilon);
    EXPECT_NEAR(sky.view(0, 0).clock.doppler, 2.0 * v / (c + v), 1e5 * epsilon / c);
    EXPECT_NEAR(sky.view(0, 0).delay_s, 1e4 / (c - v), 4e-5 * 4.0 * epsilon);
    EXPECT_NEAR(sky.view(0, 1).delay_s, 1e4 / (c + v), 4e-5 * 4.0 * epsilon);
    EXPECT_GT(sky.view(0, 0).delay_s, sky.view(0, 1).delay_s);
    EXPECT_NEAR(sky.view(1000, 0).distance_m - 5000.0, 5000.0 - sky.view(1000, 1).distance_m, 1e5 * epsilon);
    // Both ways have the length of the meeting, d/(1 - v/c).
    const ScattererView seen = sky.view(1000, 0);
    EXPECT_NEAR(seen.amplitude_sqrt_w, equation_amplitude(seen.distance_m / (1.0 - v / c), 1.0, c / 1e9),
                seen.amplitude_sqrt_w * 40.0 * epsilon);
  }
}

TEST(PulseGeometry, AtAKnotTheSpeedIsTheOneToTheRight) {
  scene::Scene scene = one_target_scene();
  scene::Platform car = moving("Car", {}, {});
  car.trajectory_m.part[0] = lines({{-1, 900}, {0, 1000}, {1, 980}});
  scene.platforms.push_back(car);
  scene.targets[0] = target_on("Car", {});
  EXPECT_NEAR(Sky(scene).view(0).speed_mps, -20.0, 1e3 * epsilon);
}

// Thesis 2.2: 1 kW, 1 GHz, 3 m^2 at 3 km: 1.67744e-15 W, 4.0957e-5 mV. The last digits printed bound the error.
TEST(PulseGeometry, AmplitudeIsThatOfTheRadarEquation) {
  scene::Scene scene = one_target_scene();
  scene.targets[0] = target_on("Earth", {0, 3000, 0}, 3.0);
  const double amplitude = Sky(scene).view(0).amplitude_sqrt_w;
  EXPECT_NEAR(amplitude * amplitude, 1.67744e-15, 0.00001e-15);
  EXPECT_NEAR(amplitude, 4.0957e-8, 0.0001e-8);
  EXPECT_NEAR(amplitude, equation_amplitude(3000.0, 3.0, c / 1e9), amplitude * 20.0 * epsilon);
}

TEST(PulseGeometry, GainsRaiseAndLossesLowerThePowerInDecibels) {
  scene::Scene scene = one_target_scene();
  const double plain = Sky(scene).view(0).amplitude_sqrt_w;
  scene.radars[0].transmit_gain = core::PowerRatio::from_db(3.0);
  scene.radars[0].receive_gain = core::PowerRatio::from_db(10.0);
  scene.radars[0].losses = core::PowerRatio::from_db(4.5);
  EXPECT_NEAR(Sky(scene).view(0).amplitude_sqrt_w, plain * std::pow(10.0, (3.0 + 10.0 - 4.5) / 20.0),
              plain * 50.0 * epsilon);
}

TEST(PulseGeometry, WavelengthIsThatOfThePulseItself) {
  scene::Scene scene = one_target_scene();
  scene.radars[0].carrier = scene::Radar::Carrier::user;
  scene.radars[0].carrier_list_hz.part[0] = lines({{0, 1e9}, {1, 4e9}});
  Sky sky(scene);
  const double long_wave = sky.view(0).amplitude_sqrt_w;
  EXPECT_EQ(sky.geometry().carrier_hz(), 1e9);
  const double short_wave = sky.view(1).amplitude_sqrt_w;
  EXPECT_EQ(sky.geometry().carrier_hz(), 4e9);
  EXPECT_NEAR(4.0 * short_wave, long_wave, long_wave * 10.0 * epsilon);
}

TEST(PulseGeometry, ClassicStcLeavesTheSpreadingOutAndPhysicalStcDoesNot) {
  for (const scene::Radar::Stc stc : {scene::Radar::Stc::range_law, scene::Radar::Stc::user}) {
    scene::Scene scene = one_target_scene();
    const double plain = Sky(scene).view(0).amplitude_sqrt_w;
    scene.radars[0].stc = stc;
    EXPECT_EQ(Sky(scene).view(0).amplitude_sqrt_w, plain);
    scene.options.profile = scene::Profile::classic;
    const double classic_wavelength = core::classic_light_speed_mps / core::exact_light_speed_mps;
    EXPECT_NEAR(Sky(scene).view(0).amplitude_sqrt_w, plain * 1e6 * classic_wavelength, plain * 1e6 * 20.0 * epsilon);
  }
}

TEST(PulseGeometry, CosineAndUserLawsFollowTheNormalAsThePlatformTurns) {
  scene::Scene scene = one_target_scene();
  const double plain = Sky(scene).view(0).amplitude_sqrt_w;
  scene::Platform table = resting("Table", {1000, 0, 0});
  table.rotation[2] = core::Angle::from_deg(-30.0);
  scene.platforms.push_back(table);
  scene::Target plate = target_on("Table", {});
  plate.traits.edit().reflectivity = scene::Target::Reflectivity::directional;
  plate.traits.edit().azimuth =
      core::Angle::from_deg(-90.0);  // faces -x, the radar; the table turns it by 30 degrees counterclockwise
  scene.targets = {plate};
  EXPECT_NEAR(Sky(scene).view(0).amplitude_sqrt_w, plain * std::sqrt(std::cos(core::pi / 6.0)), plain * 1e-14);
  scene.targets[0].traits.edit().gain = scene::Target::Gain::user;
  scene.targets[0].traits.edit().gain_db.part[0] = lines({{0, 0}, {60, -20}});
  EXPECT_NEAR(Sky(scene).view(0).amplitude_sqrt_w, plain * std::sqrt(0.1), plain * 1e-13);
  scene.targets[0].traits.edit().gain = scene::Target::Gain::cosine;
  scene.targets[0].traits.edit().azimuth = core::Angle::from_deg(90.0);  // from behind
  EXPECT_EQ(Sky(scene).view(0).amplitude_sqrt_w, 0.0);
}

// A radar and its targets on one platform: however that is turned and wherever it stands, the radar sees the same.
TEST(PulseGeometry, WhatTheRadarSeesDoesNotDependOnHowTheWorldIsTurned) {
  scene::Scene scene = one_target_scene();
  scene.radars[0].transmit_antenna.pattern = scene::Antenna::Pattern::sinx;
  scene.radars[0].transmit_antenna.azimuth_beamwidth = core::Angle::from_deg(3.0);
  scene.radars[0].transmit_antenna.elevation_beamwidth = core::Angle::from_deg(12.0);
  scene.radars[0].beam_azimuth = core::Angle::from_deg(80.0);
  scene.radars[0].beam_elevation = core::Angle::from_deg(-10.0);
  scene.targets[0] = target_on("Earth", {1000.0, 150.0, -100.0});
  scene.targets[0].traits.edit().reflectivity = scene::Target::Reflectivity::directional;
  scene.targets[0].traits.edit().azimuth = core::Angle::from_deg(-100.0);
  const ScattererView level = Sky(scene).view(0);
  scene.platforms[0].position_m = {500, 7000, -300};
  scene.platforms[0].rotation = {core::Angle::from_deg(40), core::Angle::from_deg(-25), core::Angle::from_deg(130)};
  const ScattererView turned = Sky(scene).view(0);
  EXPECT_NEAR(turned.distance_m, level.distance_m, 1e4 * 4.0 * epsilon);
  EXPECT_NEAR(turned.amplitude_sqrt_w, level.amplitude_sqrt_w, std::abs(level.amplitude_sqrt_w) * 1e-11);
}

TEST(PulseGeometry, ReceiveAntennaMultipliesTheTransmitAntennasAmplitude) {
  scene::Scene scene = one_target_scene();
  scene.radars[0].beam_azimuth = core::Angle::from_deg(86.0);  // 4 degrees off the target
  const double isotropic = Sky(scene).view(0).amplitude_sqrt_w;
  scene::Antenna& transmit = scene.radars[0].transmit_antenna;
  transmit.pattern = scene::Antenna::Pattern::sinx;
  transmit.azimuth_beamwidth = core::Angle::from_deg(10.0);
  transmit.elevation_beamwidth = core::Angle::from_deg(1.0);  // no offset in elevation: must not matter
  const double offset = 4.0 * core::pi / 180.0;
  const double g10 = radar::sinx_gain(offset, 10.0 * core::pi / 180.0),
               g6 = radar::sinx_gain(offset, 6.0 * core::pi / 180.0);
  EXPECT_NEAR(Sky(scene).view(0).amplitude_sqrt_w, isotropic * g10 * g10, isotropic * 1e-12);
  scene.radars[0].same_antenna = false;
  EXPECT_NEAR(Sky(scene).view(0).amplitude_sqrt_w, isotropic * g10, isotropic * 1e-12);
  scene.radars[0].receive_antenna = transmit;
  scene.radars[0].receive_antenna.azimuth_beamwidth = core::Angle::from_deg(6.0);
  EXPECT_NEAR(Sky(scene).view(0).amplitude_sqrt_w, isotropic * g10 * g6, isotropic * 1e-12);
  scene.options.profile = scene::Profile::classic;
  const double classic = isotropic * core::classic_light_speed_mps / core::exact_light_speed_mps;
  EXPECT_NEAR(Sky(scene).view(0).amplitude_sqrt_w, classic * std::sqrt(g10 * g6), isotropic * 1e-12);
}

TEST(PulseGeometry, EchoesListsTheTargetsAndThenTheSurfaces) {
  scene::Scene scene = one_target_scene();
  scene.targets.push_back(target_on("Earth", {0, 700, 0}, 2.0));
  scene::Surface surface;  // 20 m x 10 m across the x axis at 1 km
  scene.surfaces.push_back(surface);
  Sky sky(scene);
  sky.geometry().set_pulse(0);
  radar::EchoBatch echoes;
  sky.geometry().echoes(echoes);
  ASSERT_GT(echoes.size(), 50u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(echoes.delay_s[i], sky.view(0, i).delay_s);
    EXPECT_EQ(echoes.amplitude_sqrt_w[i], sky.view(0, i).amplitude_sqrt_w);
    EXPECT_EQ(echoes.doppler[i], sky.view(0, i).clock.doppler);
  }
  double power = 0.0;
  for (std::size_t i = 2; i < echoes.size(); ++i) power += std::pow(echoes.amplitude_sqrt_w[i], 2.0);
  // 100 m^2 facing the radar: nearest points 1e-4 closer, incidence up to 10 m/1 km.
  const double expected = std::pow(equation_amplitude(1000.0, 100.0, c / 1e9), 2.0);
  EXPECT_NEAR(power, expected, 3e-4 * expected);
  std::swap(scene.surfaces[0].corner_m[1], scene.surfaces[0].corner_m[2]);  // turns its back
  Sky behind(scene);
  behind.geometry().set_pulse(0);
  behind.geometry().echoes(echoes);
  EXPECT_EQ(echoes.size(), 2u);
}

// What is wrong with the echoes of pulse 0; empty for nothing.
core::Problem impossible_echo(const scene::Scene& scene) {
  Sky sky(scene);
  sky.geometry().set_pulse(0);
  radar::EchoBatch echoes;
  try {
    sky.geometry().echoes(echoes);
  } catch (const ImpossibleEcho& error) {
    return error.problem;
  }
  return {};
}

TEST(PulseGeometry, RefusesATargetAtTheRadarsPositionAndNamesIt) {
  scene::Scene scene = one_target_scene();
  EXPECT_EQ(impossible_echo(scene).message, "");
  scene.targets.push_back(target_on("Earth", {}));
  const core::Problem problem = impossible_echo(scene);
  EXPECT_NE(problem.message.find("position of radar"), std::string::npos) << problem.message;
  EXPECT_EQ(problem.subject, (core::Subject{"target", 1, "position_m"}));
}

TEST(PulseGeometry, RefusesATargetAsFastAsLight) {
  scene::Scene scene = one_target_scene();
  scene::Platform comet;
  comet.name = "Comet";
  comet.path = scene::Platform::Path::trajectory;
  comet.trajectory_m.part[0].knots = {{0.0, 1000.0}, {1.0, -2.9e8}};
  scene.platforms.push_back(comet);
  scene.targets.push_back(target_on("Comet", {}));
  EXPECT_EQ(impossible_echo(scene).message, "");
  scene.platforms.back().trajectory_m.part[0].knots[1].y = -3e8;
  EXPECT_NE(impossible_echo(scene).message.find("fast as light"), std::string::npos);
}

TEST(PulseGeometry, RefusesEchoesThatNoRecordingCanHold) {
  scene::Scene scene = one_target_scene();
  scene.radars[0].power_w = 1e18;
  EXPECT_EQ(impossible_echo(scene).message, "");
  scene.radars[0].transmit_gain = core::PowerRatio::from_db(300.0);
  scene.radars[0].receive_gain = core::PowerRatio::from_db(300.0);
  EXPECT_NE(impossible_echo(scene).message.find("too strong"), std::string::npos);
}

}  // namespace pulse_geometry_test
}  // namespace sarsim::simulate
