#include "signal/measure/response.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/maths/constants.hpp"
#include "core/maths/fft.hpp"
#include "core/report/expect.hpp"

namespace sarsim::signal {

namespace {

// One side of a response, from its peak outwards.
struct Side {
  double half_power = 0.0;  // distances in samples
  double null = 0.0;
  std::size_t null_index = 0;
};

double power_at(std::span<const std::complex<double>> response, std::ptrdiff_t index) {
  return std::norm(response[static_cast<std::size_t>(index)]);
}

// @param step  +1 or -1
std::optional<Side> side_of(std::span<const std::complex<double>> response, std::size_t peak, std::ptrdiff_t step) {
  const auto at = static_cast<std::ptrdiff_t>(peak);
  const auto size = static_cast<std::ptrdiff_t>(response.size());
  const double half = 0.5 * power_at(response, at);
  Side side;
  for (std::ptrdiff_t i = at; i + step >= 0 && i + step < size; i += step) {
    const double here = power_at(response, i);
    const double next = power_at(response, i + step);
    const auto distance = static_cast<double>(std::abs(i - at));
    if (side.half_power == 0.0 && next < half) side.half_power = distance + (here - half) / (here - next);
    if (side.half_power > 0.0 && next >= here) {
      side.null = distance;
      side.null_index = static_cast<std::size_t>(std::abs(i - at));
      return side;
    }
  }
  return std::nullopt;
}

double signed_index(std::size_t i, std::size_t size) {
  const auto index = static_cast<double>(i);
  return 2 * i < size ? index : index - static_cast<double>(size);
}

// Autocorrelation of a chirp with a rectangular envelope, at a delay in inverse bandwidths.
double compressed(double delay, double time_bandwidth) {
  const double fraction = std::abs(delay) / time_bandwidth;
  if (fraction >= 1.0) return 0.0;
  const double x = core::pi * delay * (1.0 - fraction);
  return (1.0 - fraction) * (x == 0.0 ? 1.0 : std::sin(x) / x);
}

// The spectrum of a chirp, of 1/per_lag inverse bandwidths between samples, times that of its weighted matched filter.
void set_weighted_chirp(std::vector<std::complex<double>>& spectrum, double time_bandwidth, double per_lag,
                        const std::function<double(double)>& filter) {
  std::vector<std::complex<double>> weighted(spectrum.size());
  const double samples = time_bandwidth * per_lag;
  for (std::size_t k = 0; k < spectrum.size() && static_cast<double>(k) < samples; ++k) {
    const double fraction = static_cast<double>(k) / samples;
    spectrum[k] = std::polar(1.0, core::pi * time_bandwidth * (fraction - 0.5) * (fraction - 0.5));
    weighted[k] = filter(fraction) * spectrum[k];
  }
  const core::Fft fft(spectrum.size());
  fft.forward(spectrum);
  fft.forward(weighted);
  for (std::size_t k = 0; k < spectrum.size(); ++k) spectrum[k] *= std::conj(weighted[k]);
}

// Each bin by the mean of the weights over it: half of one at a band's edge.
void weigh(std::vector<std::complex<double>>& spectrum, const SarWindow& window, double per_lag) {
  constexpr int parts = 8;
  const auto weight = weight_of(window);
  const double bin = per_lag / static_cast<double>(spectrum.size());
  for (std::size_t k = 0; k < spectrum.size(); ++k) {
    double sum = 0.0;
    for (int part = 0; part < parts; ++part)
      sum += weight((signed_index(k, spectrum.size()) + (part + 0.5) / parts - 0.5) * bin);
    spectrum[k] *= sum / parts;
  }
}

// Sets what lies beyond half of a share of the sampled band to 0.
void cut_band(std::vector<std::complex<double>>& spectrum, double share) {
  const double edge = 0.5 * share * static_cast<double>(spectrum.size());
  for (std::size_t k = 0; k < spectrum.size(); ++k)
    if (std::abs(signed_index(k, spectrum.size())) > edge) spectrum[k] = 0.0;
}

}  // namespace

std::optional<ResponseFigures> figures_of(std::span<const std::complex<double>> response, std::size_t peak) {
  CORE_EXPECT(peak < response.size());
  const auto left = side_of(response, peak, -1);
  const auto right = side_of(response, peak, +1);
  if (!left || !right) return std::nullopt;
  ResponseFigures figures;
  figures.width = left->half_power + right->half_power;
  figures.null = 0.5 * (left->null + right->null);
  const auto reach = static_cast<std::size_t>((1.0 + islr_null_widths) * figures.null);
  double inside = 0.0;
  double outside = 0.0;
  double highest = 0.0;
  const std::size_t first = peak - std::min(peak, reach);
  const std::size_t last = std::min(response.size() - 1, peak + reach);
  for (std::size_t i = first; i <= last; ++i) {
    const double power = std::norm(response[i]);
    const bool main = i + left->null_index >= peak && i <= peak + right->null_index;
    (main ? inside : outside) += power;
    if (!main) highest = std::max(highest, power);
  }
  figures.pslr_db = 10.0 * std::log10(highest / std::norm(response[peak]));
  figures.islr_db = 10.0 * std::log10(outside / inside);
  return figures;
}

SampledResponse theoretical_response(const SarWindow& window, double time_bandwidth, double sampling,
                                     const std::function<double(double)>& filter, BeyondSampling beyond) {
  CORE_EXPECT(time_bandwidth >= 0.0);
  CORE_EXPECT(sampling >= 0.0);
  // Memory must not grow with what a scene asks for; beyond these the figures change by less than 1e-4.
  constexpr double max_time_bandwidth = 32768.0;
  constexpr double max_sampling = 64.0;
  const bool chirp = time_bandwidth > 0.0;
  time_bandwidth = std::min(time_bandwidth, max_time_bandwidth);
  // Samples to the inverse bandwidth.
  double per_lag = chirp && sampling > 0.0 ? std::min(sampling, max_sampling) : 16.0;
  const double sampled_band = per_lag;
  const bool cut = beyond == BeyondSampling::lost && chirp && per_lag < 16.0;
  if (cut) per_lag = 16.0;
  const double lags = chirp ? std::max(2.0 * time_bandwidth, 256.0) : 4096.0;
  const std::size_t size = core::good_fft_size(static_cast<std::size_t>(lags * per_lag));
  std::vector<std::complex<double>> spectrum(size);
  if (chirp && filter) {
    set_weighted_chirp(spectrum, time_bandwidth, per_lag, filter);
  } else if (chirp) {
    for (std::size_t i = 0; i < size; ++i) spectrum[i] = compressed(signed_index(i, size) / per_lag, time_bandwidth);
    core::Fft(size).forward(spectrum);
  } else {
    std::ranges::fill(spectrum, 1.0);
  }
  if (!chirp || window.kind != SarWindow::Kind::rectangular) weigh(spectrum, window, per_lag);
  if (cut) cut_band(spectrum, sampled_band / per_lag);
  const std::size_t fine = static_cast<std::size_t>(std::ceil(64.0 / per_lag)) * size;
  SampledResponse response;
  response.values.resize(fine);
  // The chirp's correlation is 1 in the middle; that of sampled ones as many as the pulse has samples.
  const double scale = 1.0 / (static_cast<double>(size) * (chirp && filter ? time_bandwidth * per_lag : 1.0));
  for (std::size_t k = 0; k < size; ++k) response.values[2 * k < size ? k : fine - size + k] = scale * spectrum[k];
  core::Fft(fine).inverse(response.values);
  std::ranges::rotate(response.values, response.values.begin() + static_cast<std::ptrdiff_t>(fine - fine / 2));
  response.peak = fine / 2;
  response.per_lag = per_lag * static_cast<double>(fine / size);
  return response;
}

ResponseFigures theoretical_figures(const SarWindow& window, double time_bandwidth, double sampling,
                                    const std::function<double(double)>& filter) {
  const SampledResponse response =
      theoretical_response(window, time_bandwidth, sampling, filter, BeyondSampling::folded);
  ResponseFigures figures = figures_of(response.values, response.peak).value();
  figures.width /= response.per_lag;
  figures.null /= response.per_lag;
  return figures;
}

}  // namespace sarsim::signal
