#include "workflow/input/sample_input.hpp"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "core/report/invalid_request.hpp"
#include "raster/table/formats.hpp"
#include "simulate/plan/plan.hpp"
#include "workflow/input/output_names.hpp"
#include "workflow/input/scene_input.hpp"

namespace sarsim::workflow {

namespace fs = std::filesystem;

namespace {

// Of converters of 32 bits, whose largest counts are then volts of single precision.
constexpr double largest_lsb_v = 1e29;
// The least of single precision that has all its digits is 1.2e-38.
constexpr double smallest_lsb_v = 1e-37;

// How a command lets its user choose the simulation of a script.
struct Choice {
  bool by_number = false;  // It has --simulation.
  std::optional<std::int64_t> number = {};

  [[nodiscard]] std::string other_ways() const {
    return fmt::format("{}say --columns, --bits and --lsb instead of --script",
                       by_number ? "say which with --simulation N, or " : "");
  }
};

// The outputs of a script, and how a file comes to one of them.
std::string ways_to_outputs(const scene::Scene& scene, const Choice& choice) {
  std::string known;
  for (const fs::path& other : output_names(scene, {}).simulations)
    known += (known.empty() ? "" : ", ") + other.filename().string();
  if (known.empty()) return "it has none: say --columns, --bits and --lsb instead of --script";
  return fmt::format("its outputs are {}: give the file its name there, {}{}", known, choice.by_number ? "" : "or ",
                     choice.other_ways());
}

// The one with a number from 1, or else the one that writes a file of this name.
std::size_t simulation_of(const scene::Scene& scene, const std::string& path, const std::string& script,
                          const Choice& choice) {
  if (choice.number) {
    if (*choice.number >= 1 && static_cast<std::size_t>(*choice.number) <= scene.simulations.size())
      return static_cast<std::size_t>(*choice.number) - 1;
    throw core::InvalidRequest(fmt::format("--simulation: the scene has no recording {}", *choice.number),
                               fmt::format("it has {}", scene.simulations.size()));
  }
  const fs::path name = fs::path(path).filename();
  const auto found = simulation_that_writes(
      name, scene, "give the file the whole name that the scene has for it, or " + choice.other_ways());
  if (found) return *found;
  throw core::InvalidRequest(fmt::format("no recording of {} writes '{}'", script, name.string()),
                             ways_to_outputs(scene, choice));
}

// The simulation that writes a file.
simulate::Acquisition recording_of(const std::string& path, const std::string& script, const Choice& choice,
                                   const core::Observer& observer) {
  const core::WorkControl control = observer.control(core::thread_count(0));
  SceneInput input = read_scene(script, {}, CheckLevel::values, control);
  expect_usable(input);
  observer.remarks(input.of_files);
  const std::size_t index = simulation_of(input.scene, path, script, choice);
  resolve_once(input, control);
  return simulate::acquisition_of(input.scene, index, input.resolved, observer.stop);
}

void take_script(raster::RasterHints& hints, const std::string& path, const std::string& script, const Choice& choice,
                 const core::Observer& observer) {
  const simulate::Acquisition acquisition = recording_of(path, script, choice, observer);
  const scene::Simulation& simulation = acquisition.simulation;
  hints.columns = acquisition.reception.columns;
  hints.rows = acquisition.timing.rows;
  hints.bits = simulation.bits;
  hints.lsb_v = simulation.lsb_v;
  if (fs::path(path).extension() == fs::path(base_name(simulation.file)).extension()) hints.format = simulation.format;
}

raster::RasterHints hints_said(const std::string& path, const SampleArguments& arguments, const Choice& choice,
                               const core::Observer& observer) {
  raster::RasterHints hints;
  if (!arguments.script.empty()) take_script(hints, path, arguments.script, choice, observer);
  if (arguments.format) hints.format = arguments.format;
  if (arguments.columns) {
    hints.columns = static_cast<std::size_t>(*arguments.columns);
    hints.rows = 0;
  }
  hints.dataset = arguments.dataset;
  if (arguments.bits) hints.bits = static_cast<int>(*arguments.bits);
  if (arguments.lsb_v) {
    if (!(*arguments.lsb_v > 0.0)) throw core::InvalidRequest("--lsb must be above 0", "give the volts of one count");
    if (!(*arguments.lsb_v <= largest_lsb_v))
      throw core::InvalidRequest(
          fmt::format("--lsb is too large; found {:g} V, expected at most {:g} V", *arguments.lsb_v, largest_lsb_v),
          "volts of samples are numbers of single precision, below 3.4e38");
    if (!(*arguments.lsb_v >= smallest_lsb_v))
      throw core::InvalidRequest(
          fmt::format("--lsb is too small; found {:g} V, expected at least {:g} V", *arguments.lsb_v, smallest_lsb_v),
          "volts of samples are numbers of single precision, from 1.2e-38 on");
    hints.lsb_v = *arguments.lsb_v;
  }
  return hints;
}

}  // namespace

raster::RasterHints hints_for(const std::string& path, const SampleArguments& arguments,
                              const core::Observer& observer) {
  return hints_said(path, arguments, {}, observer);
}

raster::RasterHints hints_for(const std::string& path, const SampleArguments& arguments,
                              std::optional<std::int64_t> simulation, const core::Observer& observer) {
  return hints_said(path, arguments, {true, simulation}, observer);
}

simulate::Acquisition acquisition_of_file(const std::string& path, const std::string& script,
                                          std::optional<std::int64_t> simulation, const core::StopFlag* stop) {
  core::Observer alone;
  alone.stop = stop;
  return recording_of(path, script, {true, simulation}, alone);
}

SampleFile open_samples(const std::string& path, const raster::RasterHints& hints, const core::Observer& observer,
                        raster::Integrity integrity) {
  raster::OpenedRaster opened = raster::open_raster(integrity, path, hints, observer.stop);
  if (!opened.raster) throw core::InvalidRequest(core::ranked(std::move(opened.problems)));
  observer.remarks(core::ranked(std::move(opened.problems)));
  return {std::move(opened.raster), std::move(opened.axes)};
}

std::size_t rows_at_once(std::size_t columns) {
  constexpr std::size_t samples = 1U << 18U;
  return std::max<std::size_t>(1, samples / std::max<std::size_t>(columns, 1));
}

}  // namespace sarsim::workflow
