#include <array>
#include <fstream>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "cli/command/commands.hpp"
#include "cli/command/info_data.hpp"
#include "cli/command/info_plan.hpp"
#include "cli/command/info_scene.hpp"
#include "cli/shell/options.hpp"
#include "cli/shell/request_options.hpp"
#include "cli/shell/scene_options.hpp"
#include "core/text/number_text.hpp"
#include "raster/table/formats.hpp"
#include "workflow/convert/convert_options.hpp"
#include "workflow/input/recording_input.hpp"

namespace sarsim::cli {

namespace {

struct InfoArguments {
  std::string path;
  workflow::SampleArguments sample;
  workflow::SceneOverrides overrides;
  bool json = false;
  bool all = false;
  bool plan = false;
  bool statistics = false;
  std::optional<std::int64_t> workers;
  std::optional<std::int64_t> threads;
};

// An option that was given, and whether it is for scripts or for files of samples.
struct InputUse {
  const char* option;
  bool given;
  bool of_script;
};

// Options that would be ignored are mistakes, all of them at once.
void expect_used(const InfoArguments& arguments, bool script) {
  const workflow::SceneOverrides& overrides = arguments.overrides;
  const workflow::SampleArguments& sample = arguments.sample;
  const InputUse uses[] = {{"--all", arguments.all, true},
                           {"--set", !overrides.settings.empty(), true},
                           {"--targets", !overrides.targets.empty(), true},
                           {"--profile", overrides.profile.has_value(), true},
                           {"--pulse", overrides.pulse.has_value(), true},
                           {"--tolerance", overrides.tolerance.has_value(), true},
                           {"--seed", overrides.seed.has_value(), true},
                           {"--from", sample.format.has_value(), false},
                           {"--columns", sample.columns.has_value(), false},
                           {"--bits", sample.bits.has_value(), false},
                           {"--lsb", sample.lsb_v.has_value(), false},
                           {"--dataset", !sample.dataset.empty(), false},
                           {"--script", !sample.script.empty(), false},
                           {"--statistics", arguments.statistics, false}};
  core::Problems problems;
  for (const InputUse& use : uses) {
    if (!use.given || use.of_script == script) continue;
    core::Problem& problem = problems.emplace_back();
    problem.message = std::string(use.option) + " means nothing for '" + arguments.path +
                      (script ? "', which is a script" : "', which is not a script");
    problem.hint = use.of_script ? "leave it out: it is for scripts" : "leave it out: it is for files of samples";
  }
  if (script && arguments.plan && arguments.all)
    problems.push_back(
        core::InvalidRequest("--all means nothing with --plan", "leave out one of them").problems.front());
  if (!problems.empty()) throw core::InvalidRequest(std::move(problems));
}

ExitStatus print_info(const InfoArguments& arguments, Streams& streams) {
  if (!arguments.plan && (arguments.workers || arguments.threads))
    throw core::InvalidRequest("info: --workers and --threads belong to --plan", "add --plan");
  const bool script = workflow::holds_script(arguments.path);
  if (arguments.plan && !script)
    throw core::InvalidRequest("info: '" + arguments.path + "' is not a script; only scripts can be planned",
                               "leave out --plan to see what the file contains");
  expect_used(arguments, script);
  if (arguments.plan) {
    return print_plan(
        {arguments.path, arguments.overrides, arguments.json, static_cast<unsigned>(arguments.workers.value_or(1)),
         static_cast<unsigned>(arguments.threads.value_or(0))},
        streams);
  }
  if (script) return print_scene_info({arguments.path, arguments.overrides, arguments.json, arguments.all}, streams);
  return print_data_info({arguments.path, arguments.sample, arguments.statistics, arguments.json}, streams);
}

}  // namespace

Action add_info(CLI::App& app) {
  auto arguments = std::make_shared<InfoArguments>();
  add_text(app, "file", arguments->path, "FILE", "script, or file of samples")->required();
  app.add_flag("--json", arguments->json, "the same as JSON");
  app.add_flag("--all", arguments->all, "list every object and target of a script, not the first 20");
  app.add_flag("--statistics", arguments->statistics,
               "lowest, highest, rms and largest samples of a file; reads all of it");
  app.add_flag("--plan", arguments->plan, "samples, bytes, memory and time of a script's recordings, measured here");
  add_integer(app, "--workers", arguments->workers, 1, 1000000, "with --plan: also the time on N machines");
  add_integer(app, "--threads", arguments->threads, 0, 4096,
              "of --plan: threads of each; 0 for one per core (default)");
  add_scene_overrides(app, arguments->overrides);
  add_table_options(app, workflow::sample_option_table(), arguments->sample);
  add_examples(app, {{"sarsim info sar_r.toml", "resolution, ambiguities, SNR, size and time of a scene"},
                     {"sarsim info sar_r.toml --plan --workers 8", "what a run will take, and on eight machines"},
                     {"sarsim info sim1.h5", "shape, axes and attributes of a file of samples"},
                     {"sarsim info sim1.h5 --statistics", "also its largest samples, rms and share of zeros"},
                     {"sarsim info sim1.bin --columns 256 --bits 8", "a file without a header"},
                     {"sarsim info sim1.bin --script sar_r.toml", "or described by its script"}});
  return [arguments](Streams& streams) { return print_info(*arguments, streams); };
}

}  // namespace sarsim::cli
