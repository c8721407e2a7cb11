#include "gui/echo/data_saver.hpp"

#include <QSettings>
#include <QStandardPaths>

#include <filesystem>

#include "gui/echo/simulation_window.hpp"
#include "gui/runs/save_data_dialog.hpp"
#include "gui/runs/save_queue.hpp"
#include "scene/edit/edit.hpp"

namespace sarsim::gui {

namespace fs = std::filesystem;

namespace {

const QString folder_key = QStringLiteral("saving/folder");

// That of the script; of one that was never saved, that of the last data.
fs::path folder_of(const scene::Document& document) {
  if (!document.path().empty()) return fs::absolute(document.path()).parent_path();
  const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
  const fs::path last = QSettings().value(folder_key, documents).toString().toStdString();
  std::error_code unreadable;
  return fs::is_directory(last, unreadable) ? last : fs::current_path();
}

}  // namespace

DataSaver::DataSaver(Session& session, QWidget* owner) : QObject(owner), session_(session) {
  queue_ = new SaveQueue(owner);
  queue_->setWindowFlag(Qt::Window);
  connect(queue_, &SaveQueue::ended, this, [this](std::size_t run, SaveState state) {
    const core::Severity severity = state == SaveState::failed ? core::Severity::error : core::Severity::note;
    session_.log(severity, queue_->report(run).section('\n', 0, 0));
  });
}

SaveDataDialog* DataSaver::ask(const scene::Simulation& simulation, SimulationWindow& from) {
  auto* const dialog = new SaveDataDialog(session_, simulation, from.bandwidth_hz(), from.largest_v(),
                                          folder_of(session_.document()), &from);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowModality(Qt::WindowModal);
  dialog->is_taken = [this](const fs::path& file) { return queue_->will_write(file); };
  connect(dialog, &QDialog::accepted, this, [this, dialog] { take(*dialog); });
  dialog->open();
  return dialog;
}

void DataSaver::take(const SaveDataDialog& dialog) {
  const auto choice = dialog.choice();
  if (!choice) return;
  const scene::Simulation simulation = dialog.simulation();
  // What is run is the scene as it would be stored, so that a run of the stored one gives the same file.
  scene::Scene scene = workflow::with_simulation(session_.scene(), simulation);
  if (choice->target != workflow::SaveTarget::disk) {
    session_.perform(scene::add_object(session_.scene(), simulation));
    scene = session_.scene();
    session_.log(core::Severity::note,
                 tr("Stored the settings of the window as simulation %1").arg(scene.simulations.size()));
  }
  if (choice->target == workflow::SaveTarget::script) return;
  QSettings().setValue(folder_key, QString::fromStdString(choice->file.parent_path().string()));
  const std::size_t last = scene.simulations.size() - 1;
  const raster::SinkOptions options = workflow::sink_options_of(*choice, dialog.replace());
  queue_->add({std::move(scene), last, choice->file, options.replace, options.counts, options.doubles});
  queue_->show();
  queue_->raise();
}

}  // namespace sarsim::gui
