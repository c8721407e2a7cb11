#pragma once

#include <string>
#include <vector>

#include "workflow/stepped/isar.hpp"
#include "workflow/stepped/profiles.hpp"

namespace sarsim::workflow {

/// What `isar` reports, as a JSON object.
[[nodiscard]] std::string json_of(const IsarReport& report);

/// What `profiles` reports, as a JSON object.
[[nodiscard]] std::string json_of(const ProfilesReport& report);

/// Targets of the scene in a profile: a line of names, then one of numbers for each, with commas; what does not exist
/// is empty.
[[nodiscard]] std::string csv_of(const std::vector<HeldTarget>& targets);

}  // namespace sarsim::workflow
