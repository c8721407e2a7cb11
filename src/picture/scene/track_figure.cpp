#include "picture/scene/track_figure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "core/report/invalid_request.hpp"
#include "picture/figure/figure_axes.hpp"
#include "picture/scene/half_power.hpp"
#include "picture/scene/scene_map.hpp"
#include "picture/scene/snapshot.hpp"
#include "picture/scene/snapshot_maker.hpp"
#include "scene/model/read_path.hpp"
#include "simulate/survey/places.hpp"

namespace sarsim::picture {

namespace {

constexpr std::size_t path_points = 601;
constexpr std::size_t outline_points = 181;
constexpr std::size_t outlines = 9;
constexpr std::size_t max_targets = 1000;
constexpr std::size_t max_words = 20;
constexpr double half_height_line = 0.07;  // a line of words as a share of one panel of two
constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();

double time_at(const radar::TimeSpan& times, std::size_t i, std::size_t count) {
  return times.first_s + (times.last_s - times.first_s) * static_cast<double>(i) / static_cast<double>(count - 1);
}

double middle_of(const radar::TimeSpan& times) { return 0.5 * (times.first_s + times.last_s); }

void add_point(FigureCurve& curve, const std::optional<MapPlace>& place) {
  curve.x.push_back(place ? place->x : nowhere);
  curve.y.push_back(place ? place->y : nowhere);
}

// Numbers where these are few.
void mark_targets(FigurePanel& panel, const SceneMap& map, const std::vector<core::Vec3>& targets_m) {
  const std::size_t step = std::max<std::size_t>(1, (targets_m.size() + max_targets - 1) / max_targets);
  for (std::size_t i = 0; i < targets_m.size(); i += step) {
    const MapPlace place = map.place_of(targets_m[i]);
    panel.marks.push_back({place.x, place.y, targets_m.size() <= max_words ? fmt::format("{}", i + 1) : ""});
  }
}

// How far apart two marks are, as a share of the map.
double share_between(const FigurePanel& panel, const FigureMark& a, const FigureMark& b) {
  const double whole =
      std::max(panel.y_per_x * std::abs(panel.x.last - panel.x.first), std::abs(panel.y.last - panel.y.first));
  return std::hypot(panel.y_per_x * (a.x - b.x), a.y - b.y) / whole;
}

// Words that would stand on others' are left out, and what stands twice is there once.
// @param readable  share of the map from words to words
void clear_words(FigurePanel& panel, double readable) {
  constexpr double same = 0.005;
  std::vector<FigureMark> kept;
  for (FigureMark mark : panel.marks) {
    const auto within = [&](double share) {
      return std::ranges::any_of(kept, [&](const FigureMark& other) {
        return !other.text.empty() && !mark.text.empty() && share_between(panel, mark, other) < share;
      });
    };
    if (within(same)) continue;
    if (within(readable)) mark.text.clear();
    kept.push_back(std::move(mark));
  }
  panel.marks = std::move(kept);
}

// More of an axis upwards, so that nothing is behind the legend.
void make_room(FigurePanel& panel, double share_of_line) {
  constexpr std::ptrdiff_t max_lines = 5;
  const auto lines = std::ranges::count_if(panel.curves, [](const FigureCurve& curve) { return !curve.name.empty(); });
  const double share = 0.05 + share_of_line * static_cast<double>(std::min(lines, max_lines));
  panel.y.last += share * (panel.y.last - panel.y.first);
}

// Axes about all that is on a map, with room for words.
// @param share_of_line  of the height, for a line of the legend
void fit_map(FigurePanel& panel, double readable, double share_of_line) {
  std::vector<double> x;
  std::vector<double> y;
  for (const FigureCurve& curve : panel.curves) {
    x.insert(x.end(), curve.x.begin(), curve.x.end());
    y.insert(y.end(), curve.y.begin(), curve.y.end());
  }
  for (const FigureMark& mark : panel.marks) {
    x.push_back(mark.x);
    y.push_back(mark.y);
  }
  constexpr double for_words = 0.08;
  fit(panel.x, x);
  fit(panel.y, y);
  panel.x.last += for_words * (panel.x.last - panel.x.first);
  make_room(panel, share_of_line);
  clear_words(panel, readable);
}

// One radar's beam from time to time.
class BeamOnGround {
 public:
  BeamOnGround(const simulate::ResolvedScene& scene, const simulate::Link& radar, const SceneMap& map)
      : scene_(scene), radar_(radar), map_(map) {}

