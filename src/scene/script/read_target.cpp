#include "scene/script/read_commands.hpp"

namespace sarsim::scene::script {

void read_target(Reading& reading, const Token& command, Scene& scene) {
  FieldReader reader(reading, command, "target", scene.targets.size());
  Target target;
  if (reader.leading_name(field_of<&Target::platform>().in_script, target.platform)) {
    for (const Row<Target>& row : target_rows()) reader.read(row.fields, target);
    scene.targets.push_back(std::move(target));
  }
  reader.finish();
}

void read_surface(Reading& reading, const Token& command, Scene& scene) {
  FieldReader reader(reading, command, "surface", scene.surfaces.size());
  Surface surface;
  if (reader.leading_name(field_of<&Surface::platform>().in_script, surface.platform)) {
    for (const Row<Surface>& row : surface_rows()) reader.read(row.fields, surface);
    scene.surfaces.push_back(std::move(surface));
  }
  reader.finish();
}

}  // namespace sarsim::scene::script
