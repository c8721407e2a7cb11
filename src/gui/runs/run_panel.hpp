#pragma once

#include <QWidget>

#include <memory>

#include "gui/runs/run_job.hpp"

class QLabel;
class QProgressBar;
class QPushButton;

namespace sarsim::gui {

class ProblemLine;

/// Shows a run from its estimate to its report: progress with the time left, Cancel, and what came of it. Runs that
/// take long or much memory wait for Start; others begin by themselves. Takes no room before the first run.
class RunPanel : public QWidget {
  Q_OBJECT

 public:
  explicit RunPanel(QWidget* parent = nullptr);
  ~RunPanel() override;

  /// Begins a run; the one before must have ended.
  void run(RunRequest request);
  /// Asks the run to end; `ended` follows.
  void cancel();
  [[nodiscard]] bool running() const { return job_ && job_->running(); }
  /// Runs that are expected to take longer wait for Start.
  void set_patience_s(double seconds) { patience_s_ = seconds; }

 signals:
  void ended(sarsim::gui::JobEnd end);  ///< The run is over; the panel says what came of it.
  /// The user wants this LSB for the simulation that was run.
  void lsb_wanted(const sarsim::scene::Simulation& simulation, double lsb_v);

 private:
  void show_estimate(const RunEstimate& estimate);
  void show_progress(double fraction, double seconds_left);
  void show_end(JobEnd end, const QString& failure);
  void proceed();

  std::unique_ptr<RunJob> job_;
  double patience_s_ = 10.0;
  QLabel* title_ = nullptr;
  QLabel* state_ = nullptr;
  QProgressBar* bar_ = nullptr;
  QPushButton* start_ = nullptr;
  QPushButton* cancel_ = nullptr;
  QPushButton* use_lsb_ = nullptr;
  QLabel* report_ = nullptr;
  ProblemLine* problems_ = nullptr;
};

}  // namespace sarsim::gui
