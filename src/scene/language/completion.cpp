#include "scene/language/completion.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "core/text/letters.hpp"
#include "core/toml/scan.hpp"
#include "scene/language/cursor.hpp"
#include "scene/language/explanation.hpp"
#include "scene/language/format_mark.hpp"
#include "scene/language/keys.hpp"
#include "scene/language/path_facts.hpp"
#include "scene/language/value_text.hpp"
#include "scene/schema/unit_functions.hpp"
#include "scene/schema/unit_source.hpp"
#include "scene/schema/unit_table.hpp"

namespace sarsim::scene::language {

namespace toml = core::toml;

namespace {

constexpr std::string_view type_key = "type";

bool begins_like(std::string_view word, std::string_view typed) {
  return word.size() >= typed.size() &&
         std::ranges::equal(word.substr(0, typed.size()), typed, {}, core::lower, core::lower);
}

bool is_inside(std::string_view path, std::string_view table) {
  if (table.empty()) return !path.empty();
  return path.size() > table.size() && path.starts_with(table) && path[table.size()] == '.';
}

// The next part of a path below a table.
std::string_view next_part(std::string_view path, std::string_view table) {
  path.remove_prefix(table.empty() ? 0 : table.size() + 1);
  return path.substr(0, path.find('.'));
}

// What the end of an expression that is being typed is.
struct ExpressionTail {
  std::size_t begin = 0;       // of the word
  bool behind_number = false;  // a unit may follow
  bool is_first = true;        // that number is the first of the expression
};

bool begins_unit(std::string_view text) {
  return std::ranges::any_of(every_quantity, [&](Quantity quantity) {
    return std::ranges::any_of(unit_table(quantity), [&](const Unit& unit) { return unit.name.starts_with(text); });
  });
}

// Length of the word at a place; behind a number also of a unit with a slash, which may be unfinished: "m/".
std::size_t word_length(std::string_view text, std::size_t at, bool behind_number) {
  const std::size_t length = word_at(text, at).size();
  if (!behind_number || length == 0 || toml::byte_at(text, at + length) != '/') return length;
  if (!begins_unit(text.substr(at, length + 1))) return length;
  return length + 1 + word_at(text, at + length + 1).size();
}

ExpressionTail tail_of(std::string_view typed) {
  ExpressionTail tail;
  std::size_t operands = 0;
  for (std::size_t at = 0; at < typed.size();) {
    const std::size_t number = begins_number(typed[at]) ? number_length(typed.substr(at)) : 0;
    const std::size_t word = word_length(typed, at, tail.behind_number);
    if (number > 0) {
      at += number;
      tail = {at, true, operands++ == 0};
    } else if (word > 0) {
      tail.begin = at;
      at += word;
      ++operands;
      if (at < typed.size()) tail = {at, false, false};
    } else {
      const bool is_blank = core::is_blank(typed[at++]);
      tail = {at, is_blank && tail.behind_number, tail.is_first};
    }
  }
  return tail;
}

// Makes the list for one place.
class Offers {
 public:
  Offers(Cursor cursor, const KnownNames& names)
      : cursor_(std::move(cursor)), names_(names), table_(plain_table(cursor_.kind)) {
    if (table_ != nullptr) paths_ = paths_of(*table_);
    enter_list();
  }

  Completions made(std::string_view text, std::size_t offset);

 private:
  void enter_list();
  void offer(std::string word, std::string shown, std::string inserted, std::string meaning);
  void keep_begun(bool whole_words);
  void say_whether_unasked(std::string_view text);

  void keys();
  void root_keys();
  void add_key(std::string_view key, const std::string& path);
  void headers(bool from_key);
  void values();
  void in_string(std::string_view text);
  void words(const PathFacts& facts);
  void names_of_kind(std::string_view kind);
  void expression(std::optional<Quantity> quantity);
  void add_units(Quantity quantity);

  [[nodiscard]] const PathFacts* facts_of(std::string_view path) const;
  [[nodiscard]] const PathFacts* facts_of_value() const;
  [[nodiscard]] bool is_said(std::string_view path) const;
  [[nodiscard]] std::string typed_type(std::string_view choice) const;
  [[nodiscard]] bool is_excluded(const PathFacts& facts) const;
  [[nodiscard]] std::string meaning_of(const std::string& path) const;
  [[nodiscard]] std::string table_of_type(const PathFacts& choice, const Choice& alternative) const;
  [[nodiscard]] std::optional<Quantity> quantity_here(const PathFacts& facts) const;
  [[nodiscard]] bool is_of_type() const { return cursor_.path.ends_with(".type"); }

