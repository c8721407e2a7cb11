#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/report/problem.hpp"
#include "core/task/parallel.hpp"
#include "scene/model/scene.hpp"
#include "scene/schema/expression.hpp"
#include "scene/schema/field_names.hpp"
#include "scene/script/data_file.hpp"
#include "scene/script/field_places.hpp"

namespace sarsim::scene {

/// The languages of scenes.
enum class Language {
  script,    ///< That of 1998 with what was added to it: docs/formats/script.md.
  format_2,  ///< TOML: docs/formats/scene.md.
};

/// What a script says, what is wrong with it, and where everything stands.
struct ScriptReading {
  Scene scene;  ///< Complete where `problems` holds no error; else what could be understood, faulty objects included.
  core::Problems problems;
  FieldPlaces places;
  Language language = Language::script;
  bool json = false;                                 ///< Format 2 as JSON, which nothing writes.
  LetNames names = {};                               ///< Of [let], resolved; format 2 alone has them.
  std::vector<std::filesystem::path> included = {};  ///< Texts that this one includes.
  core::Problems of_names = {};  ///< Of a draft: names that mean nothing or mean two things, in format 2.
};

/// How a script is read; nothing here but `let` and `draft` can change what is found.
struct ReadControl {
  core::WorkControl work;
  /// Scripts are read by all threads in pieces of about so many bytes; shorter ones of scripts that have few of them.
  std::size_t piece_bytes = std::size_t{1} << 18;
  /// Names of [let] with the numbers or expressions that stand in for theirs; format 2 alone has such names.
  std::vector<std::pair<std::string, std::string>> let = {};
  /// A text that is being typed: errors that are about names alone are kept apart, as the scene can be shown with them.
  bool draft = false;
};

/// Reads a script in any dialect of the language (docs/formats/script.md).
///
/// All mistakes of the text are reported, each once with its line and column. Names are kept as typed and resolved by
/// nobody here; what can only be judged from the whole scene is left to `check`. Takes time linear in the text.
///
/// @param file_name  for the places of problems
/// @param loader     finds data files, called on any of the threads; where empty, FILE is an error
[[nodiscard]] ScriptReading read_script(std::string_view text, const std::string& file_name,
                                        const DataFileLoader& loader, const ReadControl& control = {});

/// Reads a script from disk, with its data files. Whatever stands in the way (no such file, a folder, no text, too
/// large) is a problem of the result; throws only where memory ends, and Interrupted.
[[nodiscard]] ScriptReading read_script_file(const std::filesystem::path& path, const ReadControl& control = {});

/// Reads a text in one of the languages of scenes, as `read_script` does.
using TextReader = ScriptReading(std::string_view text, const std::string& file_name, const DataFileLoader& loader,
                                 const ReadControl& control);
/// The same for any language.
[[nodiscard]] ScriptReading read_text_of_file(const std::filesystem::path& path, const ReadControl& control,
                                              TextReader& read);

/// Finds data files on disk: in the script's folder first, then in the current one.
[[nodiscard]] DataFileLoader disk_loader(const std::filesystem::path& script_folder);

/// Reads data files that `disk_loader` finds, for `set_named_field`; what is wrong with one is told with its place.
[[nodiscard]] PointsLoader disk_points(const std::filesystem::path& script_folder);

/// The file that `disk_loader` finds for a name; empty where there is none.
[[nodiscard]] std::filesystem::path data_file_on_disk(const std::filesystem::path& script_folder,
                                                      const std::string& name);

/// The largest script or data file that is read, in bytes.
inline constexpr std::size_t largest_script_bytes = std::size_t{1} << 30;

/// Fills in the places of problems that a scene check found.
void locate(core::Problems& problems, const FieldPlaces& places);

}  // namespace sarsim::scene
