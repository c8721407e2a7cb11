#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace sarsim::core {

/// Reads a whole text as a decimal number times 10^exponent_shift, correctly rounded once: the
/// shift moves the decimal exponent of the text before conversion, so "800" with shift -9 is the
/// double nearest to 800e-9. Accepts an optional sign, digits with an optional point, an optional
/// exponent (E, e, D or d). Nothing for any other text, for NaN and infinity, and for a value that
/// overflows; a value too small for a double is 0.
[[nodiscard]] std::optional<double> parse_number(std::string_view text, int exponent_shift = 0);

/// Reads a whole text as an integer; nothing for other text or overflow.
[[nodiscard]] std::optional<std::int64_t> parse_integer(std::string_view text);

/// Reads a whole text that is digits alone, without a sign; nothing for other text or above 64 bits.
[[nodiscard]] std::optional<std::uint64_t> parse_whole(std::string_view digits, int base = 10);

/// The shortest text that `parse_number(text, -exponent_shift)` turns back into exactly `value`:
/// plain digits for exponents of moderate size, otherwise E notation. `format_number(8e-7, 9)` is
/// "800". Negative zero is written "0"; what is not finite "nan", "inf" and "-inf", as Python and NumPy read it and
/// `parse_number` does not.
[[nodiscard]] std::string format_number(double value, int exponent_shift = 0);

/// Adds that text to another one.
void append_number(std::string& text, double value, int exponent_shift = 0);

/// `value` with an SI prefix and `digits` significant digits for people to read: 5.3e9, "Hz" gives "5.3 GHz".
[[nodiscard]] std::string with_prefix(double value, std::string_view unit, int digits = 6);

/// A number as print has it: with the sign of minus where it begins with a hyphen, "−30 m". For what is only read.
[[nodiscard]] std::string with_minus_sign(std::string number);

/// A count of bytes for people to read: "1.5 MB" (decimal prefixes).
[[nodiscard]] std::string bytes_text(double bytes);

/// A duration for people to read: "0.25 s", "3 min 20 s", "5 h 07 min".
[[nodiscard]] std::string duration_text(double seconds);

/// "about 3 s"; "below 1 ms" is about enough as it is.
[[nodiscard]] std::string about_duration_text(double seconds);

/// Case-insensitive comparison in ASCII.
[[nodiscard]] bool equal_ignoring_case(std::string_view a, std::string_view b);

/// The candidate closest to `word` by edit distance, ignoring case; empty where none is near
/// (distance above 1 and a third of the length of the word). Words of more than 64 letters have no suggestion, nor do
/// words among more than 1000 candidates: they are names that a program made.
template <class Candidates>
[[nodiscard]] std::string nearest_word(std::string_view word, const Candidates& candidates);

/// Number of insertions, deletions and replacements that turn `a` into `b`, ignoring case.
[[nodiscard]] std::size_t edit_distance(std::string_view a, std::string_view b);

template <class Candidates>
std::string nearest_word(std::string_view word, const Candidates& candidates) {
  constexpr std::size_t longest = 64;
  constexpr std::size_t max_candidates = 1000;
  std::string_view best;
  if (word.size() > longest || std::size(candidates) > max_candidates) return {};
  std::size_t best_distance = word.size() / 3 + 1;
  for (const std::string_view candidate : candidates) {
    if (candidate.size() > word.size() + best_distance || candidate.size() + best_distance < word.size()) continue;
    const std::size_t distance = edit_distance(word, candidate);
    if (distance <= best_distance && (best.empty() || distance < best_distance)) {
      best = candidate;
      best_distance = distance;
    }
  }
  return std::string(best);
}

}  // namespace sarsim::core
