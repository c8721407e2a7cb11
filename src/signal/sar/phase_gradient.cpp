#include "signal/sar/phase_gradient.hpp"

#include <algorithm>
#include <cmath>

#include "core/maths/constants.hpp"
#include "core/maths/fft.hpp"
#include "core/report/expect.hpp"

namespace sarsim::signal {

namespace {

constexpr std::size_t grain = 16;  // columns of a partial sum

// Sums over columns that do not depend on how many threads share them: one for every `grain` columns, added in order.
template <class Value, class AddColumn>
std::vector<Value> sum_over_columns(const AzimuthColumns& columns, const core::WorkControl& control,
                                    const AddColumn& add) {
  const std::size_t size = columns.size();
  std::vector<std::vector<Value>> parts((columns.count() + grain - 1) / grain);
  core::parallel_ranges(columns.count(), grain, control, [&](std::size_t begin, std::size_t end) {
    std::vector<Value>& part = parts[begin / grain];
    part.resize(size);
    std::vector<std::complex<double>> scratch(size);
    for (std::size_t i = begin; i < end; ++i) add(i, part, scratch);
  });
  std::vector<Value> sum(size);
  for (const auto& part : parts)
    for (std::size_t k = 0; k < size; ++k) sum[k] += part[k];
  return sum;
}

// The frequencies that the spectrum fills: `count` of them from `first` on, in a circle.
struct Support {
  long first = 0;
  std::size_t count = 0;
};

std::size_t wrapped(long k, long size) { return static_cast<std::size_t>((k % size + size) % size); }

// The power that only a few frequencies of the smoothed spectrum exceed, be the aperture all of it or a small part.
double strong_level(const std::vector<double>& power, long reach) {
  const auto size = static_cast<long>(power.size());
  std::vector<double> smooth;
  for (long k = 0; k < size; ++k) {
    double sum = 0.0;
    for (long j = k - reach; j <= k + reach; ++j) sum += power[wrapped(j, size)];
    smooth.push_back(sum / static_cast<double>(2 * reach + 1));
  }
  std::ranges::sort(smooth);
  return smooth[static_cast<std::size_t>(97 * (size - 1) / 100)];
}

Support support_of(const std::vector<double>& power, const SpectrumBand& band, double share) {
  const auto size = static_cast<long>(power.size());
  // Gaps of a few weak frequencies do not split the aperture.
  const long reach = size / 64;
  const double level = share * strong_level(power, reach);
  const auto is_in_band = [&](long k) {
    const double from_centre = static_cast<double>(k) - band.centre;
    const auto full = static_cast<double>(size);
    return band.width <= 0.0 || std::abs(from_centre - full * std::round(from_centre / full)) <= 0.5 * band.width;
  };
  const auto is_strong = [&](long k) { return is_in_band(k) && power[wrapped(k, size)] > level; };
  const auto is_full = [&](long k) {
    bool before = is_strong(k);
    bool after = before;
    for (long j = 1; j <= reach && !(before && after); ++j) {
      before = before || is_strong(k - j);
      after = after || is_strong(k + j);
    }
    return before && after;
  };
  // The longest empty run is what lies outside.
  long longest = 0, longest_end = 0, run = 0;
  for (long k = 0; k < 2 * size; ++k) {
    run = is_full(k % size) ? 0 : std::min(run + 1, size);
    if (run > longest) {
      longest = run;
      longest_end = k + 1;
    }
  }
  if (longest >= size) return {};
  const long centre = std::lround(band.centre);
  if (longest == 0) return {centre - size / 2, power.size()};
  long first = longest_end % size;
  const long count = size - longest;
  // The middle within half the sampling rate of the band's.
  while (2 * (first - centre) + count > size) first -= size;
  while (2 * (first - centre) + count <= -size) first += size;
  return {first, static_cast<std::size_t>(count)};
}

// Takes out what lies beyond the aperture.
void keep(AzimuthColumns& columns, const Support& support, const core::Fft& fft, const core::WorkControl& control) {
  const auto size = static_cast<long>(columns.size());
  if (support.count == columns.size()) return;
  core::parallel_ranges(columns.count(), grain, control, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto column = columns.column(i);
      fft.forward(column);
      for (long k = 0; k < size; ++k) {
        const bool kept = wrapped(k - support.first, size) < support.count;
        column[static_cast<std::size_t>(k)] *= kept ? 1.0 / static_cast<double>(size) : 0.0;
      }
      fft.inverse(column);
    }
  });
}

std::size_t brightest(std::span<const std::complex<double>> column) {
  std::size_t top = 0;
  for (std::size_t i = 1; i < column.size(); ++i)
    if (std::norm(column[i]) > std::norm(column[top])) top = i;
  return top;
}

// Width about the middle within which the centred columns together stay above a tenth of their largest power.
std::size_t blur_width(const std::vector<double>& power) {
  const std::size_t size = power.size();
  double top = 0.0;
  for (const double p : power) top = std::max(top, p);
  std::size_t width = 1;
  for (std::size_t k = 0; k < size; ++k)
    if (power[k] > 0.1 * top) width = std::max(width, 2 * std::min(k, size - k) + 1);
  return width;
}

// The gradients' integral over the support, without its straight line.
std::vector<double> integral(const std::vector<std::complex<double>>& products, const Support& support) {
  const auto size = static_cast<long>(products.size());
  std::vector<double> phase(support.count);
  for (std::size_t i = 1; i < support.count; ++i) {
    const long k = support.first + static_cast<long>(i);
    phase[i] = phase[i - 1] + std::arg(products[wrapped(k, size)]);
  }
  remove_line(phase);
  return phase;
}

