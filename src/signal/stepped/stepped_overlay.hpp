#pragma once

#include <optional>
#include <span>

#include "signal/sar/sar_image.hpp"

namespace sarsim::signal {

/// A point that an image should show, somewhere: only its place relative to other points is known.
struct OverlayPoint {
  ImagePlace place;
  double amplitude = 0.0;  ///< Of its peak; 0: not to be seen.
};

/// The shift that lays points upon an image whose origin is not known: the strongest points are tried upon the
/// strongest peaks, and the shift is kept that leaves the least of the points' amplitudes unexplained,
///
///     sum over points of min(| |image| - amplitude |, amplitude),
///
/// |image| the largest magnitude within half a cell of the shifted point. A point that is missing, or lies upon one far
/// stronger, costs its own amplitude and no more; without squares one strong point does not outvote the others. Of
/// equal sums the one of stronger points and peaks counts. The shift is exact for the strongest point that is
/// explained, whose peak is measured between samples.
/// @param image  with its values
/// @param cell   resolution of the image, metres
/// @return nothing where the image is empty or no point has an amplitude
[[nodiscard]] std::optional<ImagePlace> shift_upon_image(const FocusedImage& image,
                                                         std::span<const OverlayPoint> points, const ImagePlace& cell);

}  // namespace sarsim::signal
