#include "simulate/resolve/impossible_echo.hpp"

#include <cmath>

#include <fmt/format.h>

#include "core/report/expect.hpp"
#include "core/text/number_text.hpp"

namespace sarsim::simulate {

core::Problem problem_of_echo(std::string_view kind, std::size_t index, std::string_view radar,
                              const EchoExtremes& echo, double light_speed_mps) {
  CORE_EXPECT(light_speed_mps > 0.0);
  core::Problem problem;
  problem.subject = {std::string(kind), index, kind == "target" ? "position_m" : "corner_m"};
  const double speed_mps = std::abs(echo.speed_mps);
  if (!(speed_mps < light_speed_mps)) {
    problem.id = "echo.faster-than-light";
    problem.message = fmt::format("the {} moves as fast as light, or faster, relative to radar '{}'", kind, radar);
    problem.found = fmt::format("{:.6g} m/s", speed_mps);
    problem.expected = fmt::format("below {} m/s", core::format_number(light_speed_mps));
    problem.hint = "check the paths and rotation rates of its platform and of the radar's: times are in seconds";
  } else if (!(echo.distance_m > 0.0)) {
    problem.id = "echo.no-distance";
    problem.message = fmt::format("the {} is at the position of radar '{}'; its echo would be infinite", kind, radar);
    problem.found = fmt::format("distance {} m", core::format_number(echo.distance_m));
    problem.expected = "a distance above 0";
    problem.hint = fmt::format("move the {} or the radar's platform", kind);
  } else {
    problem.id = "echo.too-strong";
    problem.message = fmt::format("the echo of the {} in radar '{}' is too strong to be recorded", kind, radar);
    problem.found = fmt::format("{:.3g} V", echo.amplitude_v);
    problem.expected = fmt::format("up to {:g} V", strongest_echo_v);
    problem.hint = "check the reflectivity, the distance, and the radar's power and gains";
  }
  return problem;
}

std::string text_of_pulse(std::int64_t pulse, double time_s) {
  return fmt::format(" (pulse {}, {:g} s)", pulse, time_s);
}

}  // namespace sarsim::simulate
