#include "scene/edit/typed_fields.hpp"

#include <algorithm>

#include "core/text/letters.hpp"
#include "core/toml/values.hpp"
#include "scene/language/keys.hpp"
#include "scene/language/value_text.hpp"

namespace sarsim::scene {

namespace toml = core::toml;

namespace {

bool is_number_of_file(const Field& field) {
  return field.kind == FieldKind::quantity && field.spec->type != FieldType::seed;
}

std::optional<toml::Value> nth_element(std::string_view text, const toml::Value& array, std::size_t wanted) {
  toml::Elements elements(text, array);
  for (std::size_t i = 0; const auto element = elements.next(); ++i)
    if (i == wanted) return element->value;
  return std::nullopt;
}

bool is_type_word(const FieldSpec& choice, std::string_view word) {
  return std::ranges::any_of(choice.choices, [&](const Choice& one) { return type_word(one) == word; });
}

}  // namespace

bool has_default(const Field& field) { return field.kind != FieldKind::function && field.kind != FieldKind::text; }

std::string text_as_typed(const Field& field, std::string_view typed, const LetNames& names) {
  if (!is_number_of_file(field)) return {};
  const std::string_view text = core::trimmed(typed);
  const QuantityResult result = evaluate(text, field.quantity, names);
  const bool is_plain = result.literal && (result.bare || units_of(field.quantity).empty());
  return result.value && !is_plain ? language::in_quotes(text) : std::string();
}

namespace format_2 {

TypedObject::TypedObject(std::string_view text, const ObjectTables& tables, const ObjectTable& table,
                         std::optional<toml::Value> row)
    : text_(text), texts_(text, tables.document, table.first), row_(row) {
  static_cast<void>(texts_.next(object_));
}

std::optional<toml::Value> TypedObject::find(const AnyObject& object, const Field& field) {
  return std::visit([&](const auto& any) { return find_in(any, field); }, object);
}

std::optional<toml::Value> TypedObject::find(const RunOptions& options, const Field& field) {
  return find_in(options, field);
}

// The leaf of a field, of a choice that of its type, or the value that stands for a whole choice.
template <class Object>
const language::Leaf* TypedObject::leaf_of(const Object& object, const FieldOf<Object>& field) {
  const FieldTable<Object>& table = table_of<Object>();
  const FieldSpec& spec = field.spec;
  const std::string key(language::key_of(table, field, object));
  if (spec.type == FieldType::choice && has_words(spec)) {
    if (const language::Leaf* const type = object_.find(key + ".type")) return type;
    const language::Leaf* const word = object_.find(key);
    return word != nullptr && word->value.kind != toml::Kind::table ? word : nullptr;
  }
  if (const language::Leaf* const leaf = object_.find(key.substr(0, key.find('[')))) return leaf;
  for (const FieldOf<Object>& choice : table.fields()) {
    if (choice.spec.type != FieldType::choice || language::shorthand(table, choice) != &spec) continue;
    const language::Leaf* const leaf = object_.find(choice.spec.key);
    const bool is_value = leaf != nullptr && leaf->value.kind != toml::Kind::table &&
                          !is_type_word(choice.spec, toml::decoded_string(text_, leaf->value));
    return is_value ? leaf : nullptr;
  }
  return nullptr;
}

template <class Object>
std::optional<toml::Value> TypedObject::find_in(const Object& object, const Field& field) {
  const FieldTable<Object>& table = table_of<Object>();
  const auto of = std::ranges::find_if(table.fields(),
                                       [&](const FieldOf<Object>& candidate) { return &candidate.spec == field.spec; });
  if (of == table.fields().end()) return std::nullopt;
  std::optional<toml::Value> value;
  if (row_ && field.spec->key == "position")
    value = row_;
  else if (const language::Leaf* const leaf = leaf_of(object, *of))
    value = leaf->value;
  const std::string_view key = language::key_of(table, *of, object);
  const std::size_t bracket = key.find('[');
  if (value && bracket != std::string_view::npos)
    value = nth_element(text_, *value, static_cast<std::size_t>(key[bracket + 1] - '0'));
  if (value && field.spec->type == FieldType::vector) value = nth_element(text_, *value, field.part);
  return value;
}

TypedField TypedObject::typed_value(const Field& field, const std::optional<toml::Value>& value) const {
  TypedField typed{value.has_value()};
  if (!value || value->kind != toml::Kind::string || !is_number_of_file(field)) return typed;
  std::string text = toml::decoded_string(text_, *value);
  if (evaluate(text, field.quantity, {}).literal) return typed;
  std::ranges::replace(text, '\n', ' ');
  typed.expression = std::move(text);
  return typed;
}

}  // namespace format_2

}  // namespace sarsim::scene
