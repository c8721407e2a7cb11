#include "cli/doppler_input.hpp"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "base/number_text.hpp"
#include "cli/options.hpp"
#include "cli/output_names.hpp"
#include "data/sample_file.hpp"
#include "scene/check.hpp"
#include "script/reader.hpp"

namespace sarsim::cli {

namespace fs = std::filesystem;

namespace {

void take(Problems& all, Problems more) { std::ranges::move(more, std::back_inserter(all)); }

std::size_t numbered_simulation(const Scene& scene, std::int64_t number) {
  const auto index = static_cast<std::size_t>(number) - 1;
  if (index < scene.simulations.size()) return index;
  throw BadInput(fmt::format("--simulation: the script has no simulation {}", number),
                 fmt::format("it has {}", scene.simulations.size()));
}

// The simulation that is asked for, or else the first that records pulses.
std::size_t simulation_of_scene(const Scene& scene, std::optional<std::int64_t> wanted) {
  if (wanted) return numbered_simulation(scene, *wanted);
  if (scene.simulations.empty())
    throw BadInput("the script has no $SIMULATION, which says what is recorded", "add one");
  const auto first =
      std::ranges::find_if(scene.simulations, [](const Simulation& s) { return s.processing != Processing::srp; });
  return first == scene.simulations.end() ? 0 : static_cast<std::size_t>(first - scene.simulations.begin());
}

// The one that writes a file of that name, whatever its extension.
std::size_t simulation_of_file(const Scene& scene, const std::string& path, std::optional<std::int64_t> wanted) {
  if (wanted) return numbered_simulation(scene, *wanted);
  const auto names = output_names(scene, {}).simulations;
  const auto found = std::ranges::find(names, fs::path(path).stem(), [](const fs::path& p) { return p.stem(); });
  if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  if (scene.simulations.size() == 1) return 0;
  throw BadInput(fmt::format("no simulation of the script writes '{}'", fs::path(path).filename().string()),
                 "say which one did with --simulation N");
}

// Synthetic range profiles have to be refused before they are planned as pulses.
void expect_pulses(const Simulation& simulation) {
  if (simulation.processing == Processing::srp)
    throw BadInput("synthetic range profiles hold no pulses", "take a simulation of RAW or MATCHED_FILTER processing");
}

PulseInput of_scene(const PulseInputArguments& arguments, const WorkControl& control) {
  if (!arguments.script.empty()) throw BadInput("--script is for files of samples", "a script needs no other script");
  SceneInput scene = read_scene(arguments.path, {}, Scrutiny::echoes, control);
  expect_usable(scene);
  PulseInput input;
  input.problems = std::move(scene.problems);
  input.simulation = simulation_of_scene(scene.scene, arguments.simulation);
  Simulation& simulation = scene.scene.simulations[input.simulation];
  expect_pulses(simulation);
  simulation = compressed_simulation(simulation);
  input.rows = pulse_rows_of_scene(std::make_shared<const Plan>(
      make_plan(scene.scene, input.simulation, scene.resolved, Engine::automatic, control.stop)));
  return input;
}

Scene scene_of_script(const std::string& path, Problems& problems) {
  SceneInput input = read_scene(path, {}, Scrutiny::values);
  expect_usable(input);
  take(problems, std::move(input.problems));
  return std::move(input.scene);
}

// Of a file that carries its script.
Scene scene_in_file(const std::string& path, const SampleFileInfo& info) {
  const auto script =
      std::ranges::find(info.attributes, "script", [](const auto& attribute) { return attribute.first; });
  if (script == info.attributes.end() || script->second.empty())
    throw BadInput(fmt::format("'{}' does not say how it was recorded", path),
                   "give the script that wrote it with --script");
  ScriptReading reading =
      read_script(script->second, path + " (its script)", disk_loader(fs::path(path).parent_path()));
  if (!has_errors(reading.problems)) take(reading.problems, check(reading.scene));
  if (has_errors(reading.problems)) throw BadInput(ranked(std::move(reading.problems)));
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

// Volts of a number of the file; 1 with a remark where counts have no known LSB.
double scale_of(const SampleFileInfo& info, const Plan& plan, Problems& problems) {
  if (!info.counts) return 1.0;
  if (info.lsb_v && *info.lsb_v > 0.0) return *info.lsb_v;
  if (plan.simulation.lsb_v > 0.0) return plan.simulation.lsb_v;
  Problem problem;
  problem.severity = Severity::warning;
  problem.message = "the volts of a count are not known: magnitudes are in counts";
  problem.hint = "give the LSB in the script";
  problems.push_back(problem);
  return 1.0;
}

PulseInput of_file(const PulseInputArguments& arguments) {
  PulseInput input;
  std::optional<SampleFile> file;
  if (arguments.script.empty()) file = opened(arguments.path, {}, input.problems);
  const Scene scene =
      file ? scene_in_file(arguments.path, file->info()) : scene_of_script(arguments.script, input.problems);
  input.simulation = simulation_of_file(scene, arguments.path, arguments.simulation);
  expect_pulses(scene.simulations[input.simulation]);
  const auto plan = std::make_shared<const Plan>(make_plan(scene, input.simulation));
  if (!file) file = opened(arguments.path, hints_of(*plan), input.problems);
  const SampleFileInfo& info = file->info();
  if (info.rows != plan->rows || info.columns != plan->columns)
    throw BadInput(fmt::format("'{}' has {} rows of {} samples, but the script's simulation makes {} of {}",
                               arguments.path, info.rows, info.columns, plan->rows, plan->columns),
                   "name the script and the simulation that wrote it with --script and --simulation");
  const double scale = scale_of(info, *plan, input.problems);
  const auto shared = std::make_shared<const SampleFile>(std::move(*file));
  input.rows = pulse_rows_of_recording(plan, [shared, scale](std::size_t row, std::span<std::complex<double>> out) {
    shared->read_rows(row, 1, out);
    for (std::complex<double>& value : out) value *= scale;
  });
  return input;
}

}  // namespace

void add_pulse_input_arguments(CLI::App& app, PulseInputArguments& arguments) {
  add_text(app, "--script", arguments.script, "SCENE", "script that wrote the file of samples, where it carries none");
  add_integer(app, "--simulation", arguments.simulation, 1, std::int64_t{1} << 40,
              "which simulation of the script (default: the one with the file's name; of a script, the first)");
}

PulseInput open_pulse_input(const PulseInputArguments& arguments, const WorkControl& control) {
  const bool script = equal_ignoring_case(fs::path(arguments.path).extension().string(), ".scr");
  PulseInput input = script ? of_scene(arguments, control) : of_file(arguments);
  input.problems = ranked(std::move(input.problems));
  return input;
}

}  // namespace sarsim::cli
