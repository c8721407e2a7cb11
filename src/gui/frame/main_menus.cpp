#include "gui/frame/main_menus.hpp"

#include <QActionGroup>
#include <QApplication>
#include <QDir>
#include <QDockWidget>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QSettings>

#include <tuple>

#include "gui/common/icons.hpp"
#include "gui/common/session.hpp"
#include "gui/echo/data_saver.hpp"
#include "gui/echo/simulation_windows.hpp"
#include "gui/frame/document_keeper.hpp"
#include "gui/frame/help_key.hpp"
#include "gui/frame/layout_keeper.hpp"
#include "gui/frame/tool_bar.hpp"
#include "gui/frame/tool_windows.hpp"
#include "gui/image/image_viewer.hpp"
#include "gui/image/image_viewers.hpp"
#include "gui/image/open_image_dialog.hpp"
#include "gui/objects/import_dialog.hpp"
#include "gui/objects/object_tree.hpp"
#include "gui/runs/save_queue.hpp"
#include "gui/runs/stored_simulations.hpp"
#include "gui/scene/scene_panel.hpp"
#include "gui/scene/scene_widget.hpp"
#include "gui/script/script_editor.hpp"
#include "scene/schema/fields.hpp"

namespace sarsim::gui {

MainMenus::MainMenus(const Workbench& parts, ToolWindows& tools, LayoutKeeper& layouts, QMainWindow& window)
    : QObject(&window), parts_(parts), tools_(tools), layouts_(layouts), window_(window) {
  make_menus();
  make_tool_bar();
  connect(&parts_.documents, &DocumentKeeper::recent_changed, this, &MainMenus::fill_recent);
  fill_recent();
}

QAction* MainMenus::add_action(QMenu* menu, const QString& text, const char* name, const QKeySequence& keys,
                               const std::function<void()>& work, const QString& tip) {
  auto* action = new QAction(text, &window_);
  action->setObjectName(name);
  action->setShortcut(keys);
  // Also where a simulation window or viewer has the keyboard; F1 is of the window that has it.
  if (keys != QKeySequence(QKeySequence::HelpContents)) action->setShortcutContext(Qt::ApplicationShortcut);
  action->setProperty("menu", menu->title().remove('&'));
  if (!tip.isEmpty()) action->setToolTip(tip), action->setStatusTip(tip);
  connect(action, &QAction::triggered, this, work);
  menu->addAction(action);
  return action;
}

void MainMenus::add_switch(QMenu* menu, const QString& text, const char* name, bool picture::DrawingOptions::*option) {
  QAction* action = add_action(menu, text, name, {}, {[] {}});
  action->setCheckable(true);
  action->setChecked(parts_.scene.scene().options().*option);
  connect(action, &QAction::toggled, this, [this, option](bool on) {
    picture::DrawingOptions options = parts_.scene.scene().options();
    options.*option = on;
    parts_.scene.scene().set_options(options);
    parts_.scene.show_time();  // what is seen may ask for more of the snapshot
  });
}

// Icons of commands: in menus, and in the tool bar, where some have shorter words.
void MainMenus::give_icons() {
  struct Look {
    const char* action;
    const char* icon;
    QString words;  // in the tool bar; empty: those of the menu
  };
  const Look looks[] = {{"file_new", "new", {}},
                        {"file_open", "open", tr("Open")},
                        {"file_save", "save", {}},
                        {"edit_undo", "undo", tr("Undo")},
                        {"edit_redo", "redo", tr("Redo")},
                        {"edit_search", "search", tr("Search")},
                        {"new_target", "target", tr("Target")},
                        {"new_surface", "surface", tr("Surface")},
                        {"new_platform", "platform", tr("Platform")},
                        {"new_radar", "radar", tr("Radar")},
                        {"view_focus", "focus", tr("Focus")},
                        {"view_fit", "fit", tr("Show All")},
                        {"simulation_raw", "echoes", tr("Echoes")},
                        {"display_products", "image", tr("Image")},
                        {"simulation_run", "run", tr("Run")},
                        {"help_welcome", "welcome", {}},
                        {"help_tour", "tour", {}},
                        {"help_contents", "help", tr("Help")}};
  for (const Look& look : looks)
    if (auto* action = window_.findChild<QAction*>(look.action)) {
      action->setIcon(icon_of(look.icon));
      if (!look.words.isEmpty()) action->setIconText(look.words);
    }
}

void MainMenus::make_menus() {
  make_file_menu();
  make_edit_menu();
  make_geometry_menu();
  make_simulation_menu();
  make_view_menu();
  make_help_menu();
  give_icons();
}

void MainMenus::make_file_menu() {
  QMenu* file = window_.menuBar()->addMenu(tr("&File"));
  add_action(file, tr("&New"), "file_new", QKeySequence::New, [this] {
    parts_.commit_typed();
    parts_.documents.make_new();
  });
  add_action(file, tr("&Open…"), "file_open", QKeySequence::Open, [this] {
    parts_.commit_typed();
    parts_.documents.open();
  });
  recent_ = file->addMenu(tr("Open &Recent"));
  make_example_menu(file->addMenu(tr("&Examples")));
  file->addSeparator();
  add_action(file, tr("&Save"), "file_save", QKeySequence::Save, [this] {
    parts_.commit_typed();
    parts_.documents.save();
  });
  add_action(file, tr("Save &As…"), "file_save_as", QKeySequence("Ctrl+Shift+S"), [this] {
    parts_.commit_typed();
    parts_.documents.save_as();
  });
  file->addSeparator();
  add_action(
      file, tr("&Close"), "file_close", QKeySequence("Ctrl+W"), [this] { emit close_wanted(); },
      tr("Close this scene, or the window that is in front"));
  QAction* next = add_action(
      file, tr("Nex&t Scene"), "file_next", QKeySequence("Ctrl+PgDown"), [this] { emit document_step_wanted(1); },
      tr("Go to the next open scene"));
  next->setShortcuts({QKeySequence("Ctrl+PgDown"), QKeySequence("Ctrl+Tab")});
  QAction* previous = add_action(
      file, tr("&Previous Scene"), "file_previous", QKeySequence("Ctrl+PgUp"),
      [this] { emit document_step_wanted(-1); }, tr("Go to the previous open scene"));
  previous->setShortcuts({QKeySequence("Ctrl+PgUp"), QKeySequence("Ctrl+Shift+Tab")});
  file->addSeparator();
  add_action(
      file, tr("&Import Targets…"), "file_import", {}, [this] { ImportDialog(parts_.session, &window_).exec(); },
      tr("Read targets from a file of x, y, z and perhaps RCS"));
  file->addSeparator();
  add_action(file, tr("E&xit"), "file_exit", QKeySequence("Ctrl+Q"), [this] { window_.close(); });
}

// The scenes in format 2, and below them the same in the language of 1998.
void MainMenus::make_example_menu(QMenu* examples) {
  examples->setObjectName("file_examples");
  const QDir folder(QString::fromStdString(DocumentKeeper::examples_folder().string()));
  const auto add = [&](QMenu* menu, const char* names) {
    for (const QString& name : folder.entryList({names}, QDir::Files, QDir::Name))
      connect(menu->addAction(name), &QAction::triggered, this, [this, path = folder.filePath(name)] {
        parts_.commit_typed();
        parts_.documents.open_example(path);
      });
  };
  add(examples, "*.toml");
  examples->addSeparator();
  QMenu* scripts = examples->addMenu(tr("In the &Language of 1998"));
  add(scripts, "*.scr");
  examples->setEnabled(!scripts->isEmpty());
}

void MainMenus::fill_recent() {
  recent_->clear();
  for (const QString& path : parts_.documents.recent())
    connect(recent_->addAction(path), &QAction::triggered, this, [this, path] { emit file_wanted(path); });
  recent_->setEnabled(!recent_->isEmpty());
}

void MainMenus::make_edit_menu() {
  QMenu* edit = window_.menuBar()->addMenu(tr("&Edit"));
  QAction* undo = add_action(edit, tr("&Undo"), "edit_undo", QKeySequence::Undo, [this] {
    parts_.script.commit();
    parts_.session.undo();
  });
  QAction* redo = add_action(edit, tr("&Redo"), "edit_redo", QKeySequence::Redo, [this] { parts_.session.redo(); });
  redo->setShortcuts({QKeySequence("Ctrl+Shift+Z"), QKeySequence("Ctrl+Y")});
  const auto show = [this, undo, redo] {
    const scene::History& history = parts_.session.document().history();
    undo->setEnabled(history.can_undo());
    redo->setEnabled(history.can_redo());
    undo->setText(tr("&Undo %1").arg(QString::fromStdString(history.undo_label())).trimmed());
    redo->setText(tr("&Redo %1").arg(QString::fromStdString(history.redo_label())).trimmed());
  };
  connect(&parts_.session, &Session::scene_changed, this, show);
  show();
  edit->addSeparator();
  add_action(edit, tr("&Modify"), "edit_modify", {}, [this] {
    if (parts_.session.current()) emit edit_wanted(*parts_.session.current());
  });
  QMenu* functions = edit->addMenu(tr("&Functions"));
  functions->setObjectName("edit_functions");
  const auto offer = [this, functions] {
    fill_functions(functions);
    functions->setEnabled(!functions->isEmpty());
  };
  connect(&parts_.session, &Session::selection_changed, this, offer);
  connect(&parts_.session, &Session::scene_changed, this, [this, offer](const scene::SceneChange& change) {
    const auto current = parts_.session.current();
    if (!change.same_objects() || (current && change.concerns(*current))) offer();
  });
  offer();
  add_action(edit, tr("&Delete"), "edit_delete", {}, [this] { parts_.tree.delete_selection(); });
  add_action(edit, tr("Du&plicate"), "edit_duplicate", QKeySequence("Ctrl+D"),
             [this] { parts_.tree.duplicate_selection(); });
  add_action(edit, tr("Re&name"), "edit_rename", {}, [this] { parts_.tree.rename_current(); });
  add_action(edit, tr("&Table of Targets"), "edit_targets", QKeySequence("Ctrl+T"), [this] { tools_.show_targets(); });
  add_action(edit, tr("&Scene Settings"), "edit_options", {}, [this] {
    parts_.session.select({});
    parts_.bring("properties");
  });
  edit->addSeparator();
  QAction* search = add_action(
      edit, tr("Searc&h…"), "edit_search", QKeySequence("Ctrl+K"), [this] { emit search_wanted(); },
      tr("Find a command, a field of the scene or a page of the guide by a few letters"));
  search->setShortcuts({QKeySequence("Ctrl+K"), QKeySequence("Ctrl+Shift+P")});
}

// The functions that mean something for the current object as it is.
void MainMenus::fill_functions(QMenu* menu) {
  menu->clear();
  const auto current = parts_.session.current();
  if (!current) return;
  const scene::AnyObject object = scene::object_of(parts_.session.scene(), *current);
  for (const scene::Field& field : scene::fields_of(current->kind))
    if (field.kind == scene::FieldKind::function && scene::field_applies(object, field.id))
      connect(menu->addAction(QString::fromStdString(field.label) + QString::fromUtf8("…")), &QAction::triggered, this,
              [this, id = *current, name = QString::fromStdString(field.id)] { emit function_wanted(id, name); });
}

void MainMenus::make_geometry_menu() {
  QMenu* geometry = window_.menuBar()->addMenu(tr("&Geometry"));
  add_action(
      geometry, tr("New &Target"), "new_target", QKeySequence("Ctrl+1"),
      [this] { emit object_wanted(scene::Target()); }, tr("Add a point scatterer"));
  add_action(
      geometry, tr("New &Platform"), "new_platform", QKeySequence("Ctrl+2"),
      [this] {
        scene::Platform platform;
        platform.name = "Platform";
        emit object_wanted(platform);
      },
      tr("Add a frame that moves and turns and carries targets and radars"));
  add_action(
      geometry, tr("New &Radar"), "new_radar", QKeySequence("Ctrl+3"), [this] { emit object_wanted(scene::Radar()); },
      tr("Add a transmitter and receiver at the origin of a platform"));
  add_action(
      geometry, tr("New &Surface"), "new_surface", QKeySequence("Ctrl+4"),
      [this] { emit object_wanted(scene::Surface()); }, tr("Add a triangle sampled by point scatterers"));
  add_action(
      geometry, tr("New &Cloud"), "new_cloud", {}, [this] { emit object_wanted(scene::Cloud()); },
      tr("Add many point scatterers, from an NPY, CSV or HDF5 table"));
}

void MainMenus::make_simulation_menu() {
  QMenu* simulation = window_.menuBar()->addMenu(tr("&Simulation"));
  const auto open = [this](scene::Processing processing) {
    if (parts_.simulation_windows.open_new(processing) == nullptr)
      QMessageBox::information(&window_, tr("Simulation"),
                               tr("There is no radar. Create one first: Geometry, New Radar."));
  };
  add_action(
      simulation, tr("&Raw Return"), "simulation_raw", QKeySequence("Ctrl+R"), [open] { open(scene::Processing::raw); },
      tr("Raw samples at the A/D converter, following the scene"));
  add_action(
      simulation, tr("Range &Compressed"), "simulation_compressed", QKeySequence("Ctrl+Shift+R"),
      [open] { open(scene::Processing::matched_filter); }, tr("Echoes after the matched filter"));
  add_action(simulation, tr("Recor&dings"), "simulation_stored", {}, [this] { parts_.bring("simulations"); });
  add_action(
      simulation, tr("&Geometry"), "simulation_geometry", QKeySequence("Ctrl+G"), [this] { tools_.show_geometry(); },
      tr("Table of ranges, delays, amplitudes and speeds for every pulse"));
  add_action(
      simulation, tr("Sa&ving"), "simulation_saving", {},
      [this] { parts_.saver.queue().show(), parts_.saver.queue().raise(); },
      tr("Files being saved, and the results of earlier ones"));
  simulation->addSeparator();
  add_action(
      simulation, tr("R&un"), "simulation_run", QKeySequence("F5"),
      [this] {
        parts_.commit_typed();
        parts_.bring("simulations");
        if (!parts_.simulations.chosen() && !parts_.session.scene().simulations.empty())
          parts_.simulations.choose({scene::ObjectKind::simulation, 0});
        parts_.simulations.run_chosen();
      },
      tr("Run the chosen simulation into its file"));

  QMenu* display = window_.menuBar()->addMenu(tr("&Display"));
  add_action(
      display, tr("Simulation &Output…"), "display_output", QKeySequence("Ctrl+Shift+O"),
      [this] { parts_.image_viewers.ask_file(); }, tr("Open a file of samples, of any size, or a picture"));
  add_action(
      display, tr("&Make an Image…"), "display_products", QKeySequence("Ctrl+Shift+M"),
      [this] { tools_.show_products(); }, tr("Focus the echoes, or form range profiles, Doppler maps or a PPI"));
  add_action(display, tr("&Script File"), "display_script", QKeySequence("Ctrl+E"), [this] {
    parts_.bring("script");
    parts_.script.setFocus();
  });
}

void MainMenus::make_view_menu() {
  QMenu* view = window_.menuBar()->addMenu(tr("&View"));
  add_action(
      view, tr("&Focus…"), "view_focus", {}, [this] { tools_.show_focus(); },
      tr("Look at a point, or follow a platform"));
  make_hand_entries(view);
  for (const auto& [text, name, preset] : {std::tuple{tr("From A&bove"), "view_top", picture::ViewPreset::top},
                                           std::tuple{tr("From the F&ront"), "view_front", picture::ViewPreset::front},
                                           std::tuple{tr("From the S&ide"), "view_side", picture::ViewPreset::side},
                                           std::tuple{tr("Default View"), "view_start", picture::ViewPreset::start}})
    add_action(view, text, name, {}, [this, preset = preset] { parts_.scene.scene().look(preset); });
  QAction* perspective = add_action(view, tr("&Perspective"), "view_perspective", {}, {[] {}});
  perspective->setCheckable(true);
  connect(perspective, &QAction::toggled, this, [this](bool on) {
    picture::Camera camera = parts_.scene.scene().camera();
    camera.perspective = on;
    parts_.scene.scene().set_camera(camera);
  });
  view->addSeparator();
  add_switch(view, tr("&Coordinate Systems"), "view_axes", &picture::DrawingOptions::coordinate_systems);
  add_switch(view, tr("Corner Tria&d"), "view_triad", &picture::DrawingOptions::corner_triad);
  add_switch(view, tr("&Elevation Lines"), "view_lines", &picture::DrawingOptions::elevation_lines);
  add_switch(view, tr("Ground Grid"), "view_grid", &picture::DrawingOptions::ground_grid);
  add_switch(view, tr("Footprints"), "view_footprints", &picture::DrawingOptions::footprints);
  add_switch(view, tr("Filled &Surfaces"), "view_filled", &picture::DrawingOptions::filled_surfaces);
  add_switch(view, tr("&Labels"), "view_labels", &picture::DrawingOptions::labels);
  add_switch(view, tr("&Trails"), "view_trails", &picture::DrawingOptions::trails);
  add_switch(view, tr("Pattern L&obes"), "view_lobes", &picture::DrawingOptions::lobes);
  add_switch(view, tr("Platform Symbols"), "view_symbols", &picture::DrawingOptions::symbols);
  add_switch(view, tr("Illuminated Ground"), "view_illuminated", &picture::DrawingOptions::illuminated);
  add_switch(view, tr("Sky"), "view_sky", &picture::DrawingOptions::sky);
  make_track_menu(view->addMenu(tr("Colours of Trails")));
  view->addSeparator();
  QMenu* looks = view->addMenu(tr("Colo&urs"));
  auto* group = new QActionGroup(&window_);
  for (const auto& [text, name, appearance] : {std::tuple{tr("Follow &System"), "colours_system", Appearance::system},
                                               std::tuple{tr("&Light"), "colours_light", Appearance::light},
                                               std::tuple{tr("&Dark"), "colours_dark", Appearance::dark}}) {
    QAction* action = add_action(looks, text, name, {}, [this, appearance = appearance] {
      QSettings().setValue("appearance", static_cast<int>(appearance));
      emit appearance_wanted(appearance);
    });
    action->setCheckable(true);
    action->setChecked(QSettings().value("appearance").toInt() == static_cast<int>(appearance));
    group->addAction(action);
  }
  QMenu* layouts = view->addMenu(tr("La&youts"));
  layouts->setObjectName("view_layouts");
  connect(layouts, &QMenu::aboutToShow, this, [this, layouts] { layouts_.fill(*layouts); });
  QMenu* panels = view->addMenu(tr("&Windows"));
  for (const char* name : {"objects", "properties", "echoes", "image", "script", "simulations", "log"})
    panels->addAction(parts_.docks.at(name)->toggleViewAction());
  for (const auto& [name, dock] : parts_.docks) dock->toggleViewAction()->setObjectName("window_" + name);
  add_action(
      view, tr("Go to Ne&xt Panel"), "view_next_panel", QKeySequence("F6"), [this] { emit panel_step_wanted(1); },
      tr("Move the keyboard focus to the next panel"));
  add_action(
      view, tr("Go to Pre&vious Panel"), "view_previous_panel", QKeySequence("Shift+F6"),
      [this] { emit panel_step_wanted(-1); }, tr("Move the keyboard focus to the previous panel"));
  add_action(
      view, tr("Reset Layout"), "view_reset", {}, [this] { layouts_.reset(); },
      tr("Put all windows back to their first places"));
}

void MainMenus::make_hand_entries(QMenu* view) {
  add_action(
      view, tr("Orbit About Selectio&n"), "view_focus_selection", {}, [this] { parts_.scene.focus_on_selection(); },
      tr("Put what is selected into the middle, about which the view turns"));
  add_action(
      view, tr("&Zoom to Selection"), "view_zoom_selection", {}, [this] { parts_.scene.zoom_to_selection(); },
      tr("Fill the scene with what is selected; in the scene the key F or ."));
  add_action(
      view, tr("Show &All"), "view_fit", {}, [this] { parts_.scene.scene().fit(); },
      tr("Show everything; in the scene the key Home"));
  add_action(
      view, tr("Along the Bea&m"), "view_beam", {}, [this] { parts_.scene.look_along_beam(); },
      tr("Look along the beam of the selected radar, or of the first; in the scene the key 4"));
  QAction* follow = add_action(
      view, tr("Follow Selection"), "view_follow", {}, [this] { parts_.scene.follow_selection(); },
      tr("The view goes with what is selected as time runs; in the scene the key 5"));
  follow->setCheckable(true);
  connect(&parts_.scene, &ScenePanel::ride_changed, follow,
          [this, follow] { follow->setChecked(parts_.scene.ride() == ScenePanel::Ride::follow); });
  QMenu* cameras = view->addMenu(tr("Cameras"));
  cameras->setObjectName("view_cameras");
  cameras->setToolTip(tr("Every view of this scene by its name"));
  connect(cameras, &QMenu::aboutToShow, &parts_.scene, [this, cameras] { parts_.scene.fill_cameras(*cameras); });
  QAction* measure = add_action(
      view, tr("Measure Distance"), "view_measure", {}, {[] {}},
      tr("Click two points of the scene: distance, height and angles; Escape ends it; in the scene the key M"));
  measure->setCheckable(true);
  connect(measure, &QAction::toggled, &parts_.scene, &ScenePanel::measure);
  QAction* path = add_action(view, tr("Draw Path"), "view_draw_path", {}, {[] {}},
                             tr("Clicks put waypoints or legs behind the path of the selected platform; Enter ends it; "
                                "in the scene the key P"));
  path->setCheckable(true);
  connect(path, &QAction::toggled, &parts_.scene, &ScenePanel::draw_path);
  // The tool as it is: one that was refused has gone back already.
  connect(&parts_.scene.scene(), &SceneWidget::tool_changed, this, [this, measure, path] {
    measure->setChecked(parts_.scene.scene().tool() == SceneWidget::Tool::ruler);
    path->setChecked(parts_.scene.scene().tool() == SceneWidget::Tool::path);
  });
  add_action(
      view, tr("Add Waypoint Here"), "view_add_waypoint", {}, [this] { parts_.scene.add_point_here(); },
      tr("Put a point into the path of the selected platform under the pointer; or double click on the path"));
  add_action(
      view, tr("Delete Waypoint"), "view_delete_waypoint", {}, [this] { parts_.scene.delete_point(); },
      tr("Take the selected point out of its path; in the scene the key Delete"));
  QAction* own = add_action(
      view, tr("&Handles Along Own Axes"), "view_own_axes", {}, {[] {}},
      tr("Arrows of what is selected lie along the axes of its platform, not the world's; in the scene the key L"));
  own->setCheckable(true);
  connect(own, &QAction::toggled, &parts_.scene, &ScenePanel::set_own_axes);
  connect(&parts_.scene, &ScenePanel::own_axes_changed, own, &QAction::setChecked);
}

void MainMenus::make_track_menu(QMenu* menu) {
  using Tracks = picture::DrawingOptions::Tracks;
  auto* group = new QActionGroup(&window_);
  for (const auto& [text, name, tracks] : {std::tuple{tr("&Plain"), "trails_plain", Tracks::plain},
                                           std::tuple{tr("By &Time"), "trails_time", Tracks::by_time},
                                           std::tuple{tr("By &Speed"), "trails_speed", Tracks::by_speed}}) {
    QAction* action = add_action(menu, text, name, {}, [this, tracks = tracks] {
      picture::DrawingOptions options = parts_.scene.scene().options();
      options.tracks = tracks;
      parts_.scene.scene().set_options(options);
    });
    action->setCheckable(true);
    action->setChecked(tracks == Tracks::plain);
    group->addAction(action);
  }
}

void MainMenus::make_help_menu() {
  QMenu* help = window_.menuBar()->addMenu(tr("&Help"));
  add_action(help, tr("&Contents"), "help_contents", {}, [this] { tools_.show_help({"README.md", {}}); });
  add_action(
      help, tr("Help on This &Window"), "help_window_page", QKeySequence::HelpContents,
      [this] { tools_.show_help(help_place_of(window_.focusWidget())); },
      tr("The page of the guide for the panel that has the keyboard"));
  connect(new HelpKey(&window_), &HelpKey::pressed, this,
          [this](const QWidget* where) { tools_.show_help(help_place_of(where)); });
  help->addSeparator();
  add_action(
      help, tr("W&elcome"), "help_welcome", {}, [this] { emit welcome_wanted(); },
      tr("Examples as pictures, scenes to begin with, recent files"));
  add_action(
      help, tr("&Tour"), "help_tour", {}, [this] { emit tour_wanted(); },
      tr("The first example of the thesis, step by step: one radar, one target and its echo"));
  help->addSeparator();
  add_action(help, tr("&About"), "help_about", {}, [this] { tools_.show_about(); });
}

void MainMenus::make_tool_bar() {
  auto* bar = new ToolBar(tr("Tools"));
  window_.addToolBar(bar);
  bar->setObjectName("tool_bar");
  const auto put = [&](std::initializer_list<const char*> names) {
    for (const char* name : names) bar->addAction(window_.findChild<QAction*>(name));
    bar->addSeparator();
  };
  put({"file_open", "file_save"});
  put({"edit_undo", "edit_redo"});
  put({"new_target", "new_surface", "new_platform", "new_radar"});
  put({"view_focus", "view_fit"});
  for (const char* name : {"simulation_raw", "display_products"}) bar->add_worded(window_.findChild<QAction*>(name));
  bar->add_primary(window_.findChild<QAction*>("simulation_run"));
  bar->add_gap();
  for (const char* name : {"edit_search", "help_contents"}) bar->addAction(window_.findChild<QAction*>(name));
}

}  // namespace sarsim::gui
