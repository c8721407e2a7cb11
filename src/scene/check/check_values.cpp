#include "scene/check/check_values.hpp"

#include <cmath>

#include <fmt/format.h>

#include "scene/model/limits.hpp"

namespace sarsim::scene {

namespace {

std::string_view noun_for(const FieldSpec& spec) { return spec.noun.empty() ? spec.words : spec.noun; }

std::string_view base_unit(Quantity quantity) {
  const auto units = units_of(quantity);
  return units.empty() ? std::string_view{} : units.front();
}

const Range& range_for(const FieldSpec& spec, bool applies) {
  if (!spec.usable) return spec.range;
  return applies ? *spec.usable : any_value;
}

Finding broken(core::RuleId id, std::string message, std::string found, std::string expected) {
  return {.id = id, .message = std::move(message), .found = std::move(found), .expected = std::move(expected)};
}

Finding outside(const FieldSpec& spec, const Range& range, double value) {
  const bool count = spec.quantity == Quantity::count;
  const std::string_view noun = noun_for(spec);
  const std::string_view unit = base_unit(spec.quantity);
  std::string found = count ? fmt::format("{:.0f}", value) : value_text(value, unit);
  const std::string low = value_text(range.low, "");
  if (std::isfinite(range.low) && std::isfinite(range.high)) {
    const std::string high = value_text(range.high, unit);
    return broken(
        "value.out-of-range", fmt::format("the {} is out of range", noun), std::move(found),
        range.low_excluded ? fmt::format("above {} and up to {}", low, high) : fmt::format("{} to {}", low, high));
  }
  if (!std::isfinite(range.low))
    return broken("value.out-of-range", fmt::format("the {} is out of range", noun), std::move(found),
                  fmt::format("up to {}", value_text(range.high, unit)));
  if (count && range.low == 1.0)
    return broken("value.below-one", fmt::format("the {} is below one", noun), std::move(found), "1 or more");
  if (range.low == 0.0 && !range.low_excluded)
    return broken("value.negative", fmt::format("the {} is negative", noun), std::move(found), "0 or a number above");
  if (value <= 0.0)
    return broken("value.not-above-zero", fmt::format("the {} is not above zero", noun), std::move(found),
                  "a number above 0");
  return broken("value.too-small", fmt::format("the {} is too small", noun), std::move(found),
                fmt::format("at least {}", value_text(range.low, unit)));
}

std::optional<Finding> fault_of_number(const FieldSpec& spec, double value, bool applies) {
  const Range& range = range_for(spec, applies);
  const bool numeric = computable(value);
  if (numeric && range.holds(value)) return std::nullopt;
  if (numeric) return outside(spec, range, value);
  const std::string_view noun = noun_for(spec);
  const std::string_view unit = base_unit(spec.quantity);
  if (std::isfinite(value)) return too_large(noun, value_text(value, unit), unit);
  return broken("value.not-finite", fmt::format("the {} is not a finite number", noun), value_text(value, unit),
                "a finite number");
}

std::string vector_text(const core::Vec3& v, std::string_view unit) {
  return fmt::format("({:.9g}, {:.9g}, {:.9g}) {}", v.x, v.y, v.z, unit);
}

std::optional<Finding> fault_of_vector(const FieldSpec& spec, const core::Vec3& value, bool applies) {
  const Range& range = range_for(spec, applies);
  const bool numeric = computable(value.x) && computable(value.y) && computable(value.z);
  const bool inside = range.holds(value.x) && range.holds(value.y) && range.holds(value.z);
  if (numeric && inside) return std::nullopt;
  const std::string_view noun = noun_for(spec);
  const std::string_view unit = base_unit(spec.quantity);
  std::string found = vector_text(value, unit);
  if (numeric)
    return broken("value.negative", fmt::format("the {} is negative", noun), std::move(found), "0 or numbers above");
  if (std::isfinite(value.x) && std::isfinite(value.y) && std::isfinite(value.z))
    return too_large(noun, std::move(found), unit);
  return broken("value.not-finite", fmt::format("the {} is not made of finite numbers", noun), std::move(found),
                "finite numbers");
}

}  // namespace

std::optional<Finding> fault_of(const FieldSpec& spec, const FieldValue& value, bool applies) {
  if (spec.type == FieldType::number) return fault_of_number(spec, std::get<double>(value), applies);
  if (spec.type == FieldType::vector) return fault_of_vector(spec, std::get<core::Vec3>(value), applies);
  return std::nullopt;
}

}  // namespace sarsim::scene
