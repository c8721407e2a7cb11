#pragma once

#include <cstddef>
#include <string_view>

#include "core/toml/document.hpp"

namespace sarsim::core::toml {

/// After so many mistakes `parse` stops.
inline constexpr std::size_t max_mistakes = 1000;

/// Reads a whole text as TOML 1.0.0 and finds all mistakes at once: of its bytes (UTF-8, control characters), its
/// grammar, and of keys and tables that stand twice or get in each other's way. After a mistake reading goes on with
/// the next value of an array, otherwise with the next line; where a bracket or a string of several lines is not
/// closed, with the next line that looks like a header or `key =`. One mistake of a kind is told for a line.
///
/// Time is linear in the length of the text, memory in the number of its lines; inner values are checked but not kept,
/// `Elements` reads them again.
[[nodiscard]] Document parse(std::string_view text);

}  // namespace sarsim::core::toml
