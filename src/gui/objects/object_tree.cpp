#include "gui/objects/object_tree.hpp"

#include <QAction>
#include <QHeaderView>
#include <QItemSelectionModel>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QScopedValueRollback>
#include <QScrollBar>
#include <QTreeView>
#include <QVBoxLayout>

#include <algorithm>
#include <iterator>
#include <utility>

#include "gui/common/object_names.hpp"
#include "gui/common/problem_line.hpp"
#include "gui/common/shown_selection.hpp"
#include "gui/objects/object_tree_eye.hpp"
#include "gui/objects/object_tree_model.hpp"
#include "scene/edit/edit.hpp"

namespace sarsim::gui {

namespace {

// Qt looks for the place of each of many rows, or ranges of them, to paint these alone; all that can be seen is painted
// sooner.
class TreeView : public QTreeView {
 public:
  using QTreeView::QTreeView;

 protected:
  void dataChanged(const QModelIndex& first, const QModelIndex& last, const QVector<int>& roles) override {
    if (last.row() - first.row() < many) return QTreeView::dataChanged(first, last, roles);
    QTreeView::dataChanged(first, first, roles);
    viewport()->update();
  }

  void selectionChanged(const QItemSelection& selected, const QItemSelection& deselected) override {
    if (selected.size() + deselected.size() < many) return QTreeView::selectionChanged(selected, deselected);
    viewport()->update();
  }

 private:
  static constexpr int many = 100;
};

QTreeView* make_view(ObjectTreeModel* model, QWidget* parent) {
  auto* view = new TreeView(parent);
  view->setObjectName("object_tree");
  view->setAccessibleName(ObjectTree::tr("Objects of the scene"));
  view->setModel(model);
  view->setUniformRowHeights(true);
  view->setSelectionMode(QAbstractItemView::ExtendedSelection);
  view->setSelectionBehavior(QAbstractItemView::SelectRows);
  view->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::DoubleClicked);
  view->setExpandsOnDoubleClick(false);
  view->setDragEnabled(true);
  view->setAcceptDrops(true);
  view->setDropIndicatorShown(true);
  view->setDragDropMode(QAbstractItemView::DragDrop);
  view->setDefaultDropAction(Qt::MoveAction);
  view->setContextMenuPolicy(Qt::CustomContextMenu);
  view->header()->setStretchLastSection(false);
  view->header()->setResizeContentsPrecision(0);
  view->header()->setSectionResizeMode(ObjectTreeModel::name_column, QHeaderView::Stretch);
  view->header()->setSectionResizeMode(ObjectTreeModel::shown_column, QHeaderView::Fixed);
  view->header()->setMinimumSectionSize(0);
  view->header()->resizeSection(ObjectTreeModel::shown_column, 2 * view->fontMetrics().height());
  view->setHeaderHidden(true);  // Names and eyes need no headings, and coordinates need the room.
  view->setItemDelegateForColumn(ObjectTreeModel::shown_column, new EyeDelegate(view));
  view->setIndentation(view->fontMetrics().height());
  return view;
}

}  // namespace

ObjectTree::ObjectTree(Session& session, QWidget* parent)
    : QWidget(parent), session_(session), model_(new ObjectTreeModel(session, this)) {
  setObjectName("object_tree_panel");
  filter_ = new QLineEdit(this);
  filter_->setObjectName("object_filter");
  filter_->setAccessibleName(tr("Filter objects"));
  filter_->setPlaceholderText(tr("Filter"));
  filter_->setToolTip(tr("Shows objects whose names or coordinates hold all of the words"));
  filter_->setClearButtonEnabled(true);
  filter_->installEventFilter(this);
  view_ = make_view(model_, this);
  view_->installEventFilter(this);
  message_ = new ProblemLine(this);
  message_->setObjectName("object_message");
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(filter_);
  layout->addWidget(view_, 1);
  layout->addWidget(message_);
  setFocusProxy(view_);
  connect_all();
  restore_view();
}

