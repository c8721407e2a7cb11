#include "scene/script/tokens.hpp"
#include "scene/script/write_commands.hpp"

namespace sarsim::scene::script {

void write_command(ScriptLines& lines, const Surface& surface) {
  lines.plain("$SURFACE");
  lines.plain(quoted_where_needed(surface.platform) + "  ! Platform that carries the triangle");
  lines.rows(surface_rows(), surface);
  lines.blank();
}

void write_command(ScriptLines& lines, const Cloud& cloud) {
  lines.plain("$CLOUD " + quoted_where_needed(cloud.platform) + "  ! Platform that carries the points");
  lines.plain(std::string(cloud_source) + ' ' + quoted_where_needed(cloud.file) + "  ! Table of the points");
  lines.rows(cloud_rows(), cloud);
  lines.blank();
}

void write_command(ScriptLines& lines, const Target& target) {
  lines.plain("$TARGET " + quoted_where_needed(*target.platform) + "  ! Platform that carries the target");
  lines.rows(target_rows(), target);
  lines.blank();
}

}  // namespace sarsim::scene::script
