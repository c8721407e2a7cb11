#pragma once

#include <QImage>
#include <QWidget>

#include <optional>

namespace sarsim::gui {

/// A plot whose view is moved with mouse and keys, in the same way in all windows. It turns gestures into wishes; what
/// they mean is the plot's own business, and whether they are granted its owner's.
///
/// Mouse: left drag draws a rectangle; right click shows twice as much; the wheel zooms at the pointer (Ctrl: across
/// alone, Shift: upwards alone); middle drag moves the view; a left click marks a place, and a left drag that begins on
/// a mark takes it along. Keys: arrows move by a quarter, + and - zoom, Backspace goes back, Home shows everything,
/// Escape puts back a mark that is dragged, drops a rectangle, then the marks.
class GesturePlot : public QWidget {
  Q_OBJECT

 public:
  explicit GesturePlot(QWidget* parent = nullptr);

  /// Where the plot is in the widget, in its own pixels.
  [[nodiscard]] virtual QRect plot_rect() const = 0;
  /// Size of the plot in device pixels, at least 1 by 1.
  [[nodiscard]] QSize device_size() const;
  /// The plot alone, in device pixels.
  [[nodiscard]] QImage plot_image() const;

  [[nodiscard]] QSize sizeHint() const override { return {760, 480}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {260, 200}; }

 signals:
  void drag_began();       ///< The view is about to be moved with the mouse: it is one to go back to.
  void back_wanted();      ///< The view before is wanted.
  void whole_wanted();     ///< All that there is is wanted.
  void resized();          ///< The plot has another size on the screen.
  void hovered();          ///< The pointer moved or left.
  void cursors_changed();  ///< A cursor was set or dropped.

 protected:
  /// What stands within the plot, without its frame and marks.
  virtual void paint_plot(QPainter& painter) const = 0;

  /// @name What gestures mean. Places are pixels of the widget, factors above 1 show more.
  /// @{
  virtual void click(QPointF at, Qt::KeyboardModifiers keys) = 0;
  virtual void take_rectangle(QPointF from, QPointF to) = 0;
  virtual void show_twice(QPointF middle) = 0;
  virtual void scale_about_pixel(QPointF pixel, double across, double upwards) = 0;
  virtual void begin_drag() = 0;
  /// The pointer is `by` from where the drag began.
  virtual void drag(QPointF by) = 0;
  /// Moves the view by shares of its size, to the right and upwards.
  virtual void step(double right, double up) = 0;
  virtual void drop_marks() = 0;
  /// Where mark 0 or 1 is; nothing where it cannot be taken hold of.
  [[nodiscard]] virtual std::optional<QPointF> mark(std::size_t index) const = 0;
  virtual void move_mark(std::size_t index, QPointF to) = 0;
  /// @}

  /// The pointer's shape where no drag is under way.
  void set_idle_cursor(Qt::CursorShape shape);
  /// Where the pointer is; outside the plot where it is not over the widget.
  [[nodiscard]] QPointF pointer() const { return pointer_; }
  /// Whether the rectangle was begun with Shift.
  [[nodiscard]] bool rectangle_with_shift() const { return rectangle_with_shift_; }
  /// The rectangle that is being drawn, where one is.
  void paint_rectangle(QPainter& painter, Qt::PenStyle edge) const;

  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  [[nodiscard]] std::optional<std::size_t> mark_at(QPointF at) const;

  QPointF pointer_{-1.0, -1.0};
  std::optional<QPointF> rectangle_from_;
  bool rectangle_with_shift_ = false;
  std::optional<QPointF> dragged_from_;
  struct HeldMark {
    std::size_t index;
    QPointF from;     // its place before
    QPointF pressed;  // that of the pointer
  };
  std::optional<HeldMark> held_;
  Qt::CursorShape idle_cursor_ = Qt::CrossCursor;
};

}  // namespace sarsim::gui
