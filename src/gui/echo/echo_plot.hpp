#pragma once

#include <array>
#include <memory>
#include <optional>

#include "core/maths/constants.hpp"
#include "gui/common/gesture_plot.hpp"
#include "picture/echo/echo_curves.hpp"
#include "picture/echo/echo_matrix.hpp"
#include "picture/echo/echo_picture.hpp"
#include "picture/echo/echo_readout.hpp"
#include "picture/echo/echo_window.hpp"

namespace sarsim::gui {

/// The echo matrix of a simulation window with its axes and colour bar ("echo_plot"). It shows what it is given and
/// turns gestures into wishes for another view; who computes is the owner's business. Until samples of a new view
/// arrive, those of the old one are shown where they belong.
///
/// Left drag zooms to the rectangle; a left click sets the first cursor, with Shift the second. Home shows all targets.
class EchoPlot : public GesturePlot {
  Q_OBJECT

 public:
  /// A place that is marked: in range and time, so that it stays where it is when the view moves.
  struct Cursor {
    double range_m = 0.0;
    double time_s = 0.0;
  };

  explicit EchoPlot(QWidget* parent = nullptr);

  /// The view and how samples are drawn.
  void set_window(const picture::EchoWindow& window, double light_speed_mps);
  /// Samples to show; given again when more rows are ready. Null: none.
  void set_matrix(std::shared_ptr<const picture::EchoMatrix> matrix);
  [[nodiscard]] const std::shared_ptr<const picture::EchoMatrix>& matrix() const { return matrix_; }
  [[nodiscard]] const picture::EchoColours& colours() const { return colours_; }

  /// Device pixels of the plot.
  [[nodiscard]] picture::PlotSize plot_size() const;
  [[nodiscard]] QRect plot_rect() const override;

  /// The sample that a pixel of the widget shows.
  [[nodiscard]] std::optional<picture::ReadOut> read_out_at(QPointF pixel) const;
  /// The sample below a cursor: 0 or 1.
  [[nodiscard]] std::optional<picture::ReadOut> read_out_at_cursor(std::size_t cursor) const;
  [[nodiscard]] const std::optional<Cursor>& cursor(std::size_t index) const { return cursors_.at(index); }
  /// Sets cursor 0 or 1, or takes it away.
  void set_cursor(std::size_t index, std::optional<Cursor> place);

 signals:
  void view_wanted(const sarsim::picture::EchoView& view);   ///< Zoom: the view before is one to go back to.
  void view_dragged(const sarsim::picture::EchoView& view);  ///< One of many views on the way.

 protected:
  void paint_plot(QPainter& painter) const override;
  void paintEvent(QPaintEvent* event) override;
  void click(QPointF at, Qt::KeyboardModifiers keys) override;
  void take_rectangle(QPointF from, QPointF to) override;
  void show_twice(QPointF middle) override;
  void scale_about_pixel(QPointF pixel, double across, double upwards) override;
  void begin_drag() override { dragged_view_ = view(); }
  void drag(QPointF by) override;
  void step(double right, double up) override;
  void drop_marks() override;
  [[nodiscard]] std::optional<QPointF> mark(std::size_t index) const override;
  void move_mark(std::size_t index, QPointF to) override;

 private:
  void refresh_picture();
  void paint_curves(QPainter& painter) const;
  void paint_axes(QPainter& painter) const;
  void paint_colour_bar(QPainter& painter) const;
  void paint_cursors(QPainter& painter) const;
  [[nodiscard]] Cursor place_at(QPointF pixel) const;
  [[nodiscard]] QRectF place_of_picture() const;
  [[nodiscard]] QPointF pixel_of(const Cursor& cursor) const;
  [[nodiscard]] QPointF device(QPointF pixel) const;  ///< Device pixel of the plot for a pixel of the widget.
  [[nodiscard]] picture::EchoView view() const { return picture::view_of(window_); }

  picture::EchoWindow window_;
  double light_speed_mps_ = core::exact_light_speed_mps;
  std::shared_ptr<const picture::EchoMatrix> matrix_;
  picture::EchoColours colours_;
  picture::EchoImage image_;
  picture::EchoCurves curves_;
  picture::DrawAs drawn_as_ = picture::DrawAs::pixels;
  std::array<std::optional<Cursor>, 2> cursors_;
  picture::EchoView dragged_view_;
};

}  // namespace sarsim::gui
