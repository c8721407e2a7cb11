#include "scene/script/writer.hpp"

#include <algorithm>
#include <functional>
#include <string_view>
#include <type_traits>

#include <fmt/format.h>

#include "core/build/version.hpp"
#include "scene/model/kinds.hpp"
#include "scene/script/write_commands.hpp"

namespace sarsim::scene {

namespace {

using namespace script;

// Commands of a few lines each, of which there can be very many: a blank line sets off their list.
template <class Object>
constexpr bool is_short = !std::is_same_v<Object, Radar> && !Kind<Object>::belongs_to_radar;

// Ranges of a long list are written on several threads and joined in their order.
// @param pass_on  called with the lines so far when a range has been added
template <class Object, class PassOn>
void write_list(ScriptLines& lines, const std::vector<Object>& objects, const core::WorkControl& control,
                const PassOn& pass_on) {
  constexpr std::size_t range_objects = 4096;
  const std::size_t ranges = (objects.size() + range_objects - 1) / range_objects;
  const auto write_range = [&](ScriptLines& to, std::size_t range) {
    const std::size_t begin = range * range_objects;
    for (std::size_t i = begin; i < std::min(begin + range_objects, objects.size()); ++i) write_command(to, objects[i]);
  };
  if (control.threads <= 1 || ranges <= 1) {
    for (std::size_t range = 0; range < ranges; ++range) {
      write_range(lines, range);
      pass_on(lines);
    }
    return;
  }
  const auto make_worker = [&] {
    return [&](std::size_t range) {
      ScriptLines part;
      write_range(part, range);
      return part.take();
    };
  };
  const auto join = [&](std::size_t range, std::string&& part) {
    lines.append(part, (ranges - range) * (part.size() + part.size() / 8));
    pass_on(lines);
  };
  core::ordered_parallel<std::string>(ranges, control.threads, make_worker, join, control.stop);
}

template <class PassOn>
std::string written(const Scene& scene, const core::WorkControl& control, const PassOn& pass_on) {
  ScriptLines lines;
  lines.plain(fmt::format("! Radar scene, written by Sarsim {}", core::program_version));
  lines.plain("! Angles: azimuth from +y towards +x, elevation from the x-y plane upwards");
  lines.blank(2);
  for (const ObjectKind kind : written_object_kinds)
    visit_list(scene, kind, [&]<class Object>(const std::vector<Object>& objects) {
      write_list(lines, objects, control, pass_on);
      if (is_short<Object> && !objects.empty()) lines.blank();
    });
  write_command(lines, scene.options);
  return lines.take();
}

}  // namespace

std::string write_script(const Scene& scene, const core::WorkControl& control) {
  return written(scene, control, [](const ScriptLines&) {});
}

void write_script(const Scene& scene, const core::WorkControl& control,
                  const std::function<void(std::string_view)>& take) {
  take(written(scene, control, [&](ScriptLines& lines) {
    const std::string text = lines.take();
    lines = {};
    take(text);
  }));
}

}  // namespace sarsim::scene
