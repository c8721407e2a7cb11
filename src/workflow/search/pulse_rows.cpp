#include "workflow/search/pulse_rows.hpp"

#include <stdexcept>
#include <utility>

#include "core/task/worker_pool.hpp"
#include "radar/path/path.hpp"
#include "signal/search/cfar_calibration.hpp"
#include "simulate/plan/row_space.hpp"
#include "simulate/run/computed_rows.hpp"
#include "simulate/survey/derived.hpp"

namespace sarsim::workflow {

namespace {

double noise_of(const simulate::Acquisition& acquisition, const signal::CompressionFilter& filter) {
  double energy = 0.0;
  for (const std::complex<double>& tap : filter.taps) energy += std::norm(tap);
  return 2.0 * acquisition.reception.noise_stddev_v * acquisition.reception.noise_stddev_v * energy;
}

PulseRows compressed_rows(const std::shared_ptr<const simulate::Acquisition>& acquisition,
                          core::SampleRows<double> recorded) {
  if (!acquisition->reception.compressor) throw std::invalid_argument("pulses: the recording is not compressed");
  PulseRows rows;
  rows.rows = acquisition->timing.rows;
  rows.columns = acquisition->reception.columns;
  rows.range_m = acquisition->reception.column_range_m;
  const bool keeps_peak = acquisition->scene->conventions.compression == simulate::Conventions::Compression::keeps_peak;
  rows.peak_gain = keeps_peak ? 1.0 : simulate::processing_gain(*acquisition);
  rows.noise_w = noise_of(*acquisition, acquisition->reception.compressor->filter());
  rows.noise_correlation = signal::noise_correlation(acquisition->reception.compressor->filter().taps);
  const auto pool =
      std::make_shared<core::WorkerPool<simulate::RowSpace>>([] { return std::make_unique<simulate::RowSpace>(); });
  rows.copy = [pool, recorded = std::move(recorded)](std::size_t pulse, std::span<std::complex<float>> out) {
    pool->lend([&](simulate::RowSpace& space) {
      space.raw.resize(recorded.columns);
      recorded.read(pulse, space.raw);
      simulate::to_float(space.raw, out);
    });
  };
  rows.acquisition = acquisition;
  return rows;
}

PulseRows rows_of_raw_recording(const std::shared_ptr<const simulate::Acquisition>& acquisition,
                                core::SampleRows<double> recorded) {
  PulseRows rows;
  rows.rows = acquisition->timing.rows;
  rows.columns = acquisition->reception.columns;
  const auto compressor = simulate::compressor_of(*acquisition, acquisition->link.window,
                                                  acquisition->reception.columns, acquisition->reception.columns);
  // The filter gives an echo the place of its beginning: that of a centred pulse lies half a pulse before its range.
  const double c = acquisition->light_speed_mps();
  for (std::size_t i = 0; i < acquisition->reception.columns; ++i)
    rows.range_m.push_back(
        radar::range_of(acquisition->reception.raw_grid.time_s(i) + acquisition->reception.pulse.lead_s, c));
  rows.noise_w = noise_of(*acquisition, compressor->filter());
  rows.noise_correlation = signal::noise_correlation(compressor->filter().taps);
  const auto pool =
      std::make_shared<core::WorkerPool<simulate::RowSpace>>([] { return std::make_unique<simulate::RowSpace>(); });
  rows.copy = [acquisition, compressor, pool, recorded = std::move(recorded)](std::size_t pulse,
                                                                              std::span<std::complex<float>> out) {
    pool->lend([&](simulate::RowSpace& space) {
      space.raw.resize(acquisition->reception.columns);
      recorded.read(pulse, space.raw);
      space.compress(*compressor, out);
    });
  };
  rows.acquisition = acquisition;
  return rows;
}

}  // namespace

scene::Simulation compressed_simulation(const scene::Simulation& simulation) {
  scene::Simulation compressed = simulation;
  compressed.processing = scene::Processing::matched_filter;
  return compressed;
}

PulseRows pulse_rows_of_scene(const std::shared_ptr<const simulate::Acquisition>& acquisition) {
  return compressed_rows(acquisition, simulate::computed_rows(acquisition));
}

PulseRows pulse_rows_of_recording(const std::shared_ptr<const simulate::Acquisition>& acquisition,
                                  core::SampleRows<double> recorded) {
  if (acquisition->reception.is_profile()) throw std::invalid_argument("pulses: synthetic range profiles have none");
  return acquisition->reception.is_raw() ? rows_of_raw_recording(acquisition, std::move(recorded))
                                         : compressed_rows(acquisition, std::move(recorded));
}

}  // namespace sarsim::workflow
