#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/toml/document.hpp"

/// What stands at a byte of a text of format 2 that is being typed: valid or not, nothing of it needs to be closed.
namespace sarsim::scene::language {

/// What a place in a text is for.
enum class Site {
  nothing,  ///< Nothing of the language: behind a value, or before a key that begins there.
  comment,  ///< Behind a number sign.
  header,   ///< Within the brackets of a header.
  key,      ///< In a part of a key, or where one may begin.
  value,    ///< In a value without quotes, or where one may begin.
  string,   ///< Within the quotes of a value.
};

/// A key of an object, with its value where that is a single one.
struct KeyText {
  std::string path;                    ///< Below the object: "pulse.type".
  std::string word;                    ///< Without quotes; empty for tables and arrays.
  std::vector<std::size_t> rows = {};  ///< As `Cursor::rows`: of a key of a table in an array, which of these.
};

/// A place in a text with what is around it.
struct Cursor {
  Site site = Site::nothing;
  std::string kind;   ///< First part of the header of the object around: "radar"; empty before all headers.
  std::string table;  ///< Below the object: the table of the key, or of the part of it; empty: its own.
  /// Below the object: the key up to the part at the place, or the key of the value. Of a header the whole of it, up to
  /// that part: "radar.pulse".
  std::string path;
  /// What is typed there: the part of the key, the value, what is between the quotes, the header with its brackets.
  /// Empty where nothing is.
  core::toml::Span word;
  std::string typed;              ///< Of that, what is before the place; of a header without the brackets.
  bool complete = false;          ///< A key has its equals sign, a string its closing quote, a header its brackets.
  bool alone = false;             ///< A key of one part, or none, on a line with nothing else: it may become a header.
  std::vector<std::size_t> rows;  ///< Within arrays: which element of each, the outer array first.
  std::vector<KeyText> said;      ///< What else the text says of the object, before the place or behind it.
};

/// What stands at a place. Reads the object around it alone.
/// @param text    may begin with the header of the object, and end behind it
/// @param offset  of the byte behind the place
[[nodiscard]] Cursor cursor_at(std::string_view text, std::size_t offset);

/// Whether a line is the header of an object, of [options] or of [let], and not of a table below one.
[[nodiscard]] bool begins_object(std::string_view line);

/// Where what begins at a byte of a line ends: a key, a header, a value, a word or number of an expression, or all of
/// an expression that begins there. What is open ends with the line.
[[nodiscard]] std::size_t piece_end(std::string_view line, std::size_t offset);

}  // namespace sarsim::scene::language
