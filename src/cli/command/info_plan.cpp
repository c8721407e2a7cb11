#include "cli/command/info_plan.hpp"

#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cli/shell/figures.hpp"
#include "cli/shell/report.hpp"
#include "cli/shell/watch.hpp"
#include "core/build/version.hpp"
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

class PlanInfo {
 public:
  PlanInfo(const PlanArguments& arguments, workflow::PlanForecast plan)
      : arguments_(arguments), plan_(std::move(plan)) {}

  [[nodiscard]] std::string text() const {
    std::string text =
        fmt::format("{}: {} recording{}, {} thread{} for each worker\n", arguments_.path, plan_.recordings.size(),
                    plan_.recordings.size() == 1 ? "" : "s", plan_.threads, plan_.threads == 1 ? "" : "s");
    for (const workflow::RecordingForecast& r : plan_.recordings) text += text_of(r);
    if (plan_.recordings.size() > 1) {
      text += "\nall of them\n" + figures_text({si_count("samples", plan_.samples()), size("files", plan_.bytes()),
                                                size("memory of a worker", plan_.memory_bytes())});
    }
    if (plan_.recordings.empty()) return text + "  the scene has no recording\n";
    return text + workers_text();
  }

  [[nodiscard]] std::string json() const {
    core::JsonWriter json;
    json.begin_object().member("sarsim", core::program_version).member("script", arguments_.path);
    json.member("threads", plan_.threads).member("reading_seconds", plan_.reading_s).key("simulations").begin_array();
    for (const workflow::RecordingForecast& r : plan_.recordings) write_recording(json, r);
    json.end_array()
        .member("samples", plan_.samples())
        .member("bytes", plan_.bytes())
        .member("memory_bytes", plan_.memory_bytes());
    json.member("seconds", plan_.seconds(1)).key("workers").begin_array();
    for (const unsigned workers : worker_counts(arguments_.workers))
      json.begin_object()
          .member("workers", workers)
          .member("seconds", plan_.seconds(workers))
          .member("speedup", plan_.times_as_fast(workers))
          .end_object();
    json.end_array();
    return json.end_object().text();
  }

 private:
  static Figure si_count(const char* label, double value) {
    return figure(label, "", value, value < 1e6 ? fmt::format("{:.0f}", value) : fmt::format("{:.4g}", value));
  }
  static Figure size(const char* label, double bytes) { return figure(label, "", bytes, core::bytes_text(bytes)); }

  [[nodiscard]] static std::string text_of(const workflow::RecordingForecast& r) {
    std::vector<Figure> figures;
    figures.push_back(figure("samples", "", r.samples(),
                             fmt::format("{} x {}, {} rows can be shared out", r.rows, r.columns, r.rows)));
    figures.push_back(si_count("echoes", r.echoes));
    figures.push_back(
        figure("file", "", r.bytes, (is_text(r.simulation.format) ? "about " : "") + core::bytes_text(r.bytes)));
    figures.push_back(size("memory of a worker", r.memory_bytes));
    figures.push_back(
        figure("time", "", r.seconds(1),
               fmt::format("{}, from a trial of {} row{}{}", core::duration_text(r.seconds(1)), r.trial.rows,
                           r.trial.rows == 1 ? "" : "s", r.twice ? "; computed twice, because the LSB is 0" : "")));
    return fmt::format("\nsimulation {}: {}, {}, {} engine\n", r.number, r.simulation.file,
                       workflow::processing_word(r.simulation.processing), r.engine) +
           figures_text(figures);
  }

  [[nodiscard]] std::string workers_text() const {
    std::string text = fmt::format("\ntime, {} of it for reading and checking, without the disk\n",
                                   core::duration_text(plan_.reading_s));
    std::vector<Figure> figures;
    for (const unsigned workers : worker_counts(arguments_.workers))
      figures.push_back(
          figure(fmt::format("{} worker{}", workers, workers == 1 ? "" : "s"), "", plan_.seconds(workers),
                 workers == 1 ? core::duration_text(plan_.seconds(1))
                              : fmt::format("{}, {:.3g} times as fast", core::duration_text(plan_.seconds(workers)),
                                            plan_.times_as_fast(workers))));
    return text + figures_text(figures);
  }

  void write_recording(core::JsonWriter& json, const workflow::RecordingForecast& r) const {
    json.begin_object().member("number", r.number).member("file", r.simulation.file);
    json.member("radar", r.simulation.radar).member("format", workflow::format_word(r.simulation.format));
    json.member("processing", workflow::processing_word(r.simulation.processing)).member("engine", r.engine);
    json.member("rows", r.rows).member("columns", r.columns).member("samples", r.samples());
    json.member("echoes", r.echoes).member("bytes", r.bytes).member("memory_bytes", r.memory_bytes);
    json.member("passes", r.twice ? 2 : 1).member("trial_rows", r.trial.rows);
    json.member("seconds_per_row", r.trial.seconds_per_row).member("fixed_seconds", r.fixed_s);
    json.member("seconds", r.seconds(1)).end_object();
  }

  const PlanArguments& arguments_;
  workflow::PlanForecast plan_;
};

}  // namespace

ExitStatus print_plan(const PlanArguments& arguments, Streams& streams) {
  Watch watch(streams, false);
  const PlanInfo info(arguments, workflow::forecast_recordings({arguments.path, arguments.overrides, arguments.threads},
                                                               watch.observer()));
  write_out(streams, arguments.json ? info.json() : info.text());
  return exit_done;
}

}  // namespace sarsim::cli
