#pragma once

#include <QDialog>
#include <QWidget>

#include <vector>

#include "gui/common/session.hpp"

class QComboBox;
class QLineEdit;
class QPushButton;
class QTableView;

namespace sarsim::gui {

class ProblemLine;
class TargetTableModel;

/// Many targets at once as a table: cells are edited with units, one value fills many cells, rows come and go through
/// the clipboard as a spreadsheet has them.
class TargetTable : public QWidget {
  Q_OBJECT

 public:
  explicit TargetTable(Session& session, QWidget* parent = nullptr);
  ~TargetTable() override;

  /// Gives all selected cells one value, as one undo step.
  void fill_selection(const QString& text);
  /// Puts the rows that have a selected cell on the clipboard, as text with tabs.
  void copy();
  /// Takes the clipboard: a table of x, y, z and perhaps RCS becomes new targets; a single value, or a column of them,
  /// goes into the selected cells.
  void paste();
  /// Opens the dialog that reads targets from a file.
  void import_file();
  /// Adds a target and selects it.
  void add_target();
  /// Takes the targets of the selected cells out of the scene.
  void delete_targets();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  void make_widgets();
  void connect_all();
  void fill_platforms();
  void take_selection();
  void show_selection();
  void update_buttons();
  void cell_refused(const QModelIndex& cell, const QString& text, const QString& sentence);
  void say(core::Severity severity, const QStringList& texts);
  [[nodiscard]] bool paste_values(const QString& text);
  [[nodiscard]] std::vector<scene::ObjectId> selected_targets() const;
  [[nodiscard]] std::string platform_for_new() const;

  Session& session_;
  TargetTableModel* model_ = nullptr;
  QComboBox* platform_ = nullptr;
  QLineEdit* fill_value_ = nullptr;
  QPushButton* fill_ = nullptr;
  QPushButton* add_ = nullptr;
  QPushButton* delete_ = nullptr;
  QPushButton* copy_ = nullptr;
  QPushButton* paste_ = nullptr;
  QPushButton* import_ = nullptr;
  QTableView* view_ = nullptr;
  ProblemLine* message_ = nullptr;
  bool showing_ = false;
  bool stale_ = false;  // others were selected while it was hidden
};

/// The table in a window of its own, which does not keep others from being used.
class TargetTableDialog : public QDialog {
  Q_OBJECT

 public:
  explicit TargetTableDialog(Session& session, QWidget* parent = nullptr);
  [[nodiscard]] TargetTable* table() const { return table_; }

 private:
  TargetTable* table_;
};

}  // namespace sarsim::gui
