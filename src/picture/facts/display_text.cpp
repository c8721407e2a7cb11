#include "picture/facts/display_text.hpp"

#include <array>
#include <utility>

#include "core/text/letters.hpp"

namespace sarsim::picture {

namespace {

using core::is_digit;
using core::is_letter;

constexpr std::array<std::pair<std::string_view, std::string_view>, 11> units{{{"us", "µs"},
                                                                               {"um", "µm"},
                                                                               {"uV", "µV"},
                                                                               {"uW", "µW"},
                                                                               {"m2", "m²"},
                                                                               {"cm2", "cm²"},
                                                                               {"mm2", "mm²"},
                                                                               {"km2", "km²"},
                                                                               {"m/s2", "m/s²"},
                                                                               {"m/s^2", "m/s²"},
                                                                               {"m^2", "m²"}}};

// The unit that begins here, behind a number and a blank, and ends where a word does.
const std::pair<std::string_view, std::string_view>* unit_at(std::string_view text, std::size_t at) {
  if (at < 2 || text[at - 1] != ' ' || !is_digit(text[at - 2])) return nullptr;
  const std::string_view rest = text.substr(at);
  for (const auto& unit : units) {
    if (!rest.starts_with(unit.first)) continue;
    const char next = unit.first.size() < rest.size() ? rest[unit.first.size()] : ' ';
    if (!is_digit(next) && !is_letter(next) && next != '/' && next != '^' && next != '_' && next != '.') return &unit;
  }
  return nullptr;
}

// "1E-06" as "1e-6": how many characters of the text that takes; 0 where there is no exponent.
std::size_t append_exponent(std::string& shown, std::string_view text, std::size_t at) {
  if (at == 0 || (text[at] != 'E' && text[at] != 'e') || !is_digit(text[at - 1])) return 0;
  std::size_t end = at + 1;
  const bool negative = end < text.size() && text[end] == '-';
  if (end < text.size() && (text[end] == '-' || text[end] == '+')) ++end;
  const std::size_t first = end;
  while (end < text.size() && is_digit(text[end])) ++end;
  if (end == first || (end < text.size() && is_letter(text[end]))) return 0;
  std::string_view digits = text.substr(first, end - first);
  while (digits.size() > 1 && digits.front() == '0') digits.remove_prefix(1);
  shown.append(negative ? "e-" : "e").append(digits);
  return end - at;
}

}  // namespace

std::string display_text(std::string_view quantity) {
  // A name is no quantity.
  const std::size_t start = quantity.find_first_not_of("-+ ");
  if (start == std::string_view::npos || !(is_digit(quantity[start]) || quantity[start] == '.'))
    return std::string(quantity);
  std::string shown;
  for (std::size_t at = 0; at < quantity.size();) {
    if (const auto* unit = unit_at(quantity, at)) {
      shown += unit->second;
      at += unit->first.size();
    } else if (const std::size_t taken = append_exponent(shown, quantity, at); taken > 0) {
      at += taken;
    } else {
      shown += quantity[at++];
    }
  }
  return shown;
}

std::string read_out_text(std::string_view quantity) {
  constexpr std::string_view either = "+/- ";
  if (quantity.starts_with(either)) return "± " + read_out_text(quantity.substr(either.size()));
  const std::string plain = display_text(quantity);
  std::string shown;
  for (std::size_t i = 0; i < plain.size(); ++i) {
    const bool begins = i == 0 || plain[i - 1] == ' ' || plain[i - 1] == '(' || plain[i - 1] == 'e';
    if (plain[i] == '-' && begins && i + 1 < plain.size() && is_digit(plain[i + 1]))
      shown += "−";
    else
      shown += plain[i];
  }
  return shown;
}

}  // namespace sarsim::picture
