#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "scene/language/explanation.hpp"
#include "scene/language/path_facts.hpp"

/// Explanations as lines for people and as JSON.
namespace sarsim::scene::language {

namespace {

constexpr std::size_t line_width = 100;

// The text in lines of limited length; those behind the first begin with some blanks.
std::string wrapped(std::string_view text, std::size_t indent) {
  std::string result;
  std::size_t column = indent;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    const std::string_view word = text.substr(begin, end - begin);
    if (column > indent && column + 1 + word.size() > line_width) {
      result += "\n" + std::string(indent, ' ');
      column = indent;
    }
    if (column > indent) result += ' ', ++column;
    result += word;
    column += word.size();
    begin = end + 1;
  }
  return result;
}

// Each line begins with some blanks.
std::string indented(std::string_view text, std::size_t indent) {
  std::string result(indent, ' ');
  for (const char c : text) {
    result += c;
    if (c == '\n') result.append(indent, ' ');
  }
  return result;
}

class Lines {
 public:
  void fact(std::string_view name, std::string_view text) {
    constexpr std::size_t column = 16;
    if (!text.empty()) text_ += fmt::format("  {:<14}{}\n", name, wrapped(text, column));
  }
  // A text with line ends of its own.
  void block(std::string_view name, std::string_view text) {
    constexpr std::size_t column = 16;
    if (!text.empty()) text_ += fmt::format("  {:<14}{}\n", name, indented(text, column).substr(column));
  }
  void plain(std::string_view text) { text_ += std::string(text) + "\n"; }

