#include "gui/image/image_thumbnail.hpp"

#include <QMouseEvent>
#include <QPainter>

#include <algorithm>

namespace sarsim::gui {

namespace {

constexpr double smallest_mark_px = 6.0;
constexpr double thinnest = 0.25;  // of the other side: an image of few rows is still seen

}  // namespace

ImageThumbnail::ImageThumbnail(QWidget* parent) : QWidget(parent) {
  setObjectName("image_thumbnail");
  setAccessibleName(tr("Whole image"));
  setToolTip(tr("The whole image, by its strongest samples; the mark is the part shown. Click to go there."));
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
}

void ImageThumbnail::set_picture(const QImage& picture, std::size_t rows, std::size_t columns) {
  picture_ = picture;
  rows_ = std::max<std::size_t>(rows, 1);
  columns_ = std::max<std::size_t>(columns, 1);
  update();
}

void ImageThumbnail::set_view(const ImageView& view) {
  view_ = view;
  update();
}

QRectF ImageThumbnail::place() const {
  const auto rows = static_cast<double>(rows_);
  const auto columns = static_cast<double>(columns_);
  const double side = std::max(rows, columns);
  const QSizeF size(std::max(columns / side, thinnest) * (width() - 2),
                    std::max(rows / side, thinnest) * (height() - 2));
  return {QPointF((width() - size.width()) / 2.0, (height() - size.height()) / 2.0), size};
}

QRectF ImageThumbnail::mark() const {
  const QRectF all = place();
  const auto x = [&](double column) {
    return all.left() + (column + 0.5) / static_cast<double>(columns_) * all.width();
  };
  const auto y = [&](double row) { return all.top() + (row + 0.5) / static_cast<double>(rows_) * all.height(); };
  QRectF mark =
      QRectF(QPointF(x(view_.column_first), y(view_.row_first)), QPointF(x(view_.column_last), y(view_.row_last))) &
      all;
  const double more_x = std::max(0.0, smallest_mark_px - mark.width()) / 2.0;
  const double more_y = std::max(0.0, smallest_mark_px - mark.height()) / 2.0;
  return mark.adjusted(-more_x, -more_y, more_x, more_y);
}

void ImageThumbnail::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const QRectF all = place();
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  if (!picture_.isNull()) painter.drawImage(all, picture_);
  painter.setPen(palette().color(QPalette::Mid));
  painter.drawRect(all);
  painter.setPen(QPen(Qt::black, 3.0));
  painter.drawRect(mark());
  painter.setPen(QPen(Qt::white, 1.0, Qt::DashLine));
  painter.drawRect(mark());
}

// Column and row.
QPointF ImageThumbnail::sample_at(QPointF pixel) const {
  const QRectF all = place();
  return {(pixel.x() - all.left()) / all.width() * static_cast<double>(columns_) - 0.5,
          (pixel.y() - all.top()) / all.height() * static_cast<double>(rows_) - 0.5};
}

void ImageThumbnail::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  const QPointF sample = sample_at(event->position());
  emit centre_wanted(sample.x(), sample.y());
}

void ImageThumbnail::mouseMoveEvent(QMouseEvent* event) {
  if (!event->buttons().testFlag(Qt::LeftButton)) return;
  const QPointF sample = sample_at(event->position());
  emit centre_dragged(sample.x(), sample.y());
}

}  // namespace sarsim::gui