  Cursor cursor_;
  const KnownNames& names_;
  const PlainTable* table_;
  std::vector<PathFacts> paths_;
  Completions result_;
  bool wanted_ = false;  // without a letter typed
};

// Within an entry of a list, its table takes the place of that of the object.
void Offers::enter_list() {
  if (cursor_.rows.empty()) return;
  const bool is_key = cursor_.site == Site::key;
  const std::string& around = is_key ? cursor_.table : cursor_.path;
  const auto list = std::ranges::find_if(paths_, [&](const PathFacts& facts) {
    const bool within = is_inside(around, facts.path) || (is_key && around == facts.path);
    return facts.spec().type == FieldType::list && within;
  });
  if (list == paths_.end()) return;
  const std::string path = list->path;
  const std::vector<std::size_t> entry{cursor_.rows.front()};
  const auto below = [&](const std::string& whole) {
    return is_inside(whole, path) ? whole.substr(path.size() + 1) : std::string();
  };
  std::erase_if(cursor_.said, [&](const KeyText& said) { return said.rows != entry || !is_inside(said.path, path); });
  for (KeyText& said : cursor_.said) said.path = below(said.path);
  cursor_.table = below(cursor_.table);
  cursor_.path = below(cursor_.path);
  cursor_.rows.erase(cursor_.rows.begin());
  table_ = &element_table(list->spec().list);
  paths_ = paths_of(*table_);
}

Completions Offers::made(std::string_view text, std::size_t offset) {
  result_.replaced = cursor_.word;
  result_.typed = cursor_.typed;
  switch (cursor_.site) {
    case Site::header: headers(false); break;
    case Site::key:
      keys();
      if (cursor_.alone) headers(true);
      break;
    case Site::value: values(); break;
    case Site::string: in_string(text); break;
    default: break;
  }
  keep_begun(cursor_.site == Site::key);
  if (cursor_.site == Site::header) result_.typed = text.substr(cursor_.word.begin, offset - cursor_.word.begin);
  say_whether_unasked(text);
  return std::move(result_);
}

void Offers::offer(std::string word, std::string shown, std::string inserted, std::string meaning) {
  result_.offered.push_back({std::move(word), std::move(shown), std::move(inserted), std::move(meaning)});
}

// Those that begin like what was typed; of keys also those with a later part that does ("error" in position_error).
void Offers::keep_begun(bool whole_words) {
  const std::string& typed = result_.typed;
  const auto rank = [&](const Completion& one) {
    if (begins_like(one.word, typed)) return 0;
    if (!whole_words || typed.size() < 2) return 2;
    for (std::size_t at = one.word.find('_'); at != std::string::npos; at = one.word.find('_', at + 1))
      if (begins_like(std::string_view(one.word).substr(at + 1), typed)) return 1;
    return 2;
  };
  std::erase_if(result_.offered, [&](const Completion& one) { return rank(one) == 2; });
  std::ranges::stable_sort(result_.offered, {}, rank);
}

void Offers::say_whether_unasked(std::string_view text) {
  const bool stands_there = std::ranges::any_of(
      result_.offered, [&](const Completion& one) { return one.inserted == toml::piece(text, result_.replaced); });
  result_.unasked = !stands_there && !result_.offered.empty() && (wanted_ || !result_.typed.empty());
}

// ---- keys and headers

const PathFacts* Offers::facts_of(std::string_view path) const {
  const auto found = std::ranges::find(paths_, path, &PathFacts::path);
  return found == paths_.end() ? nullptr : &*found;
}

bool Offers::is_said(std::string_view path) const {
  return std::ranges::any_of(cursor_.said, [&](const KeyText& said) { return said.path == path; });
}

// The type that the text gives to a choice; empty where it gives none, or one that there is not.
std::string Offers::typed_type(std::string_view choice) const {
  const PathFacts* const facts = facts_of(choice);
  if (facts == nullptr) return {};
  const std::string type_path = fmt::format("{}.{}", choice, type_key);
  std::string word;
  bool by_value = false;
  for (const KeyText& said : cursor_.said) {
    if (said.path == type_path || (said.path == choice && !said.word.empty())) word = said.word;
    by_value = by_value || said.path == choice;
  }
  const std::vector<Choice> known = alternatives(facts->spec());
  if (word.empty() || std::ranges::find(known, word, type_word) != known.end()) return word;
  return by_value && !facts->field().shorthand.empty() ? type_word(known.front()) : std::string();
}

// Another type was chosen.
bool Offers::is_excluded(const PathFacts& facts) const {
  return std::ranges::any_of(dependences(*table_, facts), [&](const Dependence& on) {
    const std::string type = typed_type(on.choice);
    return !type.empty() && std::ranges::find(on.words, type) == on.words.end();
  });
}

std::string Offers::meaning_of(const std::string& path) const {
  if (const PathFacts* const facts = facts_of(path)) {
    std::string meaning = first_sentence(meaning_text(*facts));
    return facts->role == PathRole::choice ? meaning : fmt::format("{}. {}", takes_text(*facts), meaning);
  }
  std::vector<std::string> parts;
  for (const PathFacts& facts : paths_) {
    if (!is_inside(facts.path, path)) continue;
    const std::string part(next_part(facts.path, path));
    if (std::ranges::find(parts, part) == parts.end()) parts.push_back(part);
  }
  return fmt::format("a table with {}", joined(parts, " and "));
}

void Offers::keys() {
  wanted_ = !cursor_.alone && cursor_.word.begin == cursor_.word.end;
  if (cursor_.kind.empty()) return root_keys();
  if (table_ == nullptr) return;
  const std::string& table = cursor_.table;
  const PathFacts* const choice = facts_of(table);
  const std::string type_path = fmt::format("{}.{}", table, type_key);
  if (choice != nullptr && choice->role == PathRole::choice && !is_said(type_path))
    offer(std::string(type_key), std::string(type_key), cursor_.complete ? "type" : "type = ", takes_text(*choice));
  for (const PathFacts& facts : paths_) {
    if (!is_inside(facts.path, table)) continue;
    const std::string_view key = next_part(facts.path, table);
    std::string path = table.empty() ? std::string(key) : fmt::format("{}.{}", table, key);
    if (!is_said(path) && !is_excluded(facts)) add_key(key, path);
  }
}

void Offers::root_keys() {
  for (const std::string_view word : {"format", "include"})
    if (cursor_.table.empty() && !is_said(word)) {
      const std::string inserted = cursor_.complete ? std::string(word) : fmt::format("{} = ", word);
      offer(std::string(word), std::string(word), inserted, first_sentence(explain(word).meaning));
    }
}

void Offers::add_key(std::string_view key, const std::string& path) {
  if (std::ranges::find(result_.offered, key, &Completion::word) != result_.offered.end()) return;
  const std::string inserted = cursor_.complete ? std::string(key) : fmt::format("{} = ", key);
  offer(std::string(key), std::string(key), inserted, meaning_of(path));
}

// Those of objects, and of the tables below the object around.
// @param from_key  no bracket was typed
void Offers::headers(bool from_key) {
  wanted_ = wanted_ || !from_key;
  const bool begins_own = !from_key && cursor_.complete && cursor_.path.find('.') == std::string::npos;
  std::vector<std::string> below;
  for (const PathFacts& facts : paths_) {
    if (from_key || begins_own || is_excluded(facts)) continue;
    for (std::size_t dot = facts.path.find('.'); dot != std::string::npos; dot = facts.path.find('.', dot + 1)) {
      std::string path = facts.path.substr(0, dot);
      if (is_said(path) || std::ranges::find(below, path) != below.end()) continue;
      below.push_back(std::move(path));
    }
  }
  for (const std::string& path : below) {
    const std::string name = fmt::format("{}.{}", cursor_.kind, path);
    const std::string line = fmt::format("[{}]", name);
    offer(name, line, line, meaning_of(path));
  }
  for (const PlainTable& table : plain_tables())
    offer(std::string(table.header), table.header_line(), table.header_line(), std::string(table.meaning));
  offer("let", "[let]", "[let]", first_sentence(explain("let").meaning));
}

// ---- values

// What the path of a value is about; of "pulse.type" the choice.
const PathFacts* Offers::facts_of_value() const {
  if (const PathFacts* const facts = facts_of(cursor_.path)) return facts;
  if (!is_of_type()) return nullptr;
  const PathFacts* const choice = facts_of(std::string_view(cursor_.path).substr(0, cursor_.path.size() - 5));
  return choice != nullptr && choice->role == PathRole::choice ? choice : nullptr;
}

// "{ type = "chirp", ... }" with what belongs to the type; empty where its word is enough.
std::string Offers::table_of_type(const PathFacts& choice, const Choice& alternative) const {
  const std::vector<PathFacts> fields = paths_of_alternative(*table_, choice, alternative);
  if (std::ranges::none_of(fields, [&](const PathFacts& facts) { return is_inside(facts.path, choice.path); }))
    return {};
  const std::string example = example_text(*table_, choice, alternative);
  const std::string head = choice.path.substr(choice.path.rfind('.') + 1) + " = ";
  const std::size_t at = example.find(head + "{");
  if (at == std::string::npos) return {};
  const std::size_t begin = at + head.size();
  return example.substr(begin, toml::bracket_end(example, begin) - begin);
}

void Offers::words(const PathFacts& facts) {
  const FieldSpec& spec = facts.spec();
  const auto quoted_word = [&](std::string word, std::string meaning) {
    std::string text = in_quotes(word);
    offer(word, word, cursor_.site == Site::string ? word : text, std::move(meaning));
  };
  if (facts.role == PathRole::interpolation) {
    for (const auto method : {core::Interpolation::linear, core::Interpolation::cubic, core::Interpolation::low_pass})
      quoted_word(std::string(interpolation_word(method)), meaning_text(facts));
  } else if (spec.type == FieldType::choice) {
    for (const Choice& one : alternatives(spec)) {
      const std::string word = type_word(one);
      std::string meaning(one.meaning.empty() ? one.shown : one.meaning);
      if (!has_words(spec)) {
        const std::string number = value_text(spec, one.value);
        offer(number, number, number, std::move(meaning));
        continue;
      }
      std::string table = cursor_.site == Site::string || is_of_type() ? std::string() : table_of_type(facts, one);
      if (table.empty())
        quoted_word(word, std::move(meaning));
      else
        offer(word, word, std::move(table), std::move(meaning));
    }
  } else if (spec.type == FieldType::flags && (cursor_.site == Site::string || !cursor_.rows.empty())) {
    for (const Flag& flag : spec.flags) quoted_word(std::string(flag.id), std::string(flag.label));
  } else if (spec.type == FieldType::check && cursor_.site == Site::value) {
    for (const char* const word : {"true", "false"}) offer(word, word, word, first_sentence(meaning_text(facts)));
  } else if (spec.type == FieldType::name) {
    names_of_kind(spec.refers);
  }
  wanted_ = !result_.offered.empty();
}

void Offers::names_of_kind(std::string_view kind) {
  const bool is_radar = kind == "radar";
  std::vector<std::string> names = is_radar ? names_.radars : names_.platforms;
  if (!is_radar && std::ranges::find(names, "Earth") == names.end()) names.insert(names.begin(), "Earth");
  for (const std::string& name : names) {
    const std::string text = in_quotes(name);
    offer(name, name, cursor_.site == Site::string ? text.substr(1, text.size() - 2) : text, std::string(kind));
  }
}

void Offers::values() {
  if (cursor_.kind.empty() && cursor_.path == "format") {
    wanted_ = true;
    return offer(std::string(format_2_mark), std::string(format_2_mark), in_quotes(format_2_mark), "this language");
  }
  const PathFacts* const facts = facts_of_value();
  if (facts == nullptr) return;
  words(*facts);
  const std::string initial = default_text(*facts);
  if (result_.offered.empty() && cursor_.rows.empty() && !initial.empty())
    offer(initial, initial, initial, "the default");
}

// What the number is that stands here.
std::optional<Quantity> Offers::quantity_here(const PathFacts& facts) const {
  if (facts.role == PathRole::points) {
    const FunctionBlock& block = *facts.spec().block;
    const bool is_x = !block.x_ignored && cursor_.rows.size() == 2 && cursor_.rows.back() == 0;
    return is_x ? quantity_of(block.x) : quantity_of(facts);
  }
  if (facts.role == PathRole::choice) {
    const PathFacts* const standing = is_of_type() ? nullptr : facts_of(facts.field().shorthand);
    return standing == nullptr ? std::nullopt : std::optional(quantity_of(*standing));
  }
  const bool is_number = facts.spec().type == FieldType::number || facts.spec().type == FieldType::vector;
  return facts.role == PathRole::value && is_number ? std::optional(quantity_of(facts)) : std::nullopt;
}

void Offers::in_string(std::string_view text) {
  if (cursor_.kind == "let") return expression(std::nullopt);
  if (cursor_.kind.empty() && cursor_.path == "format")
    offer(std::string(format_2_mark), std::string(format_2_mark), std::string(format_2_mark), "this language");
  const PathFacts* const facts = facts_of_value();
  if (facts == nullptr && result_.offered.empty()) return;
  if (facts != nullptr) words(*facts);
  // A quote that is missing may have swallowed what follows.
  const std::string_view inner = toml::piece(text, cursor_.word);
  if (!cursor_.complete || inner.find('=') != std::string_view::npos) {
    const std::size_t end = toml::skip(text, cursor_.word.begin + cursor_.typed.size(), toml::bare_byte);
    const bool is_closed = toml::byte_at(text, end) == text[cursor_.word.begin - 1];
    result_.replaced.end = static_cast<std::uint32_t>(end);
    if (!is_closed)
      for (Completion& one : result_.offered) one.inserted += text[cursor_.word.begin - 1];
  }
  keep_begun(false);
  if (!result_.offered.empty() && !result_.typed.empty()) return;
  if (facts != nullptr)
    if (const auto quantity = quantity_here(*facts)) expression(quantity);
}

// Units behind a number, names and functions elsewhere.
// @param quantity  of the whole expression; nothing: any
void Offers::expression(std::optional<Quantity> quantity) {
  const std::string typed = cursor_.typed;
  const ExpressionTail tail = tail_of(typed);
  const std::size_t offset = cursor_.word.begin + typed.size();
  result_.replaced = {cursor_.word.begin + static_cast<std::uint32_t>(tail.begin), static_cast<std::uint32_t>(offset)};
  result_.typed = typed.substr(tail.begin);
  wanted_ = wanted_ || (tail.behind_number && typed.ends_with(' '));
  if (tail.behind_number) {
    if (quantity) add_units(*quantity);
    if (!quantity || !tail.is_first)
      for (const Quantity other : every_quantity) add_units(other);
    return;
  }
  for (const LetText& let : names_.let)
    if (cursor_.kind != "let" || let.name != cursor_.path) offer(let.name, let.name, let.name, let.value);
  for (const Function& function : functions())
    offer(std::string(function.name), fmt::format("{}()", function.name), fmt::format("{}(", function.name),
          "function");
  for (const Constant& constant : constants())
    offer(std::string(constant.name), std::string(constant.name), std::string(constant.name),
          fmt::format("{:.9g}", constant.value));
}

void Offers::add_units(Quantity quantity) {
  for (const std::string_view unit : units_of(quantity))
    if (std::ranges::find(result_.offered, unit, &Completion::word) == result_.offered.end())
      offer(std::string(unit), std::string(unit), std::string(unit), std::string(noun_of(quantity)));
}

// The lines `name = value` below the header of [let].
void take_let(std::string_view text, std::vector<LetText>& names) {
  while (!text.empty()) {
    const std::string_view line = text.substr(0, toml::line_feed(text, 0));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    const std::size_t begin = toml::skip(line, 0, toml::blank_byte);
    if (toml::byte_at(line, begin) == '[') return;
    const std::size_t end = toml::key_end(line, begin);
    const std::size_t equals = toml::skip(line, end, toml::blank_byte);
    if (end == begin || toml::byte_at(line, equals) != '=') continue;
    const std::size_t value = toml::skip(line, equals + 1, toml::blank_byte);
    std::size_t value_end = std::min(line.find('#', value), line.size());
    if (toml::byte_at(line, value) == '"') value_end = std::max(toml::read_quotes(line, value, false).end, value);
    names.push_back({std::string(line.substr(begin, end - begin)),
                     std::string(core::trimmed(line.substr(value, value_end - value)))});
  }
}

}  // namespace

KnownNames known_names(const Scene& scene, std::string_view text) {
  KnownNames names;
  for (const Platform& platform : scene.platforms) names.platforms.push_back(platform.name);
  for (const Radar& radar : scene.radars) names.radars.push_back(radar.name);
  constexpr std::string_view header = "[let]";
  for (std::size_t at = text.find(header); at != std::string_view::npos; at = text.find(header, at + 1)) {
    const std::size_t line = text.substr(0, at).rfind('\n') + 1;  // npos + 1 is 0.
    if (core::trimmed(text.substr(line, at - line)).empty())
      take_let(text.substr(std::min(toml::line_feed(text, at) + 1, text.size())), names.let);
  }
  return names;
}

Completions completions_at(std::string_view text, std::size_t offset, const KnownNames& names) {
  return Offers(cursor_at(text, offset), names).made(text, offset);
}

}  // namespace sarsim::scene::language
