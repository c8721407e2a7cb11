#include "gui/objects/target_table.hpp"

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QTableView>
#include <QTimer>
#include <QVBoxLayout>

#include <algorithm>
#include <set>

#include "gui/common/cell_delegate.hpp"
#include "gui/common/help_button.hpp"
#include "gui/common/problem_line.hpp"
#include "gui/common/shown_selection.hpp"
#include "gui/objects/import_dialog.hpp"
#include "gui/objects/target_table_model.hpp"
#include "scene/edit/edit.hpp"
#include "scene/edit/import_targets.hpp"

namespace sarsim::gui {

namespace {

QPushButton* make_button(QWidget* parent, const char* name, const QString& text, const QString& tooltip) {
  auto* button = new QPushButton(text, parent);
  button->setObjectName(name);
  button->setToolTip(tooltip);
  button->setAutoDefault(false);
  return button;
}

QTableView* make_view(TargetTableModel* model, QWidget* parent) {
  auto* view = new QTableView(parent);
  view->setObjectName("target_cells");
  view->setAccessibleName(TargetTable::tr("Table of targets"));
  view->setModel(model);
  view->setItemDelegate(new CellDelegate(view));
  view->setSelectionMode(QAbstractItemView::ExtendedSelection);
  view->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed |
                        QAbstractItemView::AnyKeyPressed);
  view->setAlternatingRowColors(true);
  view->setWordWrap(false);
  // Some rows are measured, not all: of a view that is not seen yet 0, "what is visible", means all of them.
  view->horizontalHeader()->setResizeContentsPrecision(60);
  view->horizontalHeader()->setSectionResizeMode(QHeaderView::Interactive);
  view->horizontalHeader()->setSortIndicator(-1,
                                             Qt::AscendingOrder);  // As the scene has them, until a heading is clicked.
  view->horizontalHeader()->setSortIndicatorClearable(true);
  view->setSortingEnabled(true);
  view->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  view->verticalHeader()->setDefaultSectionSize(view->fontMetrics().height() * 3 / 2);
  view->resizeColumnsToContents();
  return view;
}

}  // namespace

TargetTable::TargetTable(Session& session, QWidget* parent)
    : QWidget(parent), session_(session), model_(new TargetTableModel(session, this)) {
  setObjectName("target_table");
  make_widgets();
  connect_all();
  fill_platforms();
  show_selection();
  update_buttons();
}

// Views tell of changes while they go.
TargetTable::~TargetTable() {
  view_->selectionModel()->disconnect(this);
  model_->disconnect(this);
}

void TargetTable::make_widgets() {
  platform_ = new QComboBox(this);
  platform_->setObjectName("table_platform");
  platform_->setAccessibleName(tr("Platform whose targets are shown"));
  auto* platform_label = new QLabel(tr("P&latform:"), this);
  platform_label->setBuddy(platform_);
  fill_value_ = new QLineEdit(this);
  fill_value_->setObjectName("fill_value");
  fill_value_->setAccessibleName(tr("Value for all selected cells"));
  fill_value_->setPlaceholderText(tr("3 km, 10 dBsm, Isotropic"));
  auto* fill_label = new QLabel(tr("&Value:"), this);
  fill_label->setBuddy(fill_value_);
  fill_ = make_button(this, "fill_cells", tr("&Fill selected cells"), tr("Gives all selected cells this value"));
  add_ = make_button(this, "add_target", tr("&Add target"), tr("Adds a target at the origin of its platform"));
  delete_ = make_button(this, "delete_targets", tr("&Delete targets"), tr("Deletes the targets of the selected cells"));
  copy_ = make_button(this, "copy_targets", tr("&Copy"), tr("Copies the targets of the selected cells (Ctrl+C)"));
  paste_ = make_button(this, "paste_targets", tr("&Paste"),
                       tr("Adds the targets on the clipboard: columns x, y, z and, if there is one, RCS (Ctrl+V)"));
  import_ = make_button(this, "import_targets", tr("&Import..."), tr("Adds targets from a text or CSV file"));
  view_ = make_view(model_, this);
  view_->installEventFilter(this);
  message_ = new ProblemLine(this);
  message_->setObjectName("table_message");

  auto* top = new QHBoxLayout;
  for (QWidget* widget : std::initializer_list<QWidget*>{platform_label, platform_, fill_label, fill_value_, fill_})
    top->addWidget(widget);
  top->setStretchFactor(fill_value_, 1);
  auto* bottom = new QHBoxLayout;
  for (QPushButton* button : {add_, delete_, copy_, paste_, import_}) bottom->addWidget(button);
  bottom->addStretch(1);
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(top);
  layout->addWidget(view_, 1);
  layout->addWidget(message_);
  layout->addLayout(bottom);
}

