#pragma once

// The plot library's header comes from the system's folders, where warnings are off.
#include <qcustomplot.h>

namespace sarsim::gui {

/// Words above or below the panels of a figure. They ask for no width: what is longer than a line goes on in the next,
/// and what is longer than three lines ends with dots, so that long titles leave the picture its room.
class FigureText : public QCPTextElement {
  Q_OBJECT

 public:
  /// Belongs to the plot once it has a place in its layout.
  FigureText(QCustomPlot* plot, const QString& text, const QFont& font);

 protected:
  void draw(QCPPainter* painter) override;
  [[nodiscard]] QSize minimumOuterSizeHint() const override;
  [[nodiscard]] QSize maximumOuterSizeHint() const override;

 private:
  [[nodiscard]] QString fitting(int width_px) const;
  [[nodiscard]] int height_px(int width_px) const;
  [[nodiscard]] int width_px() const;
};

}  // namespace sarsim::gui
