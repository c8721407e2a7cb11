#include "workflow/record/recording.hpp"

#include <memory>

#include "core/task/clock.hpp"
#include "raster/format/sinks.hpp"
#include "raster/table/formats.hpp"
#include "simulate/run/run.hpp"

namespace sarsim::workflow {

namespace fs = std::filesystem;

namespace {

std::unique_ptr<raster::Sink> sink_of(const RecordingJob& job, const raster::Product& product) {
  if (job.discard) return raster::make_discarding_sink(product, job.options);
  return raster::make_sink(job.file, product, job.options);
}

}  // namespace

RecordingReport make_recording(const RecordingJob& job, unsigned threads, const core::Observer& observer) {
  const double begin_s = core::now_s();
  const simulate::Plan& plan = job.plan;
  const raster::Product product =
      simulate::product_of(plan, raster::format_of(job.options.format).carries_script ? job.script : std::string());
  const std::unique_ptr<raster::Sink> sink = sink_of(job, product);
  RecordingReport report = begun_report(plan, product);
  report.counts = sink->wants_counts();
  const std::string name = job.file.string();
  const auto control = [&](const std::string& stage) -> raster::RunControl {
    return {threads, observer.stop, begun_stage(observer, stage, plan)};
  };
  double lsb_v = plan.acquisition.simulation.lsb_v;
  if (lsb_v <= 0.0 && report.counts)
    lsb_v = simulate::resolved_lsb_v(plan, control(name + " (finding the largest magnitude)"));
  report.run = simulate::run(plan, lsb_v, *sink, control(name));
  if (!job.discard) take_file(job.file, report);
  report.seconds = core::now_s() - begin_s;
  return report;
}

RecordingReport begun_report(const simulate::Plan& plan, const raster::Product& product) {
  RecordingReport report;
  report.simulation = plan.acquisition.simulation;
  report.simulation.radar = plan.acquisition.link.name;
  report.options = product.options;
  report.engine = product.engine;
  report.engine_reason = plan.engine.reason;
  return report;
}

void take_file(const fs::path& path, RecordingReport& report) {
  report.file = path.string();
  report.bytes = static_cast<double>(raster::stored_bytes(path));
}

core::ProgressReport begun_stage(const core::Observer& observer, const std::string& name, const simulate::Plan& plan) {
  core::ProgressReport progress = observer.stage(name);
  if (progress) progress({0, plan.acquisition.timing.rows, plan.acquisition.reception.columns});
  return progress;
}

}  // namespace sarsim::workflow
