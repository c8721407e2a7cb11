#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/maths/sampled_function.hpp"
#include "core/maths/vector.hpp"
#include "scene/schema/function_block.hpp"
#include "scene/schema/quantity.hpp"

/// What is known of one field of one kind of object, as plain data: everything that reads, writes, checks, shows or
/// describes fields works from it.
namespace sarsim::scene {

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

/// One alternative of a choice, or one of the two of a yes or no.
struct Choice {
  /// @param of           an enumeration's value, a number or a bool
  /// @param in_format_2  empty: that of the script language in small letters, with hyphens
  template <class Value>
  constexpr Choice(std::string_view in_script, Value of, std::string_view in_forms, std::string_view what,
                   std::string_view in_format_2 = {})
      : word(in_script), value(static_cast<int>(of)), shown(in_forms), meaning(what), type(in_format_2) {}

  /// Whether the script language has no word for it, and no other way to say it.
  [[nodiscard]] constexpr bool since_2() const { return word.empty() && !type.empty(); }

  std::string_view word;  ///< Keyword of the script language; empty: a script says it in another way, or not at all.
  int value;
  std::string_view shown;    ///< In forms. Of several with one value, the first is shown.
  std::string_view meaning;  ///< For the comment beside the written word; may be empty.
  std::string_view type;     ///< Its word in format 2, where that is another than the script's; see `type_word`.
};

/// One bit of a number that is a sum of such.
struct Flag {
  std::string_view id;  ///< Follows the field's id and a point.
  std::string_view label;
  unsigned bit;
};

/// When a field means something: where a choice or a yes or no, which means something itself, is one of these.
struct Condition {
  std::size_t field = 0;   ///< Position of the choice in its table; before the field that depends on it.
  std::vector<int> among;  ///< Empty: always.
};

/// What kind of value a field has; follows from the type of its member.
enum class FieldType {
  number,    ///< double, int, core::Angle, core::PowerRatio
  seed,      ///< std::uint64_t, more than a double holds
  vector,    ///< core::Vec3 or three angles
  choice,    ///< an enumeration, or an int with `FieldSpec::choices`
  check,     ///< bool
  flags,     ///< int with `FieldSpec::flags`
  text,      ///< std::string, where `FieldSpec::refers` is empty
  name,      ///< std::string, name of another object
  function,  ///< UserFunction
  list,      ///< std::vector of structures that have a table of fields themselves.
};

/// What a list holds; `visit_elements` (field_table.hpp) has the structures.
enum class ListKind { none, legs, waypoints, sines };

/// What a field is called where its choice is one alternative.
struct OtherKey {
  int alternative = 0;
  std::string_view key = {};
};

/// One field, stated once.
struct FieldSpec {
  std::string_view id = {};   ///< Member of the structure: "prf_hz", "transmit_antenna.pattern", "corner_m[0]".
  std::string_view key = {};  ///< Path in format 2 below the object: "pulse.width", "range[0]". That of a choice is
                              ///< the table which what depends on it stands in; a function by points is such a table.
  /// Further types of a choice in format 2, which are read as one of `choices`.
  std::vector<std::string_view> other_types = {};
  /// For a choice: maps other spellings of its types to the canonical word, and any other word to itself; null: there
  /// are no other spellings.
  std::string_view (*spelling)(std::string_view word) = nullptr;
  OtherKey other_key = {};       ///< Of a field with one key for most alternatives and another for one.
  std::string_view label = {};   ///< In forms.
  std::string_view words = {};   ///< In sentences about a script.
  std::string_view noun = {};    ///< In sentences of `check`, behind "the"; empty: `words`.
  std::string_view place = {};   ///< Member that problems and places of a script name; empty: `id`.
  std::string_view refers = {};  ///< Kind of object whose name this is: "platform" or "radar".
  Quantity quantity = Quantity::number;
  std::string_view script_unit = {};  ///< One of the quantity's units, in which a script has it; empty: the base unit.
  Range range = any_value;            ///< What a script or a form can say; refused beyond.
  std::optional<Range> usable = {};   ///< What `check` lets pass where the field means something, anything elsewhere;
                                      ///< empty: `range`, everywhere.
  Range likely = any_value;           ///< What is not suspicious; where not given, that of the quantity.
  const FunctionBlock* block = nullptr;  ///< FieldType::function.
  std::vector<Choice> choices = {};      ///< FieldType::choice and check, in the order of the script language.
  std::vector<Flag> flags = {};          ///< FieldType::flags.
  std::string_view example = {};         ///< In format 2, where the default is no telling one.
  bool optional = false;                 ///< A text or name may be missing.
  bool on_earth = false;                 ///< A world position: over an Earth also by latitude, longitude and height.
  bool since_2 = false;                  ///< The script language has no such field.
  std::string_view tip = {};             ///< Meaning and formula in a sentence or two.
  std::string_view detail = {};          ///< More about it for the comment beside a written value.
  bool rare = false;                     ///< Shown a level down.
  bool needed = false;                   ///< Of an entry of a list: has no default, it has to be said. Of the world: a
                                         ///< reader warns where it is not said.

