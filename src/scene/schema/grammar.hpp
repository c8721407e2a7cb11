#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <string_view>

#include "scene/schema/function_block.hpp"

/// The pieces that the language is described with. Reader and writer work from the same descriptions
/// (scene_grammar.hpp, radar_grammar.hpp), so that what one writes the other reads.
namespace sarsim::scene::script {

/// The values a number may have, in SI units, angles and decibels as typed.
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_excluded = false;

  [[nodiscard]] bool holds(double value) const { return value <= high && (low_excluded ? value > low : value >= low); }
};

inline constexpr Range any_value{};
inline constexpr Range zero_or_more{0.0};
inline constexpr Range above_zero{0.0, std::numeric_limits<double>::infinity(), true};

/// ", zero or more" and the like, to follow what kind of value is expected; empty where anything goes.
[[nodiscard]] std::string range_text(const Range& range);

/// One parameter of a command.
struct Field {
  std::string_view member;     ///< Of the scene's structure.
  std::string_view words;      ///< What it is, in a sentence.
  std::string_view unit = {};  ///< Of the number in the script; empty for a pure number or a word.
  int shift = 0;               ///< Decimal exponent from the script's unit to the scene's.
  Range range = any_value;
  std::string_view detail = {};  ///< More about it for the comment beside a written value.
};

/// One keyword of a selection.
template <class Value>
struct Alternative {
  std::string_view word;
  Value value;
  std::string_view meaning;  ///< For the comment beside the written word; may be empty.
};

template <class Value, std::size_t N>
using Alternatives = std::array<Alternative<Value>, N>;

/// The three significant letters: the comparison ignores case and ends, with success, where either word ends.
[[nodiscard]] bool keyword_matches(std::string_view typed, std::string_view keyword);

/// The five significant letters of a command word, by the same rule.
[[nodiscard]] bool command_matches(std::string_view typed, std::string_view command);

/// Whether a word is meant as one of the language's keywords rather than as a mistyped number.
[[nodiscard]] bool is_keyword(std::string_view typed);

/// Whether a word begins as a number does.
[[nodiscard]] bool begins_like_number(std::string_view typed);

}  // namespace sarsim::scene::script
