#pragma once

#include <QStyledItemDelegate>

namespace sarsim::gui {

/// Shows a check mark as an eye: open where the object is drawn, half closed where some of it is, faint and struck
/// through where it is hidden. A click or Space changes it as it does a check box.
class EyeDelegate : public QStyledItemDelegate {
  Q_OBJECT

 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
};

}  // namespace sarsim::gui
