#pragma once

#include <string>

#include "workflow/sweep/swept_field.hpp"

namespace sarsim::workflow {

/// The fields of a scene that can be set, a line for each: its shortest name, its value and, for numbers, the units
/// that are understood. Fields that mean nothing with the alternatives that are chosen are left out; of many targets or
/// surfaces the first few are listed. Names of [let] come last.
[[nodiscard]] std::string field_list(const NamedThings& things);

}  // namespace sarsim::workflow
