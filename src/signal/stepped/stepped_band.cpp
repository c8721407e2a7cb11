#include "signal/stepped/stepped_band.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/maths/turns.hpp"
#include "core/report/expect.hpp"
#include "radar/path/path.hpp"

namespace sarsim::signal {

namespace {

// Cells with less than this share of the strongest cell's spectrum are taken for empty: they hold little but noise.
constexpr double min_share = 0.02;

std::size_t transform_size(const SteppedWaveform& w) {
  return w.subband_hz > 0.0 ? core::good_fft_size(w.samples + std::max(w.response.size(), w.filter.size())) : 1;
}

void expect_sound(const SteppedWaveform& w) {
  const auto expect = [](bool right, const char* what) {
    if (!right) throw std::invalid_argument(what);
  };
  expect(w.steps > 0 && w.pulses_per_step > 0, "stepped frequency: a burst has no pulses");
  expect(w.samples > 0 && w.sample_rate_hz > 0.0, "stepped frequency: a row has no samples");
  expect(w.light_speed_mps > 0.0 && w.first_carrier_hz > 0.0, "stepped frequency: no carrier or no speed of light");
  expect(w.order.empty() || w.order.size() == w.steps, "stepped frequency: the order is not one of all steps");
  expect(w.steps == 1 || w.carrier_step_hz != 0.0, "stepped frequency: the carrier does not step");
  expect(w.subband_hz > 0.0 || w.steps > 1, "stepped frequency: one frequency makes no profile");
  expect(w.subband_hz <= 0.0 || w.response_zero < w.response.size(),
         "stepped frequency: the compressed pulse is missing");
}

}  // namespace

SteppedBand::SteppedBand(SteppedWaveform waveform)
    : waveform_((expect_sound(waveform), std::move(waveform))),
      fft_(std::make_shared<const core::Fft>(transform_size(waveform_))) {
  if (waveform_.subband_hz > 0.0)
    lay_out_subbands();
  else
    lay_out_samples();
}

void SteppedBand::lay_out_samples() {
  gates_ = waveform_.samples;
  cells_ = waveform_.steps;
  cell_hz_ = std::abs(waveform_.carrier_step_hz);
  const bool up = waveform_.carrier_step_hz > 0.0;
  first_hz_ = up ? waveform_.first_carrier_hz : waveform_.carrier_hz(cells_ - 1);
  for (std::size_t n = 0; n < cells_; ++n) first_cell_.push_back(up ? n : cells_ - 1 - n);
}

void SteppedBand::lay_out_subbands() {
  const SteppedWaveform& w = waveform_;
  cell_hz_ = w.sample_rate_hz / static_cast<double>(fft_->size());
  const double last_hz = w.carrier_hz(w.steps - 1);
  const double width_hz = std::min(w.subband_hz, w.sample_rate_hz);
  first_hz_ = std::min(w.first_carrier_hz, last_hz) - 0.5 * width_hz;
  cells_ = static_cast<std::size_t>((std::abs(last_hz - w.first_carrier_hz) + width_hz) / cell_hz_) + 1;
  pulse_cells_ = static_cast<std::size_t>(width_hz / cell_hz_);
  if (pulse_cells_ == 0) throw std::invalid_argument("stepped frequency: a row is too short for its sub-band");
  share_.resize(cells_);
  std::vector<std::complex<double>> x(pulse_cells_);
  const double zero_s = static_cast<double>(w.response_zero) / w.sample_rate_hz;
  for (std::size_t n = 0; n < w.steps; ++n) {
    const double lowest = (w.carrier_hz(n) - 0.5 * width_hz - first_hz_) / cell_hz_;
    first_cell_.push_back(
        std::min(static_cast<std::size_t>(std::max(0.0, std::ceil(lowest - 1e-9))), cells_ - pulse_cells_));
    transform(w.response, -zero_s, frequency_hz(first_cell_.back()) - w.carrier_hz(n), x);
    for (std::size_t k = 0; k < pulse_cells_; ++k) share_[first_cell_.back() + k] += x[k];
    add_filter(frequency_hz(first_cell_.back()) - w.carrier_hz(n));
  }
  double largest = 0.0;
  for (const auto& s : share_) largest = std::max(largest, std::abs(s));
  for (auto& s : share_) s = std::abs(s) > min_share * largest ? 1.0 / s : std::complex<double>();
}

// Correlating with the filter multiplies a spectrum by sum over k of filter[k] exp(+2 pi j f k/fs).
void SteppedBand::add_filter(double first_hz) {
  if (waveform_.filter.empty()) return;
  std::vector<std::complex<double>> mirrored(waveform_.filter);
  for (auto& tap : mirrored) tap = std::conj(tap);
  std::vector<std::complex<double>> spectrum(pulse_cells_);
  transform(mirrored, 0.0, first_hz, spectrum);
  for (const auto& value : spectrum) filter_.push_back(std::conj(value));
}

double SteppedBand::gap_share() const {
  std::size_t empty = 0;
  for (std::size_t k = 0; k < cells_; ++k)
    if (!filled(k)) ++empty;
  return static_cast<double>(empty) / static_cast<double>(cells_);
}

std::size_t SteppedBand::gate_of(double delay_s) const {
  const SteppedWaveform& w = waveform_;
  const double first = (delay_s - w.first_sample_s) * w.sample_rate_hz;
  const auto last_sample = static_cast<double>(w.samples) - 1.0;
  if (w.subband_hz > 0.0) {
    // Of a raw echo half must be recorded, of a compressed one its peak.
    const double half = w.filter.empty() ? 0.0 : 0.5 * w.pulse_width_s * w.sample_rate_hz;
    constexpr double rounding = 1e-6;
    return first >= -half - rounding && first <= last_sample - half + rounding ? 0 : gates_;
  }
  const double from = std::max(0.0, std::ceil(first + w.seen_from_s * w.sample_rate_hz - 1e-6));
  const double to = std::min(last_sample, std::ceil(first + w.seen_to_s * w.sample_rate_hz - 1e-6) - 1.0);
  if (from > to) return gates_;
  const double middle = first + 0.5 * (w.seen_from_s + w.seen_to_s) * w.sample_rate_hz;
  return static_cast<std::size_t>(std::clamp(std::floor(middle + 0.5), from, to));
}

SeenDelays SteppedBand::seen_delays() const {
  const SteppedWaveform& w = waveform_;
  const double last_sample_s = w.first_sample_s + (static_cast<double>(w.samples) - 1.0) / w.sample_rate_hz;
  if (w.subband_hz <= 0.0) return {w.first_sample_s - w.seen_to_s, last_sample_s - w.seen_from_s};
  const double half_s = w.filter.empty() ? 0.0 : 0.5 * w.pulse_width_s;
  return {w.first_sample_s - half_s, last_sample_s - half_s};
}

// out[k] = sum over i of row[i] exp(-2 pi j f t), f = first_hz + k cell_hz, t = first_s + i/fs.
void SteppedBand::transform(std::span<const std::complex<double>> row, double first_s, double first_hz,
                            std::span<std::complex<double>> out) const {
  std::vector<std::complex<double>> work(fft_->size());
  for (std::size_t i = 0; i < row.size(); ++i)
    work[i] = row[i] * core::turned_exactly(-first_hz * static_cast<double>(i) / waveform_.sample_rate_hz);
  fft_->forward(work);
  for (std::size_t k = 0; k < out.size(); ++k)
    out[k] = work[k] * core::turned_exactly(-(first_hz + static_cast<double>(k) * cell_hz_) * first_s);
}

void SteppedBand::place(std::size_t pulse, std::span<const std::complex<double>> row,
                        std::span<std::complex<double>> out) const {
  CORE_EXPECT(pulse < waveform_.burst_pulses());
  CORE_EXPECT(row.size() == waveform_.samples);
  CORE_EXPECT(out.size() == values_per_pulse());
  if (waveform_.subband_hz <= 0.0) {
    std::ranges::copy(row, out.begin());
    return;
  }
  const std::size_t step = step_of(pulse);
  transform(row, waveform_.first_sample_s, frequency_hz(first_cell_[step]) - waveform_.carrier_hz(step), out);
  if (filter_.empty()) return;
  for (std::size_t k = 0; k < out.size(); ++k) out[k] *= filter_[step * pulse_cells_ + k];
}

std::complex<double> SteppedBand::weight(std::size_t cell) const {
  const auto pulses = static_cast<double>(waveform_.pulses_per_step);
  return share_.empty() ? 1.0 / pulses : share_[cell] / pulses;
}

void SteppedBand::join(std::span<const std::complex<double>> values, std::span<const PulseMotion> motion,
                       std::span<std::complex<double>> out) const {
  CORE_EXPECT(values.size() == values_per_burst());
  CORE_EXPECT(motion.empty() || motion.size() == waveform_.burst_pulses());
  CORE_EXPECT(out.size() == gates_ * cells_);
  const SteppedWaveform& w = waveform_;
  std::ranges::fill(out, std::complex<double>());
  for (std::size_t p = 0; p < w.burst_pulses(); ++p) {
    const double carrier_hz = w.carrier_hz(step_of(p));
    const std::size_t first = first_cell(p);
    const PulseMotion moved = motion.empty() ? PulseMotion{} : motion[p];
    const double doppler_hz = radar::doppler_of(moved.speed_mps, carrier_hz, w.light_speed_mps);
    const double early_s = w.sweep_rate_hz_per_s != 0.0 ? doppler_hz / w.sweep_rate_hz_per_s : 0.0;
    for (std::size_t k = 0; k < pulse_cells_; ++k) {
      const double hz = frequency_hz(first + k);
      const double turns = hz * moved.delay_s - (hz - carrier_hz) * early_s + 0.5 * doppler_hz * early_s;
      const std::complex<double> factor = weight(first + k) * core::turned_exactly(turns);
      for (std::size_t g = 0; g < gates_; ++g) {
        const std::complex<double> value = values[p * values_per_pulse() + g * pulse_cells_ + k];
        out[g * cells_ + first + k] += core::product(factor, value);
      }
    }
  }
}

}  // namespace sarsim::signal
