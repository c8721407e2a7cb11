#include "workflow/input/carried_problems.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "core/text/letters.hpp"
#include "core/text/number_text.hpp"

namespace sarsim::workflow {

namespace {

constexpr std::array<std::string_view, 28> measuring_words{
    "about", "m",     "mm",         "cm",          "km",   "s",  "ms", "us",  "deg",    "rad",
    "Hz",    "m/s",   "off",        "between",     "near", "a",  "at", "and", "states", "state",
    "every", "radar", "wavelength", "wavelengths", "of",   "to", "up", "most"};

// A word without the marks behind it.
std::string_view bare(std::string_view word) {
  while (!word.empty() && std::string_view(",;:").find(word.back()) != std::string_view::npos) word.remove_suffix(1);
  return word;
}

std::string measures_in(std::string_view found) {
  std::string text;
  bool number = false;
  while (!(found = core::trimmed(found)).empty()) {
    const std::string_view word = found.substr(0, found.find_first_of(" \t\r\n"));
    found.remove_prefix(word.size());
    const bool is_number = core::parse_number(bare(word)).has_value();
    number = number || is_number;
    const bool stays = is_number || std::ranges::find(measuring_words, bare(word)) != measuring_words.end();
    if (!stays && text.ends_with("...")) continue;
    text += (text.empty() ? "" : " ") + (stays ? std::string(word) : "...");
  }
  return number ? text : std::string();
}

}  // namespace

void drop_quotes(core::Problem& problem) {
  problem.found = measures_in(problem.found);
  std::string& text = problem.message;
  for (std::size_t begin = text.find('\''); begin != std::string::npos;) {
    const std::size_t end = text.find('\'', begin + 1);
    if (end == std::string::npos) break;
    text.replace(begin, end + 1 - begin, "'...'");
    begin = text.find('\'', begin + 5);
  }
}

core::Problems without_quotes(core::Problems problems) {
  std::ranges::for_each(problems, drop_quotes);
  return problems;
}

}  // namespace sarsim::workflow
