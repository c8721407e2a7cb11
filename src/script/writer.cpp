#include "script/writer.hpp"

#include <fmt/format.h>

#include "base/version.hpp"
#include "script/write_commands.hpp"

namespace sarsim {

namespace {

using namespace script;

template <class Object>
void write_all(ScriptLines& lines, const std::vector<Object>& objects, void (*write)(ScriptLines&, const Object&)) {
  for (const Object& object : objects) write(lines, object);
  if (!objects.empty()) lines.blank();
}

}  // namespace

std::string write_script(const Scene& scene) {
  ScriptLines lines;
  lines.plain(fmt::format("! Radar scene, written by Sarsim {}", program_version));
  lines.plain("! Angles: azimuth from +y towards +x, elevation from the x-y plane upwards");
  lines.blank(2);
  write_all(lines, scene.platforms, write_platform);
  write_all(lines, scene.surfaces, write_surface);
  write_all(lines, scene.targets, write_target);
  for (const Radar& radar : scene.radars) write_radar(lines, radar);
  for (const Simulation& simulation : scene.simulations) write_simulation(lines, simulation);
  for (const GeometryTable& table : scene.geometries) write_geometry(lines, table);
  write_options(lines, scene.options);
  return lines.take();
}

}  // namespace sarsim
