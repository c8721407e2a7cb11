#include "gui/frame/layout_keeper.hpp"

#include <QCoreApplication>
#include <QDockWidget>
#include <QInputDialog>
#include <QMainWindow>
#include <QMenu>
#include <QSettings>

#include <algorithm>
#include <vector>

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

LayoutKeeper::LayoutKeeper(QMainWindow& window, const std::map<QString, QDockWidget*>& docks)
    : QObject(&window), window_(window), docks_(docks) {}

QStringList LayoutKeeper::names() const {
  QStringList names;
  for (const BuiltInLayout& layout : built_in_layouts()) names << layout.name;
  QSettings settings;
  settings.beginGroup("layouts");
  return names + settings.childKeys();
}

// Places first, then who is seen, then sizes.
bool LayoutKeeper::apply(const QString& name) {
  const auto found =
      std::ranges::find(built_in_layouts(), name, [](const BuiltInLayout& l) { return QString(l.name); });
  if (found == built_in_layouts().end()) {
    const QByteArray kept = QSettings().value(key_of(name)).toByteArray();
    return restore_panels(kept);
  }
  for (const auto& [panel, dock] : docks_) dock->setFloating(false);
  window_.addDockWidget(Qt::LeftDockWidgetArea, docks_.at("objects"));
  window_.addDockWidget(Qt::RightDockWidgetArea, docks_.at("echoes"));
  window_.splitDockWidget(docks_.at("echoes"), docks_.at("image"), Qt::Horizontal);
  if (found->views) {
    window_.addDockWidget(Qt::LeftDockWidgetArea, docks_.at("properties"));
    window_.splitDockWidget(docks_.at("objects"), docks_.at("properties"), Qt::Vertical);
  } else {
    window_.splitDockWidget(docks_.at("image"), docks_.at("properties"), Qt::Horizontal);
  }
  for (const auto& [panel, dock] : docks_) dock->setVisible(found->panels.contains(panel));
  size_docks();
  return true;
}

// In shares of the window, so that it fits on a small screen as well.
void LayoutKeeper::size_docks() {
  const int letter = window_.fontMetrics().averageCharWidth();
  const int width = window_.width();
  const bool views = docks_.at("echoes")->isVisible() && docks_.at("image")->isVisible();
  const bool left = window_.dockWidgetArea(docks_.at("properties")) == Qt::LeftDockWidgetArea;
  const auto share = [&](double part, int most) { return std::min(static_cast<int>(part * width), most); };
  window_.resizeDocks({docks_.at("objects"), docks_.at("properties")},
                      {share(left ? 0.22 : 0.16, letter * 52), share(0.23, letter * 64)}, Qt::Horizontal);
  const int view = share(views ? 0.26 : 0.34, width);
  window_.resizeDocks({docks_.at("echoes"), docks_.at("image")}, {view, view}, Qt::Horizontal);
  if (left)
    window_.resizeDocks({docks_.at("objects"), docks_.at("properties")},
                        {window_.height() * 2 / 5, window_.height() * 3 / 5}, Qt::Vertical);
  window_.resizeDocks({docks_.at("simulations")}, {std::min(window_.fontMetrics().height() * 13, window_.height() / 5)},
                      Qt::Vertical);
}

void LayoutKeeper::save(const QString& name) {
  if (name.isEmpty()) return;
  QSettings().setValue(key_of(name), window_.saveState(layout_version));
}

// The row of documents is no part of a layout.
bool LayoutKeeper::restore_panels(const QByteArray& kept) {
  const bool is_as_kept = !kept.isEmpty() && window_.restoreState(kept, layout_version);
  emit restored();
  return is_as_kept;
}

void LayoutKeeper::restore() {
  QSettings settings;
  window_.restoreGeometry(settings.value("window/geometry").toByteArray());
  if (!wanted_.isEmpty()) {
    apply(wanted_);
    return;
  }
  const QByteArray kept = settings.value("window/state").toByteArray();
  kept_ = restore_panels(kept);
  if (!kept_) apply(first_);
}

void LayoutKeeper::keep() const {
  QSettings settings;
  settings.setValue("window/geometry", window_.saveGeometry());
  settings.setValue("window/state", window_.saveState(layout_version));
}

void LayoutKeeper::reset() { apply(first_); }

// Those that the program brings, those that were saved, and what can be done with them.
void LayoutKeeper::fill(QMenu& menu) {
  menu.clear();
  for (const BuiltInLayout& layout : built_in_layouts())
    connect(menu.addAction(QCoreApplication::translate("Layouts", layout.title)), &QAction::triggered, this,
            [this, name = QString(layout.name)] { apply(name); });
  const QStringList saved = names().mid(static_cast<qsizetype>(built_in_layouts().size()));
  if (!saved.isEmpty()) menu.addSeparator();
  for (const QString& name : saved)
    connect(menu.addAction(name), &QAction::triggered, this, [this, name] { apply(name); });
  menu.addSeparator();
  connect(menu.addAction(tr("Save Layout &As…")), &QAction::triggered, this,
          [this] { save(QInputDialog::getText(&window_, tr("Save Layout"), tr("Name of the layout"))); });
  QMenu* forget = menu.addMenu(tr("&Delete"));
  forget->setEnabled(!saved.isEmpty());
  for (const QString& name : saved)
    connect(forget->addAction(name), &QAction::triggered, this, [name] { QSettings().remove(key_of(name)); });
}

}  // namespace sarsim::gui
