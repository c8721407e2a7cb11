#include "gui/image_plot.hpp"

#include <QFontMetrics>
#include <QPainter>

#include <algorithm>
#include <cmath>

#include "gui/palette_colours.hpp"
#include "view/ticks.hpp"

namespace sarsim {

namespace {

constexpr int bar_width = 14;
constexpr int tick_length = 4;
constexpr int gap = 6;

QRgb empty_ground(bool dark) { return dark ? qRgb(38, 40, 44) : qRgb(214, 216, 220); }

}  // namespace

ImagePlot::ImagePlot(QWidget* parent) : QWidget(parent) {
  setObjectName("image_plot");
  setAccessibleName(tr("Image"));
  setAccessibleDescription(tr("Samples across, rows downwards. Arrows move, plus and minus zoom."));
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setCursor(Qt::CrossCursor);
}

void ImagePlot::set_size(std::size_t rows, std::size_t columns) {
  rows_ = std::max<std::size_t>(rows, 1);
  columns_ = std::max<std::size_t>(columns, 1);
  update();
}

void ImagePlot::set_view(const ImageView& view) {
  if (view == view_) return;
  view_ = view;
  update();
}

void ImagePlot::set_part(std::shared_ptr<const ImagePart> part, PaintedPart painted, const QString& unit) {
  part_ = std::move(part);
  painted_ = std::move(painted);
  unit_ = unit;
  const std::vector<Rgb>& table = painted_.colours.table;
  bar_ = table.empty() ? QImage() : QImage(1, static_cast<int>(table.size()), QImage::Format_RGB32);
  for (std::size_t i = 0; i < table.size(); ++i) {
    const Rgb& c = table[table.size() - 1 - i];
    bar_.setPixel(0, static_cast<int>(i), qRgb(c.red, c.green, c.blue));
  }
  update();
}

void ImagePlot::set_coarse(const QImage& picture) {
  coarse_ = picture;
  update();
}

void ImagePlot::set_reading_tool(bool on) {
  reading_tool_ = on;
  setCursor(on ? Qt::PointingHandCursor : Qt::CrossCursor);
}

QRect ImagePlot::plot_rect() const {
  const QFontMetrics metrics = fontMetrics();
  const int numbers = metrics.horizontalAdvance(QStringLiteral("-00000.00"));
  const int line = metrics.height();
  const int left = numbers + line + 2 * gap + tick_length;
  const int right = numbers + line + bar_width + 3 * gap + tick_length;
  const int above = line / 2 + gap;
  const int below = 2 * line + gap + tick_length;
  return QRect(left, above, std::max(width() - left - right, 1), std::max(height() - above - below, 1));
}

QSize ImagePlot::device_size() const {
  const QSizeF size = QSizeF(plot_rect().size()) * devicePixelRatioF();
  return {std::max(1, qRound(size.width())), std::max(1, qRound(size.height()))};
}

ImagePlace ImagePlot::place_at(QPointF pixel) const {
  const QRect plot = plot_rect();
  return {view_.column_first + (pixel.x() - plot.left()) / plot.width() * view_.columns(),
          view_.row_first + (pixel.y() - plot.top()) / plot.height() * view_.rows()};
}

QPointF ImagePlot::pixel_of(ImagePlace place) const {
  const QRect plot = plot_rect();
  return {plot.left() + (place.column - view_.column_first) / view_.columns() * plot.width(),
          plot.top() + (place.row - view_.row_first) / view_.rows() * plot.height()};
}

std::optional<ImagePlace> ImagePlot::pointer_place() const {
  if (!plot_rect().contains(pointer_.toPoint())) return std::nullopt;
  return place_at(pointer_);
}

void ImagePlot::set_cursor(std::size_t index, std::optional<ImagePlace> place) {
  cursors_.at(index) = place;
  update();
  emit cursors_changed();
}

void ImagePlot::set_selection(std::optional<ImageWindow> selection) {
  if (selection && selection->samples() == 0) selection.reset();
  if (selection_ == selection) return;
  selection_ = selection;
  update();
  emit selection_changed();
}

QRectF ImagePlot::rect_of(const QRectF& samples) const {
  return QRectF(pixel_of({samples.left(), samples.top()}), pixel_of({samples.right(), samples.bottom()}));
}

QImage ImagePlot::plot_image() const {
  QImage picture(device_size(), QImage::Format_RGB32);
  QPainter painter(&picture);
  const QRect plot = plot_rect();
  painter.scale(picture.width() / static_cast<double>(plot.width()),
                picture.height() / static_cast<double>(plot.height()));
  painter.translate(-plot.topLeft());
  paint_plot(painter);
  return picture;
}

void ImagePlot::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), palette().color(QPalette::Window));
  paint_plot(painter);
  paint_axes(painter);
  if (!bar_.isNull()) paint_colour_bar(painter);
  paint_marks(painter);
  if (!rectangle_from_) return;
  painter.setPen(QPen(palette().color(QPalette::Highlight), 1.0, selecting_ ? Qt::DashLine : Qt::SolidLine));
  QColor filled = palette().color(QPalette::Highlight);
  filled.setAlphaF(0.2F);
  painter.setBrush(filled);
  painter.drawRect(QRectF(*rectangle_from_, pointer_).normalized() & QRectF(plot_rect()));
}

