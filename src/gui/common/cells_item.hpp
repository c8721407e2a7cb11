#pragma once

// The plot library's header comes from the system's folders, where warnings are off.
#include <qcustomplot.h>

#include "picture/figure/figure.hpp"

namespace sarsim::gui {

/// The image of a figure's panel in a plot, in whole pixels of the screen. Cells stay cells: no colour that no sample
/// has. Where there are more cells than pixels, each pixel shows the strongest of its cells (picture::fitted).
class CellsItem : public QCPAbstractItem {
  Q_OBJECT

 public:
  /// @param rect  whose lower and left axes say where the image is; the plot takes the item
  explicit CellsItem(QCPAxisRect& rect);

  /// Shows another image, where its axes say.
  void show(const picture::FigureImage& image, const std::optional<picture::FigureColourBar>& bar);

  double selectTest(const QPointF& place, bool only_selectable, QVariant* details = nullptr) const override;

 protected:
  void draw(QCPPainter* painter) override;

 private:
  QCPItemPosition* first_;
  QCPItemPosition* last_;
  picture::FigureImage image_;
  std::optional<picture::FigureColourBar> bar_;
  QImage drawn_;  // as it was drawn last, null where that was another image
  QRect dots_;    // of drawn_
};

}  // namespace sarsim::gui
