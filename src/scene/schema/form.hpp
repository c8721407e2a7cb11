#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "scene/schema/field_form.hpp"
#include "scene/schema/field_table.hpp"

/// The form of a kind of object, made from its table. Internal to fields.cpp and list_fields.cpp.
namespace sarsim::scene::field_forms {

/// One field of a form, and what it is part of.
template <class Object>
struct FormField {
  const FieldOf<Object>* of;
  std::size_t part;
};

/// All fields of a form, and what can be done with each of them, by `Field::id`.
template <class Object>
class Form {
 public:
  Form() {
    for (const FieldOf<Object>& field : table_of<Object>().fields()) {
      const std::vector<Field> parts = form_fields(field.spec);
      for (std::size_t part = 0; part < parts.size(); ++part) parts_.push_back({&field, part});
      fields_.insert(fields_.end(), parts.begin(), parts.end());
    }
  }

  [[nodiscard]] const std::vector<Field>& fields() const { return fields_; }

  /// `field_applies`, to one object and to all of several.
  /// @{
  [[nodiscard]] bool applies(const Object& object, std::string_view id) const {
    return table_of<Object>().applies(object, *parts_[position(id)].of);
  }
  [[nodiscard]] bool applies(const std::vector<Object>& objects, std::string_view id) const {
    const FieldOf<Object>& field = *parts_[position(id)].of;
    return std::ranges::all_of(objects,
                               [&](const Object& object) { return table_of<Object>().applies(object, field); });
  }
  /// @}

  /// `field_text`.
  [[nodiscard]] std::string text(const Object& object, std::string_view id) const {
    const auto& [field, part] = parts_[position(id)];
    return form_text(field->spec, field->get(object), part);
  }

  /// `common_field_text`. Most have the same value, which is quicker to see than the same text.
  [[nodiscard]] std::optional<std::string> common_text(const std::vector<Object>& objects, std::string_view id) const {
    if (objects.empty()) return std::nullopt;
    const auto& [field, part] = parts_[position(id)];
    const FieldValue first = field->get(objects.front());
    std::string text = form_text(field->spec, first, part);
    for (const Object& object : objects)
      if (const FieldValue value = field->get(object);
          !same_part(field->spec, value, first, part) && form_text(field->spec, value, part) != text)
        return std::nullopt;
    return text;
  }

  /// `set_field`.
  [[nodiscard]] std::string set(Object& object, std::string_view id, std::string_view text,
                                const LetNames* names) const {
    const std::size_t at = position(id);
    const auto& [field, part] = parts_[at];
    const FieldValue before = field->get(object);
    FieldValue after = before;
    if (std::string failure = set_value(field->spec, after, part, text, names); !failure.empty()) return failure;
    if (form_text(field->spec, before, part) == form_text(field->spec, after, part)) return {};
    if (!table_of<Object>().applies(object, *field))
      return fields_[at].label + " does not apply with the present choices; change those first";
    if (fields_[at].kind != FieldKind::choice && fields_[at].kind != FieldKind::check) {
      field->put(object, after);
      return {};
    }
    // Other fields may lose their meaning with a choice, or get one.
    Object changed = object;
    field->put(changed, after);
    table_of<Object>().settle(object, changed);
    object = std::move(changed);
    return {};
  }

  /// `reset_field`.
  void reset(Object& object, std::string_view id) const {
    const auto& [field, part] = parts_[position(id)];
    Object changed = object;
    if (field->spec.type == FieldType::vector) {
      FieldValue value = field->get(object);
      FieldValue initial = field->get(Object{});
      component(std::get<core::Vec3>(value), part) = component(std::get<core::Vec3>(initial), part);
      field->put(changed, value);
    } else {
      field->reset(changed);
    }
    if (field->spec.type == FieldType::choice || field->spec.type == FieldType::check)
      table_of<Object>().settle(object, changed);
    object = std::move(changed);
  }

 private:
  [[nodiscard]] std::size_t position(std::string_view id) const {
    const auto found = std::ranges::find(fields_, id, &Field::id);
    if (found == fields_.end()) throw std::invalid_argument("there is no field '" + std::string(id) + "'");
    return static_cast<std::size_t>(found - fields_.begin());
  }

  std::vector<Field> fields_;
  std::vector<FormField<Object>> parts_;
};

/// The form of a kind of object, made at first use.
template <class Object>
const Form<Object>& form_of(const Object&) {
  static const Form<Object> made;
  return made;
}

}  // namespace sarsim::scene::field_forms
