#pragma once

#include <QFont>
#include <QPainterPath>
#include <QPixmap>

#include <map>
#include <tuple>
#include <vector>

#include "picture/scene/drawing.hpp"

class QPainter;

namespace sarsim::gui {

/// Puts drawings of a scene onto painters; the pictures of its discs and the rims of its words are kept from one
/// drawing to the next.
class ScenePainter {
 public:
  /// What a drawing leaves open.
  struct Look {
    QFont font;                ///< Of words, at its size on the screen.
    double pixel_scale = 1.0;  ///< Device pixels per pixel of the screen.
    bool dark = false;
  };

  /// Paints the background over `area` and the drawing onto it. The painter's unit is a device pixel.
  void paint(QPainter& painter, const QRectF& area, const picture::Drawing& drawing, const Look& look);

 private:
  using DiscKey = std::tuple<picture::Role, float, bool, bool>;  // role, diameter, outlined, dark

  void paint_discs(QPainter& painter, const std::vector<picture::Drawing::Disc>& discs, bool dark);
  const QPixmap& disc_picture(const picture::Drawing::Disc& disc, bool dark);
  void paint_texts(QPainter& painter, const std::vector<picture::Drawing::Text>& texts, const Look& look);
  const QPainterPath& rim_of(const QString& words, const QFont& font, double width_px);

  std::map<DiscKey, QPixmap> disc_pictures_;
  std::map<std::tuple<QString, QString, double>, QPainterPath> rims_;  // by words, font and width
};

}  // namespace sarsim::gui
