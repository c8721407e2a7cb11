#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/text/letters.hpp"

/// The characters and words of expressions.
namespace sarsim::scene {

/// Whether a word can begin with a character: a letter or an underscore.
[[nodiscard]] constexpr bool begins_word(char c) { return c == '_' || core::is_letter(c); }
/// Whether a number without a sign can.
[[nodiscard]] constexpr bool begins_number(char c) { return core::is_digit(c) || c == '.'; }

/// The word at a place of a text: letters, digits and underscores, not beginning with a digit; empty where none begins.
[[nodiscard]] std::string_view word_at(std::string_view text, std::size_t place);

/// A text in plain characters (`plain_expression`), and where each of them stands in what was typed.
class Source {
 public:
  /// Keeps a view of `text`, which must outlive it.
  explicit Source(std::string_view text);
  Source(const Source&) = delete;
  Source& operator=(const Source&) = delete;

  [[nodiscard]] std::string_view typed() const { return typed_; }
  [[nodiscard]] std::string_view plain() const { return plain_; }
  /// Byte of the typed text at which a character of the plain one, or its end, stands.
  [[nodiscard]] std::size_t origin(std::size_t place) const { return origins_.empty() ? place : origins_[place]; }
  /// What was typed for a range of the plain text.
  [[nodiscard]] std::string_view part(std::size_t begin, std::size_t end) const {
    return typed_.substr(origin(begin), origin(end) - origin(begin));
  }
  /// The same in quotes, cut off where it is long.
  [[nodiscard]] std::string quote(std::size_t begin, std::size_t end) const;

 private:
  std::string_view typed_, plain_;
  std::string made_;
  std::vector<std::size_t> origins_;  // empty: the text is plain
};

/// A word of an expression, the name of a unit, a function or anything else, and its bytes in the typed text.
struct ExpressionWord {
  std::string name;
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// The words of an expression in their order, those within numbers ("1e5") left out.
[[nodiscard]] std::vector<ExpressionWord> words_of(std::string_view text);

}  // namespace sarsim::scene
