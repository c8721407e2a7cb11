#pragma once

#include <QWidget>

#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "gui/common/session.hpp"

class QItemSelection;
class QLineEdit;
class QMenu;
class QModelIndex;
class QTreeView;

namespace sarsim::gui {

class ObjectTreeModel;
class ProblemLine;

/// The tree of all objects with a filter above it. Selection is the session's; F2 or a double click renames, Delete
/// deletes, Ctrl+D duplicates, dragging carries to another platform, a box at the right hides.
class ObjectTree : public QWidget {
  Q_OBJECT

 public:
  explicit ObjectTree(Session& session, QWidget* parent = nullptr);
  ~ObjectTree() override;

  /// What the keys and the context menu do with the selection, one undo step each.
  /// @{
  void delete_selection();
  void duplicate_selection();
  void rename_current();
  void hide_selection(bool hide);
  /// Turns the front of the selected surfaces to the other side by exchanging their first two corners.
  void invert_surfaces();
  /// @}
  /// The menu for the selection: Modify, Delete, Duplicate, Rename, Hide or Show, Invert surface; actions are named
  /// "tree_modify", ...
  [[nodiscard]] std::unique_ptr<QMenu> context_menu();

 signals:
  /// The user wants the properties of an object.
  void edit_requested(scene::ObjectId object);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void connect_all();
  bool key_pressed(int key, Qt::KeyboardModifiers modifiers);
  void show_menu(const QPoint& at);
  void take_selection();
  void show_selection();
  void reveal_current();
  void save_view();
  void restore_view();
  void request_edit(const QModelIndex& index);
  [[nodiscard]] QItemSelection rows_of(const std::set<scene::ObjectId>& objects) const;
  [[nodiscard]] std::vector<scene::ObjectId> selected() const;

  Session& session_;
  ObjectTreeModel* model_ = nullptr;
  QLineEdit* filter_ = nullptr;
  QTreeView* view_ = nullptr;
  ProblemLine* message_ = nullptr;
  bool showing_ = false;               // the view is being told, not the user's doing
  std::uint64_t shown_selection_ = 0;  // by its number

  // What the view forgets when the tree has another shape.
  std::set<QString> folded_;
  int scroll_ = 0;
  QString current_key_;
  int current_row_ = -1;
};

}  // namespace sarsim::gui
