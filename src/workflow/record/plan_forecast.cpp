#include "workflow/record/plan_forecast.hpp"

#include <algorithm>
#include <cmath>

#include "core/task/clock.hpp"
#include "core/task/parallel.hpp"
#include "workflow/record/record_size.hpp"

namespace sarsim::workflow {

namespace {

// Seconds of trials of all recordings of a script together, and at least of each.
constexpr double trial_s = 1.0;
constexpr double shortest_trial_s = 0.02;

RecordingForecast forecast_of(const SceneInput& input, std::size_t index, const TrialRules& rules,
                              const core::StopFlag* stop) {
  const double begin_s = core::now_s();
  const simulate::Plan plan =
      simulate::make_plan(input.scene, index, input.resolved, simulate::Engine::automatic, stop);
  RecordingForecast result;
  result.fixed_s = core::now_s() - begin_s;
  result.number = index + 1;
  result.simulation = plan.acquisition.simulation;
  result.engine = simulate::name_of(plan.engine.engine);
  result.rows = plan.acquisition.timing.rows;
  result.columns = plan.acquisition.reception.columns;
  const RecordingSize size = size_of(plan, rules.threads);
  result.echoes = size.echoes;
  result.memory_bytes = size.memory_bytes;
  result.bytes = size.bytes;
  result.twice = seeks_lsb(plan.acquisition.simulation);
  result.trial = try_plan(plan, rules, stop);
  return result;
}

template <class Value>
double sum_of(const std::vector<RecordingForecast>& recordings, const Value& value) {
  double total = 0.0;
  for (const RecordingForecast& recording : recordings) total += value(recording);
  return total;
}

}  // namespace

double RecordingForecast::seconds(unsigned workers) const {
  return fixed_s + seconds_of_rows(trial, std::ceil(static_cast<double>(rows) / workers), twice);
}

double PlanForecast::samples() const {
  return sum_of(recordings, [](const RecordingForecast& r) { return r.samples(); });
}

double PlanForecast::bytes() const {
  return sum_of(recordings, [](const RecordingForecast& r) { return r.bytes; });
}

double PlanForecast::memory_bytes() const {
  double most = 0.0;
  for (const RecordingForecast& r : recordings) most = std::max(most, r.memory_bytes);
  return most;
}

double PlanForecast::seconds(unsigned workers) const {
  return reading_s + sum_of(recordings, [&](const RecordingForecast& r) { return r.seconds(workers); });
}

double PlanForecast::times_as_fast(unsigned workers) const {
  return seconds(workers) > 0.0 ? seconds(1) / seconds(workers) : 1.0;
}

PlanForecast forecast_recordings(const PlanForecastRequest& request, const core::Observer& observer) {
  const core::WorkControl control = observer.control(core::thread_count(request.threads));
  const double begin_s = core::now_s();
  SceneInput input = read_scene(request.script, request.overrides, CheckLevel::echoes, control);
  expect_usable(input);
  observer.remarks(input.problems);
  resolve_once(input, control);
  PlanForecast forecast;
  forecast.threads = control.threads;
  forecast.reading_s = core::now_s() - begin_s;
  const double share = trial_s / static_cast<double>(std::max<std::size_t>(input.scene.simulations.size(), 1));
  const TrialRules rules{forecast.threads, std::max(share, shortest_trial_s), core::now_s};
  for (std::size_t i = 0; i < input.scene.simulations.size(); ++i)
    forecast.recordings.push_back(forecast_of(input, i, rules, observer.stop));
  return forecast;
}

}  // namespace sarsim::workflow
