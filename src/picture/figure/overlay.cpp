#include "picture/figure/overlay.hpp"

#include <algorithm>
#include <array>

#include "core/report/expect.hpp"

namespace sarsim::picture {

namespace {

constexpr std::array<Role, max_overlaid_curves> roles{Role::curve, Role::curve_2, Role::curve_3, Role::curve_4,
                                                      Role::curve_5};

bool same_quantity(const FigureAxis& a, const FigureAxis& b) { return a.label == b.label && a.unit == b.unit; }

bool can_be_laid_over(const FigurePanel& panel, const FigurePanel& first) {
  return !panel.image && std::ranges::none_of(panel.curves, &FigureCurve::bars) && same_quantity(panel.x, first.x) &&
         same_quantity(panel.y, first.y);
}

// An axis that runs the way of the first one, to the farther end of both.
void widen(FigureAxis& axis, const FigureAxis& other) {
  const auto [low, high] = std::minmax({axis.first, axis.last, other.first, other.last});
  const bool backwards = axis.last < axis.first;
  axis.first = backwards ? high : low;
  axis.last = backwards ? low : high;
}

void add_curves(FigurePanel& panel, const std::string& name, const std::vector<FigureCurve>& curves) {
  for (FigureCurve curve : curves) {
    curve.name = curve.name.empty() ? name : name + ", " + curve.name;
    if (panel.curves.size() < roles.size()) curve.role = roles[panel.curves.size()];
    panel.curves.push_back(std::move(curve));
  }
}

bool fits(const FigurePanel& panel) { return panel.curves.size() <= max_overlaid_curves; }

}  // namespace

std::optional<Figure> overlaid(std::span<const OverlaidFigure> figures) {
  CORE_EXPECT(!figures.empty());
  Figure together = figures.front().figure;
  together.note.clear();
  for (FigurePanel& panel : together.panels) {
    panel.curves.clear();
    panel.marks.clear();
  }
  for (const auto& [name, figure] : figures) {
    if (figure.panels.size() != together.panels.size()) return std::nullopt;
    for (std::size_t i = 0; i < together.panels.size(); ++i) {
      FigurePanel& panel = together.panels[i];
      const FigurePanel& added = figure.panels[i];
      if (!can_be_laid_over(added, panel)) return std::nullopt;
      widen(panel.x, added.x);
      widen(panel.y, added.y);
      if (panel.title != added.title) panel.title.clear();
      add_curves(panel, name, added.curves);
      panel.marks.insert(panel.marks.end(), added.marks.begin(), added.marks.end());
    }
    if (figure.title != together.title) together.title.clear();
  }
  if (!std::ranges::all_of(together.panels, fits)) return std::nullopt;
  return together;
}

}  // namespace sarsim::picture
