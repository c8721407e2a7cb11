#pragma once

#include <string>
#include <string_view>

namespace sarsim::scene {

/// The mark of format 2: the value of the key `format`, which every file of it has.
inline constexpr std::string_view format_2_mark = "sarsim 2";

/// Whether a text is meant as format 2 (TOML) rather than as a script of the language of 1998: told by its first line
/// that holds more than a comment, whatever the file is called. A script begins with `!` or `$` there, TOML with a
/// comment after `#`, a header in brackets, or `key =`.
[[nodiscard]] bool is_format_2(std::string_view text);

/// Whether a text states its format (`format = ...`) before its first header.
[[nodiscard]] bool states_format(std::string_view text);

/// The usual ending of a file with a text, without the point: "toml" or "scr".
[[nodiscard]] inline std::string usual_ending(std::string_view text) { return is_format_2(text) ? "toml" : "scr"; }

}  // namespace sarsim::scene
