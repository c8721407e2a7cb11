#include "scene/model/function_role.hpp"

#include <array>
#include <cmath>
#include <cstddef>

namespace sarsim::scene {

namespace {

using core::AngleRule;
using core::Beyond;

// Gains keep their last value; paths and rotations go on as they went; errors forget what is older than their envelope.
constexpr std::array table{
    FunctionEnds{FunctionRole::trajectory, Beyond::extended, {}, "goes on along straight lines"},
    FunctionEnds{FunctionRole::rotation, Beyond::extended, {}, "goes on at the last rate"},
    FunctionEnds{FunctionRole::beam_target, Beyond::extended, {}, "goes on along straight lines"},
    FunctionEnds{FunctionRole::position_envelope, Beyond::zero, {}, "is 0"},
    FunctionEnds{FunctionRole::rotation_envelope, Beyond::zero, {}, "is 0"},
    FunctionEnds{FunctionRole::pulse, Beyond::held, {}, "keeps the value of the nearer end"},
    FunctionEnds{FunctionRole::pulse_envelope, Beyond::held, {}, "keeps the value of the nearer end"},
    FunctionEnds{FunctionRole::window, Beyond::held, {}, "keeps the value of the nearer end"},
    FunctionEnds{FunctionRole::stc, Beyond::held, {}, "keeps the value of the nearer end"},
    FunctionEnds{FunctionRole::reflectivity, Beyond::held, {}, "keeps the value of the nearer end"},
    FunctionEnds{
        FunctionRole::azimuth_cut, Beyond::held, AngleRule::azimuth,
        "keeps the value of the nearer end, unless the gap over 180 deg is at most twice the largest spacing of "
        "the points: then it is interpolated across"},
    FunctionEnds{FunctionRole::elevation_cut, Beyond::held, AngleRule::elevation, "keeps the value of the nearer end"},
    FunctionEnds{FunctionRole::list, Beyond::extended, {}, "begins anew"},
};

constexpr bool in_order() {
  for (std::size_t i = 0; i < table.size(); ++i)
    if (static_cast<std::size_t>(table[i].role) != i) return false;
  return true;
}
static_assert(in_order());

}  // namespace

const FunctionEnds& function_ends(FunctionRole role) { return table.at(static_cast<std::size_t>(role)); }

core::InterpolationRules rules_for(FunctionRole role, core::InterpolationRules usual, bool by_role) {
  const core::Beyond beyond = function_ends(role).beyond;
  // What is older than an envelope counts in no profile.
  usual.beyond = by_role || beyond == core::Beyond::zero ? beyond : core::Beyond::extended;
  return usual;
}

core::AngleFunction angle_function(FunctionRole role, const core::SampledFunction& function,
                                   core::InterpolationRules usual, bool by_role) {
  return {function, rules_for(role, usual, by_role), by_role ? function_ends(role).angles : core::AngleRule::magnitude};
}

std::function<double(double)> evaluated(FunctionRole role, const core::SampledFunction& function,
                                        core::InterpolationRules usual, bool by_role) {
  if (role != FunctionRole::azimuth_cut && role != FunctionRole::elevation_cut)
    return [curve = core::Interpolator(function, rules_for(role, usual, by_role))](double x) { return curve.value(x); };
  return [cut = angle_function(role, function, usual, by_role)](double x) {
    return cut.value(std::abs(x) <= 180.0 ? x : std::remainder(x, 360.0));
  };
}

}  // namespace sarsim::scene
