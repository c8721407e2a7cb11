#include "gui/frame/main_window.hpp"

#include <QApplication>
#include <QCloseEvent>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QLabel>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QSettings>
#include <QStatusBar>
#include <QTimer>

#include <memory>

#include "gui/common/screen_size.hpp"
#include "gui/echo/data_saver.hpp"
#include "gui/echo/simulation_window.hpp"
#include "gui/echo/simulation_windows.hpp"
#include "gui/frame/document_keeper.hpp"
#include "gui/frame/log_panel.hpp"
#include "gui/frame/problem_badge.hpp"
#include "gui/frame/problem_watch.hpp"
#include "gui/image/image_viewer.hpp"
#include "gui/image/image_viewers.hpp"
#include "gui/live/live_panel.hpp"
#include "gui/objects/function_editor.hpp"
#include "gui/objects/object_tree.hpp"
#include "gui/objects/property_panel.hpp"
#include "gui/objects/target_table.hpp"
#include "gui/runs/product_window.hpp"
#include "gui/runs/run_panel.hpp"
#include "gui/runs/save_queue.hpp"
#include "gui/runs/stored_simulations.hpp"
#include "gui/scene/geometry_window.hpp"
#include "gui/scene/scene_panel.hpp"
#include "gui/scene/scene_widget.hpp"
#include "gui/scene/time_bar.hpp"
#include "gui/script/script_editor.hpp"
#include "gui/start/welcome_page.hpp"
#include "scene/edit/edit.hpp"
#include "scene/model/object_lists.hpp"
#include "workflow/input/cloud_input.hpp"

namespace sarsim::gui {

namespace {

// The files that a drop brings.
QStringList dropped_files(const QMimeData* data) {
  QStringList files;
  for (const QUrl& url : data->urls())
    if (url.isLocalFile()) files << url.toLocalFile();
  return files;
}

}  // namespace

MainWindow::MainWindow(QWidget* parent)
    : QMainWindow(parent), documents_(new DocumentKeeper(session_, this)), problems_(new ProblemWatch(session_, this)) {
  setObjectName("main_window");
  setAcceptDrops(true);
  setDockNestingEnabled(true);
  scene_ = new ScenePanel(session_);
  setCentralWidget(scene_);
  make_docks();
  make_badge();
  make_menus();
  make_tool_bar();
  make_document_row();
  make_start();
  ask_end_work = [this](const QStringList& work) {
    QMessageBox box(QMessageBox::Question, tr("Close"), tr("This is still under way and would be ended:"),
                    QMessageBox::Yes | QMessageBox::No, this);
    box.setInformativeText(work.join('\n') + "\n\n" + tr("End it and close?"));
    box.setDefaultButton(QMessageBox::No);
    return box.exec() == QMessageBox::Yes;
  };
  connect(scene_, &ScenePanel::edit_requested, this, &MainWindow::edit_object);
  connect(scene_, &ScenePanel::delete_wanted, tree_, &ObjectTree::delete_selection);
  connect(scene_, &ScenePanel::menu_requested, this, &MainWindow::show_object_menu);
  connect(tree_, &ObjectTree::edit_requested, this, &MainWindow::edit_object);
  connect(panel_, &PropertyPanel::function_requested, this, &MainWindow::edit_function);
  connect(&session_, &Session::document_changed, this, &MainWindow::show_title);
  connect(&session_, &Session::scene_changed, this, [this] {
    show_title();
    show_state();
  });
  connect(&session_, &Session::selection_changed, this, &MainWindow::show_state);
  connect(documents_, &DocumentKeeper::recent_changed, this, &MainWindow::fill_recent);
  fill_recent();
  show_title();
  show_state();
  resize(size_on_screen(*this, {fontMetrics().averageCharWidth() * 214, fontMetrics().height() * 50}));
}

MainWindow::~MainWindow() {
  // A field that goes while it has the keyboard says that it is finished, to whatever is left of its window.
  if (QWidget* last = QApplication::focusWidget()) last->clearFocus();
  // Panels and windows speak to the session, which is a member and goes first.
  for (QWidget* child : findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly))
    if (child->isWindow() && qobject_cast<QDockWidget*>(child) == nullptr) delete child;
  delete centralWidget();
  for (const auto& [name, dock] : docks_) delete dock;
}

