#include "scene/language/object_text.hpp"

#include <algorithm>

#include "core/text/letters.hpp"
#include "core/toml/values.hpp"

namespace sarsim::scene::language {

namespace toml = core::toml;

namespace {

bool is_bare(std::string_view key) {
  return std::ranges::all_of(key,
                             [](char c) { return core::is_letter(c) || core::is_digit(c) || c == '_' || c == '-'; });
}

}  // namespace

Leaf* ObjectText::find(std::string_view path) {
  for (Leaf& leaf : leaves)
    if (leaf.path == path) return &leaf;
  return nullptr;
}

void ObjectText::use_all_below(std::string_view path) {
  for (Leaf& leaf : leaves)
    if (is_below(leaf.path, path)) leaf.used = true;
}

std::string_view ObjectTexts::kept(std::string path) { return paths_.emplace_back(std::move(path)); }

std::string_view ObjectTexts::joined(std::string_view prefix, toml::Span key) {
  const std::string_view typed = toml::piece(text_, key);
  if (prefix.empty() && is_bare(typed)) return typed;
  std::string path(prefix);
  if (is_bare(typed)) return kept(path.append(path.empty() ? "" : ".").append(typed));
  for (const std::string& part : toml::key_parts(text_, key)) path.append(path.empty() ? "" : ".").append(part);
  return kept(std::move(path));
}

void ObjectTexts::take_value(std::string_view path, toml::Span key, const toml::Value& value, ObjectText& object) {
  object.leaves.push_back({path, key, value});
  if (value.kind != toml::Kind::table) return;
  toml::Elements inner(text_, value);
  while (const auto element = inner.next())
    take_value(joined(path, element->key), element->key, element->value, object);
}

void ObjectTexts::take_entries(const toml::Table& table, std::string_view prefix, ObjectText& object) {
  for (std::size_t i = 0; i < table.entries; ++i) {
    const toml::Entry& entry = document_.entries[table.first_entry + i];
    take_value(joined(prefix, entry.key), entry.key, entry.value, object);
  }
}

ObjectText ObjectTexts::inner(const toml::Value& table) {
  ObjectText object;
  toml::Elements elements(text_, table);
  while (const auto element = elements.next())
    take_value(joined({}, element->key), element->key, element->value, object);
  return object;
}

bool ObjectTexts::next(ObjectText& object) {
  object.leaves.clear();
  paths_.clear();
  if (table_ == document_.tables.size()) return false;
  const toml::Table& first = document_.tables[table_++];
  object.header = first.header;
  object.is_element = first.element;
  toml::Span rest = first.name;
  const auto kind = toml::next_key_part(text_, rest);
  object.kind = !kind                                ? std::string_view()
                : is_bare(toml::piece(text_, *kind)) ? toml::piece(text_, *kind)
                                                     : kept(toml::decoded_key_part(text_, *kind));
  const auto path_below = [&](toml::Span name) {
    std::string path;
    const std::vector<std::string> parts = toml::key_parts(text_, name);
    for (std::size_t i = 1; i < parts.size(); ++i) path.append(path.empty() ? "" : ".").append(parts[i]);
    return path;
  };
  const auto take = [&](const toml::Table& table, const std::string& path) {
    if (path.empty()) return take_entries(table, {}, object);
    const std::string_view prefix = kept(path);
    object.leaves.push_back({prefix, table.header, {toml::Kind::table, table.header}, true});
    take_entries(table, prefix, object);
  };
  const bool is_root = first.name.begin == first.name.end;
  take(first, is_root ? std::string() : path_below(first.name));
  if (is_root) return true;
  // Tables below the object's own.
  for (; table_ < document_.tables.size(); ++table_) {
    const toml::Table& table = document_.tables[table_];
    if (table.name.end - table.name.begin <= object.kind.size()) break;
    const std::vector<std::string> parts = toml::key_parts(text_, table.name);
    if (parts.size() < 2 || parts.front() != object.kind) break;
    take(table, path_below(table.name));
  }
  return true;
}

}  // namespace sarsim::scene::language
