#pragma once

#include "signal/measure/image_quality.hpp"

namespace sarsim::signal {

/// Mean power [V^2] of the noise of an image around a place: the lower quartile of the powers of up to 65 x 65 samples
/// spread over a rectangle, divided by that of noise of power 1, ln(4/3). Points in less than a quarter of the samples
/// raise it little. Samples that are exactly 0 do not count; 0 if there are no others.
/// @param half_azimuth_m, half_range_m  the rectangle to either side of the place, cut at the image's edges; above 0
[[nodiscard]] double noise_power_near(const FocusedImage& image, const ImageReader& reader, const ImagePlace& place,
                                      double half_azimuth_m, double half_range_m);

/// Probability that the largest peak of complex normal noise within a rectangle is more than `ratio` times the noise's
/// mean power, up to 1: the expected Euler characteristic of what is above (K. J. Worsley, Advances in Applied
/// Probability 26, 1994, for a chi-squared field of two degrees of freedom),
///
///     P = exp(-T) (1 + (a + b) sqrt(pi T/3) + a b pi/6 (2 T - 1)),
///
/// for a spectrum that is even over the band. Within 5 % for P below 0.05.
/// @param azimuth_cells, range_cells  the rectangle's sides a and b in resolution cells, 1 over the bandwidth
[[nodiscard]] double peak_false_alarm(double ratio, double azimuth_cells, double range_cells);

/// The ratio of powers, 0.5 to 1000, at which `peak_false_alarm` is `false_alarm`, which must lie between 0 and 0.5.
[[nodiscard]] double peak_threshold(double false_alarm, double azimuth_cells, double range_cells);

}  // namespace sarsim::signal
