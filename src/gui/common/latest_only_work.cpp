#include "gui/common/latest_only_work.hpp"

#include <utility>

namespace sarsim::gui {

LatestOnlyWork::LatestOnlyWork(QObject* parent) : QObject(parent) {
  connect(&job_, &BackgroundJob::ended, this, &LatestOnlyWork::take_end);
  connect(&job_, &BackgroundJob::progressed, this, [this](double fraction, double seconds_left) {
    if (wanted_ && !next_) emit progressed(fraction, seconds_left);
  });
}

void LatestOnlyWork::run(BackgroundJob::Work work) {
  wanted_ = true;
  if (job_.running()) {
    next_ = std::move(work);
    job_.cancel();
    return;
  }
  job_.start(std::move(work));
}

void LatestOnlyWork::cancel() {
  wanted_ = false;
  next_.reset();
  job_.cancel();
}

void LatestOnlyWork::take_end(JobEnd end, const QString& failure) {
  if (next_) {
    BackgroundJob::Work work = std::move(*next_);
    next_.reset();
    job_.start(std::move(work));
    return;
  }
  if (!std::exchange(wanted_, false)) return;
  emit ended(end == JobEnd::done, failure);
}

}  // namespace sarsim::gui
