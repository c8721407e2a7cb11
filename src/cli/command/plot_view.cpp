// `sarsim plot --kind scene`: the scene as the workbench shows it, one picture or many.

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "cli/command/plot_arguments.hpp"
#include "cli/shell/progress_display.hpp"
#include "core/maths/constants.hpp"
#include "core/task/parallel.hpp"
#include "picture/scene/scene_view.hpp"
#include "picture/scene/snapshot_maker.hpp"
#include "scene/model/scene_index.hpp"
#include "workflow/input/output_names.hpp"

namespace sarsim::cli {

namespace fs = std::filesystem;

namespace {

std::optional<std::size_t> followed_platform(const PlotArguments& a, const scene::Scene& scene) {
  if (a.followed.empty()) return std::nullopt;
  const std::size_t found = scene::SceneIndex(scene).platform(a.followed);
  if (found != scene::not_found) return found;
  std::string names;
  for (const scene::Platform& platform : scene.platforms) names += (names.empty() ? "" : ", ") + platform.name;
  throw core::InvalidRequest(fmt::format("--follow: the scene has no platform '{}'", a.followed),
                             names.empty() ? "it has none" : "choose one of " + names);
}

std::optional<std::size_t> beam_radar(const PlotArguments& a, const scene::Scene& scene) {
  if (!a.radar.empty()) return workflow::radar_named(scene, a.radar);
  if (a.view != picture::SceneLook::From::beam || !scene.radars.empty()) return std::nullopt;
  throw core::InvalidRequest("--view beam: the scene has no radar", "choose another view");
}

picture::SceneLook look_of(const PlotArguments& a, const scene::Scene& scene) {
  picture::SceneLook look;
  look.from = a.view.value_or(picture::SceneLook::From::start);
  if (a.look_deg.size() == 2)
    look.direction_rad = {a.look_deg[0] * core::rad_per_deg, a.look_deg[1] * core::rad_per_deg};
  look.radar = beam_radar(a, scene);
  look.followed = followed_platform(a, scene);
  look.perspective = a.perspective;
  look.options.ground_grid = true;
  look.options.footprints = true;
  look.options.filled_surfaces = true;
  look.options.illuminated = a.illuminated;
  look.options.tracks = a.tracks.value_or(picture::DrawingOptions::Tracks::plain);
  look.options.threads = core::thread_count(0);
  return look;
}

// When the scene is seen: of one picture --at-time or the middle of its time, of many from the first to the last.
std::vector<double> times_of(const PlotArguments& a, const scene::Scene& scene) {
  const std::array<double, 2> span_s = picture::SnapshotMaker(scene).time_span_s();
  if (!a.frames) return {a.at_s.value_or(0.5 * (span_s[0] + span_s[1]))};
  if (a.at_s)
    throw core::InvalidRequest("--at-time and --frames ask for one picture and for many", "leave one of them out");
  const double first_s = a.time_s.size() == 2 ? a.time_s[0] : span_s[0];
  const double last_s = a.time_s.size() == 2 ? a.time_s[1] : span_s[1];
  std::vector<double> times_s;
  const auto steps = static_cast<double>(std::max<std::int64_t>(1, *a.frames - 1));
  for (std::int64_t i = 0; i < *a.frames; ++i)
    times_s.push_back(first_s + (last_s - first_s) * static_cast<double>(i) / steps);
  return times_s;
}

// "flight.png" becomes "flight-0001.png" and so on.
fs::path frame_path(const fs::path& out, std::size_t number) {
  return out.parent_path() / fmt::format("{}-{:04}{}", out.stem().string(), number, out.extension().string());
}

std::vector<fs::path> paths_of(const PlotArguments& a, std::size_t count) {
  if (!a.frames) return {a.out};
  std::vector<fs::path> paths;
  for (std::size_t i = 1; i <= count; ++i) paths.push_back(frame_path(a.out, i));
  return paths;
}

void expect_view(const PlotArguments& a) {
  if (a.out.empty()) throw core::InvalidRequest("--kind scene makes a picture", "name it with -o");
  if (!workflow::language_of_name(a.input))
    throw core::InvalidRequest(fmt::format("--kind scene: '{}' is no scene", a.input), "name a .toml or .scr file");
  if (a.title) throw core::InvalidRequest("--title means nothing for --kind scene", "leave it out");
  if (!a.time_s.empty() && !a.frames)
    throw core::InvalidRequest("--time is the span of several pictures",
                               "add --frames N, or choose one with --at-time");
  if (a.look_deg.size() == 2 && std::abs(a.look_deg[1]) > 90.0)
    throw core::InvalidRequest(fmt::format("--look: an elevation of {} deg", a.look_deg[1]), "choose -90 to 90 deg");
  if (a.view && !a.look_deg.empty())
    throw core::InvalidRequest("--view and --look both set the viewpoint", "leave one of them out");
}

}  // namespace

void plot_view(const PlotArguments& a, Streams& streams) {
  expect_view(a);
  workflow::SceneInput input =
      workflow::read_scene(a.input, a.overrides, workflow::CheckLevel::values, {core::thread_count(0), streams.stop});
  workflow::expect_usable(input);
  print_problems(streams, input.of_files);
  const std::vector<double> times_s = times_of(a, input.scene);
  const std::vector<fs::path> paths = paths_of(a, times_s.size());
  if (a.frames) workflow::expect_free_outputs(paths, {input.sources, a.force, "-o"});
  const picture::PictureStyle style{static_cast<int>(a.size[0]), static_cast<int>(a.size[1]), a.scale.value_or(1.0),
                                    a.dark};
  picture::SceneView view(input.scene, look_of(a, input.scene), style, {times_s.front(), times_s.back()});
  const auto kind = streams.terminal ? ProgressDisplay::Style::bar : ProgressDisplay::Style::none;
  ProgressDisplay progress(streams.err, kind, a.out);
  for (std::size_t i = 0; i < times_s.size(); ++i) {
    if (streams.stop != nullptr && streams.stop->requested()) throw core::Interrupted();
    picture::write_picture(view.at(times_s[i]), paths[i], style, streams.stop);
    progress.update({i + 1, times_s.size(), 0});
  }
}

}  // namespace sarsim::cli
