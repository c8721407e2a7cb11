#include "scene/check.hpp"

#include <optional>
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

// Targets can be very many: ranges of them are checked on several threads, what is found is joined in their order.
void check_targets(Findings& findings, NameCheck& platforms, const std::vector<Target>& targets,
                   const WorkControl& control) {
  constexpr std::size_t range_targets = 16384;
  struct Part {
    Findings findings;
    std::optional<NameCheck> platforms;
  };
  std::vector<Part> parts((targets.size() + range_targets - 1) / range_targets);
  parallel_ranges(targets.size(), range_targets, control, [&](std::size_t begin, std::size_t end) {
    Part& part = parts[begin / range_targets];
    part.platforms = platforms.beginning_anew();
    for (std::size_t i = begin; i < end; ++i) {
      part.findings.about("target", i);
      check_target(part.findings, *part.platforms, targets[i]);
    }
  });
  for (Part& part : parts) {
    findings.append(std::move(part.findings));
    platforms.append(*part.platforms);
  }
}

}  // namespace

void check_options(Findings& findings, const RunOptions& options) {
  findings.between("tolerance", "tolerance", options.tolerance, 1e-12, 0.1, "");
}

Problems check(const Scene& scene, const WorkControl& control) {
  Findings findings;
  NameCheck platforms("platform", names_of(scene.platforms));
  NameCheck radars("radar", names_of(scene.radars));
  platforms.check_definitions(findings);
  check_each(findings, "platform", scene.platforms, [&](const Platform& p) { check_platform(findings, p); });
  check_each(findings, "surface", scene.surfaces, [&](const Surface& s) { check_surface(findings, platforms, s); });
  check_targets(findings, platforms, scene.targets, control);
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
