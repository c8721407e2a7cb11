#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include "scene/schema/field_spec.hpp"

/// The pieces of the script language that fields are described with, and its words that belong to no field.
namespace sarsim::scene::script {

/// What the script language needs to know of one parameter of a command.
struct Field {
  std::string_view member;     ///< Of the scene's structure: where problems are shown.
  std::string_view words;      ///< What it is, in a sentence.
  std::string_view unit = {};  ///< Of the number in the script; empty for a pure number or a word.
  int shift = 0;               ///< Decimal exponent from the script's unit to the scene's.
  Range range = any_value;
  std::string_view detail = {};  ///< More about it for the comment beside a written value.
};

/// The parameter that stands for a field.
[[nodiscard]] Field parameter_of(const FieldSpec& spec);

/// ", zero or more" and the like, to follow what kind of value is expected; empty where anything goes.
[[nodiscard]] std::string range_text(const Range& range);

/// One keyword that belongs to no field of an object.
template <class Value>
struct Alternative {
  std::string_view word;
  Value value;
  std::string_view meaning;  ///< For the comment beside the written word; may be empty.
};

template <class Value, std::size_t N>
using Alternatives = std::array<Alternative<Value>, N>;

inline constexpr std::array<std::string_view, 8> command_words{"TARGET",  "PLATFORM", "RADAR", "SIMULATION",
                                                               "SURFACE", "GEOMETRY", "CLOUD", "OPTIONS"};

inline constexpr Alternatives<core::Interpolation, 3> interpolations{
    {{"CUBIC", core::Interpolation::cubic, "cubic pieces"},
     {"MFILTER", core::Interpolation::low_pass, "low-pass filter"},
     {"LINEAR", core::Interpolation::linear, "straight lines"}}};

/// Where the points of a function stand.
enum class DataSource { data_file, in_script };
inline constexpr Alternatives<DataSource, 2> data_sources{
    {{"FILE", DataSource::data_file, ""}, {"INLINE", DataSource::in_script, ""}}};

/// Stands before the name of a cloud's file.
inline constexpr std::string_view cloud_source = "FILE";

/// Stands before the law of the sensitivity-time control, where there is one.
inline constexpr std::string_view stc_switch = "APPLY_STC";
inline constexpr std::string_view stc_switch_meaning = "sensitivity-time control";

/// The three significant letters: the comparison ignores case and ends, with success, where either word ends.
[[nodiscard]] bool keyword_matches(std::string_view typed, std::string_view keyword);

/// The five significant letters of a command word, by the same rule.
[[nodiscard]] bool command_matches(std::string_view typed, std::string_view command);

/// Whether a word is meant as one of the language's keywords rather than as a mistyped number. Those of $OPTIONS are
/// not among them: they stand in pairs, so that a number is never missing before one.
[[nodiscard]] bool is_keyword(std::string_view typed);

/// Whether a word begins as a number does.
[[nodiscard]] bool begins_like_number(std::string_view typed);

}  // namespace sarsim::scene::script
