#pragma once

#include <optional>
#include <string>

#include "core/report/problem.hpp"
#include "scene/model/scene.hpp"
#include "scene/schema/field_names.hpp"

namespace sarsim::workflow {

/// A number without a unit counts in the base unit, whatever the unit of a script is. A warning where it is so far from
/// the script's value that another unit was probably meant: 10 000 times, or 30 times where it would be near that value
/// in the script's unit.
/// @param name  of the field, as it was typed
[[nodiscard]] std::optional<core::Problem> remark_on_bare_number(const scene::Scene& scene,
                                                                 const scene::NamedField& field,
                                                                 const std::string& name, const std::string& value);

}  // namespace sarsim::workflow
