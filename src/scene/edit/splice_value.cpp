#include "scene/edit/splice_value.hpp"

#include <algorithm>

#include "core/toml/scan.hpp"
#include "core/toml/values.hpp"
#include "scene/edit/splice_places.hpp"

namespace sarsim::scene::format_2 {

namespace toml = core::toml;

namespace {

toml::Value whole_value(std::string_view text) {
  const toml::Kind kind = text.starts_with('{')   ? toml::Kind::table
                          : text.starts_with('[') ? toml::Kind::array
                                                  : toml::Kind::string;
  return {kind, toml::span_of(0, text.size())};
}

std::vector<toml::Element> elements_of(std::string_view text, const toml::Value& container) {
  std::vector<toml::Element> elements;
  toml::Elements rest(text, container);
  while (const auto element = rest.next()) elements.push_back(*element);
  return elements;
}

// An array with its elements.
struct ArrayParts {
  explicit ArrayParts(std::string_view array) : text(array), elements(elements_of(array, whole_value(array))) {}

  [[nodiscard]] std::size_t size() const { return elements.size(); }
  [[nodiscard]] toml::Span span(std::size_t i) const { return elements[i].value.span; }
  [[nodiscard]] std::string_view operator[](std::size_t i) const { return toml::piece(text, span(i)); }
  // What stands between the first two, where that may be copied.
  [[nodiscard]] std::string separator() const {
    if (size() < 2) return ", ";
    const std::string_view between = toml::piece(text, {span(0).end, span(1).begin});
    return between.find('#') == std::string_view::npos ? std::string(between) : ", ";
  }

