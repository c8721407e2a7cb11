#include "scene/schema/function_table.hpp"

#include <limits>
#include <stdexcept>

namespace sarsim::scene::function_tables {

namespace {

namespace blocks = function_blocks;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::array<double, 2> anything{-infinity, infinity};
constexpr std::array<double, 2> seconds{0.0, 10.0};
constexpr std::array<double, 2> fraction{0.0, 1.0};
constexpr std::array<double, 2> first_pulses{0.0, 10.0};
constexpr std::array<double, 2> not_negative{0.0, infinity};
constexpr std::array<double, 2> kilometre{-1000.0, 1000.0};
constexpr std::array<double, 2> hundred_degrees{-100.0, 100.0};
constexpr std::array<double, 2> unit_either_way{-1.0, 1.0};
constexpr std::array<double, 2> full_circle{0.0, 360.0};

// Intervals and carriers have to be above zero; these are the least that an editor gives.
constexpr std::array<double, 2> intervals{1e-9, infinity};
constexpr std::array<double, 2> carriers{1.0, infinity};

constexpr std::array<std::string_view, 3> positions{"Position X", "Position Y", "Position Z"};
constexpr std::array<std::string_view, 3> rotations{"Rotation X", "Rotation Y", "Rotation Z"};
constexpr std::array<std::string_view, 3> cuts{"Gain (azimuth)", "Gain (elevation)", ""};

constexpr FunctionKind motion_kinds[] = {
    {ObjectKind::platform, "trajectory_m", "Trajectory", blocks::trajectory, "Time", positions, "m", Quantity::time,
     Quantity::length, seconds, kilometre, anything, anything},
    {ObjectKind::platform, "rotation_deg", "Rotation", blocks::rotation, "Time", rotations, "deg", Quantity::time,
     Quantity::angle, seconds, hundred_degrees, anything, anything},
    {ObjectKind::platform,
     "position_envelope",
     "Position error envelope",
     blocks::position_envelope,
     "Time before now",
     {"Error weight X", "Error weight Y", "Error weight Z"},
     "m/sqrt(s)",
     Quantity::time,
     Quantity::number,
     seconds,
     unit_either_way,
     anything,
     anything},
    {ObjectKind::platform,
     "rotation_envelope",
     "Rotation error envelope",
     blocks::rotation_envelope,
     "Time before now",
     {"Error weight X", "Error weight Y", "Error weight Z"},
     "deg/sqrt(s)",
     Quantity::time,
     Quantity::number,
     seconds,
     unit_either_way,
     anything,
     anything},
    {ObjectKind::target,
     "gain_db",
     "Reflectivity",
     blocks::target_gain,
     "Incidence angle",
     {"Reflectivity", "", ""},
     "dB",
     Quantity::angle,
     Quantity::ratio_db,
     {0.0, 180.0},
     {-100.0, 0.0},
     {0.0, 180.0},
     anything},
};

constexpr FunctionKind radar_kinds[] = {
    {ObjectKind::radar,
     "pulse_iq",
     "Pulse",
     blocks::pulse_iq,
     "Fraction of the pulse width",
     {"I", "Q", ""},
     "V",
     Quantity::number,
     Quantity::voltage,
     fraction,
     unit_either_way,
     fraction,
     anything},
    {ObjectKind::radar,
     "envelope_gain",
     "Pulse envelope",
     blocks::envelope_gain,
     "Fraction of the pulse width",
     {"Amplitude", "", ""},
     "",
     Quantity::number,
     Quantity::number,
     fraction,
     fraction,
     fraction,
     anything},
    {ObjectKind::radar,
     "pri_s",
     "Pulse repetition intervals",
     blocks::pri,
     "Pulse number",
     {"Interval", "", ""},
     "s",
     Quantity::number,
     Quantity::time,
     first_pulses,
     {0.0, 1e-3},
     anything,
     intervals},
    {ObjectKind::radar,
     "carrier_list_hz",
     "Carrier frequencies",
     blocks::carrier_list,
     "Pulse number",
     {"Frequency", "", ""},
     "Hz",
     Quantity::number,
     Quantity::frequency,
     first_pulses,
     {0.0, 2e9},
     anything,
     carriers},
    {ObjectKind::radar,
     "transmit_antenna.gain_db",
     "Transmit antenna",
     blocks::transmit_gain,
     "Offset",
     cuts,
     "dB",
     Quantity::angle,
     Quantity::ratio_db,
     full_circle,
     {0.0, 100.0},
     full_circle,
     anything},
    {ObjectKind::radar,
     "receive_antenna.gain_db",
     "Receive antenna",
     blocks::receive_gain,
     "Offset",
     cuts,
     "dB",
     Quantity::angle,
     Quantity::ratio_db,
     full_circle,
     {0.0, 100.0},
     full_circle,
     anything},
    {ObjectKind::radar, "beam_target_world_m", "Point looked at", blocks::beam_target, "Time", positions, "m",
     Quantity::time, Quantity::length, seconds, kilometre, anything, anything},
    {ObjectKind::radar,
     "window_gain",
     "Matched filter window",
     blocks::window_gain,
     "Fraction of the pulse width",
     {"Weight", "", ""},
     "",
     Quantity::number,
     Quantity::number,
     fraction,
     fraction,
     fraction,
     anything},
    {ObjectKind::radar,
     "stc_gain",
     "Sensitivity time control",
     blocks::stc_gain,
     "Range",
     {"Voltage gain", "", ""},
     "",
     Quantity::length,
     Quantity::number,
     {0.0, 10e3},
     fraction,
     not_negative,
     anything},
};

[[noreturn]] void no_such_function(std::string_view field) {
  throw std::invalid_argument("there is no user-defined function '" + std::string(field) + "' in this object");
}

// The overloads find a function in one kind of object; `visit` is called with it.
template <class Visit>
bool visit_function(auto& platform, std::string_view field, const Visit& visit) requires
    std::same_as<std::remove_const_t<std::remove_reference_t<decltype(platform)>>, Platform> {
  if (field == "trajectory_m") return visit(platform.trajectory_m), true;
  if (field == "rotation_deg") return visit(platform.rotation_deg), true;
  if (field == "position_envelope") return visit(platform.position_envelope), true;
  if (field == "rotation_envelope") return visit(platform.rotation_envelope), true;
  return false;
}

template <class Visit>
bool visit_function(auto& target, std::string_view field, const Visit& visit) requires
    std::same_as<std::remove_const_t<std::remove_reference_t<decltype(target)>>, Target> {
  if (field == "gain_db") return visit(target.gain_db), true;
  return false;
}

template <class Visit>
bool visit_function(auto& radar, std::string_view field, const Visit& visit) requires
    std::same_as<std::remove_const_t<std::remove_reference_t<decltype(radar)>>, Radar> {
  if (field == "pulse_iq") return visit(radar.pulse_iq), true;
  if (field == "envelope_gain") return visit(radar.envelope_gain), true;
  if (field == "pri_s") return visit(radar.pri_s), true;
  if (field == "carrier_list_hz") return visit(radar.carrier_list_hz), true;
  if (field == "transmit_antenna.gain_db") return visit(radar.transmit_antenna.gain_db), true;
  if (field == "receive_antenna.gain_db") return visit(radar.receive_antenna.gain_db), true;
  if (field == "beam_target_world_m") return visit(radar.beam_target_world_m), true;
  if (field == "window_gain") return visit(radar.window_gain), true;
  if (field == "stc_gain") return visit(radar.stc_gain), true;
  return false;
}

template <class Ref, class Object>
Ref find_function(Object& object, std::string_view field) {
  Ref ref{{}, nullptr};
  const auto take = [&](auto& function) { ref = {function.part, &function.file}; };
  const bool found = std::visit(
      [&](auto& alternative) {
        if constexpr (requires { visit_function(alternative, field, take); })
          return visit_function(alternative, field, take);
        else
          return false;
      },
      object);
  if (!found) no_such_function(field);
  return ref;
}

}  // namespace

const FunctionKind& function_kind(ObjectKind object, std::string_view field) {
  for (const std::span<const FunctionKind> kinds :
       {std::span<const FunctionKind>(motion_kinds), std::span<const FunctionKind>(radar_kinds)})
    for (const FunctionKind& kind : kinds)
      if (kind.object == object && kind.field == field) return kind;
  no_such_function(field);
}

FunctionRef function_in(AnyObject& object, std::string_view field) { return find_function<FunctionRef>(object, field); }

ConstFunctionRef function_in(const AnyObject& object, std::string_view field) {
  return find_function<ConstFunctionRef>(object, field);
}

}  // namespace sarsim::scene::function_tables
