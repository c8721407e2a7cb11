#include "simulate/survey/table_rules.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <random>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "core/maths/constants.hpp"
#include "scene/model/cloud_points.hpp"
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
  const Link radar = resolve_radar(scene, resolved, 0);
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

// The largest azimuth and elevation of the corners off a beam to the north, deg.
std::array<double, 2> largest_offsets_deg(const scene::Surface& surface) {
  std::array<double, 2> largest{};
  for (const core::Vec3& corner : surface.corner_m) {
    largest[0] = std::max(largest[0], std::abs(core::azimuth_rad(corner)) * core::deg_per_rad);
    largest[1] = std::max(largest[1], std::abs(core::elevation_rad(corner)) * core::deg_per_rad);
  }
  return largest;
}

// A triangle of some hundred square metres around a direction, 1 km away, whose front shows to the radar.
scene::Surface surface_at(double azimuth_deg, double elevation_deg, std::mt19937& random) {
  std::uniform_real_distribution<double> draw(-1.0, 1.0);
  const core::Vec3 middle =
      1000.0 * core::direction(azimuth_deg * core::rad_per_deg, elevation_deg * core::rad_per_deg);
  scene::Surface surface;
  for (core::Vec3& corner : surface.corner_m)
    corner = middle + core::Vec3{25.0 * draw(random), 5.0 * draw(random), 25.0 * draw(random)};
  const auto& c = surface.corner_m;
  if (core::dot(core::cross(c[1] - c[0], c[2] - c[0]), middle) > 0.0)
    std::swap(surface.corner_m[1], surface.corner_m[2]);
  return surface;
}

// Alone in the scene, or beside targets: what no target shows is told, with the angle of its farthest corner.
TEST(TablesOfAngles, TellSurfacesThatReachBeyondThem) {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> angle(-20.0, 20.0);
  int told = 0, silent = 0;
  for (int draw = 0; draw < 60; ++draw) {
    const scene::Surface surface = surface_at(angle(random), angle(random), random);
    const std::array<double, 2> largest = largest_offsets_deg(surface);
    scene::Scene scene = draw % 2 == 0 ? seen_at({}) : seen_at({{0, 0}});
    scene.surfaces = {surface_at(0.0, 0.0, random), surface};
    scene.radars[0].transmit_antenna = by_points({{-12, -6}, {0, 0}, {12, -6}}, {{-9, -8}, {0, 0}, {9, -8}});
    const std::string words = said(survey(scene));
    for (const auto& [plane, reach, table] :
         {std::tuple("azimuth", largest[0], 12.0), std::tuple("elevation", largest[1], 9.0)}) {
      const auto at =
          words.find(fmt::format("1 of 2 surfaces are seen beyond the points of the antenna's cut in {}", plane));
      // Points of a surface stay some metres away from its acute corners: half a degree.
      if (reach < table) {
        EXPECT_EQ(at, std::string::npos) << words;
        ++silent;
      }
      if (reach < table + 0.6) continue;
      ASSERT_NE(at, std::string::npos) << draw << plane << reach << words;
      const auto number = words.find("surface 2 at ", at);
      ASSERT_NE(number, std::string::npos) << words;
      EXPECT_NEAR(std::abs(std::stod(words.substr(number + 13))), reach, 0.6) << words;
      ++told;
    }
  }
  EXPECT_GT(told, 20);
  EXPECT_GT(silent, 20);
}

// One of very many targets, which is none of the 64 that are examined as they pass the beam.
TEST(TablesOfAngles, TellTheOneTargetOfManyThatIsBeyond) {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> near(-3.0, 3.0), where(0.2, 0.8);
  for (int draw = 0; draw < 10; ++draw) {
    std::vector<std::array<double, 2>> offsets(1000);
    for (auto& offset : offsets) offset = {near(random), near(random)};
    scene::Scene scene = seen_at(offsets);
    scene.radars[0].transmit_antenna = by_points({{-9, -8}, {0, 0}, {9, -8}}, {{-9, -8}, {0, 0}, {9, -8}});
    EXPECT_EQ(said(survey(scene)), "");
    const auto odd = static_cast<std::size_t>(1000.0 * where(random));
    offsets[odd] = {1.0, -11.5};
    scene.targets = seen_at(offsets).targets;
    EXPECT_NE(said(survey(scene)).find(fmt::format("target {} at -11.5 deg", odd + 1)), std::string::npos)
        << said(survey(scene));
  }
}

// Points of clouds, of their reflectivity and of the antenna.
TEST(TablesOfAngles, TellPointsOfCloudsThatAreBeyond) {
  scene::CloudPoints points;
  for (int i = 0; i < 2000; ++i) {
    points.arrays.x_m.push_back(0.01 * i);
    points.arrays.y_m.push_back(1000.0);
    points.arrays.z_m.push_back(i == 777 ? 300.0 : 0.0);
    points.arrays.root_rcs_m.push_back(1.0);
  }
  points.max_m = {20.0, 1000.0, 300.0};
  points.min_m = {0.0, 1000.0, 0.0};
  points.file = "points.npy";
  scene::Scene scene = seen_at({{0, 0}});
  scene.clouds.emplace_back();
  scene.clouds[0].points = std::make_shared<const scene::CloudPoints>(std::move(points));
  scene.radars[0].transmit_antenna = by_points(flat, {{-9, -8}, {0, 0}, {9, -8}});
  const std::string words = said(survey(scene));
  EXPECT_NE(words.find("a point of cloud 1 at 16.7 deg"), std::string::npos) << words;
  scene::TargetTraits& traits = scene.clouds[0].traits;
  traits.reflectivity = scene::TargetTraits::Reflectivity::directional;
  traits.azimuth = core::Angle::from_deg(180.0);
  traits.gain = scene::TargetTraits::Gain::user;
  traits.gain_db.part[0] = lines({{0, 0}, {10, -20}});
  scene.radars[0].transmit_antenna = {};
  const std::string of_curves = said(survey(scene));
  EXPECT_NE(of_curves.find("a point of cloud 1 at 16.7 deg, points from 0 to 10 deg"), std::string::npos) << of_curves;
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
