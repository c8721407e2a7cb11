#pragma once

namespace sarsim::core {

/// How near to minus half a turn an angle is taken for half a turn: the direction opposite to the beam has one angle,
/// and periodic patterns one value there, whatever the sign of a zero or of rounding.
inline constexpr double opposite_rad = 1e-9;

}  // namespace sarsim::core
