#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <initializer_list>
#include <string>

#include "core/report/problem.hpp"
#include "scene/check/check.hpp"
#include "scene/model/scene.hpp"

/// Support for the tests of `check`: a scene without any problem, to be spoilt in one place at a time.
namespace sarsim::scene {

inline core::SampledFunction points(std::initializer_list<core::Knot> knots) {
  return {.method = core::Interpolation::linear, .knots = knots};
}

/// One object of each kind with values of a C-band SAR; `check` finds nothing in it.
inline Scene sound_scene() {
  Platform earth;
  Platform plane;
  plane.name = "Plane";
  plane.path = Platform::Path::trajectory;
  plane.trajectory_m.part = {points({{0.0, 100.0}, {1.0, -100.0}}), points({{0.0, -10e3}}), points({{0.0, 2e3}})};

  Radar radar;
  radar.platform = "Plane";
  radar.pulse = Radar::Pulse::chirp;
  radar.bandwidth_hz = 100e6;
  radar.pulse_width_s = 800e-9;
  radar.prf_hz = 300.0;
  radar.carrier_hz = 5.3e9;
  radar.transmit_antenna.pattern = Antenna::Pattern::sinx;
  radar.beam_elevation = core::Angle::from_deg(-11.3);

  Simulation simulation;
  simulation.radar = "Radar1";
  simulation.range_start_m = 10010.0;
  simulation.range_end_m = 10510.0;
  simulation.time_start_s = -0.5;
  simulation.time_end_s = 1.499;
  simulation.sample_rate_hz = 150e6;

  GeometryTable table;
  table.radar = "Radar1";

  Scene scene;
  scene.platforms = {earth, plane};
  scene.targets = {Target{}};
  scene.surfaces = {Surface{}};
  scene.radars = {radar};
  scene.simulations = {simulation};
  scene.geometries = {table};
  return scene;
}

/// Expects `check` to find exactly one problem, of this severity and about this field, and returns it.
inline core::Problem expect_single(const Scene& scene, core::Severity severity, const core::Subject& subject) {
  const core::Problems problems = check(scene);
  EXPECT_EQ(problems.size(), 1U) << (problems.empty() ? "nothing found" : core::to_string(problems.back()));
  if (problems.empty()) return {};
  const core::Problem& problem = problems.front();
  EXPECT_EQ(problem.severity, severity) << core::to_string(problem);
  EXPECT_EQ(problem.subject, subject) << problem.subject.kind << " " << problem.subject.index << " "
                                      << problem.subject.field << ": " << core::to_string(problem);
  EXPECT_FALSE(problem.id.name().empty());
  EXPECT_FALSE(problem.message.empty());
  EXPECT_TRUE(problem.place.file.empty() && problem.place.line == 0);
  return problem;
}

inline core::Problem expect_error(const Scene& scene, const core::Subject& subject) {
  core::Problem problem = expect_single(scene, core::Severity::error, subject);
  EXPECT_FALSE(problem.expected.empty()) << core::to_string(problem);
  return problem;
}

inline core::Problem expect_warning(const Scene& scene, const core::Subject& subject) {
  return expect_single(scene, core::Severity::warning, subject);
}

}  // namespace sarsim::scene
