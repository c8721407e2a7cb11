#pragma once

#include <QTimer>
#include <QWidget>

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>

#include "gui/common/session.hpp"
#include "gui/echo/echo_plot.hpp"
#include "picture/echo/echo_window.hpp"
#include "picture/echo/preview.hpp"
#include "picture/echo/radar_figures.hpp"
#include "picture/echo/view_history.hpp"
#include "picture/figure/figure.hpp"

class QLabel;
class QProgressBar;
class QPushButton;
class QToolButton;

namespace sarsim::gui {

class EchoControls;
class FigurePlot;
class ProblemLine;
class RadarViewWindow;
class ReservedLabel;

/// A simulation window (thesis 4.5): the echoes of the scene as it is now, at the resolution of the screen, computed
/// again whenever scene or window change. Any number of them, each with its own state.
class SimulationWindow : public QWidget {
  Q_OBJECT

 public:
  /// @param window  what it shows at first
  /// @param show_all  choose the ranges so that all targets are seen
  SimulationWindow(Session& session, picture::EchoWindow window, bool show_all, QWidget* parent = nullptr);
  ~SimulationWindow() override;

  [[nodiscard]] const picture::EchoWindow& window_state() const { return window_; }
  [[nodiscard]] EchoPlot& plot() { return *plot_; }
  [[nodiscard]] EchoControls& controls() { return *controls_; }
  /// Whether all samples of the present view are shown.
  [[nodiscard]] bool complete() const;
  /// What is seen, with axes, to be written to a file.
  [[nodiscard]] picture::Figure figure() const;
  /// The window as a simulation to be stored or saved.
  [[nodiscard]] scene::Simulation simulation() const;
  [[nodiscard]] const std::shared_ptr<const scene::Scene>& scene() const { return scene_; }
  /// Of the radar's pulse; 0: unknown.
  [[nodiscard]] double bandwidth_hz() const;
  /// Largest magnitude in the picture; 0 until it is complete.
  [[nodiscard]] double largest_v() const;
  /// Where the first cursor is, or else the middle of the view.
  [[nodiscard]] EchoPlot::Cursor place() const;
  /// Its document is at hand again, or is not any more: the window goes out of sight, with its views, and waits.
  void put_aside(bool aside);
  /// The number of the document whose echoes it shows.
  [[nodiscard]] int document() const { return document_; }
  /// Shows or hides the form at the side.
  void show_settings(bool shown);
  /// Opens another view of the same samples, which follows this window and ends with it.
  RadarViewWindow* open_radar_view(picture::RadarView view);

 public slots:
  /// Another view; the present one is kept to go back to.
  void go_to(const sarsim::picture::EchoView& view);
  /// The view that was left last.
  void go_back();
  /// The view that was left by going back.
  void go_forward();
  /// The ranges of all targets.
  void show_all_targets();
  /// Follows another window along the axes that both have linked.
  void follow(const sarsim::picture::EchoView& view, sarsim::picture::AxisLink link);
  /// Puts the picture onto the clipboard, without axes.
  void copy_picture();
  /// Puts the samples of a pulse onto the clipboard, for a spreadsheet: that of the first cursor, or the middle one.
  void copy_values();
  /// Asks for a name and writes the picture with its axes.
  void save_picture();
  /// Adds the window to the script as a simulation.
  void store_simulation();

 signals:
  /// With the axes along which others may follow.
  void view_changed(const sarsim::picture::EchoView& view, sarsim::picture::AxisLink link);
  /// The user wants the data in a file.
  void save_data_wanted(const sarsim::scene::Simulation& simulation);
  void changed();              ///< Scene, view, recording or cursor: what other views of it show.
  void finished();             ///< All samples of the view are shown.
  void set_aside(bool aside);  ///< It goes out of sight with its document, or comes back.

 protected:
  void closeEvent(QCloseEvent* event) override;

 private:
  [[nodiscard]] QWidget* make_tool_row();
  [[nodiscard]] QWidget* make_foot();
  void add_views_menu(QWidget* row);
  QToolButton* add_tool(QWidget* row, const QString& text, const char* name, const QString& tip);
  void connect_all();
  void change_view(const picture::EchoView& view);
  void take_state(const picture::EchoWindow& window);
  void follow_scene(const scene::SceneChange& change);
  void follow_radar(const scene::SceneChange& change);
  void compute();
  void compute_soon();
  void take_event(const picture::PreviewEvent& event);
  void show_event();
  void show_failure(const core::Problems& problems);
  void show_read_out();
  void show_cuts();
  void show_state();
  [[nodiscard]] QString title() const;

  Session& session_;
  int document_ = 0;
  std::shared_ptr<const scene::Scene> scene_;
  picture::EchoWindow window_;
  picture::ViewHistory<picture::EchoView> history_;
  bool show_all_ = false;
  EchoControls* controls_ = nullptr;
  EchoPlot* plot_ = nullptr;
  FigurePlot* cuts_ = nullptr;
  QToolButton* settings_ = nullptr;
  QToolButton* back_ = nullptr;
  QToolButton* forward_ = nullptr;
  QToolButton* show_cuts_ = nullptr;
  ReservedLabel* read_out_ = nullptr;
  ReservedLabel* difference_ = nullptr;
  QLabel* highest_ = nullptr;
  ReservedLabel* warning_ = nullptr;
  QProgressBar* progress_ = nullptr;
  ProblemLine* problems_ = nullptr;
  QTimer debounce_;
  std::mutex lock_;                              // of `latest_`
  std::optional<picture::PreviewEvent> latest_;  // from the threads that compute
  std::uint64_t request_ = 0;
  bool computing_ = false;
  bool finished_ = false;
  std::unique_ptr<picture::Preview> preview_;  // last: ends before what its events touch
};

}  // namespace sarsim::gui