  // What the table adds.
  std::string_view group = {};
  FieldType type = FieldType::number;
  ListKind list = ListKind::none;  ///< FieldType::list.
  Condition when = {};

  [[nodiscard]] std::string_view problem_place() const { return place.empty() ? id : place; }
};

/// The parts and the file name of a user-defined function inside an object.
struct FunctionRef {
  std::span<core::SampledFunction> parts;
  std::string* file = nullptr;
};
/// The same of a constant object.
struct ConstFunctionRef {
  std::span<const core::SampledFunction> parts;
  const std::string* file = nullptr;

  /// True where both say the same, wherever they are kept.
  friend bool operator==(const ConstFunctionRef& a, const ConstFunctionRef& b) {
    return *a.file == *b.file && std::ranges::equal(a.parts, b.parts);
  }
};

/// A list inside a constant object.
struct ConstListRef {
  const void* list = nullptr;
  ListKind kind = ListKind::none;

  /// True where both hold the same, wherever they are kept.
  friend bool operator==(const ConstListRef& a, const ConstListRef& b);
};

/// The value of a field: numbers, flags and choices among numbers as double, in the unit in which they are held, angles
/// in degrees and ratios in decibels; enumerations as int.
using FieldValue =
    std::variant<double, std::uint64_t, core::Vec3, int, bool, std::string, ConstFunctionRef, ConstListRef>;

/// The number that stands for what is chosen, of a choice or a yes or no.
[[nodiscard]] int chosen(const FieldValue& value);

/// Whether a script says a choice with keywords and not with a number.
[[nodiscard]] bool has_words(const FieldSpec& spec);

/// The alternative that is chosen, of those that a script has a word for; null where it has none.
[[nodiscard]] const Choice* chosen_word(const FieldSpec& spec, const FieldValue& value);

/// The word of an alternative in format 2: "matched-filter"; of one without a word, what forms show.
[[nodiscard]] std::string type_word(const Choice& choice);

/// The alternative that a word of format 2 names in one of its spellings; null if it names none.
[[nodiscard]] const Choice* choice_of_type(const FieldSpec& spec, std::string_view word);

/// The values that a point of a function may have: those of lists are above zero.
[[nodiscard]] Range range_of_y(const FunctionBlock& block);
/// Those of them that are not suspicious.
[[nodiscard]] Range likely_y(const FunctionBlock& block);

/// What no scene of a radar exceeds, in the unit in which the quantity is held; any value for pure numbers.
[[nodiscard]] Range likely_range(Quantity quantity);
/// The values that are in both.
[[nodiscard]] Range both(const Range& a, const Range& b);

/// Decimal exponent from the script's unit of a field to the unit in which it is held.
[[nodiscard]] int script_shift(const FieldSpec& spec);
/// Chooses the alternative of a number.
void choose(FieldValue& value, int alternative);
/// Whether a choice is one of some.
[[nodiscard]] bool is_among(const FieldValue& value, const std::vector<int>& among);
/// The unit of a field in a script as scripts spell it: "m^2", "GHz"; empty for a pure number.
[[nodiscard]] std::string_view script_unit(const FieldSpec& spec);

}  // namespace sarsim::scene