double root_mean_square(std::span<const double> values) {
  double sum = 0.0;
  for (const double v : values) sum += v * v;
  return values.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(values.size()));
}

}  // namespace

void remove_line(std::span<double> values) {
  const auto count = static_cast<double>(values.size());
  if (values.empty()) return;
  double mean = 0.0, moment = 0.0, spread = 0.0;
  for (const double v : values) mean += v / count;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double x = static_cast<double>(i) - 0.5 * (count - 1.0);
    moment += x * (values[i] - mean);
    spread += x * x;
  }
  const double slope = spread > 0.0 ? moment / spread : 0.0;
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] -= mean + slope * (static_cast<double>(i) - 0.5 * (count - 1.0));
}

StraightLine best_line(std::span<const double> x, std::span<const double> y, std::span<const double> weights) {
  CORE_EXPECT(x.size() == y.size());
  CORE_EXPECT(x.size() == weights.size());
  double sum = 0.0, mean_x = 0.0, mean_y = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    sum += weights[i];
    mean_x += weights[i] * x[i];
    mean_y += weights[i] * y[i];
  }
  if (!(sum > 0.0)) return {};
  mean_x /= sum;
  mean_y /= sum;
  double spread = 0.0, moment = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    spread += weights[i] * (x[i] - mean_x) * (x[i] - mean_x);
    moment += weights[i] * (x[i] - mean_x) * (y[i] - mean_y);
  }
  const double slope = spread > 0.0 ? moment / spread : 0.0;
  return {mean_y - slope * mean_x, slope};
}

void turn_spectra(AzimuthColumns& columns, const core::WorkControl& control,
                  const std::function<double(std::size_t, long)>& phase_rad) {
  CORE_EXPECT(phase_rad);
  const std::size_t size = columns.size();
  const core::Fft fft(size);
  const auto half = static_cast<long>(size / 2);
  core::parallel_ranges(columns.count(), grain, control, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto column = columns.column(i);
      fft.forward(column);
      for (long k = -half; k < static_cast<long>(size) - half; ++k)
        column[static_cast<std::size_t>(k < 0 ? k + static_cast<long>(size) : k)] *=
            std::polar(1.0 / static_cast<double>(size), phase_rad(i, k));
      fft.inverse(column);
    }
  });
}

GradientResult phase_gradient(AzimuthColumns& columns, const SpectrumBand& band, const AutofocusOptions& options,
                              const core::WorkControl& control) {
  CORE_EXPECT(columns.count() > 0);
  CORE_EXPECT(columns.size() > 0);
  CORE_EXPECT(band.width >= 0.0);
  GradientResult result;
  const std::size_t size = columns.size();
  if (columns.count() == 0) return result;
  const core::Fft fft(size);
  const auto power = sum_over_columns<double>(columns, control, [&](std::size_t i, auto& sum, auto& scratch) {
    std::ranges::copy(columns.column(i), scratch.begin());
    fft.forward(scratch);
    for (std::size_t k = 0; k < size; ++k) sum[k] += std::norm(scratch[k]);
  });
  for (const double p : power) result.energy += p / static_cast<double>(size);
  const Support support = support_of(power, band, options.support_share);
  if (support.count < 3) return result;
  keep(columns, support, fft, control);
  result.first_frequency = support.first;
  result.phase_rad.resize(support.count);
  for (std::size_t i = 0; i < support.count; ++i)
    result.amplitude.push_back(
        std::sqrt(power[wrapped(support.first + static_cast<long>(i), static_cast<long>(size))]));

  std::size_t window = size;
  for (std::size_t round = 0; round < options.rounds; ++round) {
    std::vector<std::size_t> tops(columns.count());
    const auto centred = sum_over_columns<double>(columns, control, [&](std::size_t i, auto& sum, auto& /*scratch*/) {
      const auto column = columns.column(i);
      tops[i] = brightest(column);
      for (std::size_t k = 0; k < size; ++k) sum[k] += std::norm(column[(k + tops[i]) % size]);
    });
    // Twice as wide as the blur to begin with, then narrower from round to round: what lies beyond is other points,
    // whose echoes would be taken for fast changes of phase that no later, narrower round could see.
    const std::size_t least = std::min(options.min_window, size);
    window = std::max(round == 0 ? std::min(2 * blur_width(centred), size) : 6 * window / 10, least);
    const auto products =
        sum_over_columns<std::complex<double>>(columns, control, [&](std::size_t i, auto& sum, auto& scratch) {
          const auto column = columns.column(i);
          for (std::size_t k = 0; k < size; ++k)
            scratch[k] = 2 * std::min(k, size - k) <= window ? column[(k + tops[i]) % size] : 0.0;
          fft.forward(scratch);
          for (std::size_t k = 0; k < size; ++k) sum[k] += scratch[k] * std::conj(scratch[(k + size - 1) % size]);
        });
    const std::vector<double> phase = integral(products, support);
    turn_spectra(columns, control, [&](std::size_t, long frequency) {
      const std::size_t at = wrapped(frequency - support.first, static_cast<long>(size));
      return at < support.count ? -phase[at] : 0.0;
    });
    for (std::size_t i = 0; i < phase.size(); ++i) result.phase_rad[i] += phase[i];
    result.round_rad.push_back(root_mean_square(phase));
    if (window == least && result.round_rad.back() < options.enough_rad) break;
  }
  return result;
}

}  // namespace sarsim::signal