void TargetTable::connect_all() {
  connect(platform_, &QComboBox::currentIndexChanged, this, [this](int index) {
    if (showing_ || index < 0) return;
    const QVariant name = platform_->itemData(index);
    model_->set_platform(name.isValid() ? std::optional(name.toString().toStdString()) : std::nullopt);
  });
  connect(fill_, &QPushButton::clicked, this, [this] { fill_selection(fill_value_->text()); });
  connect(fill_value_, &QLineEdit::returnPressed, this, [this] { fill_selection(fill_value_->text()); });
  connect(add_, &QPushButton::clicked, this, &TargetTable::add_target);
  connect(delete_, &QPushButton::clicked, this, &TargetTable::delete_targets);
  connect(copy_, &QPushButton::clicked, this, &TargetTable::copy);
  connect(paste_, &QPushButton::clicked, this, &TargetTable::paste);
  connect(import_, &QPushButton::clicked, this, &TargetTable::import_file);
  connect(model_, &TargetTableModel::refused, this, &TargetTable::cell_refused);
  connect(model_, &QAbstractItemModel::modelReset, this, [this] {
    show_selection();
    update_buttons();
  });
  connect(view_->selectionModel(), &QItemSelectionModel::selectionChanged, this, [this] {
    take_selection();
    update_buttons();
  });
  connect(&session_, &Session::selection_changed, this, &TargetTable::show_selection);
  connect(&session_, &Session::scene_changed, this, [this](const scene::SceneChange& change) {
    message_->clear();
    if (change.concerns(scene::ObjectKind::platform)) fill_platforms();
  });
}

void TargetTable::fill_platforms() {
  QStringList names;
  for (const scene::Platform& platform : session_.scene().platforms) names += QString::fromStdString(platform.name);
  QStringList shown;
  for (int i = 1; i < platform_->count(); ++i) shown += platform_->itemText(i);
  if (platform_->count() > 0 && shown == names) return;
  const QScopedValueRollback telling(showing_, true);
  platform_->clear();
  platform_->addItem(tr("All platforms"));
  for (const QString& name : names) platform_->addItem(name, name);
  const int kept = model_->platform() ? platform_->findData(QString::fromStdString(*model_->platform())) : 0;
  platform_->setCurrentIndex(std::max(kept, 0));
  if (kept < 0) model_->set_platform(std::nullopt);
}

std::vector<scene::ObjectId> TargetTable::selected_targets() const {
  std::vector<scene::ObjectId> targets;
  for (const QItemSelectionRange& range : view_->selectionModel()->selection())
    for (int row = range.top(); row <= range.bottom(); ++row) targets.push_back(model_->target_at(row));
  std::ranges::sort(targets);
  const auto twice = std::ranges::unique(targets);
  targets.erase(twice.begin(), twice.end());
  return targets;
}

void TargetTable::take_selection() {
  if (showing_) return;
  const std::vector<scene::ObjectId> targets = selected_targets();
  const QScopedValueRollback telling(showing_, true);
  if (!targets.empty()) session_.select({targets.begin(), targets.end()});
}

// Marks the rows of targets that were selected elsewhere; cells selected here stay as they are. While the table is
// hidden that waits until it is shown.
void TargetTable::show_selection() {
  if (showing_) return;
  stale_ = !isVisible();
  if (stale_) return;
  std::vector<int> rows;
  for (const scene::ObjectId id : session_.selection())
    if (const int row = model_->row_of(id); row >= 0) rows.push_back(row);
  std::ranges::sort(rows);
  const QScopedValueRollback telling(showing_, true);
  QItemSelection selection;
  for (std::size_t i = 0; i < rows.size();) {
    std::size_t end = i + 1;
    while (end < rows.size() && rows[end] == rows[end - 1] + 1) ++end;
    selection.append(
        QItemSelectionRange(model_->index(rows[i], 0), model_->index(rows[end - 1], model_->columnCount() - 1)));
    i = end;
  }
  show_selected(*view_, selection);
  if (!rows.empty()) view_->scrollTo(model_->index(rows.front(), 0));
}

void TargetTable::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (stale_) show_selection();
}

void TargetTable::update_buttons() {
  const bool any = view_->selectionModel()->hasSelection();
  for (QPushButton* button : {fill_, delete_, copy_}) button->setEnabled(any);
}

void TargetTable::say(core::Severity severity, const QStringList& texts) {
  constexpr qsizetype most = 4;
  QStringList shown = texts.mid(0, most);
  if (texts.size() > most) shown += tr("and %1 more").arg(texts.size() - most);
  message_->show_texts(severity, shown);
}

// Opens the cell again with what was typed, so that it can be mended.
void TargetTable::cell_refused(const QModelIndex& cell, const QString& text, const QString& sentence) {
  say(core::Severity::error, {tr("Error: %1.").arg(sentence)});
  static_cast<CellDelegate*>(view_->itemDelegate())->remember_refused(cell, text);
  QTimer::singleShot(0, this, [this, again = QPersistentModelIndex(cell)] {
    if (again.isValid() && view_->currentIndex() == again) view_->edit(again);
  });
}

