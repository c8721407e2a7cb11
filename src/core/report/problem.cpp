#include "core/report/problem.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace sarsim::core {

namespace {

const char* name_of(Severity severity) {
  switch (severity) {
    case Severity::error: return "error";
    case Severity::warning: return "warning";
    case Severity::note: return "note";
  }
  return "error";
}

bool same_cause(const Problem& a, const Problem& b) {
  return a.severity == b.severity && a.message == b.message && a.subject.kind == b.subject.kind &&
         a.subject.field == b.subject.field;
}

// A character of three bytes in UTF-8 that ends lines or turns their direction around (U+2028 to U+202E, U+2066 to
// U+2069), which a reader would not see; 0 for any other.
unsigned misleading_character(std::string_view text) {
  if (text.size() < 3 || text[0] != '\xE2') return 0;
  const auto second = static_cast<unsigned char>(text[1]);
  const auto third = static_cast<unsigned char>(text[2]);
  const unsigned character = 0x2000U + ((second & 0x3FU) << 6U) + (third & 0x3FU);
  const bool whole = (second & 0xC0U) == 0x80 && (third & 0xC0U) == 0x80;
  const bool misleads = (character >= 0x2028 && character <= 0x202E) || (character >= 0x2066 && character <= 0x2069);
  return whole && misleads ? character : 0;
}

}  // namespace

bool has_errors(const Problems& problems) {
  return std::ranges::any_of(problems, [](const Problem& p) { return p.severity == Severity::error; });
}

std::string printable(std::string_view text) {
  std::string shown;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const auto next = i + 1 < text.size() ? static_cast<unsigned char>(text[i + 1]) : 0U;
    if ((byte < 0x20 && byte != '\n' && byte != '\t') || byte == 0x7F)
      shown += fmt::format("\\x{:02x}", byte);
    else if (byte == 0xC2 && next >= 0x80 && next < 0xA0)
      shown += fmt::format("\\u{:04x}", next), ++i;
    else if (const unsigned character = misleading_character(text.substr(i)); character != 0)
      shown += fmt::format("\\u{:04x}", character), i += 2;
    else
      shown += text[i];
  }
  return shown;
}

std::string to_string(const Problem& problem) {
  std::string text;
  const Place& place = problem.place;
  if (!place.file.empty()) text += place.file + ":";
  if (place.line > 0) text += fmt::format("{}:", place.line);
  if (place.line > 0 && place.column > 0) text += fmt::format("{}:", place.column);
  if (!text.empty()) text += " ";
  text += fmt::format("{}: {}", name_of(problem.severity), problem.message);
  if (!problem.found.empty()) text += fmt::format("; found '{}'", problem.found);
  if (!problem.expected.empty())
    text += fmt::format("{} expected {}", problem.found.empty() ? ";" : ",", problem.expected);
  if (problem.count > 1) text += fmt::format(" ({} times)", problem.count);
  if (!problem.hint.empty()) text += fmt::format("\n    {}", problem.hint);
  return printable(text);
}

Problems ranked(Problems problems) {
  Problems merged;
  for (Problem& problem : problems) {
    const bool alone = problem.severity == Severity::error && problem.place.line > 0;
    const auto first =
        alone ? merged.end() : std::ranges::find_if(merged, [&](const Problem& p) { return same_cause(p, problem); });
    if (first == merged.end())
      merged.push_back(std::move(problem));
    else
      first->count += problem.count;
  }
  std::ranges::stable_sort(merged, {}, &Problem::severity);
  return merged;
}

}  // namespace sarsim::core
