#include "cli/focus_input.hpp"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "base/number_text.hpp"
#include "cli/options.hpp"
#include "cli/output_names.hpp"
#include "data/sample_file.hpp"
#include "scene/check.hpp"
#include "script/reader.hpp"
#include "simulate/sar_rows.hpp"

namespace sarsim::cli {

namespace fs = std::filesystem;

namespace {

void take(Problems& all, Problems more) { std::ranges::move(more, std::back_inserter(all)); }

void expect_sound(const Problems& problems) {
  if (has_errors(problems)) throw BadInput(problems);
}

bool is_script(const std::string& path) { return equal_ignoring_case(fs::path(path).extension().string(), ".scr"); }

// The simulation that --simulation says, or else the first whose recording can be focused.
std::size_t simulation_of_scene(const Scene& scene, std::optional<std::int64_t> wanted) {
  if (scene.simulations.empty()) throw BadInput("the script has no $SIMULATION to focus");
  if (wanted) {
    const auto number = static_cast<std::size_t>(*wanted);
    if (number >= 1 && number <= scene.simulations.size()) return number - 1;
    throw BadInput(fmt::format("--simulation: the script has no simulation {}", number),
                   fmt::format("it has {}", scene.simulations.size()));
  }
  const auto first =
      std::ranges::find_if(scene.simulations, [](const Simulation& s) { return s.processing != Processing::srp; });
  return first == scene.simulations.end() ? 0 : static_cast<std::size_t>(first - scene.simulations.begin());
}

// The one that writes a file of that name, whatever its extension.
std::size_t simulation_of_file(const Scene& scene, const std::string& path, std::optional<std::int64_t> wanted) {
  if (!wanted) {
    const auto names = output_names(scene, {}).simulations;
    const auto found = std::ranges::find(names, fs::path(path).stem(), [](const fs::path& p) { return p.stem(); });
    if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
    if (scene.simulations.size() > 1)
      throw BadInput(fmt::format("no simulation of the script writes '{}'", fs::path(path).filename().string()),
                     "say which one did with --simulation N");
  }
  return simulation_of_scene(scene, wanted);
}

FocusInput of_scene(const FocusInputArguments& arguments, const WorkControl& control) {
  if (!arguments.script.empty()) throw BadInput("--script is for files of samples", "a script needs no other script");
  SceneInput input = read_scene(arguments.path, {}, Scrutiny::echoes, control);
  expect_usable(input);
  FocusInput focus;
  focus.simulation = simulation_of_scene(input.scene, arguments.simulation);
  const Plan window = make_plan(input.scene, focus.simulation, input.resolved);
  focus.problems = std::move(input.problems);
  take(focus.problems, problems_of_sar(window));
  expect_sound(focus.problems);
  Simulation& simulation = input.scene.simulations[focus.simulation];
  simulation = recorded_for_sar(simulation, window);
  focus.plan =
      std::make_shared<const Plan>(make_plan(input.scene, focus.simulation, input.resolved, Engine::automatic));
  focus.echoes = sar_rows_of_scene(focus.plan, window.columns);
  return focus;
}

// Of a file that carries its script, or of the one in --script.
Scene scene_of_file(const FocusInputArguments& arguments, const SampleFileInfo* info, Problems& problems) {
  if (!arguments.script.empty()) {
    SceneInput input = read_scene(arguments.script, {}, Scrutiny::values);
    expect_usable(input);
    take(problems, std::move(input.problems));
    return std::move(input.scene);
  }
  const auto& attributes = info->attributes;
  const auto script = std::ranges::find(attributes, "script", [](const auto& pair) { return pair.first; });
  if (script == attributes.end() || script->second.empty())
    throw BadInput(fmt::format("'{}' does not say how it was recorded", arguments.path),
                   "give the script that wrote it with --script");
  const std::string name = arguments.path + " (its script)";
  ScriptReading reading = read_script(script->second, name, disk_loader(fs::path(arguments.path).parent_path()));
  expect_sound(reading.problems);
  expect_sound(check(reading.scene));
  return std::move(reading.scene);
}

SampleFile opened(const std::string& path, const SampleFileHints& hints, Problems& problems) {
  OpenedSampleFile result = SampleFile::open(path, hints);
  if (!result.file) throw BadInput(ranked(std::move(result.problems)));
  take(problems, std::move(result.problems));
  return std::move(*result.file);
}

SampleFileHints hints_of(const Plan& plan) {
  SampleFileHints hints;
  hints.columns = plan.columns;
  hints.rows = plan.rows;
  hints.bits = plan.simulation.bits;
  hints.lsb_v = plan.simulation.lsb_v;
  return hints;
}

void expect_shape(const SampleFileInfo& info, const Plan& plan, const std::string& path) {
  if (info.rows == plan.rows && info.columns == plan.columns) return;
  throw BadInput(fmt::format("'{}' has {} rows of {} samples, but the script's simulation makes {} of {}", path,
                             info.rows, info.columns, plan.rows, plan.columns),
                 "name the script and the simulation that wrote it with --script and --simulation");
}

// Volts of a number of the file; 1 with a remark where counts have no known LSB.
double scale_of(const SampleFileInfo& info, const Plan& plan, Problems& problems) {
  if (!info.counts) return 1.0;
  if (info.lsb_v && *info.lsb_v > 0.0) return *info.lsb_v;
  if (plan.simulation.lsb_v > 0.0) return plan.simulation.lsb_v;
  Problem problem;
  problem.severity = Severity::warning;
  problem.message = "the volts of a count are not known: amplitudes of the image are in counts";
  problem.hint = "give the LSB in the script";
  problems.push_back(problem);
  return 1.0;
}

FocusInput of_file(const FocusInputArguments& arguments) {
  FocusInput focus;
  std::optional<SampleFile> file;
  if (arguments.script.empty()) file = opened(arguments.path, {}, focus.problems);
  const Scene scene = scene_of_file(arguments, file ? &file->info() : nullptr, focus.problems);
  focus.simulation = simulation_of_file(scene, arguments.path, arguments.simulation);
  focus.plan = std::make_shared<const Plan>(make_plan(scene, focus.simulation));
  take(focus.problems, problems_of_sar(*focus.plan));
  expect_sound(focus.problems);
  if (!file) file = opened(arguments.path, hints_of(*focus.plan), focus.problems);
  expect_shape(file->info(), *focus.plan, arguments.path);
  const double scale = scale_of(file->info(), *focus.plan, focus.problems);
  const auto shared = std::make_shared<const SampleFile>(std::move(*file));
  const auto read = [shared, scale](std::size_t row, std::span<std::complex<double>> out) {
    shared->read_rows(row, 1, out);
    for (std::complex<double>& value : out) value *= scale;
  };
  focus.echoes = sar_rows_of_recording(focus.plan, read);
  return focus;
}

}  // namespace

void add_focus_input_arguments(CLI::App& app, FocusInputArguments& arguments) {
  add_text(app, "--script", arguments.script, "SCENE", "script that wrote the file of samples, where it carries none");
  add_integer(app, "--simulation", arguments.simulation, 1, std::int64_t{1} << 40,
              "which simulation of the script (default: the one with the file's name; of a script, the first)");
}

FocusInput open_focus_input(const FocusInputArguments& arguments, const WorkControl& control) {
  FocusInput focus = is_script(arguments.path) ? of_scene(arguments, control) : of_file(arguments);
  focus.problems = ranked(std::move(focus.problems));
  return focus;
}

}  // namespace sarsim::cli