// Views tell of changes while they go.
ObjectTree::~ObjectTree() {
  view_->selectionModel()->disconnect(this);
  model_->disconnect(this);
}

void ObjectTree::connect_all() {
  connect(filter_, &QLineEdit::textChanged, this, [this](const QString& text) { model_->set_filter(text); });
  connect(model_, &QAbstractItemModel::modelAboutToBeReset, this, &ObjectTree::save_view);
  connect(model_, &QAbstractItemModel::modelReset, this, &ObjectTree::restore_view);
  connect(model_, &ObjectTreeModel::refused, this, [this](const QString& sentence) {
    message_->show_texts(core::Severity::error, {tr("Error: %1.").arg(sentence)});
    session_.log(core::Severity::error, sentence);
  });
  connect(view_->selectionModel(), &QItemSelectionModel::selectionChanged, this, &ObjectTree::take_selection);
  connect(&session_, &Session::scene_changed, message_, &ProblemLine::clear);
  connect(&session_, &Session::document_replaced, this, [this] { folded_.clear(); });
  connect(model_, &ObjectTreeModel::key_changed, this, [this](const QString& before, const QString& now) {
    if (folded_.erase(before) > 0) folded_.insert(now);
  });
  connect(&session_, &Session::selection_changed, this, [this] {
    if (showing_) return;
    if (shown_selection_ != session_.selection_number()) show_selection();
    reveal_current();
  });
  connect(view_, &QTreeView::customContextMenuRequested, this, &ObjectTree::show_menu);
  connect(view_, &QTreeView::doubleClicked, this, &ObjectTree::request_edit);
  const auto note_fold = [this](const QModelIndex& index, bool folded) {
    if (showing_ || model_->filtered()) return;
    if (folded)
      folded_.insert(model_->key_of(index));
    else
      folded_.erase(model_->key_of(index));
  };
  connect(view_, &QTreeView::collapsed, this, [note_fold](const QModelIndex& index) { note_fold(index, true); });
  connect(view_, &QTreeView::expanded, this, [note_fold](const QModelIndex& index) { note_fold(index, false); });
}

void ObjectTree::request_edit(const QModelIndex& index) {
  if (const auto id = model_->object_at(index); id && !scene::is_named(id->kind)) emit edit_requested(*id);
}

// The user selected something here.
void ObjectTree::take_selection() {
  if (showing_) return;
  const QScopedValueRollback telling(showing_, true);
  message_->clear();
  std::set<scene::ObjectId> ids;
  for (const QItemSelectionRange& range : view_->selectionModel()->selection())
    for (int row = range.top(); row <= range.bottom(); ++row)
      if (const auto id = model_->object_at(model_->index(row, 0, range.parent()))) ids.insert(*id);
  if (ids.size() == 1) return session_.select_only(*ids.begin());
  // One more than before: it is the current one.
  std::vector<scene::ObjectId> added;
  std::ranges::set_difference(ids, session_.selection(), std::back_inserter(added));
  if (added.size() == 1 && ids.size() == session_.selection().size() + 1) return session_.select_also(added.front());
  session_.select(std::move(ids));
}

QItemSelection ObjectTree::rows_of(const std::set<scene::ObjectId>& objects) const {
  std::vector<QModelIndex> rows;
  rows.reserve(objects.size());
  for (const scene::ObjectId id : objects)
    if (const QModelIndex index = model_->index_of(id); index.isValid()) rows.push_back(index);
  std::ranges::sort(rows, [](const QModelIndex& a, const QModelIndex& b) {
    return a.internalId() != b.internalId() ? a.internalId() < b.internalId() : a.row() < b.row();
  });
  // Rows that follow each other are one range, so that thousands of them stay quick.
  QItemSelection selection;
  for (std::size_t i = 0; i < rows.size();) {
    std::size_t end = i + 1;
    while (end < rows.size() && rows[end].internalId() == rows[i].internalId() &&
           rows[end].row() == rows[end - 1].row() + 1)
      ++end;
    selection.append(QItemSelectionRange(rows[i], rows[end - 1].siblingAtColumn(ObjectTreeModel::shown_column)));
    i = end;
  }
  return selection;
}

