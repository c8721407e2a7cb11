#include "workflow/sweep/swept_field.hpp"

#include <optional>
#include <vector>

#include <fmt/format.h>

#include "core/text/letters.hpp"
#include "core/text/number_text.hpp"
#include "scene/schema/unit_dimension.hpp"

namespace sarsim::workflow {

namespace {

std::optional<scene::Quantity> quantity_of(const scene::Dimension& dimension) {
  for (int i = 0; i < static_cast<int>(scene::Quantity::count); ++i)  // The last is a pure number, as the first is.
    if (const auto quantity = static_cast<scene::Quantity>(i); scene::dimension_of(quantity) == dimension)
      return quantity;
  return std::nullopt;
}

SweptField field_of_let(const scene::LetNames& names, std::string_view name) {
  SweptField swept;
  const scene::Measured* const value = names.find(name);
  if (value == nullptr) {
    swept.named.failure = fmt::format("the scene has no name '{}' in [let]", core::clipped(name));
    if (const std::string near = core::nearest_word(name, names.all()); !near.empty())
      swept.named.failure += fmt::format("; did you mean '{}'?", near);
    return swept;
  }
  const auto quantity = quantity_of(value->dimension);
  scene::Field field;
  field.id = std::string(let_prefix) + std::string(name);
  field.label = name;
  field.kind = quantity ? scene::FieldKind::quantity : scene::FieldKind::text;
  field.quantity = quantity.value_or(scene::Quantity::number);
  swept.let = std::make_shared<const scene::Field>(std::move(field));
  swept.named.field = swept.let.get();
  return swept;
}

}  // namespace

SweptField find_swept_field(const NamedThings& things, std::string_view name, std::string_view value) {
  SweptField swept{scene::find_named_field(things.scene, name, value), nullptr};
  if (swept.named.field == nullptr && name.starts_with(let_prefix))
    return field_of_let(things.names, name.substr(let_prefix.size()));
  return swept;
}

}  // namespace sarsim::workflow
