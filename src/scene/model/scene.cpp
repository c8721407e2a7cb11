#include "scene/model/scene.hpp"

#include <algorithm>

#include "core/text/number_text.hpp"

namespace sarsim::scene {

namespace {

template <class Objects>
std::size_t find_by_name(const Objects& objects, std::string_view name) {
  for (std::size_t i = 0; i < objects.size(); ++i)
    if (core::equal_ignoring_case(objects[i].name, name)) return i;
  std::size_t found = not_found;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    if (!share_prefix(objects[i].name, name)) continue;
    if (found != not_found) return not_found;
    found = i;
  }
  return found;
}

}  // namespace

bool share_prefix(std::string_view a, std::string_view b) {
  const std::size_t shared = std::min(a.size(), b.size());
  return shared > 0 && core::equal_ignoring_case(a.substr(0, shared), b.substr(0, shared));
}

bool identical(const TargetTraits& a, const TargetTraits& b) {
  const auto members = {&TargetTraits::azimuth, &TargetTraits::elevation, &TargetTraits::azimuth_stddev,
                        &TargetTraits::elevation_stddev};
  return a == b && identical(a.position_stddev_m, b.position_stddev_m) && identical(a.rcs_stddev_m2, b.rcs_stddev_m2) &&
         std::ranges::all_of(members, [&](const auto member) { return identical(a.*member, b.*member); }) &&
         std::ranges::equal(a.gain_db.part[0].knots, b.gain_db.part[0].knots, identical<core::Knot>);
}

std::size_t find_platform(const Scene& scene, std::string_view name) {
  const std::size_t found = find_by_name(scene.platforms, name);
  // "Earth" is the world itself, not short for a platform "Earth2".
  const bool world = core::equal_ignoring_case(name, "Earth");
  if (world && found != not_found && !core::equal_ignoring_case(scene.platforms[found].name, name)) return not_found;
  return found;
}
std::size_t find_radar(const Scene& scene, std::string_view name) { return find_by_name(scene.radars, name); }

}  // namespace sarsim::scene
