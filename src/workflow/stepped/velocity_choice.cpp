#include "workflow/stepped/velocity_choice.hpp"

#include <cmath>

#include <fmt/format.h>

#include "core/report/invalid_request.hpp"
#include "core/text/number_text.hpp"

namespace sarsim::workflow {

VelocityChoice velocity_choice(const std::string& text) {
  using Velocity = SeriesOptions::Velocity;
  if (core::equal_ignoring_case(text, "none")) return {Velocity::none, 0.0, text};
  if (core::equal_ignoring_case(text, "scene")) return {Velocity::scene, 0.0, text};
  if (core::equal_ignoring_case(text, "estimated")) return {Velocity::estimated, 0.0, text};
  const auto number = core::parse_number(text);
  if (number && std::abs(*number) < 1e6) return {Velocity::given, *number, text};
  throw core::InvalidRequest(fmt::format("--velocity: invalid '{}'", text),
                             "none, scene, estimated or a number of m/s, positive receding");
}

void expect_speed(double fastest_mps) {
  if (!(fastest_mps > 0.0 && fastest_mps < 1e6))
    throw core::InvalidRequest(fmt::format("--fastest: {} m/s is out of range", fastest_mps), "above 0, below 1e6");
}

void expect_searchable(double fastest_mps, const SteppedRows& rows) {
  const double max_mps = fastest_searched_mps(rows);
  if (fastest_mps <= max_mps) return;
  throw core::InvalidRequest(
      fmt::format("--fastest: up to {} m/s, bursts this long resolve too many speeds to try them all",
                  core::format_number(fastest_mps)),
      fmt::format("at most {:.6g} m/s", max_mps));
}

}  // namespace sarsim::workflow
