#pragma once

#include <QPersistentModelIndex>
#include <QStyledItemDelegate>

#include "gui/common/session.hpp"

namespace sarsim::gui {

/// Edits a cell of the table of targets: choices and platforms from a list, everything else as text. A text that was
/// refused stands in the cell's editor when it is opened again.
class TargetTableDelegate : public QStyledItemDelegate {
  Q_OBJECT

 public:
  explicit TargetTableDelegate(Session& session, QObject* parent = nullptr);

  /// The text stands in the cell's editor when it is opened again.
  void remember_refused(const QModelIndex& cell, const QString& text);

  QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  void setEditorData(QWidget* editor, const QModelIndex& index) const override;
  void setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const override;

 private:
  Session& session_;
  mutable QPersistentModelIndex refused_cell_;
  mutable QString refused_text_;
};

}  // namespace sarsim::gui