// Somebody else selected something, or the tree has another shape.
void ObjectTree::show_selection() {
  const QScopedValueRollback telling(showing_, true);
  show_selected(*view_, rows_of(session_.selection()));
  shown_selection_ = session_.selection_number();
}

void ObjectTree::reveal_current() {
  if (!session_.current()) return;
  const QScopedValueRollback telling(showing_, true);
  const QModelIndex current = model_->index_of(*session_.current());
  if (!current.isValid()) return;
  view_->selectionModel()->setCurrentIndex(current, QItemSelectionModel::NoUpdate);
  if (view_->hasFocus() && current.parent().isValid() && !view_->isExpanded(current.parent())) return;
  view_->scrollTo(current);
}

void ObjectTree::save_view() {
  scroll_ = view_->verticalScrollBar()->value();
  const QModelIndex current = view_->currentIndex();
  current_key_ = model_->key_of(current);
  current_row_ = current.parent().isValid() ? current.row() : -1;
}

void ObjectTree::restore_view() {
  const QScopedValueRollback telling(showing_, true);
  for (int row = 0; row < model_->rowCount(); ++row) {
    const QModelIndex top = model_->index(row, 0);
    const QString key = model_->key_of(top);
    const bool heading = !model_->object_at(top);
    if (heading) view_->setFirstColumnSpanned(row, {}, true);
    view_->setExpanded(top, model_->filtered() || !folded_.contains(key));
    if (key != current_key_) continue;
    const int rows = model_->rowCount(top);
    const QModelIndex near =
        current_row_ < 0 || rows == 0 ? top : model_->index(std::min(current_row_, rows - 1), 0, top);
    view_->selectionModel()->setCurrentIndex(near, QItemSelectionModel::NoUpdate);
  }
  show_selection();
  view_->verticalScrollBar()->setValue(scroll_);
}

std::vector<scene::ObjectId> ObjectTree::selected() const {
  return {session_.selection().begin(), session_.selection().end()};
}

void ObjectTree::delete_selection() {
  if (!session_.selection().empty()) session_.perform(scene::remove_objects(session_.scene(), selected()));
}

void ObjectTree::duplicate_selection() {
  if (session_.selection().empty()) return;
  scene::Edit edit = scene::duplicate_objects(session_.scene(), selected());
  std::set<scene::ObjectId> copies;
  for (const scene::ObjectChange& change : edit.changes)
    if (!change.before) copies.insert(change.id);
  // With a platform comes what stands on it; it is the platform that was copied.
  const auto is_platform = [](scene::ObjectId id) { return id.kind == scene::ObjectKind::platform; };
  if (std::ranges::any_of(copies, is_platform))
    std::erase_if(copies, [&](scene::ObjectId id) { return !is_platform(id); });
  session_.perform(std::move(edit));
  session_.select(std::move(copies));
}

void ObjectTree::rename_current() {
  const auto current = session_.current();
  if (!current || !scene::is_named(current->kind)) return;
  const QModelIndex index = model_->index_of(*current);
  if (!index.isValid()) return;
  view_->setCurrentIndex(index);
  view_->edit(index);
}

void ObjectTree::hide_selection(bool hide) {
  std::set<scene::ObjectId> ids;
  for (const scene::ObjectId id : session_.selection())
    for (const scene::ObjectId one : model_->with_children(id)) ids.insert(one);
  session_.set_hidden(ids, hide);
}

