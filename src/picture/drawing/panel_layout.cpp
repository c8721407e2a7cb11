#include "picture/drawing/panel_layout.hpp"

#include <algorithm>
#include <cmath>

namespace sarsim::picture {

namespace {

// Pixels from mark to mark: labels beside each other, or lines below each other.
constexpr double across_px = 80.0;
constexpr double upwards_px = 36.0;

PlacedAxis placed_axis(const Canvas& canvas, const std::string& label, const std::string& unit, double first,
                       double last, double begin, double length, double spacing) {
  PlacedAxis axis{first, last, begin, length, axis_ticks(first, last, std::abs(length), spacing, unit), label, 0, 0, 0};
  if (!axis.ticks.unit.empty()) axis.title += " (" + axis.ticks.unit + ")";
  for (const Tick& tick : axis.ticks.ticks) axis.widest = std::max(axis.widest, Words(canvas, tick.label).width());
  axis.highest = Words(canvas, "0").height();
  if (!axis.title.empty()) axis.title_height = Words(canvas, axis.title).height();
  return axis;
}

std::optional<PlacedAxis> placed_twin(const Canvas& canvas, const FigureAxis& described, const PlacedAxis& axis,
                                      double spacing) {
  if (!described.twin) return std::nullopt;
  const FigureAxis::Twin& twin = *described.twin;
  return placed_axis(canvas, twin.label, twin.unit, axis.first * twin.factor, axis.last * twin.factor, axis.begin,
                     axis.length, spacing);
}

PlacedAxis placed_axis(const Canvas& canvas, const FigureAxis& axis, double begin, double length, double spacing) {
  PlacedAxis placed = placed_axis(canvas, axis.label, axis.unit, axis.first, axis.last, begin, length, spacing);
  if (!axis.clock_s) return placed;
  constexpr double longer = 1.4;  // than other labels
  placed.ticks = clock_ticks(axis.first, axis.last, std::abs(length), longer * spacing, *axis.clock_s);
  placed.title = axis.label;
  placed.widest = 0.0;
  for (const Tick& tick : placed.ticks.ticks)
    placed.widest = std::max(placed.widest, Words(canvas, tick.label).width());
  return placed;
}

// As much of an axis, about its middle.
FigureAxis showing(FigureAxis axis, double whole) {
  const double middle = 0.5 * (axis.first + axis.last);
  const double half = std::copysign(0.5 * whole, axis.last - axis.first);
  axis.first = middle - half;
  axis.last = middle + half;
  return axis;
}

// A circle on the ground is one in the picture: the axis that has room to spare shows more than the image.
void keep_scale(const FigurePanel& panel, const Area& area, FigureAxis& x, FigureAxis& y) {
  constexpr double longest_strip = 3.0;
  const bool image_of_ground = panel.image && x.unit == "m" && y.unit == "m";
  if (!image_of_ground && !(panel.y_per_x > 0.0)) return;
  const double y_per_x = image_of_ground ? 1.0 : panel.y_per_x;
  const double across = y_per_x * std::abs(x.last - x.first);  // in units of y, as the next
  const double up = std::abs(y.last - y.first);
  if (!(across > 0.0) || !(up > 0.0) || area.width < 2.0 || area.height < 2.0) return;
  if (std::max(across, up) > longest_strip * std::min(across, up)) return;
  const double per_px = std::max(across / area.width, up / area.height);
  x = showing(x, per_px * area.width / y_per_x);
  y = showing(y, per_px * area.height);
}

// The title of an axis beside its marks, and these.
double room_beside(const PlacedAxis& axis) {
  const double title = axis.title_height > 0.0 ? axis.title_height + gap_px : 0.0;
  return tick_px + gap_px + axis.widest + title;
}

double room_along(const PlacedAxis& axis) { return tick_px + gap_px + axis.highest + axis.title_height; }

}  // namespace

PlacedPanel placed(const Canvas& canvas, const FigurePanel& panel, const Area& area) {
  PlacedPanel out;
  out.area = {std::round(area.left), std::round(area.top), std::max(std::round(area.width), 1.0),
              std::max(std::round(area.height), 1.0)};
  FigureAxis x = panel.x;
  FigureAxis y = panel.y;
  keep_scale(panel, out.area, x, y);
  out.x = placed_axis(canvas, x, out.area.left, out.area.width, across_px);
  out.y = placed_axis(canvas, y, out.area.bottom(), -out.area.height, upwards_px);
  out.x_twin = placed_twin(canvas, x, out.x, across_px);
  out.y_twin = placed_twin(canvas, y, out.y, upwards_px);
  out.bar_left = out.area.right() + 2.0 * gap_px + (out.y_twin ? room_beside(*out.y_twin) : 0.0);
  if (panel.colour_bar) {
    const FigureColourBar& bar = *panel.colour_bar;
    out.bar =
        placed_axis(canvas, bar.label, bar.unit, bar.first, bar.last, out.area.bottom(), -out.area.height, upwards_px);
  }
  return out;
}

Margins margins_of(const PlacedPanel& panel) {
  Margins m;
  m.left = gap_px + room_beside(panel.y);
  m.right = panel.bar      ? panel.bar_left - panel.area.right() + bar_px + room_beside(*panel.bar)
            : panel.y_twin ? room_beside(*panel.y_twin)
                           : 0.0;
  // Half of a label may reach beyond the end of its axis.
  m.right = gap_px + std::max(m.right, 0.5 * panel.x.widest);
  m.above = 0.5 * gap_px + std::max(panel.x_twin ? room_along(*panel.x_twin) : 0.0, 0.5 * panel.y.highest);
  m.below = gap_px + room_along(panel.x);
  return m;
}

}  // namespace sarsim::picture
