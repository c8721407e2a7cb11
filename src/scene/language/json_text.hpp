#pragma once

#include <string>
#include <string_view>

#include "core/toml/document.hpp"

/// Scenes as JSON: the same tree as format 2, for programs that write scenes.
namespace sarsim::scene::language {

/// Whether a text is meant as JSON: its first letter is an opening brace.
[[nodiscard]] bool is_json(std::string_view text);

/// A scene in JSON, ready to be read as one in TOML.
struct JsonText {
  std::string toml;               ///< Of the same length: a byte has the place that it has in the JSON text.
  core::toml::Document document;  ///< Of `toml`, with a table for each object; mistakes are at their places.
};

/// Reads JSON as TOML. A line of `toml` is what stands between two commas of the outermost object; places in lines and
/// columns are those of the JSON text.
///
/// A little more than JSON passes: a comma behind the last value, and keys without quotes. Of several mistakes some may
/// be told only after others are corrected.
[[nodiscard]] JsonText read_json(std::string_view text);

}  // namespace sarsim::scene::language
