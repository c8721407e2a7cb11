#include "scene/schema/function_table.hpp"

#include <limits>
#include <stdexcept>

#include "scene/schema/field_table.hpp"

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
constexpr std::array<double, 2> half_turns{-180.0, 180.0};
constexpr std::array<double, 2> whole_turns{-360.0, 360.0};

// Intervals and carriers have to be above zero; these are the least that an editor gives.
constexpr std::array<double, 2> intervals{1e-9, infinity};
constexpr std::array<double, 2> carriers{1.0, infinity};

constexpr std::array<std::string_view, 3> positions{"Position X", "Position Y", "Position Z"};
constexpr std::array<std::string_view, 3> rotations{"Rotation X", "Rotation Y", "Rotation Z"};
constexpr std::array<std::string_view, 3> cuts{"Gain (azimuth)", "Gain (elevation)", ""};

constexpr FunctionKind kinds[] = {
    {"Trajectory", blocks::trajectory, "Time", positions, Quantity::time, Quantity::length, seconds, kilometre,
     anything, anything},
    {"Rotation", blocks::rotation, "Time", rotations, Quantity::time, Quantity::angle, seconds, hundred_degrees,
     anything, anything},
    {"Position error envelope",
     blocks::position_envelope,
     "Time before now",
     {"Error weight X", "Error weight Y", "Error weight Z"},
     Quantity::time,
     Quantity::number,
     seconds,
     unit_either_way,
     anything,
     anything},
    {"Rotation error envelope",
     blocks::rotation_envelope,
     "Time before now",
     {"Error weight X", "Error weight Y", "Error weight Z"},
     Quantity::time,
     Quantity::number,
     seconds,
     unit_either_way,
     anything,
     anything},
    {"Reflectivity",
     blocks::target_gain,
     "Incidence angle",
     {"Reflectivity", "", ""},
     Quantity::angle,
     Quantity::ratio_db,
     {0.0, 180.0},
     {-100.0, 0.0},
     {0.0, 180.0},
     anything},
    {"Pulse",
     blocks::pulse_iq,
     "Fraction of the pulse width",
     {"I", "Q", ""},
     Quantity::number,
     Quantity::voltage,
     fraction,
     unit_either_way,
     fraction,
     anything},
    {"Pulse envelope",
     blocks::envelope_gain,
     "Fraction of the pulse width",
     {"Amplitude", "", ""},
     Quantity::number,
     Quantity::number,
     fraction,
     fraction,
     fraction,
     anything},
    {"Pulse repetition intervals",
     blocks::pri,
     "Pulse number",
     {"Interval", "", ""},
     Quantity::number,
     Quantity::time,
     first_pulses,
     {0.0, 1e-3},
     anything,
     intervals},
    {"Carrier frequencies",
     blocks::carrier_list,
     "Pulse number",
     {"Frequency", "", ""},
     Quantity::number,
     Quantity::frequency,
     first_pulses,
     {0.0, 2e9},
     anything,
     carriers},
    {"Transmit antenna",
     blocks::transmit_gain,
     "Offset",
     cuts,
     Quantity::angle,
     Quantity::ratio_db,
     half_turns,
     {0.0, 100.0},
     whole_turns,
     anything},
    {"Receive antenna",
     blocks::receive_gain,
     "Offset",
     cuts,
     Quantity::angle,
     Quantity::ratio_db,
     half_turns,
     {0.0, 100.0},
     whole_turns,
     anything},
    {"Look-at point", blocks::beam_target, "Time", positions, Quantity::time, Quantity::length, seconds, kilometre,
     anything, anything},
    {"Matched filter window",
     blocks::window_gain,
     "Fraction of the pulse width",
     {"Weight", "", ""},
     Quantity::number,
     Quantity::number,
     fraction,
     fraction,
     fraction,
     anything},
    {"Sensitivity time control",
     blocks::stc_gain,
     "Range",
     {"Voltage gain", "", ""},
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

template <class Object>
const FieldOf<Object>& function_field(std::string_view id) {
  for (const FieldOf<Object>& field : table_of<Object>().fields())
    if (field.function != nullptr && field.spec.id == id) return field;
  no_such_function(id);
}

}  // namespace

const FunctionKind& function_kind(const AnyObject& object, std::string_view field) {
  const FunctionBlock* const block =
      std::visit([&]<class Object>(const Object&) { return function_field<Object>(field).spec.block; }, object);
  for (const FunctionKind& kind : kinds)
    if (&kind.block == block) return kind;
  no_such_function(field);
}

std::string_view y_unit(const FunctionKind& kind, std::size_t part) {
  return kind.block.y_shift == 0 ? kind.block.y[part].unit : units_of(kind.y_quantity).front();
}

FunctionRef function_in(AnyObject& object, std::string_view field) {
  return std::visit(
      [&]<class Object>(Object& alternative) {
        const FieldOf<Object>& known = function_field<Object>(field);
        return known.function(alternative);
      },
      object);
}

ConstFunctionRef function_in(const AnyObject& object, std::string_view field) {
  return std::visit(
      [&]<class Object>(const Object& alternative) {
        return std::get<ConstFunctionRef>(function_field<Object>(field).get(alternative));
      },
      object);
}

}  // namespace sarsim::scene::function_tables
