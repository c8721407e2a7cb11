// What lets the whole workbench be used without a mouse.

#include <QApplication>
#include <QDockWidget>
#include <QMenu>

#include "gui/frame/main_window.hpp"
#include "gui/objects/object_tree.hpp"
#include "gui/objects/property_panel.hpp"
#include "gui/scene/scene_panel.hpp"
#include "gui/scene/scene_widget.hpp"
#include "scene/schema/fields.hpp"

namespace sarsim::gui {

namespace {

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

// The functions that mean something for the current object as it is.
void MainWindow::fill_functions(QMenu* menu) {
  menu->clear();
  const auto current = session_.current();
  if (!current) return;
  const scene::AnyObject object = scene::object_of(session_.scene(), *current);
  for (const scene::Field& field : scene::fields_of(current->kind))
    if (field.kind == scene::FieldKind::function && scene::field_applies(object, field.id))
      connect(menu->addAction(QString::fromStdString(field.label) + QString::fromUtf8("…")), &QAction::triggered, this,
              [this, id = *current, name = QString::fromStdString(field.id)] { edit_function(id, name); });
}

}  // namespace sarsim::gui
