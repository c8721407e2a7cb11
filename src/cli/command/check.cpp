#include <algorithm>
#include <memory>
#include <ostream>

#include <fmt/format.h>

#include "cli/command/commands.hpp"
#include "cli/shell/options.hpp"
#include "cli/shell/report.hpp"
#include "cli/shell/scene_options.hpp"
#include "core/build/version.hpp"
#include "core/text/json.hpp"
#include "workflow/check/check_scene.hpp"
#include "workflow/input/echo_words.hpp"
#include "workflow/input/scene_input.hpp"

namespace sarsim::cli {

namespace {

struct CheckArguments {
  std::vector<std::string> scenes;
  workflow::SceneOverrides overrides;
  bool json = false;
  bool strict = false;
};

std::size_t count_of(const core::Problems& problems, core::Severity severity) {
  std::size_t count = 0;
  for (const core::Problem& problem : problems)
    if (problem.severity == severity) count += problem.count;
  return count;
}

workflow::SceneInput looked_at(const std::string& path, const workflow::SceneOverrides& overrides,
                               const core::StopFlag* stop) {
  const core::WorkControl control{core::thread_count(0), stop};
  workflow::SceneInput input = workflow::read_scene(path, overrides, workflow::CheckLevel::echoes, control);
  workflow::add_remarks(input, control);
  return input;
}

std::string verdict(const std::string& path, const core::Problems& problems) {
  if (problems.empty()) return path + ": no problems";
  std::string text = fmt::format("{}: {}, {}", path, counted(count_of(problems, core::Severity::error), "error"),
                                 counted(count_of(problems, core::Severity::warning), "warning"));
  const std::size_t notes = count_of(problems, core::Severity::note);
  return notes > 0 ? text + ", " + counted(notes, "note") : text;
}

void add_json(core::JsonWriter& json, const std::string& path, const workflow::SceneInput& input) {
  const core::Problems& problems = input.problems;
  json.begin_object().member("script", path).member("errors", count_of(problems, core::Severity::error));
  json.member("warnings", count_of(problems, core::Severity::warning))
      .member("notes", count_of(problems, core::Severity::note));
  json.key("problems");
  write_json(json, problems);
  json.key("simulations").begin_array();
  for (const simulate::EchoSummary& summary : input.echoes) {
    json.begin_object().member("number", summary.simulation + 1);
    workflow::write_echoes(json, summary);
    json.end_object();
  }
  json.end_array();
  json.end_object();
}

ExitStatus check_scenes(const CheckArguments& arguments, Streams& streams) {
  core::JsonWriter json;
  json.begin_object().member("sarsim", core::program_version).key("scripts").begin_array();
  ExitStatus status = exit_done;
  for (const std::string& path : arguments.scenes) {
    const workflow::SceneInput input = looked_at(path, arguments.overrides, streams.stop);
    const core::Problems& problems = input.problems;
    if (core::has_errors(problems) || (arguments.strict && count_of(problems, core::Severity::warning) > 0))
      status = exit_bad_input;
    if (arguments.json) {
      add_json(json, path, input);
      continue;
    }
    std::string text;
    for (const core::Problem& problem : problems) text += core::to_string(problem) + "\n";
    if (!core::has_errors(problems))
      for (const simulate::EchoSummary& summary : input.echoes) text += workflow::echo_text(input.scene, summary);
    write_out(streams, text + verdict(path, problems) + "\n");
  }
  json.end_array().end_object();
  if (arguments.json) write_out(streams, json.text());
  return status;
}

}  // namespace

Action add_check(CLI::App& app) {
  auto arguments = std::make_shared<CheckArguments>();
  app.add_option("scenes", arguments->scenes, "scenes to check")->type_name("SCENE")->required();
  add_scene_overrides(app, arguments->overrides);
  app.add_flag("--json", arguments->json, "the problems as JSON on standard output");
  app.add_flag("--strict", arguments->strict, "warnings, too, give exit status 2");
  add_examples(app, {{"sarsim check sar_r.toml", "all problems of a scene, with line and column"},
                     {"sarsim check *.scr", "of many"},
                     {"sarsim check --json sar_r.toml", "for programs"}});
  return [arguments](Streams& streams) { return check_scenes(*arguments, streams); };
}

}  // namespace sarsim::cli
