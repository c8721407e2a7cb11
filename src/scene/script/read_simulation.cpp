#include "scene/schema/scene_grammar.hpp"
#include "scene/script/read_commands.hpp"

namespace sarsim::scene::script {

void read_simulation(Reading& reading, const Token& command, Scene& scene) {
  namespace grammar = simulation_grammar;
  FieldReader reader(reading, command, "simulation", scene.simulations.size());
  Simulation simulation;
  if (reader.leading_name(grammar::radar, simulation.radar)) {
    reader.number(grammar::range_start, simulation.range_start_m);
    reader.number(grammar::range_end, simulation.range_end_m);
    reader.number(grammar::time_start, simulation.time_start_s);
    reader.number(grammar::time_end, simulation.time_end_s);
    reader.integer(grammar::bits, simulation.bits);
    reader.number(grammar::sample_rate, simulation.sample_rate_hz);
    reader.number(grammar::lsb, simulation.lsb_v);
    reader.choice(grammar::format, grammar::formats, simulation.format);
    reader.choice(grammar::processing, grammar::processings, simulation.processing);
    reader.text(grammar::file, simulation.file);
    reader.choice(grammar::pulse_position, grammar::pulse_positions, simulation.pulse_position);
    // Programs before October 1998 wrote neither, those of that summer only the first.
    if (reader.more()) reader.number(grammar::oversampling, simulation.oversampling);
    if (reader.more()) reader.number(grammar::width_factor, simulation.width_factor);
    scene.simulations.push_back(std::move(simulation));
  }
  reader.finish();
}

void read_geometry(Reading& reading, const Token& command, Scene& scene) {
  namespace grammar = geometry_grammar;
  FieldReader reader(reading, command, "geometry", scene.geometries.size());
  GeometryTable table;
  if (reader.leading_name(grammar::radar, table.radar)) {
    reader.number(grammar::range_start, table.range_start_m);
    reader.number(grammar::range_end, table.range_end_m);
    reader.number(grammar::time_start, table.time_start_s);
    reader.number(grammar::time_end, table.time_end_s);
    reader.choice(grammar::separator, grammar::separators, table.separator);
    reader.integer(grammar::columns, table.columns);
    reader.text(grammar::file, table.file);
    scene.geometries.push_back(std::move(table));
  }
  reader.finish();
}

}  // namespace sarsim::scene::script
