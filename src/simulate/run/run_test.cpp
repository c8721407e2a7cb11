#include "simulate/run/run.hpp"
#include "scene/model/scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <complex>
#include <cstring>
#include <span>
#include <stdexcept>
#include <tuple>
#include <vector>

#include "core/maths/constants.hpp"
#include "core/report/expect.hpp"
#include "radar/receiver/converter.hpp"
#include "simulate/plan/row_maker.hpp"
#include "simulate/run/memory_sink.hpp"

namespace sarsim::simulate {
namespace run_test {

// Radar at the origin, one target on the x axis, one pulse at t = 0.
scene::Scene one_target(double distance_m) {
  scene::Scene scene;
  scene.platforms.push_back({});
  scene::Radar radar;
  radar.pulse_width_s = 5e-6;
  scene.radars.push_back(radar);
  scene::Target target;
  target.position_m = {distance_m, 0.0, 0.0};
  scene.targets.push_back(target);
  scene::Simulation simulation;
  simulation.radar = "Radar1";
  simulation.range_start_m = 0.0;
  simulation.range_end_m = 2000.0;
  simulation.time_end_s = 0.0;
  simulation.sample_rate_hz = 4e6;
  scene.simulations.push_back(simulation);
  return scene;
}

Recording recorded(const scene::Scene& scene, unsigned threads = 1) {
  raster::RunControl control;
  control.threads = threads;
  return record(make_plan(scene, 0), control);
}

double equation_amplitude(double distance_m, double rcs_m2, double wavelength_m) {
  return std::sqrt(1000.0 * wavelength_m * wavelength_m * rcs_m2 /
                   (std::pow(4.0 * core::pi, 3.0) * std::pow(distance_m, 4.0)));
}

TEST(Run, MonochromeEchoHasTheRadarEquationsAmplitudeAndTheTwoWayPhase) {
  const Recording sink = recorded(one_target(1000.0));
  const double wavelength_m = core::exact_light_speed_mps / 1e9;
  const std::complex<double> expected =
      std::polar(equation_amplitude(1000.0, 1.0, wavelength_m), -4.0 * core::pi * 1000.0 / wavelength_m);
  const double delay_samples = 2.0 * 1000.0 / core::exact_light_speed_mps * 4e6;
  ASSERT_EQ(sink.samples.size(), 53u);
  for (std::size_t i = 0; i < sink.samples.size(); ++i) {
    const bool on = static_cast<double>(i) >= delay_samples && static_cast<double>(i) < delay_samples + 20.0;
    EXPECT_LT(std::abs(sink.samples[i] - (on ? expected : 0.0)), 1e-9 * std::abs(expected)) << i;
  }
}

TEST(Run, SameSamplesForAnyNumberOfThreads) {
  scene::Scene scene = one_target(1000.0);
  scene.simulations[0].time_end_s = 2.0;
  scene.radars[0].noise_temperature_k = 300.0;
  const Recording one = recorded(scene, 1);
  for (const unsigned threads : {2u, 3u, 8u}) {
    const Recording many = recorded(scene, threads);
    EXPECT_EQ(many.samples, one.samples) << threads;
    EXPECT_EQ(many.report.maximum_v, one.report.maximum_v);
  }
}

// Records what a sink is told.
class SpySink : public raster::Sink {
 public:
  explicit SpySink(bool wants_counts) : wants_counts_(wants_counts) {}
  [[nodiscard]] bool wants_counts() const override { return wants_counts_; }
  [[nodiscard]] std::vector<std::byte> encode(const raster::Block& block) const override {
    EXPECT_EQ(block.volts.size(), block.rows * block.columns);
    EXPECT_EQ(block.counts.size(), wants_counts_ ? 2 * block.rows * block.columns : 0u);
    std::vector<std::byte> bytes(block.counts.size() * sizeof(std::int64_t));
    if (!bytes.empty()) std::memcpy(bytes.data(), block.counts.data(), bytes.size());
    return bytes;
  }
  void append(std::span<const std::byte> bytes, std::size_t first_row, std::size_t row_count) override {
    EXPECT_EQ(first_row, rows);
    EXPECT_FALSE(finished);
    rows += row_count;
    const std::size_t old = counts.size();
    counts.resize(old + bytes.size() / sizeof(std::int64_t));
    if (!bytes.empty()) std::memcpy(counts.data() + old, bytes.data(), bytes.size());
  }
  void finish(const raster::RunReport&) override { finished = true; }

