#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scene/schema/field_table.hpp"
#include "scene/script/table_file.hpp"

/// What format 2 calls the fields of an object: all from the table of fields.
namespace sarsim::scene::language {

/// What format 2 calls a kind of object: the header of its tables.
[[nodiscard]] std::string_view header_of(ObjectKind kind);

/// The field whose value may stand for that of a choice: the only field with a unit that the first alternative has.
/// "carrier = '5.3 GHz'" is { type = "single", frequency = "5.3 GHz" }. Null where there is none.
template <class Object>
[[nodiscard]] const FieldSpec* shorthand(const FieldTable<Object>& table, const FieldOf<Object>& choice) {
  const auto& fields = table.fields();
  const std::string prefix = std::string(choice.spec.key) + ".";
  const int first = choice.spec.choices.front().value;
  const FieldSpec* found = nullptr;
  for (const FieldOf<Object>& field : fields) {
    if (!field.spec.key.starts_with(prefix)) continue;
    const Condition& when = field.spec.when;
    const bool belongs = when.among.empty() ||
                         (&fields[when.field] == &choice && std::ranges::find(when.among, first) != when.among.end());
    if (!belongs) continue;
    if (found != nullptr || (field.spec.type != FieldType::number && field.spec.type != FieldType::vector))
      return nullptr;
    found = &field.spec;
  }
  return found;
}

/// The path of a field below its object: another one where its choice is the alternative that has one of its own.
template <class Object>
[[nodiscard]] std::string_view key_of(const FieldTable<Object>& table, const FieldOf<Object>& field,
                                      const Object& object) {
  const OtherKey& other = field.spec.other_key;
  if (other.key.empty()) return field.spec.key;
  return table.fields()[field.spec.when.field].alternative(object) == other.alternative ? other.key : field.spec.key;
}

/// The name of one function of a block that holds several: "x", "azimuth", "i".
[[nodiscard]] std::string part_key(const FunctionBlock& block, std::size_t part);

/// What the values of a function are called: "points", or that of its list.
[[nodiscard]] std::string_view points_key(const FunctionBlock& block);

/// The word of a way to interpolate: "low-pass".
[[nodiscard]] std::string_view interpolation_word(core::Interpolation method);

}  // namespace sarsim::scene::language
