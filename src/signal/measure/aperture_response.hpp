#pragma once

#include <optional>
#include <span>

#include "signal/measure/response.hpp"

namespace sarsim::signal {

/// Contribution of a pulse to a target's response along a line through the image.
struct ApertureLook {
  double slope = 0.0;   ///< Change of the distance to the antenna per metre along the line: unit line of sight . line.
  double weight = 0.0;  ///< Of its echo in the image, above 0.
};

/// The band that every pulse of an aperture fills, as wave numbers of the two-way path: 2 f/c, cycles per metre.
struct ApertureBand {
  double carrier_per_m = 0.0;  ///< 2 f0/c.
  double band_per_m = 0.0;     ///< 2 B/c, above 0.
};

/// Figures of the response, along a line, of a target seen from many directions, which with the band fill part of a
/// polar annulus:
///
///     I(s) = sum over looks of w g(a s) exp(2 pi j (2 f0/c) a s),
///
/// with a the slope of a look and g the compressed pulse over the distance. This is the response of back-projection for
/// any aperture and bandwidth, also where it is not the product of a range and an azimuth response.
///
/// @param pulse  g, over the distance times the band
/// @return widths and nulls in metres along the line; nothing if the support has no width along it or there is
///         no minimum within 25 inverse widths
[[nodiscard]] std::optional<ResponseFigures> aperture_figures(std::span<const ApertureLook> looks,
                                                              const ApertureBand& band, const SampledResponse& pulse);

}  // namespace sarsim::signal
