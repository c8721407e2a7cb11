#pragma once

#include <optional>

#include "picture/figure/figure.hpp"
#include "signal/measure/image_quality.hpp"

namespace sarsim::cli {

/// The cuts through a point as a picture of two panels, azimuth and range: decibels below the peak against metres from
/// it, as far as sidelobes are counted, with the half-power width and the largest sidelobe that theory has.
/// @param azimuth, range  theory; nothing: no such lines
[[nodiscard]] picture::Figure figure_of_cuts(const signal::PointCuts& cuts, const signal::PointResponse& found,
                                             const std::optional<signal::ResponseFigures>& azimuth,
                                             const std::optional<signal::ResponseFigures>& range);

}  // namespace sarsim::cli
