#include "gui/frame/help_key.hpp"

#include <QApplication>
#include <QKeyEvent>

namespace sarsim::gui {

namespace {

struct NamedPlace {
  const char* name;  // of the widget
  const char* page;
  const char* heading;
};

constexpr const char* workbench = "guide/workbench.md";
constexpr const char* echoes = "guide/simulation-window.md";
constexpr const char* viewer = "guide/image-viewer.md";

// The headings are tested against the pages.
constexpr NamedPlace places[] = {
    {"time_bar", workbench, "Time"},
    {"scene_panel", workbench, "Mouse and keys in the scene"},
    {"object_tree_panel", workbench, "Objects"},
    {"property_panel", workbench, "Values"},
    {"function_editor", workbench, "Functions"},
    {"simulation_window", echoes, ""},
    {"radar_view", echoes, "Other views of the same samples"},
    {"save_data_dialog", echoes, "Before saving"},
    {"saving", echoes, "Before saving"},
    {"image_viewer", viewer, ""},
    {"open_image_dialog", viewer, "Which files"},
    {"stored_simulations", workbench, "Stored simulations"},
    {"products", workbench, "Images from echoes"},
    {"target_table_dialog", workbench, "Many targets"},
    {"import_dialog", workbench, "Many targets"},
    {"script_editor", "formats/scene.md", ""},
    {"geometry_window", "formats/geometry-table.md", ""},
    {"log_panel", "guide/troubleshooting.md", ""},
    {"search_box", workbench, "Search"},
    {"welcome_page", workbench, "The first minutes"},
    {"tour", workbench, "The first minutes"},
};

}  // namespace

HelpPlace help_place_of(const QWidget* widget) {
  for (; widget != nullptr; widget = widget->parentWidget())
    for (const NamedPlace& place : places)
      if (widget->objectName() == QLatin1String(place.name)) return {place.page, place.heading};
  return {workbench, {}};
}

std::vector<HelpPlace> all_help_places() {
  std::vector<HelpPlace> all{{workbench, {}}};
  for (const NamedPlace& place : places) all.push_back({place.page, place.heading});
  return all;
}

HelpKey::HelpKey(QObject* parent) : QObject(parent) { qApp->installEventFilter(this); }

bool HelpKey::eventFilter(QObject* watched, QEvent* event) {
  if (auto* button = qobject_cast<QWidget*>(watched); button != nullptr && event->type() == QEvent::HelpRequest) {
    emit pressed(button);
    return true;
  }
  if (event->type() != QEvent::KeyPress || QApplication::activePopupWidget() != nullptr)
    return QObject::eventFilter(watched, event);
  const auto* key = static_cast<QKeyEvent*>(event);
  auto* widget = qobject_cast<QWidget*>(watched);
  if (widget == nullptr || key->key() != Qt::Key_F1 || key->modifiers() != Qt::NoModifier)
    return QObject::eventFilter(watched, event);
  emit pressed(widget);
  return true;
}

}  // namespace sarsim::gui
