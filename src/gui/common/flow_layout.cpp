#include "gui/common/flow_layout.hpp"

#include <algorithm>

namespace sarsim::gui {

FlowLayout::FlowLayout(QWidget* parent) : QLayout(parent) {
  setContentsMargins(0, 0, 0, 0);
  setSpacing(4);
}

FlowLayout::~FlowLayout() {
  while (QLayoutItem* item = takeAt(0)) delete item;
}

QLayoutItem* FlowLayout::takeAt(int index) {
  return index >= 0 && index < items_.size() ? items_.takeAt(index) : nullptr;
}

void FlowLayout::setGeometry(const QRect& rect) {
  QLayout::setGeometry(rect);
  place(rect, true);
}

// All in one row.
QSize FlowLayout::sizeHint() const {
  QSize size(0, 0);
  for (const QLayoutItem* item : items_)
    if (!item->isEmpty()) {
      const QSize hint = item->sizeHint();
      size = {size.width() + (size.width() > 0 ? spacing() : 0) + hint.width(), std::max(size.height(), hint.height())};
    }
  return size;
}

QSize FlowLayout::minimumSize() const {
  QSize size(0, 0);
  for (const QLayoutItem* item : items_)
    if (!item->isEmpty()) size = size.expandedTo(item->minimumSize());
  return size;
}

int FlowLayout::place(const QRect& rect, bool really) const {
  int x = rect.x();
  int y = rect.y();
  int height = 0;
  for (QLayoutItem* item : items_) {
    if (item->isEmpty()) continue;
    const QSize hint = item->sizeHint();
    if (x > rect.x() && x + hint.width() > rect.right() + 1) {
      x = rect.x();
      y += height + spacing();
      height = 0;
    }
    if (really) item->setGeometry(QRect(QPoint(x, y), hint));
    x += hint.width() + spacing();
    height = std::max(height, hint.height());
  }
  return y + height - rect.y();
}

}  // namespace sarsim::gui
