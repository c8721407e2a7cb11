#include "scene/schema/fields.hpp"

#include <algorithm>
#include <stdexcept>

#include "scene/model/kinds.hpp"
#include "scene/schema/field_form.hpp"
#include "scene/schema/field_table.hpp"

namespace sarsim::scene {

namespace {

using namespace field_forms;

// One field of a form, and what it is part of.
template <class Object>
struct FormField {
  const FieldOf<Object>* of;
  std::size_t part;
};

// The form of a kind of object, made from its table.
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

  [[nodiscard]] bool applies(const Object& object, std::string_view id) const {
    return table_of<Object>().applies(object, *parts_[position(id)].of);
  }
  [[nodiscard]] std::string text(const Object& object, std::string_view id) const {
    const auto& [field, part] = parts_[position(id)];
    return form_text(field->spec, field->get(object), part);
  }

  [[nodiscard]] bool applies(const std::vector<Object>& objects, std::string_view id) const {
    const FieldOf<Object>& field = *parts_[position(id)].of;
    return std::ranges::all_of(objects,
                               [&](const Object& object) { return table_of<Object>().applies(object, field); });
  }
  // Most have the same value, which is quicker to see than the same text.
  [[nodiscard]] std::optional<std::string> common_text(const std::vector<Object>& objects, std::string_view id) const {
    if (objects.empty()) return std::nullopt;
    const auto& [field, part] = parts_[position(id)];
    const FieldValue first = field->get(objects.front());
    std::string text = form_text(field->spec, first, part);
    for (const Object& object : objects)
      if (const FieldValue value = field->get(object); value != first && form_text(field->spec, value, part) != text)
        return std::nullopt;
    return text;
  }

  // Says why not, and leaves the object as it is, where it cannot.
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

template <class Object>
const Form<Object>& form_of(const Object&) {
  static const Form<Object> made;
  return made;
}

std::string_view matching_field(const std::vector<Field>& fields, std::string_view name) {
  if (name.empty()) return {};
  std::string_view within;
  for (const Field& field : fields) {
    if (field.id == name) return field.id;
    const std::string_view id = field.id;
    if (name.starts_with(id) && name.substr(id.size()).starts_with('[')) within = id;  // an entry of a list
    if (!within.empty() || id.size() <= name.size() || !id.starts_with(name)) continue;
    if (id[name.size()] == '.' || id[name.size()] == '[') within = id;
  }
  return within;
}

}  // namespace

const std::vector<Field>& fields_of(ObjectKind kind) {
  const std::vector<Field>* fields = nullptr;
  for_each_kind([&]<class Object>(const Kind<Object>& known) {
    if (known.kind == kind) fields = &form_of(Object{}).fields();
  });
  if (fields == nullptr) throw std::out_of_range("no such kind of object");
  return *fields;
}

const std::vector<Field>& world_fields() { return form_of(World{}).fields(); }

const std::vector<Field>& atmosphere_fields() { return form_of(Atmosphere{}).fields(); }

const std::vector<Field>& option_fields() { return form_of(RunOptions{}).fields(); }

std::string_view field_of_problem(ObjectKind kind, std::string_view problem_field) {
  return matching_field(fields_of(kind), problem_field);
}

std::string_view option_field_of_problem(std::string_view problem_field) {
  return matching_field(option_fields(), problem_field);
}

bool field_applies(const AnyObject& object, std::string_view id) {
  return std::visit([&](const auto& alternative) { return form_of(alternative).applies(alternative, id); }, object);
}

bool field_applies(const Scene& scene, ObjectKind kind, std::string_view id) {
  return visit_list(scene, kind, [&]<class Object>(const std::vector<Object>& objects) {
    return form_of(Object{}).applies(objects, id);
  });
}

bool field_applies(const Atmosphere& atmosphere, std::string_view id) {
  return form_of(atmosphere).applies(atmosphere, id);
}

std::string field_text(const AnyObject& object, std::string_view id) {
  return std::visit([&](const auto& alternative) { return form_of(alternative).text(alternative, id); }, object);
}

std::string field_text(const RunOptions& options, std::string_view id) { return form_of(options).text(options, id); }

std::string field_text(const Atmosphere& atmosphere, std::string_view id) {
  return form_of(atmosphere).text(atmosphere, id);
}

std::optional<std::string> common_field_text(const Scene& scene, ObjectKind kind, std::string_view id) {
  return visit_list(scene, kind, [&]<class Object>(const std::vector<Object>& objects) {
    return form_of(Object{}).common_text(objects, id);
  });
}

std::string set_field(AnyObject& object, std::string_view id, std::string_view text, const LetNames* names) {
  return std::visit([&](auto& alternative) { return form_of(alternative).set(alternative, id, text, names); }, object);
}

std::string set_field(RunOptions& options, std::string_view id, std::string_view text, const LetNames* names) {
  return form_of(options).set(options, id, text, names);
}

std::string set_field(Atmosphere& atmosphere, std::string_view id, std::string_view text, const LetNames* names) {
  return form_of(atmosphere).set(atmosphere, id, text, names);
}

void reset_field(AnyObject& object, std::string_view id) {
  std::visit([&](auto& alternative) { form_of(alternative).reset(alternative, id); }, object);
}

void reset_field(RunOptions& options, std::string_view id) { form_of(options).reset(options, id); }

void reset_field(Atmosphere& atmosphere, std::string_view id) { form_of(atmosphere).reset(atmosphere, id); }

}  // namespace sarsim::scene
