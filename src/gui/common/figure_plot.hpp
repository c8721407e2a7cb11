#pragma once

// The plot library's header comes from the system's folders, where warnings are off.
#include <qcustomplot.h>

#include <QPointer>

#include <vector>

#include "gui/common/cells_item.hpp"
#include "picture/figure/figure.hpp"

namespace sarsim::gui {

/// Draws a figure: panels one below the other with axes, marks, legend and colour bar, in the colours of the palette.
/// Of an image with more cells than pixels each pixel shows the strongest of its cells.
/// Where an image has metres along both axes and one side is at most three times the other, a metre is as long on both.
class FigurePlot : public QCustomPlot {
  Q_OBJECT

 public:
  explicit FigurePlot(QWidget* parent = nullptr);

  /// Draws another figure.
  void set_figure(const picture::Figure& figure);
  [[nodiscard]] const picture::Figure& figure() const { return figure_; }

  /// Where panel `index` is drawn.
  [[nodiscard]] QCPAxisRect* panel(std::size_t index) const { return panels_.at(index); }

  /// Writes the figure, as large as a window of `size` and in its colours, to a file (picture::write_picture): PNG with
  /// `scale` dots for each pixel, SVG or PDF, as the name ends. False with words in `failure` where the name ends
  /// otherwise or the file cannot be written whole; then what stood there is left as it was.
  bool save(const QString& path, QSize size, double scale, QString& failure);

 signals:
  /// The left button was pressed, or moved while it is down, over panel `index`, at this place of its axes.
  void pressed_at(std::size_t index, double x, double y);

 protected:
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void rebuild();
  void tell_place(const QMouseEvent& event);
  [[nodiscard]] bool has_frame_of(const picture::Figure& figure) const;
  void add_text(int row, const QString& text, bool bold);
  void add_panel(int row, const picture::FigurePanel& panel);
  void add_axis(QCPAxis* axis, const picture::FigureAxis& described, double spacing_px);
  void add_twin(QCPAxis* axis, const picture::FigureAxis& described, double spacing_px);
  void add_curve(QCPAxisRect* rect, const picture::FigureCurve& curve);
  void add_mark(QCPAxisRect* rect, const picture::FigureMark& mark);
  void add_ring(QCPAxisRect* rect, const picture::FigureMark& mark);
  void add_legend(QCPAxisRect* rect, const picture::FigurePanel& panel);
  void add_colour_bar(int row, QCPAxisRect* rect, const picture::FigureColourBar& bar);
  void dress(QCPAxis* axis);
  void keep_scales();
  [[nodiscard]] QColor ink(picture::Role role) const;

  picture::Figure figure_;
  std::vector<QPointer<QCPAxisRect>> panels_;
  std::vector<CellsItem*> images_;  // one for each panel; null where it has none
};

/// Asks for a name, `suggested` at first, and writes a figure as it would look in a window like `parent`. A failure is
/// told in a message.
void ask_and_save_picture(QWidget& parent, const picture::Figure& figure, const QString& suggested);

}  // namespace sarsim::gui
