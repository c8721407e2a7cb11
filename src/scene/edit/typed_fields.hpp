#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "scene/edit/splice_tables.hpp"
#include "scene/schema/expression.hpp"
#include "scene/schema/field_table.hpp"
#include "scene/schema/fields.hpp"

/// What a text of format 2 says of the fields of a form, found through the table of fields.
namespace sarsim::scene {

/// What a text says of one field.
struct TypedField {
  bool said = true;             ///< False: the text does not speak of the field, which is then at its default.
  std::string expression = {};  ///< What stands there, where that is more than a number with a unit; else empty.
};

/// By `Field::id`, of those that have a default; empty where nothing is known of the object.
using TypedFields = std::map<std::string, TypedField, std::less<>>;

/// Whether a text may leave a field out. Names are always said, and functions have an editor of their own.
[[nodiscard]] bool has_default(const Field& field);

/// What is to stand in a text of format 2 for a number that was typed: an expression, or a number with a unit, in
/// quotes as it was typed. Empty where a number says as much, where a file would not take it, and for other kinds of
/// fields.
[[nodiscard]] std::string text_as_typed(const Field& field, std::string_view typed, const LetNames& names);

namespace format_2 {

/// The values of one object as they stand in a text, however they were written down.
class TypedObject {
 public:
  /// Text and tables must outlive it.
  /// @param row  the position of one target in a list
  TypedObject(std::string_view text, const ObjectTables& tables, const ObjectTable& table,
              std::optional<core::toml::Value> row = std::nullopt);

  /// The value of a field, or of the part of one that a form shows; nothing where the text does not say it.
  /// @param object  what the text says
  /// @{
  [[nodiscard]] std::optional<core::toml::Value> find(const AnyObject& object, const Field& field);
  [[nodiscard]] std::optional<core::toml::Value> find(const RunOptions& options, const Field& field);
  /// @}

  /// The same in words.
  template <class Object>
  [[nodiscard]] TypedField typed(const Object& object, const Field& field) {
    return typed_value(field, find(object, field));
  }

 private:
  template <class Object>
  [[nodiscard]] std::optional<core::toml::Value> find_in(const Object& object, const Field& field);
  template <class Object>
  [[nodiscard]] const language::Leaf* leaf_of(const Object& object, const FieldOf<Object>& field);
  [[nodiscard]] TypedField typed_value(const Field& field, const std::optional<core::toml::Value>& value) const;

  std::string_view text_;
  language::ObjectTexts texts_;  // holds the paths of the object
  language::ObjectText object_;
  std::optional<core::toml::Value> row_;
};

}  // namespace format_2

}  // namespace sarsim::scene
