#pragma once

#include "core/maths/interpolator.hpp"
#include "picture/figure/figure.hpp"
#include "scene/edit/function_model.hpp"

namespace sarsim::picture {

/// How a profile interpolates functions and continues them beyond their points.
struct FunctionProfile {
  core::InterpolationRules rules = {};
  bool ends_by_role = true;  ///< Beyond the points: by scene::FunctionEnds; false: extrapolated by the interpolation.
};

/// A user-defined function (thesis 4.6): a panel for each part, its points as crosses and the curve between them; of
/// functions of the pulse number bars. Parts that are constant are left out where others are not.
/// @param compare  all three interpolations, not only the one chosen
[[nodiscard]] Figure function_figure(const scene::FunctionInfo& info, const scene::FunctionDraft& function,
                                     const FunctionProfile& profile, bool compare);

}  // namespace sarsim::picture
