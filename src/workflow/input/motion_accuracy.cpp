#include "workflow/input/motion_accuracy.hpp"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/maths/constants.hpp"
#include "scene/check/path_looks.hpp"
#include "scene/model/read_path.hpp"

namespace sarsim::workflow {

namespace {

using scene::Platform;

core::Problem accuracy_problem(const std::string& file, std::string_view what, std::string found,
                               std::string expected) {
  return core::warning("motion-file.too-coarse", fmt::format("{}: {}", file, what))
      .found(std::move(found))
      .expected(std::move(expected))
      .hint(
          "use a file with closer or more accurate samples: interpolation errors between its samples enter all "
          "results");
}

}  // namespace

core::Problems problems_between_states(const scene::Scene& scene, std::size_t index) {
  const Platform& platform = scene.platforms[index];
  if (platform.path != Platform::Path::ephemeris || !platform.read_path || !platform.read_path->accuracy) return {};
  const scene::ReadAccuracy& accuracy = *platform.read_path->accuracy;
  const std::vector<scene::Look> looks = scene::looks_of(scene, index);
  if (looks.empty()) return {};
  const scene::Look& look = *std::ranges::min_element(looks, {}, &scene::Look::wavelength_m);
  const double limit_m = scene::tolerated_wavelengths * look.wavelength_m;
  if (!(accuracy.error > limit_m)) return {};
  return {accuracy_problem(
      platform.ephemeris_file, "its states are too far apart, or too inaccurate, for the wavelength",
      fmt::format(
          "about {:.3g} m off between states near {:.6g} s, {:.3g} wavelengths of radar {}; a state every {:.6g} s",
          accuracy.error, accuracy.at_s, accuracy.error / look.wavelength_m, look.radar, accuracy.spacing_s),
      fmt::format("less than 1/16 of a wavelength, {:.3g} mm", 1e3 * limit_m))};
}

core::Problems problems_between_attitudes(const scene::Scene& scene, std::size_t index) {
  const Platform& platform = scene.platforms[index];
  if (platform.rotation_kind != Platform::Rotation::quaternions || !platform.read_attitude ||
      !platform.read_attitude->accuracy)
    return {};
  const scene::ReadAccuracy& accuracy = *platform.read_attitude->accuracy;
  const double arm_m = scene::arm_m(scene, index);
  const auto share = [&](const scene::Look& look) {
    return accuracy.error * std::max(arm_m / (scene::tolerated_wavelengths * look.wavelength_m),
                                     1.0 / (scene::tolerated_beamwidths * look.beamwidth_rad));
  };
  const std::vector<scene::Look> looks = scene::looks_of(scene, index);
  if (looks.empty()) return {};
  const scene::Look& look = *std::ranges::max_element(looks, {}, share);
  if (!(share(look) > 1.0)) return {};
  return {accuracy_problem(
      platform.attitude_file, "its attitudes are too far apart, or too inaccurate",
      fmt::format("about {:.3g} deg off between attitudes near {:.6g} s; one every {:.6g} s",
                  accuracy.error * core::deg_per_rad, accuracy.at_s, accuracy.spacing_s),
      fmt::format(
          "less than {:.3g} deg for radar {}: 1/16 of its beam, or of its wavelength at {:.3g} m from the origin",
          accuracy.error / share(look) * core::deg_per_rad, look.radar, arm_m))};
}

}  // namespace sarsim::workflow
