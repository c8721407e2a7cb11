#include "cli/command/info_plan.hpp"

#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cli/shell/report.hpp"
#include "cli/shell/watch.hpp"
#include "core/build/version.hpp"
#include "core/text/facts.hpp"
#include "core/text/number_text.hpp"
#include "raster/table/formats.hpp"
#include "workflow/input/scene_words.hpp"
#include "workflow/record/plan_forecast.hpp"

namespace sarsim::cli {

namespace {

bool is_text(scene::FileFormat format) { return raster::format_of(format).is_text(); }

// 1, 2, 4 ... and the number that was asked for.
std::vector<unsigned> worker_counts(unsigned workers) {
  std::vector<unsigned> counts;
  for (unsigned count = 1; count < workers; count *= 2) counts.push_back(count);
  counts.push_back(workers);
  return counts;
}

std::string count_text(double value) {
  return value < 1e6 ? fmt::format("{:.0f}", value) : fmt::format("{:.4g}", value);
}

std::string trial_text(const workflow::RecordingForecast& r) {
  return fmt::format("{}, from a trial of {}{}", core::duration_text(r.seconds(1)), counted(r.trial.rows, "row"),
                     r.twice ? "; computed twice, because the LSB is 0" : "");
}

core::Facts facts_of(const workflow::RecordingForecast& r) {
  return {{"number", "", r.number},
          {"file", "", r.simulation.file},
          {"radar", "", r.simulation.radar},
          {"format", "", workflow::format_word(r.simulation.format)},
          {"processing", "", workflow::processing_word(r.simulation.processing)},
          {"engine", "", r.engine},
          {"rows", "", r.rows},
          {"columns", "", r.columns},
          core::worded("samples", "samples", r.samples(),
                       fmt::format("{} x {}, {} rows can be shared out", r.rows, r.columns, r.rows)),
          core::worded("echoes", "echoes", r.echoes, count_text(r.echoes)),
          core::worded("bytes", "file", r.bytes,
                       (is_text(r.simulation.format) ? "about " : "") + core::bytes_text(r.bytes)),
          core::worded("memory_bytes", "memory of a worker", r.memory_bytes, core::bytes_text(r.memory_bytes)),
          {"passes", "", r.twice ? 2 : 1},
          {"trial_rows", "", r.trial.rows},
          {"seconds_per_row", "", r.trial.seconds_per_row},
          {"fixed_seconds", "", r.fixed_s},
          core::worded("seconds", "time", r.seconds(1), trial_text(r))};
}

core::Facts facts_of_sizes(const workflow::PlanForecast& plan) {
  return {
      core::worded("samples", "samples", plan.samples(), count_text(plan.samples())),
      core::worded("bytes", "files", plan.bytes(), core::bytes_text(plan.bytes())),
      core::worded("memory_bytes", "memory of a worker", plan.memory_bytes(), core::bytes_text(plan.memory_bytes()))};
}

core::Facts facts_of_workers(const workflow::PlanForecast& plan, unsigned workers) {
  const std::string time = core::duration_text(plan.seconds(workers));
  return {
      {"workers", "", workers},
      core::worded("seconds", counted(workers, "worker"), plan.seconds(workers),
                   workers == 1 ? time : fmt::format("{}, {:.3g} times as fast", time, plan.times_as_fast(workers))),
      {"speedup", "", plan.times_as_fast(workers)}};
}

std::string text_of(const PlanArguments& arguments, const workflow::PlanForecast& plan) {
  std::string text = fmt::format("{}: {}, {} for each worker\n", arguments.path,
                                 counted(plan.recordings.size(), "recording"), counted(plan.threads, "thread"));
  for (const workflow::RecordingForecast& r : plan.recordings)
    text += fmt::format("\nsimulation {}: {}, {}, {} engine\n", r.number, r.simulation.file,
                        workflow::processing_word(r.simulation.processing), r.engine) +
            core::text_of(facts_of(r));
  if (plan.recordings.empty()) return text + "  the scene has no recording\n";
  if (plan.recordings.size() > 1) text += "\nall of them\n" + core::text_of(facts_of_sizes(plan));
  text +=
      fmt::format("\ntime, {} of it for reading and checking, without the disk\n", core::duration_text(plan.reading_s));
  for (const unsigned workers : worker_counts(arguments.workers))
    text += core::text_of(facts_of_workers(plan, workers));
  return text;
}

std::string json_of(const PlanArguments& arguments, const workflow::PlanForecast& plan) {
  core::FactRows recordings;
  for (const workflow::RecordingForecast& r : plan.recordings) recordings.push_back(facts_of(r));
  core::FactRows workers;
  for (const unsigned count : worker_counts(arguments.workers)) workers.push_back(facts_of_workers(plan, count));
  core::Facts facts{{"sarsim", "", core::program_version},
                    {"script", "", arguments.path},
                    {"threads", "", plan.threads},
                    {"reading_seconds", "", plan.reading_s},
                    {"simulations", "", std::move(recordings)}};
  append(facts, facts_of_sizes(plan));
  append(facts, {{"seconds", "", plan.seconds(1)}, {"workers", "", std::move(workers)}});
  return core::json_of(facts);
}

}  // namespace

ExitStatus print_plan(const PlanArguments& arguments, Streams& streams) {
  Watch watch(streams, false);
  const workflow::PlanForecast plan =
      workflow::forecast_recordings({arguments.path, arguments.overrides, arguments.threads}, watch.observer());
  write_out(streams, arguments.json ? json_of(arguments, plan) : text_of(arguments, plan));
  return exit_done;
}

}  // namespace sarsim::cli
