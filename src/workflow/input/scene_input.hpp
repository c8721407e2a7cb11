#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/report/problem.hpp"
#include "core/task/parallel.hpp"
#include "scene/model/scene.hpp"
#include "scene/script/reader.hpp"
#include "simulate/resolve/resolved.hpp"
#include "simulate/survey/survey.hpp"

namespace sarsim::workflow {

/// Values that stand in for those of a script.
struct SceneOverrides {
  std::optional<scene::Profile> profile;
  std::optional<scene::PulseDefinition> pulse;
  std::optional<double> tolerance;
  std::optional<std::uint64_t> seed;
  std::optional<scene::FileFormat> format;  ///< Of every simulation.
  std::vector<std::string> targets{};       ///< Tables of targets to add (workflow/input/target_tables.hpp).
  std::vector<std::string>
      settings{};                  ///< "FIELD=VALUE" (scene/schema/field_names.hpp), in this order, after the others.
  std::vector<std::string> let{};  ///< "NAME=VALUE": numbers or expressions in place of those in [let] of format 2.
};

/// The existing files named by overrides: tables of targets, and values of fields, which may be data files, also beside
/// the script.
[[nodiscard]] std::vector<std::filesystem::path> files_of(const SceneOverrides& overrides,
                                                          const std::filesystem::path& script_folder);

/// A script as understood, with everything that is wrong with it.
struct SceneInput {
  scene::Scene scene;
  scene::FieldPlaces places;
  scene::LetNames names;                       ///< Of [let], as they stand for numbers in the scene.
  std::vector<std::filesystem::path> sources;  ///< The script, what it includes, and the data files that it names.
  core::Problems problems;                     ///< Of reader, check and survey, ranked and with their places.
  core::Problems of_files;                     ///< Of these the warnings about the files that it names.
  core::Problems of_look;  ///< Of these the ones that are found anew: `CheckLevel::files` keeps nothing.
  std::vector<simulate::EchoSummary> echoes;  ///< Of the simulations that are wanted, where echoes were looked at.
  std::shared_ptr<const simulate::ResolvedScene> resolved;  ///< Where echoes were looked at, else empty.
  scene::Language language = scene::Language::script;       ///< Of the text that was read.
  bool json = false;                                        ///< It is JSON, which nothing writes.
};

/// The language of scenes that a file's name asks for: `.scr` or `.toml`; nothing for another ending.
[[nodiscard]] std::optional<scene::Language> language_of_name(const std::filesystem::path& file);

/// How much of a scene is looked at.
enum class CheckLevel {
  reading,  ///< The text alone.
  files,    ///< Also the files that it names, for what has to be warned of; they need not be there, and are not kept.
  values,   ///< Also `check`.
  echoes,   ///< Also `survey`, where there is no error.
};

/// Positions of the products of a scene that are to be made, ascending.
struct WantedProducts {
  std::vector<std::size_t> simulations;
  std::vector<std::size_t> geometries;
};

/// Says what is wanted of a scene whose text is sound; throws core::InvalidRequest for what it does not have.
using ChooseProducts = std::function<WantedProducts(const scene::Scene&)>;

/// Reads and checks a script. Settings that cannot be made are core::InvalidRequest, all at once. Where the text holds
/// errors, objects that have one are not checked further.
/// @param choose  problems of other products do not count; nothing: all are looked at
[[nodiscard]] SceneInput read_scene(const std::string& path, const SceneOverrides& overrides, CheckLevel check_level,
                                    const core::WorkControl& control = {}, const ChooseProducts& choose = {});

/// The same of a text that is in no file.
/// @param name  of a file that need not be there: for places, and files that the text names are looked for beside it
[[nodiscard]] SceneInput read_scene_text(std::string_view text, const std::string& name,
                                         const SceneOverrides& overrides, CheckLevel check_level,
                                         const core::WorkControl& control = {});

/// Checks a scene that was read before and perhaps changed since, as reading it does. Remarks of its reader stay.
/// @param overrides  but for values of [let], which only a text has
[[nodiscard]] SceneInput check_again(const SceneInput& known, CheckLevel check_level,
                                     const core::WorkControl& control = {}, const ChooseProducts& choose = {},
                                     const SceneOverrides& overrides = {});

/// The value of a field, as text, by the name that --set has for it; throws core::InvalidRequest where the name means
/// nothing.
[[nodiscard]] std::string field_value(const SceneInput& input, const std::string& name);

/// Sets a field as --set does; throws core::InvalidRequest where that cannot be done, and the scene is unchanged then.
/// @returns what is allowed but probably not meant
core::Problems set_field_value(SceneInput& input, const std::string& name, const std::string& value);

/// Checks a scene that was not read from a file, or not by `read_scene`; otherwise the same.
/// @param folder  where the data files that it names are looked for
[[nodiscard]] SceneInput take_scene(scene::Scene scene, const std::filesystem::path& folder,
                                    const SceneOverrides& overrides, CheckLevel check_level,
                                    const core::WorkControl& control = {}, const ChooseProducts& choose = {});

/// The data files that a scene names, as far as they are there.
[[nodiscard]] std::vector<std::filesystem::path> data_files_of(const scene::Scene& scene,
                                                               const std::filesystem::path& script_folder);

/// A script and the data files that it names, as far as it can be read; nothing for no name.
[[nodiscard]] std::vector<std::filesystem::path> sources_of_script(const std::string& path);

/// Makes `input.resolved` of a sound scene where it is still empty.
void resolve_once(SceneInput& input, const core::WorkControl& control);

/// Throws core::InvalidRequest with all problems where one of them is an error; where `strict`, also where one is a
/// warning.
void expect_usable(const SceneInput& input, bool strict = false);

/// Number of the radar, platform ... named in an option; throws core::InvalidRequest with the nearest name.
[[nodiscard]] std::size_t radar_named(const scene::Scene& scene, const std::string& name);

}  // namespace sarsim::workflow
