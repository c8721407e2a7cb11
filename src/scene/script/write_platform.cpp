#include "scene/script/tokens.hpp"
#include "scene/script/write_commands.hpp"

namespace sarsim::scene::script {

void write_command(ScriptLines& lines, const Platform& platform) {
  lines.plain("$PLATFORM  " + quoted_where_needed(platform.name));
  lines.fields(platform_order().path, platform);
  lines.fields(platform_order().rotation, platform);
  lines.fields(platform_order().errors, platform);
  lines.blank();
}

}  // namespace sarsim::scene::script
