#pragma once

#include <QMainWindow>
#include <QTimer>

#include <functional>
#include <map>
#include <set>
#include <vector>

#include "gui/common/appearance.hpp"
#include "gui/common/session.hpp"
#include "gui/frame/guide_site.hpp"
#include "scene/model/object.hpp"

class QDockWidget;
class QLabel;
class QToolBar;

namespace sarsim::gui {

class DataSaver;
class DocumentKeeper;
class EchoPanel;
class ImageViewers;
class LayoutKeeper;
class ObjectTree;
class ProblemWatch;
class PropertyPanel;
class ScenePanel;
class ScriptEditor;
class SimulationWindow;
class SimulationWindows;
class StartGuide;
class StoredSimulations;
class ToolWindows;
struct Workbench;

/// The workbench: the scene in the middle, objects, properties, script and stored simulations around it (thesis 4.1).
/// Menus carry the words of the thesis.
class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  explicit MainWindow(QWidget* parent = nullptr);
  ~MainWindow() override;

  [[nodiscard]] Session& session() { return session_; }
  [[nodiscard]] DocumentKeeper& documents() { return *documents_; }
  [[nodiscard]] ScenePanel& scene() { return *scene_; }
  [[nodiscard]] SimulationWindows& simulation_windows() { return *simulation_windows_; }
  [[nodiscard]] ImageViewers& image_viewers() { return *image_viewers_; }
  [[nodiscard]] DataSaver& saver() { return *saver_; }
  /// Opens a script as a document beside those that are open, or a file of samples in a viewer. False where it failed;
  /// what is wrong with samples is told in the viewer.
  bool open_any(const QString& path);
  /// Named widgets that can be made into a picture: main, objects, properties, script, simulations, log, geometry,
  /// simulation, compressed, save_data, saving, range_profile, range_doppler, doppler_time, spectrum, phase_history,
  /// products, image, viewer, output, targets, function, commands, help, import, welcome, tour. Null for another name;
  /// some need a scene that has what they show. Simulation and what belongs to it show the stored simulation that is
  /// selected; where none is, a new window of raw echoes.
  [[nodiscard]] QWidget* window_named(const QString& name);
  /// The names that `window_named` knows.
  [[nodiscard]] static QStringList window_names();
  /// Shows the panels of a layout: "scene", "echoes", "views" (echoes and image beside the scene), "script", or one
  /// that was saved. False where there is none of that name.
  bool apply_layout(const QString& name);
  /// The layouts that there are, those that the program brings first.
  [[nodiscard]] QStringList layout_names() const;
  /// Keeps the panels as they are under a name.
  void save_layout(const QString& name);
  /// Begins with a layout, whatever was kept of the last time.
  void use_layout(const QString& name);
  /// The layout of a user who has not chosen any; "scene" unless said.
  void set_first_layout(const QString& name);
  /// Light, dark, or as the desktop has it.
  void set_appearance(Appearance appearance);
  /// The site that F1 and Help open; without it, and where it cannot be shown, they open a window of the program.
  void set_guide(GuideSite guide);

  /// What would be lost with the window, in words: runs, files that are being written, images that are being made.
  [[nodiscard]] QStringList work_under_way() const;
  /// Asked once before closing ends all of that. A message box unless replaced.
  std::function<bool(const QStringList& work)> ask_end_work;

 protected:
  void showEvent(QShowEvent* event) override;
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  QDockWidget* add_dock(QWidget* widget, const QString& title, const char* name, Qt::DockWidgetArea area);
  void make_docks();
  [[nodiscard]] Workbench parts();
  void make_menus();
  void show_title();
  void show_state();
  void make_badge();
  void make_document_row();
  void show_document_row();
  void turn_to_document(int index);
  void step_to_document(int step);
  void close_document(int index);
  void close_what_is_active();
  bool may_end_work();
  void end_work();
  void add_new(scene::AnyObject object);
  void edit_object(scene::ObjectId id);
  void edit_function(scene::ObjectId id, const QString& field);
  [[nodiscard]] std::vector<QWidget*> panels_in_view() const;
  void go_to_panel(int step);
  void show_object_menu(std::optional<scene::ObjectId> id, QPoint global);
  void make_echo_dock();
  void show_first_echoes();
  void place_echoes(SimulationWindow* window);

  Session session_;
  DocumentKeeper* documents_ = nullptr;
  ToolWindows* tools_ = nullptr;
  LayoutKeeper* layouts_ = nullptr;
  StartGuide* start_ = nullptr;
  ProblemWatch* problems_ = nullptr;
  ScenePanel* scene_ = nullptr;
  ObjectTree* tree_ = nullptr;
  PropertyPanel* panel_ = nullptr;
  ScriptEditor* script_ = nullptr;
  StoredSimulations* simulations_ = nullptr;
  SimulationWindows* simulation_windows_ = nullptr;
  ImageViewers* image_viewers_ = nullptr;
  DataSaver* saver_ = nullptr;
  EchoPanel* echoes_ = nullptr;
  QTimer first_echoes_;
  std::set<int> has_had_echoes_;  // numbers of documents
  QLabel* state_ = nullptr;
  QToolBar* document_row_ = nullptr;
  std::map<QString, QDockWidget*> docks_;
  bool sized_ = false;
};

}  // namespace sarsim::gui
