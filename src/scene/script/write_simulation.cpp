#include "scene/script/write_commands.hpp"

namespace sarsim::scene::script {

void write_command(ScriptLines& lines, const Simulation& simulation) {
  lines.plain("$SIMULATION");
  lines.fields(script_order<Simulation>(), simulation);
  lines.blank(2);
}

void write_command(ScriptLines& lines, const GeometryTable& table) {
  lines.plain("$GEOMETRY");
  lines.fields(script_order<GeometryTable>(), table);
  lines.blank(2);
}

}  // namespace sarsim::scene::script
