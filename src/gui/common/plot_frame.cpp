#include "gui/common/plot_frame.hpp"

#include <QFontMetrics>
#include <QPainter>
#include <QWidget>

#include <algorithm>
#include <utility>

#include "gui/common/palette_colours.hpp"

namespace sarsim::gui {

namespace {

constexpr int bar_width = 14;
constexpr int tick_length = 4;
constexpr int gap = 6;

// Words along a plot's side, read from below where `degrees` is -90, from above where it is 90.
void draw_turned(QPainter& painter, const QRect& plot, double x, double degrees, const QString& words) {
  painter.save();
  painter.translate(x, plot.center().y());
  painter.rotate(degrees);
  painter.drawText(QRect(-plot.height() / 2, 0, plot.height(), painter.fontMetrics().height()), Qt::AlignCenter, words);
  painter.restore();
}

}  // namespace

int room_of_axis(const QFontMetrics& metrics) { return 2 * metrics.height() + gap + tick_length; }

int room_without_axis(const QFontMetrics& metrics) { return metrics.height() / 2 + gap; }

QRect plot_within(const QWidget& widget, const QString& widest, int above, int below) {
  const QFontMetrics metrics = widget.fontMetrics();
  const int words = metrics.horizontalAdvance(widest) + metrics.height() + tick_length;
  const int left = words + 2 * gap;
  const int right = words + bar_width + 3 * gap;
  return QRect(left, above, std::max(widget.width() - left - right, 1), std::max(widget.height() - above - below, 1));
}

QColor empty_ground(const QPalette& palette) { return is_dark(palette) ? QColor(38, 40, 44) : QColor(214, 216, 220); }

void draw_frame(QPainter& painter, const QRect& plot) { painter.drawRect(plot.adjusted(0, 0, -1, -1)); }

void draw_axis_across(QPainter& painter, const QRect& plot, const FrameAxis& axis, double widest, bool above) {
  const int line = painter.fontMetrics().height();
  const int edge = above ? plot.top() : plot.bottom() + 1;
  const int step = above ? -tick_length : tick_length;
  for (const FrameAxis::Mark& mark : axis.marks) {
    painter.drawLine(QPointF(mark.px, edge), QPointF(mark.px, edge + step));
    const QRectF words(mark.px - widest, above ? edge + step - line : edge + step, 2.0 * widest, line);
    painter.drawText(words, Qt::AlignCenter, mark.label);
  }
  const int title = above ? edge + step - 2 * line : edge + step + line;
  painter.drawText(QRect(plot.left(), title, plot.width(), line), Qt::AlignCenter | Qt::TextDontClip, axis.title);
}

void draw_axis_upwards(QPainter& painter, const QRect& plot, const FrameAxis& axis) {
  const int line = painter.fontMetrics().height();
  for (const FrameAxis::Mark& mark : axis.marks) {
    painter.drawLine(QPointF(plot.left() - tick_length, mark.px), QPointF(plot.left(), mark.px));
    const QRectF words(0.0, mark.px - line, plot.left() - tick_length - gap / 2.0, 2.0 * line);
    painter.drawText(words, Qt::AlignRight | Qt::AlignVCenter, mark.label);
  }
  double widest = 0.0;
  for (const FrameAxis::Mark& mark : axis.marks)
    widest = std::max<double>(widest, painter.fontMetrics().horizontalAdvance(mark.label));
  const double x = plot.left() - tick_length - widest - 1.5 * gap - line;
  draw_turned(painter, plot, std::max(x, gap / 2.0), -90.0, axis.title);
}

void draw_colour_bar(QPainter& painter, const QRect& plot, int widget_width, const FrameBar& bar) {
  const QRect strip(plot.right() + 2 * gap, plot.top(), bar_width, plot.height());
  painter.drawImage(strip, bar.colours);
  draw_frame(painter, strip);
  const int line = painter.fontMetrics().height();
  for (const picture::Tick& tick : bar.ticks.ticks) {
    const double share = (tick.value - bar.limits.low) / (bar.limits.high - bar.limits.low);
    const double y = strip.bottom() + 1 - share * strip.height();
    painter.drawLine(QPointF(strip.right() + 1, y), QPointF(strip.right() + 1 + tick_length, y));
    const QRectF words(strip.right() + tick_length + gap / 2.0 + 1, y - line, widget_width, 2.0 * line);
    painter.drawText(words, Qt::AlignLeft | Qt::AlignVCenter, QString::fromStdString(tick.label));
  }
  const std::string_view title = picture::axis_title_of(bar.quantity);
  QString words = QString::fromUtf8(title.data(), static_cast<qsizetype>(title.size()));
  if (!bar.ticks.unit.empty()) words += QStringLiteral(" (%1)").arg(QString::fromStdString(bar.ticks.unit));
  double widest = 0.0;
  for (const picture::Tick& tick : bar.ticks.ticks)
    widest = std::max<double>(widest, painter.fontMetrics().horizontalAdvance(QString::fromStdString(tick.label)));
  const double x = strip.right() + tick_length + widest + 2.0 * gap + line;
  draw_turned(painter, plot, std::min(x, widget_width - gap / 2.0), 90.0, words);
}

void draw_cursor(QPainter& painter, const QRect& plot, QPointF at, std::size_t index) {
  for (const auto& [colour, width] : {std::pair{Qt::black, 3.0}, std::pair{Qt::white, 1.0}}) {
    painter.setPen(QPen(QColor(colour), width, index == 0 ? Qt::SolidLine : Qt::DashLine));
    painter.drawLine(QPointF(plot.left(), at.y()), QPointF(plot.right(), at.y()));
    painter.drawLine(QPointF(at.x(), plot.top()), QPointF(at.x(), plot.bottom()));
  }
  const int line = painter.fontMetrics().height();
  const QRectF label(at + QPointF(3, 3), QSizeF(line, line));
  painter.fillRect(label, QColor(0, 0, 0, 160));
  painter.drawText(label, Qt::AlignCenter, QString::number(index + 1));
}

}  // namespace sarsim::gui
