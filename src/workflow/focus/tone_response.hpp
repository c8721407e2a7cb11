#pragma once

#include <complex>
#include <cstddef>
#include <optional>
#include <vector>

#include "signal/measure/response.hpp"

namespace sarsim::workflow {

/// A part of the azimuth spectrum of a target.
struct Tone {
  double per_m = 0.0;  ///< Wave number, cycles per metre.
  std::complex<double> amplitude;
};

/// The sum of amplitude exp(2 pi j per_m x) over 25 cells to either side of a place, a cell one over the width of the
/// spectrum.
struct ToneResponse {
  std::vector<std::complex<double>> values;  ///< At evenly spaced places; the place itself is in the middle.
  double step_m = 0.0;
};

/// Nothing where all tones have one wave number.
[[nodiscard]] std::optional<ToneResponse> response_of_tones(const std::vector<Tone>& tones);

/// Figures, in metres, of the peak in the middle; nothing where no first minimum is within the response.
[[nodiscard]] std::optional<signal::ResponseFigures> figures_of_tones(const std::vector<Tone>& tones);

/// A point as it would be seen by one pulse if it rested, and as it is.
struct BlurredLook {
  double azimuth_per_m = 0.0;  ///< Place in the azimuth spectrum.
  double weight = 0.0;         ///< Amplitude of the echo in the sum.
  double late_m = 0.0;         ///< By how much the echo comes from farther away than that of a point at rest.
};

/// What its motion makes of the peak of a target.
struct TargetBlur {
  double azimuth_m = 0.0;  ///< Displacement of the peak.
  double walk_m = 0.0;     ///< Range that the echoes walk through, twice their standard deviation times sqrt(3).
  std::complex<double> kept{1.0, 0.0};      ///< The peak over the sum of the weights.
  std::vector<std::complex<double>> parts;  ///< Of the peak, by look: they add up to it.
};

/// The peak of the sum of w exp(2 pi j (k x - turns_per_m late)), and of what lies beside the others in range the less
/// the farther it does, by the response of an even band. The largest within 25 cells.
/// @param turns_per_m  of the carrier, two ways
/// @param band_per_m   the pulse's band, cycles per metre of range
[[nodiscard]] std::optional<TargetBlur> blur_of(const std::vector<BlurredLook>& looks, double turns_per_m,
                                                double band_per_m);

}  // namespace sarsim::workflow
