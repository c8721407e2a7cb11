#pragma once

#include <QObject>

#include <vector>

#include "gui/common/session.hpp"
#include "picture/echo/echo_window.hpp"

class QWidget;

namespace sarsim::gui {

class SimulationWindow;

/// The simulation windows of a workbench: opens them, lets linked ones follow each other, puts them aside and closes
/// them with their document.
class SimulationWindows : public QObject {
  Q_OBJECT

 public:
  /// @param owner  of the windows; they stay above it and end with it
  SimulationWindows(Session& session, QWidget* owner);

  /// Opens a window on the current radar, or the first one, that shows all targets. Null where the scene has no radar.
  SimulationWindow* open_new(scene::Processing processing);
  /// Opens a window that shows a stored simulation exactly.
  SimulationWindow* open_stored(scene::ObjectId simulation);
  /// Those of the document at hand.
  [[nodiscard]] std::vector<SimulationWindow*> windows() const;

 signals:
  void opened(sarsim::gui::SimulationWindow* window);  ///< A window was made; it may be put into a place.
  /// The data of a window are to be saved.
  void save_data_wanted(const sarsim::scene::Simulation& simulation, sarsim::gui::SimulationWindow* from);

 private:
  SimulationWindow* open(const picture::EchoWindow& window, bool show_all);

  Session& session_;
  QWidget* owner_;
  QList<SimulationWindow*> windows_;  // of all documents
};

}  // namespace sarsim::gui
