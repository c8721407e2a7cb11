#include "scene/script/read_commands.hpp"

namespace sarsim::scene::script {

void read_simulation(Reading& reading, const Token& command, Scene& scene) {
  FieldReader reader(reading, command, "simulation", scene.simulations.size());
  Simulation simulation;
  if (reader.leading_name(field_of<&Simulation::radar>().in_script, simulation.radar)) {
    reader.read(simulation_order().always, simulation);
    // Programs before October 1998 wrote neither, those of that summer only the first.
    for (const FieldOf<Simulation>* const field : simulation_order().since_1998)
      if (reader.more()) reader.read(*field, simulation);
    scene.simulations.push_back(std::move(simulation));
  }
  reader.finish();
}

void read_geometry(Reading& reading, const Token& command, Scene& scene) {
  FieldReader reader(reading, command, "geometry", scene.geometries.size());
  GeometryTable table;
  if (reader.leading_name(field_of<&GeometryTable::radar>().in_script, table.radar)) {
    reader.read(geometry_order(), table);
    scene.geometries.push_back(std::move(table));
  }
  reader.finish();
}

}  // namespace sarsim::scene::script
