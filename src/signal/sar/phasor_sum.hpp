#pragma once

#include <complex>
#include <optional>
#include <span>

#include "signal/sar/sar_image.hpp"

namespace sarsim::signal {

/// A part of the spectrum of a point's image.
struct SpectrumPhasor {
  double azimuth_per_m = 0.0;  ///< Wave numbers, cycles per metre.
  double range_per_m = 0.0;
  double weight = 0.0;
  double turns = 0.0;  ///< Its phase, cycles.
};

/// The image at a place: the sum of weight exp(2 pi i (turns + azimuth_per_m x + range_per_m y)).
[[nodiscard]] std::complex<double> phasor_sum(std::span<const SpectrumPhasor> phasors, const ImagePlace& place);

/// The place of the peak on whose slope `from` lies, by Newton's method for the logarithm of the power: a few sums
/// where phases bend by up to about half a radian. Nothing where that leads to no peak or lower: then another search is
/// needed. Where all phasors have one wave number of an axis the place does not change in it.
[[nodiscard]] std::optional<ImagePlace> phasor_peak(std::span<const SpectrumPhasor> phasors, const ImagePlace& from);

}  // namespace sarsim::signal
