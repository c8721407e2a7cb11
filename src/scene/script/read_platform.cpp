#include "scene/schema/scene_grammar.hpp"
#include "scene/script/read_commands.hpp"

namespace sarsim::script {

namespace {

namespace grammar = platform_grammar;

void read_path(FieldReader& reader, Platform& platform) {
  reader.choice(grammar::path, grammar::paths, platform.path);
  if (platform.path == Platform::Path::stationary) {
    reader.vector(grammar::position, platform.position_m);
  } else {
    reader.function(grammar::trajectory, function_blocks::trajectory, platform.trajectory_m);
    reader.choice(grammar::aligned, grammar::alignments, platform.aligned);
  }
}

void read_rotation(FieldReader& reader, Platform& platform) {
  // The 1997 programs knew neither the keyword nor the rates.
  if (reader.more() && begins_like_number(reader.peek().text)) {
    reader.angles(grammar::rotation, platform.rotation);
    return;
  }
  reader.choice(grammar::rotation_kind, grammar::rotations, platform.rotation_kind);
  if (platform.rotation_kind == Platform::Rotation::constant)
    reader.angles(grammar::rotation, platform.rotation);
  else
    reader.function(grammar::rotation_user, function_blocks::rotation, platform.rotation_deg);
  reader.angles(grammar::rotation_rate, platform.rotation_rate);
}

void read_motion_errors(FieldReader& reader, Platform& platform) {
  reader.choice(grammar::position_error, grammar::position_errors, platform.position_error);
  if (platform.position_error == Platform::MotionError::gaussian)
    reader.vector(grammar::position_stddev, platform.position_stddev_m);
  else
    reader.function(grammar::position_envelope, function_blocks::position_envelope, platform.position_envelope);
  reader.choice(grammar::rotation_error, grammar::rotation_errors, platform.rotation_error);
  if (platform.rotation_error == Platform::MotionError::gaussian)
    reader.angles(grammar::rotation_stddev, platform.rotation_stddev);
  else
    reader.function(grammar::rotation_envelope, function_blocks::rotation_envelope, platform.rotation_envelope);
}

}  // namespace

void read_platform(Reading& reading, const Token& command, Scene& scene) {
  FieldReader reader(reading, command, "platform", scene.platforms.size());
  Platform platform;
  if (reader.leading_name(grammar::name, platform.name)) {
    read_path(reader, platform);
    read_rotation(reader, platform);
    read_motion_errors(reader, platform);
    scene.platforms.push_back(std::move(platform));
  }
  reader.finish();
}

}  // namespace sarsim::script
