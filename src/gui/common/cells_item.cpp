#include "gui/common/cells_item.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "picture/figure/fitted_image.hpp"

namespace sarsim::gui {

namespace {

QImage picture_of(const picture::FigureImage& image) {
  QImage picture(static_cast<int>(image.width), static_cast<int>(image.height), QImage::Format_RGB32);
  for (std::size_t row = 0; row < image.height; ++row) {
    auto* const line = reinterpret_cast<QRgb*>(picture.scanLine(static_cast<int>(row)));
    for (std::size_t column = 0; column < image.width; ++column) {
      const raster::Rgb& cell = image.cells[row * image.width + column];
      line[column] = qRgb(cell.red, cell.green, cell.blue);
    }
  }
  return picture;
}

}  // namespace

CellsItem::CellsItem(QCPAxisRect& rect)
    : QCPAbstractItem(rect.parentPlot()),
      first_(createPosition(QStringLiteral("first"))),
      last_(createPosition(QStringLiteral("last"))) {
  setClipAxisRect(&rect);
  setClipToAxisRect(true);
  for (QCPItemPosition* corner : {first_, last_}) {
    corner->setType(QCPItemPosition::ptPlotCoords);
    corner->setAxisRect(&rect);
    corner->setAxes(rect.axis(QCPAxis::atBottom), rect.axis(QCPAxis::atLeft));
  }
}

void CellsItem::show(const picture::FigureImage& image, const std::optional<picture::FigureColourBar>& bar) {
  image_ = image;
  bar_ = bar;
  drawn_ = {};
  first_->setCoords(image.x_first, image.y_first);
  last_->setCoords(image.x_last, image.y_last);
}

double CellsItem::selectTest(const QPointF& /*place*/, bool /*only_selectable*/, QVariant* /*details*/) const {
  return -1.0;
}

void CellsItem::draw(QCPPainter* painter) {
  const double ratio = painter->device()->devicePixelRatioF();
  const QPointF first = first_->pixelPosition() * ratio;
  const QPointF last = last_->pixelPosition() * ratio;
  const QRect dots = QRect(QRectF(first, last).normalized().topLeft().toPoint(),
                           QRectF(first, last).normalized().bottomRight().toPoint() - QPoint(1, 1));
  if (dots.isEmpty()) return;
  if (drawn_.isNull() || dots != dots_) {
    const picture::FigureImage cells =
        picture::fitted(image_, bar_, static_cast<std::size_t>(dots.width()), static_cast<std::size_t>(dots.height()));
    drawn_ = picture_of(cells)
                 .scaled(dots.size(), Qt::IgnoreAspectRatio, Qt::FastTransformation)
                 .mirrored(last.x() < first.x(), last.y() < first.y());
    drawn_.setDevicePixelRatio(ratio);
    dots_ = dots;
  }
  painter->drawImage(QPointF(dots.topLeft()) / ratio, drawn_);
}

}  // namespace sarsim::gui
