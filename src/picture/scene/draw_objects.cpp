#include <algorithm>
#include <array>
#include <cmath>

#include "core/maths/constants.hpp"
#include "core/maths/rounding.hpp"
#include "core/text/number_text.hpp"
#include "picture/scene/drawing_pen.hpp"
#include "scene/schema/quantity.hpp"

namespace sarsim::picture {

namespace {

constexpr double target_px = 7.0;
constexpr double radar_px = 10.0;
constexpr double cone_px = 50.0;
constexpr double lobe_px = 60.0;
constexpr int rim_points = 16;
constexpr double platform_axis_px = 50.0;
constexpr double normal_px = 20.0;
constexpr double path_point_px = 7.0;

// What is selected or hovered is told by size as well as by colour.
double emphasis_px(const Pen& pen, const scene::ObjectId& id) {
  return pen.hovered(id) ? 4.0 : pen.selected(id) ? 2.0 : 0.0;
}

// --- Targets --------------------------------------------------------------------------------------------------------

// Membership of targets in a set of objects, by index: one look-up each for the many.
class TargetFlags {
 public:
  TargetFlags(const std::set<scene::ObjectId>& objects, scene::ObjectKind kind, std::size_t count) {
    for (auto at = objects.lower_bound({kind, 0}); at != objects.end() && at->kind == kind; ++at) {
      if (at->index >= count) break;
      if (flags_.empty()) flags_.resize(count, false);
      flags_[at->index] = true;
    }
  }
  [[nodiscard]] bool operator[](std::size_t index) const { return !flags_.empty() && flags_[index]; }

 private:
  std::vector<bool> flags_;
};

struct SeenTarget {
  const Snapshot::Target* target;
  PicturePoint at;
  bool selected;
};

// Targets in the picture, farthest first.
std::vector<SeenTarget> seen_targets(const Pen& pen, const std::vector<Snapshot::Target>& targets) {
  const DrawingOptions& options = pen.options();
  const std::size_t count = targets.back().id.index + 1;
  const scene::ObjectKind kind = targets.back().id.kind;
  const TargetFlags hidden(options.hidden, kind, count);
  const TargetFlags selected(options.selected, kind, count);
  const std::size_t stride = options.coarse ? (targets.size() + coarse_targets - 1) / coarse_targets : 1;
  std::vector<SeenTarget> seen;
  seen.reserve(targets.size() / stride + 1);
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const Snapshot::Target& target = targets[i];
    const bool marked = selected[target.id.index];
    if (hidden[target.id.index] || (i % stride != 0 && !marked && !pen.hovered(target.id))) continue;
    const auto at = pen.project(target.position_world_m);
    if (at && pen.visible(*at) && (marked || !pen.hides(*at))) seen.push_back({&target, *at, marked});
  }
  std::ranges::stable_sort(seen, std::ranges::greater{}, [](const SeenTarget& s) { return s.at.depth_m; });
  return seen;
}

void draw_target(Pen& pen, const SeenTarget& seen, bool drop_line) {
  const Snapshot::Target& target = *seen.target;
  const bool hovered = pen.hovered(target.id);
  const Role role = hovered ? Role::hovered : seen.selected ? Role::selected : Role::target;
  if (drop_line) pen.world_line(target.position_world_m, target.foot_world_m, Role::faint, 1.0, true);
  if (target.directional) pen.line(seen.at, pen.along(seen.at, target.normal_world, normal_px), role, 1.0);
  pen.disc(seen.at, target_px + (hovered ? 4.0 : seen.selected ? 2.0 : 0.0), role, true);
  pen.handle(target.id, seen.at);
}

// --- Radars ---------------------------------------------------------------------------------------------------------

void draw_dotted_circle(Pen& pen, const PicturePoint& centre, double diameter_px) {
  constexpr int parts = 32;
  const double radius = 0.5 * pen.px(diameter_px);
  const auto at = [&](int i) {
    const double angle = 2.0 * core::pi * i / parts;
    return PicturePoint{centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle), centre.depth_m};
  };
  for (int i = 0; i < parts; i += 2) pen.line(at(i), at(i + 1), Role::beam, 1.0);
}

// The unit vector that lies at the given offsets from a beam's axis.
core::Vec3 off_axis(const Snapshot::Radar& radar, double azimuth, double elevation) {
  const core::Vec3 antenna = core::direction(azimuth, elevation);
  return antenna.x * radar.across_world + antenna.y * radar.axis_world +
         antenna.z * core::cross(radar.across_world, radar.axis_world);
}

