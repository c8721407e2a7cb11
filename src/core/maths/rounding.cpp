#include "core/maths/rounding.hpp"

#include <cmath>

#include <fmt/format.h>

#include "core/text/number_text.hpp"

namespace sarsim::core {

double tidy(double value, int digits) {
  if (!std::isfinite(value)) return value;
  return parse_number(fmt::format("{:.{}e}", value, digits - 1)).value_or(value) + 0.0;
}

double rounded_to(double value, double step) {
  constexpr int digits = 15;  // what a double surely holds
  if (!(step > 0.0) || !std::isfinite(value)) return value;
  const double multiple = std::round(value / step) * step;
  return std::isfinite(multiple) ? tidy(multiple, digits) : value;
}

Vec3 rounded_to(const Vec3& value, double step) {
  return {rounded_to(value.x, step), rounded_to(value.y, step), rounded_to(value.z, step)};
}

}  // namespace sarsim::core
