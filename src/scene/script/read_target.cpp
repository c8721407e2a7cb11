#include "scene/schema/scene_grammar.hpp"
#include "scene/script/read_commands.hpp"

namespace sarsim::scene::script {

namespace {

void read_direction(FieldReader& reader, Target& target) {
  namespace grammar = target_grammar;
  reader.angle(grammar::azimuth, target.azimuth);
  reader.angle(grammar::elevation, target.elevation);
  reader.angle(grammar::azimuth_stddev, target.azimuth_stddev);
  reader.angle(grammar::elevation_stddev, target.elevation_stddev);
  reader.choice(grammar::gain, grammar::gains, target.gain);
  if (target.gain == Target::Gain::user)
    reader.function(grammar::gain_user, function_blocks::target_gain, target.gain_db);
}

}  // namespace

void read_target(Reading& reading, const Token& command, Scene& scene) {
  namespace grammar = target_grammar;
  FieldReader reader(reading, command, "target", scene.targets.size());
  Target target;
  if (reader.leading_name(grammar::platform, target.platform)) {
    reader.vector(grammar::position, target.position_m);
    reader.vector(grammar::position_stddev, target.position_stddev_m);
    reader.number(grammar::rcs, target.rcs_m2);
    reader.number(grammar::rcs_stddev, target.rcs_stddev_m2);
    reader.choice(grammar::reflectivity, grammar::reflectivities, target.reflectivity);
    if (target.reflectivity == Target::Reflectivity::directional) read_direction(reader, target);
    scene.targets.push_back(std::move(target));
  }
  reader.finish();
}

void read_surface(Reading& reading, const Token& command, Scene& scene) {
  namespace grammar = surface_grammar;
  FieldReader reader(reading, command, "surface", scene.surfaces.size());
  Surface surface;
  if (reader.leading_name(grammar::platform, surface.platform)) {
    for (core::Vec3& corner : surface.corner_m) reader.vector(grammar::corner, corner);
    scene.surfaces.push_back(std::move(surface));
  }
  reader.finish();
}

}  // namespace sarsim::scene::script
