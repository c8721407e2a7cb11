#include "scene/schema/scene_grammar.hpp"
#include "scene/script/tokens.hpp"
#include "scene/script/write_commands.hpp"

namespace sarsim::scene::script {

void write_platform(ScriptLines& lines, const Platform& platform) {
  namespace grammar = platform_grammar;
  lines.plain("$PLATFORM  " + quoted_where_needed(platform.name));
  lines.choice(grammar::paths, platform.path);
  if (platform.path == Platform::Path::stationary) {
    lines.vector(grammar::position, platform.position_m);
  } else {
    lines.function(function_blocks::trajectory, platform.trajectory_m);
    lines.choice(grammar::alignments, platform.aligned);
  }
  lines.choice(grammar::rotations, platform.rotation_kind);
  if (platform.rotation_kind == Platform::Rotation::constant)
    lines.angles(grammar::rotation, platform.rotation);
  else
    lines.function(function_blocks::rotation, platform.rotation_deg);
  lines.angles(grammar::rotation_rate, platform.rotation_rate);
  lines.choice(grammar::position_errors, platform.position_error);
  if (platform.position_error == Platform::MotionError::gaussian)
    lines.vector(grammar::position_stddev, platform.position_stddev_m);
  else
    lines.function(function_blocks::position_envelope, platform.position_envelope);
  lines.choice(grammar::rotation_errors, platform.rotation_error);
  if (platform.rotation_error == Platform::MotionError::gaussian)
    lines.angles(grammar::rotation_stddev, platform.rotation_stddev);
  else
    lines.function(function_blocks::rotation_envelope, platform.rotation_envelope);
  lines.blank();
}

}  // namespace sarsim::scene::script
