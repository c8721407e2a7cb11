#pragma once

#include <QTimer>
#include <QWidget>

#include <filesystem>
#include <vector>

#include "gui/common/background_job.hpp"
#include "gui/common/session.hpp"
#include "gui/scene/geometry_rows.hpp"

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;

namespace sarsim::gui {

class FieldEditor;
class GeometryModel;
class GeometryView;
class ProblemLine;

/// Where everything is for every pulse of a radar (thesis 4.10): a table of any number of pulses with the columns one
/// chooses, to be looked at, saved, and stored in the script.
class GeometryWindow : public QWidget {
  Q_OBJECT

 public:
  explicit GeometryWindow(Session& session, QWidget* parent = nullptr);
  ~GeometryWindow() override;

  [[nodiscard]] const GeometryChoice& choice() const { return choice_; }
  /// Shows this table of the scene.
  void show_table(const scene::GeometryTable& table);
  [[nodiscard]] GeometryModel& model() { return *model_; }
  [[nodiscard]] GeometryView& view() { return *view_; }

  /// Writes the table to a file, as text in its columns or as CSV with all of them; progress and Cancel are shown.
  void save_to(const std::filesystem::path& path, bool csv);
  [[nodiscard]] bool saving() const { return job_.running(); }
  void cancel_saving() { job_.cancel(); }

 public slots:
  /// Asks for a name and writes the table.
  void save_as();
  /// Stores the table in the script.
  void to_script();
  /// Shows the table of the script that is chosen.
  void show_stored();
  /// Takes it out of the script.
  void delete_stored();

 signals:
  void saved(sarsim::gui::JobEnd end);  ///< A file is written, or not.

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void connect_all();
  QWidget* make_controls();
  QWidget* make_stored_row();
  QWidget* make_save_row();
  void add_fields(QWidget* page);
  void take_entry(FieldEditor& editor, const QString& text);
  void take_targets();
  void show_fields();
  void refresh_stored();
  void follow_scene();
  void compute();
  void show_ready();
  void show_saved(JobEnd end, const QString& failure);
  void go_to_pulse();

  Session& session_;
  GeometryChoice choice_;
  GeometryModel* model_ = nullptr;
  GeometryView* view_ = nullptr;
  std::vector<FieldEditor*> fields_;
  QCheckBox* distance_ = nullptr;
  QLineEdit* targets_ = nullptr;
  ProblemLine* targets_problem_ = nullptr;
  QComboBox* stored_ = nullptr;
  QPushButton* show_stored_ = nullptr;
  QPushButton* delete_stored_ = nullptr;
  QLineEdit* pulse_ = nullptr;
  QLabel* state_ = nullptr;
  ProblemLine* problems_ = nullptr;
  QPushButton* save_ = nullptr;
  QPushButton* cancel_ = nullptr;
  QProgressBar* bar_ = nullptr;
  QTimer debounce_;
  bool targets_typed_ = false;
  bool stale_ = true;
  std::filesystem::path saving_to_;
  BackgroundJob job_;
};

}  // namespace sarsim::gui
