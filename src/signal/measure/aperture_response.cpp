#include "signal/measure/aperture_response.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/maths/constants.hpp"
#include "core/report/expect.hpp"

namespace sarsim::signal {

namespace {

constexpr std::ptrdiff_t response_cells = 25;
// Of the response as it is summed, and of what its figures are taken from; a cell is the inverse of the support.
constexpr std::ptrdiff_t coarse_per_cell = 6;
constexpr std::ptrdiff_t fine_per_coarse = 8;
// On either side of a value between: Kaiser's window makes the error of a band of a sixth of the rate less than 1e-6.
constexpr std::ptrdiff_t side_values = 8;

// Looks of nearly the same slope together: the phases of a group differ by less than 0.3 rad 25 cells from the peak.
std::vector<ApertureLook> grouped(std::span<const ApertureLook> looks, double low, double high) {
  constexpr std::size_t groups = 512;
  std::vector<ApertureLook> sums(groups);
  const double per_slope = high > low ? static_cast<double>(groups) / (high - low) : 0.0;
  for (const ApertureLook& look : looks) {
    const auto group = static_cast<std::size_t>((look.slope - low) * per_slope);
    ApertureLook& sum = sums[std::min(group, groups - 1)];
    sum.slope += look.weight * look.slope;
    sum.weight += look.weight;
  }
  std::erase_if(sums, [](const ApertureLook& sum) { return !(sum.weight > 0.0); });
  for (ApertureLook& sum : sums) sum.slope /= sum.weight;
  return sums;
}

// The pulse between its values, 0 beyond them.
std::complex<double> pulse_at(const SampledResponse& pulse, double lags) {
  const double at = static_cast<double>(pulse.peak) + lags * pulse.per_lag;
  if (!(at >= 0.0 && at < static_cast<double>(pulse.values.size() - 1))) return {};
  const auto before = static_cast<std::size_t>(at);
  const double part = at - static_cast<double>(before);
  return pulse.values[before] + part * (pulse.values[before + 1] - pulse.values[before]);
}

double bessel_i0(double x) {
  double term = 1.0;
  double sum = 1.0;
  for (int k = 1; k < 40; ++k) {
    term *= 0.25 * x * x / (static_cast<double>(k) * k);
    sum += term;
  }
  return sum;
}

// Weights of the values around one that lies `part` of a step behind the first of the right half.
std::vector<double> interpolator(double part) {
  constexpr double kaiser = 12.0;
  std::vector<double> weights;
  for (std::ptrdiff_t k = 1 - side_values; k <= side_values; ++k) {
    const double x = static_cast<double>(k) - part;
    const double share = x / static_cast<double>(side_values);
    const double window = bessel_i0(kaiser * std::sqrt(std::max(1.0 - share * share, 0.0))) / bessel_i0(kaiser);
    weights.push_back(window * (x == 0.0 ? 1.0 : std::sin(core::pi * x) / (core::pi * x)));
  }
  return weights;
}

std::vector<std::complex<double>> refined(const std::vector<std::complex<double>>& coarse) {
  constexpr std::ptrdiff_t half = response_cells * coarse_per_cell;
  std::vector<std::complex<double>> fine(static_cast<std::size_t>(2 * half * fine_per_coarse + 1));
  for (std::ptrdiff_t part = 0; part < fine_per_coarse; ++part) {
    const std::vector<double> weights = interpolator(static_cast<double>(part) / fine_per_coarse);
    for (std::ptrdiff_t i = part; i < static_cast<std::ptrdiff_t>(fine.size()); i += fine_per_coarse) {
      std::complex<double> sum;
      for (std::size_t k = 0; k < weights.size(); ++k)
        sum += weights[k] * coarse[static_cast<std::size_t>(i / fine_per_coarse) + 1 + k];
      fine[static_cast<std::size_t>(i)] = sum;
    }
  }
  return fine;
}

}  // namespace

std::optional<ResponseFigures> aperture_figures(std::span<const ApertureLook> looks, const ApertureBand& band,
                                                const SampledResponse& pulse) {
  CORE_EXPECT(band.band_per_m > 0.0 && pulse.values.size() > 1);
  if (looks.empty()) return std::nullopt;
  double low = INFINITY, high = -INFINITY;  // wave numbers
  for (const ApertureLook& look : looks)
    for (const double per_m :
         {band.carrier_per_m - 0.5 * band.band_per_m, band.carrier_per_m + 0.5 * band.band_per_m}) {
      low = std::min(low, per_m * look.slope);
      high = std::max(high, per_m * look.slope);
    }
  if (!(high - low > 1e-9 * (band.carrier_per_m + band.band_per_m))) return std::nullopt;
  const auto [least, most] = std::ranges::minmax(looks, {}, &ApertureLook::slope);
  const std::vector<ApertureLook> groups = grouped(looks, least.slope, most.slope);
  const double step_m = 1.0 / (static_cast<double>(coarse_per_cell) * (high - low));
  const double middle_per_m = 0.5 * (low + high);
  constexpr std::ptrdiff_t half = response_cells * coarse_per_cell + side_values;
  std::vector<std::complex<double>> coarse(static_cast<std::size_t>(2 * half + 1));
  for (const ApertureLook& look : groups) {
    const double turns = (band.carrier_per_m * look.slope - middle_per_m) * step_m;
    const double lags = look.slope * step_m * band.band_per_m;
    std::complex<double> turned = std::polar(look.weight, -2.0 * core::pi * turns * static_cast<double>(half));
    const std::complex<double> turn = std::polar(1.0, 2.0 * core::pi * turns);
    for (std::ptrdiff_t i = -half; i <= half; ++i) {
      coarse[static_cast<std::size_t>(i + half)] += turned * pulse_at(pulse, lags * static_cast<double>(i));
      turned *= turn;
    }
  }
  const std::vector<std::complex<double>> fine = refined(coarse);
  auto figures = figures_of(fine, fine.size() / 2);
  if (!figures) return std::nullopt;
  const double fine_step_m = step_m / static_cast<double>(fine_per_coarse);
  figures->width *= fine_step_m;
  figures->null *= fine_step_m;
  return figures;
}

}  // namespace sarsim::signal
