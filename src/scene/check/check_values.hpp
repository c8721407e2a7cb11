#pragma once

#include <optional>

#include "scene/check/check_findings.hpp"
#include "scene/model/limits.hpp"
#include "scene/schema/field_table.hpp"

namespace sarsim::scene {

/// What is wrong with the value of a field by itself: it is not a number, too large to compute with, or outside what
/// can be simulated. Nothing where it is right, or no number.
/// @param applies  whether the field means something in its object
[[nodiscard]] std::optional<Finding> fault_of(const FieldSpec& spec, const FieldValue& value, bool applies);

/// Whether the number of a field is right by itself.
template <auto... Path>
[[nodiscard]] bool is_sound(const auto& object) {
  const auto& field = field_of<Path...>();
  const bool applies = table_of<std::remove_cvref_t<decltype(object)>>().applies(object, field);
  return !fault_of(field.spec, field.get(object), applies);
}

/// Whether a plain number or vector is right whether or not its field applies; false where more has to be asked.
template <class Object>
[[nodiscard]] bool is_plainly_sound(const FieldOf<Object>& field, const Object& object) {
  if (field.spec.usable) return false;
  const auto sound = [&](double value) { return computable(value) && field.spec.range.holds(value); };
  if (field.number != nullptr) return sound(field.number(object));
  if (field.vector == nullptr) return false;
  const core::Vec3& value = field.vector(object);
  return sound(value.x) && sound(value.y) && sound(value.z);
}

/// Reports each number of an object that is wrong by itself.
template <class Object>
void check_values(Findings& findings, const Object& object) {
  const FieldTable<Object>& table = table_of<Object>();
  for (const FieldOf<Object>& field : table.fields()) {
    if (field.spec.type != FieldType::number && field.spec.type != FieldType::vector) continue;
    if (is_plainly_sound(field, object)) continue;
    // Only ranges of use depend on whether the field applies.
    const bool applies = !field.spec.usable || table.applies(object, field);
    if (auto fault = fault_of(field.spec, field.get(object), applies))
      findings.error(field.spec.problem_place(), std::move(*fault));
  }
}

}  // namespace sarsim::scene
