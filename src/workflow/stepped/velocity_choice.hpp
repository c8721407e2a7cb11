#pragma once

#include <string>

#include "workflow/stepped/profile_series.hpp"

namespace sarsim::workflow {

/// The radial speed that profiles are to be made for.
struct VelocityChoice {
  SeriesOptions::Velocity velocity = SeriesOptions::Velocity::none;
  double speed_mps = 0.0;      ///< Velocity::given, positive receding.
  std::string words = "none";  ///< How files name it.
};

/// none, scene, estimated or a number of m/s; throws core::InvalidRequest for anything else.
[[nodiscard]] VelocityChoice velocity_choice(const std::string& text);

/// Throws core::InvalidRequest where a speed to look through is none, above 0 and below 1e6 m/s.
void expect_speed(double fastest_mps);

/// Throws core::InvalidRequest where a search for the speed of such bursts would try too many.
void expect_searchable(double fastest_mps, const SteppedRows& rows);

}  // namespace sarsim::workflow
