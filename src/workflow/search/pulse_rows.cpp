#include "workflow/search/pulse_rows.hpp"

#include <stdexcept>
#include <utility>

#include "core/task/worker_pool.hpp"
#include "radar/path/path.hpp"
#include "signal/search/cfar_calibration.hpp"
#include "simulate/plan/row_maker.hpp"
#include "simulate/plan/row_space.hpp"
#include "simulate/survey/derived.hpp"

namespace sarsim::workflow {

namespace {

struct SceneWorker {
  explicit SceneWorker(const simulate::Plan& plan) : maker(plan), row(plan.columns) {}
  simulate::RowMaker maker;
  std::vector<std::complex<double>> row;
};

double noise_of(const simulate::Plan& plan, const signal::CompressionFilter& filter) {
  double energy = 0.0;
  for (const std::complex<double>& tap : filter.taps) energy += std::norm(tap);
  return 2.0 * plan.noise_stddev_v * plan.noise_stddev_v * energy;
}

// What compressed data of a plan are, besides the way to read them.
PulseRows compressed_rows(std::shared_ptr<const simulate::Plan> plan) {
  if (!plan->compressor) throw std::invalid_argument("pulses: the plan is not of compressed data");
  PulseRows rows;
  rows.rows = plan->rows;
  rows.columns = plan->columns;
  rows.range_m = plan->column_range_m;
  const bool keeps_peak = plan->scene->conventions.compression == simulate::Conventions::Compression::keeps_peak;
  rows.peak_gain = keeps_peak ? 1.0 : simulate::processing_gain(*plan);
  rows.noise_w = noise_of(*plan, plan->compressor->filter());
  rows.noise_correlation = signal::noise_correlation(plan->compressor->filter().taps);
  rows.plan = std::move(plan);
  return rows;
}

PulseRows rows_of_raw_recording(std::shared_ptr<const simulate::Plan> plan, core::SampleRows<double> recorded) {
  PulseRows rows;
  rows.rows = plan->rows;
  rows.columns = plan->columns;
  const auto compressor = simulate::compressor_of(*plan, plan->radar.window, plan->columns, plan->columns);
  // The filter gives an echo the place of its beginning: that of a centred pulse lies half a pulse before its range.
  const double c = plan->scene->conventions.light_speed_mps;
  for (std::size_t i = 0; i < plan->columns; ++i)
    rows.range_m.push_back(radar::range_of(plan->raw_grid.time_s(i) + plan->pulse.lead_s, c));
  rows.noise_w = noise_of(*plan, compressor->filter());
  rows.noise_correlation = signal::noise_correlation(compressor->filter().taps);
  const auto pool =
      std::make_shared<core::WorkerPool<simulate::RowSpace>>([] { return std::make_unique<simulate::RowSpace>(); });
  rows.copy = [plan, compressor, pool, recorded = std::move(recorded)](std::size_t pulse,
                                                                       std::span<std::complex<float>> out) {
    pool->lend([&](simulate::RowSpace& space) {
      space.raw.resize(plan->columns);
      recorded.read(pulse, space.raw);
      space.compress(*compressor, out);
    });
  };
  rows.plan = std::move(plan);
  return rows;
}

}  // namespace

scene::Simulation compressed_simulation(const scene::Simulation& simulation) {
  scene::Simulation compressed = simulation;
  compressed.processing = scene::Processing::matched_filter;
  return compressed;
}

PulseRows pulse_rows_of_scene(std::shared_ptr<const simulate::Plan> plan) {
  PulseRows rows = compressed_rows(plan);
  const auto pool =
      std::make_shared<core::WorkerPool<SceneWorker>>([plan] { return std::make_unique<SceneWorker>(*plan); });
  rows.copy = [pool](std::size_t pulse, std::span<std::complex<float>> out) {
    pool->lend([&](SceneWorker& worker) {
      worker.maker.make_row(pulse, worker.row);
      simulate::to_float(worker.row, out);
    });
  };
  return rows;
}

PulseRows pulse_rows_of_recording(std::shared_ptr<const simulate::Plan> plan, core::SampleRows<double> recorded) {
  if (plan->simulation.processing == scene::Processing::srp)
    throw std::invalid_argument("pulses: synthetic range profiles have none");
  if (plan->simulation.processing == scene::Processing::raw)
    return rows_of_raw_recording(std::move(plan), std::move(recorded));
  PulseRows rows = compressed_rows(plan);
  const auto pool =
      std::make_shared<core::WorkerPool<simulate::RowSpace>>([] { return std::make_unique<simulate::RowSpace>(); });
  rows.copy = [plan, pool, recorded = std::move(recorded)](std::size_t pulse, std::span<std::complex<float>> out) {
    pool->lend([&](simulate::RowSpace& space) {
      space.raw.resize(plan->columns);
      recorded.read(pulse, space.raw);
      simulate::to_float(space.raw, out);
    });
  };
  return rows;
}

}  // namespace sarsim::workflow
