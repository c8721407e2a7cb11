#include "scene/schema/scene_grammar.hpp"
#include "scene/script/read_commands.hpp"

namespace sarsim::scene::script {

namespace {

void read_path(FieldReader& reader, Platform& platform) {
  reader.choice(platform_grammar::path, platform_grammar::paths, platform.path);
  if (platform.path == Platform::Path::stationary) {
    reader.vector(platform_grammar::position, platform.position_m);
  } else {
    reader.function(platform_grammar::trajectory, function_blocks::trajectory, platform.trajectory_m);
    reader.choice(platform_grammar::aligned, platform_grammar::alignments, platform.aligned);
  }
}

void read_rotation(FieldReader& reader, Platform& platform) {
  // The 1997 programs knew neither the keyword nor the rates.
  if (reader.more() && begins_like_number(reader.peek().text)) {
    reader.angles(platform_grammar::rotation, platform.rotation);
    return;
  }
  reader.choice(platform_grammar::rotation_kind, platform_grammar::rotations, platform.rotation_kind);
  if (platform.rotation_kind == Platform::Rotation::constant)
    reader.angles(platform_grammar::rotation, platform.rotation);
  else
    reader.function(platform_grammar::rotation_user, function_blocks::rotation, platform.rotation_deg);
  reader.angles(platform_grammar::rotation_rate, platform.rotation_rate);
}

void read_motion_errors(FieldReader& reader, Platform& platform) {
  reader.choice(platform_grammar::position_error, platform_grammar::position_errors, platform.position_error);
  if (platform.position_error == Platform::MotionError::gaussian)
    reader.vector(platform_grammar::position_stddev, platform.position_stddev_m);
  else
    reader.function(platform_grammar::position_envelope, function_blocks::position_envelope,
                    platform.position_envelope);
  reader.choice(platform_grammar::rotation_error, platform_grammar::rotation_errors, platform.rotation_error);
  if (platform.rotation_error == Platform::MotionError::gaussian)
    reader.angles(platform_grammar::rotation_stddev, platform.rotation_stddev);
  else
    reader.function(platform_grammar::rotation_envelope, function_blocks::rotation_envelope,
                    platform.rotation_envelope);
}

}  // namespace

void read_platform(Reading& reading, const Token& command, Scene& scene) {
  FieldReader reader(reading, command, "platform", scene.platforms.size());
  Platform platform;
  if (reader.leading_name(platform_grammar::name, platform.name)) {
    read_path(reader, platform);
    read_rotation(reader, platform);
    read_motion_errors(reader, platform);
    scene.platforms.push_back(std::move(platform));
  }
  reader.finish();
}

}  // namespace sarsim::scene::script
