#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "core/report/problem.hpp"

namespace sarsim::simulate {

/// The strongest echo that is recorded, sqrt(W): many of these together still fit a single-precision number.
inline constexpr double strongest_echo_v = 1e30;

/// What decides whether an echo can be computed at all.
struct EchoExtremes {
  double distance_m = 0.0;   ///< The smallest.
  double speed_mps = 0.0;    ///< The largest radial speed, either sign.
  double amplitude_v = 0.0;  ///< The largest.
};

/// Whether echoes with these extremes are computed: a distance above zero, slower than light, finite; false for NaN.
[[nodiscard]] inline bool possible_echo(const EchoExtremes& echo, double light_speed_mps) {
  return echo.distance_m > 0.0 && echo.speed_mps < light_speed_mps && echo.speed_mps > -light_speed_mps &&
         echo.amplitude_v <= strongest_echo_v;
}

/// Says what is impossible about the echoes of an object of the scene.
/// @param kind  "target" or "surface"
[[nodiscard]] core::Problem problem_of_echo(std::string_view kind, std::size_t index, std::string_view radar,
                                            const EchoExtremes& echo, double light_speed_mps);

/// " (pulse 12, 0.25 s)": which one it is, behind the message.
[[nodiscard]] std::string text_of_pulse(std::int64_t pulse, double time_s);

/// Thrown where a pulse meets an impossible echo that the survey of some pulses did not see.
struct ImpossibleEcho : std::runtime_error {
  explicit ImpossibleEcho(core::Problem p) : std::runtime_error(p.message), problem(std::move(p)) {}
  core::Problem problem;
};

}  // namespace sarsim::simulate
