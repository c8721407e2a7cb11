#include "signal/sar/image_spectrum.hpp"

#include <algorithm>
#include <cmath>

#include "core/report/expect.hpp"
#include "radar/path/path.hpp"

namespace sarsim::signal {

namespace {

// Wave numbers that one direction fills evenly.
struct FilledBand {
  SpectrumExtent extent;
  double weight = 0.0;
};

SpectrumExtent joined_extent(const SpectrumExtent& a, const SpectrumExtent& b) {
  return {std::min(a.min_per_m, b.min_per_m), std::max(a.max_per_m, b.max_per_m)};
}

// The sum of the weights below a wave number, and how fast it grows there.
struct WeightBelow {
  double sum = 0.0;
  double slope_m = 0.0;
};

WeightBelow weight_below(std::span<const FilledBand> bands, double per_m) {
  WeightBelow below;
  for (const FilledBand& band : bands) {
    const double width = band.extent.width_per_m();
    const double above = per_m - band.extent.min_per_m;
    below.sum += band.weight * (width > 0.0 ? std::clamp(above / width, 0.0, 1.0) : above >= 0.0);
    if (above > 0.0 && above < width) below.slope_m += band.weight / width;
  }
  return below;
}

// The wave number below which the weights add up to `weight`: of a sum of straight pieces, by Newton's steps within a
// bracket that shrinks.
double quantile_of(std::span<const FilledBand> bands, double weight, SpectrumExtent within) {
  constexpr int max_steps = 40;
  constexpr double close = 1e-12;
  const double tolerance_per_m = close * within.width_per_m();
  double at = within.middle_per_m();
  for (int i = 0; i < max_steps && within.width_per_m() > tolerance_per_m; ++i) {
    const WeightBelow below = weight_below(bands, at);
    (below.sum < weight ? within.min_per_m : within.max_per_m) = at;
    if (std::abs(below.sum - weight) <= close * weight) return at;
    const double next = at + (weight - below.sum) / below.slope_m;
    const bool inside = next > within.min_per_m && next < within.max_per_m;
    at = inside ? next : within.middle_per_m();
  }
  return at;
}

std::optional<SpectrumExtent> extent_of_bands(std::span<const FilledBand> bands, double beyond) {
  double all = 0.0;
  SpectrumExtent whole{INFINITY, -INFINITY};
  for (const FilledBand& band : bands) {
    if (!(band.weight > 0.0)) continue;
    all += band.weight;
    whole = joined_extent(whole, band.extent);
  }
  if (!(all > 0.0)) return std::nullopt;
  if (beyond == 0.0) return whole;
  return SpectrumExtent{quantile_of(bands, beyond * all, whole), quantile_of(bands, (1.0 - beyond) * all, whole)};
}

FilledBand filled_band(double a, double b, double weight) { return {{std::min(a, b), std::max(a, b)}, weight}; }

}  // namespace

std::optional<ImageSpectrum> spectrum_of(std::span<const SeenDirection> seen, const SarWaveform& waveform,
                                         double beyond) {
  std::vector<SeenSlopes> slopes;
  slopes.reserve(seen.size());
  for (const SeenDirection& direction : seen)
    slopes.push_back(
        {direction.sine, std::sqrt(std::max(0.0, 1.0 - direction.sine * direction.sine)), direction.weight});
  return spectrum_of(slopes, {0.0, 1.0, 0.0}, waveform, beyond);
}

std::optional<ImageSpectrum> spectrum_of(std::span<const SeenSlopes> seen, const SeenSlopes& baseband,
                                         const SarWaveform& waveform, double beyond) {
  CORE_EXPECT(beyond >= 0.0 && beyond < 0.5);
  CORE_EXPECT(waveform.light_speed_mps > 0.0);
  const double low =
      radar::turns_per_m(waveform.carrier_hz - 0.5 * std::abs(waveform.bandwidth_hz), waveform.light_speed_mps);
  const double high =
      radar::turns_per_m(waveform.carrier_hz + 0.5 * std::abs(waveform.bandwidth_hz), waveform.light_speed_mps);
  const double middle = radar::turns_per_m(waveform.carrier_hz, waveform.light_speed_mps);
  const double azimuth0 = middle * baseband.azimuth;
  const double range0 = middle * baseband.range;
  std::vector<FilledBand> azimuth;
  std::vector<FilledBand> range;
  for (const SeenSlopes& slope : seen) {
    azimuth.push_back(filled_band(low * slope.azimuth - azimuth0, high * slope.azimuth - azimuth0, slope.weight));
    range.push_back(filled_band(low * slope.range - range0, high * slope.range - range0, slope.weight));
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
  return extent.min_per_m >= axis.spectrum_centre_per_m - half_period &&
         extent.max_per_m <= axis.spectrum_centre_per_m + half_period;
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
