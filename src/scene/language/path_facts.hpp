#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "scene/language/plain_table.hpp"
#include "scene/model/kinds.hpp"

/// What is known of one path of format 2, such as "pulse.width", in the words of explanations, schema and reference.
namespace sarsim::scene::language {

/// What is written at a path.
enum class PathRole {
  value,
  choice,         ///< A word, a table with `type`, or a shorthand.
  points,         ///< The points of a function, or the values of a list.
  interpolation,  ///< How a function is joined between its points.
  file,           ///< The data file of a function.
};

/// One path below an object.
struct PathFacts {
  std::string path;
  PathRole role = PathRole::value;
  std::vector<const PlainField*> fields;  ///< One, or those whose values share an array.
  std::size_t part = 0;                   ///< Which function of its block.

  [[nodiscard]] const PlainField& field() const { return *fields.front(); }
  [[nodiscard]] const FieldSpec& spec() const { return fields.front()->spec; }
};

/// Every path of a table, in its order.
[[nodiscard]] std::vector<PathFacts> paths_of(const PlainTable& table);

/// A choice that a field depends on, and the words with which it means something.
struct Dependence {
  std::string choice;  ///< Path.
  std::vector<std::string> words;
  bool is_default = false;  ///< One of the words is the default of the choice.
};
/// All of them, the nearest first; none where the path always means something.
[[nodiscard]] std::vector<Dependence> dependences(const PlainTable& table, const PathFacts& facts);
/// "pulse of type chirp"; empty where the path always means something.
[[nodiscard]] std::string dependence_text(const PlainTable& table, const PathFacts& facts);

/// Every path below an object of a kind, and those of the words of its choices: "pulse.type".
[[nodiscard]] const std::vector<std::string>& paths_of(ObjectKind kind);
/// `dependence_text` of a path of a kind, or those of all fields that have the path, as `path.start` of legs and lines;
/// empty also for a path that the kind does not have.
[[nodiscard]] std::string owner_of(ObjectKind kind, std::string_view path);
[[nodiscard]] std::string owner_of(const PlainTable& table, std::string_view path);

/// The alternatives of a choice, each word once.
[[nodiscard]] std::vector<Choice> alternatives(const FieldSpec& spec);

/// The paths that belong to an alternative of a choice: below its table, or that depend on it alone.
[[nodiscard]] std::vector<PathFacts> paths_of_alternative(const PlainTable& table, const PathFacts& choice,
                                                          const Choice& alternative);

/// What is written there: "a time", "three lengths: [x, y, z]".
[[nodiscard]] std::string takes_text(const PathFacts& facts);
/// What is measured; `Quantity::number` for what has no unit.
[[nodiscard]] Quantity quantity_of(const PathFacts& facts);
/// The values that are allowed.
[[nodiscard]] Range range_of(const PathFacts& facts);
/// "0 m or more", "above 0 Hz", "1 to 64"; empty where anything goes.
[[nodiscard]] std::string range_words(const Range& range, Quantity quantity);
/// The same of a path, with what simulating asks for beyond it.
[[nodiscard]] std::string range_text(const PathFacts& facts);
/// Those of them that are not suspicious.
[[nodiscard]] Range likely_range_of(const PathFacts& facts);
/// What is not suspicious; empty where anything goes.
[[nodiscard]] std::string likely_text(const PathFacts& facts);
/// Meaning and formula.
[[nodiscard]] std::string meaning_text(const PathFacts& facts);

/// The default as it would be written; empty where the path has none and, if it means anything, has to be written.
[[nodiscard]] std::string default_text(const PathFacts& facts);
/// Lines of format 2 below the header of the object: `pulse = { type = "chirp", width = "5 us" }`.
[[nodiscard]] std::string example_text(const PlainTable& table, const PathFacts& facts);
/// The same with a given value.
[[nodiscard]] std::string example_text(const PlainTable& table, const PathFacts& facts, const std::string& value);
/// The same of a choice with all that belongs to an alternative.
[[nodiscard]] std::string example_text(const PlainTable& table, const PathFacts& choice, const Choice& alternative);

/// A line with the value that may stand for a choice: `carrier = "5.3 GHz"`; of a choice or of the field whose value it
/// is. Empty for all others.
[[nodiscard]] std::string shorthand_text(const PlainTable& table, const PathFacts& facts);

/// How the 1998 language says it: "$RADAR: pulse width in ns".
[[nodiscard]] std::string script_text(const PathFacts& facts);
/// Where the workbench shows it: "Pulse: Pulse width"; empty where nowhere.
[[nodiscard]] std::string label_text(const PathFacts& facts);
/// Its names for `--set`: "Radar1.pulse_width".
[[nodiscard]] std::vector<std::string> set_names(const PathFacts& facts);

/// Words joined by commas, the last two by `last`: "a, b or c".
[[nodiscard]] std::string joined(const std::vector<std::string>& words, std::string_view last = " or ");

}  // namespace sarsim::scene::language
