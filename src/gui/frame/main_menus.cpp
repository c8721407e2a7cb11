// The menus, the tool bar and the small dialogs of the main window.

#include <qcustomplot.h>
#include <QActionGroup>
#include <QApplication>
#include <QComboBox>
#include <QDesktopServices>
#include <QDialogButtonBox>
#include <QDir>
#include <QDockWidget>
#include <QEventLoop>
#include <QFormLayout>
#include <QLineEdit>
#include <QMenuBar>
#include <QMessageBox>
#include <QSettings>
#include <QTimer>

#include "core/build/version.hpp"
#include "core/maths/rounding.hpp"
#include "gui/common/icons.hpp"
#include "gui/echo/data_saver.hpp"
#include "gui/echo/radar_view_window.hpp"
#include "gui/echo/simulation_window.hpp"
#include "gui/echo/simulation_windows.hpp"
#include "gui/frame/document_keeper.hpp"
#include "gui/frame/help_key.hpp"
#include "gui/frame/help_window.hpp"
#include "gui/frame/main_window.hpp"
#include "gui/frame/tool_bar.hpp"
#include "gui/image/image_viewer.hpp"
#include "gui/image/image_viewers.hpp"
#include "gui/image/open_image_dialog.hpp"
#include "gui/objects/function_editor.hpp"
#include "gui/objects/import_dialog.hpp"
#include "gui/objects/object_tree.hpp"
#include "gui/objects/target_table.hpp"
#include "gui/runs/product_window.hpp"
#include "gui/runs/save_data_dialog.hpp"
#include "gui/runs/save_queue.hpp"
#include "gui/runs/stored_simulations.hpp"
#include "gui/scene/geometry_window.hpp"
#include "gui/scene/scene_panel.hpp"
#include "gui/scene/scene_widget.hpp"
#include "gui/scene/time_bar.hpp"
#include "gui/script/script_editor.hpp"
#include "gui/start/search_box.hpp"
#include "gui/start/tour_panel.hpp"
#include "gui/start/welcome_page.hpp"
#include "picture/figure/ticks.hpp"
#include "scene/schema/fields.hpp"

