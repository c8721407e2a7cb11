#include "workflow/exchange/phase_history.hpp"

#include <algorithm>
#include <cmath>

#include "core/maths/turns.hpp"
#include "core/report/expect.hpp"
#include "radar/waveform/pulse.hpp"

namespace sarsim::workflow {

namespace {

// Room beside an echo for its stretch and the rounding of its place.
constexpr std::int64_t spare_samples = 3;

// Tolerance of the kernel for which it computes in double precision.
constexpr double exactly = 1e-12;

double band_of(const simulate::Acquisition& acquisition) {
  return std::abs(radar::bandwidth_hz(acquisition.link.pulse));
}

// The samples of an echo before the one at its delay, and all of them.
std::int64_t samples_before(const simulate::Acquisition& acquisition) {
  return static_cast<std::int64_t>(
             std::ceil(-acquisition.reception.pulse.first_s() / acquisition.reception.raw_grid.interval_s)) +
         spare_samples;
}
std::int64_t samples_of_echo(const simulate::Acquisition& acquisition) {
  return samples_before(acquisition) +
         static_cast<std::int64_t>(
             std::ceil(acquisition.reception.pulse.last_s() / acquisition.reception.raw_grid.interval_s)) +
         spare_samples;
}

radar::SampleGrid grid_of_reference(const simulate::Acquisition& acquisition) {
  const double interval_s = acquisition.reception.raw_grid.interval_s;
  return {-static_cast<double>(samples_before(acquisition)) * interval_s, interval_s,
          static_cast<std::size_t>(samples_of_echo(acquisition))};
}

CollectionExtent joined(const CollectionExtent& a, const CollectionExtent& b) {
  return {std::min(a.first_tx_s, b.first_tx_s),         std::max(a.last_tx_s, b.last_tx_s),
          std::min(a.min_delay_s, b.min_delay_s),       std::max(a.max_delay_s, b.max_delay_s),
          std::min(a.min_carrier_hz, b.min_carrier_hz), std::max(a.max_carrier_hz, b.max_carrier_hz)};
}

}  // namespace

DelaySpan whole_echoes(const simulate::Acquisition& acquisition) {
  const radar::SampleGrid& grid = acquisition.reception.raw_grid;
  const double first_s = grid.time_s(0) + acquisition.reception.pulse.lead_s;
  return {first_s, grid.time_s(grid.count) + acquisition.reception.pulse.lead_s - acquisition.link.pulse.width_s};
}

FrequencyGrid frequency_grid(const simulate::Acquisition& acquisition) {
  constexpr double spare_swath = 1.2;
  constexpr double rounding = 1e-9;
  const double rate_hz = 1.0 / acquisition.reception.raw_grid.interval_s;
  const DelaySpan whole = whole_echoes(acquisition);
  const double swath = spare_swath * (whole.last_s - whole.first_s) * rate_hz;
  FrequencyGrid grid;
  grid.transform = core::good_fft_size(
      std::max(acquisition.reception.columns + static_cast<std::size_t>(samples_of_echo(acquisition)),
               static_cast<std::size_t>(std::ceil(std::max(swath, 0.0))) + 1));
  grid.step_hz = rate_hz / static_cast<double>(grid.transform);
  const auto half = static_cast<std::int64_t>(
      std::floor(std::min(0.5 * band_of(acquisition), 0.5 * rate_hz) / grid.step_hz * (1.0 + rounding)));
  grid.first_bin = -std::min(half, static_cast<std::int64_t>((grid.transform - 1) / 2));
  grid.samples = static_cast<std::size_t>(1 - 2 * grid.first_bin);
  return grid;
}

CollectionExtent extent_of(const Collection& collection, const core::WorkControl& control) {
  constexpr std::size_t together = 4096;
  const std::size_t rows = collection.acquisition->timing.rows;
  std::vector<CollectionExtent> parts((rows + together - 1) / together);
  core::parallel_ranges(rows, together, control, [&](std::size_t begin, std::size_t end) {
    CollectionGeometry geometry(collection);
    CollectionExtent& part = parts[begin / together];
    for (std::size_t row = begin; row < end; ++row) {
      const CollectedPulse pulse = geometry.pulse_of(row);
      const double tx_s = pulse.vector.tx_time_s;
      const CollectionExtent one{tx_s, tx_s, pulse.delay_s, pulse.delay_s, pulse.carrier_hz, pulse.carrier_hz};
      part = row == begin ? one : joined(part, one);
    }
  });
  CollectionExtent all = parts.front();
  for (const CollectionExtent& part : parts) all = joined(all, part);
  return all;
}

HistoryShape history_shape(const Collection& collection, const CollectionExtent& extent) {
  const DelaySpan whole = whole_echoes(*collection.acquisition);
  return {frequency_grid(*collection.acquisition), whole.first_s - extent.min_delay_s,
          whole.last_s - extent.max_delay_s};
}

PhaseHistory::PhaseHistory(const Collection& collection, const HistoryShape& shape)
    : collection_(&collection),
      shape_(shape),
      grid_(shape.grid),
      geometry_(collection),
      fft_(grid_.transform),
      before_(samples_before(*collection.acquisition)),
      reference_grid_(grid_of_reference(*collection.acquisition)),
      kernel_(collection.acquisition->reception.pulse, reference_grid_, exactly),
      echo_row_(reference_grid_.count),
      reference_(grid_.transform),
      row_(grid_.transform) {
  CORE_EXPECT(grid_.transform >= reference_grid_.count);
  CORE_EXPECT(grid_.transform >= collection.acquisition->reception.columns);
}

raster::PhaseVector PhaseHistory::with_band(const CollectedPulse& pulse) const {
  raster::PhaseVector v = pulse.vector;
  v.first = pulse.carrier_hz + static_cast<double>(grid_.first_bin) * grid_.step_hz;
  v.step = grid_.step_hz;
  v.fx1_hz = v.first;
  v.fx2_hz = v.first + static_cast<double>(grid_.samples - 1) * v.step;
  v.toa1_s = shape_.toa1_s;
  v.toa2_s = shape_.toa2_s;
  return v;
}

raster::PhaseVector PhaseHistory::vector_of(std::size_t row) { return with_band(geometry_.pulse_of(row)); }

std::size_t PhaseHistory::bin_of(std::size_t sample) const {
  const std::int64_t bin = grid_.first_bin + static_cast<std::int64_t>(sample);
  return static_cast<std::size_t>(bin < 0 ? bin + static_cast<std::int64_t>(grid_.transform) : bin);
}

// The echo is computed with what its delay is beyond a whole number of samples, and put at its place, around the end of
// the transform.
void PhaseHistory::transform_reference(const CollectedPulse& pulse) {
  const radar::SampleGrid& grid = collection_->acquisition->reception.raw_grid;
  const double place = (pulse.delay_s - grid.first_s) / grid.interval_s;
  const double whole = std::floor(place);
  const double rest_s = (place - whole) * grid.interval_s;
  echo_.clear();
  if (pulse.clock.dilation_rate != 0.0)
    echo_.add(rest_s, 1.0, pulse.clock);
  else
    echo_.add(rest_s, 1.0, pulse.clock.doppler);
  std::ranges::fill(echo_row_, std::complex<double>());
  kernel_.add(echo_row_, pulse.carrier_hz, echo_);
  const std::complex<double> turn = core::turned_exactly(-pulse.carrier_hz * (pulse.delay_s - rest_s));
  std::ranges::fill(reference_, std::complex<double>());
  const auto length = static_cast<std::int64_t>(grid_.transform);
  const auto first = static_cast<std::int64_t>(std::fmod(whole, static_cast<double>(length))) - before_;
  for (std::size_t i = 0; i < echo_row_.size(); ++i) {
    const std::int64_t at = (first + static_cast<std::int64_t>(i)) % length;
    reference_[static_cast<std::size_t>(at < 0 ? at + length : at)] += turn * echo_row_[i];
  }
  fft_.forward(reference_);
}

raster::PhaseVector PhaseHistory::make(std::size_t row, std::span<std::complex<double>> samples) {
  CORE_EXPECT(samples.size() == grid_.samples);
  const CollectedPulse pulse = geometry_.pulse_of(row);
  transform_reference(pulse);
  const std::size_t columns = collection_->rows.columns;
  collection_->rows.read(row, std::span(row_).first(columns));
  std::fill(row_.begin() + static_cast<std::ptrdiff_t>(columns), row_.end(), std::complex<double>());
  fft_.forward(row_);
  for (std::size_t k = 0; k < samples.size(); ++k) samples[k] = row_[bin_of(k)] / reference_[bin_of(k)];
  return with_band(pulse);
}

double PhaseHistory::weakest_share(std::size_t row) {
  transform_reference(geometry_.pulse_of(row));
  double least = INFINITY;
  double most = 0.0;
  for (std::size_t k = 0; k < grid_.samples; ++k) {
    const double magnitude = std::abs(reference_[bin_of(k)]);
    least = std::min(least, magnitude);
    most = std::max(most, magnitude);
  }
  return most > 0.0 ? least / most : 0.0;
}

}  // namespace sarsim::workflow
