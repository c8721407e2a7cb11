#pragma once

#include <QPersistentModelIndex>
#include <QStyledItemDelegate>

namespace sarsim::gui {

/// The role in which a model tells what a cell can be chosen from, a QStringList; nothing where it is typed.
inline constexpr int choices_role = Qt::UserRole + 1;

/// Edits a cell of a table: choices from a list, everything else as text. A text that was refused stands in the cell's
/// editor when it is opened again.
class CellDelegate : public QStyledItemDelegate {
  Q_OBJECT

 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  /// The text stands in the cell's editor when it is opened again.
  void remember_refused(const QModelIndex& cell, const QString& text);

  QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  void setEditorData(QWidget* editor, const QModelIndex& index) const override;
  void setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const override;

 private:
  mutable QPersistentModelIndex refused_cell_;
  mutable QString refused_text_;
};

}  // namespace sarsim::gui
