#include "scene/script/writer.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/build/version.hpp"
#include "scene/script/write_commands.hpp"

namespace sarsim::scene {

namespace {

using namespace script;

template <class Object>
void write_all(ScriptLines& lines, const std::vector<Object>& objects, void (*write)(ScriptLines&, const Object&)) {
  for (const Object& object : objects) write(lines, object);
  if (!objects.empty()) lines.blank();
}

// Targets can be very many: ranges of them are written on several threads and joined in their order.
void write_targets(ScriptLines& lines, const std::vector<Target>& targets, const core::WorkControl& control) {
  constexpr std::size_t range_targets = 4096;
  const std::size_t ranges = (targets.size() + range_targets - 1) / range_targets;
  if (control.threads <= 1 || ranges <= 1) return write_all(lines, targets, write_target);
  const auto make_worker = [&] {
    return [&](std::size_t range) {
      ScriptLines part;
      const std::size_t begin = range * range_targets;
      for (std::size_t i = begin; i < std::min(begin + range_targets, targets.size()); ++i)
        write_target(part, targets[i]);
      return part.take();
    };
  };
  const auto join = [&](std::size_t range, std::string&& part) {
    lines.append(part, (ranges - range) * (part.size() + part.size() / 8));
  };
  core::ordered_parallel<std::string>(ranges, control.threads, make_worker, join, control.stop);
  lines.blank();
}

}  // namespace

std::string write_script(const Scene& scene, const core::WorkControl& control) {
  ScriptLines lines;
  lines.plain(fmt::format("! Radar scene, written by Sarsim {}", core::program_version));
  lines.plain("! Angles: azimuth from +y towards +x, elevation from the x-y plane upwards");
  lines.blank(2);
  write_all(lines, scene.platforms, write_platform);
  write_all(lines, scene.surfaces, write_surface);
  write_targets(lines, scene.targets, control);
  for (const Radar& radar : scene.radars) write_radar(lines, radar);
  for (const Simulation& simulation : scene.simulations) write_simulation(lines, simulation);
  for (const GeometryTable& table : scene.geometries) write_geometry(lines, table);
  write_options(lines, scene.options);
  return lines.take();
}

}  // namespace sarsim::scene
