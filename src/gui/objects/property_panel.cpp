#include "gui/objects/property_panel.hpp"

#include <QGridLayout>
#include <QGroupBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPointer>
#include <QScopedValueRollback>
#include <QTableWidget>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

#include <fmt/format.h>

#include "core/text/number_text.hpp"
#include "gui/common/field_editor.hpp"
#include "gui/common/problem_line.hpp"
#include "gui/common/text.hpp"

namespace sarsim::gui {

namespace {

// Figures that follow the time need not be newer than an eye sees.
constexpr int derived_delay_ms = 40;

// With this delay a timer fires after what it was started among.
constexpr int after_painting_ms = 20;

std::string merge_key_of(const PanelSubject& subject, const scene::Field& field) {
  std::string key = "step " + field.id;
  if (subject.kind()) {
    const scene::ObjectId first = subject.ids().front();
    key += fmt::format(" of {} {} and {} more", scene::name_of(first.kind), first.index, subject.ids().size() - 1);
  }
  return key;
}

QTableWidget* make_figures(QWidget* parent) {
  auto* table = new QTableWidget(0, 2, parent);
  table->setObjectName("derived_figures");
  table->setAccessibleName(PropertyPanel::tr("Derived values"));
  table->setHorizontalHeaderLabels({PropertyPanel::tr("Value"), PropertyPanel::tr("Figure")});
  table->horizontalHeader()->hide();
  table->verticalHeader()->hide();
  table->verticalHeader()->setDefaultSectionSize(table->fontMetrics().height() * 3 / 2);
  table->horizontalHeader()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
  table->horizontalHeader()->setStretchLastSection(true);
  table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table->setSelectionBehavior(QAbstractItemView::SelectRows);
  table->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  table->setTabKeyNavigation(false);
  table->setWordWrap(false);
  return table;
}

}  // namespace

PropertyPanel::PropertyPanel(Session& session, QWidget* parent) : QScrollArea(parent), session_(session) {
  setObjectName("property_panel");
  setAccessibleName(tr("Properties"));
  setWidgetResizable(true);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setFrameShape(QFrame::NoFrame);

  auto* inside = new QWidget;
  layout_ = new QVBoxLayout(inside);
  title_ = new QLabel(inside);
  title_->setObjectName("panel_title");
  title_->setTextFormat(Qt::PlainText);
  title_->setWordWrap(true);
  QFont bold = title_->font();
  bold.setBold(true);
  title_->setFont(bold);
  remark_ = new QLabel(inside);
  remark_->setObjectName("panel_remark");
  remark_->setWordWrap(true);
  problems_ = new ProblemLine(inside);
  problems_->setObjectName("panel_problems");
  derived_box_ = new QGroupBox(tr("Derived values"), inside);
  derived_ = make_figures(derived_box_);
  (new QVBoxLayout(derived_box_))->addWidget(derived_);
  for (QWidget* widget : std::initializer_list<QWidget*>{title_, remark_, problems_, derived_box_})
    layout_->addWidget(widget);
  layout_->addStretch(1);
  setWidget(inside);

  derived_timer_.setSingleShot(true);
  derived_timer_.setInterval(derived_delay_ms);
  connect(&derived_timer_, &QTimer::timeout, this, &PropertyPanel::fill_derived);
  connect(&session_, &Session::scene_changed, this, &PropertyPanel::follow);
  connect(&session_, &Session::selection_changed, this, &PropertyPanel::refresh_soon);
  debounce_.setSingleShot(true);
  connect(&debounce_, &QTimer::timeout, this, [this] {
    // All windows are painted first.
    if (debounce_.interval() == 0)
      debounce_.start(after_painting_ms);
    else
      refresh();
  });
  connect(&session_, &Session::problems_changed, this, [this] {
    if (committing_ || debounce_.isActive()) return;
    fill_problems();
    arrange();
  });
  connect(&session_, &Session::time_changed, this, [this] {
    if (subject_.single() && !derived_timer_.isActive()) derived_timer_.start();
  });
  connect(&session_, &Session::document_replaced, this, [this] {
    for (const auto& [id, editor] : editors_) editor->restore();
  });
  rebuild();
  refresh();
}

// A field that goes while it has the keyboard says once more that it is finished.
PropertyPanel::~PropertyPanel() {
  for (const auto& [id, editor] : editors_) editor->disconnect(this);
}

// Objects of the kind of the current one; without one, the options.
PanelSubject PropertyPanel::wanted_subject() const {
  const auto current = session_.current();
  if (!current) return PanelSubject(session_.document());
  std::vector<scene::ObjectId> ids;
  for (const scene::ObjectId id : session_.selection())
    if (id.kind == current->kind) ids.push_back(id);
  PanelSubject subject(session_.document(), current->kind, ids);
  if (subject.ids().empty()) return PanelSubject(session_.document());
  return subject;
}

// Many objects take a while, which is spent once the other windows have followed, and once for changes in a row.
void PropertyPanel::refresh_soon() {
  constexpr std::size_t many = 20'000;
  if (session_.selection().size() < many) return refresh();
  debounce_.start(0);
}

// Whether the fields show objects that are no longer as they are shown, or gone.
bool PropertyPanel::is_stale() const { return debounce_.isActive() && !subject_.stands_in(session_.scene()); }

void PropertyPanel::refresh() {
  if (committing_) return;
  debounce_.stop();
  if (PanelSubject wanted = wanted_subject(); !wanted.same_objects(subject_)) {
    const std::uint64_t revision = session_.document().revision();
    commit_pending();
    if (session_.document().revision() != revision) wanted = wanted_subject();
    const bool other_kind = wanted.kind() != subject_.kind();
    subject_ = std::move(wanted);
    if (other_kind)
      rebuild();
    else
      for (const auto& [id, editor] : editors_) editor->restore();
  } else {
    subject_ = std::move(wanted);
  }
  fill();
}

// Fields show their objects and names of others, and what the text says of them, which a change of the text alone may
// concern; problems and figures depend on all of the scene.
void PropertyPanel::follow(const scene::SceneChange& change) {
  if (debounce_.isActive()) return;
  if (shows(change) || change.empty()) return refresh_soon();
  if (!committing_) fill_outlook();
}

bool PropertyPanel::shows(const scene::SceneChange& change) const {
  if (change.concerns_names()) return true;
  if (!subject_.kind()) return change.options || change.everything;
  return std::ranges::any_of(subject_.ids(), [&](scene::ObjectId id) { return change.concerns(id); });
}

// What was typed belongs to the objects that were shown, not to those selected next.
void PropertyPanel::commit_pending() {
  const QScopedValueRollback committing(committing_, true);
  for (const auto& [id, editor] : editors_) {
    if (!editor->pending()) continue;
    if (!subject_.stands_in(session_.scene())) return;
    editor->commit();
    subject_ = PanelSubject(session_.document(), subject_.kind(), subject_.ids());
  }
}

void PropertyPanel::commit() {
  commit_pending();
  refresh();
}

void PropertyPanel::apply(FieldEditor* editor, const QString& text, bool step) {
  if (is_stale()) return refresh();
  const std::string key = step ? merge_key_of(subject_, editor->field()) : std::string();
  const auto change = [kind = subject_.kind(), ids = subject_.ids(), field = editor->field(), text = text.toStdString(),
                       key](const scene::Document& document, scene::Edit& edit) {
    FieldChange made = PanelSubject(document, kind, ids).change(document, field, text, key);
    edit = std::move(made.edit);
    return made.failure;
  };
  const QPointer<FieldEditor> asked = editor;  // Other work may rebuild the panel meanwhile.
  const std::string why = session_.make_and_perform(QString::fromStdString(edit_label("Change", editor->field())),
                                                    subject_.ids().size(), change);
  if (why.empty()) return;
  const QString sentence = QString::fromStdString(why);
  if (committing_) session_.log(core::Severity::warning, tr("Not applied: %1").arg(sentence));
  if (asked && step) asked->refuse_step(sentence);
  if (asked && !step) asked->show_failure(sentence);
}

void PropertyPanel::apply_entries(ListField* editor, const EntryChange& change) {
  if (is_stale()) return refresh();
  FieldChange made = subject_.change_entries(session_.document(), editor->field(), change);
  if (!made.failure.empty()) return editor->show_failure(QString::fromStdString(made.failure));
  editor->clear_failure();
  session_.perform(std::move(made.edit));
}

void PropertyPanel::reset(FieldEditor* editor) {
  if (is_stale()) return refresh();
  editor->restore();
  const auto change = [kind = subject_.kind(), ids = subject_.ids(), field = editor->field()](
                          const scene::Document& document, scene::Edit& edit) {
    edit = PanelSubject(document, kind, ids).reset(document, field);
    return std::string();
  };
  const std::string why = session_.make_and_perform(QString::fromStdString(edit_label("Reset", editor->field())),
                                                    subject_.ids().size(), change);
  if (!why.empty()) session_.log(core::Severity::warning, tr("Not reset: %1").arg(QString::fromStdString(why)));
}

// By the first of many objects, as each key is pressed.
void PropertyPanel::judge(FieldEditor* editor, const QString& text) {
  if (is_stale()) return;
  constexpr std::size_t max_judged = 100;
  std::vector<scene::ObjectId> first = subject_.ids();
  if (first.size() > max_judged) first.resize(max_judged);
  const FieldChange change = PanelSubject(session_.document(), subject_.kind(), first)
                                 .change(session_.document(), editor->field(), text.toStdString());
  if (change.failure.empty())
    editor->clear_failure();
  else
    editor->show_failure(QString::fromStdString(change.failure));
}

void PropertyPanel::fill() {
  title_->setText(QString::fromStdString(subject_.title(session_.scene())));
  const std::size_t selected = session_.selection().size();
  const bool others = subject_.kind() && selected > subject_.ids().size();
  remark_->setVisible(others || !subject_.kind());
  remark_->setText(others ? tr("Other objects are selected as well; only these are changed here.")
                          : tr("They hold for all simulations of the script. Select objects to see their properties."));
  for (const auto& [id, editor] : editors_) {
    fill_choices(editor);
    if (auto* const list = qobject_cast<ListField*>(editor)) list->show_entries(subject_.only_object());
    if (const auto text = subject_.common_text(editor->field().id))
      editor->show(content_of(editor->field(), *text));
    else
      editor->show_different(content_of(editor->field(), "").origin);
  }
  fill_outlook();
}

FieldContent PropertyPanel::content_of(const scene::Field& field, const std::string& value) const {
  FieldContent content{QString::fromStdString(value)};
  const auto typed = subject_.common_typed(field.id);
  if (!typed) return content;
  content.expression = QString::fromStdString(typed->expression);
  content.origin = typed->said ? FieldOrigin::said : FieldOrigin::by_default;
  return content;
}

void PropertyPanel::fill_outlook() {
  fill_problems();
  arrange();
  if (subject_.single())
    derived_timer_.start(0);
  else
    show_figures({});
}

void PropertyPanel::fill_choices(FieldEditor* editor) {
  const scene::FieldKind kind = editor->field().kind;
  if (kind != scene::FieldKind::platform && kind != scene::FieldKind::radar) return;
  QStringList names;
  bool has_earth = false;
  if (kind == scene::FieldKind::radar)
    for (const scene::Radar& radar : session_.scene().radars) names += QString::fromStdString(radar.name);
  else
    for (const scene::Platform& platform : session_.scene().platforms) {
      names += QString::fromStdString(platform.name);
      has_earth = has_earth || core::equal_ignoring_case(platform.name, "Earth");
    }
  // The world itself is known without a definition.
  if (kind == scene::FieldKind::platform && !has_earth) names += QStringLiteral("Earth");
  names.removeDuplicates();
  editor->set_choices(names);
}

void PropertyPanel::fill_problems() {
  std::map<QString, std::vector<core::Problem>> at_field;
  core::Severity worst = core::Severity::note;
  QStringList elsewhere;
  for (const core::Problem& problem : session_.problems()) {
    if (!subject_.concerns(problem.subject)) continue;
    const QString id = QString::fromStdString(subject_.field_of(problem.subject.field));
    if (editors_.contains(id) && subject_.applies(id.toStdString())) {
      at_field[id].push_back(problem);
      continue;
    }
    elsewhere += problem_text(problem);
    worst = std::min(worst, problem.severity);
  }
  for (const auto& [id, editor] : editors_) {
    const auto found = at_field.find(id);
    editor->show_problems(found == at_field.end() ? std::vector<core::Problem>{} : found->second);
  }
  elsewhere.removeDuplicates();
  if (elsewhere.isEmpty())
    problems_->clear();
  else
    problems_->show_texts(worst, elsewhere.mid(0, 5));
}

// Shows the rows that mean something and are not folded away.
void PropertyPanel::arrange() {
  for (const Group& group : groups_) {
    const bool open = group.more == nullptr || group.more->isChecked();
    bool any = false;
    bool any_rare = false;
    for (FieldEditor* editor : group.editors) {
      const bool applies = subject_.applies(editor->field().id);
      any = any || applies;
      any_rare = any_rare || (applies && editor->field().rare);
      editor->set_shown(applies && (!editor->field().rare || open || editor->troubled()));
      const scene::FieldKind kind = editor->field().kind;
      const bool needs_one =
          kind == scene::FieldKind::function || kind == scene::FieldKind::list || editor->id() == "name";
      editor->widget()->setEnabled(subject_.single() || !needs_one || !subject_.kind());
    }
    if (group.more != nullptr) group.more->setVisible(any_rare);
    group.box->setVisible(any);
  }
}

void PropertyPanel::fill_derived() {
  if (!subject_.single() || !scene::has_object(session_.scene(), subject_.ids().front())) return show_figures({});
  show_figures(picture::derived_figures(session_.scene(), subject_.ids().front(), session_.time_s()));
}

void PropertyPanel::show_figures(const std::vector<picture::DerivedFigure>& figures) {
  derived_box_->setVisible(!figures.empty());
  const int rows = static_cast<int>(figures.size());
  if (derived_->rowCount() != rows) derived_->setRowCount(rows);
  for (int row = 0; row < rows; ++row) {
    const picture::DerivedFigure& figure = figures[static_cast<std::size_t>(row)];
    const QString formula = "<p>" + QString::fromStdString(figure.formula).toHtmlEscaped() + "</p>";
    for (int column = 0; column < 2; ++column) {
      QTableWidgetItem* item = derived_->item(row, column);
      if (item == nullptr) derived_->setItem(row, column, item = new QTableWidgetItem);
      item->setText(column == 0 ? text_of(figure.label) : read_out(figure.text));
      item->setToolTip(QStringLiteral("<p><b>%1</b></p>").arg(read_out(figure.text).toHtmlEscaped()) + formula);
      item->setData(Qt::AccessibleDescriptionRole, QString::fromStdString(figure.formula));
    }
  }
  // All rows are shown; it is the panel that scrolls.
  const int height = derived_->verticalHeader()->length() + 2 * derived_->frameWidth();
  if (derived_->minimumHeight() != height) derived_->setFixedHeight(height);
}

FieldEditor* PropertyPanel::editor_of(const QString& id) const {
  const auto found = editors_.find(id);
  return found == editors_.end() ? nullptr : found->second;
}

bool PropertyPanel::focus_field(const QString& id) {
  FieldEditor* editor = editor_of(id);
  if (editor == nullptr || !subject_.applies(id.toStdString())) return false;
  for (Group& group : groups_)
    if (group.more != nullptr && std::ranges::find(group.editors, editor) != group.editors.end() && !editor->shown())
      group.more->setChecked(true);
  editor->widget()->setFocus(Qt::OtherFocusReason);
  if (auto* line = qobject_cast<QLineEdit*>(editor->widget())) line->selectAll();  // The first key replaces it.
  // What was unfolded has its place only when the layout has been made.
  QTimer::singleShot(0, editor, [this, editor] { ensureWidgetVisible(editor->widget()); });
  return true;
}

// The first that is typed into; who stands where is known already when an object is made.
void PropertyPanel::focus_first() {
  FieldEditor* first = nullptr;
  for (const Group& group : groups_)
    for (FieldEditor* editor : group.editors) {
      if (!editor->shown() || !editor->widget()->isEnabled()) continue;
      if (first == nullptr) first = editor;
      if (qobject_cast<QLineEdit*>(editor->widget()) == nullptr) continue;
      focus_field(editor->id());
      return;
    }
  if (first != nullptr) focus_field(first->id());
}

// --- How the page of fields of one kind of object is put together.

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
