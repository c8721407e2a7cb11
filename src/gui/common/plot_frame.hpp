#pragma once

#include <QImage>
#include <QPalette>
#include <QPointF>
#include <QRect>
#include <QString>

#include <vector>

#include "picture/colour/display_quantity.hpp"
#include "picture/figure/ticks.hpp"

class QFontMetrics;
class QPainter;
class QWidget;

namespace sarsim::gui {

/// What stands around the picture of a plot: axes and colour bar; and the cursors on it. Lengths are pixels of the
/// widget.

/// One axis: words with a mark each, and the title beyond them.
struct FrameAxis {
  /// A mark with its words.
  struct Mark {
    double px = 0.0;  ///< Across or down, in the widget.
    QString label;
  };
  QString title;
  std::vector<Mark> marks;
};

/// A widget's plot, with room at the left for an axis and at the right for a colour bar with numbers such as `widest`,
/// and so much above and below.
[[nodiscard]] QRect plot_within(const QWidget& widget, const QString& widest, int above, int below);
/// Room for an axis below or above a plot: its marks, and two lines of words.
[[nodiscard]] int room_of_axis(const QFontMetrics& metrics);
/// Half a line, for words that reach beyond the end of the axis at the side.
[[nodiscard]] int room_without_axis(const QFontMetrics& metrics);

/// The ground of a plot where there are no samples.
[[nodiscard]] QColor empty_ground(const QPalette& palette);

/// The line around a plot.
void draw_frame(QPainter& painter, const QRect& plot);
/// An axis along the lower or the upper edge of a plot.
/// @param widest  room for a label
void draw_axis_across(QPainter& painter, const QRect& plot, const FrameAxis& axis, double widest, bool above);
/// An axis along the left edge of a plot, its title turned upwards.
void draw_axis_upwards(QPainter& painter, const QRect& plot, const FrameAxis& axis);

/// What a colour bar shows.
struct FrameBar {
  QImage colours;  ///< One column, the highest value above.
  picture::DisplayQuantity quantity = picture::DisplayQuantity::magnitude;
  picture::ColourLimits limits;
  picture::Ticks ticks;  ///< Between the limits.
};
/// A colour bar at the right of a plot, its title at the widget's right edge.
void draw_colour_bar(QPainter& painter, const QRect& plot, int widget_width, const FrameBar& bar);

/// Cross hairs over a plot with their number, seen on any colour; the first are solid, others dashed.
/// @param index  0 for number 1
void draw_cursor(QPainter& painter, const QRect& plot, QPointF at, std::size_t index);

}  // namespace sarsim::gui
