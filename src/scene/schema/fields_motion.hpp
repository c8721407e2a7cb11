#pragma once

#include "scene/schema/field_table.hpp"

/// The fields of platforms that the script language does not have, group by group; each behind the choice it depends
/// on.
namespace sarsim::scene {

/// Those that depend on `Platform::path`.
void add_paths(FieldTable<Platform>& table);
/// Those that depend on `Platform::rotation_kind`.
void add_attitude_laws(FieldTable<Platform>& table);
/// Those that depend on `Platform::position_error`.
void add_gusts(FieldTable<Platform>& table);
/// Oscillations, waves and navigation.
void add_perturbations(FieldTable<Platform>& table);

}  // namespace sarsim::scene
