#include "gui/common/cell_delegate.hpp"

#include <QComboBox>
#include <QLineEdit>

namespace sarsim::gui {

void CellDelegate::remember_refused(const QModelIndex& cell, const QString& text) {
  refused_cell_ = cell;
  refused_text_ = text;
}

QWidget* CellDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem&, const QModelIndex& index) const {
  const QStringList choices = index.data(choices_role).toStringList();
  QWidget* editor = nullptr;
  if (choices.isEmpty()) {
    editor = new QLineEdit(parent);
  } else {
    auto* box = new QComboBox(parent);
    box->addItems(choices);
    if (const QString now = index.data(Qt::EditRole).toString(); !choices.contains(now)) box->addItem(now);
    editor = box;
  }
  editor->setObjectName("cell_editor");
  editor->setAccessibleName(index.model()->headerData(index.column(), Qt::Horizontal).toString());
  return editor;
}

void CellDelegate::setEditorData(QWidget* editor, const QModelIndex& index) const {
  const QString value = index.data(Qt::EditRole).toString();
  if (auto* box = qobject_cast<QComboBox*>(editor)) return box->setCurrentIndex(box->findText(value));
  auto* edit = qobject_cast<QLineEdit*>(editor);
  // What is being typed stays when other things of the scene change.
  if (edit == nullptr || edit->isModified()) return;
  if (refused_cell_ != index) {
    edit->setText(value);
    return;
  }
  edit->setText(refused_text_);
  edit->setModified(true);
  refused_cell_ = QModelIndex();
}

void CellDelegate::setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const {
  const auto* box = qobject_cast<const QComboBox*>(editor);
  const auto* edit = qobject_cast<const QLineEdit*>(editor);
  model->setData(index, box != nullptr ? box->currentText() : edit->text(), Qt::EditRole);
}

}  // namespace sarsim::gui
