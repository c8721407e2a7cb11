#pragma once

#include "core/maths/vector.hpp"
#include "scene/model/scene.hpp"

// What a half-typed scene becomes so that it can be evaluated and drawn.
namespace sarsim::picture {

/// Beyond it a scene's times are no times [s].
inline constexpr double longest_time_s = 1e9;

/// True where all three are.
[[nodiscard]] bool is_finite(const core::Vec3& v);
/// The number, or 0 where it is not finite.
[[nodiscard]] double finite_or_zero(double value);
/// The same of each of three.
[[nodiscard]] core::Vec3 finite_or_zero(const core::Vec3& v);

/// Only what drawing needs: the beam and the transmit antenna. It stands on the world, whose name always resolves.
[[nodiscard]] scene::Radar cleaned(const scene::Radar& radar);

/// The platforms and choices of a scene alone, so that resolving it fills no surfaces.
[[nodiscard]] scene::Scene frames_of(const scene::Scene& scene);

/// A path that is half typed, or whose file is not read, cannot be drawn: such platforms stay where they are.
void put_to_rest(scene::Scene& frames);

}  // namespace sarsim::picture