  // Where the middle of the beam is.
  [[nodiscard]] std::optional<MapPlace> spot(double time_s) const {
    const radar::Pose pose = pose_at(time_s);
    return met_by(pose, pointing_at(pose, time_s).axis_world());
  }

  // Where the power has fallen to half that of the middle, from direction to direction about it.
  [[nodiscard]] FigureCurve outline(double time_s) const {
    const radar::Pose pose = pose_at(time_s);
    const radar::Pointing pointing = pointing_at(pose, time_s);
    FigureCurve curve;
    for (const auto& offset : half_power_outline(radar_.transmit, scene_.conventions.pattern, outline_points))
      add_point(curve,
                offset ? met_by(pose, beam_direction(pointing, scene_.conventions.pointing, *offset)) : std::nullopt);
    return curve;
  }

 private:
  [[nodiscard]] radar::Pose pose_at(double time_s) const {
    return scene_.platforms[radar_.platform].track.at(time_s, 0);
  }

  [[nodiscard]] radar::Pointing pointing_at(const radar::Pose& pose, double time_s) const {
    return {radar_.beam,           scene_.conventions.pointing, time_s,
            pose.position_world_m, pose.world_from_platform,    pose.rotation_rad};
  }

  [[nodiscard]] std::optional<MapPlace> met_by(const radar::Pose& pose, const core::Vec3& direction) const {
    const auto point_m = map_.met_by(pose.position_world_m, direction);
    return point_m ? std::optional(map_.place_of(*point_m)) : std::nullopt;
  }

