#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <string_view>

#include "scene/model/function_role.hpp"

namespace sarsim::scene {

/// One axis of a user-defined function.
struct FunctionAxis {
  std::string_view name;
  std::string_view unit;  ///< Empty for a pure number.
};

/// What a user-defined function block holds: one to three functions of the same variable.
struct FunctionBlock {
  std::string_view words;  ///< What the functions are, together.
  FunctionRole role;       ///< Of the first; see `role_of`.
  std::size_t count = 1;   ///< Functions of the block.
  FunctionAxis x;
  std::array<FunctionAxis, 3> y;   ///< The first `count` are used.
  bool x_ignored = false;          ///< A list: only the order of the points matters.
  int y_shift = 0;                 ///< Decimal exponent from y in the script to y in the scene.
  std::string_view list_key = {};  ///< Of a list: what format 2 calls its values.
  double likely_low = -std::numeric_limits<double>::infinity();  ///< Values of y that are not suspicious, in the
  double likely_high = std::numeric_limits<double>::infinity();  ///< unit in which the scene holds them.
};

/// Role of one of the functions of a block: of an antenna the first is the cut in azimuth, the second in elevation.
[[nodiscard]] constexpr FunctionRole role_of(const FunctionBlock& block, std::size_t part) {
  return block.role == FunctionRole::azimuth_cut && part == 1 ? FunctionRole::elevation_cut : block.role;
}

/// The fourteen blocks of the script language, by the member of the scene that they fill.
namespace function_blocks {

inline constexpr FunctionAxis time{"time", "s"};
inline constexpr FunctionAxis lag{"time before now", "s"};
inline constexpr FunctionAxis pulse_fraction{"fraction of the pulse width", ""};
inline constexpr FunctionAxis pulse_number{"pulse number", ""};
inline constexpr FunctionAxis offset_angle{"angle off the beam", "deg"};
inline constexpr std::array<FunctionAxis, 3> position{{{"position x", "m"}, {"position y", "m"}, {"position z", "m"}}};

inline constexpr FunctionBlock target_gain{"reflectivity of the target",
                                           FunctionRole::reflectivity,
                                           1,
                                           {"incidence angle", "deg"},
                                           {{{"reflectivity", "dB"}}}};

inline constexpr FunctionBlock trajectory{"trajectory", FunctionRole::trajectory, 3, time, position};
inline constexpr FunctionBlock rotation{"rotation of the platform",
                                        FunctionRole::rotation,
                                        3,
                                        time,
                                        {{{"rotation x", "deg"}, {"rotation y", "deg"}, {"rotation z", "deg"}}}};
inline constexpr FunctionBlock position_envelope{
    "envelope of the position errors",
    FunctionRole::position_envelope,
    3,
    lag,
    {{{"error weight x", "m/sqrt(s)"}, {"error weight y", "m/sqrt(s)"}, {"error weight z", "m/sqrt(s)"}}}};
inline constexpr FunctionBlock rotation_envelope{
    "envelope of the rotation errors",
    FunctionRole::rotation_envelope,
    3,
    lag,
    {{{"error weight x", "deg/sqrt(s)"}, {"error weight y", "deg/sqrt(s)"}, {"error weight z", "deg/sqrt(s)"}}}};

inline constexpr FunctionBlock pulse_iq{"pulse", FunctionRole::pulse, 2, pulse_fraction, {{{"I", "V"}, {"Q", "V"}}}};
inline constexpr FunctionBlock envelope_gain{
    "pulse envelope", FunctionRole::pulse_envelope, 1, pulse_fraction, {{{"amplitude", ""}}}};
inline constexpr FunctionBlock pri{"pulse repetition intervals",
                                   FunctionRole::list,
                                   1,
                                   pulse_number,
                                   {{{"interval", "s"}}},
                                   true,
                                   0,
                                   "intervals",
                                   1e-6,
                                   1.0};
inline constexpr FunctionBlock carrier_list{"carrier frequencies",
                                            FunctionRole::list,
                                            1,
                                            pulse_number,
                                            {{{"frequency", "GHz"}}},
                                            true,
                                            9,
                                            "frequencies",
                                            1e6,
                                            1e12};
inline constexpr FunctionBlock transmit_gain{"gain of the transmit antenna",
                                             FunctionRole::azimuth_cut,
                                             2,
                                             offset_angle,
                                             {{{"gain in azimuth", "dB"}, {"gain in elevation", "dB"}}}};
inline constexpr FunctionBlock receive_gain{"gain of the receive antenna",
                                            FunctionRole::azimuth_cut,
                                            2,
                                            offset_angle,
                                            {{{"gain in azimuth", "dB"}, {"gain in elevation", "dB"}}}};
inline constexpr FunctionBlock beam_target{"point the beam looks at", FunctionRole::beam_target, 3, time, position};
inline constexpr FunctionBlock window_gain{
    "matched-filter window", FunctionRole::window, 1, pulse_fraction, {{{"weight", ""}}}};
inline constexpr FunctionBlock stc_gain{
    "sensitivity-time control", FunctionRole::stc, 1, {"range", "m"}, {{{"voltage gain", ""}}}};

inline constexpr std::array<const FunctionBlock*, 14> all{
    &target_gain, &trajectory,   &rotation,      &position_envelope, &rotation_envelope, &pulse_iq,    &envelope_gain,
    &pri,         &carrier_list, &transmit_gain, &receive_gain,      &beam_target,       &window_gain, &stc_gain};

}  // namespace function_blocks

}  // namespace sarsim::scene
