#pragma once

#include <string>
#include <utility>
#include <vector>

namespace sarsim::raster {

/// What an array of a file, or its root, says of itself. What cannot be read is handed on by its name: an attribute
/// that changes what numbers mean must not count as absent.
struct ArrayAttributes {
  /// Texts, numbers and lists of numbers, all as text: name, value.
  std::vector<std::pair<std::string, std::string>> known = {};
  /// The others: name, and what was found in words, "a structure".
  std::vector<std::pair<std::string, std::string>> unreadable = {};
  bool complete = true;  ///< Whether all attributes were met; a damaged list, or an endless one, ends early.
};

}  // namespace sarsim::raster
