#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scene/schema/field_table.hpp"

/// The order in which scripts give the fields of an object, for reader and writer alike.
namespace sarsim::scene::script {

/// Some fields of a kind of object, one behind the other.
template <class Object>
using Order = std::vector<const FieldOf<Object>*>;

/// The order of `$PLATFORM`, behind the name; before 1998 without the kind of rotation and the rates.
struct PlatformOrder {
  Order<Platform> path;
  Order<Platform> rotation;
  Order<Platform> errors;
};
[[nodiscard]] const PlatformOrder& platform_order();

/// Fields that the writer puts on one line.
template <class Object>
struct Row {
  Order<Object> fields;           ///< Numbers and vectors, which mean something together, all in the unit of the first.
  std::string_view comment = {};  ///< Beside them, behind the unit; empty: a line and a comment for each field.
};

/// The order of `$TARGET`, behind the platform.
[[nodiscard]] const std::vector<Row<Target>>& target_rows();

/// The order of `$CLOUD`, behind the platform and the file.
[[nodiscard]] const std::vector<Row<Cloud>>& cloud_rows();

/// The order of `$SURFACE`, behind the platform.
[[nodiscard]] const std::vector<Row<Surface>>& surface_rows();

/// The order of `$RADAR`, behind the name.
struct RadarOrder {
  Order<Radar> up_to_power;
  Order<Radar> gains;  ///< Both or neither.
  Order<Radar> losses;
  Order<Radar> transmit_antenna;
  Order<Radar> receive_antenna;  ///< Behind its pattern, with which SAME is an alternative.
  Order<Radar> direction_and_window;
  Order<Radar> stc;  ///< Behind its kind, which is said with one keyword or two.
};
[[nodiscard]] const RadarOrder& radar_order();

/// The order of `$SIMULATION`, behind the radar. The last two may be missing.
struct SimulationOrder {
  Order<Simulation> always;
  Order<Simulation> since_1998;
};
[[nodiscard]] const SimulationOrder& simulation_order();

/// The order of `$GEOMETRY`, behind the radar.
[[nodiscard]] const Order<GeometryTable>& geometry_order();

/// Every field of a kind of object in the order of its command.
template <class Object>
[[nodiscard]] Order<Object> script_order();
template <>
Order<Platform> script_order();
template <>
Order<Target> script_order();
template <>
Order<Cloud> script_order();
template <>
Order<Surface> script_order();
template <>
Order<Radar> script_order();
template <>
Order<Simulation> script_order();
template <>
Order<GeometryTable> script_order();
template <>
Order<RunOptions> script_order();

/// The key of a field of `$OPTIONS`.
[[nodiscard]] std::string option_key(const FieldSpec& spec);

/// What a script calls a field of an object.
template <class Object>
[[nodiscard]] const Field& parameter(const FieldOf<Object>& field, const Object&) {
  return field.in_script;
}
/// The carrier is the first of several where it is stepped.
[[nodiscard]] const Field& parameter(const FieldOf<Radar>& field, const Radar& radar);

}  // namespace sarsim::scene::script
