#include "simulate/plan/row_maker.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

#include "core/report/expect.hpp"
#include "simulate/plan/simulate_test_scene.hpp"
#include "simulate/resolve/impossible_echo.hpp"

namespace sarsim::simulate {
namespace row_maker_test {

using Row = std::vector<std::complex<double>>;

// 20 pulses of a target that flies away at 300 m/s.
scene::Scene receding_target() {
  scene::Scene scene = one_target_scene();
  scene.platforms.push_back(moving("Aircraft", {700.0, 0.0, 0.0}, {300.0, 0.0, 0.0}));
  scene.targets[0] = target_on("Aircraft", {});
  scene.radars[0].prf_hz = 10.0;
  scene.simulations[0].time_end_s = 1.95;
  return scene;
}

// Rows made one over the other are those made into fresh rows, and 0 outside of the samples that are said.
void expect_rows_again_and_again(const scene::Scene& scene, Engine engine, bool sparse) {
  const Plan plan = make_plan(scene, 0, nullptr, engine);
  RowMaker maker(plan);
  RowMaker fresh_maker(plan);
  Row row(plan.acquisition.reception.columns);
  radar::SampleSpan filled;
  for (std::size_t r = 0; r < plan.acquisition.timing.rows; ++r) {
    filled = maker.make_row(r, row, filled);
    Row fresh(plan.acquisition.reception.columns, {7.0, 7.0});
    fresh_maker.make_row(r, fresh);
    EXPECT_EQ(row, fresh) << r;
    ASSERT_LE(filled.end, row.size());
    EXPECT_EQ(filled.end - filled.begin < row.size(), sparse);
    EXPECT_EQ(std::count(row.begin(), row.begin() + static_cast<std::ptrdiff_t>(filled.begin), 0.0),
              static_cast<std::ptrdiff_t>(filled.begin));
    EXPECT_EQ(std::count(row.begin() + static_cast<std::ptrdiff_t>(filled.end), row.end(), 0.0),
              static_cast<std::ptrdiff_t>(row.size() - filled.end));
  }
}

TEST(RowMaker, SaysWhereARowIsZeroAndClearsWhatTheLastOneLeft) {
  scene::Scene scene = receding_target();
  for (const Engine engine : {Engine::direct, Engine::reference})
    expect_rows_again_and_again(scene, engine, engine == Engine::direct);
  scene.radars[0].pulse = scene::Radar::Pulse::chirp;
  scene.radars[0].bandwidth_hz = 1e6;
  expect_rows_again_and_again(scene, Engine::direct, true);
}

TEST(RowMaker, FillsTheWholeRowWithNoise) {
  scene::Scene scene = receding_target();
  scene.radars[0].noise_temperature_k = 300.0;
  expect_rows_again_and_again(scene, Engine::direct, false);
}

// More points than are worked on at a time, the last of them with speeds of their own.
scene::Scene crowd(std::size_t extra) {
  scene::Scene scene = receding_target();
  scene.radars[0].pulse = scene::Radar::Pulse::chirp;
  scene.radars[0].bandwidth_hz = 1e6;
  scene.targets.clear();
  const std::size_t count = points_at_once + extra;
  for (std::size_t k = 0; k < count; ++k)
    scene.targets.push_back(
        target_on(k + 50 < count ? "Earth" : "Aircraft",
                  {1000.0 + 0.01 * static_cast<double>(k % 100'000), 0.3 * static_cast<double>(k % 7), 0.0}));
  return scene;
}

double difference(const Plan& a, const Plan& b, std::size_t row) {
  Row of_a(a.acquisition.reception.columns), of_b(b.acquisition.reception.columns);
  RowMaker(a).make_row(row, of_a);
  RowMaker(b).make_row(row, of_b);
  double difference2 = 0.0, sum2 = 0.0;
  for (std::size_t i = 0; i < of_a.size(); ++i) {
    difference2 += std::norm(of_a[i] - of_b[i]);
    sum2 += std::norm(of_b[i]);
  }
  EXPECT_GT(sum2, 0.0);
  return std::sqrt(difference2 / sum2);
}

TEST(RowMaker, TakesMorePointsThanItHoldsAtATime) {
  scene::Scene scene = crowd(60);
  for (const auto echoes : {scene::AmbiguousEchoes::none, scene::AmbiguousEchoes::all})
    for (const auto processing : {scene::Processing::raw, scene::Processing::matched_filter}) {
      scene.options.ambiguous_echoes = echoes;
      scene.radars[0].prf_hz = echoes == scene::AmbiguousEchoes::all ? 20e3 : 10.0;
      scene.simulations[0].time_end_s = 4.5 / scene.radars[0].prf_hz;
      scene.simulations[0].processing = processing;
      const Plan fast = make_plan(scene, 0, nullptr, Engine::spectral);
      EXPECT_LT(difference(fast, make_plan(scene, 0, nullptr, Engine::reference), 2), 1e-5);
    }
}

TEST(RowMaker, NamesAnImpossibleEchoBehindWhatItHoldsAtATime) {
  scene::Scene scene = crowd(60);
  scene.targets.back() = target_on("Earth", {0.0, 0.0, 0.0});
  const Plan plan = make_plan(scene, 0, nullptr, Engine::spectral);
  Row row(plan.acquisition.reception.columns);
  EXPECT_THROW(RowMaker(plan).make_row(0, row), ImpossibleEcho);
}

TEST(RowMaker, ExpectsAStaleSpanWithinTheRow) {
  if (!core::checks_expectations()) GTEST_SKIP() << "this build does not check expectations";
  const Plan plan = make_plan(one_target_scene(), 0);
  RowMaker maker(plan);
  Row row(plan.acquisition.reception.columns);
  EXPECT_THROW(maker.make_row(0, row, {0, row.size() + 1}), core::BrokenExpectation);
  EXPECT_THROW(maker.make_row(0, row, {2, 1}), core::BrokenExpectation);
}

}  // namespace row_maker_test
}  // namespace sarsim::simulate
