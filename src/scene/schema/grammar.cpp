#include "scene/schema/grammar.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/text/number_text.hpp"

namespace sarsim::scene::script {

namespace {

char upper(char c) { return (c >= 'a' && c <= 'z') ? static_cast<char>(c - 'a' + 'A') : c; }

bool letters_match(std::string_view typed, std::string_view word, std::size_t significant) {
  if (typed.empty()) return false;
  const std::size_t compared = std::min({typed.size(), word.size(), significant});
  return std::ranges::equal(typed.substr(0, compared), word.substr(0, compared), {}, upper);
}

// Every keyword by its significant letters.
constexpr std::array<std::string_view, 40> stems{"ISO", "DIR", "COS", "OTH", "STA", "TRA", "NOT", "ALI", "CON", "STD",
                                                 "MON", "CHI", "BAR", "REC", "LIN", "SIN", "STE", "SIM", "SAM", "FIX",
                                                 "ROT", "SPO", "HAN", "HAM", "NO_", "APP", "1OV", "ASC", "BIN", "BRA",
                                                 "HDF", "CSV", "NPY", "RAW", "MAT", "SRP", "BEG", "CEN", "SPA", "COM"};
constexpr std::array<std::string_view, 4> block_stems{"CUB", "MFI", "FIL", "INL"};

}  // namespace

std::string range_text(const Range& range) {
  const bool bounded_below = std::isfinite(range.low);
  const bool bounded_above = std::isfinite(range.high);
  if (bounded_below && bounded_above)
    return fmt::format(", {} to {}", core::format_number(range.low), core::format_number(range.high));
  if (!bounded_below) return bounded_above ? fmt::format(", at most {}", core::format_number(range.high)) : "";
  if (range.low == 0.0) return range.low_excluded ? ", above zero" : ", zero or more";
  return fmt::format(", at least {}", core::format_number(range.low));
}

bool keyword_matches(std::string_view typed, std::string_view keyword) { return letters_match(typed, keyword, 3); }

bool command_matches(std::string_view typed, std::string_view command) { return letters_match(typed, command, 5); }

bool is_keyword(std::string_view typed) {
  if (typed.size() < 3) return false;
  const auto is_it = [&](std::string_view stem) { return keyword_matches(typed, stem); };
  return std::ranges::any_of(stems, is_it) || std::ranges::any_of(block_stems, is_it);
}

bool begins_like_number(std::string_view typed) {
  return !typed.empty() && std::string_view("+-.0123456789").find(typed.front()) != std::string_view::npos;
}

}  // namespace sarsim::scene::script