void ObjectTree::invert_surfaces() {
  scene::Edit edit;
  for (const scene::ObjectId id : session_.selection()) {
    if (id.kind != scene::ObjectKind::surface) continue;
    scene::Surface surface = session_.scene().surfaces.at(id.index);
    std::swap(surface.corner_m[0], surface.corner_m[1]);
    scene::Edit one = scene::replace_object(session_.scene(), id, surface, "Invert surface");
    std::ranges::move(one.changes, std::back_inserter(edit.changes));
  }
  edit.label = edit.changes.size() == 1 ? "Invert surface" : "Invert surfaces";
  session_.perform(std::move(edit));
}

std::unique_ptr<QMenu> ObjectTree::context_menu() {
  auto menu = std::make_unique<QMenu>();
  menu->setObjectName("object_menu");
  const std::set<scene::ObjectId>& selection = session_.selection();
  const auto current = session_.current();
  const auto add = [&](const char* name, const QString& text, const QKeySequence& keys, bool enabled, auto&& what) {
    QAction* action = menu->addAction(text, this, what);
    action->setObjectName(name);
    action->setShortcut(keys);
    action->setEnabled(enabled);
  };
  const bool any = !selection.empty();
  add("tree_modify", tr("&Modify"), QKeySequence(Qt::Key_Return), current.has_value(), [this] {
    if (const auto now = session_.current()) emit edit_requested(*now);
  });
  add("tree_delete", tr("&Delete"), QKeySequence(Qt::Key_Delete), any, [this] { delete_selection(); });
  menu->addSeparator();
  add("tree_duplicate", tr("D&uplicate"), QKeySequence(Qt::CTRL | Qt::Key_D), any, [this] { duplicate_selection(); });
  add("tree_rename", tr("&Rename"), QKeySequence(Qt::Key_F2), current && scene::is_named(current->kind),
      [this] { rename_current(); });
  const bool all_hidden =
      any && std::ranges::all_of(selection, [this](scene::ObjectId id) { return session_.hidden().contains(id); });
  const bool can_hide =
      std::ranges::any_of(selection, [](scene::ObjectId id) { return id.kind <= scene::ObjectKind::radar; });
  if (all_hidden)
    add("tree_show", tr("&Show"), {}, can_hide, [this] { hide_selection(false); });
  else
    add("tree_hide", tr("&Hide"), {}, can_hide, [this] { hide_selection(true); });
  if (std::ranges::any_of(selection, [](scene::ObjectId id) { return id.kind == scene::ObjectKind::surface; }))
    add("tree_invert", tr("&Invert surface"), {}, true, [this] { invert_surfaces(); });
  return menu;
}

void ObjectTree::show_menu(const QPoint& at) {
  if (session_.selection().empty()) return;
  context_menu()->exec(view_->viewport()->mapToGlobal(at));
}

bool ObjectTree::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::KeyPress) {
    const auto& key = *static_cast<QKeyEvent*>(event);
    if (watched == view_) return key_pressed(key.key(), key.modifiers());
    if (key.key() == Qt::Key_Escape && !filter_->text().isEmpty()) {
      filter_->clear();
      return true;
    }
    if (key.key() == Qt::Key_Down) {
      view_->setFocus(Qt::TabFocusReason);
      return true;
    }
  }
  return QWidget::eventFilter(watched, event);
}

bool ObjectTree::key_pressed(int key, Qt::KeyboardModifiers modifiers) {
  // What a name being typed leaves over is not for the tree.
  if (view_->viewport()->findChild<QLineEdit*>() != nullptr) return false;
  switch (key) {
    case Qt::Key_Delete: delete_selection(); return true;
    case Qt::Key_D:
      if (modifiers != Qt::ControlModifier) return false;
      duplicate_selection();
      return true;
    case Qt::Key_Return:
    case Qt::Key_Enter:
      if (const auto current = session_.current()) emit edit_requested(*current);
      return true;
    case Qt::Key_F2: rename_current(); return true;
    default: return false;
  }
}

}  // namespace sarsim::gui