QDockWidget* MainWindow::add_dock(QWidget* widget, const QString& title, const char* name, Qt::DockWidgetArea area) {
  auto* dock = new QDockWidget(title, this);
  dock->setObjectName(QString("%1_dock").arg(name));
  dock->setWidget(widget);
  addDockWidget(area, dock);
  docks_[name] = dock;
  return dock;
}

void MainWindow::make_docks() {
  tree_ = new ObjectTree(session_);
  panel_ = new PropertyPanel(session_);
  script_ = new ScriptEditor(session_);
  simulations_ = new StoredSimulations(session_);
  simulation_windows_ = new SimulationWindows(session_, this);
  image_viewers_ = new ImageViewers(session_, this);
  connect(simulations_, &StoredSimulations::show_requested, simulation_windows_, &SimulationWindows::open_stored);
  saver_ = new DataSaver(session_, this);
  connect(simulation_windows_, &SimulationWindows::save_data_wanted, saver_,
          [this](const scene::Simulation& simulation, SimulationWindow* from) { saver_->ask(simulation, *from); });
  const int letter = fontMetrics().averageCharWidth();
  tree_->setMinimumWidth(letter * 24);
  panel_->setMinimumWidth(letter * 51);
  add_dock(tree_, tr("Objects"), "objects", Qt::LeftDockWidgetArea);
  add_dock(panel_, tr("Properties"), "properties", Qt::RightDockWidgetArea);
  QDockWidget* script = add_dock(script_, tr("Script File"), "script", Qt::BottomDockWidgetArea);
  QDockWidget* simulations = add_dock(simulations_, tr("Previously Stored"), "simulations", Qt::BottomDockWidgetArea);
  QDockWidget* log = add_dock(new LogPanel(session_, *problems_), tr("Log"), "log", Qt::BottomDockWidgetArea);
  // Wanted by its name in the menu View, where there is room for it.
  add_dock(new LivePanel(session_, *image_viewers_), tr("Image"), "image", Qt::RightDockWidgetArea)->hide();
  make_echo_dock();
  tabifyDockWidget(simulations, script);
  tabifyDockWidget(simulations, log);
  simulations->raise();
  setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
  setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
}

void MainWindow::showEvent(QShowEvent* event) {
  QMainWindow::showEvent(event);
  if (sized_) return;
  sized_ = true;
  if (welcome_->isHidden())
    scene_->scene().setFocus();
  else
    welcome_->setFocus();
  restore_layout();
  // Docks take sizes only once the window has its own.
  if (!layout_is_kept_) QTimer::singleShot(0, this, &MainWindow::size_docks);
}

void MainWindow::fill_recent() {
  recent_->clear();
  for (const QString& path : documents_->recent())
    connect(recent_->addAction(path), &QAction::triggered, this, [this, path] { open_any(path); });
  recent_->setEnabled(!recent_->isEmpty());
}

void MainWindow::show_title() {
  setWindowTitle(QString("%1[*] - Sarsim").arg(documents_->shown_name()));
  setWindowModified(documents_->unsaved());
}

// "3 radars   6 surfaces", of what there is.
void MainWindow::show_state() {
  const scene::Scene& scene = session_.scene();
  QStringList words;
  const auto count = [&](std::size_t number, const QString& one, const QString& many) {
    if (number > 0) words << (number == 1 ? one : many.arg(static_cast<qulonglong>(number)));
  };
  count(scene.targets.size(), tr("1 target"), tr("%L1 targets"));
  count(workflow::cloud_points(scene), tr("1 point of clouds"), tr("%L1 points of clouds"));
  count(scene.surfaces.size(), tr("1 surface"), tr("%L1 surfaces"));
  count(scene.radars.size(), tr("1 radar"), tr("%L1 radars"));
  QString text = words.isEmpty() ? tr("Nothing in the scene yet") : words.join("   ");
  if (session_.current()) {
    text += "   " + QString::fromStdString(scene::label_of(scene, *session_.current()));
    if (session_.selection().size() > 1) text += tr(" and %1 more").arg(session_.selection().size() - 1);
  }
  state_->setText(text);
}

// How much is wrong, at a glance; a click shows what, in the panel that lists it.
void MainWindow::make_badge() {
  // A widget of its own: what menus and tips say comes above it and goes again.
  state_ = new QLabel(this);
  state_->setObjectName("scene_state");
  statusBar()->addWidget(state_, 1);
  auto* badge = new ProblemBadge(this);
  statusBar()->addPermanentWidget(badge);
  connect(problems_, &ProblemWatch::changed, this, [this, badge] {
    badge->show_problems(problems_->problems());
    script_->list_also(problems_->of_echoes());
  });
  connect(badge, &ProblemBadge::clicked, this, [this] {
    docks_["script"]->show();
    docks_["script"]->raise();
    const core::Problems& all = problems_->problems();
    script_->show_problem(all.empty() ? core::Place{} : all.front().place);
  });
}

