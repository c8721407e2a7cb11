#include "workflow/input/scene_input.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <set>
#include <tuple>

#include <fmt/format.h>

#include "core/report/invalid_request.hpp"
#include "core/text/number_text.hpp"
#include "scene/check/check.hpp"
#include "scene/edit/data_functions.hpp"
#include "scene/language/scene_reader.hpp"
#include "scene/language/words.hpp"
#include "scene/model/cloud_points.hpp"
#include "scene/model/scene_index.hpp"
#include "scene/schema/field_names.hpp"
#include "simulate/survey/survey.hpp"
#include "simulate/survey/table_rules.hpp"
#include "workflow/input/bare_number.hpp"
#include "workflow/input/cloud_input.hpp"
#include "workflow/input/motion_input.hpp"
#include "workflow/input/target_tables.hpp"

namespace sarsim::workflow {

namespace fs = std::filesystem;

namespace {

using Object = std::pair<std::string, std::size_t>;

std::size_t objects_of(const scene::Scene& scene, std::string_view kind) {
  if (kind == "platform") return scene.platforms.size();
  if (kind == "radar") return scene.radars.size();
  return scene::not_found;
}

// What check finds about objects that the reader could not make sense of, and about what uses them, would only repeat
// the reader; so would names of platforms and radars that could not be read at all.
core::Problems without_objects_of(core::Problems found, const core::Problems& reading, const scene::Scene& scene) {
  std::set<Object> broken;
  bool lost = false;
  for (const core::Problem& problem : reading) {
    if (problem.severity != core::Severity::error) continue;
    broken.insert({problem.subject.kind, problem.subject.index});
    lost = lost || problem.subject.kind.empty() || problem.subject.field == "name" ||
           problem.subject.index >= objects_of(scene, problem.subject.kind);
  }
  if (broken.empty()) return found;
  scene::SceneIndex names(scene);
  const auto add_users = [&](const char* kind, const auto& products) {
    for (std::size_t i = 0; i < products.size(); ++i)
      if (broken.contains({"radar", names.radar(products[i].radar)})) broken.insert({kind, i});
  };
  add_users("simulation", scene.simulations);
  add_users("geometry", scene.geometries);
  std::erase_if(found, [&](const core::Problem& p) {
    const bool name = p.subject.field == "platform" || p.subject.field == "radar";
    return broken.contains({p.subject.kind, p.subject.index}) || (lost && name);
  });
  return found;
}

// Where check refuses a field, what the reader had to remark about it is said already.
void drop_warnings_of(const core::Problems& found, core::Problems& reading) {
  using Key = std::tuple<std::string, std::size_t, std::string>;
  const auto key_of = [](const core::Subject& subject) { return Key(subject.kind, subject.index, subject.field); };
  std::set<Key> refused;
  for (const core::Problem& problem : found)
    if (problem.severity == core::Severity::error) refused.insert(key_of(problem.subject));
  std::erase_if(reading, [&](const core::Problem& remark) {
    return remark.severity == core::Severity::warning && refused.contains(key_of(remark.subject));
  });
}

void apply(const SceneOverrides& overrides, scene::Scene& scene) {
  scene::RunOptions& options = scene.options;
  if (overrides.profile) options.profile = *overrides.profile;
  if (overrides.pulse) options.pulse = *overrides.pulse;
  if (overrides.tolerance) options.tolerance = *overrides.tolerance;
  if (overrides.seed) options.seed = *overrides.seed;
  if (overrides.format)
    for (scene::Simulation& simulation : scene.simulations) simulation.format = *overrides.format;
}

std::vector<TargetTable> tables_of(const SceneOverrides& overrides, const scene::Scene& scene) {
  std::vector<TargetTable> tables;
  for (const std::string& word : overrides.targets) tables.push_back(target_table_of(word, scene));
  return tables;
}

// Sets one field. Returns empty, or why not, in words.
// @param[out] remarks  what is allowed but probably not meant
std::string failure_of_setting(const std::string& name, const std::string& value, scene::Scene& scene,
                               const scene::PointsLoader& load, core::Problems& remarks) {
  const scene::NamedField field = scene::find_named_field(scene, name, value);
  if (field.field == nullptr) return field.failure;
  if (auto remark = remark_on_bare_number(scene, field, name, value)) remarks.push_back(std::move(*remark));
  return scene::set_named_field(scene, field, value, load);
}

// One field after the other, so that a later one may need what an earlier one chose.
// @param[out] remarks  what is allowed but probably not meant
core::Problems problems_of_setting(const std::vector<std::string>& settings, scene::Scene& scene,
                                   const scene::PointsLoader& load, core::Problems& remarks) {
  core::Problems problems;
  for (const std::string& setting : settings) {
    const std::size_t equals = std::min(setting.find('='), setting.size());
    const std::string failure =
        equals == setting.size()
            ? "there is no '='; write OBJECT.FIELD=VALUE, as in Radar1.bandwidth=10MHz"
            : failure_of_setting(setting.substr(0, equals), setting.substr(equals + 1), scene, load, remarks);
    if (failure.empty()) continue;
    problems.push_back({});
    problems.back().message = "--set " + setting.substr(0, 80) + ": " + failure;
  }
  return problems;
}

template <class Item>
void append(std::vector<Item>& items, std::vector<Item> more) {
  std::ranges::move(more, std::back_inserter(items));
}

// Where the survey told which targets are beyond the unambiguous range, their window need not be told of.
void drop_windows_of_late_echoes(const core::Problems& of_echoes, core::Problems& found) {
  constexpr core::RuleId beyond_unambiguous = "range-window.beyond-unambiguous", late_echoes = "echoes.late";
  std::erase_if(found, [&](const core::Problem& window) {
    return window.id == beyond_unambiguous && std::ranges::any_of(of_echoes, [&](const core::Problem& p) {
             return p.subject.kind == window.subject.kind && p.subject.index == window.subject.index &&
                    p.id == late_echoes;
           });
  });
}

// Problems of products that nobody wants.
void forget_others(core::Problems& problems, const WantedProducts& wanted) {
  const auto lacks = [](const std::vector<std::size_t>& some, std::size_t index) {
    return !std::ranges::binary_search(some, index);
  };
  std::erase_if(problems, [&](const core::Problem& p) {
    return (p.subject.kind == "simulation" && lacks(wanted.simulations, p.subject.index)) ||
           (p.subject.kind == "geometry" && lacks(wanted.geometries, p.subject.index));
  });
}

// The points of clouds are targets to the survey; which of them it means is not known where it saw only some.
void name_clouds(core::Problems& problems, const scene::Scene& scene, const simulate::ResolvedScene& surveyed) {
  for (core::Problem& problem : problems) {
    if (problem.subject.kind != "target" || problem.subject.index < scene.targets.size()) continue;
    const auto& clouds = surveyed.scatterers.clouds();
    std::size_t number = 0;
    while (number + 1 < clouds.size() && clouds[number + 1].first <= problem.subject.index) ++number;
    problem.subject = {"cloud", number, "file"};
    problem.message += " (of a point of the cloud)";
  }
}

// What the survey did not look at.
void note_thinning(core::Problems& problems, const scene::Scene& scene) {
  for (std::size_t i = 0; i < scene.clouds.size(); ++i) {
    const std::size_t points = scene::point_count(scene.clouds[i]);
    if (points <= max_cloud_looks) continue;
    problems.push_back(
        core::note(
            "cloud.thinned",
            fmt::format("echo figures are based on {} of the {} points of the cloud; target counts include only those",
                        max_cloud_looks, points))
            .at("cloud", i, "file"));
  }
}

// Whether the scene was read from a text in the language of 1998; one that a program made has no places.
bool is_script(const SceneInput& input) {
  return input.language == scene::Language::script && !input.places.find({"radar", 0, ""}).file.empty();
}

// What the survey says of the simulations that are wanted; of all where nobody said which.
core::Problems problems_of_echoes(SceneInput& input, const std::optional<WantedProducts>& wanted,
                                  const core::WorkControl& control) {
  if (input.scene.simulations.empty() || (wanted && wanted->simulations.empty())) return {};
  resolve_once(input, control);
  std::vector<scene::Simulation> all = input.scene.simulations;
  if (wanted) {
    input.scene.simulations.clear();
    for (const std::size_t index : wanted->simulations) input.scene.simulations.push_back(all.at(index));
  }
  const auto surveyed = simulate::thinned(input.resolved, max_cloud_looks);
  simulate::SurveyReport report = simulate::survey_report(input.scene, surveyed, control);
  if (is_script(input) || input.scene.options.profile == scene::Profile::classic)
    core::append(report.problems, simulate::differences_of_profiles(input.scene, report.summaries));
  name_clouds(report.problems, input.scene, *surveyed);
  note_thinning(report.problems, input.scene);
  input.scene.simulations = std::move(all);
  input.echoes = std::move(report.summaries);
  if (!wanted) return std::move(report.problems);
  for (simulate::EchoSummary& summary : input.echoes) summary.simulation = wanted->simulations.at(summary.simulation);
  for (core::Problem& problem : report.problems)
    if (problem.subject.kind == "simulation") problem.subject.index = wanted->simulations.at(problem.subject.index);
  return std::move(report.problems);
}

scene::ReadControl read_control(const SceneOverrides& overrides, const core::WorkControl& control) {
  scene::ReadControl read{control};
  for (const std::string& word : overrides.let) {
    const std::size_t equals = std::min(word.find('='), word.size());
    if (equals == word.size())
      throw core::InvalidRequest(fmt::format("--let {}: there is no '='", word), "write NAME=VALUE, as in speed=300");
    read.let.emplace_back(word.substr(0, equals), word.substr(equals + 1));
  }
  return read;
}

core::Problem nothing_asked(scene::Language language) {
  const bool is_script = language == scene::Language::script;
  return core::warning("scene.asks-for-nothing",
                       is_script ? "the script defines nothing to compute" : "the scene defines nothing to compute")
      .expected("a recording or a geometry table")
      .hint(is_script ? "add a $SIMULATION or a $GEOMETRY" : "add a [[recording]] or a [[geometry]]");
}

// What was found in some files themselves, as in those of functions by points.
core::Problems problems_in(const std::vector<std::filesystem::path>& files, const core::Problems& problems) {
  core::Problems found;
  std::ranges::copy_if(problems, std::back_inserter(found), [&](const core::Problem& problem) {
    return std::ranges::any_of(files, [&](const auto& file) { return file == problem.place.file; });
  });
  return found;
}

void keep_warnings(core::Problems& problems) {
  std::erase_if(problems, [](const core::Problem& problem) { return problem.severity != core::Severity::warning; });
}

// As they are said of the scene.
core::Problems warnings_of_files(core::Problems problems, const SceneInput& input) {
  keep_warnings(problems);
  if (input.language == scene::Language::format_2) scene::say_in_format_2(problems);
  scene::locate(problems, input.places);
  return core::ranked(std::move(problems));
}

// What files have to be warned of that nobody needs yet; nothing of them is kept, and they need not be there.
core::Problems warnings_by_look(const scene::Scene& scene, const std::filesystem::path& folder,
                                const core::WorkControl& control) {
  if (data_files_of(scene, folder).empty()) return {};
  scene::Scene looked = scene;
  core::Problems found = read_files_of(looked, folder, control);
  keep_warnings(found);
  return found;
}

// A scene with what its reader found, on its way to an input.
SceneInput looked_at(scene::ScriptReading reading, const std::filesystem::path& folder, const SceneOverrides& overrides,
                     CheckLevel check_level, const core::WorkControl& control, const ChooseProducts& choose) {
  SceneInput input;
  input.scene = std::move(reading.scene);
  input.places = std::move(reading.places);
  input.language = reading.language;
  input.json = reading.json;
  input.names = std::move(reading.names);
  apply(overrides, input.scene);
  core::Problems of_tables = add_targets(tables_of(overrides, input.scene), input.scene, control.stop);
  if (core::has_errors(of_tables)) throw core::InvalidRequest(std::move(of_tables));
  core::append(reading.problems, std::move(of_tables));
  if (!overrides.settings.empty() && !core::has_errors(reading.problems))
    if (core::Problems mistakes =
            problems_of_setting(overrides.settings, input.scene, scene::disk_points(folder), reading.problems);
        !mistakes.empty())
      throw core::InvalidRequest(std::move(mistakes));
  core::Problems of_files = problems_in(data_files_of(input.scene, folder), reading.problems);
  core::Problems of_look;
  if (check_level != CheckLevel::reading && !core::has_errors(reading.problems)) {
    const bool keeps = check_level != CheckLevel::files;
    core::Problems read =
        keeps ? read_files_of(input.scene, folder, control) : warnings_by_look(input.scene, folder, control);
    if (!keeps) of_look = read;
    core::append(of_files, read);
    core::append(reading.problems, std::move(read));
  }
  std::optional<WantedProducts> wanted;
  if (choose && !core::has_errors(reading.problems)) wanted = choose(input.scene);
  if (check_level != CheckLevel::reading && check_level != CheckLevel::files) {
    core::Problems found = without_objects_of(scene::check(input.scene, control), reading.problems, input.scene);
    if (core::has_errors(reading.problems))  // Files were not read then.
      std::erase_if(found, [](const core::Problem& p) { return p.id == core::RuleId("motion-file.unread"); });
    if (overrides.format)  // Outputs take its extension.
      std::erase_if(found, [](const core::Problem& p) { return p.id == core::RuleId("output.other-extension"); });
    if (wanted) forget_others(found, *wanted);
    drop_warnings_of(found, reading.problems);
    core::append(reading.problems, std::move(found));
  }
  if (check_level == CheckLevel::echoes && !core::has_errors(reading.problems)) {
    core::Problems of_echoes = problems_of_echoes(input, wanted, control);
    drop_windows_of_late_echoes(of_echoes, reading.problems);
    core::append(reading.problems, std::move(of_echoes));
  }
  if (check_level == CheckLevel::echoes && !core::has_errors(reading.problems) && input.scene.simulations.empty() &&
      input.scene.geometries.empty())
    reading.problems.push_back(nothing_asked(input.language));
  if (input.language == scene::Language::format_2) scene::say_in_format_2(reading.problems);
  scene::locate(reading.problems, input.places);
  input.problems = core::ranked(std::move(reading.problems));
  input.of_files = warnings_of_files(std::move(of_files), input);
  input.of_look = warnings_of_files(std::move(of_look), input);
  return input;
}

}  // namespace

std::optional<scene::Language> language_of_name(const std::filesystem::path& file) {
  const std::string ending = file.extension().string();
  if (core::equal_ignoring_case(ending, ".scr")) return scene::Language::script;
  if (core::equal_ignoring_case(ending, ".toml")) return scene::Language::format_2;
  return std::nullopt;
}

namespace {

// What a reader found in a text, as an input with all files that belong to it.
SceneInput input_of(scene::ScriptReading reading, const std::string& path, const SceneOverrides& overrides,
                    CheckLevel check_level, const core::WorkControl& control, const ChooseProducts& choose) {
  std::vector<std::filesystem::path> sources{path};
  append(sources, std::move(reading.included));
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  append(sources, data_files_of(reading.scene, folder));
  SceneInput input = looked_at(std::move(reading), folder, overrides, check_level, control, choose);
  append(sources, data_files_of(input.scene, folder));  // Those that settings name, too.
  for (TargetTable& table : tables_of(overrides, input.scene)) sources.push_back(std::move(table.file));
  input.sources = std::move(sources);
  return input;
}

std::filesystem::path folder_of(const SceneInput& input) {
  return input.sources.empty() ? std::filesystem::path() : input.sources.front().parent_path();
}

}  // namespace

SceneInput read_scene(const std::string& path, const SceneOverrides& overrides, CheckLevel check_level,
                      const core::WorkControl& control, const ChooseProducts& choose) {
  return input_of(scene::read_scene_file(path, read_control(overrides, control)), path, overrides, check_level, control,
                  choose);
}

SceneInput read_scene_text(std::string_view text, const std::string& name, const SceneOverrides& overrides,
                           CheckLevel check_level, const core::WorkControl& control) {
  const scene::DataFileLoader loader = scene::disk_loader(std::filesystem::path(name).parent_path());
  return input_of(scene::read_scene_text(text, name, loader, read_control(overrides, control)), name, overrides,
                  check_level, control, {});
}

namespace {

core::Problems without(core::Problems problems, const core::Problems& some) {
  std::erase_if(problems, [&](const core::Problem& problem) {
    return std::ranges::any_of(some, [&](const core::Problem& one) {
      return one.severity == problem.severity && one.message == problem.message && one.found == problem.found &&
             one.place == problem.place;
    });
  });
  return problems;
}

}  // namespace

SceneInput check_again(const SceneInput& known, CheckLevel check_level, const core::WorkControl& control,
                       const ChooseProducts& choose, const SceneOverrides& overrides) {
  if (!overrides.let.empty())
    throw core::InvalidRequest("--let means nothing for a scene that was read already",
                               "give the values when it is read");
  scene::ScriptReading reading;
  reading.scene = known.scene;
  reading.problems = without(known.problems, known.of_look);
  reading.places = known.places;
  reading.language = known.language;
  reading.json = known.json;
  reading.names = known.names;
  SceneInput input = looked_at(std::move(reading), folder_of(known), overrides, check_level, control, choose);
  input.sources = known.sources;
  append(input.sources, data_files_of(input.scene, folder_of(known)));
  return input;
}

std::string field_value(const SceneInput& input, const std::string& name) {
  const scene::NamedField field = scene::find_named_field(input.scene, name);
  if (field.field == nullptr) throw core::InvalidRequest(field.failure);
  return scene::named_field_text(input.scene, field);
}

core::Problems set_field_value(SceneInput& input, const std::string& name, const std::string& value) {
  core::Problems remarks;
  scene::Scene changed = input.scene;
  const std::string failure = failure_of_setting(name, value, changed, scene::disk_points(folder_of(input)), remarks);
  if (!failure.empty()) throw core::InvalidRequest(fmt::format("{}: {}", name, failure));
  input.scene = std::move(changed);
  return remarks;
}

SceneInput take_scene(scene::Scene scene, const std::filesystem::path& folder, const SceneOverrides& overrides,
                      CheckLevel check_level, const core::WorkControl& control, const ChooseProducts& choose) {
  scene::ScriptReading reading;
  reading.scene = std::move(scene);
  std::vector<std::filesystem::path> sources = data_files_of(reading.scene, folder);
  SceneInput input = looked_at(std::move(reading), folder, overrides, check_level, control, choose);
  append(sources, data_files_of(input.scene, folder));  // Those that settings name, too.
  for (TargetTable& table : tables_of(overrides, input.scene)) sources.push_back(std::move(table.file));
  input.sources = std::move(sources);
  return input;
}

std::vector<std::filesystem::path> data_files_of(const scene::Scene& scene,
                                                 const std::filesystem::path& script_folder) {
  std::set<std::string> names;
  const auto take = [&names](const scene::SharedObject& object) {
    for (const scene::FunctionUse& use : scene::functions_of(object))
      if (!use.file->empty()) names.insert(*use.file);
  };
  for (const scene::Platform& platform : scene.platforms) {
    take(platform);
    if (platform.path == scene::Platform::Path::ephemeris) names.insert(platform.ephemeris_file);
    if (platform.rotation_kind == scene::Platform::Rotation::quaternions) names.insert(platform.attitude_file);
  }
  names.insert(scene.world.geoid);
  names.erase("");
  for (const scene::Radar& radar : scene.radars) take(radar);
  for (const scene::Target& target : scene.targets)
    if (const std::string& file = target.traits->gain_db.file; !file.empty()) names.insert(file);
  for (const scene::Cloud& cloud : scene.clouds) {
    if (!cloud.file.empty()) names.insert(cloud.file);
    if (!cloud.traits.gain_db.file.empty()) names.insert(cloud.traits.gain_db.file);
  }
  std::vector<std::filesystem::path> files;
  for (const std::string& name : names)
    if (auto file = scene::data_file_on_disk(script_folder, name); !file.empty()) files.push_back(std::move(file));
  return files;
}

std::vector<std::filesystem::path> files_of(const SceneOverrides& overrides,
                                            const std::filesystem::path& script_folder) {
  std::vector<std::filesystem::path> files;
  const auto add = [&](const std::string& word) {
    const std::string value = word.substr(word.find('=') + 1);
    std::vector<std::string> names{word, value};
    for (std::size_t begin = 0; begin < value.size();) {  // Several values may vary.
      const std::size_t end = std::min(value.find(',', begin), value.size());
      names.push_back(value.substr(begin, end - begin));
      begin = end + 1;
    }
    for (const std::string& name : names) {
      if (name.empty()) continue;
      std::error_code none;
      for (fs::path& file : std::vector<fs::path>{name, script_folder / name})
        if (fs::is_regular_file(file, none)) files.push_back(std::move(file));
    }
  };
  for (const std::string& table : overrides.targets) add(table);
  for (const std::string& setting : overrides.settings) add(setting);
  return files;
}

std::vector<std::filesystem::path> sources_of_script(const std::string& path) {
  if (path.empty()) return {};
  scene::ScriptReading reading = scene::read_scene_file(path);
  std::vector<std::filesystem::path> sources{path};
  append(sources, std::move(reading.included));
  append(sources, data_files_of(reading.scene, std::filesystem::path(path).parent_path()));
  return sources;
}

void resolve_once(SceneInput& input, const core::WorkControl& control) {
  if (!input.resolved)
    input.resolved = std::make_shared<const simulate::ResolvedScene>(simulate::resolve(input.scene, control));
}

void expect_usable(const SceneInput& input, bool strict) {
  const auto fatal = [strict](const core::Problem& p) {
    return p.severity == core::Severity::error || (strict && p.severity == core::Severity::warning);
  };
  if (std::ranges::any_of(input.problems, fatal)) throw core::InvalidRequest(input.problems);
}

std::size_t radar_named(const scene::Scene& scene, const std::string& name) {
  const std::size_t found = scene::find_radar(scene, name);
  if (found != scene::not_found) return found;
  std::vector<std::string> names;
  for (const scene::Radar& radar : scene.radars) names.push_back(radar.name);
  const std::string nearest = core::nearest_word(name, names);
  const std::string others = names.empty() ? "it defines none" : "its first is '" + names.front() + "'";
  throw core::InvalidRequest("the scene has no radar '" + name + "'",
                             nearest.empty() ? others : "did you mean '" + nearest + "'?");
}

}  // namespace sarsim::workflow
