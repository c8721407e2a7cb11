#include "workflow/focus/tone_response.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/maths/constants.hpp"
#include "core/maths/sinc.hpp"
#include "signal/sar/phasor_sum.hpp"

namespace sarsim::workflow {

namespace {

// The sum of tones at the places -half to half, a step apart. Each tone turns by as much from place to place; several
// neighbouring places are made at once, since one needs the one before.
std::vector<std::complex<double>> sum_of_tones(const std::vector<Tone>& tones, double zero_per_m, double step_m,
                                               std::ptrdiff_t half) {
  constexpr std::size_t lanes = 8;
  const auto count = static_cast<std::size_t>(2 * half + 1);
  const std::size_t blocks = (count + lanes - 1) / lanes;
  std::vector<std::array<double, lanes>> real(blocks), imag(blocks);
  for (const Tone& tone : tones) {
    const double turn_rad = 2.0 * core::pi * (tone.per_m - zero_per_m) * step_m;
    const double size = std::abs(tone.amplitude);
    const double begin_rad = std::arg(tone.amplitude);
    std::array<double, lanes> re, im;
    for (std::size_t i = 0; i < lanes; ++i) {
      const double phase_rad = begin_rad + turn_rad * (static_cast<double>(i) - static_cast<double>(half));
      re[i] = size * std::cos(phase_rad);
      im[i] = size * std::sin(phase_rad);
    }
    const double c = std::cos(turn_rad * lanes);
    const double s = std::sin(turn_rad * lanes);
    for (std::size_t b = 0; b < blocks; ++b)
      for (std::size_t i = 0; i < lanes; ++i) {
        real[b][i] += re[i];
        imag[b][i] += im[i];
        const double next = re[i] * c - im[i] * s;
        im[i] = re[i] * s + im[i] * c;
        re[i] = next;
      }
  }
  std::vector<std::complex<double>> sum(count);
  for (std::size_t n = 0; n < count; ++n) sum[n] = {real[n / lanes][n % lanes], imag[n / lanes][n % lanes]};
  return sum;
}

}  // namespace

std::optional<ToneResponse> response_of_tones(const std::vector<Tone>& tones) {
  constexpr double steps_per_cell = 48.0;
  constexpr std::ptrdiff_t half = 1200;  // 25 cells
  if (tones.empty()) return std::nullopt;
  const auto [low, high] = std::ranges::minmax(tones, {}, &Tone::per_m);
  if (!(high.per_m > low.per_m)) return std::nullopt;
  const double step_m = 1.0 / ((high.per_m - low.per_m) * steps_per_cell);
  return ToneResponse{sum_of_tones(tones, low.per_m, step_m, half), step_m};
}

std::optional<signal::ResponseFigures> figures_of_tones(const std::vector<Tone>& tones) {
  const std::optional<ToneResponse> response = response_of_tones(tones);
  if (!response) return std::nullopt;
  auto figures = signal::figures_of(response->values, response->values.size() / 2);
  if (!figures) return std::nullopt;
  figures->width *= response->step_m;
  figures->null *= response->step_m;
  return figures;
}

std::optional<TargetBlur> blur_of(const std::vector<BlurredLook>& looks, double turns_per_m, double band_per_m) {
  double sum = 0.0, mean_m = 0.0, square = 0.0;
  for (const BlurredLook& look : looks) {
    sum += look.weight;
    mean_m += look.weight * look.late_m;
    square += look.weight * look.late_m * look.late_m;
  }
  if (!(sum > 0.0)) return std::nullopt;
  mean_m /= sum;
  TargetBlur blur;
  blur.walk_m = std::sqrt(12.0 * std::max(0.0, square / sum - mean_m * mean_m));
  std::vector<Tone> tones;
  std::vector<signal::SpectrumPhasor> phasors;
  for (const BlurredLook& look : looks) {
    const double weight = look.weight * std::max(0.0, core::sinc(band_per_m * (look.late_m - mean_m)));
    const double turns = -turns_per_m * look.late_m;
    tones.push_back({look.azimuth_per_m, std::polar(weight, 2.0 * core::pi * (turns - std::round(turns)))});
    phasors.push_back({.azimuth_per_m = look.azimuth_per_m, .weight = weight, .turns = turns});
  }
  const std::optional<ToneResponse> response = response_of_tones(tones);
  if (!response) return std::nullopt;
  const auto top =
      std::ranges::max_element(response->values, {}, [](const std::complex<double>& v) { return std::norm(v); });
  const auto steps =
      static_cast<double>(top - response->values.begin()) - static_cast<double>(response->values.size() / 2);
  const auto peak = signal::phasor_peak(phasors, {steps * response->step_m, 0.0});
  blur.azimuth_m = peak ? peak->azimuth_m : steps * response->step_m;
  blur.kept = signal::phasor_sum(phasors, {blur.azimuth_m, 0.0}) / sum;
  for (const Tone& tone : tones)
    blur.parts.push_back(tone.amplitude * std::polar(1.0, 2.0 * core::pi * tone.per_m * blur.azimuth_m));
  return blur;
}

}  // namespace sarsim::workflow
