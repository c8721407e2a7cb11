#include "simulate/survey/table_rules.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "core/maths/constants.hpp"
#include "simulate/plan/simulate_test_scene.hpp"
#include "simulate/survey/survey.hpp"

namespace sarsim::simulate {
namespace table_rules_test {
namespace {

// A beam to the north and targets at these angles off it, azimuth and elevation, all 1 km away.
scene::Scene seen_at(const std::vector<std::array<double, 2>>& offsets_deg) {
  scene::Scene scene = one_target_scene();
  scene.targets.clear();
  for (const auto& [azimuth_deg, elevation_deg] : offsets_deg)
    scene.targets.push_back(target_on(
        "Earth", 1000.0 * core::direction(azimuth_deg * core::rad_per_deg, elevation_deg * core::rad_per_deg)));
  return scene;
}

scene::Antenna by_points(std::vector<core::Knot> azimuth, std::vector<core::Knot> elevation) {
  scene::Antenna antenna;
  antenna.pattern = scene::Antenna::Pattern::user;
  antenna.gain_db.part = {lines(std::move(azimuth)), lines(std::move(elevation))};
  return antenna;
}

const std::vector<core::Knot> flat{{0, 0}};
const std::vector<core::Knot> cosecant{{-90, -40}, {-10, -30}, {-2, -3},  {0, 0},
                                       {2, -1},    {10, -6},   {40, -12}, {90, -40}};

std::vector<double> two_way_db(const scene::Scene& scene) {
  const ResolvedScene resolved = resolve(scene);
  const ResolvedRadar radar = resolve_radar(scene, resolved, 0);
  PulseGeometry geometry(resolved, radar);
  geometry.set_pulse(0);
  std::vector<double> gains_db;
  for (std::size_t i = 0; i < scene.targets.size(); ++i) {
    const double isotropic =
        equation_amplitude(1000.0, 1.0, resolved.conventions.light_speed_mps / scene.radars[0].carrier_hz);
    gains_db.push_back(20.0 * std::log10(geometry.view(i).amplitude_sqrt_w / isotropic));
  }
  return gains_db;
}

std::string said(const core::Problems& problems) {
  std::string all;
  for (const core::Problem& p : problems)
    if (p.message.find("beyond") != std::string::npos || p.message.find("differently") != std::string::npos)
      all +=
          fmt::format("{}: {}; {}\n", p.severity == core::Severity::warning ? "warning" : "note", p.message, p.found);
  return all;
}

TEST(TablesOfAngles, TellTargetsAboveTheBeamFromThoseBelow) {
  scene::Scene scene = seen_at({{0, 10}, {0, -10}, {25, 10}});
  scene.radars[0].transmit_antenna = by_points(flat, cosecant);
  const std::vector<double> gains_db = two_way_db(scene);
  EXPECT_NEAR(gains_db[0], -12.0, 1e-9);
  EXPECT_NEAR(gains_db[1], -60.0, 1e-9);
  EXPECT_NEAR(gains_db[2], -12.0, 1e-9);
  scene.radars[0].same_antenna = false;  // once
  EXPECT_NEAR(two_way_db(scene)[1], -30.0, 1e-9);
  std::swap(scene.radars[0].transmit_antenna, scene.radars[0].receive_antenna);
  EXPECT_NEAR(two_way_db(scene)[1], -30.0, 1e-9);
}

// Azimuth offsets are positive clockwise, to the right of the beam.
TEST(TablesOfAngles, TellTargetsToTheRightFromThoseToTheLeft) {
  scene::Scene scene = seen_at({{10, 0}, {-10, 0}, {170, 0}});
  scene.radars[0].transmit_antenna = by_points(cosecant, flat);
  const std::vector<double> gains_db = two_way_db(scene);
  EXPECT_NEAR(gains_db[0], -12.0, 1e-9);
  EXPECT_NEAR(gains_db[1], -60.0, 1e-9);
  EXPECT_NEAR(gains_db[2], -80.0, 1e-9);  // -40 dB at both ends of the table
  EXPECT_NE(said(survey(scene)).find("1 of 3 targets are seen beyond"), std::string::npos);
  scene.targets.pop_back();
  EXPECT_EQ(said(survey(scene)), "");
}

// A pattern that goes on in a straight line would be at +130 dB behind.
TEST(TablesOfAngles, HoldTheirEndsAndSayWhoIsThere) {
  scene::Scene scene = seen_at({{0, 0}, {60, 0}, {180, 0}});
  scene.radars[0].transmit_antenna = by_points({{-20, -30}, {-10, -40}, {0, 0}, {10, -40}, {20, -30}}, flat);
  const std::vector<double> gains_db = two_way_db(scene);
  EXPECT_NEAR(gains_db[1], -60.0, 1e-9);
  EXPECT_NEAR(gains_db[2], -60.0, 1e-9);
  const std::string words = said(survey(scene));
  EXPECT_NE(words.find("warning: 2 of 3 targets are seen beyond the points of the antenna's cut in azimuth"),
            std::string::npos)
      << words;
  EXPECT_NE(words.find("target 3 at 180 deg, points from -20 to 20 deg; -30 dB is taken"), std::string::npos) << words;
}

TEST(TablesOfAngles, OfReflectivitiesSayWhoIsBeyond) {
  scene::Scene scene = seen_at({{0, 0}, {90, 0}});
  for (scene::Target& target : scene.targets) {
    scene::TargetTraits& traits = target.traits.edit();
    traits.reflectivity = scene::TargetTraits::Reflectivity::directional;
    traits.azimuth = core::Angle::from_deg(180.0);  // faces the radar of the first, across the second's line of sight
    traits.gain = scene::TargetTraits::Gain::user;
    traits.gain_db.part[0] = lines({{0, 0}, {60, -20}});
  }
  EXPECT_NEAR(two_way_db(scene)[1], -20.0, 1e-9);
  const std::string words = said(survey(scene));
  EXPECT_NE(words.find("1 of 2 targets with a reflectivity by points are seen at incidence angles beyond these"),
            std::string::npos)
      << words;
  EXPECT_NE(words.find("target 2 at 90 deg, points from 0 to 60 deg; -20 dB is taken"), std::string::npos) << words;
}

TEST(ProfileDifferences, AreTheHalfThatClassicLeavesOut) {
  scene::Scene scene = seen_at({{0, 10}, {0, -10}});
  scene.radars[0].transmit_antenna = by_points(flat, cosecant);
  for (const scene::Profile profile : {scene::Profile::physical, scene::Profile::classic}) {
    scene.options.profile = profile;
    const bool classic = profile == scene::Profile::classic;
    EXPECT_NEAR(two_way_db(scene)[1], classic ? -12.0 : -60.0, 1e-9);
    const std::string words = said(differences_of_profiles(scene, survey_report(scene).summaries));
    EXPECT_NE(words.find(classic ? "warning: the profiles" : "note: the profiles"), std::string::npos) << words;
    EXPECT_NE(words.find("1 of 2 targets; target 2 at azimuth 0 deg, elevation -10 deg off the beam: -12 dB two-way by "
                         "classic, -60 dB by physical"),
              std::string::npos)
        << words;
  }
}

// A table of one side that reaches all targets is read alike.
TEST(ProfileDifferences, AreNoneOfScriptsAsTheyWere) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> gain(-40.0, 0.0), azimuth(-180.0, 180.0), elevation(-90.0, 90.0);
  for (int draw = 0; draw < 30; ++draw) {
    std::vector<core::Knot> knots;
    for (int i = 0; i <= 9; ++i) knots.push_back({20.0 * i, gain(random)});
    std::vector<std::array<double, 2>> offsets;
    for (int i = 0; i < 5; ++i) offsets.push_back({azimuth(random), elevation(random)});
    scene::Scene scene = seen_at(offsets);
    scene.radars[0].transmit_antenna = by_points(knots, knots);
    EXPECT_EQ(said(survey(scene)) + said(differences_of_profiles(scene, survey_report(scene).summaries)), "");
  }
}

TEST(ProfileDifferences, AreToldOfReceiversByRange) {
  scene::Scene scene = seen_at({{0, 0}});
  scene.radars[0].stc = scene::Radar::Stc::user;
  scene.radars[0].stc_gain.part[0] = lines({{0, 0.1}, {1000, 1}});
  const std::string words = said(differences_of_profiles(scene, survey_report(scene).summaries));
  EXPECT_NE(words.find("at 2000 m: 1.9 by classic, 1 by physical"), std::string::npos) << words;
}

}  // namespace
}  // namespace table_rules_test
}  // namespace sarsim::simulate
