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
#include <QToolBar>

#include <memory>
#include <utility>

#include "gui/common/screen_size.hpp"
#include "gui/echo/data_saver.hpp"
#include "gui/echo/echo_panel.hpp"
#include "gui/echo/simulation_window.hpp"
#include "gui/echo/simulation_windows.hpp"
#include "gui/frame/document_keeper.hpp"
#include "gui/frame/document_tabs.hpp"
#include "gui/frame/layout_keeper.hpp"
#include "gui/frame/log_panel.hpp"
#include "gui/frame/main_menus.hpp"
#include "gui/frame/problem_badge.hpp"
#include "gui/frame/problem_watch.hpp"
#include "gui/frame/start_guide.hpp"
#include "gui/frame/tool_windows.hpp"
#include "gui/frame/workbench.hpp"
#include "gui/image/image_viewer.hpp"
#include "gui/image/image_viewers.hpp"
#include "gui/live/live_panel.hpp"
#include "gui/objects/function_editor.hpp"
#include "gui/objects/object_tree.hpp"
#include "gui/objects/property_panel.hpp"
#include "gui/runs/run_panel.hpp"
#include "gui/runs/save_queue.hpp"
#include "gui/runs/stored_simulations.hpp"
#include "gui/scene/scene_panel.hpp"
#include "gui/scene/scene_widget.hpp"
#include "gui/script/script_editor.hpp"
#include "gui/start/tour_panel.hpp"
#include "gui/start/welcome_page.hpp"
#include "picture/live/live_engine.hpp"
#include "scene/edit/edit.hpp"
#include "scene/model/object.hpp"
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

// The first place in a widget that takes the keyboard.
QWidget* first_inside(QWidget* widget) {
  if (widget->focusProxy() != nullptr) return widget->focusProxy();
  if (widget->focusPolicy() != Qt::NoFocus) return widget;
  for (QWidget* next = widget->nextInFocusChain(); next != widget; next = next->nextInFocusChain())
    if (widget->isAncestorOf(next) && (next->focusPolicy() & Qt::TabFocus) != 0 && next->isEnabled() &&
        next->isVisible())
      return next;
  return nullptr;
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
  make_document_row();
  start_ = new StartGuide(parts(), *tools_, *this);
  connect(start_, &StartGuide::file_wanted, this, &MainWindow::open_any);
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

Workbench MainWindow::parts() {
  return {session_,      *documents_,          *scene_,         *tree_,  *panel_, *script_,
          *simulations_, *simulation_windows_, *image_viewers_, *saver_, docks_};
}

void MainWindow::make_menus() {
  tools_ = new ToolWindows(parts(), *this);
  layouts_ = new LayoutKeeper(*this, docks_);
  auto* const menus = new MainMenus(parts(), *tools_, *layouts_, *this);
  connect(menus, &MainMenus::file_wanted, this, &MainWindow::open_any);
  connect(menus, &MainMenus::close_wanted, this, &MainWindow::close_what_is_active);
  connect(menus, &MainMenus::document_step_wanted, this, &MainWindow::step_to_document);
  connect(menus, &MainMenus::object_wanted, this, &MainWindow::add_new);
  connect(menus, &MainMenus::edit_wanted, this, &MainWindow::edit_object);
  connect(menus, &MainMenus::function_wanted, this, &MainWindow::edit_function);
  connect(menus, &MainMenus::appearance_wanted, this, &MainWindow::set_appearance);
  connect(menus, &MainMenus::panel_step_wanted, this, &MainWindow::go_to_panel);
  connect(menus, &MainMenus::search_wanted, this, [this] { start_->show_search(); });
  connect(menus, &MainMenus::welcome_wanted, this, [this] { start_->show_welcome(); });
  connect(menus, &MainMenus::tour_wanted, this, [this] { start_->show_tour(); });
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
  QDockWidget* simulations = add_dock(simulations_, tr("Recordings"), "simulations", Qt::BottomDockWidgetArea);
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
  if (start_->welcome().isHidden())
    scene_->scene().setFocus();
  else
    start_->welcome().setFocus();
  layouts_->restore();
  // Docks take sizes only once the window has its own.
  if (!layouts_->kept()) QTimer::singleShot(0, layouts_, &LayoutKeeper::size_docks);
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
  count(workflow::cloud_points(scene), tr("1 cloud point"), tr("%L1 cloud points"));
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
    parts().bring("script");
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
  parts().bring("properties");
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
  return work + tools_->work_under_way();
}

bool MainWindow::may_end_work() {
  const QStringList work = work_under_way();
  return work.isEmpty() || ask_end_work(work);
}

void MainWindow::end_work() {
  saver_->queue().cancel_all();
  simulations_->run_panel().cancel();
  for (ImageViewer* viewer : image_viewers_->viewers()) viewer->cancel_export();
  tools_->end_work();
}

void MainWindow::closeEvent(QCloseEvent* event) {
  // Nothing ends before every question is answered.
  parts().commit_typed();
  if (!documents_->may_close_all() || !may_end_work()) {
    event->ignore();
    return;
  }
  end_work();
  layouts_->keep();
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
    parts().commit_typed();
    return documents_->open_file(path);
  }
  image_viewers_->open_file(path.toStdString());
  return true;
}