  const simulate::ResolvedScene& scene_;
  const simulate::Link& radar_;
  const SceneMap& map_;
};

FigureCurve spots_of(const BeamOnGround& beam, const std::string& name, Role role, const radar::TimeSpan& times) {
  FigureCurve curve{name, role, false, {}, {}};
  for (std::size_t i = 0; i < path_points; ++i) add_point(curve, beam.spot(time_at(times, i, path_points)));
  return curve;
}

bool has_any(const FigureCurve& curve) {
  return std::ranges::any_of(curve.x, [](double x) { return std::isfinite(x); });
}

// The path of a platform on the map and its height.
void add_path(Figure& figure, const simulate::ResolvedPlatform& platform, const SceneMap& map,
              const radar::TimeSpan& times, Role role) {
  FigureCurve path{platform.name, role, false, {}, {}};
  FigureCurve height{platform.name, role, false, {}, {}};
  for (std::size_t i = 0; i < path_points; ++i) {
    const double time_s = time_at(times, i, path_points);
    const MapPlace place = map.place_of(platform.track.at(time_s, 0).position_world_m);
    add_point(path, place);
    height.x.push_back(time_s);
    height.y.push_back(place.height_m);
  }
  figure.panels[0].marks.push_back({path.x[0], path.y[0], map.time_words(times.first_s)});
  figure.panels[0].curves.push_back(std::move(path));
  figure.panels[1].curves.push_back(std::move(height));
}

void fit_heights(FigurePanel& panel) {
  std::vector<double> all;
  for (const FigureCurve& curve : panel.curves) all.insert(all.end(), curve.y.begin(), curve.y.end());
  fit(panel.y, all);
  make_room(panel, half_height_line);
}

// Those that do not move: the ground is where they are, and not where aircraft are.
std::vector<core::Vec3> resting_targets_m(const simulate::ResolvedScene& scene, const std::vector<core::Vec3>& all_m) {
  std::vector<core::Vec3> resting_m;
  for (std::size_t i = 0; i < all_m.size(); ++i)
    if (scene.platforms[scene.scatterers[i].platform].track.fixed()) resting_m.push_back(all_m[i]);
  return resting_m;
}

bool is_world(const std::string& name) { return name == "Earth"; }

}  // namespace

radar::TimeSpan shown_times(const scene::Scene& scene) {
  radar::TimeSpan times = scene::needed_times(scene);
  if (times.first_s < times.last_s) return times;
  const auto mentioned = SnapshotMaker(scene).time_span_s();
  times = {mentioned[0], mentioned[1]};
  if (!(times.first_s < times.last_s)) times.last_s = times.first_s + 1.0;
  return times;
}

Figure track_figure(const scene::Scene& scene, const simulate::ResolvedScene& resolved, const radar::TimeSpan& times) {
  static constexpr std::array roles{Role::curve, Role::curve_2, Role::curve_3, Role::curve_4, Role::curve_5};
  const std::vector<core::Vec3> targets_m =
      simulate::target_places_m(resolved, middle_of(times), resolved.scatterers.targets());
  const SceneMap map(scene.world, resting_targets_m(resolved, targets_m));
  Figure figure;
  figure.title = "paths of the platforms";
  figure.panels.resize(2);
  map.name_axes(figure.panels[0]);
  figure.panels[1].x = map.time_axis(times.first_s, times.last_s);
  figure.panels[1].y = {"Height", "m", 0.0, 1.0, {}};
  std::size_t drawn = 0;
  const auto next_role = [&] { return roles[drawn++ % roles.size()]; };
  for (std::size_t i = 0; i < scene.platforms.size(); ++i)
    if (!is_world(resolved.platforms[i].name)) add_path(figure, resolved.platforms[i], map, times, next_role());
  for (std::size_t i = 0; i < scene.radars.size(); ++i) {
    const simulate::Link radar = simulate::resolve_radar(scene, resolved, i);
    FigureCurve spots = spots_of({resolved, radar, map}, "beam of " + radar.name, Role::beam, times);
    if (!has_any(spots)) continue;
    spots.role = next_role();
    figure.note = fmt::format("Beams meet {}", map.ground_words());
    figure.panels[0].curves.push_back(std::move(spots));
  }
  mark_targets(figure.panels[0], map, targets_m);
  fit_map(figure.panels[0], 0.05, half_height_line);
  fit_heights(figure.panels[1]);
  return figure;
}

Figure footprint_figure(const scene::Scene& scene, const simulate::ResolvedScene& resolved, std::size_t radar,
                        const radar::TimeSpan& times) {
  const simulate::Link seen = simulate::resolve_radar(scene, resolved, radar);
  if (seen.transmit.kind == radar::AntennaPattern::Kind::isotropic)
    throw core::InvalidRequest(fmt::format("the antenna of {} is isotropic and has no footprint", seen.name),
                               "give it a pattern");
  const std::vector<core::Vec3> targets_m =
      simulate::target_places_m(resolved, middle_of(times), resolved.scatterers.targets());
  const SceneMap map(scene.world, resting_targets_m(resolved, targets_m));
  const BeamOnGround beam(resolved, seen, map);
  Figure figure;
  figure.title = "footprint of " + seen.name;
  figure.note = fmt::format("Half-power (-3 dB) contour of the beam, one way, on {}", map.ground_words());
  FigurePanel& panel = figure.panels.emplace_back();
  map.name_axes(panel);
  for (std::size_t i = 0; i < outlines; ++i) {
    const double time_s = time_at(times, i, outlines);
    FigureCurve outline = beam.outline(time_s);
    outline.role = i == 0 ? Role::curve : i + 1 == outlines ? Role::curve_2 : Role::faint;
    if (i == 0 || i + 1 == outlines) outline.name = map.time_words(time_s);
    if (has_any(outline)) panel.curves.push_back(std::move(outline));
  }
  if (panel.curves.empty())
    throw core::InvalidRequest(fmt::format("the beam of {} does not intersect {}", seen.name, map.ground_words()),
                               "point it lower, or choose other times with --time");
  panel.curves.push_back(spots_of(beam, "middle of the beam", Role::curve_3, times));
  mark_targets(panel, map, targets_m);
  fit_map(panel, 0.025, 0.5 * half_height_line);
  return figure;
}

}  // namespace sarsim::picture
