#pragma once

// The plot library's header comes from the system's folders, where warnings are off.
#include <qcustomplot.h>

#include <array>
#include <optional>

#include "scene/edit/function_model.hpp"

class QRubberBand;

namespace sarsim::gui {

/// The graph of one part of a user-defined function (thesis 4.6): the interpolated curve with its points, which can be
/// dragged; bars where the function belongs to the pulse number.
///
/// A left press within 8 pixels of a point drags it, elsewhere it draws the rectangle to zoom to; a right click zooms
/// out by two about the place clicked; the wheel zooms about the pointer (Shift: y alone, Ctrl: x alone). Plus, minus
/// and Home do so from the keyboard. Escape ends a drag without effect.
class FunctionPlot : public QCustomPlot {
  Q_OBJECT

 public:
  /// What is seen of the axes.
  struct Window {
    std::array<double, 2> x{0.0, 1.0};
    std::array<double, 2> y{0.0, 1.0};
  };

  explicit FunctionPlot(QWidget* parent = nullptr);

  /// Shows another function with other axes, all of it.
  void set_info(const scene::FunctionInfo& info, std::size_t part);
  /// Shows these points; the window stays.
  void set_function(const core::SampledFunction& function);
  /// Draws the two other interpolations faintly.
  void set_compare(bool compare);
  /// Marks a point; nothing for none.
  void set_current(std::optional<std::size_t> knot);

  [[nodiscard]] Window window() const { return window_; }
  /// Sets what is seen, limited to what is legal; ends in the wrong order are exchanged, equal ones moved apart.
  void set_window(Window window);
  /// Zooms about a point of the graph; factors below 1 show less.
  void zoom_about(double x, double y, double factor_x, double factor_y);
  /// Zooms about the middle.
  void zoom(double factor_x, double factor_y);
  /// Shows all points, and the usual range where they span none.
  void fit();

  /// Where a point is drawn.
  [[nodiscard]] QPointF knot_pixel(std::size_t knot) const;
  /// The point within 8 pixels, nearest first.
  [[nodiscard]] std::optional<std::size_t> knot_at(const QPointF& pixel) const;

 signals:
  void drag_began(std::size_t knot);                         ///< A point was taken hold of and moved.
  void dragged(std::size_t knot, sarsim::core::Knot to);     ///< While the button is down; not rounded.
  void drag_ended(std::size_t knot, sarsim::core::Knot to);  ///< Rounded to a hundredth of the decade of the window.
  void drag_cancelled();                                     ///< It is to go back to where it was.
  void knot_clicked(std::size_t knot);                       ///< A point was pressed without being moved.
  void window_changed();                                     ///< Another part of the axes is seen.

 protected:
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void make_items();
  void refresh_colours();
  void refresh_axes();
  void refresh_axis(QCPAxis* axis, const QString& name, const std::string& unit, QCPAxisTickerText& ticker);
  void refresh_curves();
  void refresh_knots();
  void redraw();
  void show_coordinates(const QPointF& pixel, core::Knot at);
  void hide_coordinates();
  [[nodiscard]] core::Knot shown_knot(std::size_t knot) const;
  [[nodiscard]] core::Knot value_at(const QPointF& pixel) const;
  [[nodiscard]] QPointF inside(const QPointF& pixel) const;
  void set_range(const std::array<double, 2>& limits, std::array<double, 2>& range) const;
  [[nodiscard]] QString coordinates_text(core::Knot at) const;

  scene::FunctionInfo info_;
  std::size_t part_ = 0;
  core::SampledFunction function_;
  bool compare_ = false;
  std::optional<std::size_t> current_;
  Window window_;
  std::array<QCPGraph*, 3> curves_{};  // in the order of Interpolation
  QCPGraph* points_ = nullptr;
  QCPGraph* current_point_ = nullptr;
  QCPBars* bars_ = nullptr;
  QCPItemText* coordinates_ = nullptr;
  QSharedPointer<QCPAxisTickerText> x_ticker_;
  QSharedPointer<QCPAxisTickerText> y_ticker_;
  QRubberBand* band_ = nullptr;
  std::optional<std::size_t> dragged_;
  bool moved_ = false;
  std::optional<QPoint> band_from_;
};

}  // namespace sarsim::gui
