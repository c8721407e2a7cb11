#include "picture/echo/radar_views.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/maths/constants.hpp"
#include "core/maths/fft.hpp"
#include "core/maths/rounding.hpp"
#include "core/maths/window.hpp"
#include "radar/path/path.hpp"

namespace sarsim::picture {

namespace {

// Weights of `count` samples; symmetric.
std::vector<double> weights(SpectrumWindow window, std::size_t count) {
  std::vector<double> w(count, 1.0);
  if (window == SpectrumWindow::rectangular || count < 2) return w;
  for (std::size_t i = 0; i < count; ++i) {
    // Half a sample from either end, so that no sample is lost to a weight of 0.
    const double x = (static_cast<double>(i) + 0.5) / static_cast<double>(count);
    w[i] = window == SpectrumWindow::hann ? core::hanning_window(x, 0.0) : core::hamming_window(x);
  }
  return w;
}

// Bin of a transform of `size` that stands at place `i` of an axis that ascends from the most negative frequency.
std::size_t bin_at(std::size_t i, std::size_t size) { return (i + size - size / 2) % size; }

// Its frequency in units of the bins' spacing.
double cycles_at(std::size_t i, std::size_t size) { return static_cast<double>(i) - static_cast<double>(size / 2); }

double mean_interval_s(const EchoBlock& block) {
  return block.rows < 2 ? 0.0 : (block.time_s.back() - block.time_s.front()) / static_cast<double>(block.rows - 1);
}

std::string remark_on(const EchoBlock& block, double interval_s) {
  constexpr double tolerance = 1e-6;
  for (std::size_t r = 1; r < block.rows; ++r) {
    if (block.carrier_hz[r] != block.carrier_hz[0]) return "the carrier changes from pulse to pulse";
    if (std::abs(block.time_s[r] - block.time_s[r - 1] - interval_s) > tolerance * interval_s)
      return "the pulses are not evenly spaced";
  }
  return {};
}

void add_moments(DopplerTime& history) {
  const std::size_t times = history.time_s.size();
  for (std::size_t t = 0; t < times; ++t) {
    double power = 0.0;
    double first = 0.0;
    double second = 0.0;
    for (std::size_t d = 0; d < history.doppler_hz.size(); ++d) {
      const double p = std::norm(history.samples[d * times + t]);
      const double f = history.doppler_hz[d];
      power += p;
      first += p * f;
      second += p * f * f;
    }
    const double mean = power > 0.0 ? first / power : 0.0;
    history.mean_hz.push_back(mean);
    history.width_hz.push_back(power > 0.0 ? std::sqrt(std::max(0.0, second / power - mean * mean)) : 0.0);
  }
}

}  // namespace

EchoBlock echo_block(const simulate::Plan& plan, simulate::IndexSpan rows, const core::WorkControl& control) {
  return echo_block(plan, rows, {0, plan.acquisition.reception.columns}, control);
}

EchoBlock echo_block(const simulate::Plan& plan, simulate::IndexSpan rows, simulate::IndexSpan columns,
                     const core::WorkControl& control) {
  const simulate::Acquisition& acquisition = plan.acquisition;
  EchoBlock block;
  const std::size_t end = std::min(rows.end, acquisition.timing.rows);
  const std::size_t begin = std::min(rows.begin, end);
  block.rows = end - begin;
  const std::size_t last_column = std::min(columns.end, acquisition.reception.columns);
  const std::size_t first_column = std::min(columns.begin, last_column);
  block.columns = last_column - first_column;
  block.range_m.assign(acquisition.reception.column_range_m.begin() + static_cast<std::ptrdiff_t>(first_column),
                       acquisition.reception.column_range_m.begin() + static_cast<std::ptrdiff_t>(last_column));
  block.sample_rate_hz = 1.0 / acquisition.reception.raw_grid.interval_s;
  block.light_speed_mps = acquisition.light_speed_mps();
  simulate::SampleSelection selection;
  for (std::size_t r = begin; r < end; ++r) {
    selection.rows.push_back({r, r + 1});
    const std::int64_t pulse = acquisition.timing.first_pulse_of_row(r);
    block.time_s.push_back(acquisition.link.repetition.send_time_s(pulse));
    block.carrier_hz.push_back(acquisition.link.carrier.carrier_hz(pulse));
  }
  for (std::size_t c = first_column; c < last_column; ++c) selection.columns.push_back({c, c + 1});
  block.samples.resize(block.rows * block.columns);
  std::vector<std::size_t> order(block.rows);
  std::iota(order.begin(), order.end(), std::size_t{0});
  simulate::compute_sampled_rows(plan, selection, order, control, block.samples, {});
  return block;
}

RangeProfile range_profile(const EchoBlock& block, ProfileMean mean) {
  RangeProfile profile{block.range_m, std::vector<double>(block.columns)};
  const auto count = static_cast<double>(std::max<std::size_t>(block.rows, 1));
  for (std::size_t c = 0; c < block.columns; ++c) {
    std::complex<double> sum;
    double power = 0.0;
    for (std::size_t r = 0; r < block.rows; ++r) {
      sum += block.at(r, c);
      power += std::norm(block.at(r, c));
    }
    profile.magnitude_v[c] = mean == ProfileMean::coherent ? std::abs(sum) / count : std::sqrt(power / count);
  }
  return profile;
}

RangeDoppler range_doppler(const EchoBlock& block, SpectrumWindow window, std::size_t bins) {
  RangeDoppler map;
  map.range_m = block.range_m;
  if (block.rows == 0) return map;
  const double interval_s = mean_interval_s(block);
  map.remark = remark_on(block, interval_s);
  const std::size_t size = core::good_fft_size(std::max(bins, block.rows));
  const std::vector<double> w = weights(window, block.rows);
  const double scale = 1.0 / std::accumulate(w.begin(), w.end(), 0.0);
  const double rate_hz = interval_s > 0.0 ? 1.0 / interval_s : 0.0;
  for (std::size_t i = 0; i < size; ++i) {
    map.doppler_hz.push_back(cycles_at(i, size) / static_cast<double>(size) * rate_hz);
    map.speed_mps.push_back(radar::speed_of(map.doppler_hz.back(), block.carrier_hz[0], block.light_speed_mps));
  }
  map.samples.resize(size * block.columns);
  const core::Fft fft(size);
  std::vector<std::complex<double>> line(size);
  for (std::size_t c = 0; c < block.columns; ++c) {
    std::ranges::fill(line, std::complex<double>());
    for (std::size_t r = 0; r < block.rows; ++r) line[r] = scale * w[r] * block.at(r, c);
    fft.forward(line);
    for (std::size_t i = 0; i < size; ++i) map.samples[i * block.columns + c] = line[bin_at(i, size)];
  }
  return map;
}

DopplerTime doppler_time(const EchoBlock& block, std::size_t column, SpectrumWindow window, std::size_t interval,
                         std::size_t padding) {
  constexpr std::size_t max_intervals = 2000;
  DopplerTime history;
  if (block.rows == 0) return history;
  EchoBlock intervals = block;  // Each is a column of its own.
  intervals.rows = std::clamp<std::size_t>(interval, 1, block.rows);
  const std::size_t beginnings = block.rows - intervals.rows + 1;
  const std::size_t step = std::max({std::size_t{1}, intervals.rows / 8, (beginnings - 1) / max_intervals + 1});
  intervals.columns = (beginnings - 1) / step + 1;
  intervals.samples.resize(intervals.rows * intervals.columns);
  for (std::size_t i = 0; i < intervals.columns; ++i) {
    for (std::size_t r = 0; r < intervals.rows; ++r)
      intervals.samples[r * intervals.columns + i] = block.at(i * step + r, column);
    history.time_s.push_back(core::tidy(0.5 * (block.time_s[i * step] + block.time_s[i * step + intervals.rows - 1])));
  }
  RangeDoppler map = range_doppler(intervals, window, intervals.rows * padding);
  // The frequencies are those of the mean interval of all pulses, as the remark is.
  const double interval_s = mean_interval_s(block);
  const std::size_t size = map.doppler_hz.size();
  for (std::size_t i = 0; i < size; ++i)
    history.doppler_hz.push_back(interval_s > 0.0 ? cycles_at(i, size) / static_cast<double>(size) / interval_s : 0.0);
  history.samples = std::move(map.samples);
  add_moments(history);
  history.remark = remark_on(block, interval_s);
  return history;
}

PowerSpectrum power_spectrum(const EchoBlock& block, std::size_t row, SpectrumWindow window) {
  PowerSpectrum spectrum;
  const std::size_t size = block.columns;
  if (size == 0) return spectrum;
  const std::vector<double> w = weights(window, size);
  const double energy = std::inner_product(w.begin(), w.end(), w.begin(), 0.0);
  std::vector<std::complex<double>> line(size);
  for (std::size_t c = 0; c < size; ++c) line[c] = w[c] * block.at(row, c);
  const core::Fft fft(size);
  fft.forward(line);
  for (std::size_t i = 0; i < size; ++i) {
    spectrum.frequency_hz.push_back(cycles_at(i, size) / static_cast<double>(size) * block.sample_rate_hz);
    spectrum.density_w_per_hz.push_back(std::norm(line[bin_at(i, size)]) / (energy * block.sample_rate_hz));
  }
  return spectrum;
}

PhaseHistory phase_history(const EchoBlock& block, std::size_t column) {
  PhaseHistory history;
  history.time_s = block.time_s;
  double turns = 0.0;
  for (std::size_t r = 0; r < block.rows; ++r) {
    const double phase = std::arg(block.at(r, column));
    if (r > 0) turns -= std::round((phase - history.phase_rad.back()) / (2.0 * core::pi));
    history.phase_rad.push_back(phase);
    history.unwrapped_rad.push_back(phase + 2.0 * core::pi * turns);
    history.path_m.push_back(
        -radar::range_of_phase(history.unwrapped_rad.back(), block.carrier_hz[r], block.light_speed_mps));
  }
  return history;
}

}  // namespace sarsim::picture
