// Which panels stand beside the scene, and how much room they take: layouts with names.

#include <QApplication>
#include <QDockWidget>
#include <QInputDialog>
#include <QMenu>
#include <QSettings>

#include <algorithm>
#include <vector>

#include "gui/common/screen_size.hpp"
#include "gui/echo/echo_panel.hpp"
#include "gui/echo/simulation_window.hpp"
#include "gui/echo/simulation_windows.hpp"
#include "gui/frame/main_window.hpp"
#include "picture/live/live_engine.hpp"
#include "workflow/input/cloud_input.hpp"

namespace sarsim::gui {

namespace {

constexpr int layout_version = 2;

// A layout that the program brings: its panels, in any order.
struct BuiltInLayout {
  const char* name;
  const char* title;
  QStringList panels;
  bool views;  // echoes and image beside the scene, properties below the objects
};

const std::vector<BuiltInLayout>& built_in_layouts() {
  static const std::vector<BuiltInLayout> all{
      {"scene",
       QT_TRANSLATE_NOOP("Layouts", "&Scene"),
       {"objects", "properties", "simulations", "script", "log"},
       false},
      {"echoes",
       QT_TRANSLATE_NOOP("Layouts", "Scene and &Echoes"),
       {"objects", "properties", "simulations", "script", "log", "echoes"},
       false},
      {"views",
       QT_TRANSLATE_NOOP("Layouts", "Scene, Echoes and &Image"),
       {"objects", "properties", "echoes", "image"},
       true},
      {"script", QT_TRANSLATE_NOOP("Layouts", "S&cript"), {"objects", "script", "log", "image"}, false}};
  return all;
}

QString key_of(const QString& name) { return "layouts/" + name; }

}  // namespace

QStringList MainWindow::layout_names() const {
  QStringList names;
  for (const BuiltInLayout& layout : built_in_layouts()) names << layout.name;
  QSettings settings;
  settings.beginGroup("layouts");
  return names + settings.childKeys();
}

// Places first, then who is seen, then sizes.
bool MainWindow::apply_layout(const QString& name) {
  const auto found =
      std::ranges::find(built_in_layouts(), name, [](const BuiltInLayout& l) { return QString(l.name); });
  if (found == built_in_layouts().end()) {
    const QByteArray kept = QSettings().value(key_of(name)).toByteArray();
    return restore_panels(kept);
  }
  for (const auto& [panel, dock] : docks_) dock->setFloating(false);
  addDockWidget(Qt::LeftDockWidgetArea, docks_["objects"]);
  addDockWidget(Qt::RightDockWidgetArea, docks_["echoes"]);
  splitDockWidget(docks_["echoes"], docks_["image"], Qt::Horizontal);
  if (found->views) {
    addDockWidget(Qt::LeftDockWidgetArea, docks_["properties"]);
    splitDockWidget(docks_["objects"], docks_["properties"], Qt::Vertical);
  } else {
    splitDockWidget(docks_["image"], docks_["properties"], Qt::Horizontal);
  }
  for (const auto& [panel, dock] : docks_) dock->setVisible(found->panels.contains(panel));
  size_docks();
  return true;
}

// In shares of the window, so that it fits on a small screen as well.
void MainWindow::size_docks() {
  const int letter = fontMetrics().averageCharWidth();
  const int width = this->width();
  const bool views = docks_["echoes"]->isVisible() && docks_["image"]->isVisible();
  const bool left = dockWidgetArea(docks_["properties"]) == Qt::LeftDockWidgetArea;
  const auto share = [&](double part, int most) { return std::min(static_cast<int>(part * width), most); };
  resizeDocks({docks_["objects"], docks_["properties"]},
              {share(left ? 0.22 : 0.16, letter * 52), share(0.23, letter * 64)}, Qt::Horizontal);
  const int view = share(views ? 0.26 : 0.34, width);
  resizeDocks({docks_["echoes"], docks_["image"]}, {view, view}, Qt::Horizontal);
  if (left) resizeDocks({docks_["objects"], docks_["properties"]}, {height() * 2 / 5, height() * 3 / 5}, Qt::Vertical);
  resizeDocks({docks_["simulations"]}, {std::min(fontMetrics().height() * 13, height() / 5)}, Qt::Vertical);
}

void MainWindow::save_layout(const QString& name) {
  if (name.isEmpty()) return;
  QSettings().setValue(key_of(name), saveState(layout_version));
}

// The row of documents is no part of a layout.
bool MainWindow::restore_panels(const QByteArray& kept) {
  const bool restored = !kept.isEmpty() && restoreState(kept, layout_version);
  show_document_row();
  return restored;
}

void MainWindow::restore_layout() {
  QSettings settings;
  restoreGeometry(settings.value("window/geometry").toByteArray());
  if (!wanted_layout_.isEmpty()) {
    apply_layout(wanted_layout_);
    return;
  }
  const QByteArray kept = settings.value("window/state").toByteArray();
  layout_is_kept_ = restore_panels(kept);
  if (!layout_is_kept_) apply_layout(first_layout_);
}

void MainWindow::keep_layout() const {
  QSettings settings;
  settings.setValue("window/geometry", saveGeometry());
  settings.setValue("window/state", saveState(layout_version));
}

void MainWindow::reset_layout() { apply_layout(first_layout_); }

// Those that the program brings, those that were saved, and what can be done with them.
void MainWindow::fill_layouts(QMenu* menu) {
  menu->clear();
  for (const BuiltInLayout& layout : built_in_layouts())
    connect(menu->addAction(QCoreApplication::translate("Layouts", layout.title)), &QAction::triggered, this,
            [this, name = QString(layout.name)] { apply_layout(name); });
  const QStringList saved = layout_names().mid(static_cast<qsizetype>(built_in_layouts().size()));
  if (!saved.isEmpty()) menu->addSeparator();
  for (const QString& name : saved)
    connect(menu->addAction(name), &QAction::triggered, this, [this, name] { apply_layout(name); });
  menu->addSeparator();
  connect(menu->addAction(tr("Save Layout &As…")), &QAction::triggered, this,
          [this] { save_layout(QInputDialog::getText(this, tr("Save Layout"), tr("Name of the layout"))); });
  QMenu* forget = menu->addMenu(tr("&Delete"));
  forget->setEnabled(!saved.isEmpty());
  for (const QString& name : saved)
    connect(forget->addAction(name), &QAction::triggered, this, [name] { QSettings().remove(key_of(name)); });
}

// ---- Echoes beside the scene

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

}  // namespace sarsim::gui
