#pragma once

#include "scene/schema/field_table.hpp"

/// The parts of the radar's table. Internal to the fields_*.cpp files.
namespace sarsim::scene::radar_fields {

/// The two antennas.
void add_antennas(FieldTable<Radar>& table);
/// Where the beam points.
void add_direction(FieldTable<Radar>& table);
/// Window of the matched filter and sensitivity-time control.
void add_receiver(FieldTable<Radar>& table);
/// What a radar begins with where another alternative is chosen.
void begin_radar(const Radar& before, Radar& after);

}  // namespace sarsim::scene::radar_fields