void draw_cone(Pen& pen, const Snapshot::Radar& radar, const PicturePoint& apex, Role role) {
  const double half_azimuth = std::min(core::pi, 0.5 * radar.azimuth_width_rad);
  const double half_elevation = std::min(0.5 * core::pi, 0.5 * radar.elevation_width_rad);
  std::array<PicturePoint, rim_points> rim;
  for (int i = 0; i < rim_points; ++i) {
    const double angle = 2.0 * core::pi * i / rim_points;
    const core::Vec3 towards = off_axis(radar, radar.beam_middle.azimuth_rad + half_azimuth * std::cos(angle),
                                        radar.beam_middle.elevation_rad + half_elevation * std::sin(angle));
    rim[static_cast<std::size_t>(i)] = pen.along(apex, towards, cone_px);
  }
  for (std::size_t i = 0; i < rim.size(); ++i) pen.line(rim[i], rim[(i + 1) % rim.size()], role, 1.0);
  for (std::size_t i = 0; i < rim.size(); i += rim.size() / 4) pen.line(apex, rim[i], role, 1.0);
  pen.line(apex, pen.along(apex, radar.axis_world, cone_px), role, 1.0, true);
}

// Every second row and every fourth column of the lobe's grid.
void draw_lobe(Pen& pen, const Snapshot::Radar& radar, const PicturePoint& apex, Role role) {
  const auto& lobe = radar.lobe_world;
  const auto at = [&](std::size_t row, std::size_t column) { return pen.along(apex, lobe[row][column], lobe_px); };
  for (std::size_t row = 0; row < lobe.size(); row += 2)
    for (std::size_t column = 1; column < lobe[row].size(); ++column)
      pen.line(at(row, column - 1), at(row, column), role, 1.0);
  for (std::size_t column = 0; column < lobe.front().size(); column += 4)
    for (std::size_t row = 1; row < lobe.size(); ++row) pen.line(at(row - 1, column), at(row, column), role, 1.0);
}

// The beam down to the ground: its outline there, edges of its cone, and the ends of what is recorded.
void draw_footprint(Pen& pen, const Snapshot::Radar& radar, Role role) {
  constexpr std::size_t between_edges = 16;
  const auto& outline = radar.footprint_world_m;
  for (std::size_t i = 1; i < outline.size(); ++i)
    if (outline[i - 1] && outline[i]) pen.world_line(*outline[i - 1], *outline[i], role, 2.0);
  for (std::size_t i = 0; i + 1 < outline.size(); i += between_edges)
    if (outline[i]) pen.world_line(radar.position_world_m, *outline[i], Role::faint, 1.0);
  for (const std::vector<core::Vec3>& arc : radar.swath_world_m)
    for (std::size_t i = 1; i < arc.size(); ++i) pen.world_line(arc[i - 1], arc[i], role, 1.0);
}

void draw_radar(Pen& pen, const Snapshot::Radar& radar, const PicturePoint& at) {
  const DrawingOptions& options = pen.options();
  const Role beam = pen.role_of(radar.id, Role::beam);
  if (options.footprints) draw_footprint(pen, radar, beam);
  if (radar.isotropic)
    draw_dotted_circle(pen, at, 20.0 + emphasis_px(pen, radar.id));
  else if (options.lobes && !options.coarse && !radar.lobe_world.empty())
    draw_lobe(pen, radar, at, beam);
  else
    draw_cone(pen, radar, at, beam);
  pen.disc(at, radar_px + emphasis_px(pen, radar.id), pen.role_of(radar.id, Role::radar), true);
  pen.handle(radar.id, at);
  if (options.labels && !options.coarse)
    pen.text(at.x, at.y + pen.px(24.0), radar.name, pen.role_of(radar.id, Role::radar), pen.selected(radar.id), true,
             Drawing::Hold::movable);
}

// --- Platforms ------------------------------------------------------------------------------------------------------

// What the colour of a trail says: a value at each of its parts.
std::vector<double> tone_values(const Snapshot::Platform& platform, DrawingOptions::Tracks tracks) {
  std::vector<double> values;
  for (std::size_t i = 1; i < platform.trail_s.size(); ++i) {
    const double step_s = platform.trail_s[i] - platform.trail_s[i - 1];
    const double way_m = core::norm(platform.trail_world_m[i] - platform.trail_world_m[i - 1]);
    const bool by_time = tracks == DrawingOptions::Tracks::by_time;
    values.push_back(by_time ? platform.trail_s[i - 1] + 0.5 * step_s : step_s > 0.0 ? way_m / step_s : 0.0);
  }
  return values;
}

