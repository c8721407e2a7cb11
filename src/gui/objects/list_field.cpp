#include "gui/objects/list_field.hpp"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QScrollBar>
#include <QTimer>
#include <QVBoxLayout>

#include <algorithm>

#include "gui/common/cell_delegate.hpp"
#include "scene/schema/expression.hpp"

namespace sarsim::gui {

namespace {

// Of a list with more entries the table scrolls.
constexpr int max_rows_shown = 8;

QTableView* make_view(const scene::Field& field, QWidget* parent) {
  auto* view = new QTableView(parent);
  view->setObjectName(QString::fromStdString("entries_" + field.id));
  view->setAccessibleName(QString::fromStdString(field.label));
  view->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed |
                        QAbstractItemView::AnyKeyPressed);
  view->setSelectionMode(QAbstractItemView::SingleSelection);
  view->setWordWrap(false);
  view->verticalHeader()->setDefaultSectionSize(view->fontMetrics().height() * 3 / 2);
  return view;
}

}  // namespace

ListField::ListField(const scene::Field& field, QWidget* parent)
    : FieldEditor(field, parent),
      widget_(new QWidget(parent)),
      view_(make_view(field, widget_)),
      model_(new ListModel(field, this)),
      delegate_(new CellDelegate(view_)) {
  describe(widget_, false);
  widget_->setFocusProxy(view_);
  view_->setModel(model_);
  view_->setItemDelegate(delegate_);
  auto* title = new QLabel(QString::fromStdString(field.label), widget_);
  title->setBuddy(view_);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(title, 1);
  add_ = add_button("add_", tr("Add"), tr("Put an entry behind the current one"), &ListField::add);
  remove_ = add_button("remove_", tr("Remove"), tr("Take the current entry away"), &ListField::remove);
  up_ = add_button("up_", tr("Up"), tr("Move the current entry towards the beginning"), &ListField::move_up);
  down_ = add_button("down_", tr("Down"), tr("Move the current entry towards the end"), &ListField::move_down);
  for (QToolButton* button : {add_, remove_, up_, down_}) buttons->addWidget(button);
  auto* layout = new QVBoxLayout(widget_);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addLayout(buttons);
  layout->addWidget(view_);
  connect(model_, &ListModel::typed, this, &ListField::cell_typed);
  connect(view_->selectionModel(), &QItemSelectionModel::currentChanged, this, &ListField::enable_buttons);
  arrange();
}

QToolButton* ListField::add_button(const QString& name, const QString& text, const QString& tip,
                                   void (ListField::*press)()) {
  auto* button = new QToolButton(widget_);
  button->setObjectName(name + id());
  button->setText(text);
  button->setToolTip(tip);
  button->setAccessibleName(tr("%1: %2").arg(QString::fromStdString(field().label), text));
  button->setFocusPolicy(Qt::StrongFocus);
  connect(button, &QToolButton::clicked, this, press);
  return button;
}

void ListField::show_entries(const std::optional<scene::AnyObject>& object) {
  const QModelIndex current = view_->currentIndex();
  const int row = current.row();
  const int column = current.column();
  model_->show(object);
  if (!view_->currentIndex().isValid() && row >= 0 && model_->rowCount() > 0)
    view_->setCurrentIndex(model_->index(std::min(row, model_->rowCount() - 1), column));
  arrange();
}

void ListField::restore() {
  model_->drop_typing();
  FieldEditor::restore();
}

// Columns that mean something, and as many rows as there are entries.
void ListField::arrange() {
  for (int column = 0; column < model_->columnCount(); ++column)
    view_->setColumnHidden(column, !model_->means_something(column));
  view_->resizeColumnsToContents();
  const int rows = std::clamp(model_->rowCount(), 1, max_rows_shown);
  const int height = view_->horizontalHeader()->sizeHint().height() +
                     rows * view_->verticalHeader()->defaultSectionSize() +
                     view_->horizontalScrollBar()->sizeHint().height() + 2 * view_->frameWidth();
  if (view_->minimumHeight() != height) view_->setFixedHeight(height);
  enable_buttons();
}

void ListField::enable_buttons() {
  const int row = view_->currentIndex().row();
  remove_->setEnabled(row >= 0);
  up_->setEnabled(row > 0);
  down_->setEnabled(row >= 0 && row + 1 < model_->rowCount());
}

void ListField::cell_typed(const QModelIndex& cell, const QString& text) {
  typed_cell_ = cell;
  typed_text_ = text;
  const auto entry = static_cast<std::size_t>(cell.row());
  emit entries_changed([list = field(), entry, column = model_->field_at(cell.column()).id, typed = text.toStdString()](
                           scene::AnyObject& object, const scene::LetNames* names) {
    return scene::set_entry(object, list, entry, column, typed, names);
  });
  typed_cell_ = QPersistentModelIndex();
}

void ListField::show_failure(const QString& sentence) {
  FieldEditor::show_failure(sentence);
  if (!typed_cell_.isValid()) return;
  delegate_->remember_refused(typed_cell_, typed_text_);
  QTimer::singleShot(0, this, [this, again = typed_cell_] {
    if (again.isValid() && view_->currentIndex() == again) view_->edit(again);
  });
}

void ListField::add() {
  const QModelIndex current = view_->currentIndex();
  const int at = current.isValid() ? current.row() + 1 : model_->rowCount();
  emit entries_changed([list = field(), at](scene::AnyObject& object, const scene::LetNames*) {
    scene::add_entry(object, list, static_cast<std::size_t>(at));
    return std::string();
  });
  if (at < model_->rowCount()) view_->setCurrentIndex(model_->index(at, std::max(0, current.column())));
}

void ListField::remove() {
  const int row = view_->currentIndex().row();
  if (row < 0) return;
  emit entries_changed([list = field(), row](scene::AnyObject& object, const scene::LetNames*) {
    scene::remove_entry(object, list, static_cast<std::size_t>(row));
    return std::string();
  });
}

void ListField::move(int by) {
  const QModelIndex current = view_->currentIndex();
  const int to = current.row() + by;
  if (!current.isValid() || to < 0 || to >= model_->rowCount()) return;
  emit entries_changed([list = field(), row = current.row(), to](scene::AnyObject& object, const scene::LetNames*) {
    scene::move_entry(object, list, static_cast<std::size_t>(row), static_cast<std::size_t>(to));
    return std::string();
  });
  view_->setCurrentIndex(model_->index(to, current.column()));
}

}  // namespace sarsim::gui
