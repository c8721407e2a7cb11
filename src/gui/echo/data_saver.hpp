#pragma once

#include <QObject>

#include "gui/common/session.hpp"

class QWidget;

namespace sarsim::gui {

class SaveDataDialog;
class SaveQueue;
class SimulationWindow;

/// Takes a simulation window's data from the wish to save them to the file or the script: dialog, queue, log.
class DataSaver : public QObject {
  Q_OBJECT

 public:
  /// @param owner  of the window of the queue
  DataSaver(Session& session, QWidget* owner);

  [[nodiscard]] SaveQueue& queue() { return *queue_; }
  /// Opens the dialog on a window; it deletes itself when it is closed.
  SaveDataDialog* ask(const scene::Simulation& simulation, SimulationWindow& from);
  /// Does what was chosen.
  void take(const SaveDataDialog& dialog);

 private:
  Session& session_;
  SaveQueue* queue_;
};

}  // namespace sarsim::gui
