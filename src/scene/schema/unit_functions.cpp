#include "scene/schema/unit_functions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/maths/constants.hpp"

namespace sarsim::scene {

namespace {

// Sine of an angle and a number of quarter turns; exact at multiples of 90 deg, and accurate for angles of many turns.
double sine_of(double angle_deg, int quarters) {
  int turned = 0;
  const double rest = std::remquo(angle_deg, 90.0, &turned) * core::rad_per_deg;
  switch ((turned + quarters) & 3) {
    case 0: return std::sin(rest);
    case 1: return std::cos(rest);
    case 2: return 0.0 - std::sin(rest);  // no negative zero
    default: return -std::cos(rest);
  }
}

double sine(double a, double) { return sine_of(a, 0); }
double cosine(double a, double) { return sine_of(a, 1); }
double tangent(double a, double) { return sine_of(a, 0) / sine_of(a, 1); }
double larger(double a, double b) { return std::max(a, b); }
double smaller(double a, double b) { return std::min(a, b); }

constexpr std::size_t any_number = std::numeric_limits<std::size_t>::max();

using Rule = Function::Rule;

constexpr Function table[] = {
    {"sqrt", Rule::root, 1, 1, [](double a, double) { return std::sqrt(a); }, nullptr, "an argument of 0 or more"},
    {"sin", Rule::of_angle, 1, 1, sine, [](double a) { return std::sin(a); }, ""},
    {"cos", Rule::of_angle, 1, 1, cosine, [](double a) { return std::cos(a); }, ""},
    {"tan", Rule::of_angle, 1, 1, tangent, [](double a) { return std::tan(a); }, "another angle than 90 or 270 deg"},
    {"asin", Rule::pure_to_angle, 1, 1, [](double a, double) { return std::asin(a) * core::deg_per_rad; }, nullptr,
     "an argument from -1 to 1"},
    {"acos", Rule::pure_to_angle, 1, 1, [](double a, double) { return std::acos(a) * core::deg_per_rad; }, nullptr,
     "an argument from -1 to 1"},
    {"atan", Rule::pure_to_angle, 1, 1, [](double a, double) { return std::atan(a) * core::deg_per_rad; }, nullptr, ""},
    {"atan2", Rule::to_angle, 2, 2, [](double a, double b) { return std::atan2(a, b) * core::deg_per_rad; }, nullptr,
     ""},
    {"abs", Rule::like, 1, 1, [](double a, double) { return std::abs(a); }, nullptr, ""},
    {"min", Rule::like, 2, any_number, smaller, nullptr, ""},
    {"max", Rule::like, 2, any_number, larger, nullptr, ""},
    {"log10", Rule::pure, 1, 1, [](double a, double) { return std::log10(a); }, nullptr, "an argument above 0"},
};

constexpr Constant values[] = {
    {"pi", core::pi, {}},
    {"c", core::exact_light_speed_mps, {{1, -1}}},
};

template <class Table>
auto named(const Table& entries, std::string_view name) -> decltype(std::begin(entries)) {
  const auto found = std::ranges::find_if(entries, [&](const auto& entry) { return entry.name == name; });
  return found == std::end(entries) ? nullptr : found;
}

}  // namespace

std::span<const Function> functions() { return table; }
std::span<const Constant> constants() { return values; }
const Function* function_named(std::string_view name) { return named(table, name); }
const Constant* constant_named(std::string_view name) { return named(values, name); }

}  // namespace sarsim::scene
