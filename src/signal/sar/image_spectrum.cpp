#include "signal/sar/image_spectrum.hpp"

#include <algorithm>
#include <cmath>

#include "core/report/expect.hpp"
#include "radar/path/path.hpp"

namespace sarsim::signal {

namespace {

// Wave numbers that one direction fills evenly.
struct FilledBand {
  double least = 0.0;
  double most = 0.0;
  double weight = 0.0;
};

// The share of the weights below a wave number.
double weight_below(std::span<const FilledBand> bands, double per_m) {
  double sum = 0.0;
  for (const FilledBand& band : bands) {
    const double width = band.most - band.least;
    const double part = width > 0.0 ? std::clamp((per_m - band.least) / width, 0.0, 1.0) : per_m >= band.least;
    sum += band.weight * part;
  }
  return sum;
}

// Where that much of the weights lies below.
double quantile_of(std::span<const FilledBand> bands, double weight, double least, double most) {
  constexpr int halvings = 40;
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (least + most);
    (weight_below(bands, middle) < weight ? least : most) = middle;
  }
  return 0.5 * (least + most);
}

std::optional<SpectrumExtent> extent_of_bands(std::span<const FilledBand> bands, double beyond) {
  double all = 0.0;
  double least = INFINITY;
  double most = -INFINITY;
  for (const FilledBand& band : bands) {
    if (!(band.weight > 0.0)) continue;
    all += band.weight;
    least = std::min(least, band.least);
    most = std::max(most, band.most);
  }
  if (!(all > 0.0)) return std::nullopt;
  if (beyond == 0.0) return SpectrumExtent{least, most};
  return SpectrumExtent{quantile_of(bands, beyond * all, least, most),
                        quantile_of(bands, (1.0 - beyond) * all, least, most)};
}

FilledBand ordered(double a, double b, double weight) { return {std::min(a, b), std::max(a, b), weight}; }

SpectrumExtent joined_extent(const SpectrumExtent& a, const SpectrumExtent& b) {
  return {std::min(a.least_per_m, b.least_per_m), std::max(a.most_per_m, b.most_per_m)};
}

}  // namespace

std::optional<ImageSpectrum> spectrum_of(std::span<const SeenDirection> seen, const SarWaveform& waveform,
                                         double beyond) {
  CORE_EXPECT(beyond >= 0.0 && beyond < 0.5);
  CORE_EXPECT(waveform.light_speed_mps > 0.0);
  const double low =
      radar::turns_per_m(waveform.carrier_hz - 0.5 * std::abs(waveform.bandwidth_hz), waveform.light_speed_mps);
  const double high =
      radar::turns_per_m(waveform.carrier_hz + 0.5 * std::abs(waveform.bandwidth_hz), waveform.light_speed_mps);
  const double middle = radar::turns_per_m(waveform.carrier_hz, waveform.light_speed_mps);
  std::vector<FilledBand> azimuth;
  std::vector<FilledBand> range;
  for (const SeenDirection& direction : seen) {
    const double cosine = std::sqrt(std::max(0.0, 1.0 - direction.sine * direction.sine));
    azimuth.push_back(ordered(low * direction.sine, high * direction.sine, direction.weight));
    range.push_back(ordered(low * cosine - middle, high * cosine - middle, direction.weight));
  }
  const auto azimuth_extent = extent_of_bands(azimuth, beyond);
  const auto range_extent = extent_of_bands(range, beyond);
  if (!azimuth_extent || !range_extent) return std::nullopt;
  return ImageSpectrum{*azimuth_extent, *range_extent};
}

ImageSpectrum joined(const ImageSpectrum& a, const ImageSpectrum& b) {
  return {joined_extent(a.azimuth, b.azimuth), joined_extent(a.range, b.range)};
}

bool holds(const ImageAxis& axis, const SpectrumExtent& extent) {
  CORE_EXPECT(axis.step_m != 0.0);
  const double half_period = 0.5 / std::abs(axis.step_m);
  return extent.least_per_m >= axis.spectrum_centre_per_m - half_period &&
         extent.most_per_m <= axis.spectrum_centre_per_m + half_period;
}

double step_for(const ImageAxis& axis, const SpectrumExtent& extent) {
  constexpr double spare = 1.1;
  if (holds(axis, extent)) return axis.step_m;
  return std::min(axis.step_m, 1.0 / (spare * extent.width_per_m()));
}

void fit_axis(ImageAxis& axis, const SpectrumExtent& extent) {
  if (holds(axis, extent)) return;
  const double step_m = step_for(axis, extent);
  axis.count = static_cast<std::size_t>(std::ceil(static_cast<double>(axis.count) * axis.step_m / step_m));
  axis.step_m = step_m;
  axis.spectrum_centre_per_m = extent.middle_per_m();
}

}  // namespace sarsim::signal
