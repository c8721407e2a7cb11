#pragma once

#include <QWidget>

#include <cstddef>
#include <filesystem>
#include <memory>
#include <vector>

#include "gui/runs/run_job.hpp"

class QLabel;
class QProgressBar;
class QPushButton;
class QTableWidget;

namespace sarsim::gui {

class ProblemLine;

/// How far a run of a queue is.
enum class SaveState { waiting, running, done, cancelled, failed };

/// Runs that save data, one after the other: progress and time left, Cancel, and what came of each. Files appear when
/// they are complete; cancelled or failed, a run leaves nothing behind, and what it was to replace stays.
class SaveQueue : public QWidget {
  Q_OBJECT

 public:
  explicit SaveQueue(QWidget* parent = nullptr);
  ~SaveQueue() override;

  /// Adds a run to the end and shows it; it begins when those before have ended. Returns its number from 0.
  std::size_t add(RunRequest request);
  /// Ends a run, or keeps one that waits from beginning.
  void cancel(std::size_t run);
  /// Ends the run that is under way and forgets those that wait.
  void cancel_all();
  /// Whether a run has not ended yet.
  [[nodiscard]] bool busy() const;
  [[nodiscard]] std::size_t size() const { return runs_.size(); }
  [[nodiscard]] SaveState state(std::size_t run) const { return runs_.at(run).state; }
  /// What came of a run in words: the report, or why there is none.
  [[nodiscard]] QString report(std::size_t run) const;
  /// Whether a run that has not ended will write this file.
  [[nodiscard]] bool will_write(const std::filesystem::path& file) const;

 signals:
  void ended(std::size_t run, sarsim::gui::SaveState state);  ///< One of them is over.

 private:
  struct Run {
    RunRequest request;
    SaveState state = SaveState::waiting;
    QString words;  ///< Progress, or the estimate.
    QStringList warnings;
    QString failure;
    RunSummary summary;
    bool repeated = false;  ///< Saved again with another LSB.
  };
  [[nodiscard]] static bool may_repeat(const Run& run) {
    return run.state == SaveState::done && run.summary.report.saturated > 0 && !run.repeated;
  };
  void make_buttons();
  void start_next();
  void take_estimate(const RunEstimate& estimate);
  void take_progress(double fraction, double seconds_left);
  void take_end(JobEnd end, const QString& failure);
  void save_again();
  void clear_ended();
  void show_run(std::size_t run);
  void show_chosen();
  [[nodiscard]] std::size_t chosen() const;

  std::vector<Run> runs_;
  std::size_t current_ = 0;  // of the job
  std::unique_ptr<RunJob> job_;
  QTableWidget* table_ = nullptr;
  QProgressBar* bar_ = nullptr;
  QLabel* report_ = nullptr;
  ProblemLine* problems_ = nullptr;
  QPushButton* cancel_ = nullptr;
  QPushButton* again_ = nullptr;
  QPushButton* clear_ = nullptr;
};

}  // namespace sarsim::gui
