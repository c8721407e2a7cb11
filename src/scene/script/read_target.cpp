#include <array>

#include "scene/model/object.hpp"
#include "scene/script/read_commands.hpp"

namespace sarsim::scene::script {

void read_target(Reading& reading, const Token& command, Scene& scene) {
  FieldReader reader(reading, command, "target", scene.targets.size());
  std::string carrier = world_name();
  if (reader.leading_name(field_of<&Target::platform>().in_script, carrier)) {
    Target target;
    target.platform = std::move(carrier);
    for (const Row<Target>& row : target_rows()) reader.read(row.fields, target);
    if (!scene.targets.empty()) share_equal(target, scene.targets.back());
    scene.targets.push_back(std::move(target));
  }
  reader.finish();
}

void read_cloud(Reading& reading, const Token& command, Scene& scene) {
  FieldReader reader(reading, command, "cloud", scene.clouds.size());
  Cloud cloud;
  if (reader.leading_name(field_of<&Cloud::platform>().in_script, cloud.platform)) {
    const auto& file = field_of<&Cloud::file>();
    static constexpr std::array<std::string_view, 1> source{cloud_source};
    if (reader.keyword(file.in_script, source) == 0) reader.read(file, cloud);
    for (const Row<Cloud>& row : cloud_rows()) reader.read(row.fields, cloud);
    scene.clouds.push_back(std::move(cloud));
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
