#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "scene/schema/expression.hpp"
#include "scene/schema/field_spec.hpp"

/// Terms of radar engineers and other programs for things that have another name in the tables of fields. One table,
/// used for unknown words in scenes, `--set`, sweeps, Python, `explain` and the search of the workbench.
namespace sarsim::scene {

/// Conversion from the value of such a word to that of the field.
enum class TradeLaw {
  same,
  same_with_unit,  ///< The same where it has a unit; a bare number counts something else.
  reciprocal,      ///< 1/x: of a time, a frequency.
  wavelength,      ///< c/x: of a length, a frequency.
  cell,            ///< c/(2 x): of a length in range, a bandwidth or a sampling frequency.
  noise_figure,    ///< 290 K 10^(x/10).
  turn_period,     ///< 360 deg/x: of a time, a rate of turn.
  off_nadir,       ///< x - 90 deg: of an angle from the nadir, an elevation.
  negative,        ///< -x: of a depression, an elevation.
  aperture,        ///< 0.886 wavelength/x: of the length of an antenna, a half-power width.
  slant_range,     ///< c x/2: of a delay, a range.
  turns,           ///< 360 deg x: of turns in a time, a rate of turn.
  none,            ///< The value does not carry over.
};

/// Whether the value stays what it is.
[[nodiscard]] constexpr bool keeps_value(TradeLaw law) {
  return law == TradeLaw::same || law == TradeLaw::same_with_unit;
}

/// A word of the trade.
struct TradeWord {
  std::string_view names;  ///< Spellings, separated by blanks; ignoring underscores, hyphens and case.
  std::string_view kind;   ///< Header of the objects in which it has this meaning; empty: in all.
  std::string_view field;  ///< Kind and path in format 2: "radar.repetition.frequency"; empty: there is no field.
  TradeLaw law = TradeLaw::none;
  std::string_view line = {};  ///< What to write; the value in angle brackets, a list or not, is the converted one.
  std::string_view note = {};  ///< Further information, or why there is no such field.
};

/// A word of the trade for one alternative of a choice.
struct TradeChoice {
  std::string_view names;   ///< As of a TradeWord; "[]": a list.
  std::string_view choice;  ///< Path of the choice below its object: "pulse".
  std::string_view word;    ///< The alternative; empty: there is none.
  std::string_view note = {};
};

/// A word of the trade for a kind of object.
struct TradeHeader {
  std::string_view names;
  std::string_view header;  ///< "radar"; empty: there is none.
  std::string_view note;
};

/// The tables (trade_words.cpp).
[[nodiscard]] std::span<const TradeWord> trade_words();
[[nodiscard]] std::span<const TradeChoice> trade_choices();
[[nodiscard]] std::span<const TradeHeader> trade_headers();

/// The entry of a word; one for the kind of object takes precedence. A unit at its end is ignored ("fc_ghz"). Null if
/// there is no such word, or if it has another meaning in objects of that kind.
/// @param kind  a header of format 2; empty: the first entry, of whatever kind
[[nodiscard]] const TradeWord* trade_word(std::string_view name, std::string_view kind);
/// The entry of the most similar word in objects of a kind; null if none is similar.
[[nodiscard]] const TradeWord* nearest_trade_word(std::string_view name, std::string_view kind);
/// The entry of a word of a choice, by its path below its object; null where there is none.
[[nodiscard]] const TradeChoice* trade_choice(std::string_view word, std::string_view choice);
/// The entry of a kind of object; null where there is none.
[[nodiscard]] const TradeHeader* trade_header(std::string_view header);
/// Whether one of the names is, or begins with, a typed word.
[[nodiscard]] bool is_spelling(std::string_view names, std::string_view typed);

/// Context of a word.
struct TradeUse {
  std::string_view name;                  ///< As it was typed, perhaps with a unit at its end.
  std::string_view kind = {};             ///< Of the object; empty: none.
  std::string_view value = {};            ///< Its value, with a unit or without; empty: none.
  std::optional<double> carrier_hz = {};  ///< Of the radar, if it is known.
  bool has_table = false;                 ///< The object has the table to which the field belongs: "pulse".
};

/// The name of the table to which the field of a word belongs: "pulse"; empty where it belongs to none.
[[nodiscard]] std::string_view table_of_word(const TradeWord& word);
/// How format 2 says it: `write repetition = "1 kHz" (1/PRI)`; `write width = "1 us" in pulse` where the object has
/// that table, so that what else is in it stays.
[[nodiscard]] std::string trade_advice(const TradeWord& word, const TradeUse& use);
/// Advice in the notation of `--set` and Python: "write Radar1.repetition.frequency=1 kHz"; without an owner that has
/// the field, only the name of the field.
[[nodiscard]] std::string trade_setting(const TradeWord& word, const TradeUse& use, std::string_view owner);
/// Hint that converts a value of another dimension to that of a field in the usual way: for "1.67 ms" as a repetition
/// frequency `write "598.8 Hz", which is 1/(1.67 ms)`; empty if there is no usual conversion.
/// @param text   what was typed
/// @param found  what it measures
[[nodiscard]] std::string conversion_hint(const FieldSpec& spec, std::string_view text, const Measured& found,
                                          std::optional<double> carrier_hz);
/// Advice for the word of a choice: `write "chirp"`.
[[nodiscard]] std::string trade_advice(const TradeChoice& choice);

}  // namespace sarsim::scene
