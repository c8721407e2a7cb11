#include "gui/common/gesture_plot.hpp"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <utility>

namespace sarsim::gui {

namespace {

constexpr double smallest_rectangle_px = 4.0;
constexpr double wheel_step = 1.25;
constexpr double key_share = 0.25;
constexpr double hold_px = 7.0;  // how near a mark is taken hold of

}  // namespace

GesturePlot::GesturePlot(QWidget* parent) : QWidget(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setCursor(idle_cursor_);
}

QSize GesturePlot::device_size() const {
  const QSizeF size = QSizeF(plot_rect().size()) * devicePixelRatioF();
  return {std::max(1, qRound(size.width())), std::max(1, qRound(size.height()))};
}

QImage GesturePlot::plot_image() const {
  QImage picture(device_size(), QImage::Format_RGB32);
  QPainter painter(&picture);
  const QRect plot = plot_rect();
  painter.scale(picture.width() / static_cast<double>(plot.width()),
                picture.height() / static_cast<double>(plot.height()));
  painter.translate(-plot.topLeft());
  paint_plot(painter);
  return picture;
}

void GesturePlot::set_idle_cursor(Qt::CursorShape shape) {
  idle_cursor_ = shape;
  setCursor(shape);
}

void GesturePlot::paint_rectangle(QPainter& painter, Qt::PenStyle edge) const {
  if (!rectangle_from_) return;
  QColor colour = palette().color(QPalette::Highlight);
  painter.setPen(QPen(colour, 1.0, edge));
  colour.setAlphaF(0.2F);
  painter.setBrush(colour);
  painter.drawRect(QRectF(*rectangle_from_, pointer_).normalized() & QRectF(plot_rect()));
}

std::optional<std::size_t> GesturePlot::mark_at(QPointF at) const {
  for (std::size_t index = 0; index < 2; ++index) {
    const std::optional<QPointF> place = mark(index);
    if (place && std::hypot(place->x() - at.x(), place->y() - at.y()) <= hold_px) return index;
  }
  return std::nullopt;
}

void GesturePlot::mousePressEvent(QMouseEvent* event) {
  event->accept();
  pointer_ = event->position();
  if (!plot_rect().contains(pointer_.toPoint())) return;
  if (event->button() == Qt::LeftButton) {
    const auto index = event->modifiers() == Qt::NoModifier ? mark_at(pointer_) : std::nullopt;
    if (index) {
      held_ = {*index, *mark(*index), pointer_};
      setCursor(Qt::ClosedHandCursor);
      return;
    }
    rectangle_from_ = pointer_;
    rectangle_with_shift_ = event->modifiers().testFlag(Qt::ShiftModifier);
  }
  if (event->button() == Qt::MiddleButton) {
    dragged_from_ = pointer_;
    begin_drag();
    setCursor(Qt::ClosedHandCursor);
    emit drag_began();
  }
}

void GesturePlot::mouseMoveEvent(QMouseEvent* event) {
  pointer_ = event->position();
  if (rectangle_from_) update();
  if (dragged_from_) drag(pointer_ - *dragged_from_);
  if (held_)
    move_mark(held_->index, held_->from + pointer_ - held_->pressed);
  else if (event->buttons() == Qt::NoButton)
    setCursor(mark_at(pointer_) ? Qt::OpenHandCursor : idle_cursor_);
  emit hovered();
}

void GesturePlot::mouseReleaseEvent(QMouseEvent* event) {
  event->accept();
  pointer_ = event->position();
  if (event->button() == Qt::MiddleButton && dragged_from_) {
    dragged_from_.reset();
    setCursor(idle_cursor_);
    return;
  }
  if (event->button() == Qt::RightButton && plot_rect().contains(pointer_.toPoint())) {
    show_twice(pointer_);
    return;
  }
  if (event->button() == Qt::LeftButton && std::exchange(held_, std::nullopt)) {
    setCursor(mark_at(pointer_) ? Qt::OpenHandCursor : idle_cursor_);
    return;
  }
  if (event->button() != Qt::LeftButton || !rectangle_from_) return;
  const QPointF corner = *std::exchange(rectangle_from_, std::nullopt);
  update();
  const QPointF drawn = pointer_ - corner;
  if (std::abs(drawn.x()) < smallest_rectangle_px && std::abs(drawn.y()) < smallest_rectangle_px)
    click(pointer_, event->modifiers());
  else
    take_rectangle(corner, pointer_);
}

void GesturePlot::wheelEvent(QWheelEvent* event) {
  event->accept();
  const QPoint turned = event->angleDelta();
  const int steps = turned.y() != 0 ? turned.y() : turned.x();  // Some systems turn Shift into a sideways wheel.
  if (steps == 0) return;
  const double factor = std::pow(wheel_step, -steps / 120.0);
  const bool across_alone = event->modifiers().testFlag(Qt::ControlModifier);
  const bool upwards_alone = event->modifiers().testFlag(Qt::ShiftModifier);
  scale_about_pixel(event->position(), upwards_alone ? 1.0 : factor, across_alone ? 1.0 : factor);
}

void GesturePlot::keyPressEvent(QKeyEvent* event) {
  const QPointF middle = QRectF(plot_rect()).center();
  switch (event->key()) {
    case Qt::Key_Left: step(-key_share, 0.0); return;
    case Qt::Key_Right: step(key_share, 0.0); return;
    case Qt::Key_Up: step(0.0, key_share); return;
    case Qt::Key_Down: step(0.0, -key_share); return;
    case Qt::Key_Plus:
    case Qt::Key_Equal: scale_about_pixel(middle, 0.5, 0.5); return;
    case Qt::Key_Minus: scale_about_pixel(middle, 2.0, 2.0); return;
    case Qt::Key_Backspace: emit back_wanted(); return;
    case Qt::Key_Home: emit whole_wanted(); return;
    case Qt::Key_Escape:
      if (const auto held = std::exchange(held_, std::nullopt))
        move_mark(held->index, held->from);
      else if (!std::exchange(rectangle_from_, std::nullopt))
        drop_marks();
      update();
      return;
    default: QWidget::keyPressEvent(event);
  }
}

void GesturePlot::leaveEvent(QEvent*) {
  pointer_ = {-1.0, -1.0};
  emit hovered();
}

void GesturePlot::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  emit resized();
}

void GesturePlot::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange) emit resized();
  if (event->type() == QEvent::PaletteChange) update();
}

}  // namespace sarsim::gui
