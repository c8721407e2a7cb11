#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "scene/script/reader.hpp"

namespace sarsim::scene {

/// Reads a text of format 2 (docs/formats/scene.md). All mistakes are reported, each with its line and column; what the
/// text does not say has its default. References are by exact name. Takes time linear in the text.
/// @param file_name  for the places of problems
/// @param loader     finds included files and data files; where empty, they are errors
[[nodiscard]] ScriptReading read_format_2(std::string_view text, const std::string& file_name,
                                          const DataFileLoader& loader, const ReadControl& control = {});

/// Reads a text in either language, told by its content.
[[nodiscard]] ScriptReading read_scene_text(std::string_view text, const std::string& file_name,
                                            const DataFileLoader& loader, const ReadControl& control = {});

/// The same from disk, with the files that it names; `read_script_file` says what can go wrong.
[[nodiscard]] ScriptReading read_scene_file(const std::filesystem::path& path, const ReadControl& control = {});

}  // namespace sarsim::scene
