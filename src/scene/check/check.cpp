#include "scene/check/check.hpp"

#include <optional>
#include <utility>

#include "scene/check/check_motion.hpp"
#include "scene/check/check_objects.hpp"
#include "scene/check/check_values.hpp"
#include "scene/model/limits.hpp"

namespace sarsim::scene {

namespace {

template <class Objects>
std::vector<std::string_view> names_of(const Objects& objects) {
  std::vector<std::string_view> names;
  names.reserve(objects.size());
  for (const auto& object : objects) names.emplace_back(object.name);
  return names;
}

template <class Objects, class Check>
void check_each(Findings& findings, std::string_view kind, const Objects& objects, const Check& check_one) {
  for (std::size_t i = 0; i < objects.size(); ++i) {
    findings.about(kind, i);
    check_one(objects[i]);
  }
}

// Targets can be very many: ranges of them are checked on several threads, what is found is joined in their order.
void check_targets(Findings& findings, NameCheck& platforms, const std::vector<Target>& targets,
                   const core::WorkControl& control) {
  constexpr std::size_t range_targets = 16384;
  std::vector<Findings> parts((targets.size() + range_targets - 1) / range_targets);
  core::parallel_ranges(targets.size(), range_targets, control, [&](std::size_t begin, std::size_t end) {
    Findings& part = parts[begin / range_targets];
    NameCheck own = platforms.beginning_anew();
    for (std::size_t i = begin; i < end; ++i) {
      part.about("target", i);
      check_target(part, own, targets[i]);
    }
  });
  for (Findings& part : parts) findings.append(std::move(part));
}

// Surfaces are small one by one and may be many: all are filled with points.
void check_surfaces_together(Findings& findings, const std::vector<Surface>& surfaces) {
  double points = 0.0;
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    const double more = points_of(surfaces[i]);
    if (!(more <= largest_surface_m2)) continue;  // Reported by itself.
    points += more;
    if (points <= largest_surface_m2) continue;
    findings.about("surface", i);
    findings.error("corner_m",
                   {.id = "surfaces.too-large",
                    .message = "the surfaces together are too large to be sampled at one point per square metre",
                    .found = value_text(points, "points") + " up to this one",
                    .expected = value_text(largest_surface_m2, "points") + " or less of all surfaces",
                    .hint = "Corners are given in metres."});
    return;
  }
}

}  // namespace

void check_options(Findings& findings, const RunOptions& options) { check_values(findings, options); }

core::Problems check(const Scene& scene, const core::WorkControl& control) {
  Findings findings;
  NameCheck platforms("platform", names_of(scene.platforms));
  NameCheck radars("radar", names_of(scene.radars));
  platforms.check_definitions(findings);
  findings.about("world", 0);
  check_world(findings, scene);
  const PlatformChains chains(scene);
  check_each(findings, "platform", scene.platforms, [&](const Platform& p) {
    check_platform(findings, p);
    check_motion(findings, scene, chains, static_cast<std::size_t>(&p - scene.platforms.data()));
  });
  check_each(findings, "surface", scene.surfaces, [&](const Surface& s) { check_surface(findings, platforms, s); });
  check_surfaces_together(findings, scene.surfaces);
  check_targets(findings, platforms, scene.targets, control);
  check_each(findings, "cloud", scene.clouds, [&](const Cloud& c) { check_cloud(findings, platforms, c); });
  radars.check_definitions(findings);
  check_each(findings, "radar", scene.radars, [&](const Radar& r) { check_radar(findings, platforms, r); });
  check_each(findings, "simulation", scene.simulations,
             [&](const Simulation& s) { check_simulation(findings, radars, scene, s); });
  check_each(findings, "geometry", scene.geometries,
             [&](const GeometryTable& g) { check_geometry_table(findings, radars, scene, g); });
  check_file_names(findings, scene);
  check_paths_between_points(findings, scene);
  check_function_ends(findings, scene);
  findings.about("options", 0);
  check_options(findings, scene.options);
  return std::move(findings).take();
}

}  // namespace sarsim::scene
