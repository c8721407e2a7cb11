#pragma once

#include <string_view>
#include <vector>

#include "scene/model/object.hpp"
#include "scene/schema/field_table.hpp"

namespace sarsim::scene {

/// A kind of object: its names, its list in a scene, its fields.
template <class Object>
struct Kind {
  ObjectKind kind;
  std::string_view command;  ///< Of the script language, without `$`.
  std::string_view meaning;
  std::vector<Object> Scene::*list;

  /// "platform", "target", ...
  [[nodiscard]] std::string_view name() const { return name_of(kind); }
  [[nodiscard]] const FieldTable<Object>& table() const { return table_of<Object>(); }
};

/// Calls `visit` with each Kind, in the order of ObjectKind.
template <class Visit>
void for_each_kind(Visit&& visit) {
  visit(
      Kind<Platform>{ObjectKind::platform, "PLATFORM", "A frame that carries targets and radars.", &Scene::platforms});
  visit(Kind<Target>{ObjectKind::target, "TARGET", "A point that reflects.", &Scene::targets});
  visit(Kind<Surface>{ObjectKind::surface, "SURFACE", "A triangle that reflects.", &Scene::surfaces});
  visit(Kind<Radar>{ObjectKind::radar, "RADAR", "A transmitter and receiver.", &Scene::radars});
  visit(Kind<Simulation>{ObjectKind::simulation, "SIMULATION", "A recording to be made.", &Scene::simulations});
  visit(Kind<GeometryTable>{ObjectKind::geometry, "GEOMETRY", "A table of delays, amplitudes and speeds to be made.",
                            &Scene::geometries});
}

}  // namespace sarsim::scene
