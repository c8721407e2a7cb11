#include "scene/check/check.hpp"

#include <cmath>
#include <functional>
#include <limits>

#include "scene/check/check_test_scene.hpp"

namespace sarsim::scene {
namespace check_test {

using testing::HasSubstr;

TEST(Check, FindsNothingInASoundScene) {
  for (const core::Problem& problem : check(sound_scene())) ADD_FAILURE() << core::to_string(problem);
}

TEST(Check, FindsNothingInAnEmptyScene) { EXPECT_TRUE(check(Scene{}).empty()); }

TEST(Check, FindsNothingWrongWithARadarThatNoSimulationUses) {
  Scene scene = sound_scene();
  scene.simulations.clear();
  scene.geometries.clear();
  EXPECT_TRUE(check(scene).empty());
}

// Every number of a scene, with its place. What is not in use must be a number too: an editor shows it.
struct Field {
  core::Subject subject;
  std::function<void(Scene&, double)> set;
};

std::vector<Field> motion_fields() {
  return {
      {{"platform", 1, "position_m"}, [](Scene& s, double v) { s.platforms[1].position_m.y = v; }},
      {{"platform", 1, "trajectory_m"}, [](Scene& s, double v) { s.platforms[1].trajectory_m.part[2].knots[0].y = v; }},
      {{"platform", 0, "trajectory_m"},
       [](Scene& s, double v) {
         s.platforms[0].trajectory_m.part[1] = points({{v, 0.0}});
       }},
      {{"platform", 0, "rotation"}, [](Scene& s, double v) { s.platforms[0].rotation[2] = core::Angle::from_deg(v); }},
      {{"platform", 0, "rotation_deg"},
       [](Scene& s, double v) {
         s.platforms[0].rotation_deg.part[0] = points({{0.0, v}});
       }},
      {{"platform", 0, "rotation_rate"},
       [](Scene& s, double v) { s.platforms[0].rotation_rate[1] = core::Angle::from_deg(v); }},
      {{"platform", 0, "position_stddev_m"}, [](Scene& s, double v) { s.platforms[0].position_stddev_m.x = v; }},
      {{"platform", 0, "position_envelope"},
       [](Scene& s, double v) {
         s.platforms[0].position_envelope.part[0] = points({{v, 1.0}});
       }},
      {{"platform", 0, "rotation_stddev"},
       [](Scene& s, double v) { s.platforms[0].rotation_stddev[0] = core::Angle::from_deg(v); }},
      {{"platform", 0, "rotation_envelope"},
       [](Scene& s, double v) {
         s.platforms[0].rotation_envelope.part[2] = points({{0.0, v}});
       }},
      {{"target", 0, "position_m"}, [](Scene& s, double v) { s.targets[0].position_m.x = v; }},
      {{"target", 0, "position_stddev_m"},
       [](Scene& s, double v) { s.targets[0].traits.edit().position_stddev_m.z = v; }},
      {{"target", 0, "rcs_m2"}, [](Scene& s, double v) { s.targets[0].rcs_m2 = v; }},
      {{"target", 0, "rcs_stddev_m2"}, [](Scene& s, double v) { s.targets[0].traits.edit().rcs_stddev_m2 = v; }},
      {{"target", 0, "azimuth"},
       [](Scene& s, double v) { s.targets[0].traits.edit().azimuth = core::Angle::from_deg(v); }},
      {{"target", 0, "elevation"},
       [](Scene& s, double v) { s.targets[0].traits.edit().elevation = core::Angle::from_deg(v); }},
      {{"target", 0, "azimuth_stddev"},
       [](Scene& s, double v) { s.targets[0].traits.edit().azimuth_stddev = core::Angle::from_deg(v); }},
      {{"target", 0, "elevation_stddev"},
       [](Scene& s, double v) { s.targets[0].traits.edit().elevation_stddev = core::Angle::from_deg(v); }},
      {{"target", 0, "gain_db"},
       [](Scene& s, double v) {
         s.targets[0].traits.edit().gain_db.part[0] = points({{v, 0.0}});
       }},
      {{"surface", 0, "corner_m"}, [](Scene& s, double v) { s.surfaces[0].corner_m[1].y = v; }},
  };
}

std::vector<Field> radar_fields() {
  return {
      {{"radar", 0, "bandwidth_hz"}, [](Scene& s, double v) { s.radars[0].bandwidth_hz = v; }},
      {{"radar", 0, "pulse_iq"},
       [](Scene& s, double v) {
         s.radars[0].pulse_iq.part[1] = points({{v, 0.0}});
       }},
      {{"radar", 0, "pulse_width_s"}, [](Scene& s, double v) { s.radars[0].pulse_width_s = v; }},
      {{"radar", 0, "rise_s"}, [](Scene& s, double v) { s.radars[0].rise_s = v; }},
      {{"radar", 0, "fall_s"}, [](Scene& s, double v) { s.radars[0].fall_s = v; }},
      {{"radar", 0, "envelope_gain"},
       [](Scene& s, double v) {
         s.radars[0].envelope_gain.part[0] = points({{0.0, v}});
       }},
      {{"radar", 0, "prf_hz"}, [](Scene& s, double v) { s.radars[0].prf_hz = v; }},
      {{"radar", 0, "pri_s"},
       [](Scene& s, double v) {
         s.radars[0].pri_s.part[0] = points({{0.0, v}});
       }},
      {{"radar", 0, "carrier_hz"}, [](Scene& s, double v) { s.radars[0].carrier_hz = v; }},
      {{"radar", 0, "carrier_step_hz"}, [](Scene& s, double v) { s.radars[0].carrier_step_hz = v; }},
      {{"radar", 0, "carrier_list_hz"},
       [](Scene& s, double v) {
         s.radars[0].carrier_list_hz.part[0] = points({{0.0, v}});
       }},
      {{"radar", 0, "power_w"}, [](Scene& s, double v) { s.radars[0].power_w = v; }},
      {{"radar", 0, "transmit_gain"},
       [](Scene& s, double v) { s.radars[0].transmit_gain = core::PowerRatio::from_db(v); }},
      {{"radar", 0, "receive_gain"},
       [](Scene& s, double v) { s.radars[0].receive_gain = core::PowerRatio::from_db(v); }},
      {{"radar", 0, "losses"}, [](Scene& s, double v) { s.radars[0].losses = core::PowerRatio::from_db(v); }},
      {{"radar", 0, "noise_temperature_k"}, [](Scene& s, double v) { s.radars[0].noise_temperature_k = v; }},
      {{"radar", 0, "transmit_antenna.azimuth_beamwidth"},
       [](Scene& s, double v) { s.radars[0].transmit_antenna.azimuth_beamwidth = core::Angle::from_deg(v); }},
      {{"radar", 0, "transmit_antenna"},
       [](Scene& s, double v) {
         s.radars[0].transmit_antenna.gain_db.part[0] = points({{v, v}});
       }},
      {{"radar", 0, "receive_antenna.elevation_beamwidth"},
       [](Scene& s, double v) { s.radars[0].receive_antenna.elevation_beamwidth = core::Angle::from_deg(v); }},
      {{"radar", 0, "receive_antenna"},
       [](Scene& s, double v) {
         s.radars[0].receive_antenna.gain_db.part[1] = points({{0.0, v}});
       }},
      {{"radar", 0, "beam_elevation"},
       [](Scene& s, double v) { s.radars[0].beam_elevation = core::Angle::from_deg(v); }},
      {{"radar", 0, "beam_azimuth"}, [](Scene& s, double v) { s.radars[0].beam_azimuth = core::Angle::from_deg(v); }},
      {{"radar", 0, "beam_rate"}, [](Scene& s, double v) { s.radars[0].beam_rate = core::Angle::from_deg(v); }},
      {{"radar", 0, "spot_world_m"}, [](Scene& s, double v) { s.radars[0].spot_world_m.z = v; }},
      {{"radar", 0, "beam_target_world_m"},
       [](Scene& s, double v) {
         s.radars[0].beam_target_world_m.part[0] = points({{0.0, v}});
       }},
      {{"radar", 0, "hanning_pedestal"}, [](Scene& s, double v) { s.radars[0].hanning_pedestal = v; }},
      {{"radar", 0, "window_gain"},
       [](Scene& s, double v) {
         s.radars[0].window_gain.part[0] = points({{0.0, v}});
       }},
      {{"radar", 0, "stc_gain"},
       [](Scene& s, double v) {
         s.radars[0].stc_gain.part[0] = points({{v, 1.0}});
       }},
  };
}

std::vector<Field> recording_fields() {
  return {
      {{"simulation", 0, "range_start_m"}, [](Scene& s, double v) { s.simulations[0].range_start_m = v; }},
      {{"simulation", 0, "range_end_m"}, [](Scene& s, double v) { s.simulations[0].range_end_m = v; }},
      {{"simulation", 0, "time_start_s"}, [](Scene& s, double v) { s.simulations[0].time_start_s = v; }},
      {{"simulation", 0, "time_end_s"}, [](Scene& s, double v) { s.simulations[0].time_end_s = v; }},
      {{"simulation", 0, "sample_rate_hz"}, [](Scene& s, double v) { s.simulations[0].sample_rate_hz = v; }},
      {{"simulation", 0, "lsb_v"}, [](Scene& s, double v) { s.simulations[0].lsb_v = v; }},
      {{"simulation", 0, "oversampling"}, [](Scene& s, double v) { s.simulations[0].oversampling = v; }},
      {{"simulation", 0, "width_factor"}, [](Scene& s, double v) { s.simulations[0].width_factor = v; }},
      {{"geometry", 0, "range_start_m"}, [](Scene& s, double v) { s.geometries[0].range_start_m = v; }},
      {{"geometry", 0, "range_end_m"}, [](Scene& s, double v) { s.geometries[0].range_end_m = v; }},
      {{"geometry", 0, "time_start_s"}, [](Scene& s, double v) { s.geometries[0].time_start_s = v; }},
      {{"geometry", 0, "time_end_s"}, [](Scene& s, double v) { s.geometries[0].time_end_s = v; }},
      {{"options", 0, "tolerance"}, [](Scene& s, double v) { s.options.tolerance = v; }},
  };
}

void expect_refuses_what_is_no_number(const std::vector<Field>& fields) {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const Field& field : fields) {
    for (const double value : {std::nan(""), infinity, -infinity}) {
      SCOPED_TRACE(field.subject.kind + " " + field.subject.field);
      Scene scene = sound_scene();
      field.set(scene, value);
      const core::Problem problem = expect_error(scene, field.subject);
      EXPECT_THAT(problem.message, HasSubstr("finite number"));
      EXPECT_THAT(problem.found, HasSubstr(std::isnan(value) ? "nan" : "inf"));
    }
  }
}

TEST(Check, RefusesWhatIsNoNumberInTheMotionAndTargets) { expect_refuses_what_is_no_number(motion_fields()); }
TEST(Check, RefusesWhatIsNoNumberInTheRadar) { expect_refuses_what_is_no_number(radar_fields()); }
TEST(Check, RefusesWhatIsNoNumberInTheRecordings) { expect_refuses_what_is_no_number(recording_fields()); }

TEST(Check, ReportsEveryProblemAtOnce) {
  Scene scene = sound_scene();
  scene.targets[0].platform = "Moon";
  scene.radars[0].pulse_width_s = 0.0;
  scene.radars[0].power_w = -1.0;
  scene.simulations[0].file = "";
  EXPECT_EQ(check(scene).size(), 4U);
}

TEST(Check, PutsErrorsBeforeWarningsAndFalseSignalsBeforeSurprises) {
  Scene scene = sound_scene();
  scene.platforms.push_back(scene.platforms[1]);  // other object
  scene.simulations[0].range_start_m = -10.0;     // surprise
  scene.simulations[0].sample_rate_hz = 80e6;     // false signal
  scene.targets[0].rcs_m2 = -1.0;                 // lost signal
  scene.geometries[0].columns = 256;              // error, from the last object
  std::vector<std::string> fields;
  for (const core::Problem& problem : check(scene)) fields.push_back(problem.subject.field);
  EXPECT_THAT(fields, testing::ElementsAre("columns", "sample_rate_hz", "rcs_m2", "name", "range_start_m"));
}

TEST(Check, RefusesNumbersThatNothingCanBeComputedWith) {
  for (const double value : {1e18, -1e18}) {
    Scene scene = sound_scene();
    scene.platforms[0].position_m.y = value;
    EXPECT_FALSE(core::has_errors(check(scene))) << value;
    scene.platforms[0].position_m.y = 1.1 * value;
    EXPECT_THAT(expect_error(scene, {"platform", 0, "position_m"}).message, testing::HasSubstr("too large"));
  }
  Scene scene = sound_scene();
  scene.radars[0].transmit_gain = core::PowerRatio::from_db(300.1);
  expect_error(scene, {"radar", 0, "transmit_gain"});
}

TEST(Check, RefusesASurfaceOfTooManyPoints) {
  Scene scene = sound_scene();
  scene.surfaces.push_back({"Earth", {core::Vec3{}, core::Vec3{6e3, 0.0, 0.0}, core::Vec3{0.0, 6e3, 0.0}}});
  EXPECT_FALSE(core::has_errors(check(scene)));
  scene.surfaces.back().corner_m[2].y = 7e3;
  EXPECT_THAT(expect_error(scene, {"surface", scene.surfaces.size() - 1, "corner_m"}).message,
              testing::HasSubstr("too large"));
}

TEST(Check, RefusesSurfacesThatAreTooLargeTogether) {
  Scene scene = sound_scene();
  scene.surfaces.clear();
  const std::size_t before = scene.surfaces.size();
  for (int i = 0; i < 3; ++i)
    scene.surfaces.push_back({"Earth", {core::Vec3{}, core::Vec3{4e3, 0.0, 0.0}, core::Vec3{0.0, 4e3, 0.0}}});
  EXPECT_THAT(expect_error(scene, {"surface", before + 2, "corner_m"}).message, testing::HasSubstr("together"));
  scene.surfaces.pop_back();
  EXPECT_FALSE(core::has_errors(check(scene)));
}

TEST(Check, SaysOfAnObjectWithAnErrorOnlyTheError) {
  Scene scene = sound_scene();
  scene.targets[0].rcs_m2 = -1.0;  // A warning.
  EXPECT_EQ(check(scene).size(), 1U);
  scene.targets[0].traits.edit().rcs_stddev_m2 = -1.0;
  expect_error(scene, {"target", 0, "rcs_stddev_m2"});
}

TEST(Check, NamesTheObjectByItsPositionInItsList) {
  Scene scene = sound_scene();
  scene.targets.resize(5);
  scene.targets[3].traits.edit().rcs_stddev_m2 = -1.0;
  expect_error(scene, {"target", 3, "rcs_stddev_m2"});
}

TEST(Check, HoldsTheToleranceInItsRange) {
  for (const double tolerance : {1e-12, 1e-6, 0.1}) {
    Scene scene = sound_scene();
    scene.options.tolerance = tolerance;
    EXPECT_TRUE(check(scene).empty()) << tolerance;
  }
  for (const double tolerance : {0.0, -1e-6, 0.9e-12, 0.11}) {
    Scene scene = sound_scene();
    scene.options.tolerance = tolerance;
    expect_error(scene, {"options", 0, "tolerance"});
  }
}

TEST(Check, FindsTheSameOnAnyNumberOfThreads) {
  Scene scene = sound_scene();
  scene.platforms[0].name = "Ground";
  scene.platforms.push_back(scene.platforms[0]);
  scene.platforms.back().name = "Plane 1";
  scene.platforms.push_back(scene.platforms[0]);
  scene.platforms.back().name = "Plane 2";
  const std::string names[] = {"Ground", "Earth", "Plane", "Plane 1", "Grou", "nobody"};
  scene.targets.assign(60'000, Target{});
  for (std::size_t i = 0; i < scene.targets.size(); ++i) {
    scene.targets[i].platform = names[i < 20'000 ? 0 : i % 6];
    if (i % 1000 == 7) scene.targets[i].traits.edit().rcs_stddev_m2 = -1.0;
    if (i % 1000 == 8) scene.targets[i].rcs_m2 = -1.0;
  }
  const auto printed = [&](unsigned threads) {
    std::string text;
    for (const core::Problem& p : check(scene, {threads}))
      text += core::to_string(p) + " " + p.subject.kind + std::to_string(p.subject.index) + p.subject.field + "\n";
    return text;
  };
  const std::string one = printed(1);
  EXPECT_NE(one.find("no platform has this name; found 'nobody'"), std::string::npos);
  EXPECT_NE(one.find("Plane 2, Earth"), std::string::npos);
  for (const unsigned threads : {2U, 3U, 8U}) EXPECT_TRUE(printed(threads) == one) << threads;
}

// The world is there whether or not a script defines it.
TEST(Check, SaysNothingOfAnEarthThatIsNotDefined) {
  Scene scene = sound_scene();
  scene.platforms[0].name = "Ground";
  for (Radar& radar : scene.radars) radar.platform = "Ground";
  for (Surface& surface : scene.surfaces) surface.platform = "Ground";
  for (Target& target : scene.targets) target.platform = "Earth";
  EXPECT_TRUE(check(scene, {1}).empty());
}

TEST(Check, EndsWhenAskedTo) {
  core::StopFlag stop;
  stop.request();
  EXPECT_THROW(static_cast<void>(check(sound_scene(), {2, &stop})), core::Interrupted);
}

TEST(Check, OfAMillionTargetsOnOnePlatformNeedsNoMillionLookUps) {
  Scene scene = sound_scene();
  for (int i = 0; i < 300; ++i) {
    scene.platforms.push_back(scene.platforms[0]);
    scene.platforms.back().name = "Platform number " + std::to_string(i);
  }
  scene.targets.assign(1'000'000, Target{});
  for (Target& target : scene.targets) target.platform = "Platform number 299";
  EXPECT_TRUE(check(scene).empty());
}

}  // namespace check_test
}  // namespace sarsim::scene
