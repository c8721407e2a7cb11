#pragma once

#include <optional>
#include <span>

#include "signal/sar/sar_echoes.hpp"
#include "signal/sar/sar_image.hpp"

/// Which wave numbers the responses of an image fill, and axes that hold them (docs/theory/focusing.md, "The grid").
namespace sarsim::signal {

/// Wave numbers of an axis, in cycles per metre.
struct SpectrumExtent {
  double min_per_m = 0.0;
  double max_per_m = 0.0;

  [[nodiscard]] double width_per_m() const { return max_per_m - min_per_m; }
  [[nodiscard]] double middle_per_m() const { return 0.5 * (min_per_m + max_per_m); }
};

/// The wave numbers of an image of slant range, in baseband.
struct ImageSpectrum {
  SpectrumExtent azimuth;
  SpectrumExtent range;
};

/// One pulse's sight of a point.
struct SeenDirection {
  double sine = 0.0;    ///< Of the angle by which the line of sight points ahead, in (-1, 1).
  double weight = 0.0;  ///< Amplitude of the echo, at least 0.
};

/// The wave numbers that hold the response of a point but for `beyond` of its echoes' amplitude at either end of each
/// axis: a pulse with the angle a and the frequency f0 + f, |f| up to B/2, gives
///
///     azimuth  (2/c) (f0 + f) sin a,        range  (2/c) ((f0 + f) cos a - f0).
///
/// Nothing where no direction has a weight.
/// @param beyond  at least 0 and below 1/2
[[nodiscard]] std::optional<ImageSpectrum> spectrum_of(std::span<const SeenDirection> seen, const SarWaveform& waveform,
                                                       double beyond);

/// One pulse's view of a point of an image: derivatives of the distance to the antenna with respect to the image's
/// coordinates, m/m.
struct SeenSlopes {
  double azimuth = 0.0;
  double range = 0.0;
  double weight = 0.0;  ///< Amplitude of the echo, at least 0.
};

/// The same as `spectrum_of` directions, for an image on any surface and any flight: with the slopes a and r, and the
/// slopes a0 and r0 of the distance to which the image's phases refer (baseband), in cycles per metre
///
///     azimuth  (2/c) ((f0 + f) a - f0 a0),        range  (2/c) ((f0 + f) r - f0 r0).
[[nodiscard]] std::optional<ImageSpectrum> spectrum_of(std::span<const SeenSlopes> seen, const SeenSlopes& baseband,
                                                       const SarWaveform& waveform, double beyond);

/// The smallest spectrum that holds both.
[[nodiscard]] ImageSpectrum joined(const ImageSpectrum& a, const ImageSpectrum& b);

/// Whether samples of this axis hold these wave numbers in the one period about its spectral centre.
[[nodiscard]] bool holds(const ImageAxis& axis, const SpectrumExtent& extent);

/// The step that an axis needs for these wave numbers with a tenth to spare; that which it has where it is fine enough.
[[nodiscard]] double step_for(const ImageAxis& axis, const SpectrumExtent& extent);

/// Makes an axis that does not hold these wave numbers finer where it has to be, from the same place on over the same
/// length, with its spectral centre in their middle. Leaves one that holds them as it is.
void fit_axis(ImageAxis& axis, const SpectrumExtent& extent);

}  // namespace sarsim::signal
