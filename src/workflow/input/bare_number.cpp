#include "workflow/input/bare_number.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "scene/schema/field_spec.hpp"
#include "scene/schema/unit_table.hpp"

namespace sarsim::workflow {

namespace {

constexpr double absurd = 1e4;
constexpr double far = 30.0;

// How many times larger one is than the other, at least 1.
double ratio_of(double a, double b) {
  const double ratio = std::abs(a / b);
  return std::max(ratio, 1.0 / ratio);
}

bool is_suspicious(double given, double old, int script_shift) {
  const double ratio = ratio_of(given, old);
  if (ratio >= absurd) return true;
  return script_shift != 0 && ratio >= far && ratio_of(given * std::pow(10.0, script_shift), old) < far;
}

}  // namespace

std::optional<core::Problem> remark_on_bare_number(const scene::Scene& scene, const scene::NamedField& field,
                                                   const std::string& name, const std::string& value) {
  const scene::Quantity quantity = field.field->quantity;
  const auto units = scene::units_of(quantity);
  const auto usual = std::ranges::count_if(scene::unit_table(quantity), [](const scene::Unit& u) { return !u.yields; });
  if (usual < 2 || scene::number_length(value) != value.size()) return std::nullopt;
  std::string old_text = scene::named_field_text(scene, field);
  const std::optional<double> given = scene::read_quantity(value, quantity).value;
  const std::optional<double> old = scene::read_quantity(old_text, quantity).value;
  if (!given || !old || *given == 0.0 || *old == 0.0) return std::nullopt;
  if (!is_suspicious(*given, *old, scene::script_shift(*field.field->spec))) return std::nullopt;
  std::string written = old_text;
  std::erase(written, ' ');
  return core::warning("set.no-unit", fmt::format("--set {}: a number without a unit counts in {}",
                                                  name + "=" + value.substr(0, 40), units[0]))
      .found(scene::quantity_text(*given, quantity))
      .expected("a value near that of the script, " + old_text)
      .hint(fmt::format("Write the unit, as in {}={}.", name, written));
}

}  // namespace sarsim::workflow
