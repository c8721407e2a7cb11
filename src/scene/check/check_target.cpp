#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "scene/check/check_objects.hpp"
#include "scene/check/check_values.hpp"
#include "scene/model/limits.hpp"

namespace sarsim::scene {

namespace {

void check_reflectivity(Findings& findings, double rcs_m2, const TargetTraits& traits) {
  if (rcs_m2 < 0.0)
    findings.warning(Consequence::lost_signal, "rcs_m2",
                     {.id = "target.negative-rcs",
                      .message = "the radar cross-section is negative and counts as zero: the target gives no echo",
                      .found = value_text(rcs_m2, "m2"),
                      .expected = "a number above 0",
                      .hint = rcs_m2 > -100.0 ? fmt::format("It is in m2, not in dBsm: {0:g} dBsm are {1:.4g} m2.",
                                                            rcs_m2, std::pow(10.0, 0.1 * rcs_m2))
                                              : std::string()});
  const bool used =
      traits.reflectivity == TargetTraits::Reflectivity::directional && traits.gain == TargetTraits::Gain::user;
  check_function(findings, {.field = "gain_db", .what = "reflectivity function", .parts = single_part, .used = used},
                 traits.gain_db.part);
}

}  // namespace

void check_target(Findings& findings, NameCheck& platforms, const Target& target) {
  platforms.resolve(findings, "platform", *target.platform);
  check_values(findings, target);
  check_reflectivity(findings, target.rcs_m2, *target.traits);
}

void check_cloud(Findings& findings, NameCheck& platforms, const Cloud& cloud) {
  platforms.resolve(findings, "platform", cloud.platform);
  check_values(findings, cloud);
  check_reflectivity(findings, cloud.rcs_m2, cloud.traits);
  if (cloud.file.empty())
    findings.error("file", {.id = "cloud.no-file",
                            .message = "the cloud has no file: its points are read from a table",
                            .expected = "the name of an NPY, CSV or HDF5 file"});
}

double points_of(const Surface& surface) {
  const auto& [a, b, c] = surface.corner_m;
  const double area_m2 = 0.5 * core::norm(core::cross(b - a, c - a));
  return std::max({area_m2, core::norm(b - a), core::norm(c - b), core::norm(a - c)});
}

void check_surface(Findings& findings, NameCheck& platforms, const Surface& surface) {
  platforms.resolve(findings, "platform", surface.platform);
  check_values(findings, surface);
  const auto& [a, b, c] = surface.corner_m;
  if (!is_sound<&Surface::corner_m, 0>(surface) || !is_sound<&Surface::corner_m, 1>(surface) ||
      !is_sound<&Surface::corner_m, 2>(surface))
    return;
  const double area_m2 = 0.5 * core::norm(core::cross(b - a, c - a));
  if (area_m2 > largest_surface_m2)
    findings.error("corner_m", {.id = "surface.too-large",
                                .message = "the surface is too large to be sampled at one point per square metre",
                                .found = value_text(area_m2, "m2"),
                                .expected = value_text(largest_surface_m2, "m2") + " or less",
                                .hint = "Corners are given in metres."});
  else if (const double points = points_of(surface); points > largest_surface_m2)
    findings.error("corner_m", {.id = "surface.too-long",
                                .message = "the surface is too long and thin to be sampled at one point per metre",
                                .found = value_text(points, "m") + " long",
                                .expected = value_text(largest_surface_m2, "m") + " or less",
                                .hint = "Corners are given in metres."});
  if (area_m2 == 0.0)
    findings.warning(Consequence::lost_signal, "corner_m",
                     {.id = "surface.no-area",
                      .message = "the surface has no area and reflects nothing",
                      .found = "three corners on a line",
                      .expected = "a triangle"});
}

}  // namespace sarsim::scene
