#include "scene/check/path_looks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <tuple>

#include "core/maths/constants.hpp"
#include "radar/path/path.hpp"
#include "scene/check/carrier_span.hpp"
#include "scene/model/scene_index.hpp"

namespace sarsim::scene {

namespace {

constexpr double isotropic_rad = std::numeric_limits<double>::infinity();

// Between the nearest points on both sides of the peak that are 3 dB below it.
double width_of(const core::SampledFunction& cut) {
  if (cut.knots.empty()) return isotropic_rad;
  const core::Knot& peak = *std::ranges::max_element(cut.knots, {}, &core::Knot::y);
  double nearest_deg = isotropic_rad;
  for (const core::Knot& knot : cut.knots)
    if (knot.y <= peak.y - 3.0) nearest_deg = std::min(nearest_deg, std::abs(knot.x - peak.x));
  return 2.0 * nearest_deg * core::rad_per_deg;
}

double beamwidth_of(const Antenna& antenna) {
  switch (antenna.pattern) {
    case Antenna::Pattern::isotropic: break;
    case Antenna::Pattern::sinx: return std::min(antenna.elevation_beamwidth.rad(), antenna.azimuth_beamwidth.rad());
    case Antenna::Pattern::user: return std::min(width_of(antenna.gain_db.part[0]), width_of(antenna.gain_db.part[1]));
  }
  return isotropic_rad;
}

double beamwidth_of(const Radar& radar) {
  const double sent = beamwidth_of(radar.transmit_antenna);
  return radar.same_antenna ? sent : std::min(sent, beamwidth_of(radar.receive_antenna));
}

// @param tables  those of geometry tables, too
template <class Wanted>
std::vector<Look> looks_if(const Scene& scene, bool tables, const Wanted& wanted) {
  // Of those that look at one time with one beamwidth the one with the shortest wavelength speaks for all.
  std::map<std::tuple<double, double, double>, std::size_t> of_times;
  std::vector<Look> looks;
  SceneIndex names(scene);
  const auto add = [&](const auto& products) {
    for (const auto& product : products) {
      const std::size_t at = names.radar(product.radar);
      if (at == not_found || !wanted(scene.radars[at])) continue;
      const Radar& radar = scene.radars[at];
      const auto carriers = carrier_span(radar);
      if (!carriers || !(carriers->highest_hz > 0.0) || !std::isfinite(carriers->highest_hz)) continue;
      const Look look{radar.name, radar::wavelength_of(carriers->highest_hz, core::exact_light_speed_mps),
                      beamwidth_of(radar), product.time_start_s, product.time_end_s};
      const auto [known, is_new] = of_times.try_emplace({look.from_s, look.to_s, look.beamwidth_rad}, looks.size());
      if (is_new)
        looks.push_back(look);
      else if (look.wavelength_m < looks[known->second].wavelength_m)
        looks[known->second] = look;
    }
  };
  add(scene.simulations);
  if (tables) add(scene.geometries);
  return looks;
}

// Whether a platform is carried or led by another one, or is that one. Each is met once, whatever ways lead to it.
bool depends(SceneIndex& names, const Scene& scene, const std::string& name, std::size_t on) {
  std::vector<std::size_t> open{names.platform(name)};
  std::set<std::size_t> met;
  while (!open.empty()) {
    const std::size_t at = open.back();
    open.pop_back();
    if (at == on) return true;
    if (at == not_found || !met.insert(at).second) continue;
    const Platform& platform = scene.platforms[at];
    if (!platform.parent.empty()) open.push_back(names.platform(platform.parent));
    if (platform.path == Platform::Path::relative) open.push_back(names.platform(platform.leader));
  }
  return false;
}

}  // namespace

std::vector<Look> looks_of(const Scene& scene) {
  return looks_if(scene, false, [](const Radar&) { return true; });
}

std::vector<Look> looks_of(const Scene& scene, std::size_t platform) {
  SceneIndex names(scene);
  const auto carries = [&](const std::string& name) { return depends(names, scene, name, platform); };
  // Millions of targets share the names of few platforms.
  const std::string* known = nullptr;
  const auto is_carried = [&](const std::string& name) {
    if (&name == known) return false;
    known = &name;
    return carries(name);
  };
  const bool reflecting =
      std::ranges::any_of(scene.targets, [&](const Target& one) { return is_carried(*one.platform); }) ||
      std::ranges::any_of(scene.clouds, [&](const Cloud& one) { return is_carried(one.platform); }) ||
      std::ranges::any_of(scene.surfaces, [&](const Surface& one) { return is_carried(one.platform); });
  return looks_if(scene, true, [&](const Radar& radar) { return reflecting || carries(radar.platform); });
}

double arm_m(const Scene& scene, std::size_t platform) {
  const std::string& name = scene.platforms[platform].name;
  double arm = 0.0;
  for (const Target& target : scene.targets)
    if (*target.platform == name) arm = std::max(arm, core::norm(target.position_m));
  for (const Platform& one : scene.platforms)
    if (one.parent == name && one.path == Platform::Path::stationary) arm = std::max(arm, core::norm(one.position_m));
  return arm;
}

}  // namespace sarsim::scene
