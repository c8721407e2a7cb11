#include "picture/scene/solids.hpp"

#include <algorithm>
#include <cmath>

#include "core/maths/constants.hpp"
#include "picture/scene/globe.hpp"

namespace sarsim::picture {

namespace {

constexpr double symbol_px = 44.0;  // from nose to tail
constexpr std::uint8_t beam_opacity = 26;
constexpr std::uint8_t footprint_opacity = 51;
constexpr std::uint8_t illuminated_opacity = 64;

bool is_marked(const DrawingOptions& options, const scene::ObjectId& id) {
  return options.selected.contains(id) || options.hovered == id;
}

Role role_in(const DrawingOptions& options, const scene::ObjectId& id, Role usual) {
  if (options.hovered == id) return Role::hovered;
  return options.selected.contains(id) ? Role::selected : usual;
}

// Grey by the elevation of the normal, white where it points down (thesis 4.1).
std::uint8_t shade_of(const core::Vec3& normal_world) {
  const double elevation = core::elevation_rad(normal_world);
  if (elevation < 0.0) return 255;
  return static_cast<std::uint8_t>(std::lround(100.0 + 154.0 * elevation / (0.5 * core::pi)));
}

// A marked colour shines through the grey.
raster::Rgb tinted(raster::Rgb grey, raster::Rgb mark) {
  const auto mix = [](std::uint8_t a, std::uint8_t b) { return static_cast<std::uint8_t>((2 * a + b) / 3); };
  return {mix(grey.red, mark.red), mix(grey.green, mark.green), mix(grey.blue, mark.blue)};
}

Mesh surfaces_mesh(const Snapshot& snapshot, const DrawingOptions& options) {
  Mesh mesh;
  for (const Snapshot::Surface& surface : snapshot.surfaces) {
    if (options.hidden.contains(surface.id)) continue;
    const auto first = static_cast<std::uint32_t>(mesh.points_world_m.size());
    mesh.points_world_m.insert(mesh.points_world_m.end(), surface.corner_world_m.begin(), surface.corner_world_m.end());
    mesh.triangles.push_back({first, first + 1, first + 2});
    const raster::Rgb grey = surface_fill(shade_of(surface.normal_world), options.dark);
    const Role role = role_in(options, surface.id, Role::surface);
    mesh.colours.push_back(is_marked(options, surface.id) ? tinted(grey, colour(role, options.dark)) : grey);
    mesh.objects.push_back(surface.id);
  }
  return mesh;
}

using Outline = std::vector<std::optional<core::Vec3>>;

bool is_whole(const Outline& outline) {
  return outline.size() > 2 && std::ranges::all_of(outline, [](const auto& point) { return point.has_value(); });
}

// Triangles from a point to each part of an outline.
void add_fan(Mesh& mesh, const core::Vec3& apex, const Outline& outline) {
  const auto first = static_cast<std::uint32_t>(mesh.points_world_m.size());
  mesh.points_world_m.push_back(apex);
  for (const auto& point : outline) mesh.points_world_m.push_back(point.value_or(apex));
  for (std::uint32_t i = 1; i < outline.size(); ++i)
    if (outline[i - 1] && outline[i]) mesh.triangles.push_back({first, first + i, first + i + 1});
}

core::Vec3 middle_of(const Outline& outline) {
  core::Vec3 sum;
  for (const auto& point : outline) sum = sum + *point;
  return (1.0 / static_cast<double>(outline.size())) * sum;
}

// What the outline swept over from one place to the next.
void add_sweep(Mesh& mesh, const Outline& from, const Outline& to) {
  const auto first = static_cast<std::uint32_t>(mesh.points_world_m.size());
  const auto count = static_cast<std::uint32_t>(from.size());
  for (const Outline* outline : {&from, &to})
    for (const auto& point : *outline) mesh.points_world_m.push_back(*point);
  for (std::uint32_t i = 1; i < count; ++i) {
    mesh.triangles.push_back({first + i - 1, first + i, first + count + i});
    mesh.triangles.push_back({first + i - 1, first + count + i, first + count + i - 1});
  }
}

Mesh veil(raster::Rgb colour, std::uint8_t opacity) { return {{}, {}, {colour}, opacity, {}}; }

Mesh illuminated_mesh(const Snapshot::Radar& radar, bool dark) {
  Mesh mesh = veil(colour(Role::beam, dark), illuminated_opacity);
  const Outline* before = nullptr;
  for (const Outline& outline : radar.illuminated_world_m) {
    if (!is_whole(outline)) {
      before = nullptr;
      continue;
    }
    add_fan(mesh, middle_of(outline), outline);
    if (before != nullptr && before->size() == outline.size()) add_sweep(mesh, *before, outline);
    before = &outline;
  }
  return mesh;
}

void add_beam(MeshList& meshes, const Snapshot::Radar& radar, const DrawingOptions& options) {
  const raster::Rgb tint = colour(role_in(options, radar.id, Role::beam), options.dark);
  if (is_whole(radar.footprint_world_m)) {
    Mesh ground = veil(tint, footprint_opacity);
    add_fan(ground, middle_of(radar.footprint_world_m), radar.footprint_world_m);
    meshes.push_back(std::make_shared<const Mesh>(std::move(ground)));
  }
  Mesh cone = veil(tint, beam_opacity);
  add_fan(cone, radar.position_world_m, radar.footprint_world_m);
  if (!cone.triangles.empty()) meshes.push_back(std::make_shared<const Mesh>(std::move(cone)));
}

void add_symbol(MeshList& meshes, const Snapshot::Platform& platform, const Camera& camera,
                const DrawingOptions& options) {
  const auto at = camera.project(platform.pose.position_world_m);
  if (!at) return;
  const double length_m = symbol_px * options.pixel_scale / camera.scale_at(at->depth_m);
  const raster::Rgb tint = colour(role_in(options, platform.id, Role::solid), options.dark);
  Mesh mesh = symbol_mesh(platform.symbol->symbol, platform.pose.position_world_m, platform.symbol->world_from_symbol,
                          length_m, tint);
  mesh.objects = {platform.id};
  meshes.push_back(std::make_shared<const Mesh>(std::move(mesh)));
}

}  // namespace

Solids solids_of(const Snapshot& snapshot, const Camera& camera, const DrawingOptions& options) {
  Solids solids;
  MeshList& meshes = solids.meshes;
  if (const auto& globe = snapshot.globe.at(options.dark ? 1 : 0);
      globe && options.ground_grid && shows_curvature(camera))
    meshes.push_back(globe);
  if (options.filled_surfaces && !snapshot.surfaces.empty())
    meshes.push_back(std::make_shared<const Mesh>(surfaces_mesh(snapshot, options)));
  solids.scenery = meshes.size();
  for (const Snapshot::Radar& radar : snapshot.radars) {
    if (options.hidden.contains(radar.id)) continue;
    if (options.illuminated && !radar.illuminated_world_m.empty())
      meshes.push_back(std::make_shared<const Mesh>(illuminated_mesh(radar, options.dark)));
    if (options.footprints) add_beam(meshes, radar, options);
  }
  if (options.symbols)
    for (const Snapshot::Platform& platform : snapshot.platforms)
      if (platform.symbol && !options.hidden.contains(platform.id)) add_symbol(meshes, platform, camera, options);
  return solids;
}

}  // namespace sarsim::picture
