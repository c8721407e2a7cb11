#include "core/report/problem.hpp"

#include <algorithm>
#include <functional>
#include <iterator>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

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

// So many errors of one cause, each with its place, are a list to work through; more of them are one mistake.
constexpr std::size_t max_told_alone = 100;

// Severity, message, kind and field of the object.
using Cause = std::tuple<Severity, std::string, std::string, std::string>;

Cause cause_of(const Problem& problem) {
  return {problem.severity, problem.message, problem.subject.kind, problem.subject.field};
}

// How often a cause was met, and where the first of it is.
struct Met {
  std::size_t first = 0;
  std::size_t times = 0;
  bool alone = false;  // Some of them stand for themselves.
};

// Of causes that are met too often the first one counts for all.
void drop_repeated(const std::map<Cause, Met, std::less<>>& met, Problems& merged) {
  std::vector<char> drop(merged.size(), 0);
  bool any = false;
  for (std::size_t i = 0; i < merged.size(); ++i) {
    const Met& known = met.find(cause_of(merged[i]))->second;
    if (!known.alone || known.times <= max_told_alone || known.first == i) continue;
    merged[known.first].count += merged[i].count;
    drop[i] = 1;
    any = true;
  }
  if (!any) return;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < merged.size(); ++i)
    if (drop[i] == 0) {
      if (kept != i) merged[kept] = std::move(merged[i]);
      ++kept;
    }
  merged.resize(kept);
}

struct Character {
  unsigned code = 0;
  std::size_t bytes = 1;
  bool whole = false;  // Of UTF-8; else a byte that stands alone.
};

// The character that a text begins with, of up to three bytes: longer ones give no orders.
Character first_character(std::string_view text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
  const auto follows = [&](std::size_t i) { return (byte(i) & 0xC0U) == 0x80; };
  const unsigned lead = byte(0);
  if (lead < 0x80) return {lead, 1, true};
  if (lead >= 0xC2 && lead < 0xE0 && follows(1)) return {((lead & 0x1FU) << 6U) + (byte(1) & 0x3FU), 2, true};
  if (lead >= 0xE0 && lead < 0xF0 && follows(1) && follows(2))
    return {((lead & 0xFU) << 12U) + ((byte(1) & 0x3FU) << 6U) + (byte(2) & 0x3FU), 3, true};
  if (lead >= 0xF0 && lead < 0xF5 && follows(1) && follows(2) && follows(3)) return {0x10000, 4, true};
  return {lead, 1, false};
}

// Control characters (C0 but for line feed and tab, DEL, C1), line ends that are none, and marks that turn the
// direction of what follows, which a reader would not see.
bool gives_orders(unsigned code) {
  if (code == '\n' || code == '\t') return false;
  return code < 0x20 || (code >= 0x7F && code < 0xA0) || code == 0x061C || code == 0x200E || code == 0x200F ||
         (code >= 0x2028 && code <= 0x202E) || (code >= 0x2066 && code <= 0x2069);
}

// Readers quote single words (core/text/quoted_word.hpp); no list of them becomes longer than a page.
std::string bounded(std::string_view text) {
  constexpr std::size_t longest = 2000;
  if (text.size() <= longest) return std::string(text);
  std::size_t end = longest;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80) --end;
  return std::string(text.substr(0, end)) + "...";
}

}  // namespace

ProblemBuilder::ProblemBuilder(Severity severity, RuleId id, std::string message) {
  problem_.severity = severity;
  problem_.id = id;
  problem_.message = std::move(message);
}

ProblemBuilder&& ProblemBuilder::found(std::string text) && {
  problem_.found = std::move(text);
  return std::move(*this);
}

ProblemBuilder&& ProblemBuilder::expected(std::string text) && {
  problem_.expected = std::move(text);
  return std::move(*this);
}

ProblemBuilder&& ProblemBuilder::hint(std::string text) && {
  problem_.hint = std::move(text);
  return std::move(*this);
}

ProblemBuilder&& ProblemBuilder::at(std::string kind, std::size_t index, std::string field) && {
  return std::move(*this).at(Subject{std::move(kind), index, std::move(field)});
}

ProblemBuilder&& ProblemBuilder::at(Subject subject) && {
  problem_.subject = std::move(subject);
  return std::move(*this);
}

ProblemBuilder&& ProblemBuilder::in(std::string file, std::size_t line, std::size_t column) && {
  return std::move(*this).in(Place{std::move(file), line, column});
}

ProblemBuilder&& ProblemBuilder::in(Place place) && {
  problem_.place = std::move(place);
  return std::move(*this);
}

ProblemBuilder&& ProblemBuilder::times(std::size_t count) && {
  problem_.count = count;
  return std::move(*this);
}

ProblemBuilder::operator Problem() && { return std::move(problem_); }

ProblemBuilder error(std::string message) { return {Severity::error, std::move(message)}; }
ProblemBuilder warning(std::string message) { return {Severity::warning, std::move(message)}; }
ProblemBuilder note(std::string message) { return {Severity::note, std::move(message)}; }
ProblemBuilder error(RuleId id, std::string message) { return {Severity::error, id, std::move(message)}; }
ProblemBuilder warning(RuleId id, std::string message) { return {Severity::warning, id, std::move(message)}; }
ProblemBuilder note(RuleId id, std::string message) { return {Severity::note, id, std::move(message)}; }

void append(Problems& problems, Problems more) { std::ranges::move(more, std::back_inserter(problems)); }

bool has_errors(const Problems& problems) {
  return std::ranges::any_of(problems, [](const Problem& p) { return p.severity == Severity::error; });
}

std::string printable(std::string_view text) {
  std::string shown;
  shown.reserve(text.size());
  while (!text.empty()) {
    const Character character = first_character(text);
    if (!gives_orders(character.code))
      shown += text.substr(0, character.bytes);
    else if (character.code < 0x80 || !character.whole)
      shown += fmt::format("\\x{:02x}", character.code);
    else
      shown += fmt::format("\\u{:04x}", character.code);
    text.remove_prefix(character.bytes);
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
  text += fmt::format("{}: {}", name_of(problem.severity), bounded(problem.message));
  if (!problem.found.empty()) text += fmt::format("; found '{}'", bounded(problem.found));
  if (!problem.expected.empty())
    text += fmt::format("{} expected {}", problem.found.empty() ? ";" : ",", bounded(problem.expected));
  if (problem.count > 1) text += fmt::format(" ({} times)", problem.count);
  if (!problem.hint.empty()) text += fmt::format("\n    {}", bounded(problem.hint));
  return printable(text);
}

Problems ranked(Problems problems) {
  std::map<Cause, Met, std::less<>> met;
  Problems merged;
  for (Problem& problem : problems) {
    const bool alone = problem.severity == Severity::error && problem.place.line > 0;
    Met& known = met.try_emplace(cause_of(problem), Met{merged.size(), 0, false}).first->second;
    ++known.times;
    known.alone = known.alone || alone;
    if (known.times > 1 && (!alone || known.times > max_told_alone))
      merged[known.first].count += problem.count;
    else
      merged.push_back(std::move(problem));
  }
  drop_repeated(met, merged);
  std::ranges::stable_sort(merged, {}, &Problem::severity);
  return merged;
}

}  // namespace sarsim::core
