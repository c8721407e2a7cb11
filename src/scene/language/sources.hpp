#pragma once

#include <deque>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "scene/language/object_reader.hpp"

/// The texts that a scene is made of, and the names for numbers that they share.
namespace sarsim::scene::language {

/// A scene's text with all that it includes, those included first.
struct Sources {
  std::deque<std::string> texts;  ///< Of included files, and those that JSON was turned into.
  std::deque<Source> sources;
};

/// Whether a text of format 2 includes files.
[[nodiscard]] bool includes_files(std::string_view text);

/// Takes a text apart and everything that it includes, each file once; reports what is wrong with them.
void take_apart(std::string_view text, const std::string& file, Reading& reading, Sources& sources);

/// Reads the tables `[let]` of all texts, and what stands in for some of their values. A stand-in that is a bare number
/// counts in the base unit of what it replaces.
/// @param stand_ins  names with values as they were typed, in place of those of the texts
void read_names(const Sources& sources, const std::vector<std::pair<std::string, std::string>>& stand_ins,
                Reading& reading);

}  // namespace sarsim::scene::language
