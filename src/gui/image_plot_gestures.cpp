// What mouse and keys do on the plot of an image viewer.

#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include <cmath>
#include <utility>

#include "gui/image_plot.hpp"

namespace sarsim {

namespace {

constexpr double smallest_rectangle_px = 4.0;
constexpr double wheel_step = 1.25;
constexpr double key_share = 0.25;

}  // namespace

void ImagePlot::scale_about_pixel(QPointF pixel, double column_factor, double row_factor) {
  const ImagePlace at = place_at(pixel);
  emit view_wanted(mended(scaled_about(view_, at.column, at.row, column_factor, row_factor), rows_, columns_));
}

void ImagePlot::mousePressEvent(QMouseEvent* event) {
  event->accept();
  pointer_ = event->position();
  if (!plot_rect().contains(pointer_.toPoint())) return;
  if (event->button() == Qt::LeftButton) {
    rectangle_from_ = pointer_;
    selecting_ = event->modifiers().testFlag(Qt::ShiftModifier);
  }
  if (event->button() == Qt::MiddleButton) {
    moved_from_ = pointer_;
    moved_view_ = view_;
    setCursor(Qt::ClosedHandCursor);
    emit drag_began();
  }
}

void ImagePlot::mouseMoveEvent(QMouseEvent* event) {
  pointer_ = event->position();
  if (rectangle_from_) update();
  if (moved_from_) {
    const QPointF by = pointer_ - *moved_from_;
    const double across = -by.x() / plot_rect().width() * moved_view_.columns();
    const double down = -by.y() / plot_rect().height() * moved_view_.rows();
    emit view_dragged(mended({moved_view_.column_first + across, moved_view_.column_last + across,
                              moved_view_.row_first + down, moved_view_.row_last + down},
                             rows_, columns_));
  }
  emit hovered();
}

void ImagePlot::mouseReleaseEvent(QMouseEvent* event) {
  event->accept();
  pointer_ = event->position();
  if (event->button() == Qt::MiddleButton && moved_from_) {
    moved_from_.reset();
    set_reading_tool(reading_tool_);
    return;
  }
  if (event->button() == Qt::RightButton && plot_rect().contains(pointer_.toPoint())) {
    const ImagePlace at = place_at(pointer_);
    emit view_wanted(
        mended({at.column - view_.columns(), at.column + view_.columns(), at.row - view_.rows(), at.row + view_.rows()},
               rows_, columns_));
    return;
  }
  if (event->button() != Qt::LeftButton || !rectangle_from_) return;
  const QPointF corner = *std::exchange(rectangle_from_, std::nullopt);
  update();
  const QRectF drawn = QRectF(corner, pointer_).normalized() & QRectF(plot_rect());
  if (drawn.width() < smallest_rectangle_px && drawn.height() < smallest_rectangle_px) {
    click(*event);
    return;
  }
  const ImagePlace low = place_at(drawn.topLeft());
  const ImagePlace high = place_at(drawn.bottomRight());
  const ImageView wanted{low.column, high.column, low.row, high.row};
  if (selecting_)
    set_selection(samples_in(wanted, rows_, columns_));
  else if (drawn.width() >= smallest_rectangle_px && drawn.height() >= smallest_rectangle_px)
    emit view_wanted(mended(wanted, rows_, columns_));
}

void ImagePlot::click(const QMouseEvent& event) {
  const ImagePlace at = place_at(pointer_);
  const double column = std::round(at.column);
  const double row = std::round(at.row);
  if (column < 0.0 || row < 0.0 || column >= static_cast<double>(columns_) || row >= static_cast<double>(rows_)) return;
  if (reading_tool_)
    emit reading_wanted(static_cast<std::size_t>(row), static_cast<std::size_t>(column));
  else
    set_cursor(event.modifiers().testFlag(Qt::ShiftModifier) ? 1 : 0, ImagePlace{column, row});
}

void ImagePlot::wheelEvent(QWheelEvent* event) {
  event->accept();
  const QPoint turned = event->angleDelta();
  const int steps = turned.y() != 0 ? turned.y() : turned.x();  // Some systems turn Shift into a sideways wheel.
  if (steps == 0) return;
  const double factor = std::pow(wheel_step, -steps / 120.0);
  const bool columns_alone = event->modifiers().testFlag(Qt::ControlModifier);
  const bool rows_alone = event->modifiers().testFlag(Qt::ShiftModifier);
  scale_about_pixel(event->position(), rows_alone ? 1.0 : factor, columns_alone ? 1.0 : factor);
}

void ImagePlot::keyPressEvent(QKeyEvent* event) {
  const auto move = [&](double across, double down) {
    const double columns = across * key_share * view_.columns();
    const double rows = down * key_share * view_.rows();
    emit view_wanted(mended(
        {view_.column_first + columns, view_.column_last + columns, view_.row_first + rows, view_.row_last + rows},
        rows_, columns_));
  };
  const QPointF middle = QRectF(plot_rect()).center();
  switch (event->key()) {
    case Qt::Key_Left: move(-1.0, 0.0); return;
    case Qt::Key_Right: move(1.0, 0.0); return;
    case Qt::Key_Up: move(0.0, -1.0); return;
    case Qt::Key_Down: move(0.0, 1.0); return;
    case Qt::Key_Plus:
    case Qt::Key_Equal: scale_about_pixel(middle, 0.5, 0.5); return;
    case Qt::Key_Minus: scale_about_pixel(middle, 2.0, 2.0); return;
    case Qt::Key_Backspace: emit back_wanted(); return;
    case Qt::Key_Home: emit whole_wanted(); return;
    case Qt::Key_Escape:
      if (!std::exchange(rectangle_from_, std::nullopt)) {
        set_selection(std::nullopt);
        cursors_ = {};
        emit cursors_changed();
      }
      update();
      return;
    default: QWidget::keyPressEvent(event);
  }
}

void ImagePlot::leaveEvent(QEvent*) {
  pointer_ = {-1.0, -1.0};
  emit hovered();
}

void ImagePlot::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  emit resized();
}

void ImagePlot::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange) emit resized();
  if (event->type() == QEvent::PaletteChange) update();
}

}  // namespace sarsim
