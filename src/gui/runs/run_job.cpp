#include "gui/runs/run_job.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <utility>

#include "core/task/clock.hpp"
#include "core/task/parallel.hpp"
#include "core/text/number_text.hpp"
#include "gui/common/problem_line.hpp"
#include "raster/format/sinks.hpp"
#include "raster/table/formats.hpp"
#include "scene/check/check.hpp"
#include "scene/script/writer.hpp"
#include "simulate/resolve/impossible_echo.hpp"
#include "simulate/run/run.hpp"
#include "simulate/survey/survey.hpp"
#include "workflow/record/save_estimate.hpp"

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
QStringList warnings_of_sound(const scene::Scene& one) {
  core::Problems problems = scene::check(one);
  if (!core::has_errors(problems)) std::ranges::move(simulate::survey(one), std::back_inserter(problems));
  problems = core::ranked(std::move(problems));
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
  std::error_code failure;
  const fs::space_info space = fs::space(folder, failure);
  if (failure || bytes <= static_cast<double>(space.available)) return;
  throw std::runtime_error(
      RunJob::tr(
          "The disk of '%1' has not enough room: %2 are needed, %3 are free. Make room or choose another folder.")
          .arg(QString::fromStdString(folder.string()), size_text(bytes),
               size_text(static_cast<double>(space.available)))
          .toStdString());
}

RunEstimate estimate_of(const simulate::Plan& plan, double bytes, QStringList warnings) {
  const unsigned threads = core::thread_count(0);
  const simulate::Cost cost = simulate::estimated_cost(plan, threads);
  const bool twice = plan.simulation.lsb_v <= 0.0 && raster::holds_counts(plan.simulation.format);
  RunEstimate estimate;
  estimate.rows = plan.rows;
  estimate.columns = plan.columns;
  estimate.bytes = bytes;
  estimate.seconds = cost.seconds_one_thread / threads * (twice ? 2.0 : 1.0);
  estimate.memory_bytes = cost.memory_bytes;
  const std::string_view engine = simulate::name_of(plan.engine.engine);
  estimate.engine = QString::fromLatin1(engine.data(), static_cast<qsizetype>(engine.size()));
  estimate.warnings = std::move(warnings);
  return estimate;
}

// Part of the work, from `from` to `to` of the whole.
core::ProgressReport part_of(const BackgroundJob::Report& report, double from, double to) {
  return [&report, from, to](const core::Progress& progress) {
    const double share =
        progress.total > 0 ? static_cast<double>(progress.done) / static_cast<double>(progress.total) : 1.0;
    report(from + (to - from) * share);
  };
}

QString millivolts(double volts) { return QStringLiteral("%1 mV").arg(1e3 * volts, 0, 'g', 6); }

QString percent(double share) { return QStringLiteral("%1 %").arg(100.0 * share, 0, 'g', 4); }

double share(std::uint64_t part, const simulate::RunReport& run) {
  const double samples = static_cast<double>(run.rows) * static_cast<double>(run.columns);
  return samples > 0.0 ? static_cast<double>(part) / samples : 0.0;
}

std::string base_name(const std::string& name) {
  const std::size_t slash = name.find_last_of("/\\");
  std::string base = slash == std::string::npos ? name : name.substr(slash + 1);
  const bool drive = slash == std::string::npos && base.size() >= 2 && base[1] == ':';
  return drive ? base.substr(2) : base;
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
  QStringList warnings = warnings_of_sound(with_only(request_.scene, request_.simulation));
  const auto resolved = std::make_shared<const simulate::ResolvedScene>(simulate::resolve(request_.scene));
  const simulate::Plan plan =
      simulate::make_plan(request_.scene, request_.simulation, resolved, simulate::Engine::automatic);
  const bool with_script = raster::format_of(plan.simulation.format).carries_script;
  const simulate::Product product =
      simulate::product_of(plan, with_script ? scene::write_script(request_.scene) : std::string());
  const raster::SinkOptions options{plan.simulation.format, request_.replace, false, false};
  const double bytes = raster::expected_bytes(product, options);
  const RunEstimate estimate = estimate_of(plan, bytes, std::move(warnings));
  QMetaObject::invokeMethod(
      this, [this, estimate] { emit estimated(estimate); }, Qt::QueuedConnection);
  wait_for_leave(stop);

  const double begin_s = core::now_s();
  expect_room(request_.file, raster::least_bytes(plan.simulation.format, bytes));
  const std::unique_ptr<simulate::Sink> sink = raster::make_sink(request_.file, product, options);
  const bool seek_lsb = plan.simulation.lsb_v <= 0.0 && sink->wants_counts();
  double lsb_v = plan.simulation.lsb_v;
  if (seek_lsb) lsb_v = simulate::resolved_lsb_v(plan, {0, &stop, part_of(report, 0.0, 0.5)});
  summary_.report = simulate::run(plan, lsb_v, *sink, {0, &stop, part_of(report, seek_lsb ? 0.5 : 0.0, 1.0)});
  summary_.counts = sink->wants_counts();
  summary_.simulation = plan.simulation;
  summary_.file = request_.file;
  summary_.engine = QString::fromStdString(product.engine + " (" + plan.engine.reason + ")");
  std::error_code failure;
  const auto size = fs::file_size(request_.file, failure);
  summary_.bytes = failure ? bytes : static_cast<double>(size);
  summary_.seconds = core::now_s() - begin_s;
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
  std::set<fs::path> taken;
  for (std::size_t i = 0; i <= simulation && i < scene.simulations.size(); ++i) {
    const fs::path base = base_name(scene.simulations[i].file);
    if (base.empty() || base == "." || base == "..") {
      if (i == simulation) return {};
      continue;
    }
    fs::path file = folder / base;
    for (int number = 2; !taken.insert(file).second; ++number)
      file.replace_filename(base.stem().string() + "-" + std::to_string(number) + base.extension().string());
    if (i == simulation) return file;
  }
  return {};
}

}  // namespace sarsim::gui
