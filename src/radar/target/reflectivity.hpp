#pragma once

#include "core/maths/interpolator.hpp"
#include "core/maths/vector.hpp"

namespace sarsim::radar {

/// How the cross-section of a scatterer depends on the incidence angle (thesis 4.2).
enum class ReflectivityLaw { isotropic, cosine, user };

/// Angle between a scatterer's normal and the direction back to the radar, rad: 0 faces the radar, pi faces away.
/// @param normal_world  unit vector
/// @param look_world    from the radar to the scatterer; the null vector gives 0
[[nodiscard]] double incidence_rad(const core::Vec3& normal_world, const core::Vec3& look_world);

/// Factor on the cross-section at an incidence angle: 1; cos, nothing from behind; 10^(D/10) of the user's curve D [dB]
/// over the angle in degrees.
[[nodiscard]] double reflectivity(ReflectivityLaw law, const core::Interpolator& gain_db, double incidence_rad);

}  // namespace sarsim::radar
