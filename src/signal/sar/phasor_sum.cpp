#include "signal/sar/phasor_sum.hpp"

#include <algorithm>
#include <cmath>

#include "core/maths/constants.hpp"

namespace sarsim::signal {

namespace {

std::complex<double> phasor_at(const SpectrumPhasor& phasor, const ImagePlace& place) {
  const double turns = phasor.turns + phasor.azimuth_per_m * place.azimuth_m + phasor.range_per_m * place.range_m;
  return std::polar(phasor.weight, 2.0 * core::pi * (turns - std::round(turns)));
}

struct Middle {
  double azimuth_per_m = 0.0;
  double range_per_m = 0.0;
};

Middle middle_of(std::span<const SpectrumPhasor> phasors) {
  const auto azimuth = std::ranges::minmax(phasors, {}, &SpectrumPhasor::azimuth_per_m);
  const auto range = std::ranges::minmax(phasors, {}, &SpectrumPhasor::range_per_m);
  return {0.5 * (azimuth.min.azimuth_per_m + azimuth.max.azimuth_per_m),
          0.5 * (range.min.range_per_m + range.max.range_per_m)};
}

// The sum and its moments, which are its derivatives by -(2 pi i)^n, about the middle of the spectrum.
struct Moments {
  std::complex<double> sum;
  std::complex<double> a, r;
  std::complex<double> aa, ar, rr;
};

Moments moments_at(std::span<const SpectrumPhasor> phasors, const Middle& middle, const ImagePlace& place) {
  Moments m;
  for (const SpectrumPhasor& phasor : phasors) {
    const std::complex<double> value = phasor_at(phasor, place);
    const double a = phasor.azimuth_per_m - middle.azimuth_per_m;
    const double r = phasor.range_per_m - middle.range_per_m;
    m.sum += value;
    m.a += a * value;
    m.r += r * value;
    m.aa += a * a * value;
    m.ar += a * r * value;
    m.rr += r * r * value;
  }
  return m;
}

// The step to the top of the parabola that the logarithm of the power is like; nothing where that has none.
std::optional<ImagePlace> step_of(const Moments& m) {
  constexpr double flat = 1e-9;  // Of the spread that phasors of equal phase have.
  const std::complex<double> a = m.a / m.sum;
  const std::complex<double> r = m.r / m.sum;
  const double aa = (m.aa / m.sum - a * a).real();
  const double ar = (m.ar / m.sum - a * r).real();
  const double rr = (m.rr / m.sum - r * r).real();
  const double by_turn = -1.0 / (2.0 * core::pi);
  const bool has_azimuth = std::abs(m.aa) > 0.0;
  const bool has_range = std::abs(m.rr) > 0.0;
  if (!has_azimuth && !has_range) return ImagePlace{};
  if ((has_azimuth && !(aa > 0.0)) || (has_range && !(rr > 0.0))) return std::nullopt;
  if (!has_range) return ImagePlace{by_turn * a.imag() / aa, 0.0};
  if (!has_azimuth) return ImagePlace{0.0, by_turn * r.imag() / rr};
  const double determinant = aa * rr - ar * ar;
  if (!(determinant > flat * aa * rr)) return std::nullopt;
  return ImagePlace{by_turn * (rr * a.imag() - ar * r.imag()) / determinant,
                    by_turn * (aa * r.imag() - ar * a.imag()) / determinant};
}

}  // namespace

std::complex<double> phasor_sum(std::span<const SpectrumPhasor> phasors, const ImagePlace& place) {
  std::complex<double> sum;
  for (const SpectrumPhasor& phasor : phasors) sum += phasor_at(phasor, place);
  return sum;
}

std::optional<ImagePlace> phasor_peak(std::span<const SpectrumPhasor> phasors, const ImagePlace& from) {
  if (phasors.empty()) return std::nullopt;
  constexpr int max_steps = 8;
  constexpr double enough = 1e-10;  // Of the power: what a last step may still add.
  const Middle middle = middle_of(phasors);
  ImagePlace place = from;
  Moments here = moments_at(phasors, middle, place);
  for (int i = 0; i < max_steps; ++i) {
    if (!(std::norm(here.sum) > 0.0)) return std::nullopt;
    const std::optional<ImagePlace> step = step_of(here);
    if (!step) return std::nullopt;
    const ImagePlace next{place.azimuth_m + step->azimuth_m, place.range_m + step->range_m};
    const Moments there = moments_at(phasors, middle, next);
    const double gain = std::norm(there.sum) / std::norm(here.sum) - 1.0;
    if (!(gain > -enough)) return std::nullopt;
    place = next;
    here = there;
    if (gain < enough) return place;
  }
  return std::nullopt;
}

}  // namespace sarsim::signal
