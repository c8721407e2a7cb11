#include "gui/objects/target_table_delegate.hpp"

#include <QComboBox>
#include <QLineEdit>

#include "gui/objects/target_table_model.hpp"

namespace sarsim::gui {

TargetTableDelegate::TargetTableDelegate(Session& session, QObject* parent)
    : QStyledItemDelegate(parent), session_(session) {}

void TargetTableDelegate::remember_refused(const QModelIndex& cell, const QString& text) {
  refused_cell_ = cell;
  refused_text_ = text;
}

QWidget* TargetTableDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem&,
                                           const QModelIndex& index) const {
  const auto* model = qobject_cast<const TargetTableModel*>(index.model());
  const scene::Field& field = model->field_at(index.column());
  QStringList choices;
  for (const std::string& choice : field.choices) choices += QString::fromStdString(choice);
  if (field.kind == scene::FieldKind::platform)
    for (const scene::Platform& platform : session_.scene().platforms) choices += QString::fromStdString(platform.name);
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
  editor->setAccessibleName(QString::fromStdString(field.label));
  return editor;
}

void TargetTableDelegate::setEditorData(QWidget* editor, const QModelIndex& index) const {
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

void TargetTableDelegate::setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const {
  const auto* box = qobject_cast<const QComboBox*>(editor);
  const auto* edit = qobject_cast<const QLineEdit*>(editor);
  model->setData(index, box != nullptr ? box->currentText() : edit->text(), Qt::EditRole);
}

}  // namespace sarsim::gui
