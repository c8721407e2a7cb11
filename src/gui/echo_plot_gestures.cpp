// What mouse and keys do on the plot of a simulation window.

#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include <cmath>
#include <utility>

#include "gui/echo_plot.hpp"

namespace sarsim {

namespace {

constexpr double smallest_rectangle_px = 4.0;
constexpr double wheel_step = 1.25;
constexpr double key_share = 0.25;

}  // namespace

void EchoPlot::scale_about(QPointF pixel, double range_factor, double time_factor) {
  const QPointF at = device(pixel);
  emit view_wanted(scaled_about(view(), plot_size(), at.x(), at.y(), range_factor, time_factor));
}

void EchoPlot::mousePressEvent(QMouseEvent* event) {
  event->accept();
  pointer_ = event->position();
  if (!plot_rect().contains(pointer_.toPoint())) return;
  if (event->button() == Qt::LeftButton) rectangle_from_ = pointer_;
  if (event->button() == Qt::MiddleButton) {
    moved_from_ = pointer_;
    moved_view_ = view();
    setCursor(Qt::ClosedHandCursor);
    emit drag_began();
  }
}

void EchoPlot::mouseMoveEvent(QMouseEvent* event) {
  pointer_ = event->position();
  if (rectangle_from_) update();
  if (moved_from_) {
    const QPointF by = device(pointer_) - device(*moved_from_);
    emit view_dragged(panned(moved_view_, plot_size(), by.x(), by.y()));
  }
  emit hovered();
}

void EchoPlot::mouseReleaseEvent(QMouseEvent* event) {
  event->accept();
  pointer_ = event->position();
  if (event->button() == Qt::MiddleButton && moved_from_) {
    moved_from_.reset();
    setCursor(Qt::CrossCursor);
    return;
  }
  const QPointF at = device(pointer_);
  if (event->button() == Qt::RightButton && plot_rect().contains(pointer_.toPoint())) {
    emit view_wanted(zoomed_out(view(), plot_size(), at.x(), at.y()));
    return;
  }
  if (event->button() != Qt::LeftButton || !rectangle_from_) return;
  const QPointF corner = *std::exchange(rectangle_from_, std::nullopt);
  update();
  const QPointF drawn = pointer_ - corner;
  if (std::abs(drawn.x()) < smallest_rectangle_px && std::abs(drawn.y()) < smallest_rectangle_px) {
    const Cursor place{range_at(view(), plot_size(), at.x()), time_at(view(), plot_size(), at.y())};
    set_cursor(event->modifiers().testFlag(Qt::ShiftModifier) ? 1 : 0, place);
    return;
  }
  const QPointF from = device(corner);
  if (const auto zoomed = zoomed_to(view(), plot_size(), from.x(), from.y(), at.x(), at.y())) emit view_wanted(*zoomed);
}

void EchoPlot::wheelEvent(QWheelEvent* event) {
  event->accept();
  const QPoint turned = event->angleDelta();
  const int steps = turned.y() != 0 ? turned.y() : turned.x();  // Some systems turn Shift into a sideways wheel.
  if (steps == 0) return;
  const double factor = std::pow(wheel_step, -steps / 120.0);
  const bool range_alone = event->modifiers().testFlag(Qt::ControlModifier);
  const bool time_alone = event->modifiers().testFlag(Qt::ShiftModifier);
  scale_about(event->position(), time_alone ? 1.0 : factor, range_alone ? 1.0 : factor);
}

void EchoPlot::keyPressEvent(QKeyEvent* event) {
  const PlotSize size = plot_size();
  const auto move = [&](double across, double up) {
    emit view_wanted(panned(view(), size, -across * key_share * static_cast<double>(size.width_px),
                            up * key_share * static_cast<double>(size.height_px)));
  };
  const QPointF middle = plot_rect().center();
  switch (event->key()) {
    case Qt::Key_Left: move(-1.0, 0.0); return;
    case Qt::Key_Right: move(1.0, 0.0); return;
    case Qt::Key_Up: move(0.0, 1.0); return;
    case Qt::Key_Down: move(0.0, -1.0); return;
    case Qt::Key_Plus:
    case Qt::Key_Equal: scale_about(middle, 0.5, 0.5); return;
    case Qt::Key_Minus: scale_about(middle, 2.0, 2.0); return;
    case Qt::Key_Backspace: emit back_wanted(); return;
    case Qt::Key_Home: emit all_targets_wanted(); return;
    case Qt::Key_Escape:
      if (!std::exchange(rectangle_from_, std::nullopt)) {
        cursors_ = {};
        emit cursors_changed();
      }
      update();
      return;
    default: QWidget::keyPressEvent(event);
  }
}

void EchoPlot::leaveEvent(QEvent*) {
  pointer_ = {-1.0, -1.0};
  emit hovered();
}

void EchoPlot::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  emit resized();
}

void EchoPlot::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange) emit resized();
  if (event->type() == QEvent::PaletteChange) update();
}

}  // namespace sarsim
