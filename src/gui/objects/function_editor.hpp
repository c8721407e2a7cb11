#pragma once

#include <QDialog>

#include <array>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "gui/common/session.hpp"
#include "scene/edit/function_model.hpp"

class QAction;
class QButtonGroup;
class QCheckBox;
class QLineEdit;
class QRadioButton;

namespace sarsim::gui {

class FieldEditor;
class FunctionPlot;
class FunctionTable;
class ProblemLine;

/// Edits a user-defined function (thesis 4.6): a table and a graph of its parts, with undo of its own. OK makes one
/// step of the session's history of all that was done; Cancel leaves everything as it was.
class FunctionEditor : public QDialog {
  Q_OBJECT

 public:
  /// @param field  of kind `function` (scene/schema/fields.hpp); std::invalid_argument for another
  FunctionEditor(Session& session, scene::ObjectId object, const std::string& field, QWidget* parent = nullptr);
  ~FunctionEditor() override;

  [[nodiscard]] const scene::FunctionDraft& draft() const { return draft_; }
  [[nodiscard]] const scene::FunctionInfo& info() const { return info_; }
  [[nodiscard]] FunctionPlot& plot() { return *plot_; }
  [[nodiscard]] FunctionTable& table() { return *table_; }
  /// The part that is shown.
  [[nodiscard]] std::size_t part() const { return part_; }
  /// Shows another part of the function in table and graph.
  void show_part(std::size_t part);

  /// Reads, writes and imports files; what stands in the way is shown in words, and the function then stays as it is.
  /// Names are taken from the script's folder first. True where it was done.
  /// @{
  bool load_file(const QString& name);
  bool save_file(const QString& name);
  bool import_csv(const QString& path);
  /// @}

  /// What is to become of samples that belong into a file.
  enum class Unsaved { save, keep_inline, cancel };
  /// Asked by OK where the samples belong into a file that does not hold them. A message box unless replaced.
  std::function<Unsaved(const QString& file)> ask_unsaved;
  /// Asked before a file is replaced that is not the function's own. A message box unless replaced.
  std::function<bool(const QString& file)> ask_replace;

 public slots:
  /// Takes back the last change of this editor.
  void undo();
  /// Makes it again.
  void redo();
  void accept() override;

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void make_layout();
  void make_questions();
  QWidget* make_source();
  QWidget* make_display();
  QWidget* make_interpolation();
  QWidget* make_graph();
  QWidget* make_window_fields();
  void make_undo();
  void connect_points();

  bool take_drag_back();
  void change(scene::FunctionDraft next);
  void show_draft();
  void show_source();
  void show_window();
  void say(core::Severity severity, const QStringList& texts);
  void take_knot(std::size_t row, core::Knot knot);
  void insert_sample();
  void delete_sample();
  void take_count(int count);
  void take_source();
  void take_window(FieldEditor& editor, std::size_t end, const QString& text);
  void browse();
  [[nodiscard]] core::Problems take_points_of_file();
  [[nodiscard]] scene::FunctionReading read(const scene::DataFileText& file, const std::string& name) const;
  [[nodiscard]] bool take_reading(scene::FunctionReading reading);
  [[nodiscard]] bool stands_in_file() const;
  [[nodiscard]] std::filesystem::path script_folder() const;
  [[nodiscard]] std::filesystem::path path_of(const QString& name) const;
  [[nodiscard]] core::SampledFunction& shown(scene::FunctionDraft& draft) const { return draft.parts[part_]; }

  Session& session_;
  scene::ObjectId id_;
  std::string field_;
  scene::AnyObject object_;
  scene::FunctionInfo info_;
  scene::FunctionDraft draft_;
  std::vector<scene::FunctionDraft> states_;  // every one since the beginning
  std::size_t state_ = 0;
  scene::FunctionDraft before_drag_;
  bool dragging_ = false;
  std::size_t part_ = 0;
  std::string own_file_;  // a text that was read or written here, or is the function's from the beginning

  QRadioButton* inline_ = nullptr;
  QRadioButton* in_file_ = nullptr;
  QLineEdit* file_ = nullptr;
  QButtonGroup* parts_ = nullptr;
  QButtonGroup* methods_ = nullptr;
  QCheckBox* compare_ = nullptr;
  FunctionTable* table_ = nullptr;
  FunctionPlot* plot_ = nullptr;
  std::array<FieldEditor*, 4> window_{};
  ProblemLine* problems_ = nullptr;
  QAction* undo_ = nullptr;
  QAction* redo_ = nullptr;
};

}  // namespace sarsim::gui
