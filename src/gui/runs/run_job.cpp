#include "gui/runs/run_job.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "core/os/disk_room.hpp"
#include "core/task/parallel.hpp"
#include "core/text/number_text.hpp"
#include "gui/common/problem_line.hpp"
#include "raster/format/sinks.hpp"
#include "raster/table/formats.hpp"
#include "scene/script/writer.hpp"
#include "simulate/resolve/impossible_echo.hpp"
#include "workflow/input/output_names.hpp"
#include "workflow/input/scene_input.hpp"
#include "workflow/record/record_size.hpp"
#include "workflow/record/recording.hpp"

namespace sarsim::gui {

namespace fs = std::filesystem;

namespace {

QString size_text(double bytes) { return QString::fromStdString(core::bytes_text(bytes)); }

// The scene with this recording alone: problems of others are of no interest.
scene::Scene with_only(const scene::Scene& scene, std::size_t simulation) {
  scene::Scene one = scene;
  one.simulations = {scene.simulations.at(simulation)};
  one.geometries.clear();
  return one;
}

// Throws where the scene has errors, with all of them in words; otherwise gives the warnings.
QStringList warnings_of_sound(const core::Problems& problems) {
  QStringList errors;
  QStringList warnings;
  for (const core::Problem& problem : problems) {
    if (problem.severity == core::Severity::note) continue;
    (problem.severity == core::Severity::error ? errors : warnings) += problem_text(problem);
  }
  if (!errors.isEmpty()) throw std::runtime_error(errors.join('\n').toStdString());
  return warnings;
}

void expect_room(const fs::path& file, double bytes) {
  const fs::path folder = fs::absolute(file).parent_path();
  const std::optional<double> free = core::room_if_too_little(folder, bytes);
  if (!free) return;
  throw std::runtime_error(
      RunJob::tr(
          "The disk of '%1' has not enough room: %2 are needed, %3 are free. Make room or choose another folder.")
          .arg(QString::fromStdString(folder.string()), size_text(bytes), size_text(*free))
          .toStdString());
}

RunEstimate estimate_of(const simulate::Plan& plan, double bytes, QStringList warnings) {
  const unsigned threads = core::thread_count(0);
  const simulate::Cost cost = simulate::estimated_cost(plan, threads);
  RunEstimate estimate;
  estimate.rows = plan.rows;
  estimate.columns = plan.columns;
  estimate.bytes = bytes;
  estimate.seconds = cost.seconds_one_thread / threads * workflow::passes_of(plan.simulation);
  estimate.memory_bytes = cost.memory_bytes;
  const std::string_view engine = simulate::name_of(plan.engine.engine);
  estimate.engine = QString::fromLatin1(engine.data(), static_cast<qsizetype>(engine.size()));
  estimate.warnings = std::move(warnings);
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

double share(std::uint64_t part, const simulate::RunReport& run) {
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

void RunJob::work(const core::StopFlag& stop, const BackgroundJob::Report& report) try {
  workflow::SceneInput input =
      workflow::take_scene(with_only(request_.scene, request_.simulation), {}, {}, workflow::Scrutiny::echoes);
  QStringList warnings = warnings_of_sound(input.problems);
  workflow::resolve_once(input, {});
  const simulate::Plan plan =
      simulate::make_plan(request_.scene, request_.simulation, input.resolved, simulate::Engine::automatic);
  const scene::FileFormat format = plan.simulation.format;
  const std::string script =
      raster::format_of(format).carries_script ? scene::write_script(request_.scene) : std::string();
  const raster::SinkOptions options{format, request_.replace, false, false};
  const double bytes = raster::expected_bytes(simulate::product_of(plan, script), options);
  const RunEstimate estimate = estimate_of(plan, bytes, std::move(warnings));
  QMetaObject::invokeMethod(
      this, [this, estimate] { emit estimated(estimate); }, Qt::QueuedConnection);
  wait_for_leave(stop);

  expect_room(request_.file, raster::least_bytes(format, bytes));
  const workflow::RecordingReport made = workflow::make_recording(
      {plan, request_.file, options, script}, 0, observer_of(stop, report, workflow::seeks_lsb(plan.simulation)));
  summary_.report = made.run;
  summary_.counts = made.counts;
  summary_.simulation = plan.simulation;
  summary_.file = request_.file;
  summary_.engine = QString::fromStdString(made.engine + " (" + made.engine_reason + ")");
  summary_.bytes = made.bytes.value_or(bytes);
  summary_.seconds = made.seconds;
} catch (const simulate::ImpossibleEcho& error) {
  throw std::runtime_error(problem_text(error.problem).toStdString());
}

QStringList summary_lines(const RunSummary& summary) {
  const simulate::RunReport& run = summary.report;
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
  return RunJob::tr("%1 of the samples were clipped: an LSB of %2 would hold them all.")
      .arg(percent(share(summary.report.saturated, summary.report)), millivolts(summary.report.best_lsb_v));
}

QString estimate_text(const RunEstimate& estimate) {
  return RunJob::tr("%1 x %2 samples, %3, %4, %5 of memory, %6 engine")
      .arg(estimate.rows)
      .arg(estimate.columns)
      .arg(size_text(estimate.bytes), QString::fromStdString(core::about_duration_text(estimate.seconds)),
           size_text(estimate.memory_bytes), estimate.engine);
}

fs::path run_file(const scene::Scene& scene, std::size_t simulation, const fs::path& folder) {
  if (simulation >= scene.simulations.size()) return {};
  return workflow::output_names(scene, {folder, false, {}}).simulations[simulation];
}

}  // namespace sarsim::gui
