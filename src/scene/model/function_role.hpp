#pragma once

#include <functional>
#include <span>
#include <string_view>

#include "core/maths/angle_function.hpp"

namespace sarsim::scene {

/// Use of a user-defined function of a scene.
enum class FunctionRole {
  trajectory,
  rotation,
  beam_target,
  position_envelope,
  rotation_envelope,
  pulse,
  pulse_envelope,
  window,
  stc,
  reflectivity,
  azimuth_cut,
  elevation_cut,
  list,  ///< Of pulse repetition intervals, or of carriers: y of each pulse in turn.
};

/// Values of such a function beyond its first and last point, in the profile `physical`. The profile `classic`
/// extrapolates all but lists and error envelopes by their interpolation method, and evaluates antennas at the
/// magnitude of the angle.
struct FunctionEnds {
  FunctionRole role;
  core::Beyond beyond = core::Beyond::held;
  core::AngleRule angles = core::AngleRule::magnitude;  ///< Of cuts through an antenna's pattern.
  std::string_view words;  ///< Predicate for messages: "keeps the value of the nearer end".
};

/// The entry of a role.
[[nodiscard]] const FunctionEnds& function_ends(FunctionRole role);

/// The rules of a function for its role.
/// @param usual    LowPassRule and CubicEnds; Beyond is replaced
/// @param by_role  by the table (`physical`); otherwise by the method (`classic`)
[[nodiscard]] core::InterpolationRules rules_for(FunctionRole role, core::InterpolationRules usual,
                                                 bool by_role = true);

/// The same for a cut through an antenna's pattern or another function of an angle.
[[nodiscard]] core::AngleFunction angle_function(FunctionRole role, const core::SampledFunction& function,
                                                 core::InterpolationRules usual, bool by_role = true);

/// Any function as it is used, of x in the unit of its points; angles are wrapped to -180 to 180 degrees.
[[nodiscard]] std::function<double(double)> evaluated(FunctionRole role, const core::SampledFunction& function,
                                                      core::InterpolationRules usual, bool by_role = true);

}  // namespace sarsim::scene
