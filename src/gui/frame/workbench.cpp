#include "gui/frame/workbench.hpp"

#include <QDockWidget>

#include "gui/objects/property_panel.hpp"
#include "gui/script/script_editor.hpp"

namespace sarsim::gui {

void Workbench::commit_typed() const {
  script.commit();
  panel.commit();
}

void Workbench::bring(const QString& dock) const {
  docks.at(dock)->show();
  docks.at(dock)->raise();
}

}  // namespace sarsim::gui