  std::string_view text;
  std::vector<toml::Element> elements;
};

std::string array_after(std::string_view typed, std::string_view before, std::string_view after);
std::string table_after(std::string_view typed, const Said* before, const Said& after);

// What an inline table says that the writer has made: it has no dotted keys.
Said said_in(std::string_view text, std::string key = "") {
  Said said{std::move(key)};
  if (!text.starts_with('{')) {
    said.text = text;
    return said;
  }
  for (const toml::Element& element : elements_of(text, whole_value(text)))
    said.below.push_back(said_in(toml::piece(text, element.value.span), toml::key_parts(text, element.key).front()));
  return said;
}

std::string element_after(std::string_view typed, std::string_view before, std::string_view after) {
  if (before == after) return std::string(typed);
  const auto all_begin_with = [&](char c) {
    return typed.starts_with(c) && before.starts_with(c) && after.starts_with(c);
  };
  if (all_begin_with('[')) return array_after(typed, before, after);
  if (!all_begin_with('{')) return std::string(after);
  const Said was = said_in(before);
  return table_after(typed, &was, said_in(after));
}

// As many elements as before.
std::string same_count_after(const ArrayParts& typed, const ArrayParts& before, const ArrayParts& after) {
  std::string text;
  std::size_t at = 0;
  for (std::size_t i = 0; i < typed.size(); ++i) {
    text += typed.text.substr(at, typed.span(i).begin - at);
    text += element_after(typed[i], before[i], after[i]);
    at = typed.span(i).end;
  }
  return text.append(typed.text.substr(at));
}

// The elements that differ stand between `first` equal ones and `last` equal ones.
std::string other_count_after(const ArrayParts& typed, const ArrayParts& after, std::size_t first, std::size_t last) {
  const std::string separator = typed.separator();
  std::string middle;
  for (std::size_t i = first; i + last < after.size(); ++i)
    middle += (middle.empty() ? "" : separator) + std::string(after[i]);
  const std::size_t behind = typed.size() - last;  // of those that go
  std::size_t begin = 0;
  std::size_t end = 0;
  if (first < behind) {
    begin = typed.span(first).begin;
    end = typed.span(behind - 1).end;
    if (middle.empty()) first > 0 ? begin = typed.span(first - 1).end : end = typed.span(behind).begin;
  } else if (first > 0) {
    begin = end = typed.span(first - 1).end;
    middle.insert(0, separator);
  } else {
    begin = end = typed.span(0).begin;
    middle += separator;
  }
  return std::string(typed.text).replace(begin, end - begin, middle);
}

std::string array_after(std::string_view typed_text, std::string_view before_text, std::string_view after_text) {
  const ArrayParts typed(typed_text);
  const ArrayParts before(before_text);
  const ArrayParts after(after_text);
  if (typed.size() != before.size() || typed.size() == 0) return std::string(after_text);
  if (before.size() == after.size()) return same_count_after(typed, before, after);
  const std::size_t shorter = std::min(before.size(), after.size());
  std::size_t first = 0;
  while (first < shorter && before[first] == after[first]) ++first;
  std::size_t last = 0;
  while (last < shorter - first && before[before.size() - 1 - last] == after[after.size() - 1 - last]) ++last;
  if (first + last == 0) return std::string(after_text);
  return other_count_after(typed, after, first, last);
}

// One item of an inline table: as it was typed, changed, or gone.
struct TypedItem {
  toml::Span at;
  std::optional<std::string> text;
};

// Nothing where the keys cannot be told apart.
std::optional<std::vector<TypedItem>> items_after(std::string_view typed, const Said* before, const Said& after) {
  static const std::vector<Said> nothing;
  const std::vector<Said>& said = before == nullptr ? nothing : before->below;
  std::vector<TypedItem> items;
  for (const toml::Element& element : elements_of(typed, whole_value(typed))) {
    const std::vector<std::string> parts = toml::key_parts(typed, element.key);
    const std::string_view value = toml::piece(typed, element.value.span);
    const Said* const was = find_typed(said, parts.front());
    const Said* const becomes = find_typed(after.below, parts.front());
    const toml::Span at{element.key.begin, element.value.span.end};
    const bool stays = says_same(was, becomes);
    if (!stays && parts.size() > 1) return std::nullopt;
    if (parts.front() == "type" && !is_type_of(value, before)) return std::nullopt;
    if (stays)
      items.push_back({at, std::string(toml::piece(typed, at))});
    else if (becomes == nullptr)
      items.push_back({at, std::nullopt});
    else
      items.push_back({at, std::string(toml::piece(typed, {at.begin, element.value.span.begin})) +
                               value_after(value, was, *becomes)});
  }
  return items;
}

std::string table_after(std::string_view typed, const Said* before, const Said& after) {
  const auto items = items_after(typed, before, after);
  if (!items || items->empty()) return inline_text(after);
  std::string text;
  const TypedItem* last = nullptr;
  for (std::size_t i = 0; i < items->size(); ++i) {
    const TypedItem& item = (*items)[i];
    if (!item.text) continue;
    if (last != nullptr)
      text += last + 1 == &item ? std::string(toml::piece(typed, {last->at.end, item.at.begin})) : ", ";
    text += *item.text;
    last = &item;
  }
  for (const Said& key : after.below) {
    const bool is_typed = std::ranges::any_of(*items, [&](const TypedItem& item) {
      const toml::Span key_span{item.at.begin, static_cast<std::uint32_t>(toml::key_end(typed, item.at.begin))};
      return toml::key_parts(typed, key_span).front() == key.key;
    });
    const Said* const was = before == nullptr ? nullptr : find_typed(before->below, key.key);
    if (is_typed || says_same(was, &key)) continue;
    text += (text.empty() ? "" : ", ") + key.key + " = " + inline_text(key);
  }
  const std::string_view head = typed.substr(0, items->front().at.begin);
  return std::string(head) + text + std::string(typed.substr(items->back().at.end));
}

// The position of what follows blanks, line ends and comments.
std::size_t behind_space(std::string_view text, std::size_t at) {
  for (;; at = toml::line_feed(text, at)) {
    at = std::min(text.find_first_not_of(" \t\r\n", at), text.size());
    if (toml::byte_at(text, at) != '#') return at;
  }
}

// Only blanks, perhaps a comment, between a byte and the end of its line.
bool nothing_follows(std::string_view text, std::size_t at) {
  at = toml::skip(text, at, toml::blank_byte);
  return at >= text.size() || text[at] == '#' || text[at] == '\n' || text[at] == '\r';
}

void cut(TextChanges& changes, std::string_view text, std::size_t begin, std::size_t end) {
  if (begin < end) changes.push_back({begin, std::string(text.substr(begin, end - begin)), ""});
}

// The begin of the comment lines directly above a line.
std::size_t comments_above(std::string_view text, std::size_t begin) {
  while (begin > 0) {
    const std::size_t above = line_begin(text, begin - (begin > 1 && text[begin - 2] == '\r' ? 2 : 1));
    if (toml::byte_at(text, toml::skip(text, above, toml::blank_byte)) != '#') break;
    begin = above;
  }
  return begin;
}

// Rows, their commas included, and what is said of them alone.
void cut_rows(TextChanges& changes, std::string_view text, std::size_t begin, std::size_t end) {
  if (is_first_on_line(text, begin) && nothing_follows(text, end)) {
    begin = comments_above(text, line_begin(text, begin));
    end = behind_line(text, end);
  } else {
    end = toml::skip(text, end, toml::blank_byte);
  }
  cut(changes, text, begin, end);
}

// The last rows, behind which there is no comma: that of the row before goes.
void cut_last_rows(TextChanges& changes, std::string_view text, toml::Span rows, std::size_t comma) {
  const std::string_view between = text.substr(comma, rows.begin - comma);
  if (between.find('#') != std::string_view::npos) {
    cut(changes, text, comma, comma + 1);
    return cut_rows(changes, text, rows.begin, rows.end);
  }
  std::size_t end = rows.end;
  if (nothing_follows(text, end)) end = std::min(text.find_first_of("\r\n", end), text.size());
  cut(changes, text, comma, end);
}

}  // namespace

const Said* find_typed(const std::vector<Said>& said, std::string_view key) {
  const auto found = std::ranges::find(said, key, &Said::key);
  return found == said.end() ? nullptr : &*found;
}

bool says_same(const Said* a, const Said* b) {
  if (a == nullptr || b == nullptr) return a == b;
  return inline_text(*a) == inline_text(*b);
}

bool is_type_of(std::string_view typed, const Said* before) {
  const Said* const type = before == nullptr ? nullptr : find_typed(before->below, "type");
  if (type == nullptr || !typed.starts_with('"')) return true;
  return toml::decoded_string(typed, whole_value(typed)) == toml::decoded_string(type->text, whole_value(type->text));
}

std::string value_after(std::string_view typed, const Said* before, const Said& after) {
  if (typed.starts_with('{') && !after.below.empty()) return table_after(typed, before, after);
  const bool is_array = typed.starts_with('[') && after.text.starts_with('[');
  if (is_array && before != nullptr && before->text.starts_with('['))
    return array_after(typed, before->text, after.text);
  return inline_text(after);
}

TextChanges change_rows(std::string_view text, const toml::Value& array, const std::vector<RowChange>& rows) {
  const std::vector<toml::Element> elements = elements_of(text, array);
  TextChanges changes;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const toml::Span row = elements[i].value.span;
    if (!rows[i].removed) {
      if (rows[i].text) replace_stretch(changes, text, row, *rows[i].text);
      continue;
    }
    std::size_t behind = i + 1;
    while (behind < rows.size() && rows[behind].removed) ++behind;
    const std::uint32_t end = elements[behind - 1].value.span.end;
    const std::size_t comma = behind_space(text, end);
    if (toml::byte_at(text, comma) == ',')
      cut_rows(changes, text, row.begin, comma + 1);
    else if (i > 0)
      cut_last_rows(changes, text, {row.begin, end}, behind_space(text, elements[i - 1].value.span.end));
    i = behind - 1;
  }
  return changes;
}

void replace_stretch(TextChanges& changes, std::string_view text, toml::Span at, std::string_view with) {
  const std::string_view old = toml::piece(text, at);
  if (old == with) return;
  const std::size_t shorter = std::min(old.size(), with.size());
  std::size_t front = 0;
  while (front < shorter && old[front] == with[front]) ++front;
  std::size_t back = 0;
  while (back < shorter - front && old[old.size() - 1 - back] == with[with.size() - 1 - back]) ++back;
  changes.push_back({at.begin + front, std::string(old.substr(front, old.size() - front - back)),
                     std::string(with.substr(front, with.size() - front - back))});
}

}  // namespace sarsim::scene::format_2
