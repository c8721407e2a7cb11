#include "workflow/record/geometry.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "core/report/invalid_request.hpp"
#include "core/text/number_text.hpp"
#include "scene/check/check.hpp"
#include "workflow/input/motion_input.hpp"
#include "workflow/input/recording_options.hpp"
#include "workflow/input/scene_input.hpp"

namespace sarsim::workflow {

namespace {

// The scene whose tables are wanted, and the simulation that a recording is of.
struct GeometrySource {
  scene::Scene scene;
  std::optional<std::size_t> simulation;
  std::vector<std::filesystem::path> files;
  core::Problems remarks;  // about these files

  /// Where the data files of the script are looked for.
  [[nodiscard]] std::filesystem::path folder() const {
    return files.empty() ? std::filesystem::path() : files.front().parent_path();
  }
};

constexpr double unlimited_m = 1e300;

GeometrySource source_of(const GeometryRequest& request, const core::WorkControl& control) {
  const RecordingArguments& arguments = request.input;
  if (arguments.held ? !arguments.held->rows : arguments.script.empty() && holds_script(arguments.path)) {
    SceneInput input = arguments.held
                           ? check_again(arguments.held->input, CheckLevel::values, control, {}, arguments.overrides)
                           : read_scene(arguments.path, arguments.overrides, CheckLevel::values, control);
    expect_usable(input);
    return {std::move(input.scene), {}, std::move(input.sources), std::move(input.of_files)};
  }
  StoredRecording recording = open_recording(
      arguments, records_pulses, [](const simulate::Acquisition&) { return core::Problems(); }, control);
  return {std::move(recording.scene), recording.simulation, std::move(recording.sources),
          std::move(recording.problems)};
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
scene::GeometryTable described_table(const GeometryRequest& request, const scene::Scene& scene) {
  if (!request.start_s || !request.end_s)
    throw core::InvalidRequest("a table of a radar needs --start and --end",
                               "give the send times of its first and last pulse in s");
  if (*request.end_s < *request.start_s)
    throw core::InvalidRequest(fmt::format("--end {} lies before --start {}", core::format_number(*request.end_s),
                                           core::format_number(*request.start_s)),
                               "exchange them");
  return whole_table(scene.radars[radar_named(scene, request.radar)].name, *request.start_s, *request.end_s);
}

std::vector<scene::GeometryTable> chosen_tables(const GeometryRequest& request, const GeometrySource& source) {
  const scene::Scene& scene = source.scene;
  if (!request.radar.empty()) return {described_table(request, scene)};
  if (request.start_s || request.end_s)
    throw core::InvalidRequest("--start and --end belong to a table of a radar", "name it with --radar");
  if (source.simulation && request.numbers.empty()) {
    const scene::Simulation& recorded = scene.simulations[*source.simulation];
    return {whole_table(recorded.radar, recorded.time_start_s, recorded.time_end_s)};
  }
  if (scene.geometries.empty())
    throw core::InvalidRequest(request.input.path + ": the scene has no geometry table",
                               "choose pulses with --radar, --start and --end");
  if (request.numbers.empty()) return scene.geometries;
  std::vector<scene::GeometryTable> tables;
  for (const std::string& word : request.numbers) {
    const auto number = core::parse_integer(word);
    if (!number || *number < 1 || *number > static_cast<std::int64_t>(scene.geometries.size()))
      throw core::InvalidRequest(fmt::format("the scene has no geometry table '{}'", word),
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

// What the script does not say has not been checked with it: whether pulses leave at these times.
// @returns  warnings about the files of its motions
core::Problems expect_pulses(const scene::GeometryTable& table, scene::Scene& scene,
                             const std::filesystem::path& folder) {
  scene.geometries = {table};
  scene.geometries[0].file = "table";
  scene.geometries[0].range_end_m = 1.0;
  core::Problems remarks = read_motions(scene, folder);  // which may be needed for other times now
  core::Problems problems = remarks;
  core::append(problems, scene::check(scene));
  std::erase_if(problems, [](const core::Problem& p) { return p.severity != core::Severity::error; });
  if (!problems.empty()) throw core::InvalidRequest(std::move(problems));
  return remarks;
}

}  // namespace

OptionTable<GeometryRequest> geometry_choice_options() {
  OptionTable<GeometryRequest> table;
  table.text("--radar", "NAME", "make a table of this radar instead", &GeometryRequest::radar);
  table.number("--start", "S", "send time of its first pulse, s", &GeometryRequest::start_s);
  table.number("--end", "S", "send time of its last pulse, s", &GeometryRequest::end_s);
  table.flag("--no-targets", "the platforms alone: tracks and attitudes", &GeometryRequest::no_targets);
  return table;
}

OptionTable<GeometryRequest> geometry_option_table() {
  OptionTable<GeometryRequest> table;
  table.texts("--table", "NUMBER", "which table of the scene, from 1 (default: all); repeat",
              [](GeometryRequest& request, const std::string& word) { request.numbers.push_back(word); });
  table.include(geometry_choice_options(), [](GeometryRequest& request) -> GeometryRequest& { return request; });
  table.include(recording_options(), &GeometryRequest::input);
  return table;
}

GeometryTables geometry_tables(const GeometryRequest& request, const core::WorkControl& control) {
  GeometrySource source = source_of(request, control);
  if (request.no_targets) remove_targets(source.scene);
  std::vector<scene::GeometryTable> tables = chosen_tables(request, source);
  if (!request.radar.empty()) source.remarks = expect_pulses(tables.front(), source.scene, source.folder());
  if (request.columns)
    for (scene::GeometryTable& table : tables) table.columns = *request.columns;
  return {std::move(source.scene), std::move(tables), std::move(source.files), core::ranked(std::move(source.remarks))};
}

}  // namespace sarsim::workflow