void ImagePlot::paint_plot(QPainter& painter) const {
  const QRect plot = plot_rect();
  painter.save();
  painter.setClipRect(plot);
  painter.fillRect(plot, QColor(empty_ground(is_dark(palette()))));
  // No smoothing: no colour that no sample has.
  if (!coarse_.isNull())
    painter.drawImage(rect_of(QRectF(-0.5, -0.5, static_cast<double>(columns_), static_cast<double>(rows_))), coarse_);
  if (part_ && !painted_.image.isNull()) painter.drawImage(rect_of(extent_of(part_->window)), painted_.image);
  painter.restore();
}

void ImagePlot::paint_axes(QPainter& painter) const {
  const QRect plot = plot_rect();
  painter.setPen(palette().color(QPalette::WindowText));
  painter.drawRect(plot.adjusted(0, 0, -1, -1));
  const int line = fontMetrics().height();
  const double across = fontMetrics().horizontalAdvance(QStringLiteral("0000000000"));
  const int edge = plot.bottom() + 1;
  for (const Tick& tick : axis_ticks(view_.column_first, view_.column_last, plot.width(), across, "").ticks) {
    const double x = pixel_of({tick.value, 0.0}).x();
    painter.drawLine(QPointF(x, edge), QPointF(x, edge + tick_length));
    painter.drawText(QRectF(x - across, edge + tick_length, 2.0 * across, line), Qt::AlignCenter,
                     QString::fromStdString(tick.label));
  }
  painter.drawText(QRect(plot.left(), edge + tick_length + line, plot.width(), line), Qt::AlignCenter, tr("Sample"));
  for (const Tick& tick : axis_ticks(view_.row_first, view_.row_last, plot.height(), 2.5 * line, "").ticks) {
    const double y = pixel_of({0.0, tick.value}).y();
    painter.drawLine(QPointF(plot.left() - tick_length, y), QPointF(plot.left(), y));
    painter.drawText(QRectF(0.0, y - line, plot.left() - tick_length - gap / 2.0, 2.0 * line),
                     Qt::AlignRight | Qt::AlignVCenter, QString::fromStdString(tick.label));
  }
  painter.save();
  painter.translate(gap / 2.0, plot.center().y());
  painter.rotate(-90.0);
  painter.drawText(QRect(-plot.height() / 2, 0, plot.height(), line), Qt::AlignCenter, tr("Row"));
  painter.restore();
}

void ImagePlot::paint_colour_bar(QPainter& painter) const {
  const QRect plot = plot_rect();
  const QRect strip(plot.right() + 2 * gap, plot.top(), bar_width, plot.height());
  painter.drawImage(strip, bar_);
  painter.setPen(palette().color(QPalette::WindowText));
  painter.drawRect(strip.adjusted(0, 0, -1, -1));
  const int line = fontMetrics().height();
  const ColourLimits& limits = painted_.colours.limits;
  const Ticks marks = axis_ticks(limits.low, limits.high, plot.height(), 2.5 * line, unit_.toStdString());
  for (const Tick& tick : marks.ticks) {
    const double share = (tick.value - limits.low) / (limits.high - limits.low);
    const double y = strip.bottom() + 1 - share * strip.height();
    painter.drawLine(QPointF(strip.right() + 1, y), QPointF(strip.right() + 1 + tick_length, y));
    painter.drawText(QRectF(strip.right() + tick_length + gap / 2.0 + 1, y - line, width(), 2.0 * line),
                     Qt::AlignLeft | Qt::AlignVCenter, QString::fromStdString(tick.label));
  }
  const QString unit = QString::fromStdString(marks.unit);
  const std::string_view title = title_of(painted_.colours.quantity);
  const QString name = QString::fromUtf8(title.data(), static_cast<qsizetype>(title.size()));
  painter.save();
  painter.translate(width() - gap / 2.0, plot.center().y());
  painter.rotate(90.0);
  painter.drawText(QRect(-plot.height() / 2, 0, plot.height(), line), Qt::AlignCenter,
                   unit.isEmpty() ? name : name + QStringLiteral(" [%1]").arg(unit));
  painter.restore();
}

void ImagePlot::paint_marks(QPainter& painter) const {
  painter.save();
  painter.setClipRect(plot_rect());
  if (selection_) {
    // Light on dark, so that it is seen on any colour.
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(Qt::black, 3.0));
    painter.drawRect(rect_of(extent_of(*selection_)));
    painter.setPen(QPen(Qt::white, 1.0, Qt::DashLine));
    painter.drawRect(rect_of(extent_of(*selection_)));
  }
  for (std::size_t i = 0; i < cursors_.size(); ++i)
    if (cursors_[i]) paint_cursor(painter, i);
  painter.restore();
}

void ImagePlot::paint_cursor(QPainter& painter, std::size_t index) const {
  const QRect plot = plot_rect();
  const QPointF at = pixel_of(*cursors_[index]);
  for (const auto& [colour, width] : {std::pair{Qt::black, 3.0}, std::pair{Qt::white, 1.0}}) {
    painter.setPen(QPen(QColor(colour), width, index == 0 ? Qt::SolidLine : Qt::DashLine));
    painter.drawLine(QPointF(plot.left(), at.y()), QPointF(plot.right(), at.y()));
    painter.drawLine(QPointF(at.x(), plot.top()), QPointF(at.x(), plot.bottom()));
  }
  const QRectF label(at + QPointF(3, 3), QSizeF(fontMetrics().height(), fontMetrics().height()));
  painter.fillRect(label, QColor(0, 0, 0, 160));
  painter.drawText(label, Qt::AlignCenter, QString::number(index + 1));
}

}  // namespace sarsim
