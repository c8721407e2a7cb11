#include <fmt/format.h>

#include "scene/script/tokens.hpp"
#include "scene/script/write_commands.hpp"

namespace sarsim::scene::script {

void write_surface(ScriptLines& lines, const Surface& surface) {
  lines.plain("$SURFACE");
  lines.plain(quoted_where_needed(surface.platform) + "  ! Platform that carries the triangle");
  for (std::size_t i = 0; i < surface.corner_m.size(); ++i) {
    const core::Vec3& corner = surface.corner_m[i];
    lines.row({corner.x, corner.y, corner.z}, fmt::format("(m) Corner {}: x, y, z", i + 1));
  }
  lines.blank();
}

void write_target(ScriptLines& lines, const Target& target) {
  lines.plain("$TARGET " + quoted_where_needed(target.platform) + "  ! Platform that carries the target");
  const core::Vec3& at = target.position_m;
  const core::Vec3& spread = target.position_stddev_m;
  lines.row({at.x, at.y, at.z}, "(m) Position: x, y, z");
  lines.row({spread.x, spread.y, spread.z}, "(m) Standard deviation of the position: x, y, z");
  lines.row({target.rcs_m2, target.rcs_stddev_m2}, "(m^2) Radar cross-section and its standard deviation");
  lines.field(field_of<&Target::reflectivity>(), target);
  if (target.reflectivity == Target::Reflectivity::directional) {
    lines.row(
        {target.azimuth.deg(), target.elevation.deg(), target.azimuth_stddev.deg(), target.elevation_stddev.deg()},
        "(deg) Azimuth and elevation of the face, their standard deviations");
    lines.fields({&field_of<&Target::gain>(), &field_of<&Target::gain_db>()}, target);
  }
  lines.blank();
}

}  // namespace sarsim::scene::script
