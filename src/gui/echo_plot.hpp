#pragma once

#include <QImage>
#include <QWidget>

#include <array>
#include <memory>
#include <optional>

#include "view/echo_curves.hpp"
#include "view/echo_matrix.hpp"
#include "view/echo_picture.hpp"
#include "view/echo_readout.hpp"
#include "view/echo_window.hpp"

namespace sarsim {

/// The echo matrix of a simulation window with its axes and colour bar ("echo_plot"). It shows what it is given and
/// turns gestures into wishes for another view; who computes is the owner's business. Until samples of a new view
/// arrive, those of the old one are shown where they belong.
///
/// Mouse: left drag zooms to the rectangle, right click shows twice as much, the wheel zooms at the pointer (Ctrl:
/// range alone, Shift: time alone), middle drag moves the view; a left click sets the first cursor, with Shift the
/// second. Keys: arrows move by a quarter, + and - zoom, Backspace goes back, Home shows all targets, Escape drops a
/// rectangle or the cursors.
class EchoPlot : public QWidget {
  Q_OBJECT

 public:
  /// A place that is marked: in range and time, so that it stays where it is when the view moves.
  struct Cursor {
    double range_m = 0.0;
    double time_s = 0.0;
  };

  explicit EchoPlot(QWidget* parent = nullptr);

  /// The view and how samples are drawn.
  void set_window(const EchoWindow& window, double light_speed_mps);
  /// Samples to show; given again when more rows are ready. Null: none.
  void set_matrix(std::shared_ptr<const EchoMatrix> matrix);
  [[nodiscard]] const std::shared_ptr<const EchoMatrix>& matrix() const { return matrix_; }
  [[nodiscard]] const EchoColours& colours() const { return colours_; }

  /// Device pixels of the plot.
  [[nodiscard]] PlotSize plot_size() const;
  /// Where the plot is in the widget, in its own pixels.
  [[nodiscard]] QRect plot_rect() const;
  /// The plot alone, in device pixels.
  [[nodiscard]] QImage plot_image() const;

  /// The sample that a pixel of the widget shows.
  [[nodiscard]] std::optional<ReadOut> read_out_at(QPointF pixel) const;
  /// The sample below a cursor: 0 or 1.
  [[nodiscard]] std::optional<ReadOut> read_out_at_cursor(std::size_t cursor) const;
  [[nodiscard]] const std::optional<Cursor>& cursor(std::size_t index) const { return cursors_.at(index); }
  void set_cursor(std::size_t index, std::optional<Cursor> place);

  [[nodiscard]] QSize sizeHint() const override { return {760, 480}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {260, 200}; }

 signals:
  void view_wanted(const sarsim::EchoView& view);  ///< Zoom: the view before is one to go back to.
  void view_dragged(const sarsim::EchoView& view);
  void drag_began();
  void back_wanted();
  void all_targets_wanted();
  void resized();
  void hovered();  ///< The pointer moved or left; ask `read_out_at`.
  void cursors_changed();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  void refresh_picture();
  void paint_plot(QPainter& painter) const;
  void paint_curves(QPainter& painter) const;
  void paint_axes(QPainter& painter) const;
  void paint_colour_bar(QPainter& painter) const;
  void paint_cursors(QPainter& painter) const;
  [[nodiscard]] QRectF place_of_picture() const;
  [[nodiscard]] QPointF pixel_of(const Cursor& cursor) const;
  [[nodiscard]] QPointF device(QPointF pixel) const;  ///< Device pixel of the plot for a pixel of the widget.
  [[nodiscard]] EchoView view() const { return view_of(window_); }
  void scale_about(QPointF pixel, double range_factor, double time_factor);

  EchoWindow window_;
  double light_speed_mps_ = 299792458.0;
  std::shared_ptr<const EchoMatrix> matrix_;
  EchoColours colours_;
  EchoImage image_;
  EchoCurves curves_;
  DrawAs drawn_as_ = DrawAs::pixels;
  std::array<std::optional<Cursor>, 2> cursors_;
  std::optional<QPointF> rectangle_from_;
  QPointF pointer_;
  std::optional<QPointF> moved_from_;
  EchoView moved_view_;
};

}  // namespace sarsim