bool MainWindow::apply_layout(const QString& name) { return layouts_->apply(name); }

QStringList MainWindow::layout_names() const { return layouts_->names(); }

void MainWindow::save_layout(const QString& name) { layouts_->save(name); }

void MainWindow::use_layout(const QString& name) { layouts_->use(name); }

void MainWindow::set_first_layout(const QString& name) { layouts_->set_first(name); }

void MainWindow::set_guide(GuideSite guide) { tools_->set_guide(std::move(guide)); }

QStringList MainWindow::window_names() { return ToolWindows::names(); }

QWidget* MainWindow::window_named(const QString& name) {
  if (name == "main") return this;
  if (docks_.contains(name)) {
    parts().bring(name);
    return docks_[name];
  }
  if (name == "commands") return start_->search_box();
  if (name == "welcome") return start_->show_welcome(), &start_->welcome();
  if (name == "tour") return start_->tour_panel();
  return tools_->named(name);
}

// --- Echoes beside the scene

void MainWindow::make_echo_dock() {
  echoes_ = new EchoPanel;
  add_dock(echoes_, tr("Echoes"), "echoes", Qt::RightDockWidgetArea)->hide();
  connect(simulation_windows_, &SimulationWindows::opened, this, &MainWindow::place_echoes);
  connect(echoes_, &EchoPanel::raw_wanted, this, [this] { simulation_windows_->open_new(scene::Processing::raw); });
  connect(echoes_, &EchoPanel::compressed_wanted, this,
          [this] { simulation_windows_->open_new(scene::Processing::matched_filter); });
  // When the scene and its windows are as they will be.
  first_echoes_.setSingleShot(true);
  connect(&first_echoes_, &QTimer::timeout, this, &MainWindow::show_first_echoes);
  const auto soon = [this] { first_echoes_.start(0); };
  connect(&session_, &Session::document_replaced, this, soon);
  connect(docks_["echoes"], &QDockWidget::visibilityChanged, this, soon);
  connect(echoes_, &EchoPanel::alone_wanted, this, [this](SimulationWindow* window) {
    window->setParent(this, Qt::Window);
    window->resize(size_on_screen(*this, {1100, 760}));
    window->show();
  });
}

// Those of a scene that is opened are there without being asked for, once: of its first recording, otherwise of its
// first radar. Those of very many targets would take the processors from the image, whose pictures came half as often.
void MainWindow::show_first_echoes() {
  const scene::Scene& scene = session_.scene();
  if (!isVisible() || !docks_["echoes"]->isVisible() || scene.radars.empty()) return;
  if (scene.targets.size() + workflow::cloud_points(scene) > picture::many_targets) return;
  if (!has_had_echoes_.insert(session_.number()).second || !simulation_windows_->windows().empty()) return;
  if (scene.simulations.empty())
    simulation_windows_->open_new(scene::Processing::raw);
  else
    simulation_windows_->open_stored({scene::ObjectKind::simulation, 0});
}

