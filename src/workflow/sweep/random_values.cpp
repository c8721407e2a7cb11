#include "workflow/sweep/random_values.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/maths/random.hpp"
#include "core/maths/rounding.hpp"
#include "core/text/letters.hpp"
#include "core/text/number_text.hpp"
#include "core/text/separated.hpp"
#include "scene/schema/unit_table.hpp"

namespace sarsim::workflow {

namespace {

// A distribution of some parameters.
struct Law {
  std::string_view name;
  std::size_t parameters;
  const char* expected;
  double (*draw)(const std::array<double, 2>& parameters, const core::RandomStream& stream, std::int64_t number);
};

constexpr std::array<Law, 3> laws{
    {{"normal", 2, "normal(MEAN, STANDARD DEVIATION), as in normal(1, 0.2)",
      [](const std::array<double, 2>& p, const core::RandomStream& stream, std::int64_t number) {
        return p[0] + p[1] * stream.normals(number, 0)[0];
      }},
     {"uniform", 2, "uniform(LOWEST, HIGHEST), as in uniform(1, 2)",
      [](const std::array<double, 2>& p, const core::RandomStream& stream, std::int64_t number) {
        return p[0] + (p[1] - p[0]) * stream.uniforms(number, 0)[0];
      }},
     {"exponential", 1, "exponential(MEAN), as in exponential(2)",
      [](const std::array<double, 2>& p, const core::RandomStream& stream, std::int64_t number) {
        return -p[0] * std::log(stream.uniforms(number, 0)[0]);
      }}}};

const Law* law_of(std::string_view text) {
  const std::string_view name = core::trimmed(text.substr(0, std::min(text.find('('), text.size())));
  const auto law = std::ranges::find(laws, name, &Law::name);
  return text.find('(') == std::string_view::npos || law == laws.end() ? nullptr : &*law;
}

struct Parameter {
  std::string number;
  std::string unit;
};

// What stands between the parentheses; nothing where they do not close at the end.
std::vector<Parameter> parameters_of(std::string_view text) {
  std::vector<Parameter> parameters;
  const std::size_t open = text.find('(');
  if (text.empty() || text.back() != ')') return parameters;
  core::each_piece(text.substr(open + 1, text.size() - open - 2), ',', [&](std::string_view one) {
    const std::size_t length = scene::number_length(one);
    parameters.push_back({std::string(one.substr(0, length)), std::string(core::trimmed(one.substr(length)))});
  });
  for (Parameter& parameter : parameters)
    if (parameter.unit.empty()) parameter.unit = parameters.back().unit;
  return parameters;
}

// Numbers in the unit in which they are drawn.
struct Scale {
  std::array<double, 2> parameters{};
  std::string unit;
  std::string failure;
};

Scale scale_of(const std::vector<Parameter>& parameters, const scene::Field& field) {
  Scale scale;
  // A mean of whole numbers, or their deviation, may be a fraction.
  const scene::Quantity quantity = field.quantity == scene::Quantity::count ? scene::Quantity::number : field.quantity;
  const bool one_unit =
      std::ranges::all_of(parameters, [&](const Parameter& p) { return p.unit == parameters.front().unit; });
  if (one_unit) scale.unit = parameters.front().unit;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const scene::QuantityReading reading = scene::read_quantity(parameters[i].number + parameters[i].unit, quantity);
    if (!reading.value)
      scale.failure = reading.failure;
    else if (!one_unit && parameters[i].unit.starts_with("dB"))
      scale.failure = "decibels are mixed with another unit; write all numbers in one unit";
    else
      scale.parameters.at(i) = one_unit ? core::parse_number(parameters[i].number).value_or(NAN) : *reading.value;
  }
  return scale;
}

std::string mistake_in(const Law& law, const std::array<double, 2>& parameters) {
  if (law.name == "normal" && !(parameters[1] >= 0.0)) return "the standard deviation is negative";
  if (law.name == "uniform" && !(parameters[0] <= parameters[1])) return "the lowest value is above the highest";
  if (law.name == "exponential" && !(parameters[0] >= 0.0)) return "the mean of exponential() is negative";
  return {};
}

std::string text_of(double value, const Scale& scale, const scene::Field& field) {
  constexpr int digits = 9;
  if (field.quantity == scene::Quantity::count) return core::format_number(std::round(value)) + scale.unit;
  return core::format_number(core::tidy(value, digits)) + scale.unit;
}

}  // namespace

bool is_random(std::string_view text) { return law_of(core::trimmed(text)) != nullptr; }

scene::ValueList draw_values(std::string_view text, const scene::Field& field, std::size_t count, std::uint64_t seed,
                             std::string_view key) {
  text = core::trimmed(text);
  const Law& law = *law_of(text);
  if (field.kind != scene::FieldKind::quantity)
    return {{}, fmt::format("{} is not a number, and cannot be drawn", field.label)};
  const std::vector<Parameter> parameters = parameters_of(text);
  if (parameters.size() != law.parameters)
    return {{}, fmt::format("'{}' cannot be drawn; expected {}", core::clipped(text), law.expected)};
  const Scale scale = scale_of(parameters, field);
  if (!scale.failure.empty()) return {{}, scale.failure};
  if (const std::string mistake = mistake_in(law, scale.parameters); !mistake.empty()) return {{}, mistake};
  const core::RandomStream stream(seed, core::RandomKind::sweep_value, core::name_key(key));
  scene::ValueList list;
  for (std::size_t i = 0; i < count; ++i) {
    const double value = law.draw(scale.parameters, stream, static_cast<std::int64_t>(i));
    if (!std::isfinite(value)) return {{}, fmt::format("'{}' gives values that are too large", core::clipped(text))};
    list.texts.push_back(text_of(value, scale, field));
  }
  return list;
}

}  // namespace sarsim::workflow
