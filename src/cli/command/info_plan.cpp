#include "cli/command/info_plan.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "cli/shell/figures.hpp"
#include "cli/shell/report.hpp"
#include "core/build/version.hpp"
#include "core/task/clock.hpp"
#include "core/task/parallel.hpp"
#include "core/text/number_text.hpp"
#include "raster/format/sinks.hpp"
#include "raster/table/formats.hpp"
#include "workflow/input/scene_words.hpp"
#include "workflow/record/record_size.hpp"
#include "workflow/record/row_trial.hpp"

namespace sarsim::cli {

namespace {

// Seconds of trials of all recordings of a script together, and at least of each.
constexpr double trial_s = 1.0;
constexpr double shortest_trial_s = 0.02;

bool is_text(scene::FileFormat format) { return raster::format_of(format).is_text(); }

// What a recording takes.
struct RecordingPlan {
  std::size_t number = 0;
  scene::Simulation simulation;
  std::string engine;
  std::size_t rows = 0;
  std::size_t columns = 0;
  double echoes = 0.0;
  double bytes = 0.0;
  double memory_bytes = 0.0;
  double fixed_s = 0.0;  // Before the first row; every worker does it.
  bool twice = false;    // The LSB is not known and the file holds counts.
  workflow::Trial trial;

  [[nodiscard]] double samples() const { return static_cast<double>(rows) * static_cast<double>(columns); }
  // The slowest of `workers` has the rows that do not divide.
  [[nodiscard]] double seconds(unsigned workers) const {
    return fixed_s + workflow::seconds_of_rows(trial, std::ceil(static_cast<double>(rows) / workers), twice);
  }
};

// 1, 2, 4 ... and the number that was asked for.
std::vector<unsigned> worker_counts(unsigned workers) {
  std::vector<unsigned> counts;
  for (unsigned count = 1; count < workers; count *= 2) counts.push_back(count);
  counts.push_back(workers);
  return counts;
}

class PlanInfo {
 public:
  PlanInfo(const PlanArguments& arguments, const workflow::SceneInput& input, double reading_s, Streams& streams)
      : arguments_(arguments), input_(input), reading_s_(reading_s), streams_(streams) {
    threads_ = core::thread_count(arguments.threads);
    const double share = trial_s / static_cast<double>(std::max<std::size_t>(input.scene.simulations.size(), 1));
    rules_ = {threads_, std::max(share, shortest_trial_s), core::now_s};
  }

  void look() {
    for (std::size_t i = 0; i < input_.scene.simulations.size(); ++i) recordings_.push_back(look_at(i));
  }

  [[nodiscard]] std::string text() const {
    std::string text =
        fmt::format("{}: {} recording{}, {} thread{} for each worker\n", arguments_.path, recordings_.size(),
                    recordings_.size() == 1 ? "" : "s", threads_, threads_ == 1 ? "" : "s");
    for (const RecordingPlan& r : recordings_) text += text_of(r);
    if (recordings_.size() > 1) {
      text += "\nall of them\n" + figures_text({si_count("samples", samples()), size("files", bytes()),
                                                size("memory of a worker", memory_bytes())});
    }
    if (recordings_.empty()) return text + "  the script has no $SIMULATION\n";
    return text + workers_text();
  }

  [[nodiscard]] std::string json() const {
    core::JsonWriter json;
    json.begin_object().member("sarsim", core::program_version).member("script", arguments_.path);
    json.member("threads", threads_).member("reading_seconds", reading_s_).key("simulations").begin_array();
    for (const RecordingPlan& r : recordings_) write_recording(json, r);
    json.end_array().member("samples", samples()).member("bytes", bytes()).member("memory_bytes", memory_bytes());
    json.member("seconds", seconds(1)).key("workers").begin_array();
    for (const unsigned workers : worker_counts(arguments_.workers))
      json.begin_object()
          .member("workers", workers)
          .member("seconds", seconds(workers))
          .member("speedup", speedup(workers))
          .end_object();
    json.end_array();
    return json.end_object().text();
  }