// The least and the largest value of all trails that are drawn.
struct ToneRange {
  double least = HUGE_VAL;
  double most = -HUGE_VAL;

  [[nodiscard]] std::uint8_t tone(double value) const {
    // Speeds that differ by rounding alone are one speed.
    const double size = std::max({std::abs(least), std::abs(most), 1e-300});
    const double part = most - least > 1e-6 * size ? (value - least) / (most - least) : 0.5;
    return static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(part, 0.0, 1.0)));
  }
};

ToneRange tone_range(const Pen& pen, const std::vector<Snapshot::Platform>& platforms) {
  ToneRange range;
  for (const Snapshot::Platform& platform : platforms)
    if (!pen.hidden(platform.id))
      for (const double value : tone_values(platform, pen.options().tracks)) {
        range.least = std::min(range.least, value);
        range.most = std::max(range.most, value);
      }
  return range;
}

void draw_trail(Pen& pen, const Snapshot::Platform& platform, const ToneRange& range) {
  const std::vector<core::Vec3>& trail = platform.trail_world_m;
  const bool plain = pen.options().tracks == DrawingOptions::Tracks::plain;
  const std::vector<double> values = plain ? std::vector<double>() : tone_values(platform, pen.options().tracks);
  for (std::size_t i = 1; i < trail.size(); ++i)
    if (plain)
      pen.world_line(trail[i - 1], trail[i], pen.role_of(platform.id, Role::faint), 1.0);
    else
      pen.world_line(trail[i - 1], trail[i], Role::track, 2.0, false, range.tone(values[i - 1]));
}

// A bar of the colours at the lower edge, between the scale bar and the triad.
void draw_tone_bar(Pen& pen, const ToneRange& range) {
  constexpr int parts = 32;
  constexpr double bar_width_px = 120.0;
  const bool by_time = pen.options().tracks == DrawingOptions::Tracks::by_time;
  const scene::Quantity quantity = by_time ? scene::Quantity::time : scene::Quantity::speed;
  const double y = pen.camera().height_px - pen.px(20.0);
  const double left = 0.5 * (pen.camera().width_px - pen.px(bar_width_px));
  const double step = pen.px(bar_width_px) / parts;
  for (int i = 0; i < parts; ++i)
    pen.line({left + i * step, y, 0.0}, {left + (i + 1) * step, y, 0.0}, Role::track, 5.0, false,
             static_cast<std::uint8_t>(255 * i / (parts - 1)));
  const auto words = [&](double value) { return scene::quantity_text(core::tidy(value, 4), quantity); };
  const std::string least = words(range.least);
  const std::string most = words(range.most);
  pen.text(left + 0.5 * pen.px(bar_width_px), y - pen.px(8.0), least == most ? least : least + " to " + most,
           Role::text, false, true);
}

void draw_square(Pen& pen, const PicturePoint& at, double side_px, Role role) {
  const double half = 0.5 * pen.px(side_px);
  const auto corner = [&](double x, double y) { return PicturePoint{at.x + x * half, at.y + y * half, at.depth_m}; };
  const std::array<PicturePoint, 4> corners{corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)};
  for (std::size_t i = 0; i < corners.size(); ++i) pen.line(corners[i], corners[(i + 1) % corners.size()], role, 2.0);
}

// The whole of a path with the points that make it.
void draw_path(Pen& pen, const Snapshot::Platform& platform) {
  const std::vector<core::Vec3>& path = platform.path_world_m;
  for (std::size_t i = 1; i < path.size(); ++i) pen.world_line(path[i - 1], path[i], Role::selected, 1.0, true);
  const auto& hovered = pen.options().hovered_point;
  for (std::size_t i = 0; i < platform.path_points_world_m.size(); ++i) {
    const auto at = pen.project(platform.path_points_world_m[i]);
    if (!at || !pen.visible(*at)) continue;
    const bool is_hovered = hovered == PathPointId{platform.id, i};
    draw_square(pen, *at, path_point_px + (is_hovered ? 4.0 : 0.0), is_hovered ? Role::hovered : Role::selected);
    pen.handle(platform.id, *at, i);
  }
}

