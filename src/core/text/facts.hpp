#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/report/problem.hpp"
#include "core/text/json.hpp"

/// What a report says, once: a list of facts, of which JSON, CSV, tables and texts are loops.
namespace sarsim::core {

struct Fact;
/// Facts about one thing, in the order in which they are told.
using Facts = std::vector<Fact>;
/// Facts about several things of one kind, each with the same columns.
using FactRows = std::vector<Facts>;

/// What a fact says: nothing, a truth, a whole number, a number, a word, words, problems, facts of a group, or rows of
/// them. Numbers that are not finite are nothing to readers.
class FactValue {
 public:
  using Held = std::variant<std::monostate, bool, std::int64_t, double, std::string, std::vector<std::string>, Problems,
                            Facts, FactRows>;

  // NOLINTBEGIN(google-explicit-constructor): a fact is what it says
  FactValue() = default;
  /// A truth.
  FactValue(bool truth);
  /// A number.
  FactValue(double number);
  /// A whole number.
  template <std::integral Count>
  FactValue(Count count);
  /// A word.
  FactValue(const char* word);
  /// A word.
  FactValue(std::string word);
  FactValue(std::vector<std::string> words);
  FactValue(Problems problems);
  FactValue(Facts group);
  FactValue(FactRows rows);
  template <class Value>
  FactValue(const std::optional<Value>& value);
  // NOLINTEND(google-explicit-constructor)

  [[nodiscard]] const Held& held() const { return held_; }

 private:
  Held held_;
};

/// How people read a number.
struct Digits {
  /// With an SI prefix, with so many significant digits, or with so many decimals: plain, with an exponent, signed.
  enum class Notation { prefixed, significant, fixed, scientific, with_sign };
  Notation notation = Notation::prefixed;
  int count = 6;
};
/// So many significant digits; those of `Digits{}` have the SI prefix that suits them where the unit takes one.
[[nodiscard]] constexpr Digits significant(int count) { return {Digits::Notation::significant, count}; }
/// So many decimals; no sign where they are all 0.
[[nodiscard]] constexpr Digits fixed(int count) { return {Digits::Notation::fixed, count}; }
/// So many decimals behind the first digit, and an exponent.
[[nodiscard]] constexpr Digits scientific(int count) { return {Digits::Notation::scientific, count}; }
/// So many decimals with their sign.
[[nodiscard]] constexpr Digits with_sign(int count) { return {Digits::Notation::with_sign, count}; }

/// One fact.
struct Fact {
  std::string key;    ///< In JSON and CSV, with its unit: "range_first_m"; empty: for people only.
  std::string label;  ///< For people: "Range from"; empty: for programs only.
  FactValue value;
  std::string unit{};  ///< Of what people read.
  Digits digits{};
  std::string text{};  ///< What people read in its place: "no peak".
};

// Here a fact is complete.
inline FactValue::FactValue(bool truth) : held_(truth) {}
inline FactValue::FactValue(double number) : held_(number) {}
/// See its declaration.
template <std::integral Count>
FactValue::FactValue(Count count) : held_(static_cast<std::int64_t>(count)) {}
inline FactValue::FactValue(const char* word) : held_(std::string(word)) {}
inline FactValue::FactValue(std::string word) : held_(std::move(word)) {}
inline FactValue::FactValue(std::vector<std::string> words) : held_(std::move(words)) {}
inline FactValue::FactValue(Problems problems) : held_(std::move(problems)) {}

/// See its declaration.
template <class Value>
FactValue::FactValue(const std::optional<Value>& value) {
  if (value) *this = FactValue(*value);
}

/// A value where there is one; else nothing.
template <class Value>
[[nodiscard]] FactValue only(bool known, const Value& value) {
  return known ? FactValue(value) : FactValue();
}

/// A fact that people read in these words.
[[nodiscard]] inline Fact worded(std::string key, std::string label, FactValue value, std::string text) {
  return {std::move(key), std::move(label), std::move(value), {}, {}, std::move(text)};
}

/// The names of files, as a fact holds them.
[[nodiscard]] std::vector<std::string> texts_of(const std::vector<std::filesystem::path>& paths);

/// Adds facts to others.
void append(Facts& facts, Facts more);

/// Writes those with keys as members of the open object. A group of which nothing is known is null.
void write_json(JsonWriter& json, const Facts& facts);
/// The same as an object of its own, with a line feed.
[[nodiscard]] std::string json_of(const Facts& facts);

/// Keys separated by commas (RFC 4180), those of groups one by one: the first line of a table.
[[nodiscard]] std::string csv_names(const Facts& columns);
/// A line with the values of a row: 1 and 0 for truths, nothing for what is not known.
/// @param digits  of numbers; 0: all that it takes to read them back exactly
[[nodiscard]] std::string csv_line(const Facts& row, int digits = 0);
/// A cell of it, in quotes where it has to be.
[[nodiscard]] std::string csv_cell(const std::string& text);

/// A fact as people read it.
struct ShownFact {
  std::string label;
  std::string value;  ///< Empty: nothing is known.
  std::string unit;   ///< With its prefix.
};
/// All facts with labels, those of groups one by one, without rows.
[[nodiscard]] std::vector<ShownFact> shown(const Facts& facts);
/// Lines "  label   value unit" of what is known.
[[nodiscard]] std::string text_of(const Facts& facts);

/// Columns of a row for people, "label (unit)", and their cells, in that unit.
[[nodiscard]] std::vector<std::string> headings(const Facts& row);
[[nodiscard]] std::vector<std::string> cells(const Facts& row);
/// Cells in columns of these widths, right-aligned; what is said in place of a number ends the line.
[[nodiscard]] std::string aligned_row(const Facts& row, std::span<const std::size_t> widths);

}  // namespace sarsim::core
