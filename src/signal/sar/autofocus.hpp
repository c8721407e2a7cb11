#pragma once

#include <cstddef>
#include <vector>

#include "core/task/parallel.hpp"
#include "signal/sar/sar_image.hpp"

namespace sarsim::signal {

/// -sum of p ln p, p the share of each pixel in the energy of an image: the smaller, the sharper. 0 without energy.
[[nodiscard]] double image_entropy(const FocusedImage& image);

/// When phase gradient autofocus is content.
struct AutofocusOptions {
  std::size_t rounds = 20;     ///< At most.
  double enough_rad = 0.01;    ///< Ends when a round corrects less than this, root mean square.
  double support_share = 0.1;  ///< Frequencies with less than this of the power that 97 % of the spectrum, smoothed,
                               ///< stay below are not part of the aperture.
  double band_per_m = 0.0;     ///< Nor are those farther than half of this from the image's spectral centre, cycles
                               ///< per metre, where only noise is; 0: all may be.
  std::size_t min_window = 5;  ///< Pixels of azimuth that a round looks at, at least.
};

/// What autofocus found in an image whose pulses all saw all of it.
struct AutofocusResult {
  FocusedImage image;                ///< Corrected.
  std::vector<double> phase_rad;     ///< That was taken out of the spectrum, one value for each frequency of azimuth.
  std::vector<double> cycles_per_m;  ///< The frequencies: ascending, without gaps, within the aperture; about the
                                     ///< image's spectral centre.
  std::vector<double> round_rad;     ///< Root mean square of what each round corrected.
};

/// Phase gradient autofocus (Wahl, Eichel, Ghiglia and Jakowatz, IEEE Trans. AES 30, 1994): each column's brightest
/// pixel is brought to the middle and cut out with a window that narrows from twice the blur to `min_window`; in the
/// spectra G of the columns the phase error of azimuth frequency n has the gradient arg of the sum over columns of G(n)
/// conj(G(n - 1)). Its integral without constant and straight line, which only move the image, is taken out of all
/// columns. What lies beyond the aperture is kept in the image, but not looked at: noise there would outshine points.
///
/// An echo turned by exp(+j e) at frequency k has phase_rad = e there. Needs contrast: a few columns with a point that
/// stands out. The same bytes for any number of threads.
/// @throw  std::invalid_argument where the image has not as many values as its axes say; Interrupted
[[nodiscard]] AutofocusResult autofocus(const FocusedImage& image, const AutofocusOptions& options,
                                        const core::WorkControl& control);

/// What autofocus found along the track.
struct StripmapAutofocusResult {
  FocusedImage image;             ///< Corrected.
  std::vector<double> along_m;    ///< Places of the antenna along the frame's line, evenly spaced.
  std::vector<double> phase_rad;  ///< Of the echoes received there; without constant and straight line.
  double rms_rad = 0.0;           ///< Of what was taken out of the pieces' spectra, by their energy.
};

/// The same for a strip, whose points were seen by different parts of the flight: the image is cut along azimuth into
/// overlapping pieces of `piece_m` (much shorter than the synthetic aperture, much longer than the blur). In a piece
/// about azimuth x the frequency k of a column at range R was received under the angle a, sin a = k lambda/2, at
/// s = x - R tan a. Where the beam squints, pieces follow its line of sight, so that one place s has one frequency at
/// all ranges. Each piece's phase lacks a straight line of its own: the lines are those that make the pieces agree
/// where they overlap, in the sense of least squares. Each piece is corrected by its stretch of the mean, again without
/// the straight line that fits best to it over the piece's spectrum, and the pieces are put together: points stay where
/// they were. Errors that change within a piece's length are not seen.
/// @param image  of slant range
/// @throw  std::invalid_argument for an image of another plane or with fewer than four pixels to a piece; Interrupted
[[nodiscard]] StripmapAutofocusResult autofocus_strip(const FocusedImage& image, double piece_m,
                                                      const AutofocusOptions& options,
                                                      const core::WorkControl& control);

}  // namespace sarsim::signal
