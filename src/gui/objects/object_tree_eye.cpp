#include "gui/objects/object_tree_eye.hpp"

#include <QApplication>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>

namespace sarsim::gui {

namespace {

// In a square of 16 units.
void draw_eye(QPainter& painter, Qt::CheckState state, const QColor& colour) {
  const auto pen = [&](double width) { return QPen(colour, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin); };
  QPainterPath lids(QPointF(1.5, 8));
  lids.quadTo(8, 1.5, 14.5, 8);
  lids.quadTo(8, 14.5, 1.5, 8);
  painter.setPen(pen(1.2));
  painter.setBrush(Qt::NoBrush);
  painter.drawPath(lids);
  if (state == Qt::Unchecked) return painter.drawLine(QPointF(3, 13.5), QPointF(13, 2.5));
  painter.setPen(Qt::NoPen);
  painter.setBrush(state == Qt::Checked ? QBrush(colour) : QBrush(Qt::NoBrush));
  if (state == Qt::PartiallyChecked) painter.setPen(pen(1.0));
  painter.drawEllipse(QPointF(8, 8), 2.2, 2.2);
}

}  // namespace

void EyeDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
  QStyleOptionViewItem item = option;
  initStyleOption(&item, index);
  const QStyle* style = item.widget != nullptr ? item.widget->style() : QApplication::style();
  const bool checkable = item.features.testFlag(QStyleOptionViewItem::HasCheckIndicator);
  const QRect box = style->subElementRect(QStyle::SE_ItemViewItemCheckIndicator, &item, item.widget);
  item.features &= ~QStyleOptionViewItem::HasCheckIndicator;
  style->drawControl(QStyle::CE_ItemViewItem, &item, painter, item.widget);
  if (!checkable) return;
  const bool chosen = item.state.testFlag(QStyle::State_Selected);
  const QPalette::ColorRole role = chosen                             ? QPalette::HighlightedText
                                   : item.checkState == Qt::Unchecked ? QPalette::PlaceholderText
                                                                      : QPalette::Text;
  const double side = std::min(box.width(), box.height());
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  painter->translate(box.center().x() + 0.5 - 0.5 * side, box.center().y() + 0.5 - 0.5 * side);
  painter->scale(side / 16.0, side / 16.0);
  draw_eye(*painter, item.checkState, item.palette.color(role));
  painter->restore();
}

}  // namespace sarsim::gui
