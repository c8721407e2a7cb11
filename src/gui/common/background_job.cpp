#include "gui/common/background_job.hpp"

#include <chrono>
#include <stdexcept>
#include <utility>

#include "core/report/invalid_request.hpp"
#include "gui/common/problem_line.hpp"

namespace sarsim::gui {

namespace {

using Clock = std::chrono::steady_clock;

// Warnings beside the errors are of no use to who has to mend these.
QString words_of(const core::InvalidRequest& refused) {
  QStringList texts;
  for (const core::Problem& problem : refused.problems)
    if (problem.severity == core::Severity::error) texts << problem_text(problem);
  return texts.join('\n');
}

double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

}  // namespace

BackgroundJob::BackgroundJob(QObject* parent) : QObject(parent) {}

BackgroundJob::~BackgroundJob() {
  cancel();
  if (thread_.joinable()) thread_.join();
}

void BackgroundJob::start(Work work) {
  if (running_) throw std::logic_error("background job: work is under way");
  if (thread_.joinable()) thread_.join();
  stop_ = std::make_unique<core::StopFlag>();
  running_ = true;
  thread_ = std::thread([this, work = std::move(work)] { work_through(work); });
}

void BackgroundJob::cancel() {
  if (stop_) stop_->request();
}

// Runs on the worker's thread. What it posts is dropped by Qt where this object is gone by then.
void BackgroundJob::work_through(const Work& work) {
  const Clock::time_point begin = Clock::now();
  double last_told_s = -1.0;
  const Report report = [&](double fraction) {
    constexpr double between_reports_s = 0.05;
    const double now_s = seconds_since(begin);
    if (last_told_s >= 0.0 && now_s - last_told_s < between_reports_s && fraction < 1.0) return;
    last_told_s = now_s;
    constexpr double enough_to_judge = 0.01;
    const double left_s = fraction > enough_to_judge ? now_s * (1.0 - fraction) / fraction : -1.0;
    QMetaObject::invokeMethod(
        this, [this, fraction, left_s] { emit progressed(fraction, left_s); }, Qt::QueuedConnection);
  };
  try {
    work(*stop_, report);
    end_with(JobEnd::done, {});
  } catch (const core::Interrupted&) {
    end_with(JobEnd::cancelled, {});
  } catch (const core::InvalidRequest& refused) {
    end_with(JobEnd::failed, words_of(refused));
  } catch (const std::bad_alloc&) {
    end_with(JobEnd::failed, tr("There is not enough memory for this."));
  } catch (const std::exception& error) {
    end_with(JobEnd::failed, QString::fromStdString(error.what()));
  }
}

void BackgroundJob::end_with(JobEnd end, const QString& failure) {
  QMetaObject::invokeMethod(
      this,
      [this, end, failure] {
        thread_.join();
        running_ = false;
        emit ended(end, failure);
      },
      Qt::QueuedConnection);
}

}  // namespace sarsim::gui
