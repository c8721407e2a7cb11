#include "gui/runs/product_job.hpp"

#include <chrono>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include "core/report/invalid_request.hpp"

namespace sarsim::gui {

namespace {

using Clock = std::chrono::steady_clock;

double elapsed_s(Clock::time_point since) { return std::chrono::duration<double>(Clock::now() - since).count(); }

// When a stage began, and when it was told of last.
struct StageClock {
  std::string stage;
  Clock::time_point begin;
  double told_s = -1.0;

  void follow(const std::string& name) {
    if (name == stage) return;
    stage = name;
    begin = Clock::now();
    told_s = -1.0;
  }
  // Not more often than eyes can follow.
  [[nodiscard]] bool may_tell(double now_s, double fraction) {
    constexpr double between_s = 0.05;
    if (told_s >= 0.0 && now_s - told_s < between_s && fraction < 1.0) return false;
    told_s = now_s;
    return true;
  }
};

}  // namespace

ProductJob::ProductJob(QObject* parent) : QObject(parent) {
  connect(&job_, &BackgroundJob::ended, this, &ProductJob::ended);
}

ProductJob::~ProductJob() { job_.disconnect(this); }

void ProductJob::start(Work work) {
  if (running()) throw std::logic_error("product job: work is under way");
  result_ = {};
  refusals_.clear();
  job_.start([this, work = std::move(work)](const core::StopFlag& stop, const BackgroundJob::Report&) {
    work_through(work, stop);
  });
}

void ProductJob::stop() { job_.cancel(); }

// On the worker's thread.
void ProductJob::work_through(const Work& work, const core::StopFlag& stop) {
  try {
    result_ = work(observer(stop));
  } catch (const core::InvalidRequest& refused) {
    refusals_ = refused.problems;
    throw;
  }
}

core::Observer ProductJob::observer(const core::StopFlag& stop) {
  core::Observer observer;
  observer.stop = &stop;
  observer.progress = [this, clock = std::make_shared<StageClock>()](const std::string& stage,
                                                                     const core::Progress& progress) {
    if (progress.total == 0) return;
    clock->follow(stage);
    const double fraction = static_cast<double>(progress.done) / static_cast<double>(progress.total);
    const double now_s = elapsed_s(clock->begin);
    if (!clock->may_tell(now_s, fraction)) return;
    constexpr double enough_to_judge = 0.01;
    const double left_s = fraction > enough_to_judge ? now_s * (1.0 - fraction) / fraction : -1.0;
    QMetaObject::invokeMethod(
        this,
        [this, name = QString::fromStdString(stage), fraction, left_s] { emit progressed(name, fraction, left_s); },
        Qt::QueuedConnection);
  };
  observer.announce = [this](const std::string& line) {
    QMetaObject::invokeMethod(
        this, [this, words = QString::fromStdString(line)] { emit announced(words); }, Qt::QueuedConnection);
  };
  return observer;
}

}  // namespace sarsim::gui