  std::size_t rows = 0;
  std::vector<std::int64_t> counts;
  bool finished = false;

 private:
  bool wants_counts_;
};

raster::RunControl one_thread() {
  raster::RunControl control;
  control.threads = 1;
  return control;
}

TEST(Run, ASinkThatWantsCountsGetsTheConvertersOwn) {
  scene::Scene scene = one_target(1000.0);
  scene.radars[0].noise_temperature_k = 3e5;
  const Plan plan = make_plan(scene, 0);
  const double lsb_v = 1e-9;
  SpySink sink(true);
  const raster::RunReport report = run(plan, lsb_v, sink, one_thread());
  const Recording volts = recorded(scene);
  std::vector<std::int64_t> expected(2 * volts.samples.size());
  radar::ConversionTally tally;
  radar::Converter{8, lsb_v}.convert(volts.samples, expected, tally);
  EXPECT_EQ(sink.counts, expected);
  EXPECT_TRUE(sink.finished);
  EXPECT_EQ(report.saturated, tally.saturated);
  EXPECT_EQ(report.zero, tally.zero);
  EXPECT_GT(report.saturated, 0u);
  EXPECT_EQ(report.maximum_v, tally.maximum_v);
  EXPECT_EQ(report.lsb_v, lsb_v);
  EXPECT_EQ(report.best_lsb_v, report.maximum_v / 127.0);
  EXPECT_EQ(report.range_used, report.maximum_v / (lsb_v * 127.0));
  EXPECT_EQ(report.rows, 1u);
  EXPECT_EQ(report.columns, 53u);
}

TEST(Run, AnLsbOfZeroIsTheLargestMagnitudeOverTheFullScale) {
  scene::Scene scene = one_target(1000.0);
  const Plan plan = make_plan(scene, 0);
  const double lsb_v = resolved_lsb_v(plan, one_thread());
  EXPECT_EQ(lsb_v, recorded(scene).report.maximum_v / 127.0);
  SpySink sink(true);
  const raster::RunReport report = run(plan, lsb_v, sink, one_thread());
  EXPECT_EQ(report.saturated, 0u);
  EXPECT_NEAR(report.range_used, 1.0, 1e-15);
  scene.simulations[0].lsb_v = 3e-9;
  EXPECT_EQ(resolved_lsb_v(make_plan(scene, 0), one_thread()), 3e-9);
  scene.simulations[0].lsb_v = 0.0;
  scene.targets.clear();
  EXPECT_EQ(resolved_lsb_v(make_plan(scene, 0), one_thread()), 1.0);  // silence
}

TEST(Run, ReportsProgressUpToTheLastRow) {
  scene::Scene scene = one_target(1000.0);
  scene.simulations[0].time_end_s = 3.0;
  std::vector<std::size_t> done;
  raster::RunControl control = one_thread();
  control.progress = [&](const core::Progress& p) {
    EXPECT_EQ(p.total, 3001u);
    EXPECT_EQ(p.columns, 53u);
    done.push_back(p.done);
  };
  (void)record(make_plan(scene, 0), control);
  ASSERT_GT(done.size(), 1u);
  EXPECT_TRUE(std::ranges::is_sorted(done));
  EXPECT_EQ(done.back(), 3001u);
}

TEST(Run, StopsWhenAskedAndLeavesTheSinkUnfinished) {
  scene::Scene scene = one_target(1000.0);
  scene.simulations[0].time_end_s = 100.0;
  core::StopFlag stop;
  raster::RunControl control = one_thread();
  control.stop = &stop;
  control.progress = [&](const core::Progress&) { stop.request(); };
  SpySink sink(false);
  EXPECT_THROW(run(make_plan(scene, 0), 0.0, sink, control), core::Interrupted);
  EXPECT_FALSE(sink.finished);
  EXPECT_LT(sink.rows, 10'000u);
}

TEST(Run, PassesOnWhatGoesWrongInARow) {
  scene::Scene scene = one_target(1000.0);
  scene.targets.push_back(scene::Target());
  EXPECT_THROW((void)record(make_plan(scene, 0), one_thread()), std::runtime_error);
}

// A recording with noise, of several pulses.
scene::Scene noisy_scene() {
  scene::Scene scene = one_target(1000.0);
  scene.radars[0].noise_temperature_k = 300.0;
  scene.simulations[0].time_end_s = 0.02;
  return scene;
}

TEST(RunRows, OfAnyDivisionAreTheRowsOfAWholeRun) {
  const Plan plan = make_plan(noisy_scene(), 0);
  ASSERT_EQ(plan.acquisition.timing.rows, 21U);
  const Recording whole = record(plan, {1, nullptr, {}});
  for (const std::size_t cut : {1U, 8U, 20U}) {
    Recording parts;
    MemorySink sink(parts);
    radar::ConversionTally tally;
    const auto take = [&](const raster::EncodedRows& block) {
      EXPECT_EQ(block.bytes.size(),
                block.rows.count * plan.acquisition.reception.columns * sizeof(std::complex<double>));
      sink.append(block.bytes, block.rows.first, block.rows.count);
      tally.add(block.tally);
    };
    run_rows(plan, {0, cut}, 0.0, sink, {1, nullptr, {}}, take);
    run_rows(plan, {cut, plan.acquisition.timing.rows - cut}, 0.0, sink, {3, nullptr, {}}, take);
    EXPECT_EQ(parts.samples, whole.samples);
    EXPECT_EQ(
        raster::report_of({plan.acquisition.timing.rows, plan.acquisition.reception.columns, 8}, 0.0, tally).maximum_v,
        whole.report.maximum_v);
  }
}

TEST(RunStored, ConvertsRowsAsTheRunThatComputesThem) {
  const Plan plan = make_plan(noisy_scene(), 0);
  const Recording whole = record(plan);
  const auto reader = [&] {
    return [&](std::size_t row, std::span<std::complex<double>> volts) {
      std::copy_n(whole.samples.begin() + static_cast<std::ptrdiff_t>(row * plan.acquisition.reception.columns),
                  plan.acquisition.reception.columns, volts.begin());
    };
  };
  const double lsb_v = resolved_lsb_v(plan, {});
  EXPECT_EQ(lsb_v, raster::lsb_of_maximum_v(whole.report.maximum_v, plan.acquisition.simulation.bits));
  Recording computed;
  Recording stored;
  MemorySink computed_sink(computed);
  MemorySink stored_sink(stored);
  const raster::RunReport a = run(plan, lsb_v, computed_sink, {});
  const raster::RunReport b = raster::run_stored(
      {plan.acquisition.timing.rows, plan.acquisition.reception.columns, plan.acquisition.simulation.bits}, reader,
      lsb_v, stored_sink, {});
  EXPECT_EQ(stored.samples, computed.samples);
  EXPECT_EQ(std::tie(a.maximum_v, a.lsb_v, a.range_used, a.saturated, a.zero),
            std::tie(b.maximum_v, b.lsb_v, b.range_used, b.saturated, b.zero));
}

TEST(Run, ExpectsRowsOfThePlanAndAnLsb) {
  if (!core::checks_expectations()) GTEST_SKIP() << "this build does not check expectations";
  const Plan plan = make_plan(one_target(1000.0), 0);
  std::vector<std::complex<double>> row(plan.acquisition.reception.columns);
  RowMaker maker(plan);
  EXPECT_THROW(maker.make_row(plan.acquisition.timing.rows, row), core::BrokenExpectation);
  EXPECT_THROW(maker.make_row(0, std::span(row).subspan(1)), core::BrokenExpectation);
  EXPECT_NO_THROW(maker.make_row(0, row));
}

}  // namespace run_test
}  // namespace sarsim::simulate
