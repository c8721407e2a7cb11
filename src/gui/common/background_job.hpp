#pragma once

#include <QObject>
#include <QString>

#include <functional>
#include <memory>
#include <thread>

#include "core/task/stop.hpp"

namespace sarsim::gui {

/// How long work ended.
enum class JobEnd { done, cancelled, failed };

/// Long work on a thread of its own, one piece at a time. Signals come on the thread of this object. Destroyed before
/// the end, the work is stopped and waited for.
class BackgroundJob : public QObject {
  Q_OBJECT

 public:
  /// Tells how far the work is, 0 to 1; may be called as often as it likes.
  using Report = std::function<void(double fraction)>;
  /// The work: throws Interrupted when stopped and std::exception with words for people where it fails.
  using Work = std::function<void(const core::StopFlag& stop, const Report& report)>;

  explicit BackgroundJob(QObject* parent = nullptr);
  ~BackgroundJob() override;

  /// Begins; std::logic_error where work is under way.
  void start(Work work);
  /// Asks the work to end; `ended` follows.
  void cancel();
  [[nodiscard]] bool running() const { return running_; }

 signals:
  void progressed(double fraction, double seconds_left);        ///< Seconds below 0: not known yet.
  void ended(sarsim::gui::JobEnd end, const QString& failure);  ///< With words about its failure, where it failed.

 private:
  void work_through(const Work& work);
  void end_with(JobEnd end, const QString& failure);

  std::unique_ptr<core::StopFlag> stop_;
  std::thread thread_;
  bool running_ = false;
};

}  // namespace sarsim::gui
