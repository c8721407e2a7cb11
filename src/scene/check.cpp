#include "scene/check.hpp"

#include <utility>

#include "scene/check_objects.hpp"

namespace sarsim {

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

}  // namespace

void check_options(Findings& findings, const RunOptions& options) {
  findings.between("tolerance", "tolerance", options.tolerance, 1e-12, 0.1, "");
}

Problems check(const Scene& scene) {
  Findings findings;
  NameCheck platforms("platform", names_of(scene.platforms));
  NameCheck radars("radar", names_of(scene.radars));
  platforms.check_definitions(findings);
  check_each(findings, "platform", scene.platforms, [&](const Platform& p) { check_platform(findings, p); });
  check_each(findings, "surface", scene.surfaces, [&](const Surface& s) { check_surface(findings, platforms, s); });
  check_each(findings, "target", scene.targets, [&](const Target& t) { check_target(findings, platforms, t); });
  radars.check_definitions(findings);
  check_each(findings, "radar", scene.radars, [&](const Radar& r) { check_radar(findings, platforms, r); });
  check_each(findings, "simulation", scene.simulations,
             [&](const Simulation& s) { check_simulation(findings, radars, scene, s); });
  check_each(findings, "geometry", scene.geometries,
             [&](const GeometryTable& g) { check_geometry_table(findings, radars, scene, g); });
  check_file_names(findings, scene);
  findings.about("options", 0);
  check_options(findings, scene.options);
  platforms.report_undefined_earth(findings);
  return std::move(findings).take();
}

}  // namespace sarsim