void TargetTable::fill_selection(const QString& text) {
  const QModelIndexList cells = view_->selectionModel()->selectedIndexes();
  if (cells.isEmpty()) return;
  if (const QString why = model_->fill(cells, {text}); !why.isEmpty())
    say(core::Severity::error, {tr("Error: %1. Nothing was changed.").arg(why)});
}

void TargetTable::copy() {
  std::vector<scene::Target> targets;
  for (const scene::ObjectId id : selected_targets()) targets.push_back(session_.scene().targets.at(id.index));
  if (!targets.empty()) QApplication::clipboard()->setText(QString::fromStdString(scene::targets_text(targets)));
}

std::string TargetTable::platform_for_new() const {
  if (model_->platform()) return *model_->platform();
  const QModelIndex current = view_->currentIndex();
  if (current.isValid()) return *session_.scene().targets.at(model_->target_at(current.row()).index).platform;
  return session_.scene().platforms.empty() ? "Earth" : session_.scene().platforms.front().name;
}

// A value, or one for each row from the current cell on. False where the text is a table.
bool TargetTable::paste_values(const QString& text) {
  QStringList values = text.split('\n');
  for (QString& value : values) value = value.trimmed();
  while (!values.isEmpty() && values.back().isEmpty()) values.removeLast();
  const auto is_value = [](const QString& value) {
    return !value.isEmpty() && !value.contains('\t') && !value.contains(',') && !value.contains(';') &&
           value.split(' ', Qt::SkipEmptyParts).size() <= 2;
  };
  if (values.isEmpty() || !std::ranges::all_of(values, is_value)) return false;
  const QModelIndex current = view_->currentIndex();
  QModelIndexList cells = view_->selectionModel()->selectedIndexes();
  if (values.size() > 1 && current.isValid()) {
    cells.clear();
    for (qsizetype i = 0; i < values.size(); ++i)
      if (const QModelIndex cell = current.siblingAtRow(current.row() + static_cast<int>(i)); cell.isValid())
        cells += cell;
  }
  if (cells.isEmpty()) return false;
  if (const QString why = model_->fill(cells, values); !why.isEmpty())
    say(core::Severity::error, {tr("Error: %1. Nothing was changed.").arg(why)});
  return true;
}

void TargetTable::paste() {
  const QString text = QApplication::clipboard()->text();
  if (text.trimmed().isEmpty()) return say(core::Severity::note, {tr("The clipboard contains no text.")});
  if (paste_values(text)) return;
  scene::TargetImport import = scene::import_targets(text.toStdString(), platform_for_new(), session_.scene().world);
  QStringList problems;
  for (const core::Problem& problem : import.problems)
    problems += tr("Line %1: %2").arg(problem.place.line).arg(problem_text(problem));
  const bool any = !import.targets.empty();
  if (any) session_.perform(scene::add_targets(session_.scene(), std::move(import.targets)));
  if (!problems.isEmpty()) say(any ? core::Severity::warning : core::Severity::error, problems);
  if (!any && problems.isEmpty()) say(core::Severity::note, {tr("The clipboard contains no targets.")});
}

void TargetTable::import_file() {
  ImportDialog dialog(session_, this);
  dialog.set_platform(platform_for_new());
  dialog.exec();
}

void TargetTable::add_target() {
  scene::Target target;
  target.platform = platform_for_new();
  session_.perform(scene::add_object(session_.scene(), std::move(target)));
  session_.select_only({scene::ObjectKind::target, session_.scene().targets.size() - 1});
}

void TargetTable::delete_targets() {
  const std::vector<scene::ObjectId> targets = selected_targets();
  if (!targets.empty()) session_.perform(scene::remove_objects(session_.scene(), targets));
}

bool TargetTable::eventFilter(QObject* watched, QEvent* event) {
  // What a cell being typed leaves over is not for the table.
  if (event->type() != QEvent::KeyPress || view_->viewport()->findChild<QWidget*>("cell_editor") != nullptr)
    return QWidget::eventFilter(watched, event);
  const auto* key = static_cast<QKeyEvent*>(event);
  if (key->matches(QKeySequence::Copy)) {
    copy();
  } else if (key->matches(QKeySequence::Paste)) {
    paste();
  } else if (key->matches(QKeySequence::Delete)) {
    delete_targets();
  } else {
    return QWidget::eventFilter(watched, event);
  }
  return true;
}

TargetTableDialog::TargetTableDialog(Session& session, QWidget* parent)
    : QDialog(parent), table_(new TargetTable(session, this)) {
  setObjectName("target_table_dialog");
  setWindowTitle(tr("Targets"));
  setModal(false);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  add_help_button(*buttons);
  buttons->button(QDialogButtonBox::Close)->setAutoDefault(false);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(table_, 1);
  layout->addWidget(buttons);
  // Wide enough for the columns that everybody needs, in characters of the font.
  resize(fontMetrics().averageCharWidth() * 110, fontMetrics().height() * 30);
}

}  // namespace sarsim::gui
