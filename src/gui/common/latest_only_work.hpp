#pragma once

#include <QObject>

#include <optional>

#include "gui/common/background_job.hpp"

namespace sarsim::gui {

/// Work in the background of which only the newest counts: a new piece ends the one before, and nothing is told about
/// pieces that were replaced.
class LatestOnlyWork : public QObject {
  Q_OBJECT

 public:
  explicit LatestOnlyWork(QObject* parent = nullptr);

  /// Begins as soon as what is under way has stopped.
  void run(BackgroundJob::Work work);
  /// Ends what is under way and forgets it.
  void cancel();
  [[nodiscard]] bool busy() const { return wanted_; }

 signals:
  void progressed(double fraction, double seconds_left);  ///< As `BackgroundJob` tells it, of the newest piece.
  /// The newest piece has ended: in success, or with words about its failure.
  void ended(bool good, const QString& failure);

 private:
  void take_end(JobEnd end, const QString& failure);

  std::optional<BackgroundJob::Work> next_;
  bool wanted_ = false;  // somebody waits for what runs or is next
  BackgroundJob job_;
};

}  // namespace sarsim::gui
