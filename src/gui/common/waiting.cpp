#include "gui/common/waiting.hpp"

#include <QApplication>
#include <QEventLoop>
#include <QProgressDialog>
#include <QTimer>

#include <utility>

#include "gui/common/text.hpp"

namespace sarsim::gui {

namespace {

constexpr int moment_ms = 600;

// Waits until the loop ends, which it does where the work has ended or the user gives it up.
void wait_with_dialog(const QString& what, const BackgroundJob& job, QEventLoop& until_ended) {
  constexpr int steps = 1000;
  QProgressDialog dialog(what, QCoreApplication::translate("Waiting", "Cancel"), 0, steps,
                         QApplication::activeWindow());
  dialog.setObjectName("waiting_dialog");
  dialog.setWindowTitle(QCoreApplication::translate("Waiting", "Please Wait"));
  dialog.setWindowModality(Qt::ApplicationModal);
  dialog.setMinimumDuration(0);
  dialog.setAutoReset(false);
  QObject::connect(&job, &BackgroundJob::progressed, &dialog, [&](double fraction, double seconds_left) {
    dialog.setValue(static_cast<int>(steps * fraction));
    dialog.setLabelText(with_time_left(what, seconds_left));
  });
  QObject::connect(&dialog, &QProgressDialog::canceled, &until_ended, &QEventLoop::quit);
  dialog.show();
  until_ended.exec();
}

}  // namespace

Waited run_and_wait(const QString& what, BackgroundJob::Work work) {
  auto* const job = new BackgroundJob(qApp);  // outlives this where it is given up
  Waited waited;
  bool ended = false;
  QEventLoop until_ended;
  QObject::connect(job, &BackgroundJob::ended, &until_ended, [&](JobEnd end, const QString& failure) {
    waited = {end, failure};
    ended = true;
    until_ended.quit();
  });
  QObject::connect(job, &BackgroundJob::ended, job, &QObject::deleteLater);
  QTimer::singleShot(moment_ms, &until_ended, &QEventLoop::quit);
  QApplication::setOverrideCursor(Qt::WaitCursor);
  job->start(std::move(work));
  until_ended.exec(QEventLoop::ExcludeUserInputEvents);
  QApplication::restoreOverrideCursor();
  if (!ended) wait_with_dialog(what, *job, until_ended);
  if (!ended) job->cancel();
  return waited;
}

}  // namespace sarsim::gui
