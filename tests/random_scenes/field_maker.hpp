#pragma once

#include <cmath>
#include <functional>
#include <map>

#include "random_scenes/chance.hpp"
#include "scene/schema/field_table.hpp"

namespace sarsim::test {

/// How to draw the fields that have to fit the rest of a scene; without a function: not at all.
template <class Object>
using FieldDraws = std::map<const scene::FieldOf<Object>*, std::function<void(Object&)>>;

/// The field of a member, as a key of `FieldDraws`.
template <auto... Path>
[[nodiscard]] auto* field() {
  return &scene::field_of<Path...>();
}

/// Draws the value of a field from what its table says of it. Texts and functions stay, numbers without bounds often.
inline void draw_value(Chance& chance, const scene::FieldSpec& spec, scene::FieldValue& value) {
  const scene::Range& range = spec.range;
  const bool bounded = std::isfinite(range.low) && std::isfinite(range.high);
  const auto number = [&] { return range.low >= 0.0 ? chance.size(1e-3, 1e3) : chance.signed_size(1e-3, 1e3); };
  switch (spec.type) {
    case scene::FieldType::choice: {
      std::vector<scene::Choice> choices = spec.choices;
      std::erase_if(choices, [](const scene::Choice& choice) { return choice.since_2(); });
      return choose(value, choices[chance.below(choices.size())].value);
    }
    case scene::FieldType::check: value = chance.coin(); return;
    case scene::FieldType::seed: value = chance.bits(); return;
    case scene::FieldType::flags:
    case scene::FieldType::number:
      if (bounded && (spec.quantity == scene::Quantity::count || spec.type == scene::FieldType::flags))
        value = static_cast<double>(chance.integer(static_cast<int>(range.low), static_cast<int>(range.high)));
      else if (bounded)
        value = chance.between(range.low, range.high);
      else if (spec.quantity != scene::Quantity::count && chance.one_in(3))
        value = number();
      return;
    case scene::FieldType::vector:
      if (chance.one_in(3)) value = core::Vec3{number(), number(), number()};
      return;
    case scene::FieldType::text:
    case scene::FieldType::name:
    case scene::FieldType::list:
    case scene::FieldType::function: return;
  }
}

/// Draws the fields of an object that mean something, in the order of their table, so that what depends on a choice
/// comes behind it: those that are named as they say, all others from what the table says of them.
template <class Object>
[[nodiscard]] Object drawn(Chance& chance, Object object, const FieldDraws<Object>& draws) {
  const scene::FieldTable<Object>& table = scene::table_of<Object>();
  for (const scene::FieldOf<Object>& field : table.fields()) {
    if (!table.applies(object, field) || field.spec.since_2) continue;
    if (const auto own = draws.find(&field); own != draws.end()) {
      if (own->second) own->second(object);
      continue;
    }
    scene::FieldValue value = field.get(object);
    draw_value(chance, field.spec, value);
    field.put(object, value);
  }
  return object;
}

}  // namespace sarsim::test