void draw_platform(Pen& pen, const Snapshot::Platform& platform) {
  const DrawingOptions& options = pen.options();
  const auto at = pen.project(platform.pose.position_world_m);
  if (!at || !pen.visible(*at)) return;
  const bool world = core::equal_ignoring_case(platform.name, "Earth");  // The main axes are its own (thesis 4.1).
  const bool marked = pen.selected(platform.id) || pen.hovered(platform.id);
  const core::Vec3& p = platform.pose.position_world_m;
  if (options.elevation_lines && p != platform.foot_world_m)
    pen.world_line(p, platform.foot_world_m, Role::faint, 1.0, true);
  if (options.coordinate_systems && !world)
    draw_axes(pen, *at, platform.pose.world_from_platform, platform_axis_px, marked ? 2.0 : 1.0,
              options.labels && !options.coarse);
  if (marked || (!options.coordinate_systems && !world))
    pen.disc(*at, 5.0 + emphasis_px(pen, platform.id), pen.role_of(platform.id, Role::platform), true);
  pen.handle(platform.id, *at);
  if (!options.labels) return;
  const double above = at->y - pen.px(10.0);
  pen.text(at->x, above, platform.name, pen.role_of(platform.id, Role::platform), pen.selected(platform.id), true,
           Drawing::Hold::movable);
  pen.handle(platform.id, {at->x, above - pen.px(4.0), at->depth_m});
}

// --- Surfaces -------------------------------------------------------------------------------------------------------

void draw_surface(Pen& pen, const Snapshot::Surface& surface) {
  const auto& c = surface.corner_world_m;
  const DrawingOptions& options = pen.options();
  const Role rim = pen.role_of(surface.id, Role::surface);
  for (std::size_t i = 0; i < 3; ++i) pen.world_line(c[i], c[(i + 1) % 3], rim, rim == Role::surface ? 1.0 : 2.0);
  if (options.elevation_lines && !options.coarse)
    for (const core::Vec3& corner : c)
      if (corner.z != 0.0) pen.world_line(corner, {corner.x, corner.y, 0.0}, Role::faint, 1.0, true);
  const auto centroid = pen.project((1.0 / 3.0) * (c[0] + c[1] + c[2]));
  if (!centroid) return;
  if (pen.visible(*centroid))
    pen.line(*centroid, pen.along(*centroid, surface.normal_world, normal_px), pen.role_of(surface.id, Role::z_axis),
             1.0);
  pen.handle(surface.id, *centroid);
}

}  // namespace

void draw_surfaces(Pen& pen, const std::vector<Snapshot::Surface>& surfaces) {
  for (const Snapshot::Surface& surface : surfaces)
    if (!pen.hidden(surface.id)) draw_surface(pen, surface);
}

void draw_targets(Pen& pen, const std::vector<Snapshot::Target>& targets) {
  if (targets.empty()) return;
  const std::vector<SeenTarget> seen = seen_targets(pen, targets);
  const bool drop_lines = pen.options().elevation_lines && !pen.options().coarse;
  pen.drawing().discs.reserve(pen.drawing().discs.size() + seen.size());
  pen.drawing().handles.reserve(pen.drawing().handles.size() + seen.size());
  for (const SeenTarget& target : seen) {
    const bool raised = target.target->position_world_m != target.target->foot_world_m;
    draw_target(pen, target, drop_lines && raised);
  }
}

void draw_radars(Pen& pen, const std::vector<Snapshot::Radar>& radars) {
  std::vector<std::pair<const Snapshot::Radar*, PicturePoint>> seen;
  for (const Snapshot::Radar& radar : radars) {
    if (pen.hidden(radar.id)) continue;
    const auto at = pen.project(radar.position_world_m);
    if (at && pen.visible(*at)) seen.emplace_back(&radar, *at);
  }
  std::ranges::stable_sort(seen, std::ranges::greater{}, [](const auto& s) { return s.second.depth_m; });
  for (const auto& [radar, at] : seen) draw_radar(pen, *radar, at);
}

void draw_platforms(Pen& pen, const std::vector<Snapshot::Platform>& platforms) {
  const bool toned = pen.options().trails && pen.options().tracks != DrawingOptions::Tracks::plain;
  const ToneRange range = toned ? tone_range(pen, platforms) : ToneRange{};
  for (const Snapshot::Platform& platform : platforms) {
    if (pen.hidden(platform.id)) continue;
    if (pen.options().trails) draw_trail(pen, platform, range);
    if (pen.selected(platform.id)) draw_path(pen, platform);
    draw_platform(pen, platform);
  }
  if (range.least <= range.most) draw_tone_bar(pen, range);
}

}  // namespace sarsim::picture
