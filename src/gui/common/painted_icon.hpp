#pragma once

#include <QIconEngine>
#include <QPainter>
#include <QPixmap>

namespace sarsim::gui {

/// An icon that is painted whenever it is wanted, at any size: what derives from it paints, and copies itself.
class PaintedIcon : public QIconEngine {
 public:
  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
    QPixmap pixmap(size);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    paint(&painter, QRect(QPoint(0, 0), size), mode, state);
    return pixmap;
  }
};

}  // namespace sarsim::gui
