#pragma once

#include <optional>
#include <string>

#include "picture/drawing/canvas.hpp"
#include "picture/figure/ticks.hpp"

namespace sarsim::picture {

/// An axis in its place: values from `first` to `last` along pixels from `begin` on, `length` of them; negative
/// upwards.
struct PlacedAxis {
  double first = 0.0;
  double last = 1.0;
  double begin = 0.0;
  double length = 1.0;
  Ticks ticks;
  std::string title;
  double widest = 0.0;        ///< Label of a mark, pixels.
  double highest = 0.0;       ///< The same.
  double title_height = 0.0;  ///< 0 without a title.

  /// Where a value stands.
  [[nodiscard]] double place(double value) const { return begin + (value - first) / (last - first) * length; }
};

/// A panel in its place.
struct PlacedPanel {
  Area area;  ///< Between the axes; whole pixels.
  PlacedAxis x, y;
  std::optional<PlacedAxis> x_twin, y_twin;  ///< Along the upper edge, and the right one.
  std::optional<PlacedAxis> bar;
  double bar_left = 0.0;
};

/// What stands around a panel's area.
struct Margins {
  double left = 0.0;
  double right = 0.0;
  double above = 0.0;
  double below = 0.0;
};

inline constexpr double tick_px = 4.0;
inline constexpr double gap_px = 6.0;
inline constexpr double bar_px = 14.0;

/// A panel with its area; marks suit the lengths of the axes.
[[nodiscard]] PlacedPanel placed(const Canvas& canvas, const FigurePanel& panel, const Area& area);
/// What the words about a panel need.
[[nodiscard]] Margins margins_of(const PlacedPanel& panel);

}  // namespace sarsim::picture
