#pragma once

#include <optional>

#include "scene/check/check_findings.hpp"
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

/// Reports each number of an object that is wrong by itself.
template <class Object>
void check_values(Findings& findings, const Object& object) {
  for (const FieldOf<Object>& field : table_of<Object>().fields()) {
    if (field.spec.type != FieldType::number && field.spec.type != FieldType::vector) continue;
    if (auto fault = fault_of(field.spec, field.get(object), table_of<Object>().applies(object, field)))
      findings.error(field.spec.problem_place(), std::move(*fault));
  }
}

}  // namespace sarsim::scene
