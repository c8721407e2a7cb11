#include "picture/echo/preview.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <complex>
#include <limits>
#include <span>
#include <thread>

#include <gtest/gtest.h>

#include "picture/echo/preview_test_scene.hpp"
#include "simulate/resolve/resolved.hpp"
#include "simulate/run/run.hpp"
#include "support/processor_time.hpp"

namespace sarsim::picture {
namespace preview_test {

using Kind = PreviewEvent::Kind;

// Waits for the outcome of one request.
PreviewEvent shown(const scene::Scene& scene, const EchoWindow& window, const PlotSize& size,
                   simulate::Engine engine = simulate::Engine::automatic) {
  PreviewEvent last;
  Preview preview([&](const PreviewEvent& event) { last = event; }, 3);
  preview.show({std::make_shared<const scene::Scene>(scene), window, size, engine, false});
  preview.wait();
  return last;
}

// What `sarsim run` saves for the window.
simulate::Plan saved_plan(scene::Scene scene, const scene::Simulation& simulation, simulate::Engine engine) {
  scene.simulations = {simulation};
  return simulate::make_plan(scene, 0, nullptr, engine);
}

struct Difference {
  std::size_t samples = 0;
  double largest = 0.0;  // over the largest magnitude of the recording
};

// Of a shown peak: from the nearest of the saved samples that it stands for, and in magnitude from the largest.
double off_peak(std::complex<double> peak, std::span<const std::complex<double>> saved) {
  double nearest = std::numeric_limits<double>::infinity();
  double largest = 0.0;
  for (const std::complex<double>& sample : saved) {
    nearest = std::min(nearest, std::abs(peak - sample));
    largest = std::max(largest, std::abs(sample));
  }
  return std::max(nearest, std::abs(std::abs(peak) - largest));
}

// Between what is shown and what is saved, where their samples coincide: every `finer`-th column that is shown.
Difference difference(const EchoMatrix& matrix, const simulate::Plan& saved, std::size_t finer) {
  const simulate::Recording recording = simulate::record(saved);
  const std::span<const std::complex<double>> samples(recording.samples);
  const simulate::SampleSelection& selection = matrix.places().selection;
  Difference d;
  for (std::size_t i = 0; i < matrix.rows(); ++i)
    for (std::size_t k = 0; k < matrix.columns(); ++k) {
      const std::size_t row = matrix.places().row[i] * saved.acquisition.reception.columns;
      if (selection.pick == simulate::SampleSelection::Pick::peak && finer == 1) {
        const simulate::IndexSpan span = selection.columns[k];
        const double off = off_peak(matrix.row(i)[k], samples.subspan(row + span.begin, span.end - span.begin));
        d.largest = std::max(d.largest, off / recording.report.maximum_v);
        ++d.samples;
        continue;
      }
      if (matrix.places().column[k] % finer != 0) continue;
      const std::size_t column = matrix.places().column[k] / finer;
      if (column >= saved.acquisition.reception.columns) continue;
      d.largest = std::max(d.largest, std::abs(matrix.row(i)[k] - samples[row + column]) / recording.report.maximum_v);
      ++d.samples;
    }
  return d;
}

scene::Scene with_pulse(scene::Radar::Pulse pulse) {
  scene::Scene scene = simulate::flight_scene();
  scene::Radar& radar = scene.radars[0];
  radar.pulse = pulse;
  radar.pulse_iq.part = {
      core::SampledFunction{core::Interpolation::cubic, {{0.0, 0.2}, {0.3, 1.0}, {0.6, -0.8}, {1.0, 0.1}}},
      core::SampledFunction{core::Interpolation::linear, {{0.0, 0.0}, {0.5, 0.7}, {1.0, -0.3}}}};
  if (pulse == scene::Radar::Pulse::mono) {
    radar.envelope = scene::Radar::Envelope::linear;
    radar.rise_s = radar.fall_s = 100e-9;
  }
  return scene;
}

constexpr std::array pulses{scene::Radar::Pulse::mono, scene::Radar::Pulse::chirp, scene::Radar::Pulse::user,
                            scene::Radar::Pulse::barker};
constexpr std::array processings{scene::Processing::raw, scene::Processing::matched_filter};

// Noise, jitter of platforms, positions, cross-sections and angles, motion, an antenna: every kind of random number.
TEST(Preview, ShowsTheSamplesThatAreSavedBitForBit) {
  for (const scene::Radar::Pulse pulse : pulses)
    for (const scene::Processing processing : processings)
      for (const simulate::Engine engine :
           {simulate::Engine::direct, simulate::Engine::spectral, simulate::Engine::reference})
        for (const EchoView& view : {EchoView{2100.0, 2700.0, -0.1, 0.1}, EchoView{2203.7, 2411.1, -0.0505, 0.0123}}) {
          EchoWindow window = flight_window(processing);
          set_view(window, view);
          window.recording.pulse_position = engine == simulate::Engine::direct
                                                ? scene::Simulation::PulsePosition::centre
                                                : scene::Simulation::PulsePosition::begin;
          const scene::Scene scene = with_pulse(pulse);
          const PreviewEvent event = shown(scene, window, {64, 48}, engine);
          ASSERT_EQ(event.kind, Kind::finished);
          const Difference d = difference(*event.matrix, saved_plan(scene, simulation_of(window, 20e6), engine), 1);
          EXPECT_EQ(d.samples, event.matrix->rows() * event.matrix->columns());
          EXPECT_EQ(d.largest, 0.0) << static_cast<int>(pulse) << static_cast<int>(engine);
          EXPECT_EQ(event.matrix->rows(), 48U);
          EXPECT_EQ(event.matrix->columns(), 64U);
        }
}

// Without noise, which a finer sampling has more of.
TEST(Preview, BeyondTheGridStillShowsTheSamplesThatAreSaved) {
  for (const scene::Radar::Pulse pulse : pulses)
    for (const simulate::Engine engine : {simulate::Engine::direct, simulate::Engine::spectral}) {
      scene::Scene scene = with_pulse(pulse);
      scene.radars[0].noise_temperature_k = 0.0;
      EchoWindow window = flight_window();
      const PreviewEvent event = shown(scene, window, {600, 40}, engine);
      ASSERT_EQ(event.kind, Kind::finished);
      const simulate::Plan saved = saved_plan(scene, simulation_of(window, 20e6), engine);
      ASSERT_EQ(saved.acquisition.reception.columns, 240U);
      ASSERT_EQ(event.matrix->plan().acquisition.reception.columns, 720U);
      const Difference d = difference(*event.matrix, saved, 3);
      EXPECT_GT(d.samples, 40U * 150U);
      EXPECT_LT(d.largest, 2.0 * scene.options.tolerance) << static_cast<int>(pulse);
    }
}

TEST(Preview, ShowsCompressedDataOfEitherEngineWithinTwiceTheTolerance) {
  const scene::Scene scene = simulate::flight_scene();
  const EchoWindow window = flight_window(scene::Processing::matched_filter);
  const PreviewEvent event = shown(scene, window, {100, 60}, simulate::Engine::spectral);
  ASSERT_EQ(event.kind, Kind::finished);
  const Difference d =
      difference(*event.matrix, saved_plan(scene, simulation_of(window, 20e6), simulate::Engine::direct), 1);
  EXPECT_LT(d.largest, 2.0 * scene.options.tolerance);
  EXPECT_GT(d.samples, 0U);
}

TEST(Preview, ShowsSyntheticRangeProfilesAndTheClassicProfile) {
  scene::Scene scene = simulate::flight_scene();
  scene::Radar& radar = scene.radars[0];
  radar.carrier = scene::Radar::Carrier::stepped;
  radar.carrier_step_hz = 1e6;
  radar.carrier_steps = 8;
  radar.pulses_per_step = 2;
  EchoWindow window = flight_window(scene::Processing::srp);
  window.sampling.rate_hz = 1e6;
  PreviewEvent event = shown(scene, window, {30, 5}, simulate::Engine::direct);
  ASSERT_EQ(event.kind, Kind::finished);
  EXPECT_EQ(
      difference(*event.matrix, saved_plan(scene, simulation_of(window, 20e6), simulate::Engine::direct), 1).largest,
      0.0);
  scene.options.profile = scene::Profile::classic;
  for (const scene::Processing processing : processings) {
    window = flight_window(processing);
    event = shown(scene, window, {50, 20}, simulate::Engine::direct);
    ASSERT_EQ(event.kind, Kind::finished);
    EXPECT_EQ(
        difference(*event.matrix, saved_plan(scene, simulation_of(window, 20e6), simulate::Engine::direct), 1).largest,
        0.0);
  }
}

TEST(Preview, ShowsOneSamplePerPixelWhereTheScreenSetsTheSampling) {
  EchoWindow window = flight_window();
  window.sampling.kind = Sampling::Kind::screen;
  const PreviewEvent event = shown(simulate::flight_scene(), window, {333, 20});
  ASSERT_EQ(event.kind, Kind::finished);
  EXPECT_EQ(event.matrix->plan().acquisition.reception.columns, 333U);
  for (std::size_t x = 0; x < 333; ++x) {
    EXPECT_EQ(event.matrix->places().column_of_pixel[x], x);
    EXPECT_NEAR(event.matrix->range_m(x), range_at(view_of(window), {333, 20}, static_cast<double>(x)), 1e-6);
  }
}

TEST(Preview, CoversTheWindowWithACoarsePictureFirst) {
  EchoWindow window = flight_window();
  std::vector<std::size_t> ready;
  bool rows_known = true;
  std::vector<Kind> kinds;
  Preview preview(
      [&](const PreviewEvent& event) {
        kinds.push_back(event.kind);
        if (event.kind != Kind::rows) return;
        ready.push_back(event.matrix->ready_rows());
        const auto nearest = event.matrix->nearest_ready();
        for (std::size_t r = 0; r < nearest.size(); ++r) {
          rows_known &= event.matrix->ready(nearest[r]);
          const std::size_t apart = std::max(r, nearest[r]) - std::min(r, nearest[r]);
          rows_known &= apart <= 4 * event.matrix->rows() / ready.back();
        }
      },
      1);
  preview.show({std::make_shared<const scene::Scene>(simulate::flight_scene()),
                window,
                {64, 200},
                simulate::Engine::reference,
                false});
  preview.wait();
  ASSERT_GE(kinds.size(), 3U);
  EXPECT_EQ(kinds.front(), Kind::started);
  EXPECT_EQ(kinds.back(), Kind::finished);
  ASSERT_FALSE(ready.empty());
  EXPECT_GE(ready.front(), 4U);
  EXPECT_LE(ready.front(), 16U);
  EXPECT_TRUE(rows_known);
}

TEST(Preview, TellsNothingAboutARequestThatWasReplaced) {
  std::atomic<std::uint64_t> newest{0};
  std::atomic<int> outdated{0};
  std::atomic<std::uint64_t> finished{0};
  Preview preview([&](const PreviewEvent& event) {
    if (event.request < newest) ++outdated;
    if (event.kind == Kind::finished) finished = event.request;
  });
  const auto scene = std::make_shared<const scene::Scene>(simulate::flight_scene());
  EchoWindow window = flight_window();
  for (int i = 0; i < 40; ++i) {
    window.recording.range_end_m += 1.0;
    newest = preview.show({scene, window, {64, 200}, simulate::Engine::reference, false});
    if (i % 8 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  preview.wait();
  EXPECT_EQ(outdated, 0);
  EXPECT_EQ(finished, newest);
}

// While the listener is held up, a second thread comes with news about the same request, which is then replaced.
TEST(Preview, TellsNoNewsThatWaitedWhileTheirRequestWasReplaced) {
  using std::chrono::milliseconds;
  std::atomic<bool> held_up{false};
  std::atomic<bool> replaced{false};
  std::atomic<int> outdated{0};
  Preview preview(
      [&](const PreviewEvent& event) {
        if (event.request != 1) return;
        if (replaced) ++outdated;
        if (event.kind != Kind::rows || held_up.exchange(true)) return;
        std::this_thread::sleep_for(milliseconds(150));
      },
      2);
  scene::Scene scene = simulate::flight_scene();
  scene.targets.resize(2000, scene.targets[0]);
  const auto shared = std::make_shared<const scene::Scene>(scene);
  preview.show({shared, flight_window(), {64, 200}, simulate::Engine::reference, false});
  while (!held_up) std::this_thread::sleep_for(milliseconds(1));
  std::this_thread::sleep_for(milliseconds(80));
  replaced = true;
  preview.show({std::make_shared<const scene::Scene>(simulate::flight_scene()),
                flight_window(),
                {4, 4},
                simulate::Engine::direct,
                false});
  preview.wait();
  EXPECT_EQ(outdated, 0);
}

TEST(Preview, FollowsTheSceneAndKeepsNothingOfTheOneBefore) {
  std::shared_ptr<const EchoMatrix> matrix;
  Preview preview([&](const PreviewEvent& event) { matrix = event.matrix; });
  scene::Scene scene = simulate::flight_scene();
  const EchoWindow window = flight_window();
  preview.show({std::make_shared<const scene::Scene>(scene), window, {64, 48}, simulate::Engine::direct, false});
  preview.wait();
  ASSERT_TRUE(matrix && matrix->complete());
  const auto before = matrix;
  scene.targets[5].position_m.y += 3.0;
  preview.show({std::make_shared<const scene::Scene>(scene), window, {64, 48}, simulate::Engine::direct, false});
  preview.wait();
  ASSERT_TRUE(matrix && matrix->complete());
  EXPECT_NE(matrix, before);
  EXPECT_EQ(difference(*matrix, saved_plan(scene, simulation_of(window, 20e6), simulate::Engine::direct), 1).largest,
            0.0);
  EXPECT_GT(difference(*before, saved_plan(scene, simulation_of(window, 20e6), simulate::Engine::direct), 1).largest,
            0.01);
}

// What threads are at when the word comes: a tenth of a second of each processor at most.
TEST(Preview, IsCancelledWithinATenthOfASecond) {
  scene::Scene scene = simulate::flight_scene();
  scene.targets.resize(20000, scene.targets[0]);
  scene.radars[0].pulse_width_s = 3e-6;
  std::atomic<int> events{0};
  Preview preview([&](const PreviewEvent& event) { events += event.kind == Kind::rows ? 1 : 0; });
  const auto shared = std::make_shared<const scene::Scene>(scene);
  double least_s = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 5; ++i) {
    events = 0;
    preview.show({shared, flight_window(), {400, 200}, simulate::Engine::spectral, false});
    while (events == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    const sarsim::test::ProcessorTime time;
    preview.cancel();
    const int before = events;
    preview.wait();
    least_s = std::min(least_s, time.seconds());
    EXPECT_EQ(events, before);
  }
  EXPECT_LT(least_s, 0.1 * std::max(1U, std::thread::hardware_concurrency()));
}

TEST(Preview, ShowsNothingInAWindowWithoutPixels) {
  const PreviewEvent event = shown(simulate::flight_scene(), flight_window(), {0, 0});
  ASSERT_EQ(event.kind, Kind::finished);
  EXPECT_EQ(event.matrix->rows(), 1U);
  EXPECT_EQ(event.matrix->columns(), 1U);
}

TEST(Preview, FindsTheRangesOfAllTargetsWhereAskedTo) {
  PreviewEvent last;
  Preview preview([&](const PreviewEvent& event) { last = event; });
  EchoWindow window = flight_window();
  window.sampling.kind = Sampling::Kind::screen;
  set_view(window, {0.0, 0.0, 0.0, 0.01});
  preview.show({std::make_shared<const scene::Scene>(simulate::flight_scene()),
                window,
                {100, 50},
                simulate::Engine::automatic,
                true});
  preview.wait();
  ASSERT_EQ(last.kind, Kind::finished);
  const EchoView view = view_of(last.matrix->window());
  // Distances from 2236 m on, two pulses of 150 m before and behind.
  EXPECT_NEAR(view.range_start_m, 2236.0 - 300.0, 5.0);
  EXPECT_GT(view.range_end_m, 2290.0 + 300.0 - 5.0);
  EXPECT_LT(view.range_end_m, 2320.0 + 300.0);
}

TEST(Preview, SaysWhyThereIsNothingToShow) {
  scene::Scene scene = simulate::flight_scene();
  EchoWindow window = flight_window();
  window.recording.radar = "Nobody";
  PreviewEvent event = shown(scene, window, {10, 10});
  ASSERT_EQ(event.kind, Kind::failed);
  EXPECT_NE(event.problems.at(0).message.find("'Nobody' is not defined"), std::string::npos);

  window = flight_window();
  set_view(window, {2100.0, 2700.0, 0.0001, 0.0002});
  event = shown(scene, window, {10, 10});
  ASSERT_EQ(event.kind, Kind::failed);
  EXPECT_NE(event.problems.at(0).message.find("no pulse is sent"), std::string::npos);

  scene.targets[0].rcs_m2 = std::nan("");
  event = shown(scene, flight_window(), {10, 10});
  ASSERT_EQ(event.kind, Kind::failed);
  EXPECT_EQ(event.problems.at(0).subject.kind, "target");

  scene = simulate::flight_scene();
  scene.targets[0].platform = "Plane";
  scene.targets[0].position_m = {};  // at the radar's own place
  event = shown(scene, flight_window(), {10, 10}, simulate::Engine::direct);
  ASSERT_EQ(event.kind, Kind::failed);
  EXPECT_EQ(event.problems.at(0).subject.kind, "target");
}

TEST(Preview, IsNotHeldUpByMistakesElsewhere) {
  scene::Scene scene = simulate::flight_scene();
  scene.radars.push_back(scene.radars[0]);
  scene.radars[1].name = "Broken";
  scene.radars[1].prf_hz = -1.0;
  scene.simulations.push_back({});  // without radar, window and sampling
  const PreviewEvent event = shown(scene, flight_window(), {10, 10});
  EXPECT_EQ(event.kind, Kind::finished);
}

TEST(Preview, OfAVeryLongRowOfRawDataIsSampledByTheScreen) {
  EchoWindow window = flight_window();
  window.sampling.rate_hz = 1e12;  // four million samples
  const PreviewEvent event = shown(simulate::flight_scene(), window, {64, 3});
  ASSERT_EQ(event.kind, Kind::finished);
  EXPECT_EQ(event.matrix->plan().acquisition.reception.columns, 64U);
}

TEST(PlanShown, HasVeryLongRowsWhereTheyAreToBeComputed) {
  const scene::Scene scene = simulate::flight_scene();
  const auto resolved = std::make_shared<const simulate::ResolvedScene>(simulate::resolve(scene));
  EchoWindow window = flight_window();
  window.sampling.rate_hz = 5e11;
  const auto columns = [&](LongRows long_rows) {
    const ShownPlan shown = plan_shown(scene, resolved, window, {64, 3}, simulate::Engine::direct, long_rows);
    return shown.plan ? shown.plan->acquisition.reception.columns : 0;
  };
  EXPECT_EQ(columns(LongRows::by_screen), 64U);
  // 2 x 5e11 Hz x 600 m / c
  EXPECT_NEAR(static_cast<double>(columns(LongRows::computed)), 2001384.0, 2.0);
  window.sampling.rate_hz = 5e12;
  const ShownPlan shown = plan_shown(scene, resolved, window, {64, 3}, simulate::Engine::direct, LongRows::computed);
  EXPECT_EQ(shown.plan, nullptr);
  ASSERT_EQ(shown.problems.size(), 1U);
  EXPECT_EQ(shown.problems[0].subject.field, "range_end_m");
}

TEST(SamplePlaces, AreThePulsesNearestInTimeAlsoForStaggeredIntervals) {
  scene::Scene scene = simulate::flight_scene();
  scene.radars[0].repetition = scene::Radar::Repetition::user;
  scene.radars[0].pri_s.part[0].knots = {{0.0, 1e-3}, {1.0, 5e-3}, {2.0, 2e-3}};
  scene.simulations = {simulation_of(flight_window(), 20e6)};
  const simulate::Plan plan = simulate::make_plan(scene, 0);
  for (const std::size_t height : {7U, 30U, 75U, 400U}) {
    const PlotSize size{16, height};
    const SamplePlaces places = place_samples(plan, size, PixelRule::sample);
    for (std::size_t y = 0; y < height; ++y) {
      const double time = time_at({2100.0, 2700.0, -0.1, 0.1}, size, static_cast<double>(y));
      const auto off = [&](std::size_t row) {
        return std::abs(plan.acquisition.link.repetition.send_time_s(plan.acquisition.timing.first_pulse_of_row(row)) -
                        time);
      };
      const double shown_off = off(places.row[places.row_of_pixel[y]]);
      for (std::size_t r = 0; r < plan.acquisition.timing.rows; ++r)
        EXPECT_LE(shown_off, off(r) + 1e-12) << y << " " << r;
    }
  }
}

TEST(SamplePlaces, HoldEveryPulseWhereThereAreFewerThanPixelRows) {
  scene::Scene scene = simulate::flight_scene();
  EchoWindow window = flight_window();
  set_view(window, {2100.0, 2700.0, 0.0, 0.0091});  // 10 pulses, the last one before the end
  scene.simulations = {simulation_of(window, 20e6)};
  const SamplePlaces places = place_samples(simulate::make_plan(scene, 0), {16, 100}, PixelRule::sample);
  EXPECT_EQ(places.row.size(), 10U);
  EXPECT_EQ(places.row_of_pixel.back(), 0U);  // time runs upwards
  EXPECT_EQ(places.row_of_pixel.front(), 9U);
}

TEST(SamplePlaces, OfPeaksHoldEverySampleOfTheRecordingOnce) {
  scene::Scene scene = simulate::flight_scene();
  scene.simulations = {simulation_of(flight_window(), 20e6)};
  const simulate::Plan plan = simulate::make_plan(scene, 0);
  const SamplePlaces places = place_samples(plan, {37, 23}, PixelRule::peak);
  const auto covers = [](const std::vector<simulate::IndexSpan>& spans, std::size_t count) {
    std::size_t next = 0;
    for (const simulate::IndexSpan& span : spans) {
      EXPECT_EQ(span.begin, next);
      EXPECT_LT(span.begin, span.end);
      next = span.end;
    }
    EXPECT_EQ(next, count);
  };
  covers(places.selection.rows, plan.acquisition.timing.rows);
  covers(places.selection.columns, plan.acquisition.reception.columns);
  EXPECT_EQ(places.selection.pick, simulate::SampleSelection::Pick::peak);
  const auto nearest = [](const std::vector<std::size_t>& element, const std::vector<simulate::IndexSpan>& spans) {
    for (std::size_t i = 0; i < element.size(); ++i)
      for (std::size_t e = spans[i].begin; e < spans[i].end; ++e) {
        const auto off = [&](std::size_t k) { return std::max(element[k], e) - std::min(element[k], e); };
        EXPECT_LE(off(i), off(i > 0 ? i - 1 : i));
        EXPECT_LE(off(i), off(std::min(i + 1, element.size() - 1)));
      }
  };
  nearest(places.row, places.selection.rows);
  nearest(places.column, places.selection.columns);
}

// A target's peak may be a single sample wide, which one sample in so many would leave out.
TEST(SamplePlaces, OfCompressedDataHoldEverySampleOfAPulse) {
  scene::Scene scene = simulate::flight_scene();
  scene.simulations = {simulation_of(flight_window(scene::Processing::matched_filter), 20e6)};
  const simulate::Plan plan = simulate::make_plan(scene, 0);
  const SamplePlaces places = place_samples(plan, {37, 23}, PixelRule::sample);
  EXPECT_EQ(places.selection.pick, simulate::SampleSelection::Pick::peak);
  std::size_t next = 0;
  for (const simulate::IndexSpan& span : places.selection.columns) {
    EXPECT_EQ(span.begin, next);
    next = span.end;
  }
  EXPECT_EQ(next, plan.acquisition.reception.columns);
  for (const simulate::IndexSpan& span : places.selection.rows) EXPECT_EQ(span.end, span.begin + 1);
}

TEST(Preview, ShowsThePeakOfACompressedTargetOnFewPixels) {
  scene::Scene scene = simulate::flight_scene();
  scene.radars[0].noise_temperature_k = 0.0;
  EchoWindow window = flight_window(scene::Processing::matched_filter);
  const simulate::Plan plan = saved_plan(scene, simulation_of(window, 20e6), simulate::Engine::reference);
  const PreviewEvent event = shown(scene, window, {20, 400}, simulate::Engine::reference);
  ASSERT_EQ(event.kind, Kind::finished);
  double largest_v = 0.0;
  for (std::size_t i = 0; i < event.matrix->rows(); ++i)
    largest_v = std::max(largest_v, event.matrix->row_statistics(i).largest_v);
  EXPECT_DOUBLE_EQ(largest_v, simulate::record(plan).report.maximum_v);
}

TEST(SampleRoom, IsUsedAgainByTheNextMatrix) {
  SampleRoom room;
  std::vector<std::complex<double>> samples = room.take(1000);
  const auto* place = samples.data();
  room.give_back(std::move(samples));
  samples = room.take(900);
  EXPECT_EQ(samples.data(), place);
  EXPECT_EQ(samples.size(), 900U);
}

TEST(EchoMatrix, ShowsTheNearestRowThatIsReady) {
  scene::Scene scene = simulate::flight_scene();
  scene.simulations = {simulation_of(flight_window(), 20e6)};
  const auto plan = std::make_shared<const simulate::Plan>(simulate::make_plan(scene, 0));
  EchoMatrix matrix(plan, flight_window(), {16, 9});
  EXPECT_TRUE(matrix.nearest_ready().empty());
  matrix.set_ready(2);
  matrix.set_ready(7);
  EXPECT_EQ(matrix.ready_rows(), 2U);
  EXPECT_FALSE(matrix.complete());
  EXPECT_EQ(matrix.nearest_ready(), (std::vector<std::size_t>{2, 2, 2, 2, 2, 7, 7, 7, 7}));
  EXPECT_EQ(matrix.pulse(0), -100);
  EXPECT_NEAR(matrix.time_s(8), 0.1, 1e-12);
  EXPECT_EQ(matrix.carrier_hz(3), 5e9);
}

}  // namespace preview_test
}  // namespace sarsim::picture
