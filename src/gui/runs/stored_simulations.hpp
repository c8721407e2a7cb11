#pragma once

#include <QWidget>

#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "gui/common/session.hpp"

class QHBoxLayout;
class QLabel;
class QPushButton;
class QTableWidget;

namespace sarsim::gui {

class RunPanel;

/// The simulations that a script stores: a line for each, with buttons to show, edit, run, delete and make them.
class StoredSimulations : public QWidget {
  Q_OBJECT

 public:
  explicit StoredSimulations(Session& session, QWidget* parent = nullptr);

  /// The simulation of the chosen line.
  [[nodiscard]] std::optional<scene::ObjectId> chosen() const;
  /// Makes the line of a simulation the chosen one.
  void choose(scene::ObjectId simulation);

  /// Runs a simulation into a file without asking anything; not while another run is under way.
  void run_into(scene::ObjectId simulation, const std::filesystem::path& file, bool replace);
  [[nodiscard]] RunPanel& run_panel() { return *run_panel_; }

  /// Asked for the folder of the files of a scene that was never saved; nothing for no. A file dialog unless replaced.
  std::function<std::optional<std::filesystem::path>()> ask_folder;
  /// Asked before an existing file is replaced. A message box unless replaced.
  std::function<bool(const std::filesystem::path&)> ask_replace;

 public slots:
  /// Opens a window with the settings of the chosen line.
  void show_chosen();
  /// Shows its properties.
  void edit_chosen();
  /// Runs it into a file of its folder.
  void run_chosen();
  /// Takes it out of the script.
  void delete_chosen();
  /// Adds a simulation that suits the current radar.
  void add_new();

 signals:
  void show_requested(sarsim::scene::ObjectId simulation);  ///< Open a simulation window with these settings.

 private:
  [[nodiscard]] QHBoxLayout* make_buttons();
  void make_questions();
  QPushButton* add_button(const QString& text, const char* name, const QString& tip, void (StoredSimulations::*slot)());
  void refresh();
  void refresh_buttons();
  void follow_selection();
  void take_lsb(const scene::Simulation& simulation, double lsb_v);
  [[nodiscard]] std::optional<std::filesystem::path> folder() const;

  Session& session_;
  std::vector<scene::Simulation> shown_;
  QTableWidget* table_ = nullptr;
  QLabel* empty_ = nullptr;
  std::vector<QPushButton*> of_chosen_;
  QPushButton* new_ = nullptr;
  RunPanel* run_panel_ = nullptr;
  int run_of_ = 0;  // the number of the document that the last run is of
};

/// A simulation of a radar with values that suit the scene: the ranges of all targets with two pulse lengths around
/// them, 1.2 times the bandwidth as sampling frequency, the first 64 pulses, a file name that is free. Where the scene
/// is faulty, the values of the thesis.
[[nodiscard]] scene::Simulation suitable_simulation(const scene::Scene& scene, std::size_t radar);

}  // namespace sarsim::gui
