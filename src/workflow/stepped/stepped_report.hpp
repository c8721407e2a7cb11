#pragma once

#include "core/text/facts.hpp"
#include "workflow/stepped/isar.hpp"
#include "workflow/stepped/profiles.hpp"

namespace sarsim::workflow {

/// What `isar` reports.
[[nodiscard]] core::Facts facts_of(const IsarReport& report);

/// An image of it.
/// @param alone  it is the only one, and people read of it among the facts of the report
[[nodiscard]] core::Facts facts_of(const WrittenIsarImage& written, bool alone);

/// A target of the scene in an image.
[[nodiscard]] core::Facts facts_of(const HeldPoint& point);

/// What `profiles` reports.
[[nodiscard]] core::Facts facts_of(const ProfilesReport& report);

/// A target of the scene in a profile.
[[nodiscard]] core::Facts facts_of(const HeldTarget& target);

/// Targets of the scene in a profile: a line of names, then one of numbers for each, with commas; what does not exist
/// is empty.
[[nodiscard]] std::string csv_of(const std::vector<HeldTarget>& targets);

}  // namespace sarsim::workflow