// Beside the scene where that is seen and there is room; otherwise the window stands by itself.
void MainWindow::place_echoes(SimulationWindow* window) {
  if (!isVisible() || !docks_["echoes"]->isVisible()) return;
  echoes_->take(window);
  docks_["echoes"]->raise();
}

// --- Several documents in one window: the row of tabs, turning from one to another, closing

// Above everything that shows the document, and only where there is a choice.
void MainWindow::make_document_row() {
  addToolBarBreak();
  document_row_ = addToolBar(tr("Open scenes"));
  document_row_->setObjectName("document_row");
  document_row_->setMovable(false);
  document_row_->toggleViewAction()->setVisible(false);
  auto* const tabs = new DocumentTabs(session_, *documents_, document_row_);
  document_row_->addWidget(tabs);
  connect(tabs, &DocumentTabs::turn_wanted, this, &MainWindow::turn_to_document);
  connect(tabs, &DocumentTabs::close_wanted, this, &MainWindow::close_document);
  connect(&session_, &Session::row_changed, this, &MainWindow::show_document_row);
  connect(layouts_, &LayoutKeeper::restored, this, &MainWindow::show_document_row);
  show_document_row();
}

void MainWindow::show_document_row() {
  const bool several = session_.document_count() > 1;
  document_row_->setVisible(several);
  for (const char* name : {"file_next", "file_previous"})
    if (auto* const action = findChild<QAction*>(name)) action->setEnabled(several);
}

void MainWindow::turn_to_document(int index) {
  parts().commit_typed();
  session_.turn_to(static_cast<std::size_t>(index));
}

void MainWindow::step_to_document(int step) {
  const auto count = static_cast<int>(session_.document_count());
  turn_to_document((static_cast<int>(session_.at_hand()) + step + count) % count);
}

// Where the last one was closed there is a choice of what to begin with.
void MainWindow::close_document(int index) {
  turn_to_document(index);
  const bool last = session_.document_count() == 1;
  if (documents_->close() && last) start_->show_welcome();
}

// Echoes, images and other windows of their own close before the document does.
void MainWindow::close_what_is_active() {
  QWidget* const active = QApplication::activeWindow();
  const bool is_part = active == nullptr || active == this || qobject_cast<QDockWidget*>(active) != nullptr;
  if (is_part)
    close_document(static_cast<int>(session_.at_hand()));
  else
    active->close();
}

// --- What lets the whole workbench be used without a mouse

// Panels in the order of the screen: objects, scene, what lies in front below, properties.
std::vector<QWidget*> MainWindow::panels_in_view() const {
  std::vector<QWidget*> panels;
  // Of windows that share a place the title bar shows which is in front.
  const auto add_dock = [&](const char* name) {
    const QDockWidget* dock = docks_.at(name);
    if (dock->isVisible() && !dock->visibleRegion().isEmpty()) panels.push_back(dock->widget());
  };
  add_dock("objects");
  panels.push_back(&scene_->scene());
  for (const char* name : {"echoes", "image", "simulations", "script", "log", "properties"}) add_dock(name);
  return panels;
}

void MainWindow::go_to_panel(int step) {
  const std::vector<QWidget*> panels = panels_in_view();
  const QWidget* now = QApplication::focusWidget();
  const auto count = static_cast<int>(panels.size());
  int at = step > 0 ? -1 : count;
  for (int i = 0; i < count; ++i)
    if (now != nullptr &&
        (panels[static_cast<std::size_t>(i)] == now || panels[static_cast<std::size_t>(i)]->isAncestorOf(now)))
      at = i;
  QWidget* panel = panels[static_cast<std::size_t>((at + step + count) % count)];
  if (panel == panel_) return panel_->focus_first();
  if (QWidget* inside = first_inside(panel)) inside->setFocus(Qt::TabFocusReason);
}

}  // namespace sarsim::gui
