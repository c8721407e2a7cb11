#pragma once

#include <QTimer>
#include <QWidget>

#include <memory>

#include "gui/common/latest_only_work.hpp"
#include "picture/echo/radar_figures.hpp"

class QCheckBox;
class QComboBox;
class QFormLayout;
class QHBoxLayout;
class QLabel;
class QProgressBar;
class QSpinBox;

namespace sarsim::gui {

class FigurePlot;
class ProblemLine;
class SimulationWindow;

/// Another view of the samples of a simulation window: range profile, range-Doppler map, spectrum or phase history. It
/// follows the scene, the view and the first cursor of that window.
class RadarViewWindow : public QWidget {
  Q_OBJECT

 public:
  /// @param from  whose samples are shown; the window ends with it
  RadarViewWindow(SimulationWindow& from, picture::RadarView view);

  [[nodiscard]] const picture::RadarViewChoice& choice() const { return choice_; }
  [[nodiscard]] FigurePlot& plot() { return *plot_; }
  /// What is shown belongs to the present choice, scene and cursor.
  [[nodiscard]] bool complete() const { return complete_; }

 public slots:
  /// Shows another view, or the same one computed in another way.
  void set_choice(const sarsim::picture::RadarViewChoice& choice);
  /// Puts the figure onto the clipboard.
  void copy_picture();
  /// Puts its values onto the clipboard, for a spreadsheet.
  void copy_values();
  /// @param path  empty: asks for it
  void save_values(const QString& path = QString());
  /// @param path  empty: asks for it
  void save_picture(const QString& path = QString());

 signals:
  void finished();  ///< The figure, or why there is none, is shown.

 private:
  void make_controls(QHBoxLayout* row);
  void make_foot(QHBoxLayout* row);
  void show_choice();
  void take_choice();
  void compute_soon();
  void compute();
  void show_result(bool good, const QString& failure);
  [[nodiscard]] QString suggested_file(const char* ending) const;

  SimulationWindow& from_;
  picture::RadarViewChoice choice_;
  QComboBox* view_ = nullptr;
  QSpinBox* pulses_ = nullptr;
  QLabel* interval_label_ = nullptr;
  QSpinBox* interval_ = nullptr;
  QComboBox* mean_ = nullptr;
  QComboBox* window_ = nullptr;
  QSpinBox* padding_ = nullptr;
  QCheckBox* decibels_ = nullptr;
  QCheckBox* unwrapped_ = nullptr;
  QLabel* padding_label_ = nullptr;
  QLabel* pulses_label_ = nullptr;
  FigurePlot* plot_ = nullptr;
  ProblemLine* problems_ = nullptr;
  QProgressBar* progress_ = nullptr;
  QTimer debounce_;
  bool complete_ = false;
  bool showing_ = false;
  struct Result;
  std::shared_ptr<Result> result_;  // written by the work, read when it has ended
  LatestOnlyWork work_;
};

}  // namespace sarsim::gui
