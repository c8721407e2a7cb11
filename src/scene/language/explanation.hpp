#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/text/json.hpp"
#include "scene/language/guide_headings.hpp"
#include "scene/schema/field_spec.hpp"

/// What people are told about the words of format 2, all of it from the tables of fields.
namespace sarsim::scene::language {

/// One alternative of a choice.
struct AlternativeExplanation {
  std::string word;                 ///< "chirp"
  std::string meaning;              ///< "pulse of linearly swept frequency"
  std::string in_script;            ///< Keyword of the 1998 language; may be empty.
  std::vector<std::string> fields;  ///< Paths below the object that belong to it: "pulse.bandwidth".
  std::string example;
};

/// Another word that can be explained, in a line.
struct ExplanationLine {
  std::string name;   ///< "radar.pulse.width"
  std::string value;  ///< Its default; may be empty.
  std::string meaning;
};

/// What is known of one word. What is empty does not apply.
struct Explanation {
  std::string name;     ///< "radar.pulse.width"
  std::string meaning;  ///< Sentences.
  std::string takes;    ///< What may be written: "a time".
  std::string unit;     ///< In which a number without a unit counts.
  std::vector<std::string> other_units;
  Range limits = any_value;  ///< In that unit.
  Range likely_limits = any_value;
  std::string range;  ///< Both in words.
  std::string likely;
  std::string initial;     ///< The default as format 2 writes it.
  std::string applies_to;  ///< "pulse of type chirp"; empty: always.
  std::string shorthand;   ///< Of a choice, or of the field whose value may stand for it: `carrier = "5.3 GHz"`.
  std::vector<AlternativeExplanation> alternatives;
  std::string example;                 ///< Lines of format 2.
  std::string in_script;               ///< How the 1998 language says it.
  std::string label;                   ///< Where the workbench shows it.
  std::vector<std::string> set_names;  ///< For `--set`.
  std::vector<ExplanationLine> lines;  ///< What the word contains, or all that it can mean.
  std::string asked;                   ///< For a synonym: the advice, with the name used here.
  std::vector<GuideHeading> pages;     ///< Headings of the documentation with the word.
  std::string next;                    ///< How to go on.

  std::string failure;  ///< Why there is no explanation; all else is then empty but `hint`.
  std::string hint;
};

/// Explains a field ("radar.pulse.width", or "pulse.width" where one kind alone has it), a choice ("radar.pulse"), a
/// kind of object ("radar"), "let", "include" or "format", or the name that `--set` has for a field ("pulse_width").
/// An empty word gives the kinds of objects. For a term of the trade ("pri", "lfm") it explains the corresponding
/// field. Any other word, or several, are searched in names, synonyms, meanings and the headings of the documentation;
/// fields with the word in their name come first.
[[nodiscard]] Explanation explain(std::string_view word);

/// The first of some sentences.
[[nodiscard]] std::string first_sentence(const std::string& text);

/// The explanation in lines for people.
[[nodiscard]] std::string text_of(const Explanation& explanation);

/// The same as a JSON object.
void write_json(core::JsonWriter& json, const Explanation& explanation);

}  // namespace sarsim::scene::language
