#include <QGridLayout>
#include <QGroupBox>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

#include "gui/common/field_editor.hpp"
#include "gui/common/problem_line.hpp"
#include "gui/objects/property_panel.hpp"

// How the page of fields of one kind of object is put together.

namespace sarsim::gui {

namespace {

QString fold_key(const PanelSubject& subject, const QString& group) {
  const std::string_view kind = subject.kind() ? scene::name_of(*subject.kind()) : "options";
  return QString::fromUtf8(kind.data(), static_cast<qsizetype>(kind.size())) + '/' + group;
}

}  // namespace

void PropertyPanel::rebuild() {
  if (page_ != nullptr) {
    // What is still typed there is not meant for what is shown next.
    for (const auto& [id, editor] : editors_) editor->disconnect(this);
    // Out of the tree at once, so that nobody finds its fields; deleted later, because one of them may be sending.
    page_->hide();
    page_->setParent(nullptr);
    page_->deleteLater();
  }
  groups_.clear();
  editors_.clear();
  page_ = new QWidget;
  page_layout_ = new QVBoxLayout(page_);
  page_layout_->setContentsMargins(0, 0, 0, 0);
  for (const scene::Field& field : subject_.fields()) {
    Group& group = group_named(QString::fromStdString(field.group));
    FieldEditor* editor =
        field.kind == scene::FieldKind::list ? new ListField(field, group.box) : make_field_editor(field, group.box);
    group.editors.push_back(editor);
    editors_[editor->id()] = editor;
    connect_editor(editor);
  }
  for (Group& group : groups_) build_group(group);
  align_labels();
  order_tabs();
  layout_->insertWidget(layout_->indexOf(problems_) + 1, page_);
  page_->show();
}

PropertyPanel::Group& PropertyPanel::group_named(const QString& name) {
  const auto found = std::ranges::find(groups_, name, &Group::name);
  if (found != groups_.end()) return *found;
  Group group;
  group.name = name;
  group.box = new QGroupBox(QString(name).replace('&', QStringLiteral("&&")), page_);
  group.box->setObjectName("group_" + name);
  group.grid = new QGridLayout(group.box);
  group.grid->setColumnStretch(1, 1);
  page_layout_->addWidget(group.box);
  return groups_.emplace_back(std::move(group));
}

// First the fields that everybody needs, then the fold, then the others.
void PropertyPanel::build_group(Group& group) {
  for (FieldEditor* editor : group.editors)
    if (!editor->field().rare) add_row(group, editor);
  if (std::ranges::none_of(group.editors, [](const FieldEditor* editor) { return editor->field().rare; })) return;
  group.more = new QToolButton(group.box);
  group.more->setObjectName("more_" + group.name);
  const bool whole = std::ranges::all_of(group.editors, [](const FieldEditor* editor) { return editor->field().rare; });
  group.more->setText(whole ? group.box->title() : tr("More"));
  group.more->setAccessibleName(tr("More of %1").arg(group.name));
  // A group that is rarely needed as a whole takes one line.
  if (whole) group.box->setTitle(QString());
  group.more->setToolTip(tr("Fields that are rarely needed"));
  group.more->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  group.more->setAutoRaise(true);
  group.more->setCheckable(true);
  group.more->setFocusPolicy(Qt::StrongFocus);
  group.grid->addWidget(group.more, group.grid->rowCount(), 0, 1, 2, Qt::AlignLeft);
  for (FieldEditor* editor : group.editors)
    if (editor->field().rare) add_row(group, editor);
  const bool open = unfolded_.contains(fold_key(subject_, group.name));
  group.more->setChecked(open);
  group.more->setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
  connect(group.more, &QToolButton::toggled, this,
          [this, name = group.name](bool now_open) { fold(group_named(name), now_open); });
}

// Fields of all groups begin at the same place.
void PropertyPanel::align_labels() {
  int width = 0;
  for (const auto& [id, editor] : editors_)
    if (editor->label() != nullptr) width = std::max(width, editor->label()->sizeHint().width());
  // Long words go into two lines, so that a narrow panel needs no bar to scroll sideways.
  const int most = fontMetrics().averageCharWidth() * 18;
  for (const auto& [id, editor] : editors_)
    if (auto* label = qobject_cast<QLabel*>(editor->label()); label != nullptr && label->sizeHint().width() > most)
      label->setWordWrap(true);
  for (const Group& group : groups_) group.grid->setColumnMinimumWidth(0, std::min(width, most));
}

// Tab goes from row to row as the eye does, whatever order the widgets were made in.
void PropertyPanel::order_tabs() {
  std::vector<QWidget*> order;
  const auto add = [&order](const Group& group, bool rare) {
    for (const FieldEditor* editor : group.editors)
      if (editor->field().rare == rare) order.push_back(editor->widget());
  };
  for (const Group& group : groups_) {
    add(group, false);
    if (group.more != nullptr) order.push_back(group.more);
    add(group, true);
  }
  for (std::size_t i = 1; i < order.size(); ++i) QWidget::setTabOrder(order[i - 1], order[i]);
}

void PropertyPanel::fold(Group& group, bool open) {
  const QString key = fold_key(subject_, group.name);
  if (open)
    unfolded_.insert(key);
  else
    unfolded_.erase(key);
  group.more->setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
  arrange();
}

void PropertyPanel::add_row(Group& group, FieldEditor* editor) {
  const int row = group.grid->rowCount();
  if (editor->label() != nullptr) {
    group.grid->addWidget(editor->label(), row, 0);
    group.grid->addWidget(editor->widget(), row, 1);
  } else {
    group.grid->addWidget(editor->widget(), row, 0, 1, 2);
  }
  if (editor->result() != nullptr) group.grid->addWidget(editor->result(), row + 1, 1);
  group.grid->addWidget(editor->problem_line(), row + 2, 0, 1, 2);
}

void PropertyPanel::connect_editor(FieldEditor* editor) {
  connect(editor, &FieldEditor::entered, this, [this, editor](const QString& text) { apply(editor, text, false); });
  connect(editor, &FieldEditor::stepped, this, [this, editor](const QString& text) { apply(editor, text, true); });
  connect(editor, &FieldEditor::retyped, this, [this, editor](const QString& text) { judge(editor, text); });
  connect(editor, &FieldEditor::reset_wanted, this, [this, editor] { reset(editor); });
  if (auto* const list = qobject_cast<ListField*>(editor))
    connect(list, &ListField::entries_changed, this,
            [this, list](const EntryChange& change) { apply_entries(list, change); });
  connect(editor, &FieldEditor::left, this, [this] { session_.end_run(); });
  connect(editor, &FieldEditor::opened, this, [this, editor] {
    if (subject_.single()) emit function_requested(subject_.ids().front(), editor->id());
  });
}

}  // namespace sarsim::gui
