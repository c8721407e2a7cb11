#pragma once

#include <QObject>
#include <QStringList>

#include <condition_variable>
#include <filesystem>
#include <memory>
#include <mutex>
#include <string>

#include "gui/common/background_job.hpp"
#include "raster/table/sink.hpp"
#include "workflow/record/prepared_recording.hpp"

namespace sarsim::gui {

/// One simulation of a scene to be computed into a file.
struct RunRequest {
  scene::Scene scene;
  std::size_t simulation = 0;
  std::filesystem::path file;
  bool replace = false;  ///< An existing file may be replaced.
  bool counts = false;   ///< Counts of the converter instead of volts in HDF5 and NPY.
  bool doubles = false;  ///< Volts of HDF5 and NPY in double precision.
};

/// What a run will take, known before its first pulse.
struct RunEstimate {
  workflow::RecordingEstimate takes;
  QString engine;
  QStringList warnings;  ///< Of the scene and its echoes.
};

/// What a run came to.
struct RunSummary {
  scene::Simulation simulation;
  raster::RunReport report;
  std::filesystem::path file;
  QString engine;  ///< With the reason for it.
  double bytes = 0.0;
  double seconds = 0.0;
  bool counts = false;  ///< The file holds counts of the converter, not volts.
};

/// Runs a simulation to a file on a thread of its own, as `sarsim run` does: check and survey, plan, LSB, echoes.
/// The file appears when it is complete; cancelled or failed, nothing is left behind.
class RunJob : public QObject {
  Q_OBJECT

 public:
  /// A run that has not begun.
  explicit RunJob(RunRequest request, QObject* parent = nullptr);
  ~RunJob() override;

  /// Plans; then `estimated` is emitted and the job waits for `proceed` or `cancel`.
  void start();
  /// Begins to compute what was planned.
  void proceed();
  /// Asks the run to end; `ended` follows.
  void cancel();
  [[nodiscard]] bool running() const { return job_->running(); }
  /// After `ended` with JobEnd::done.
  [[nodiscard]] const RunSummary& summary() const { return summary_; }
  [[nodiscard]] const RunRequest& request() const { return request_; }

 signals:
  void estimated(const sarsim::gui::RunEstimate& estimate);     ///< It is planned, and waits.
  void progressed(double fraction, double seconds_left);        ///< Seconds below 0: not known yet.
  void ended(sarsim::gui::JobEnd end, const QString& failure);  ///< With words about its failure, where it failed.

 private:
  void work(const core::StopFlag& stop, const BackgroundJob::Report& report);
  void wait_for_leave(const core::StopFlag& stop);

  RunRequest request_;
  RunSummary summary_;
  std::mutex lock_;
  std::condition_variable changed_;
  bool may_proceed_ = false;
  std::unique_ptr<BackgroundJob> job_;
};

/// The summary in lines for people: size, time, largest magnitude, LSB, shares of saturated and zero samples.
[[nodiscard]] QStringList summary_lines(const RunSummary& summary);
/// What to do about clipped samples, with the LSB that would hold them all; empty where none was.
[[nodiscard]] QString saturation_warning(const RunSummary& summary);
/// "512 x 2048 samples, 2.1 MB, about 3 s, 40 MB of memory, spectral engine".
[[nodiscard]] QString estimate_text(const RunEstimate& estimate);

/// Where a simulation's file goes in a folder: the base name of its name after either kind of slash; where simulations
/// before it in the scene have the same one, with their number: "sim-2.bin", as `sarsim run` has it. Empty for a name
/// without a base name.
[[nodiscard]] std::filesystem::path run_file(const scene::Scene& scene, std::size_t simulation,
                                             const std::filesystem::path& folder);

}  // namespace sarsim::gui
