#pragma once

#include <optional>
#include <span>

#include "signal/measure/response.hpp"

namespace sarsim::signal {

/// A pulse as part of a target's response along a line through the image.
struct ApertureLook {
  double slope = 0.0;   ///< Change of the distance to the antenna per metre along the line: line of sight times line.
  double weight = 0.0;  ///< Of its echo in the image, above 0.
};

/// The band that every pulse of an aperture fills, as wave numbers of the two-way path: 2 f/c, cycles per metre.
struct ApertureBand {
  double carrier_per_m = 0.0;  ///< 2 f0/c.
  double band_per_m = 0.0;     ///< 2 B/c, above 0.
};

/// Figures of the response along a line of a target that is seen from many directions: that of the part of a polar
/// annulus which they and the band fill,
///
///     I(s) = sum over looks of w g(a s) exp(2 pi j (2 f0/c) a s),
///
/// a the slope of a look and g the compressed pulse over the distance. It is that of back-projection for any aperture
/// and any bandwidth, at which the response is no product of one over the range and one over the azimuth.
///
/// @param pulse  g, over the distance times the band
/// @return widths and nulls in metres of the line; nothing where the support has no width along it or no minimum lies
///         within 25 of its inverse widths
[[nodiscard]] std::optional<ResponseFigures> aperture_figures(std::span<const ApertureLook> looks,
                                                              const ApertureBand& band, const SampledResponse& pulse);

}  // namespace sarsim::signal