namespace sarsim::gui {

namespace {

constexpr int longest_picture_ms = 5000;

}  // namespace

QAction* MainWindow::add_action(QMenu* menu, const QString& text, const char* name, const QKeySequence& keys,
                                const std::function<void()>& work, const QString& tip) {
  auto* action = new QAction(text, this);
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

void MainWindow::add_switch(QMenu* menu, const QString& text, const char* name, bool picture::DrawingOptions::*option) {
  QAction* action = add_action(menu, text, name, {}, {[] {}});
  action->setCheckable(true);
  action->setChecked(scene_->scene().options().*option);
  connect(action, &QAction::toggled, this, [this, option](bool on) {
    picture::DrawingOptions options = scene_->scene().options();
    options.*option = on;
    scene_->scene().set_options(options);
    scene_->show_time();  // what is seen may ask for more of the snapshot
  });
}

// Icons of commands: in menus, and in the tool bar, where some have shorter words.
void MainWindow::give_icons() {
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
    if (auto* action = findChild<QAction*>(look.action)) {
      action->setIcon(icon_of(look.icon));
      if (!look.words.isEmpty()) action->setIconText(look.words);
    }
}

void MainWindow::make_menus() {
  make_file_menu();
  make_edit_menu();
  make_geometry_menu();
  make_simulation_menu();
  make_view_menu();
  make_help_menu();
  give_icons();
}

void MainWindow::make_file_menu() {
  QMenu* file = menuBar()->addMenu(tr("&File"));
  add_action(file, tr("&New"), "file_new", QKeySequence::New, [this] {
    commit_typed();
    documents_->make_new();
  });
  add_action(file, tr("&Open…"), "file_open", QKeySequence::Open, [this] {
    commit_typed();
    documents_->open();
  });
  recent_ = file->addMenu(tr("Open &Recent"));
  make_example_menu(file->addMenu(tr("&Examples")));
  file->addSeparator();
  add_action(file, tr("&Save"), "file_save", QKeySequence::Save, [this] {
    commit_typed();
    documents_->save();
  });
  add_action(file, tr("Save &As…"), "file_save_as", QKeySequence("Ctrl+Shift+S"), [this] {
    commit_typed();
    documents_->save_as();
  });
  file->addSeparator();
  add_action(
      file, tr("&Close"), "file_close", QKeySequence("Ctrl+W"), [this] { close_what_is_active(); },
      tr("Close this scene, or the window that is in front"));
  QAction* next = add_action(
      file, tr("Nex&t Scene"), "file_next", QKeySequence("Ctrl+PgDown"), [this] { step_to_document(1); },
      tr("Turn to the next of the open scenes"));
  next->setShortcuts({QKeySequence("Ctrl+PgDown"), QKeySequence("Ctrl+Tab")});
  QAction* previous = add_action(
      file, tr("&Previous Scene"), "file_previous", QKeySequence("Ctrl+PgUp"), [this] { step_to_document(-1); },
      tr("Turn to the one before"));
  previous->setShortcuts({QKeySequence("Ctrl+PgUp"), QKeySequence("Ctrl+Shift+Tab")});
  file->addSeparator();
  add_action(
      file, tr("&Import Targets…"), "file_import", {}, [this] { ImportDialog(session_, this).exec(); },
      tr("Read targets from a file of x, y, z and perhaps RCS"));
  file->addSeparator();
  add_action(file, tr("E&xit"), "file_exit", QKeySequence("Ctrl+Q"), [this] { close(); });
}

// The scenes in format 2, and below them the same in the language of 1998.
void MainWindow::make_example_menu(QMenu* examples) {
  examples->setObjectName("file_examples");
  const QDir folder(QString::fromStdString(DocumentKeeper::examples_folder().string()));
  const auto add = [&](QMenu* menu, const char* names) {
    for (const QString& name : folder.entryList({names}, QDir::Files, QDir::Name))
      connect(menu->addAction(name), &QAction::triggered, this, [this, path = folder.filePath(name)] {
        commit_typed();
        documents_->open_example(path);
      });
  };
  add(examples, "*.toml");
  examples->addSeparator();
  QMenu* scripts = examples->addMenu(tr("In the &Language of 1998"));
  add(scripts, "*.scr");
  examples->setEnabled(!scripts->isEmpty());
}

void MainWindow::make_edit_menu() {
  QMenu* edit = menuBar()->addMenu(tr("&Edit"));
  QAction* undo = add_action(edit, tr("&Undo"), "edit_undo", QKeySequence::Undo, [this] {
    script_->commit();
    session_.undo();
  });
  QAction* redo = add_action(edit, tr("&Redo"), "edit_redo", QKeySequence::Redo, [this] { session_.redo(); });
  redo->setShortcuts({QKeySequence("Ctrl+Shift+Z"), QKeySequence("Ctrl+Y")});
  const auto show = [this, undo, redo] {
    const scene::History& history = session_.document().history();
    undo->setEnabled(history.can_undo());
    redo->setEnabled(history.can_redo());
    undo->setText(tr("&Undo %1").arg(QString::fromStdString(history.undo_label())).trimmed());
    redo->setText(tr("&Redo %1").arg(QString::fromStdString(history.redo_label())).trimmed());
  };
  connect(&session_, &Session::scene_changed, this, show);
  show();
  edit->addSeparator();
  add_action(edit, tr("&Modify"), "edit_modify", {}, [this] {
    if (session_.current()) edit_object(*session_.current());
  });
  QMenu* functions = edit->addMenu(tr("&Functions"));
  functions->setObjectName("edit_functions");
  const auto offer = [this, functions] {
    fill_functions(functions);
    functions->setEnabled(!functions->isEmpty());
  };
  connect(&session_, &Session::selection_changed, this, offer);
  connect(&session_, &Session::scene_changed, this, [this, offer](const scene::SceneChange& change) {
    const auto current = session_.current();
    if (!change.same_objects() || (current && change.concerns(*current))) offer();
  });
  offer();
  add_action(edit, tr("&Delete"), "edit_delete", {}, [this] { tree_->delete_selection(); });
  add_action(edit, tr("Du&plicate"), "edit_duplicate", QKeySequence("Ctrl+D"),
             [this] { tree_->duplicate_selection(); });
  add_action(edit, tr("Re&name"), "edit_rename", {}, [this] { tree_->rename_current(); });
  add_action(edit, tr("&Table of Targets"), "edit_targets", QKeySequence("Ctrl+T"), [this] { show_targets(); });
  add_action(edit, tr("Options of the &Script"), "edit_options", {}, [this] {
    session_.select({});
    docks_["properties"]->show();
    docks_["properties"]->raise();
  });
  edit->addSeparator();
  QAction* search = add_action(
      edit, tr("Searc&h…"), "edit_search", QKeySequence("Ctrl+K"), [this] { show_search(); },
      tr("Find a command, a field of the scene or a page of the guide by a few letters"));
  search->setShortcuts({QKeySequence("Ctrl+K"), QKeySequence("Ctrl+Shift+P")});
}

void MainWindow::make_geometry_menu() {
  QMenu* geometry = menuBar()->addMenu(tr("&Geometry"));
  add_action(
      geometry, tr("New &Target"), "new_target", QKeySequence("Ctrl+1"), [this] { add_new(scene::Target()); },
      tr("Add a point that reflects"));
  add_action(
      geometry, tr("New &Platform"), "new_platform", QKeySequence("Ctrl+2"),
      [this] {
        scene::Platform platform;
        platform.name = "Platform";
        add_new(platform);
      },
      tr("Add a frame that moves and turns and carries targets and radars"));
  add_action(
      geometry, tr("New &Radar"), "new_radar", QKeySequence("Ctrl+3"), [this] { add_new(scene::Radar()); },
      tr("Add a transmitter and receiver at the origin of a platform"));
  add_action(
      geometry, tr("New &Surface"), "new_surface", QKeySequence("Ctrl+4"), [this] { add_new(scene::Surface()); },
      tr("Add a triangle filled with points that reflect"));
  add_action(
      geometry, tr("New &Cloud"), "new_cloud", {}, [this] { add_new(scene::Cloud()); },
      tr("Add many points that reflect, from an NPY, CSV or HDF5 table"));
}

void MainWindow::make_simulation_menu() {
  QMenu* simulation = menuBar()->addMenu(tr("&Simulation"));
  const auto open = [this](scene::Processing processing) {
    if (simulation_windows_->open_new(processing) == nullptr)
      QMessageBox::information(this, tr("Simulation"), tr("There is no radar. Create one first: Geometry, New Radar."));
  };
  add_action(
      simulation, tr("&Raw Return"), "simulation_raw", QKeySequence("Ctrl+R"), [open] { open(scene::Processing::raw); },
      tr("See what the A/D converter delivers, as the scene changes"));
  add_action(
      simulation, tr("Range &Compressed"), "simulation_compressed", QKeySequence("Ctrl+Shift+R"),
      [open] { open(scene::Processing::matched_filter); }, tr("See what the matched filter makes of it"));
  add_action(simulation, tr("&Previously Stored"), "simulation_stored", {}, [this] {
    docks_["simulations"]->show();
    docks_["simulations"]->raise();
  });
  add_action(
      simulation, tr("&Geometry"), "simulation_geometry", QKeySequence("Ctrl+G"), [this] { show_geometry(); },
      tr("Table of ranges, delays, amplitudes and speeds for every pulse"));
  add_action(
      simulation, tr("Sa&ving"), "simulation_saving", {}, [this] { saver_->queue().show(), saver_->queue().raise(); },
      tr("Files that are being saved, and what came of those before"));
  simulation->addSeparator();
  add_action(
      simulation, tr("R&un"), "simulation_run", QKeySequence("F5"),
      [this] {
        commit_typed();
        docks_["simulations"]->show();
        docks_["simulations"]->raise();
        if (!simulations_->chosen() && !session_.scene().simulations.empty())
          simulations_->choose({scene::ObjectKind::simulation, 0});
        simulations_->run_chosen();
      },
      tr("Run the chosen simulation into its file"));

  QMenu* display = menuBar()->addMenu(tr("&Display"));
  add_action(
      display, tr("Simulation &Output…"), "display_output", QKeySequence("Ctrl+Shift+O"),
      [this] { image_viewers_->ask_file(); }, tr("Look into a file of samples, of any size, or a picture"));
  add_action(
      display, tr("&Make an Image…"), "display_products", QKeySequence("Ctrl+Shift+M"), [this] { show_products(); },
      tr("Focus the echoes, or make range profiles, Doppler maps or a search picture of them"));
  add_action(display, tr("&Script File"), "display_script", QKeySequence("Ctrl+E"), [this] {
    docks_["script"]->show();
    docks_["script"]->raise();
    script_->setFocus();
  });
}

void MainWindow::make_view_menu() {
  QMenu* view = menuBar()->addMenu(tr("&View"));
  add_action(
      view, tr("&Focus…"), "view_focus", {}, [this] { show_focus(); }, tr("Look at a point, or follow a platform"));
  make_hand_entries(view);
  for (const auto& [text, name, preset] :
       {std::tuple{tr("From A&bove"), "view_top", picture::ViewPreset::top},
        std::tuple{tr("From the F&ront"), "view_front", picture::ViewPreset::front},
        std::tuple{tr("From the S&ide"), "view_side", picture::ViewPreset::side},
        std::tuple{tr("As at the Be&ginning"), "view_start", picture::ViewPreset::start}})
    add_action(view, text, name, {}, [this, preset = preset] { scene_->scene().look(preset); });
  QAction* perspective = add_action(view, tr("&Perspective"), "view_perspective", {}, {[] {}});
  perspective->setCheckable(true);
  connect(perspective, &QAction::toggled, this, [this](bool on) {
    picture::Camera camera = scene_->scene().camera();
    camera.perspective = on;
    scene_->scene().set_camera(camera);
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
  auto* group = new QActionGroup(this);
  for (const auto& [text, name, appearance] : {std::tuple{tr("As the Deskto&p"), "colours_system", Appearance::system},
                                               std::tuple{tr("&Light"), "colours_light", Appearance::light},
                                               std::tuple{tr("&Dark"), "colours_dark", Appearance::dark}}) {
    QAction* action = add_action(looks, text, name, {}, [this, appearance = appearance] {
      QSettings().setValue("appearance", static_cast<int>(appearance));
      set_appearance(appearance);
    });
    action->setCheckable(true);
    action->setChecked(QSettings().value("appearance").toInt() == static_cast<int>(appearance));
    group->addAction(action);
  }
  QMenu* layouts = view->addMenu(tr("La&youts"));
  layouts->setObjectName("view_layouts");
  connect(layouts, &QMenu::aboutToShow, this, [this, layouts] { fill_layouts(layouts); });
  QMenu* panels = view->addMenu(tr("&Windows"));
  for (const char* name : {"objects", "properties", "echoes", "image", "script", "simulations", "log"})
    panels->addAction(docks_[name]->toggleViewAction());
  for (const auto& [name, dock] : docks_) dock->toggleViewAction()->setObjectName("window_" + name);
  add_action(
      view, tr("Ne&xt Panel"), "view_next_panel", QKeySequence("F6"), [this] { go_to_panel(1); },
      tr("Take the keyboard to the next panel"));
  add_action(
      view, tr("Pre&vious Panel"), "view_previous_panel", QKeySequence("Shift+F6"), [this] { go_to_panel(-1); },
      tr("Take the keyboard to the panel before"));
  add_action(
      view, tr("Reset Layout"), "view_reset", {}, [this] { reset_layout(); },
      tr("Put all windows back to their first places"));
}

void MainWindow::make_track_menu(QMenu* menu) {
  using Tracks = picture::DrawingOptions::Tracks;
  auto* group = new QActionGroup(this);
  for (const auto& [text, name, tracks] : {std::tuple{tr("&Plain"), "trails_plain", Tracks::plain},
                                           std::tuple{tr("By &Time"), "trails_time", Tracks::by_time},
                                           std::tuple{tr("By &Speed"), "trails_speed", Tracks::by_speed}}) {
    QAction* action = add_action(menu, text, name, {}, [this, tracks = tracks] {
      picture::DrawingOptions options = scene_->scene().options();
      options.tracks = tracks;
      scene_->scene().set_options(options);
    });
    action->setCheckable(true);
    action->setChecked(tracks == Tracks::plain);
    group->addAction(action);
  }
}

void MainWindow::make_help_menu() {
  QMenu* help = menuBar()->addMenu(tr("&Help"));
  add_action(help, tr("&Contents"), "help_contents", {}, [this] { show_help({"README.md", {}}); });
  add_action(
      help, tr("Help on This &Window"), "help_window_page", QKeySequence::HelpContents,
      [this] { show_help(help_place_of(focusWidget())); },
      tr("The page of the guide for the panel that has the keyboard"));
  connect(new HelpKey(this), &HelpKey::pressed, this,
          [this](const QWidget* where) { show_help(help_place_of(where)); });
  help->addSeparator();
  add_action(
      help, tr("W&elcome"), "help_welcome", {}, [this] { show_welcome(); },
      tr("Examples as pictures, scenes to begin with, recent files"));
  add_action(
      help, tr("&Tour"), "help_tour", {}, [this] { show_tour(); },
      tr("The first example of the thesis, step by step: one radar, one target and its echo"));
  help->addSeparator();
  add_action(help, tr("&About"), "help_about", {}, [this] { show_about(); });
}

void MainWindow::make_tool_bar() {
  auto* bar = new ToolBar(tr("Tools"));
  addToolBar(bar);
  bar->setObjectName("tool_bar");
  const auto put = [&](std::initializer_list<const char*> names) {
    for (const char* name : names) bar->addAction(findChild<QAction*>(name));
    bar->addSeparator();
  };
  put({"file_open", "file_save"});
  put({"edit_undo", "edit_redo"});
  put({"new_target", "new_surface", "new_platform", "new_radar"});
  put({"view_focus", "view_fit"});
  for (const char* name : {"simulation_raw", "display_products"}) bar->add_worded(findChild<QAction*>(name));
  bar->add_primary(findChild<QAction*>("simulation_run"));
  bar->add_gap();
  for (const char* name : {"edit_search", "help_contents"}) bar->addAction(findChild<QAction*>(name));
}

// Thesis 4.7: a platform that is followed, or a point.
void MainWindow::show_focus() {
  QDialog dialog(this);
  dialog.setObjectName("focus_dialog");
  dialog.setWindowTitle(tr("Select Focus"));
  auto* form = new QFormLayout(&dialog);
  auto* platform = new QComboBox;
  platform->setObjectName("focus_platform");
  platform->setAccessibleName(tr("Follow"));
  platform->setToolTip(tr("A platform stays in the middle while the time runs"));
  platform->addItem(tr("A point"));
  for (const scene::Platform& p : session_.scene().platforms) platform->addItem(QString::fromStdString(p.name));
  if (scene_->followed() && scene_->followed()->kind == scene::ObjectKind::platform)
    platform->setCurrentIndex(static_cast<int>(scene_->followed()->index) + 1);
  form->addRow(tr("&Follow"), platform);
  const core::Vec3 focus = scene_->scene().camera().focus_world_m;
  std::array<QLineEdit*, 3> fields{};
  // Finer than a tenth of a pixel nobody sees.
  const double fine_m = picture::round_below(0.1 / scene_->scene().camera().pixels_per_m);
  const std::array<double, 3> values{core::rounded_to(focus.x, fine_m), core::rounded_to(focus.y, fine_m),
                                     core::rounded_to(focus.z, fine_m)};
  for (std::size_t i = 0; i < 3; ++i) {
    fields[i] = new QLineEdit(QString::fromStdString(scene::quantity_text(values[i], scene::Quantity::length, "m")));
    fields[i]->setObjectName(QString("focus_%1").arg(QChar("xyz"[i])));
    fields[i]->setAccessibleName(tr("%1 of the focus").arg(QChar("XYZ"[i])));
    fields[i]->setToolTip(tr("In the world; any unit: 100 m, 2.5 km"));
    fields[i]->setMinimumWidth(fields[i]->fontMetrics().horizontalAdvance("-000.000000 km  "));
    form->addRow(QString("&%1").arg(QChar("XYZ"[i])), fields[i]);
    fields[i]->setEnabled(platform->currentIndex() == 0);
  }
  connect(platform, &QComboBox::currentIndexChanged, &dialog, [&](int index) {
    for (QLineEdit* field : fields) field->setEnabled(index == 0);
  });
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  form->addRow(buttons);
  connect(buttons, &QDialogButtonBox::accepted, &dialog, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
  if (dialog.exec() != QDialog::Accepted) return;
  if (platform->currentIndex() > 0) {
    scene_->follow(
        scene::ObjectId{scene::ObjectKind::platform, static_cast<std::size_t>(platform->currentIndex() - 1)});
    return;
  }
  std::array<double, 3> wanted = values;
  for (std::size_t i = 0; i < 3; ++i) {
    const scene::QuantityReading reading =
        scene::read_quantity(fields[i]->text().toStdString(), scene::Quantity::length);
    if (reading.value)
      wanted[i] = *reading.value;
    else
      session_.log(core::Severity::warning, QString::fromStdString(reading.failure));
  }
  scene_->follow(std::nullopt);
  scene_->focus_on({wanted[0], wanted[1], wanted[2]});
}

void MainWindow::show_help(const HelpPlace& place) {
  if (!guide_.open(place)) show_help_window(place);
}

// A dialog that holds up the rest of the program must not hold up its own help.
void MainWindow::show_help_window(const HelpPlace& place) {
  QWidget* parent = QApplication::activeModalWidget();
  if (parent == nullptr || qobject_cast<HelpWindow*>(parent) != nullptr) parent = this;
  auto* help = parent->findChild<HelpWindow*>("help_window", Qt::FindDirectChildrenOnly);
  if (help == nullptr) help = new HelpWindow(parent);
  help->show();  // before the page, which is scrolled in a window that has its size
  help->show_page(place.page, place.heading);
  help->raise();
  help->activateWindow();
}

void MainWindow::show_about() {
  QMessageBox box(QMessageBox::NoIcon, tr("About Sarsim"),
                  tr("<h3>Sarsim %1</h3><p>Radar echo simulator: from a scene to complex baseband samples.</p>"
                     "<p>Qt %2, QCustomPlot %3, HDF5 %4</p>"
                     "<p>Free software under the <a href=\"https://www.gnu.org/licenses/gpl-3.0.html\">GNU General "
                     "Public License</a>, version 3 or later, without any warranty.</p>")
                      .arg(core::program_version, qVersion(), QCUSTOMPLOT_VERSION_STR, core::hdf5_version),
                  QMessageBox::Ok, this);
  box.setObjectName("about");
  box.setIconPixmap(program_icon().pixmap(box.fontMetrics().height() * 5));
  box.setTextFormat(Qt::RichText);
  box.setTextInteractionFlags(Qt::TextBrowserInteraction);
  box.exec();
}

QWidget* MainWindow::show_products() {
  commit_typed();
  if (products_ == nullptr) products_ = new ProductWindow(session_, *image_viewers_, this);
  products_->show();
  products_->raise();
  products_->activateWindow();
  return products_;
}

QStringList MainWindow::window_names() {
  return {"main",       "objects",       "properties", "script",   "simulations",   "log",           "geometry",
          "simulation", "compressed",    "targets",    "function", "commands",      "help",          "import",
          "viewer",     "output",        "save_data",  "saving",   "range_profile", "range_doppler", "doppler_time",
          "spectrum",   "phase_history", "products",   "welcome",  "tour",          "image"};
}

// A window of echoes: of the stored simulation that is selected, otherwise a new one.
SimulationWindow* MainWindow::open_simulation() {
  const auto current = session_.current();
  if (current && current->kind == scene::ObjectKind::simulation) return simulation_windows_->open_stored(*current);
  return simulation_windows_->open_new(scene::Processing::raw);
}

// Windows that belong to one of echoes, which is opened with them.
QWidget* MainWindow::simulation_part(const QString& name) {
  static const std::map<QString, picture::RadarView> views{{"range_profile", picture::RadarView::range_profile},
                                                           {"range_doppler", picture::RadarView::range_doppler},
                                                           {"doppler_time", picture::RadarView::doppler_time},
                                                           {"spectrum", picture::RadarView::spectrum},
                                                           {"phase_history", picture::RadarView::phase_history}};
  if (name == "saving") return &saver_->queue();
  const auto view = views.find(name);
  if (view == views.end() && name != "save_data") return nullptr;
  SimulationWindow* window = open_simulation();
  if (window == nullptr) return nullptr;
  if (view != views.end()) return window->open_radar_view(view->second);
  // The dialog tells of the picture, which must be there first.
  QEventLoop until_shown;
  connect(window, &SimulationWindow::finished, &until_shown, &QEventLoop::quit);
  QTimer::singleShot(longest_picture_ms, &until_shown, &QEventLoop::quit);
  until_shown.exec();
  return saver_->ask(window->simulation(), *window);
}

QWidget* MainWindow::window_named(const QString& name) {
  if (name == "main") return this;
  if (docks_.contains(name)) {
    docks_[name]->show();
    docks_[name]->raise();
    return docks_[name];
  }
  if (name == "geometry") return show_geometry(), geometry_;
  if (name == "simulation") return open_simulation();
  if (name == "compressed") return simulation_windows_->open_new(scene::Processing::matched_filter);
  if (name == "viewer") {
    const auto viewers = image_viewers_->viewers();
    return viewers.empty() ? image_viewers_->open_empty() : viewers.front();
  }
  if (name == "output") return image_viewers_->ask_file();
  if (name == "products") return show_products();
  if (QWidget* of_simulation = simulation_part(name)) return of_simulation;
  if (name == "targets") return show_targets(), targets_;
  if (name == "help") return show_help_window({"README.md", {}}), findChild<HelpWindow*>("help_window");
  if (name == "commands") return new SearchBox(search_entries(), this);
  if (name == "welcome") return show_welcome(), welcome_;
  if (name == "tour") return tour_panel();
  if (name == "import") return new ImportDialog(session_, this);
  if (name != "function") return nullptr;
  // The first function that the scene has.
  for (const scene::ObjectKind kind :
       {scene::ObjectKind::platform, scene::ObjectKind::radar, scene::ObjectKind::target})
    for (std::size_t i = 0; i < scene::count_of(session_.scene(), kind); ++i) {
      const scene::AnyObject object = scene::object_of(session_.scene(), {kind, i});
      for (const scene::Field& field : scene::fields_of(kind))
        if (field.kind == scene::FieldKind::function && scene::field_applies(object, field.id))
          return new FunctionEditor(session_, {kind, i}, field.id, this);
    }
  return nullptr;
}

}  // namespace sarsim::gui
