#pragma once

#include <QDialog>

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

#include "gui/common/latest_only_work.hpp"
#include "gui/common/session.hpp"
#include "workflow/record/save_choice.hpp"

class QComboBox;
class QDialogButtonBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QSpinBox;

namespace sarsim::gui {

class ProblemLine;

/// Asks how the data of a simulation window are saved (thesis 4.5.2): sampling, converter, file, script; tells size and
/// time before. What is chosen is in `choice` once it was accepted.
class SaveDataDialog : public QDialog {
  Q_OBJECT

 public:
  /// @param recording     radar, window and processing; what is proposed for the rest
  /// @param bandwidth_hz  of the radar's pulse; 0: unknown
  /// @param largest_v     largest magnitude in the picture; 0: unknown
  /// @param folder        of the proposed file, and of names without one
  SaveDataDialog(Session& session, const scene::Simulation& recording, double bandwidth_hz, double largest_v,
                 std::filesystem::path folder, QWidget* parent = nullptr);

  /// What is chosen; nothing while a field cannot be read.
  [[nodiscard]] std::optional<workflow::SaveChoice> choice() const;
  /// The simulation that it comes to.
  [[nodiscard]] scene::Simulation simulation() const { return workflow::chosen_simulation(choice_, largest_v_); }
  /// An existing file may be replaced: the user was asked.
  [[nodiscard]] bool replace() const { return replace_; }

  /// Asked before an existing file is replaced. A message box unless replaced.
  std::function<bool(const std::filesystem::path&)> ask_replace;
  /// Asked for a file; empty for none. A file dialog unless replaced.
  std::function<QString(const QString& present)> ask_file;
  /// Whether somebody is about to write this file, which may not exist yet.
  std::function<bool(const std::filesystem::path&)> is_taken;

 public slots:
  void accept() override;

 signals:
  void forecast_ready();  ///< Size and time of the present choice are shown, or why there are none.

 private:
  void make_window_group(QFormLayout* form);
  void make_converter_group(QFormLayout* form);
  void make_file_group(QFormLayout* form);
  QLineEdit* add_line(QFormLayout* form, const QString& label, const char* name, const QString& tip);
  QComboBox* add_choice(QFormLayout* form, const QString& label, const char* name, const QStringList& entries,
                        const QString& tip);
  void make_questions();
  void take_rate();
  void take_multiple();
  void take_lsb_choice();
  void take_rest();
  void show_objections(const QStringList& texts);
  void show_lsb();
  void select_file();
  void show_format(scene::FileFormat format);
  void follow_format();
  void show_samples();
  [[nodiscard]] QStringList objections() const;
  void refresh();
  void plan();
  void show_forecast(bool good, const QString& failure);

  Session& session_;
  workflow::SaveChoice choice_;
  double bandwidth_hz_;
  double largest_v_;
  std::filesystem::path folder_;
  bool replace_ = false;
  QString rate_failure_;
  QString lsb_failure_;
  QLineEdit* multiple_ = nullptr;
  QLineEdit* rate_ = nullptr;
  QSpinBox* bits_ = nullptr;
  QComboBox* lsb_from_ = nullptr;
  QLineEdit* lsb_ = nullptr;
  QComboBox* format_ = nullptr;
  QComboBox* samples_ = nullptr;
  QLineEdit* file_ = nullptr;
  QComboBox* target_ = nullptr;
  QLabel* estimate_ = nullptr;
  ProblemLine* problems_ = nullptr;
  QDialogButtonBox* buttons_ = nullptr;
  bool sound_ = true;  // the present choice can be run, as far as is known
  std::shared_ptr<workflow::SaveForecast> forecast_;
  LatestOnlyWork planning_;
};

}  // namespace sarsim::gui
