#include <algorithm>
#include <filesystem>
#include <functional>
#include <memory>
#include <ostream>
#include <span>

#include <fmt/format.h>

#include "cli/command/commands.hpp"
#include "cli/shell/options.hpp"
#include "cli/shell/scene_options.hpp"
#include "core/os/output_file.hpp"
#include "core/text/number_text.hpp"
#include "scene/check/check.hpp"
#include "simulate/run/geometry_table.hpp"
#include "workflow/input/motion_input.hpp"
#include "workflow/input/output_names.hpp"
#include "workflow/input/recording_input.hpp"
#include "workflow/input/scene_input.hpp"

namespace sarsim::cli {

namespace {

struct GeometryArguments {
  std::string input;
  std::string script;
  std::vector<std::string> numbers;
  std::string radar;
  std::optional<double> start_s;
  std::optional<double> end_s;
  std::optional<std::int64_t> columns;
  std::string output;
  bool csv = false;
  bool no_targets = false;
  bool force = false;
  workflow::SceneOverrides overrides;
};

// The scene whose tables are wanted, and the simulation that a recording is of.
struct GeometrySource {
  scene::Scene scene;
  std::optional<std::size_t> simulation;
  std::vector<std::filesystem::path> files;

  /// Where the data files of the script are looked for.
  [[nodiscard]] std::filesystem::path folder() const {
    return files.empty() ? std::filesystem::path() : files.front().parent_path();
  }
};

constexpr double unlimited_m = 1e300;

GeometrySource source_of(const GeometryArguments& arguments) {
  if (arguments.script.empty() && workflow::holds_script(arguments.input)) {
    workflow::SceneInput input = workflow::read_scene(arguments.input, arguments.overrides, workflow::Scrutiny::values);
    workflow::expect_usable(input);
    return {std::move(input.scene), {}, std::move(input.sources)};
  }
  workflow::StoredRecording recording =
      workflow::open_recording({arguments.input, arguments.script, {}, arguments.overrides}, workflow::records_pulses,
                               [](const simulate::Plan&) { return core::Problems(); });
  return {std::move(recording.scene), recording.simulation, std::move(recording.sources)};
}

// Every target, wherever it is.
scene::GeometryTable whole_table(const std::string& radar, double start_s, double end_s) {
  scene::GeometryTable table;
  table.radar = radar;
  table.range_start_m = 0.0;
  table.range_end_m = unlimited_m;
  table.time_start_s = start_s;
  table.time_end_s = end_s;
  table.columns = 255;
  return table;
}

// The table that --radar, --start and --end describe.
scene::GeometryTable described_table(const GeometryArguments& arguments, const scene::Scene& scene) {
  if (!arguments.start_s || !arguments.end_s)
    throw core::Refused("a table of a radar needs --start and --end",
                        "give the send times of its first and last pulse in s");
  if (*arguments.end_s < *arguments.start_s)
    throw core::Refused(fmt::format("--end {} lies before --start {}", core::format_number(*arguments.end_s),
                                    core::format_number(*arguments.start_s)),
                        "exchange them");
  return whole_table(scene.radars[workflow::radar_named(scene, arguments.radar)].name, *arguments.start_s,
                     *arguments.end_s);
}

std::vector<scene::GeometryTable> chosen_tables(const GeometryArguments& arguments, const GeometrySource& source) {
  const scene::Scene& scene = source.scene;
  if (!arguments.radar.empty()) return {described_table(arguments, scene)};
  if (arguments.start_s || arguments.end_s)
    throw core::Refused("--start and --end belong to a table of a radar", "name it with --radar");
  if (source.simulation && arguments.numbers.empty()) {
    const scene::Simulation& recorded = scene.simulations[*source.simulation];
    return {whole_table(recorded.radar, recorded.time_start_s, recorded.time_end_s)};
  }
  if (scene.geometries.empty())
    throw core::Refused(arguments.input + ": the scene has no geometry table",
                        "choose pulses with --radar, --start and --end");
  if (arguments.numbers.empty()) return scene.geometries;
  std::vector<scene::GeometryTable> tables;
  for (const std::string& word : arguments.numbers) {
    const auto number = core::parse_integer(word);
    if (!number || *number < 1 || *number > static_cast<std::int64_t>(scene.geometries.size()))
      throw core::Refused(fmt::format("the script has no geometry table '{}'", word),
                          fmt::format("tables have the numbers 1 to {}", scene.geometries.size()));
    tables.push_back(scene.geometries[static_cast<std::size_t>(*number) - 1]);
  }
  return tables;
}

// Tables tell where platforms are whether or not anything is on them.
void remove_targets(scene::Scene& scene) {
  scene.targets.clear();
  scene.clouds.clear();
  scene.surfaces.clear();
}

void write_tables(const GeometryArguments& arguments, const scene::Scene& scene,
                  const std::vector<scene::GeometryTable>& tables, const std::function<void(std::string_view)>& write,
                  const core::StopFlag* stop) {
  for (std::size_t i = 0; i < tables.size(); ++i) {
    if (i > 0) write("\n");
    arguments.csv ? simulate::write_geometry_csv(scene, tables[i], write, stop)
                  : simulate::write_geometry_text(scene, tables[i], write, stop);
  }
}

// What the script does not say has not been checked with it: whether pulses leave at these times.
void expect_pulses(const scene::GeometryTable& table, scene::Scene& scene, const std::filesystem::path& folder) {
  scene.geometries = {table};
  scene.geometries[0].file = "table";
  scene.geometries[0].range_end_m = 1.0;
  core::Problems problems = workflow::read_motions(scene, folder);  // which may be needed for other times now
  std::ranges::move(scene::check(scene), std::back_inserter(problems));
  std::erase_if(problems, [](const core::Problem& p) { return p.severity != core::Severity::error; });
  if (!problems.empty()) throw core::Refused(std::move(problems));
}

ExitStatus print_geometry(const GeometryArguments& arguments, Streams& streams) {
  GeometrySource source = source_of(arguments);
  if (arguments.no_targets) remove_targets(source.scene);
  std::vector<scene::GeometryTable> tables = chosen_tables(arguments, source);
  if (!arguments.radar.empty()) expect_pulses(tables.front(), source.scene, source.folder());
  if (arguments.columns)
    for (scene::GeometryTable& table : tables) table.columns = static_cast<int>(*arguments.columns);
  if (arguments.output.empty()) {
    const auto write = [&](std::string_view piece) { write_out(streams, piece); };
    write_tables(arguments, source.scene, tables, write, streams.stop);
    return exit_done;
  }
  workflow::expect_free_outputs({arguments.output}, {source.files, arguments.force, "-o"});
  core::OutputFile file(arguments.output, arguments.force);
  const auto write = [&](std::string_view piece) { file.write(std::as_bytes(std::span(piece))); };
  write_tables(arguments, source.scene, tables, write, streams.stop);
  file.commit();
  return exit_done;
}

}  // namespace

Action add_geometry(CLI::App& app) {
  auto arguments = std::make_shared<GeometryArguments>();
  add_text(app, "input", arguments->input, "SCENE|DATA", "script, or a recording, whose pulses are shown")->required();
  add_text(app, "--script", arguments->script, "SCENE", "script that wrote the recording, where it carries none");
  auto* numbers = app.add_option("numbers", arguments->numbers, "which tables of the script, from 1 (default: all)")
                      ->type_name("NUMBER");
  auto* radar = add_text(app, "--radar", arguments->radar, "NAME", "make a table of this radar instead");
  numbers->excludes(radar);
  add_real(app, "--start", arguments->start_s, "S", "send time of its first pulse, s");
  add_real(app, "--end", arguments->end_s, "S", "send time of its last pulse, s");
  add_integer(app, "--columns", arguments->columns, 0, 255, "sum of column bits, see docs/formats/geometry-table.md");
  app.add_flag("--csv", arguments->csv, "comma-separated values, all columns, exact numbers");
  app.add_flag("--no-targets", arguments->no_targets, "the platforms alone: tracks and attitudes");
  add_text(app, "-o,--out,--output", arguments->output, "FILE", "file to write (default: standard output)");
  app.add_flag("--force", arguments->force, "replace the output file where it exists");
  add_scene_overrides(app, arguments->overrides);
  add_examples(app, {{"sarsim geometry scene.toml", "the geometry tables of the scene"},
                     {"sarsim geometry sar_r.toml --radar Radar1 --start 0 --end 0.1", "any other pulses"},
                     {"sarsim geometry scene.toml 1 --csv -o table.csv", "for other programs"},
                     {"sarsim geometry sar_r.h5 --no-targets --csv -o track.csv",
                      "the track and attitude of a recording, pulse by pulse"}});
  return [arguments](Streams& streams) { return print_geometry(*arguments, streams); };
}

}  // namespace sarsim::cli
