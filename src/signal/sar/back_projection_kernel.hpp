#pragma once

#include <span>

#include "signal/sar/projection_point.hpp"
#include "signal/sar/projection_tile.hpp"

namespace sarsim::signal {

/// Adds to the tile, for each of its points x and each pulse,
///
///     w s(tau(x) - fd/K) exp(+j 2 pi (f tau(x) + fd^2/(2 K))),      fd = -2 v f/c,
///
/// s the pulse's echo between records and w its weight; tau is the light time there and back to the antenna as it flies
/// on, exact for an even flight (radar/path/light_time.hpp). Distances, delays and the reference of every phase are in
/// double precision at the middle of each stretch; from there a polynomial in float leads on, with whole turns per
/// point taken out of its linear term: within 1.3e-5 cycles of the exact phase and 1e-3 of a record. SIMD with run-time
/// choice of the instruction set.
/// @param tile  with as many pieces of a surface as stretches, if it has a surface and no points
void project(std::span<const ProjectionPulse> pulses, const ProjectionConstants& constants,
             const ProjectionAperture& aperture, Stretch stretch, ProjectionTile& tile);

}  // namespace sarsim::signal
