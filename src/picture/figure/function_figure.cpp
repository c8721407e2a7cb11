#include "picture/figure/function_figure.hpp"

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

#include "picture/figure/figure_axes.hpp"

namespace sarsim::picture {

namespace {

constexpr std::size_t intervals = 1000;
constexpr std::size_t max_crosses = 200;

struct Method {
  core::Interpolation interpolation;
  const char* name;
  Role role;
};
constexpr std::array<Method, 3> methods{{{core::Interpolation::linear, "linear", Role::curve},
                                         {core::Interpolation::cubic, "cubic splines", Role::curve_2},
                                         {core::Interpolation::low_pass, "low-pass filter", Role::curve_3}}};

bool constant(const core::SampledFunction& part) { return part.knots.size() < 2; }

// Where the points are, and an eighth of that on either side, so that what the curve does outside is seen.
std::pair<double, double> seen(const scene::FunctionInfo& info, const core::SampledFunction& part) {
  if (constant(part)) return {info.x_range[0], info.x_range[1]};
  const double first = part.knots.front().x;
  const double last = part.knots.back().x;
  const double more = 0.125 * (last - first);
  return {std::max(first - more, info.x_limits[0]), std::min(last + more, info.x_limits[1])};
}

// A function of a figure, with how it is completed.
struct Drawn {
  const core::SampledFunction& part;
  scene::FunctionRole role;
  const FunctionProfile& profile;
};

FigureCurve curve_of(const Drawn& drawn, const Method& method, std::pair<double, double> x) {
  core::SampledFunction function = drawn.part;
  function.method = method.interpolation;
  const auto value = scene::evaluated(drawn.role, function, drawn.profile.rules, drawn.profile.ends_by_role);
  FigureCurve curve{"", method.role, false, {}, {}};
  for (std::size_t i = 0; i <= intervals; ++i) {
    curve.x.push_back(x.first + (x.second - x.first) * static_cast<double>(i) / static_cast<double>(intervals));
    curve.y.push_back(value(curve.x.back()));
  }
  return curve;
}

const char* name_of(core::Interpolation interpolation) {
  return std::ranges::find(methods, interpolation, &Method::interpolation)->name;
}

void add_bars(FigurePanel& panel, const core::SampledFunction& part) {
  FigureCurve bars{"", Role::curve, true, {}, {}};
  for (std::size_t i = 0; i < part.knots.size(); ++i) {
    bars.x.push_back(static_cast<double>(i));
    bars.y.push_back(part.knots[i].y);
  }
  panel.x.first = -0.75;
  panel.x.last = static_cast<double>(std::max<std::size_t>(bars.x.size(), 1)) - 0.25;
  std::vector<double> values = bars.y;
  values.push_back(0.0);  // bars stand on it
  fit(panel.y, values);
  panel.curves.push_back(std::move(bars));
}

void add_curves(FigurePanel& panel, const scene::FunctionInfo& info, const Drawn& drawn, bool compare) {
  const core::SampledFunction& part = drawn.part;
  const auto x = seen(info, part);
  std::tie(panel.x.first, panel.x.last) = x;
  std::vector<double> values;
  for (const Method& method : methods) {
    if (!compare && method.interpolation != part.method) continue;
    FigureCurve curve = curve_of(drawn, method, x);
    curve.name = compare ? method.name : "";
    values.insert(values.end(), curve.y.begin(), curve.y.end());
    panel.curves.push_back(std::move(curve));
  }
  for (const core::Knot& knot : part.knots) {
    values.push_back(knot.y);
    if (part.knots.size() <= max_crosses) panel.marks.push_back({knot.x, knot.y, ""});
  }
  fit(panel.y, values);
}

}  // namespace

Figure function_figure(const scene::FunctionInfo& info, const scene::FunctionDraft& function,
                       const FunctionProfile& profile, bool compare) {
  Figure figure;
  figure.title = info.title;
  const bool all_constant = std::ranges::all_of(function.parts, constant);
  for (std::size_t i = 0; i < function.parts.size(); ++i) {
    const core::SampledFunction& part = function.parts[i];
    if (!info.per_pulse && constant(part) && !all_constant) continue;
    FigurePanel& panel = figure.panels.emplace_back();
    panel.x = {info.x_name, info.x_unit, 0.0, 1.0, {}};
    panel.y = {info.parts[i].name, info.parts[i].y_unit, 0.0, 1.0, {}};
    if (info.per_pulse) {
      add_bars(panel, part);
      continue;
    }
    add_curves(panel, info, {part, info.parts[i].role, profile}, compare);
    // Parts may differ in their interpolation.
    if (!constant(part)) panel.title = std::string("Chosen: ") + name_of(part.method);
  }
  return figure;
}

}  // namespace sarsim::picture
