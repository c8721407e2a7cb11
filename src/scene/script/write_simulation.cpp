#include "scene/schema/scene_grammar.hpp"
#include "scene/script/write_commands.hpp"

namespace sarsim::scene::script {

void write_simulation(ScriptLines& lines, const Simulation& simulation) {
  namespace grammar = simulation_grammar;
  lines.plain("$SIMULATION");
  lines.name(grammar::radar, simulation.radar);
  lines.number(grammar::range_start, simulation.range_start_m);
  lines.number(grammar::range_end, simulation.range_end_m);
  lines.number(grammar::time_start, simulation.time_start_s);
  lines.number(grammar::time_end, simulation.time_end_s);
  lines.integer(grammar::bits, simulation.bits);
  lines.number(grammar::sample_rate, simulation.sample_rate_hz);
  lines.number(grammar::lsb, simulation.lsb_v);
  lines.choice(grammar::formats, simulation.format);
  lines.choice(grammar::processings, simulation.processing);
  lines.name(grammar::file, simulation.file);
  lines.choice(grammar::pulse_positions, simulation.pulse_position);
  lines.number(grammar::oversampling, simulation.oversampling);
  lines.number(grammar::width_factor, simulation.width_factor);
  lines.blank(2);
}

void write_geometry(ScriptLines& lines, const GeometryTable& table) {
  namespace grammar = geometry_grammar;
  lines.plain("$GEOMETRY");
  lines.name(grammar::radar, table.radar);
  lines.number(grammar::range_start, table.range_start_m);
  lines.number(grammar::range_end, table.range_end_m);
  lines.number(grammar::time_start, table.time_start_s);
  lines.number(grammar::time_end, table.time_end_s);
  lines.choice(grammar::separators, table.separator);
  lines.integer(grammar::columns, table.columns);
  lines.name(grammar::file, table.file);
  lines.blank(2);
}

}  // namespace sarsim::scene::script
