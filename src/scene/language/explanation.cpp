#include "scene/language/explanation.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <sstream>

#include <fmt/format.h>

#include "core/text/letters.hpp"
#include "core/text/number_text.hpp"
#include "scene/language/explanation_search.hpp"
#include "scene/language/format_mark.hpp"
#include "scene/language/path_facts.hpp"
#include "scene/schema/trade_words.hpp"

namespace sarsim::scene::language {

namespace {

// A path with the table that it belongs to.
struct Found {
  const PlainTable* table;
  PathFacts facts;
  const PlainTable* object = nullptr;  // of a field of the entries of a list: what has the list,
  PathFacts list = {};                 // and the list

  [[nodiscard]] bool is_of_entry() const { return object != nullptr; }
  [[nodiscard]] const PlainTable& owner() const { return is_of_entry() ? *object : *table; }
  // Below the object.
  [[nodiscard]] std::string path_of(const PathFacts& other) const {
    return is_of_entry() ? fmt::format("{}.{}", list.path, other.path) : other.path;
  }
  [[nodiscard]] std::string path() const { return path_of(facts); }
  [[nodiscard]] std::string name() const { return fmt::format("{}.{}", owner().header, path()); }
};

std::vector<Found> entry_paths(const PlainTable& object, const PathFacts& list) {
  std::vector<Found> found;
  if (list.spec().type != FieldType::list) return found;
  const PlainTable& entries = element_table(list.spec().list);
  for (PathFacts& facts : paths_of(entries)) found.push_back({&entries, std::move(facts), &object, list});
  return found;
}

// Every path of every object, those of entries of lists behind that of the list.
std::vector<Found> every_path() {
  std::vector<Found> all;
  for (const PlainTable& table : plain_tables())
    for (PathFacts& facts : paths_of(table)) {
      std::vector<Found> entries = entry_paths(table, facts);
      all.push_back({&table, std::move(facts)});
      std::ranges::move(entries, std::back_inserter(all));
    }
  return all;
}

ExplanationLine line_of(const Found& found) {
  return {found.name(), default_text(found.facts), first_sentence(meaning_text(found.facts))};
}

std::string next_text(const Explanation& explanation) {
  return fmt::format("sarsim explain {} tells more about one of them", explanation.lines.front().name);
}

std::vector<AlternativeExplanation> explained_alternatives(const Found& found) {
  std::vector<AlternativeExplanation> explained;
  for (const Choice& alternative : alternatives(found.facts.spec())) {
    AlternativeExplanation& one = explained.emplace_back();
    one.word = type_word(alternative);
    one.meaning = alternative.meaning.empty() ? alternative.shown : alternative.meaning;
    one.in_script = alternative.word;
    for (const PathFacts& facts : paths_of_alternative(*found.table, found.facts, alternative))
      one.fields.push_back(found.path_of(facts));
    one.example = example_text(*found.table, found.facts, alternative);
  }
  return explained;
}

Explanation explained(const Found& found) {
  const PathFacts& facts = found.facts;
  const Quantity quantity = quantity_of(facts);
  Explanation explanation;
  explanation.name = found.name();
  explanation.meaning = meaning_text(facts);
  explanation.takes = takes_text(facts);
  for (const std::string_view unit : units_of(quantity)) explanation.other_units.emplace_back(unit);
  if (!explanation.other_units.empty()) {
    explanation.unit = explanation.other_units.front();
    explanation.other_units.erase(explanation.other_units.begin());
  }
  explanation.limits = range_of(facts);
  explanation.range = range_text(facts);
  if (!likely_text(facts).empty()) explanation.likely_limits = likely_range_of(facts);
  explanation.likely = likely_text(facts);
  explanation.initial = default_text(facts);
  explanation.applies_to = dependence_text(*found.table, facts);
  explanation.shorthand = shorthand_text(*found.table, facts);
  explanation.example = example_text(*found.table, facts);
  if (found.is_of_entry()) {
    const std::string& list = found.list.path;
    explanation.example = fmt::format("{} = [{}]", list.substr(list.rfind('.') + 1), explanation.example);
  }
  explanation.in_script = script_text(facts);
  explanation.label = label_text(facts);
  explanation.set_names = set_names(facts);
  if (facts.role == PathRole::choice) explanation.alternatives = explained_alternatives(found);
  for (const Found& entry : entry_paths(*found.table, facts)) explanation.lines.push_back(line_of(entry));
  if (!explanation.lines.empty()) explanation.next = next_text(explanation);
  return explanation;
}

Explanation explained(const PlainTable& table) {
  Explanation explanation;
  explanation.name = table.header;
  explanation.meaning = table.meaning;
  explanation.takes =
      fmt::format("a table with the header {}{}", table.header_line(), table.is_list ? "; there may be many" : "");
  explanation.in_script = fmt::format("${}", table.command);
  for (const PathFacts& facts : paths_of(table)) explanation.lines.push_back(line_of({&table, facts}));
  explanation.next = next_text(explanation);
  return explanation;
}

// The words before all headers and [let], which are not fields.
std::vector<Explanation> general_words() {
  Explanation format;
  format.name = "format";
  format.meaning = "Marks the file as a scene of format 2. It comes before the first header of every file.";
  format.takes = fmt::format("\"{}\"", format_2_mark);
  format.example = fmt::format("format = \"{}\"", format_2_mark);
  format.in_script = "nothing: a script has no mark";
  Explanation include;
  include.name = "include";
  include.meaning =
      "Other files of format 2 that are read first. Names are relative to the file that states them. Objects and the "
      "names of [let] of all files are combined.";
  include.takes = "an array of file names, before the first header";
  include.example = "include = [\"ground.toml\"]";
  include.in_script = "nothing: a script is one file";
  Explanation let;
  let.name = "let";
  let.meaning =
      "Names for values used in several places. A value is a number or an expression in quotes, which may use other "
      "names. Every quantity in quotes may use them; --let NAME=VALUE replaces one.";
  let.takes = "a table with the header [let]: names of letters, digits and underscores";
  let.example = "[let]\nspeed = \"240 m/s\"\nway = \"speed * 10 s\"";
  let.in_script = "nothing: a script has numbers alone";
  return {format, include, let};
}

Explanation overview() {
  Explanation explanation;
  explanation.meaning = "A scene of format 2 is a TOML file. It can contain:";
  for (const Explanation& general : general_words())
    explanation.lines.push_back({general.name, "", first_sentence(general.meaning)});
  for (const PlainTable& table : plain_tables())
    explanation.lines.push_back({std::string(table.header), "", first_sentence(std::string(table.meaning))});
  explanation.next =
      "sarsim explain radar              the fields of a kind\n"
      "sarsim explain radar.pulse        a choice with its alternatives\n"
      "sarsim explain radar.pulse.width  one field";
  return explanation;
}

// Every path that a word can mean: the whole path with or without its kind, or its end.
std::vector<Found> paths_called(std::string_view word) {
  std::vector<Found> whole;
  std::vector<Found> ends;
  for (Found& found : every_path()) {
    if (found.name() == word) return {std::move(found)};
    const std::string path = found.path();
    if (path == word)
      whole.push_back(std::move(found));
    else if (path.ends_with(fmt::format(".{}", word)))
      ends.push_back(std::move(found));
  }
  return whole.empty() ? ends : whole;
}

bool is_name_of(const PlainTable& table, const PlainField& field, std::string_view word) {
  if (word == field.spec.id || word == fmt::format("{}.{}", table.header, field.spec.id)) return true;
  return std::ranges::any_of(field.set_names, [&](const std::string& name) {
    const std::size_t dot = table.is_list ? name.find('.') + 1 : 0;
    const std::string_view plain = std::string_view(name).substr(dot);
    return word == name || word == plain || word == fmt::format("{}.{}", table.header, plain);
  });
}

// Whether the form, `--set` or the scene call a path so; "platform.legs.length" of a field of a list's entries.
bool is_named(const Found& found, std::string_view word) {
  const auto is_it = [&](const PathFacts& facts, std::string_view name) {
    return std::ranges::any_of(facts.fields,
                               [&](const PlainField* field) { return is_name_of(found.owner(), *field, name); });
  };
  if (!found.is_of_entry()) return is_it(found.facts, word);
  const std::string end = fmt::format(".{}", found.facts.path);
  return word.ends_with(end) && is_it(found.list, word.substr(0, word.size() - end.size()));
}

std::vector<Found> paths_named(std::string_view word) {
  std::vector<Found> found = every_path();
  std::erase_if(found, [&](const Found& one) { return !is_named(one, word); });
  return found;
}

// Those below a table that is not a choice: "radar.antenna.azimuth", of which there are points and interpolation.
std::vector<Found> paths_below(std::string_view word) {
  const std::string below = fmt::format("{}.", word);
  std::vector<Found> found = every_path();
  std::erase_if(found,
                [&](const Found& one) { return !one.name().starts_with(below) && !one.path().starts_with(below); });
  return found;
}

// @param meaning  in a sentence that the fields follow
Explanation several(std::string_view word, const std::vector<Found>& found, std::string_view meaning) {
  if (found.size() == 1) return explained(found.front());
  Explanation explanation;
  explanation.name = word;
  explanation.meaning = meaning;
  for (const Found& one : found) explanation.lines.push_back(line_of(one));
  explanation.next = next_text(explanation);
  return explanation;
}

// The field that is written like the word, looked for within its kind where it names one.
std::string nearest_name(const std::string& word) {
  std::vector<std::string> names;
  for (const Explanation& general : general_words()) names.push_back(general.name);
  for (const PlainTable& table : plain_tables()) names.emplace_back(table.header);
  for (const Found& found : every_path()) {
    const std::string path = found.path();
    names.push_back(word.starts_with(fmt::format("{}.", found.owner().header)) ? found.name() : path);
    if (word.find('.') == std::string::npos) names.push_back(path.substr(path.rfind('.') + 1));
    if (!found.is_of_entry()) continue;
    const std::string& list = found.list.path;  // "legs.length", "platform.legs.length"
    const std::string below = fmt::format("{}.{}", list.substr(list.rfind('.') + 1), found.facts.path);
    names.push_back(below);
    names.push_back(fmt::format("{}.{}", found.owner().header, below));
  }
  return core::nearest_word(word, names);
}

Explanation unknown(const std::string& word) {
  Explanation explanation;
  explanation.failure = fmt::format("format 2 has no '{}'", core::clipped(word));
  const std::string near = nearest_name(word);
  explanation.hint = near.empty() ? "sarsim explain lists what there is" : fmt::format("did you mean '{}'?", near);
  return explanation;
}

// The field of that kind and path, or a choice that has it.
std::optional<Found> path_at(std::string_view name) {
  for (Found& found : every_path())
    if (found.name() == name) return std::move(found);
  return std::nullopt;
}

// What a word of the trade says here, in one line.
std::string said_of(std::string_view word, const TradeWord& meant) {
  return fmt::format("{}: {}", core::clipped(word), trade_advice(meant, {.name = word}));
}

// Of a word that stands for one field, that field.
std::optional<Explanation> explained_trade(const std::string& word) {
  const TradeWord* const meant = trade_word(word, {});
  if (meant != nullptr && meant->law != TradeLaw::none)
    if (const auto found = path_at(meant->field)) {
      Explanation explanation = explained(*found);
      explanation.asked = said_of(word, *meant);
      return explanation;
    }
  for (const TradeChoice& choice : trade_choices()) {
    if (trade_choice(word, choice.choice) != &choice) continue;
    const auto found = paths_called(choice.choice);
    if (meant != nullptr || found.empty()) continue;
    Explanation explanation = explained(found.front());
    explanation.asked = fmt::format("{}: {} as {}", core::clipped(word), trade_advice(choice), explanation.name);
    if (choice.word.empty()) explanation.asked = fmt::format("{}: {}", core::clipped(word), choice.note);
    return explanation;
  }
  return std::nullopt;
}

// Whether the trade means another field by a word than those that `--set` calls so: "pri".
bool means_another(std::string_view word, const std::vector<Found>& found) {
  const TradeWord* const meant = trade_word(word, {});
  if (meant == nullptr || meant->law == TradeLaw::none || keeps_value(meant->law)) return false;
  return std::ranges::none_of(found, [&](const Found& one) { return one.name() == meant->field; });
}

SearchText search_text(const Found& found) {
  SearchText text{found.name(), {}, meaning_text(found.facts)};
  for (const TradeWord& word : trade_words())
    if (word.field == text.name) text.aliases += fmt::format(" {}", word.names);
  if (found.facts.role == PathRole::choice)
    for (const Choice& choice : alternatives(found.facts.spec())) {
      text.aliases += " " + type_word(choice);
      text.meaning += " " + std::string(choice.meaning);
    }
  return text;
}

// All that has to do with some words; nothing where nothing has.
std::optional<Explanation> searched(const std::string& words) {
  constexpr std::size_t max_lines = 24;
  constexpr std::size_t max_pages = 12;
  const std::vector<Found> paths = every_path();
  std::vector<SearchText> texts;
  for (const Found& found : paths) texts.push_back(search_text(found));
  Explanation explanation;
  explanation.name = core::clipped(words);
  for (const std::size_t i : best_matches(words, texts)) {
    const ExplanationLine line = line_of(paths[i]);
    const auto same = [&](const ExplanationLine& one) { return one.name == line.name; };
    if (explanation.lines.size() < max_lines && std::ranges::none_of(explanation.lines, same))
      explanation.lines.push_back(line);
  }
  explanation.pages = headings_with(words);
  if (explanation.pages.size() > max_pages) explanation.pages.resize(max_pages);
  const TradeWord* const meant = trade_word(words, {});
  if (explanation.lines.empty() && explanation.pages.empty() && meant == nullptr) return std::nullopt;
  explanation.meaning = meant != nullptr ? said_of(words, *meant) : "No field has this name. Related entries:";
  if (!explanation.lines.empty()) explanation.next = next_text(explanation);
  return explanation;
}

// Of three words or more by all but one: "range cell migration".
std::optional<Explanation> searched_in_part(const std::string& words) {
  std::vector<std::string> all;
  std::istringstream stream(words);
  for (std::string word; stream >> word;) all.push_back(word);
  constexpr std::size_t most = 6;
  for (std::size_t left_out = 0; all.size() >= 3 && all.size() <= most && left_out < all.size(); ++left_out) {
    std::string part;
    for (std::size_t i = 0; i < all.size(); ++i)
      if (i != left_out) part += (part.empty() ? "" : " ") + all[i];
    if (auto found = searched(part)) return found;
  }
  return std::nullopt;
}

// "[[radar]]" and "radar.pulse.type" mean "radar" and "radar.pulse".
std::string plain_word(std::string_view word) {
  std::string text(core::trimmed(word));
  std::erase_if(text, [](char c) { return c == '[' || c == ']'; });
  return text;
}

}  // namespace

std::string first_sentence(const std::string& text) {
  for (std::size_t end = text.find(". "); end != std::string::npos; end = text.find(". ", end + 1))
    if (end < 2 || text[end - 2] != '.') return text.substr(0, end + 1);  // "i.e. so" goes on
  return text;
}

Explanation explain(std::string_view word) {
  const std::string text = plain_word(word);
  if (text.empty()) return overview();
  for (Explanation& general : general_words())
    if (general.name == text) {
      for (const Found& found : paths_called(text)) general.lines.push_back(line_of(found));
      return std::move(general);
    }
  if (const PlainTable* const table = plain_table(text)) return explained(*table);
  if (const std::vector<Found> found = paths_called(text); !found.empty())
    return several(text, found, "Several fields have this name:");
  if (const std::vector<Found> found = paths_named(text); !found.empty() && !means_another(text, found))
    return several(text, found, "Several fields have this name:");
  if (const std::vector<Found> found = paths_below(text); !found.empty())
    return several(text, found, "A table with these fields:");
  constexpr std::string_view type = ".type";
  if (text.ends_with(type)) return explain(std::string_view(text).substr(0, text.size() - type.size()));
  if (const auto trade = explained_trade(text)) return *trade;
  if (const auto found = searched(text)) return *found;
  if (const auto found = searched_in_part(text)) return *found;
  return unknown(text);
}

}  // namespace sarsim::scene::language
