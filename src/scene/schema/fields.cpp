#include "scene/schema/fields.hpp"

#include <algorithm>
#include <stdexcept>

#include "scene/model/kinds.hpp"
#include "scene/schema/form.hpp"

namespace sarsim::scene {

namespace {

using namespace field_forms;

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

bool field_applies(const Scene& scene, ObjectId object, std::string_view id) {
  return visit_list(scene, object.kind, [&](const auto& objects) {
    const auto& one = objects.at(object.index);
    return form_of(one).applies(one, id);
  });
}

bool field_applies(const Scene& scene, ObjectKind kind, std::string_view id) {
  return visit_list(scene, kind, [&]<class Object>(const std::vector<Object>& objects) {
    return form_of(Object{}).applies(objects, id);
  });
}

bool field_applies(const Atmosphere& atmosphere, std::string_view id) {
  return form_of(atmosphere).applies(atmosphere, id);
}

bool field_applies(const World& world, std::string_view id) { return form_of(world).applies(world, id); }

std::string field_text(const AnyObject& object, std::string_view id) {
  return std::visit([&](const auto& alternative) { return form_of(alternative).text(alternative, id); }, object);
}

std::string field_text(const RunOptions& options, std::string_view id) { return form_of(options).text(options, id); }

std::string field_text(const Atmosphere& atmosphere, std::string_view id) {
  return form_of(atmosphere).text(atmosphere, id);
}

std::string field_text(const World& world, std::string_view id) { return form_of(world).text(world, id); }

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

std::string set_field(World& world, std::string_view id, std::string_view text, const LetNames* names) {
  return form_of(world).set(world, id, text, names);
}

void reset_field(AnyObject& object, std::string_view id) {
  std::visit([&](auto& alternative) { form_of(alternative).reset(alternative, id); }, object);
}

void reset_field(RunOptions& options, std::string_view id) { form_of(options).reset(options, id); }

void reset_field(Atmosphere& atmosphere, std::string_view id) { form_of(atmosphere).reset(atmosphere, id); }

void reset_field(World& world, std::string_view id) { form_of(world).reset(world, id); }

}  // namespace sarsim::scene
