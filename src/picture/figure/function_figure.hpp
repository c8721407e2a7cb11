#pragma once

#include "core/maths/interpolator.hpp"
#include "picture/figure/figure.hpp"
#include "scene/edit/function_model.hpp"

namespace sarsim::picture {

/// A user-defined function (thesis 4.6): a panel for each part, its points as crosses and the curve between them; of
/// functions of the pulse number bars. Parts that are constant are left out where others are not.
/// @param rule     of low-pass interpolation
/// @param compare  all three interpolations, not only the one chosen
[[nodiscard]] Figure function_figure(const scene::FunctionInfo& info, const scene::FunctionDraft& function,
                                     core::InterpolationRules rule, bool compare);

}  // namespace sarsim::picture
