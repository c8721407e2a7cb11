#include "cli/stepped_input.hpp"

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

bool is_script(const std::string& path) { return equal_ignoring_case(fs::path(path).extension().string(), ".scr"); }

// Whether the radar of a simulation steps its carrier, or at least modulates its pulse.
bool suits(const Scene& scene, const Simulation& simulation, SteppedUse use) {
  const std::size_t index = find_radar(scene, simulation.radar);
  if (index == not_found) return false;
  const Radar& radar = scene.radars[index];
  if (radar.carrier == Radar::Carrier::stepped && radar.carrier_steps > 1) return true;
  return use == SteppedUse::isar && radar.pulse != Radar::Pulse::mono && radar.carrier == Radar::Carrier::single;
}

// The simulation that --simulation says, or else the first that can be used.
std::size_t simulation_of_scene(const Scene& scene, std::optional<std::int64_t> wanted, SteppedUse use) {
  if (scene.simulations.empty()) throw BadInput("the script has no $SIMULATION");
  if (wanted) {
    const auto number = static_cast<std::size_t>(*wanted);
    if (number >= 1 && number <= scene.simulations.size()) return number - 1;
    throw BadInput(fmt::format("--simulation: the script has no simulation {}", number),
                   fmt::format("it has {}", scene.simulations.size()));
  }
  const auto first = std::ranges::find_if(scene.simulations, [&](const Simulation& s) { return suits(scene, s, use); });
  return first == scene.simulations.end() ? 0 : static_cast<std::size_t>(first - scene.simulations.begin());
}

// The one that writes a file of that name, whatever its extension.
std::size_t simulation_of_file(const Scene& scene, const SteppedInputArguments& arguments, SteppedUse use) {
  if (!arguments.simulation) {
    const auto names = output_names(scene, {}).simulations;
    const auto found =
        std::ranges::find(names, fs::path(arguments.path).stem(), [](const fs::path& p) { return p.stem(); });
    if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
    if (scene.simulations.size() > 1)
      throw BadInput(
          fmt::format("no simulation of the script writes '{}'", fs::path(arguments.path).filename().string()),
          "say which one did with --simulation N");
  }
  return simulation_of_scene(scene, arguments.simulation, use);
}

SteppedInput of_scene(const SteppedInputArguments& arguments, SteppedUse use, const WorkControl& control) {
  if (!arguments.script.empty()) throw BadInput("--script is for files of samples", "a script needs no other script");
  SceneInput input = read_scene(arguments.path, arguments.overrides, Scrutiny::echoes, control);
  expect_usable(input);
  SteppedInput stepped;
  stepped.simulation = simulation_of_scene(input.scene, arguments.simulation, use);
  Simulation& simulation = input.scene.simulations[stepped.simulation];
  // Bursts are cut here, and profiles made of sub-bands too: what `check` says of SRP does not concern them.
  simulation.processing = Processing::raw;
  const Plan window = make_plan(input.scene, stepped.simulation, input.resolved);
  stepped.problems = std::move(input.problems);
  std::erase_if(stepped.problems, [](const Problem& p) { return p.subject.field == "processing"; });
  take(stepped.problems, problems_of_stepped(window, use, false));
  if (has_errors(stepped.problems)) throw BadInput(ranked(std::move(stepped.problems)));
  simulation = recorded_for_stepped(simulation, window);
  const auto plan =
      std::make_shared<const Plan>(make_plan(input.scene, stepped.simulation, input.resolved, Engine::automatic));
  stepped.rows = stepped_rows_of_scene(plan, window);
  return stepped;
}

// Of a file that carries its script, or of the one in --script.
Scene scene_of_file(const SteppedInputArguments& arguments, const SampleFileInfo* info, Problems& problems) {
  if (!arguments.script.empty()) {
    SceneInput input = read_scene(arguments.script, arguments.overrides, Scrutiny::values);
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
  if (has_errors(reading.problems)) throw BadInput(std::move(reading.problems));
  if (Problems found = check(reading.scene); has_errors(found)) throw BadInput(std::move(found));
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
  problem.message = "the volts of a count are not known: amplitudes are in counts";
  problem.hint = "give the LSB in the script";
  problems.push_back(problem);
  return 1.0;
}

SteppedInput of_file(const SteppedInputArguments& arguments, SteppedUse use) {
  SteppedInput stepped;
  std::optional<SampleFile> file;
  if (arguments.script.empty()) file = opened(arguments.path, {}, stepped.problems);
  const Scene scene = scene_of_file(arguments, file ? &file->info() : nullptr, stepped.problems);
  stepped.simulation = simulation_of_file(scene, arguments, use);
  const auto plan = std::make_shared<const Plan>(make_plan(scene, stepped.simulation));
  take(stepped.problems, problems_of_stepped(*plan, use, true));
  if (has_errors(stepped.problems)) throw BadInput(ranked(std::move(stepped.problems)));
  if (!file) file = opened(arguments.path, hints_of(*plan), stepped.problems);
  if (file->info().rows != plan->rows || file->info().columns != plan->columns)
    throw BadInput(fmt::format("'{}' has {} rows of {} samples, but the script's simulation makes {} of {}",
                               arguments.path, file->info().rows, file->info().columns, plan->rows, plan->columns),
                   "name the script and the simulation that wrote it with --script and --simulation");
  const double scale = scale_of(file->info(), *plan, stepped.problems);
  const auto shared = std::make_shared<const SampleFile>(std::move(*file));
  stepped.rows = stepped_rows_of_recording(plan, [shared, scale](std::size_t row, std::span<std::complex<double>> out) {
    shared->read_rows(row, 1, out);
    for (std::complex<double>& value : out) value *= scale;
  });
  return stepped;
}

}  // namespace

void add_stepped_input_arguments(CLI::App& app, SteppedInputArguments& arguments) {
  add_text(app, "--script", arguments.script, "SCENE", "script that wrote the file of samples, where it carries none");
  add_integer(app, "--simulation", arguments.simulation, 1, std::int64_t{1} << 40,
              "which simulation of the script (default: the one with the file's name; of a script, the first that "
              "suits)");
  add_scene_overrides(app, arguments.overrides);
}

SteppedInput open_stepped_input(const SteppedInputArguments& arguments, SteppedUse use, const WorkControl& control) {
  SteppedInput stepped = is_script(arguments.path) ? of_scene(arguments, use, control) : of_file(arguments, use);
  stepped.problems = ranked(std::move(stepped.problems));
  return stepped;
}

}  // namespace sarsim::cli