void MainWindow::add_new(scene::AnyObject object) {
  const scene::ObjectKind kind = scene::kind_of(object);
  // New things stand on the platform that is selected, or that carries what is.
  if (const auto current = session_.current()) {
    const std::string carrier = current->kind == scene::ObjectKind::platform
                                    ? session_.scene().platforms[current->index].name
                                    : scene::carrier_of(session_.scene(), *current);
    const bool carried = !scene::belongs_to_radar(current->kind) && !carrier.empty();
    if (carried && scene::stands_on_platform(kind)) scene::set_carrier(object, carrier);
  }
  session_.perform(scene::add_object(session_.scene(), std::move(object)));
  edit_object({kind, scene::count_of(session_.scene(), kind) - 1});
}

void MainWindow::edit_object(scene::ObjectId id) {
  session_.select_only(id);
  docks_["properties"]->show();
  docks_["properties"]->raise();
  panel_->focus_first();
}

void MainWindow::edit_function(scene::ObjectId id, const QString& field) {
  auto* editor = new FunctionEditor(session_, id, field.toStdString(), this);
  editor->setAttribute(Qt::WA_DeleteOnClose);
  editor->open();
}

void MainWindow::show_object_menu(std::optional<scene::ObjectId> id, QPoint global) {
  if (id && !session_.selection().contains(*id)) session_.select_only(*id);
  const std::unique_ptr<QMenu> menu = id ? tree_->context_menu() : std::make_unique<QMenu>();
  scene_->add_hand_entries(*menu);
  menu->exec(global);
}

void MainWindow::show_geometry() {
  if (geometry_ == nullptr) {
    geometry_ = new GeometryWindow(session_, this);
    geometry_->setWindowFlag(Qt::Window);
  }
  geometry_->show();
  geometry_->raise();
  geometry_->activateWindow();
}

void MainWindow::show_targets() {
  if (targets_ == nullptr) targets_ = new TargetTableDialog(session_, this);
  targets_->show();
  targets_->raise();
  targets_->activateWindow();
}

void MainWindow::set_appearance(Appearance appearance) {
  sarsim::gui::set_appearance(*qApp, appearance);
  emit session_.selection_changed();
}

QStringList MainWindow::work_under_way() const {
  QStringList work;
  if (saver_->queue().busy()) work << tr("Data of simulation windows are being saved.");
  if (simulations_->run_panel().running()) work << tr("A stored simulation is being run.");
  for (const ImageViewer* viewer : image_viewers_->viewers())
    if (viewer->exporting())
      work << tr("Samples of %1 are being exported.").arg(QString::fromStdString(viewer->path().filename().string()));
  if (geometry_ != nullptr && geometry_->saving()) work << tr("A geometry table is being saved.");
  if (products_ != nullptr && products_->busy()) work << tr("An image is being made from echoes.");
  return work;
}

bool MainWindow::may_end_work() {
  const QStringList work = work_under_way();
  return work.isEmpty() || ask_end_work(work);
}

void MainWindow::end_work() {
  saver_->queue().cancel_all();
  simulations_->run_panel().cancel();
  for (ImageViewer* viewer : image_viewers_->viewers()) viewer->cancel_export();
  if (geometry_ != nullptr) geometry_->cancel_saving();
  if (products_ != nullptr) products_->stop();
}

void MainWindow::closeEvent(QCloseEvent* event) {
  // Nothing ends before every question is answered.
  commit_typed();
  if (!documents_->may_close_all() || !may_end_work()) {
    event->ignore();
    return;
  }
  end_work();
  keep_layout();
  documents_->end();
  event->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (!dropped_files(event->mimeData()).isEmpty()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  const QStringList files = dropped_files(event->mimeData());
  if (files.isEmpty()) return;
  event->acceptProposedAction();
  for (const QString& file : files) open_any(file);
}

bool MainWindow::open_any(const QString& path) {
  if (!is_data_file(path.toStdString())) {
    commit_typed();
    return documents_->open_file(path);
  }
  image_viewers_->open_file(path.toStdString());
  return true;
}

}  // namespace sarsim::gui
