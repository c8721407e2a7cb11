#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "scene/check/check_objects.hpp"
#include "scene/check/path_error.hpp"
#include "scene/check/path_looks.hpp"

namespace sarsim::scene {

namespace {

bool sound(const core::SampledFunction& part) {
  const auto finite = [](const core::Knot& knot) { return std::isfinite(knot.x) && std::isfinite(knot.y); };
  const auto not_ascending = [](const core::Knot& a, const core::Knot& b) { return !(a.x < b.x); };
  return std::ranges::all_of(part.knots, finite) &&
         std::ranges::adjacent_find(part.knots, not_ascending) == part.knots.end();
}

// The parts that stand for a smooth path. Straight lines are what their points say, and so is what has no points.
std::array<core::SampledFunction, 3> smooth_parts(const Platform& platform) {
  std::array<core::SampledFunction, 3> parts;
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (platform.trajectory_m.part[i].method != core::Interpolation::linear) parts[i] = platform.trajectory_m.part[i];
  return parts;
}

std::string hint_of(const Platform& platform, const core::InterpolationRules& rules) {
  const auto takes = [&](core::Interpolation method) {
    return std::ranges::any_of(platform.trajectory_m.part, [&](const core::SampledFunction& part) {
      return part.method == method && part.knots.size() > 2;
    });
  };
  const bool chords = rules.cubic_ends == core::CubicEnds::chords;
  const std::string ends = chords ? " and CUBIC_ENDS NOT_A_KNOT in $OPTIONS" : "";
  if (takes(core::Interpolation::low_pass)) return "Take CUBIC" + ends + ", or give more points.";
  if (chords) return "Set CUBIC_ENDS NOT_A_KNOT in $OPTIONS, or give more points.";
  return "Give more points.";
}

}  // namespace

void check_paths_between_points(Findings& findings, const Scene& scene) {
  const std::vector<Look> looks = looks_of(scene);
  const core::InterpolationRules rules(
      scene.options.profile == Profile::classic ? core::LowPassRule::origin : core::LowPassRule::first_knot,
      scene.options.cubic_ends);
  for (std::size_t i = 0; i < scene.platforms.size(); ++i) {
    const Platform& platform = scene.platforms[i];
    if (platform.path != Platform::Path::trajectory || !std::ranges::all_of(platform.trajectory_m.part, sound))
      continue;
    const std::array<core::SampledFunction, 3> parts = smooth_parts(platform);
    PathError worst;
    const Look* at = nullptr;
    for (const Look& look : looks) {
      const auto error = path_error(parts, rules, look.from_s, look.to_s);
      if (!error || error->error_m <= tolerated_wavelengths * look.wavelength_m) continue;
      if (at != nullptr && error->error_m / look.wavelength_m <= worst.error_m / at->wavelength_m) continue;
      worst = *error;
      at = &look;
    }
    if (at == nullptr) continue;
    findings.about("platform", i);
    findings.warning(Consequence::false_signal, "trajectory_m",
                     {.id = "path.deviates",
                      .message = "the path between its points may deviate from a smooth one",
                      .found = fmt::format("about {:.3g} m at {:.6g} s, {:.3g} wavelengths of radar {}", worst.error_m,
                                           worst.time_s, worst.error_m / at->wavelength_m, at->radar),
                      .expected = fmt::format("less than 1/16 of a wavelength, {:.3g} mm",
                                              1e3 * tolerated_wavelengths * at->wavelength_m),
                      .hint = hint_of(platform, rules)});
  }
}

}  // namespace sarsim::scene
