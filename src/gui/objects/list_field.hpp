#pragma once

#include <QTableView>
#include <QToolButton>

#include <functional>

#include "gui/common/field_editor.hpp"
#include "gui/objects/list_model.hpp"

namespace sarsim::gui {

class CellDelegate;

/// Changes a list of an object; says why not where it cannot.
using EntryChange = std::function<std::string(scene::AnyObject& object, const scene::LetNames* names)>;

/// A list of an object, legs, waypoints or oscillations, as a table with buttons: entries are added behind the current
/// one, removed and moved.
class ListField : public FieldEditor {
  Q_OBJECT

 public:
  /// @param field  of FieldKind::list
  ListField(const scene::Field& field, QWidget* parent);

  [[nodiscard]] QWidget* widget() const override { return widget_; }
  /// Shows the list of an object; nothing where several are shown, whose lists cannot be changed together.
  void show_entries(const std::optional<scene::AnyObject>& object);
  /// As `FieldEditor`; a cell that was typed into is opened again with what was typed.
  void show_failure(const QString& sentence) override;
  void restore() override;

 signals:
  /// To be applied; `show_failure` or `clear_failure` is the answer.
  void entries_changed(const EntryChange& change);

 protected:
  void display() override {}
  [[nodiscard]] QPalette::ColorRole text_role() const override { return QPalette::WindowText; }

 private:
  QToolButton* add_button(const QString& name, const QString& text, const QString& tip, void (ListField::*press)());
  void cell_typed(const QModelIndex& cell, const QString& text);
  void add();
  void remove();
  void move(int by);
  void move_up() { move(-1); }
  void move_down() { move(1); }
  void arrange();
  void enable_buttons();

  QWidget* widget_;
  QTableView* view_;
  ListModel* model_;
  CellDelegate* delegate_;
  QToolButton* add_ = nullptr;
  QToolButton* remove_ = nullptr;
  QToolButton* up_ = nullptr;
  QToolButton* down_ = nullptr;
  QPersistentModelIndex typed_cell_;
  QString typed_text_;
};

}  // namespace sarsim::gui
