#include "picture/scene/scene_view.hpp"

#include <algorithm>

#include "picture/scene/draw_scene.hpp"
#include "picture/scene/framing.hpp"
#include "picture/scene/ground_point.hpp"

namespace sarsim::picture {

namespace {

Camera looking(const SceneLook& look, const PictureStyle& style, double scale) {
  Camera camera = Camera::start(style.width_px * scale, style.height_px * scale);
  camera.pixels_per_m *= scale;
  switch (look.from) {
    case SceneLook::From::start:
    case SceneLook::From::beam: break;
    case SceneLook::From::top: camera = preset(camera, ViewPreset::top); break;
    case SceneLook::From::front: camera = preset(camera, ViewPreset::front); break;
    case SceneLook::From::side: camera = preset(camera, ViewPreset::side); break;
  }
  if (look.direction_rad) {
    camera.azimuth_rad = look.direction_rad->at(0);
    camera.elevation_rad = look.direction_rad->at(1);
  }
  camera.perspective = look.perspective;
  return camera;
}

// What is to be in view at some of the times: all of it is then in view at all of them.
Snapshot gathered(const SnapshotMaker& maker, std::array<double, 2> times_s) {
  Snapshot all = maker.at(times_s[0]);
  for (const double time_s : {0.5 * (times_s[0] + times_s[1]), times_s[1]}) {
    Snapshot more = maker.at(time_s);
    all.platforms.insert(all.platforms.end(), more.platforms.begin(), more.platforms.end());
    all.targets.insert(all.targets.end(), more.targets.begin(), more.targets.end());
    all.surfaces.insert(all.surfaces.end(), more.surfaces.begin(), more.surfaces.end());
    all.radars.insert(all.radars.end(), more.radars.begin(), more.radars.end());
  }
  return all;
}

}  // namespace

std::optional<core::Vec3> platform_place(const Snapshot& snapshot, std::size_t number) {
  return place_of(snapshot, {scene::ObjectKind::platform, number});
}

Camera beam_camera(const Camera& camera, const Snapshot& snapshot, std::size_t radar) {
  const scene::ObjectId id{scene::ObjectKind::radar, radar};
  const auto at = std::ranges::find(snapshot.radars, id, &Snapshot::Radar::id);
  if (at == snapshot.radars.end()) return camera;
  const core::Vec3& antenna = at->position_world_m;
  const auto ground = ground_along({antenna, at->axis_world, 0.0}, snapshot.earth);
  double reach_m = ground ? core::norm(*ground - antenna) : 0.0;
  if (!(reach_m > 1.0)) reach_m = std::max(1.0, camera.viewer_distance_m());
  const double width_rad = at->isotropic ? 0.0 : std::max(at->azimuth_width_rad, at->elevation_width_rad);
  return along_beam(camera, antenna, at->axis_world, width_rad, reach_m);
}

SceneView::SceneView(const scene::Scene& scene, const SceneLook& look, const PictureStyle& style,
                     std::array<double, 2> times_s)
    : maker_(scene), look_(look), style_(style) {
  const double scale = style.scale;
  look_.options.dark = style.dark;
  look_.options.pixel_scale = scale;
  look_.options.samples = 2;
  const auto [first_s, last_s] = maker_.time_span_s();
  trail_s_ = last_s - first_s;
  camera_ = showing_all(looking(look_, style, scale), gathered(maker_, times_s), look_.options);
  if (!look_.followed) return;
  if (const auto place = platform_place(maker_.at(times_s[0]), *look_.followed))
    way_to_focus_m_ = camera_.focus_world_m - *place;
}

Camera SceneView::camera_at(const Snapshot& snapshot) const {
  if (look_.from == SceneLook::From::beam && !look_.direction_rad)
    return beam_camera(camera_, snapshot, look_.radar.value_or(0));
  Camera camera = camera_;
  if (look_.followed)
    if (const auto place = platform_place(snapshot, *look_.followed)) camera.focus_world_m = *place + way_to_focus_m_;
  return camera;
}

Sheet SceneView::at(double time_s) {
  const Snapshot snapshot = maker_.at(time_s, trail_s_, look_.options.illuminated);
  draw_scene(snapshot, camera_at(snapshot), look_.options, drawing_);
  return sheet_of(drawing_, style_.dark, style_.scale);
}

Sheet sheet_of(const Drawing& drawing, bool dark, double scale) {
  const auto rgb = [&](Role role) { return colour(role, dark); };
  const auto px = [&](float value) { return static_cast<double>(value) / scale; };
  Sheet sheet;
  sheet.background = rgb(Role::background);
  if (drawing.horizon_px) sheet.sky = {rgb(Role::sky), rgb(Role::background), *drawing.horizon_px / scale};
  const Rendering& solids = drawing.solids;
  if (!solids.empty())
    sheet.image = {solids.left / scale, solids.top / scale, solids.width, solids.height, scale, solids.argb};
  for (const Drawing::Line& line : drawing.lines)
    sheet.lines.push_back(
        {px(line.x0), px(line.y0), px(line.x1), px(line.y1), px(line.width_px), line.dotted, colour_of(line, dark)});
  // Faint lines lie below, as in the workbench.
  std::ranges::stable_sort(sheet.lines, {}, [&](const Sheet::Line& line) { return line.colour != rgb(Role::faint); });
  const raster::Rgb rim = rgb(dark ? Role::background : Role::text);
  for (const Drawing::Disc& disc : drawing.discs)
    sheet.discs.push_back({px(disc.x), px(disc.y), px(disc.diameter_px), rgb(disc.role),
                           disc.outlined ? std::optional(rim) : std::nullopt});
  for (const Drawing::Text& text : drawing.texts)
    sheet.texts.push_back({px(text.x), px(text.y), text.text, text.bold, text.centred, rgb(text.role)});
  return sheet;
}

}  // namespace sarsim::picture
