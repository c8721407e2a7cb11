#include "simulate/run/sampled_rows.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>
#include <set>
#include <thread>

#include <gtest/gtest.h>

#include "simulate/plan/simulate_test_scene.hpp"
#include "simulate/resolve/impossible_echo.hpp"

namespace sarsim::simulate {
namespace sampled_rows_test {

using Samples = std::vector<std::complex<double>>;

// Thesis A.2 with noise, a moving target and 40 pulses.
scene::Scene noisy_scene() {
  scene::Scene scene = one_target_scene();
  scene.platforms.push_back(moving("Car", {500.0, 0.0, 0.0}, {30.0, 10.0, 0.0}));
  scene.targets.push_back(target_on("Car", {0.0, 0.0, 0.0}));
  scene.radars[0].noise_temperature_k = 1e6;
  scene.simulations[0].time_end_s = 0.039;
  return scene;
}

SampleSelection every_nth(const Plan& plan, std::size_t row_step, std::size_t column_step) {
  SampleSelection selection;
  for (std::size_t r = 0; r < plan.acquisition.timing.rows; r += row_step)
    selection.rows.push_back({r, std::min(r + row_step, plan.acquisition.timing.rows)});
  for (std::size_t c = 0; c < plan.acquisition.reception.columns; c += column_step)
    selection.columns.push_back({c, std::min(c + column_step, plan.acquisition.reception.columns)});
  return selection;
}

Samples sampled(const Plan& plan, const SampleSelection& selection, unsigned threads) {
  Samples out(selection.rows.size() * selection.columns.size(), std::nan(""));
  compute_sampled_rows(plan, selection, refinement_order(selection.rows.size()), {threads, nullptr}, out, {});
  return out;
}

TEST(SampledRows, AreTheSamplesOfTheRecordingBitForBit) {
  const scene::Scene scene = noisy_scene();
  for (const Engine engine : {Engine::reference, Engine::direct, Engine::spectral}) {
    const Plan plan = make_plan(scene, 0, nullptr, engine);
    const Samples all = record(plan).samples;
    const SampleSelection selection = every_nth(plan, 3, 7);
    const Samples some = sampled(plan, selection, 3);
    for (std::size_t i = 0; i < selection.rows.size(); ++i)
      for (std::size_t k = 0; k < selection.columns.size(); ++k)
        EXPECT_EQ(some[i * selection.columns.size() + k], all[3 * i * plan.acquisition.reception.columns + 7 * k])
            << i << " " << k;
  }
}

TEST(SampledRows, PeaksAreTheLargestSamplesOfTheirRowsAndColumns) {
  const Plan plan = make_plan(noisy_scene(), 0, nullptr, Engine::direct);
  const Samples all = record(plan).samples;
  SampleSelection selection = every_nth(plan, 3, 7);
  selection.pick = SampleSelection::Pick::peak;
  const Samples peaks = sampled(plan, selection, 2);
  for (std::size_t i = 0; i < selection.rows.size(); ++i)
    for (std::size_t k = 0; k < selection.columns.size(); ++k) {
      double largest = 0.0;
      for (std::size_t r = selection.rows[i].begin; r < selection.rows[i].end; ++r)
        for (std::size_t c = selection.columns[k].begin; c < selection.columns[k].end; ++c)
          largest = std::max(largest, std::abs(all[r * plan.acquisition.reception.columns + c]));
      EXPECT_EQ(std::abs(peaks[i * selection.columns.size() + k]), largest) << i << " " << k;
    }
}

TEST(SampledRows, AreTheSameOnAnyNumberOfThreadsAndWriteOnlyWhatIsAsked) {
  const Plan plan = make_plan(noisy_scene(), 0, nullptr, Engine::spectral);
  const SampleSelection selection = every_nth(plan, 1, 1);
  EXPECT_EQ(sampled(plan, selection, 1), sampled(plan, selection, 5));
  Samples out(plan.acquisition.timing.rows * plan.acquisition.reception.columns, {7.0, 7.0});
  const std::vector<std::size_t> order{4};
  compute_sampled_rows(plan, selection, order, {2, nullptr}, out, {});
  EXPECT_EQ(out[3 * plan.acquisition.reception.columns], std::complex(7.0, 7.0));
  EXPECT_NE(out[4 * plan.acquisition.reception.columns], std::complex(7.0, 7.0));
  EXPECT_EQ(out[5 * plan.acquisition.reception.columns], std::complex(7.0, 7.0));
}

TEST(SampledRows, TellAboutEveryRowOnceWhenItIsComplete) {
  const Plan plan = make_plan(noisy_scene(), 0, nullptr, Engine::direct);
  const SampleSelection selection = every_nth(plan, 1, 1);
  Samples out(plan.acquisition.timing.rows * plan.acquisition.reception.columns, std::nan(""));
  std::vector<std::atomic<int>> told(plan.acquisition.timing.rows);
  std::atomic<bool> incomplete{false};
  compute_sampled_rows(plan, selection, refinement_order(plan.acquisition.timing.rows), {3, nullptr}, out,
                       [&](std::size_t row) {
                         ++told[row];
                         if (std::isnan(out[(row + 1) * plan.acquisition.reception.columns - 1].real()))
                           incomplete = true;
                       });
  EXPECT_FALSE(incomplete);
  for (const auto& count : told) EXPECT_EQ(count, 1);
}

TEST(SampledRows, EndWhenAskedTo) {
  const Plan plan = make_plan(noisy_scene(), 0, nullptr, Engine::direct);
  const SampleSelection selection = every_nth(plan, 1, 1);
  Samples out(plan.acquisition.timing.rows * plan.acquisition.reception.columns);
  core::StopFlag stop;
  std::atomic<int> rows{0};
  EXPECT_THROW(compute_sampled_rows(plan, selection, refinement_order(plan.acquisition.timing.rows), {2, &stop}, out,
                                    [&](std::size_t) {
                                      ++rows;
                                      stop.request();
                                    }),
               core::Interrupted);
  EXPECT_LE(rows, 2);
}

TEST(SampledRows, EndWithinAPeakOfManyPulses) {
  const Plan plan = make_plan(noisy_scene(), 0, nullptr, Engine::direct);
  SampleSelection selection = every_nth(plan, plan.acquisition.timing.rows, 1);
  selection.pick = SampleSelection::Pick::peak;
  core::StopFlag stop;
  SampledRowMaker maker(plan, selection, &stop);
  stop.request();
  Samples out(plan.acquisition.reception.columns);
  EXPECT_THROW(maker.make_row(0, out), core::Interrupted);
}

TEST(SampledRows, PassOnWhatAThreadThrows) {
  scene::Scene scene = noisy_scene();
  scene.targets.push_back(target_on("Earth", {0.0, 0.0, 0.0}));  // at the radar
  const Plan plan = make_plan(scene, 0, nullptr, Engine::direct);
  const SampleSelection selection = every_nth(plan, 1, 1);
  Samples out(plan.acquisition.timing.rows * plan.acquisition.reception.columns);
  EXPECT_THROW(
      compute_sampled_rows(plan, selection, refinement_order(plan.acquisition.timing.rows), {2, nullptr}, out, {}),
      ImpossibleEcho);
}

TEST(RefinementOrder, HoldsEveryNumberOnce) {
  for (const std::size_t count : {0U, 1U, 2U, 3U, 7U, 8U, 1000U}) {
    auto order = refinement_order(count);
    std::ranges::sort(order);
    std::vector<std::size_t> numbers(count);
    std::iota(numbers.begin(), numbers.end(), std::size_t{0});
    EXPECT_EQ(order, numbers);
  }
}

TEST(RefinementOrder, EveryBeginningCoversTheWhole) {
  const std::size_t count = 1000;
  const auto order = refinement_order(count);
  std::set<std::size_t> known;
  for (std::size_t n = 0; n < count; ++n) {
    known.insert(order[n]);
    std::size_t before = 0;
    std::size_t widest = 0;
    for (const std::size_t row : known) {
      widest = std::max(widest, row - before);
      before = row;
    }
    widest = std::max(widest, count - before);
    EXPECT_LE(widest, 4 * count / (n + 1) + 1) << n;
  }
}

}  // namespace sampled_rows_test
}  // namespace sarsim::simulate
