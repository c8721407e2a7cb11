#include "gui/runs/run_job.hpp"

#include <utility>

#include "core/text/number_text.hpp"
#include "gui/common/problem_line.hpp"
#include "workflow/input/output_names.hpp"
#include "workflow/record/record_size.hpp"

namespace sarsim::gui {

namespace fs = std::filesystem;

namespace {

QString size_text(double bytes) { return QString::fromStdString(core::bytes_text(bytes)); }

RunEstimate estimate_of(const workflow::PreparedRecording& prepared) {
  RunEstimate estimate{.takes = prepared.estimate, .engine = {}, .warnings = {}};
  const std::string_view engine = simulate::name_of(prepared.plan.engine.engine);
  estimate.engine = QString::fromLatin1(engine.data(), static_cast<qsizetype>(engine.size()));
  for (const core::Problem& problem : prepared.problems)
    if (problem.severity == core::Severity::warning) estimate.warnings += problem_text(problem);
  return estimate;
}

// Who tells of a recording's progress; where the LSB is found first, that is half of the work.
core::Observer observer_of(const core::StopFlag& stop, const BackgroundJob::Report& report, bool twice) {
  core::Observer observer;
  observer.stop = &stop;
  observer.progress = [&report, twice, first = std::string()](const std::string& stage,
                                                              const core::Progress& progress) mutable {
    if (first.empty()) first = stage;
    const double from = twice && stage != first ? 0.5 : 0.0;
    const double to = twice && stage == first ? 0.5 : 1.0;
    const double share =
        progress.total > 0 ? static_cast<double>(progress.done) / static_cast<double>(progress.total) : 1.0;
    report(from + (to - from) * share);
  };
  return observer;
}

QString millivolts(double volts) { return QStringLiteral("%1 mV").arg(1e3 * volts, 0, 'g', 6); }

QString percent(double share) { return QStringLiteral("%1 %").arg(100.0 * share, 0, 'g', 4); }

double share(std::uint64_t part, const raster::RunReport& run) {
  const double samples = static_cast<double>(run.rows) * static_cast<double>(run.columns);
  return samples > 0.0 ? static_cast<double>(part) / samples : 0.0;
}

}  // namespace

RunJob::RunJob(RunRequest request, QObject* parent)
    : QObject(parent), request_(std::move(request)), job_(std::make_unique<BackgroundJob>()) {
  connect(job_.get(), &BackgroundJob::progressed, this, &RunJob::progressed);
  connect(job_.get(), &BackgroundJob::ended, this, &RunJob::ended);
}

RunJob::~RunJob() { cancel(); }

void RunJob::start() {
  job_->start([this](const core::StopFlag& stop, const BackgroundJob::Report& report) { work(stop, report); });
}

void RunJob::proceed() {
  const std::scoped_lock hold(lock_);
  may_proceed_ = true;
  changed_.notify_all();
}

void RunJob::cancel() {
  job_->cancel();
  const std::scoped_lock hold(lock_);
  changed_.notify_all();
}

void RunJob::wait_for_leave(const core::StopFlag& stop) {
  std::unique_lock hold(lock_);
  changed_.wait(hold, [&] { return may_proceed_ || stop.requested(); });
  if (stop.requested()) throw core::Interrupted();
}

void RunJob::work(const core::StopFlag& stop, const BackgroundJob::Report& report) {
  const workflow::PreparedRecording prepared = workflow::prepare_recording(
      request_.scene, request_.simulation, request_.file,
      {.replace = request_.replace, .counts = request_.counts, .doubles = request_.doubles}, &stop);
  const RunEstimate estimate = estimate_of(prepared);
  QMetaObject::invokeMethod(
      this, [this, estimate] { emit estimated(estimate); }, Qt::QueuedConnection);
  wait_for_leave(stop);

  const workflow::RecordingReport made = workflow::make_recording(
      prepared, observer_of(stop, report, workflow::seeks_lsb(prepared.plan.acquisition.simulation, request_.counts)));
  summary_.report = made.run;
  summary_.counts = made.counts;
  summary_.simulation = prepared.plan.acquisition.simulation;
  summary_.file = request_.file;
  summary_.engine = QString::fromStdString(made.engine + " (" + made.engine_reason + ")");
  summary_.bytes = made.bytes.value_or(prepared.estimate.bytes);
  summary_.seconds = made.seconds;
}

QStringList summary_lines(const RunSummary& summary) {
  const raster::RunReport& run = summary.report;
  const bool given = summary.simulation.lsb_v > 0.0;
  QStringList lines;
  lines += RunJob::tr("%1: %2 x %3 samples, %4, %5")
               .arg(QString::fromStdString(summary.file.string()))
               .arg(run.rows)
               .arg(run.columns)
               .arg(size_text(summary.bytes), QString::fromStdString(core::duration_text(summary.seconds)));
  lines += RunJob::tr("Largest magnitude %1, %2 of the converter's range")
               .arg(millivolts(run.maximum_v), percent(run.range_used));
  if (summary.counts || given)
    lines += RunJob::tr("LSB %1 (%2), best %3")
                 .arg(millivolts(run.lsb_v), given ? RunJob::tr("as given") : RunJob::tr("estimated from the data"),
                      millivolts(run.best_lsb_v));
  else
    lines += RunJob::tr("Best LSB %1").arg(millivolts(run.best_lsb_v));
  lines += RunJob::tr("%1 of the samples saturated, %2 zero")
               .arg(percent(share(run.saturated, run)), percent(share(run.zero, run)));
  lines += RunJob::tr("Engine: %1").arg(summary.engine);
  return lines;
}

QString saturation_warning(const RunSummary& summary) {
  if (summary.report.saturated == 0) return {};
  return RunJob::tr("%1 of the samples were clipped: an LSB of %2 would avoid clipping.")
      .arg(percent(share(summary.report.saturated, summary.report)), millivolts(summary.report.best_lsb_v));
}

QString estimate_text(const RunEstimate& estimate) {
  return RunJob::tr("%1 x %2 samples, %3, %4, %5 of memory, %6 engine")
      .arg(estimate.takes.rows)
      .arg(estimate.takes.columns)
      .arg(size_text(estimate.takes.bytes), QString::fromStdString(core::about_duration_text(estimate.takes.seconds)),
           size_text(estimate.takes.memory_bytes), estimate.engine);
}

fs::path run_file(const scene::Scene& scene, std::size_t simulation, const fs::path& folder) {
  if (simulation >= scene.simulations.size()) return {};
  return workflow::output_names(scene, {folder, false, {}}).simulations[simulation];
}

}  // namespace sarsim::gui