 private:
  [[nodiscard]] RecordingPlan look_at(std::size_t index) const {
    const double begin_s = core::now_s();
    const simulate::Plan plan =
        simulate::make_plan(input_.scene, index, input_.resolved, simulate::Engine::automatic, streams_.stop);
    RecordingPlan result;
    result.fixed_s = core::now_s() - begin_s;
    result.number = index + 1;
    result.simulation = plan.simulation;
    result.engine = simulate::name_of(plan.engine.engine);
    result.rows = plan.rows;
    result.columns = plan.columns;
    const simulate::Cost cost = simulate::estimated_cost(plan, threads_);
    result.echoes = cost.echoes;
    result.memory_bytes = cost.memory_bytes;
    result.bytes = raster::expected_bytes(simulate::product_of(plan, {}), {plan.simulation.format});
    result.twice = workflow::seeks_lsb(plan.simulation);
    result.trial = workflow::try_plan(plan, rules_, streams_.stop);
    return result;
  }

  static Figure si_count(const char* label, double value) {
    return figure(label, "", value, value < 1e6 ? fmt::format("{:.0f}", value) : fmt::format("{:.4g}", value));
  }
  static Figure size(const char* label, double bytes) { return figure(label, "", bytes, core::bytes_text(bytes)); }

  [[nodiscard]] static std::string text_of(const RecordingPlan& r) {
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
    std::string text =
        fmt::format("\ntime, {} of it for reading and checking, without the disk\n", core::duration_text(reading_s_));
    std::vector<Figure> figures;
    for (const unsigned workers : worker_counts(arguments_.workers))
      figures.push_back(figure(fmt::format("{} worker{}", workers, workers == 1 ? "" : "s"), "", seconds(workers),
                               workers == 1 ? core::duration_text(seconds(1))
                                            : fmt::format("{}, {:.3g} times as fast",
                                                          core::duration_text(seconds(workers)), speedup(workers))));
    return text + figures_text(figures);
  }

  void write_recording(core::JsonWriter& json, const RecordingPlan& r) const {
    json.begin_object().member("number", r.number).member("file", r.simulation.file);
    json.member("radar", r.simulation.radar).member("format", workflow::format_word(r.simulation.format));
    json.member("processing", workflow::processing_word(r.simulation.processing)).member("engine", r.engine);
    json.member("rows", r.rows).member("columns", r.columns).member("samples", r.samples());
    json.member("echoes", r.echoes).member("bytes", r.bytes).member("memory_bytes", r.memory_bytes);
    json.member("passes", r.twice ? 2 : 1).member("trial_rows", r.trial.rows);
    json.member("seconds_per_row", r.trial.seconds_per_row).member("fixed_seconds", r.fixed_s);
    json.member("seconds", r.seconds(1)).end_object();
  }

  [[nodiscard]] double samples() const {
    return sum([](const RecordingPlan& r) { return r.samples(); });
  }
  [[nodiscard]] double bytes() const {
    return sum([](const RecordingPlan& r) { return r.bytes; });
  }
  [[nodiscard]] double seconds(unsigned workers) const {
    return reading_s_ + sum([&](const RecordingPlan& r) { return r.seconds(workers); });
  }
  [[nodiscard]] double speedup(unsigned workers) const {
    return seconds(workers) > 0.0 ? seconds(1) / seconds(workers) : 1.0;
  }
  // Recordings are made one after the other.
  [[nodiscard]] double memory_bytes() const {
    double most = 0.0;
    for (const RecordingPlan& r : recordings_) most = std::max(most, r.memory_bytes);
    return most;
  }
  template <class Value>
  [[nodiscard]] double sum(const Value& value) const {
    double total = 0.0;
    for (const RecordingPlan& r : recordings_) total += value(r);
    return total;
  }

  const PlanArguments& arguments_;
  const workflow::SceneInput& input_;
  double reading_s_;
  Streams& streams_;
  unsigned threads_ = 1;
  workflow::TrialRules rules_;
  std::vector<RecordingPlan> recordings_;
};

}  // namespace

ExitStatus print_plan(const PlanArguments& arguments, Streams& streams) {
  const core::WorkControl control{core::thread_count(arguments.threads), streams.stop};
  const double begin_s = core::now_s();
  workflow::SceneInput input =
      workflow::read_scene(arguments.path, arguments.overrides, workflow::Scrutiny::echoes, control);
  workflow::expect_usable(input);
  print_problems(streams, input.problems);
  workflow::resolve_once(input, control);
  PlanInfo info(arguments, input, core::now_s() - begin_s, streams);
  info.look();
  write_out(streams, arguments.json ? info.json() : info.text());
  return exit_done;
}

}  // namespace sarsim::cli
