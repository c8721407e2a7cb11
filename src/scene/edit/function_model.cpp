#include "scene/edit/function_model.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "core/maths/interpolator.hpp"
#include "core/text/number_text.hpp"
#include "scene/schema/function_table.hpp"
#include "scene/script/data_file.hpp"

namespace sarsim::scene {

namespace {

using namespace function_tables;

std::string title_of(const FunctionKind& kind, const AnyObject& object) {
  std::string title(kind.title);
  std::string name;
  if (const auto* platform = std::get_if<Platform>(&object)) name = platform->name;
  if (const auto* radar = std::get_if<Radar>(&object)) name = radar->name;
  if (std::holds_alternative<Target>(object)) name = "a target";
  return name.empty() ? title : title + " of " + name;
}

// Hundredths of the decade: 10^(floor(log10(range)) - 2), as the exponent.
int rounding_exponent(double range) { return static_cast<int>(std::floor(std::log10(range))) - 2; }

bool usable_range(double range) { return std::isfinite(range) && range > 0.0; }

double step_of(const std::array<double, 2>& range) {
  const double width = std::abs(range[1] - range[0]);
  return usable_range(width) ? std::pow(10.0, rounding_exponent(width)) : 0.0;
}

// x of a moved knot: apart from its neighbours by a step, or halfway between them where there is no room.
double x_between_neighbours(const std::vector<core::Knot>& knots, std::size_t at, double x, const FunctionInfo& info) {
  double low = info.x_limits[0];
  double high = info.x_limits[1];
  const double step = step_of(info.x_range);
  const bool left = at > 0;
  const bool right = at + 1 < knots.size();
  // Where the neighbour is so large that a step vanishes in its digits, the next number is as near as can be.
  if (left) low = std::max(low, std::max(knots[at - 1].x + step, std::nextafter(knots[at - 1].x, HUGE_VAL)));
  if (right) high = std::min(high, std::min(knots[at + 1].x - step, std::nextafter(knots[at + 1].x, -HUGE_VAL)));
  if (low <= high) return std::clamp(x, low, high);
  if (left && right) {
    const double middle = std::midpoint(knots[at - 1].x, knots[at + 1].x);
    return middle > knots[at - 1].x && middle < knots[at + 1].x ? middle : knots[at].x;
  }
  return knots[at].x;
}

}  // namespace

FunctionInfo function_info(const AnyObject& object, std::string_view field) {
  const FunctionKind& kind = function_kind(object, field);
  FunctionInfo info;
  info.title = title_of(kind, object);
  for (std::size_t i = 0; i < kind.block.count; ++i)
    info.parts.push_back(
        {std::string(kind.part_names[i]), std::string(y_unit(kind, i)), kind.y_range, role_of(kind.block, i)});
  info.x_name = kind.x_name;
  info.x_unit = kind.block.x.unit;
  info.x_range = kind.x_range;
  info.x_limits = kind.x_limits;
  info.y_limits = kind.y_limits;
  info.per_pulse = kind.block.x_ignored;
  return info;
}

FunctionDraft function_of(const AnyObject& object, std::string_view field) {
  const ConstFunctionRef ref = function_in(object, field);
  return {{ref.parts.begin(), ref.parts.end()}, *ref.file};
}

void set_function(AnyObject& object, std::string_view field, const FunctionDraft& draft) {
  const FunctionRef ref = function_in(object, field);
  if (draft.parts.size() != ref.parts.size())
    throw std::invalid_argument("a function of " + std::to_string(ref.parts.size()) + " parts cannot be set from " +
                                std::to_string(draft.parts.size()));
  std::ranges::copy(draft.parts, ref.parts.begin());
  *ref.file = draft.file;
}

std::size_t insert_knot(core::SampledFunction& function, std::size_t at) {
  auto& knots = function.knots;
  if (knots.empty()) {
    knots.push_back({0.0, 0.0});
    return 0;
  }
  at = std::min(at, knots.size() - 1);
  core::Knot knot{knots[at].x + 1.0, knots[at].y};
  if (at + 1 < knots.size())
    knot = {std::midpoint(knots[at].x, knots[at + 1].x), std::midpoint(knots[at].y, knots[at + 1].y)};
  else if (!(knot.x > knots[at].x))  // a unit vanishes in the digits of a large x
    knot.x = std::nextafter(knots[at].x, HUGE_VAL);
  // Between two numbers that are next to each other there is no third.
  if (knot.x == knots[at].x || (at + 1 < knots.size() && knot.x == knots[at + 1].x)) return at;
  knots.insert(knots.begin() + static_cast<std::ptrdiff_t>(at) + 1, knot);
  return at + 1;
}

void remove_knot(core::SampledFunction& function, std::size_t at) {
  if (function.knots.size() < 2 || at >= function.knots.size()) return;
  function.knots.erase(function.knots.begin() + static_cast<std::ptrdiff_t>(at));
}

std::size_t move_knot(core::SampledFunction& function, std::size_t at, core::Knot to, const FunctionInfo& info) {
  auto& knots = function.knots;
  if (at >= knots.size() || std::isnan(to.x) || std::isnan(to.y)) return at;
  if (!info.per_pulse) knots[at].x = x_between_neighbours(knots, at, to.x, info);
  knots[at].y = std::clamp(to.y, info.y_limits[0], info.y_limits[1]);
  return at;
}

double rounded_to_range(double value, double range) {
  range = std::abs(range);
  if (!usable_range(range) || !std::isfinite(value)) return value;
  const int exponent = rounding_exponent(range);
  // Moved by decimal exponents as text, so that the result is the double nearest to the few digits it is meant to have.
  const auto steps = core::parse_number(core::format_number(value), -exponent);
  if (!steps || std::abs(*steps) > 0x1p53) return value;
  return core::parse_number(core::format_number(std::round(*steps)), exponent).value_or(value);
}

std::vector<core::Knot> curve_points(const core::SampledFunction& function, FunctionRole role,
                                     core::Interpolation method, double x0, double x1, std::size_t count) {
  core::SampledFunction sorted{method, function.knots};
  std::erase_if(sorted.knots, [](const core::Knot& knot) { return !std::isfinite(knot.x) || !std::isfinite(knot.y); });
  std::ranges::stable_sort(sorted.knots, {}, &core::Knot::x);
  const auto repeated = std::ranges::unique(sorted.knots, {}, &core::Knot::x);
  sorted.knots.erase(repeated.begin(), repeated.end());
  const std::function<double(double)> curve = evaluated(role, sorted, {});
  std::vector<core::Knot> points;
  points.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double part = count > 1 ? static_cast<double>(i) / static_cast<double>(count - 1) : 0.0;
    const double x = i + 1 == count && count > 1 ? x1 : x0 + part * (x1 - x0);
    points.push_back({x, curve(x)});
  }
  return points;
}

std::string function_file_text(const AnyObject& object, std::string_view field, const FunctionDraft& draft) {
  return write_data_file(draft.parts, function_kind(object, field).block);
}

FunctionReading read_function_file(const AnyObject& object, std::string_view field, DataFileReading data,
                                   const std::string& file_name) {
  FunctionReading reading{function_of(object, field), {}};
  reading.problems = std::move(data.problems);
  if (core::has_errors(reading.problems)) return reading;
  for (std::size_t i = 0; i < reading.draft.parts.size(); ++i)
    reading.draft.parts[i].knots = std::move(data.functions[i]);
  reading.draft.file = file_name;
  return reading;
}

}  // namespace sarsim::scene
