#include <filesystem>
#include <memory>
#include <ostream>
#include <utility>

#include <fmt/format.h>

#include "cli/command/commands.hpp"
#include "cli/command/sweep_arguments.hpp"
#include "cli/command/sweep_commands.hpp"
#include "cli/shell/engine_options.hpp"
#include "cli/shell/options.hpp"
#include "cli/shell/watch.hpp"
#include "core/report/invalid_request.hpp"
#include "core/task/parallel.hpp"
#include "core/text/counted.hpp"
#include "core/text/number_text.hpp"
#include "scene/script/reader.hpp"
#include "workflow/input/motion_input.hpp"
#include "workflow/input/scene_input.hpp"
#include "workflow/input/simd_choice.hpp"
#include "workflow/sweep/sweep.hpp"
#include "workflow/sweep/sweep_fields.hpp"
#include "workflow/sweep/sweep_options.hpp"

namespace sarsim::cli {

namespace {

using workflow::SweepPlan;
using workflow::SweepReport;
using workflow::SweepRequest;
using workflow::SweepRow;

SweepRequest sweep_request(const SweepArguments& arguments, workflow::SceneInput input) {
  SweepRequest request = arguments.words.request;
  request.scene = std::move(input.scene);
  request.script = arguments.scene;
  request.places = std::move(input.places);
  request.names = std::move(input.names);
  request.sources = std::move(input.sources);
  for (const std::string& word : arguments.let)
    request.values.settings.push_back(std::string(workflow::let_prefix) + word);
  request.values.folder = std::filesystem::path(arguments.scene).parent_path();
  request.post_processing = workflow::post_processing_of(arguments.words.post_processing);
  request.format = request.overrides.format;
  request.engine = arguments.engine.value_or(simulate::Engine::automatic);
  return request;
}

workflow::SceneInput read_scene_to_vary(const SweepArguments& arguments, Streams& streams) {
  const SweepRequest& request = arguments.words.request;
  const unsigned threads = core::thread_count(request.threads);
  workflow::SceneInput input =
      read_scene(arguments.scene, request.overrides, workflow::CheckLevel::reading, {threads, streams.stop});
  if (!core::has_errors(input.problems)) {
    const std::filesystem::path folder = std::filesystem::path(arguments.scene).parent_path();
    core::Problems of_clouds = workflow::read_files_of(input.scene, folder, {threads, streams.stop});
    scene::locate(of_clouds, input.places);
    core::append(input.problems, std::move(of_clouds));
  }
  expect_usable(input, request.strict);
  if (!arguments.quiet && !arguments.fields) print_problems(streams, input.problems);
  return input;
}

std::string plan_json(const SweepRequest& request, const SweepPlan& plan) {
  std::vector<SweepRow> rows = plan.rows;
  for (SweepRow& row : rows) {
    if (row.done || row.table) continue;
    const workflow::ProductSize& size = size_of(plan, row.variation, row.product);
    row.run.rows = size.rows;
    row.run.columns = size.columns;
    row.bytes = size.bytes;
  }
  return sweep_json(frame_of(request, plan, "planned"), rows);
}

std::string plan_text(const SweepPlan& plan) {
  std::string text;
  for (const SweepRow& row : plan.rows) {
    text += fmt::format("{}  {}  {}", row.variation + 1, plan.sweep.label(row.variation), row.file);
    if (row.done) {
      text += "  (done)\n";
    } else if (row.table) {
      text += "  geometry table\n";
    } else {
      const workflow::ProductSize& size = size_of(plan, row.variation, row.product);
      text += fmt::format("  {} x {} samples, {}\n", size.rows, size.columns, core::bytes_text(size.bytes));
    }
  }
  return text;
}

ExitStatus print_plan(const SweepArguments& arguments, const SweepRequest& request, const SweepPlan& plan,
                      Streams& streams) {
  write_out(streams, arguments.json ? plan_json(request, plan) : plan_text(plan));
  if (!arguments.quiet) write_err(streams, announcement(request, plan) + "\n");
  return exit_done;
}

ExitStatus print_report(const SweepArguments& arguments, const SweepRequest& request, const SweepReport& report,
                        Streams& streams) {
  const SweepPlan& plan = report.plan;
  if (arguments.json) write_out(streams, sweep_json(frame_of(request, plan, report.status()), plan.rows));
  if (!arguments.quiet)
    write_err(streams,
              fmt::format("{}: {} in {}\n", report.table.string(), core::counted(plan.variations.size(), "variation"),
                          core::duration_text(report.seconds)));
  if (report.failures.empty()) return exit_done;
  print_problems(streams, workflow::shortened(report.failures));
  return exit_bad_input;
}

ExitStatus sweep_scene(const SweepArguments& arguments, Streams& streams) {
  if (arguments.commands && !arguments.dry_run)
    throw core::InvalidRequest("--commands prints what a sweep would run, and runs nothing", "add --dry-run");
  workflow::choose_simd(arguments.simd);
  workflow::SceneInput input = read_scene_to_vary(arguments, streams);
  if (arguments.fields) {
    write_out(streams, workflow::field_list({input.scene, input.names}));
    return exit_done;
  }
  const SweepRequest request = sweep_request(arguments, std::move(input));
  Watch watch(streams, arguments.quiet);
  const core::Observer observer = watch.observer();
  SweepPlan plan = workflow::plan_sweep(request, observer);
  if (plan.refused && arguments.json)
    write_out(streams, workflow::sweep_json(frame_of(request, plan, "bad input"), {}));
  workflow::expect_sound(plan);
  if (arguments.commands && request.post_processing)
    throw core::InvalidRequest(
        "--commands prints the recordings alone",
        "leave out --focus, --search or --profiles, and process each recording with a command of its own");
  if (arguments.commands) {
    write_out(streams, run_commands(arguments, plan));
    return exit_done;
  }
  if (arguments.dry_run) return print_plan(arguments, request, plan, streams);
  const SweepReport report = workflow::run_sweep(request, std::move(plan), observer);
  watch.close();
  return print_report(arguments, request, report, streams);
}

}  // namespace

Action add_sweep(CLI::App& app) {
  auto arguments = std::make_shared<SweepArguments>();
  add_sweep_arguments(app, *arguments);
  add_examples(app,
               {{"sarsim sweep scene.toml --set seed=1..1000 --out runs", "a thousand noises"},
                {"sarsim sweep scene.toml --set Radar1.bandwidth=10MHz:10MHz:100MHz --set seed=1..10 --dry-run",
                 "what a hundred combinations would be"},
                {"sarsim sweep scene.toml --set 'Target1.x=1km,2km' --discard", "results only, no recordings"},
                {"sarsim sweep scene.toml --let speed=100:50:300m/s", "a name of [let], and all that it stands for"},
                {"sarsim sweep scene.toml --values cases.csv --out runs", "a variation for each line of a table"},
                {"sarsim sweep scene.toml --zip --set 'Target1.rcs=normal(1, 0.2)' --set seed=1..100",
                 "random values, each with its own noise"},
                {"sarsim sweep sar.toml --set seed=1..100 --discard --focus --measure",
                 "the errors of 100 images, as columns of the table"},
                {"sarsim sweep scene.toml --set seed=1..100 --dry-run --commands", "a command for each variation"},
                {"sarsim sweep scene.toml --fields", "what can be set"}});
  return [arguments](Streams& streams) { return sweep_scene(*arguments, streams); };
}

}  // namespace sarsim::cli