  [[nodiscard]] std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

void add_alternatives(Lines& lines, const Explanation& explanation) {
  if (explanation.alternatives.empty()) return;
  lines.plain("\n  Types");
  for (const AlternativeExplanation& one : explanation.alternatives) {
    lines.plain(fmt::format("    {:<16}{}{}", one.word, one.meaning,
                            one.in_script.empty() ? "" : fmt::format(" ({})", one.in_script)));
    if (!one.fields.empty()) lines.plain(std::string(20, ' ') + wrapped(joined(one.fields, ", "), 20));
    lines.plain(indented(one.example, 20));
  }
}

void add_lines(Lines& lines, const Explanation& explanation) {
  if (explanation.lines.empty()) return;
  std::size_t widest = 0;
  std::size_t widest_value = 0;
  for (const ExplanationLine& line : explanation.lines) {
    widest = std::max(widest, line.name.size());
    widest_value = std::max(widest_value, std::min<std::size_t>(line.value.size(), 16));
  }
  lines.plain("");
  for (const ExplanationLine& line : explanation.lines) {
    const std::string head =
        fmt::format("  {:<{}}  {:<{}}{}", line.name, widest, line.value, widest_value, widest_value == 0 ? "" : "  ");
    lines.plain(head + line.meaning);
  }
}

void add_pages(Lines& lines, const Explanation& explanation) {
  if (explanation.pages.empty()) return;
  lines.plain("\n  In the documentation");
  std::size_t widest = 0;
  for (const GuideHeading& page : explanation.pages) widest = std::max(widest, page.page.size());
  for (const GuideHeading& page : explanation.pages)
    lines.plain(fmt::format("    {:<{}}  {}", page.page, widest, page.heading.empty() ? page.title : page.heading));
}

std::string units_text(const Explanation& explanation) {
  if (explanation.unit.empty()) return {};
  const std::string text = explanation.unit + " where none is written";
  return explanation.other_units.empty() ? text
                                         : fmt::format("{}; also {}", text, joined(explanation.other_units, ", "));
}

void write_range(core::JsonWriter& json, std::string_view name, const Range& range, std::string_view words) {
  if (words.empty()) return;
  json.key(name).begin_object();
  if (std::isfinite(range.low)) json.member(range.low_excluded ? "above" : "minimum", range.low);
  if (std::isfinite(range.high)) json.member("maximum", range.high);
  json.member("text", words).end_object();
}

void write_words(core::JsonWriter& json, std::string_view name, const std::vector<std::string>& words) {
  if (words.empty()) return;
  json.key(name).begin_array();
  for (const std::string& word : words) json.value(word);
  json.end_array();
}

void write_some(core::JsonWriter& json, std::string_view name, std::string_view text) {
  if (!text.empty()) json.member(name, text);
}

void write_alternatives(core::JsonWriter& json, const Explanation& explanation) {
  if (explanation.alternatives.empty()) return;
  json.key("types").begin_array();
  for (const AlternativeExplanation& one : explanation.alternatives) {
    json.begin_object().member("type", one.word).member("meaning", one.meaning);
    write_some(json, "script", one.in_script);
    write_words(json, "fields", one.fields);
    json.member("example", one.example).end_object();
  }
  json.end_array();
}

void write_lines(core::JsonWriter& json, const Explanation& explanation) {
  if (explanation.lines.empty()) return;
  json.key("fields").begin_array();
  for (const ExplanationLine& line : explanation.lines) {
    json.begin_object().member("name", line.name);
    write_some(json, "default", line.value);
    json.member("meaning", line.meaning).end_object();
  }
  json.end_array();
}

void write_pages(core::JsonWriter& json, const Explanation& explanation) {
  if (explanation.pages.empty()) return;
  json.key("pages").begin_array();
  for (const GuideHeading& page : explanation.pages) {
    json.begin_object().member("page", page.page).member("title", page.title);
    write_some(json, "heading", page.heading);
    json.end_object();
  }
  json.end_array();
}

}  // namespace

std::string text_of(const Explanation& explanation) {
  Lines lines;
  if (!explanation.asked.empty()) lines.plain(wrapped(explanation.asked, 0) + "\n");
  if (!explanation.name.empty()) lines.plain(explanation.name);
  const std::size_t indent = explanation.name.empty() ? 0 : 4;
  lines.plain(std::string(indent, ' ') + wrapped(explanation.meaning, indent));
  const bool has_facts = !explanation.takes.empty();
  if (has_facts) lines.plain("");
  lines.fact("Takes", explanation.takes);
  lines.fact("Unit", units_text(explanation));
  lines.fact("Range", explanation.range);
  lines.fact("Likely", explanation.likely);
  lines.fact("Default", explanation.initial);
  lines.fact("Applies to", explanation.applies_to);
  lines.block("Example", explanation.example);
  lines.fact("Shorthand", explanation.shorthand);
  lines.fact("In a script", explanation.in_script);
  lines.fact("Workbench", explanation.label);
  lines.fact("--set", joined(explanation.set_names, ", "));
  add_alternatives(lines, explanation);
  add_lines(lines, explanation);
  add_pages(lines, explanation);
  if (!explanation.next.empty()) lines.plain("\n" + explanation.next);
  return lines.take();
}

void write_json(core::JsonWriter& json, const Explanation& explanation) {
  json.begin_object();
  write_some(json, "name", explanation.name);
  json.member("meaning", explanation.meaning);
  write_some(json, "takes", explanation.takes);
  write_some(json, "unit", explanation.unit);
  write_words(json, "other_units", explanation.other_units);
  write_range(json, "range", explanation.limits, explanation.range);
  write_range(json, "likely", explanation.likely_limits, explanation.likely);
  write_some(json, "default", explanation.initial);
  write_some(json, "applies_to", explanation.applies_to);
  write_some(json, "shorthand", explanation.shorthand);
  write_some(json, "example", explanation.example);
  write_some(json, "script", explanation.in_script);
  write_some(json, "workbench", explanation.label);
  write_words(json, "set", explanation.set_names);
  write_alternatives(json, explanation);
  write_lines(json, explanation);
  write_some(json, "asked", explanation.asked);
  write_pages(json, explanation);
  json.end_object();
}

}  // namespace sarsim::scene::language
