#include "scene/check/check_objects.hpp"
#include "scene/model/limits.hpp"

namespace sarsim::scene {

namespace {

void check_reflectivity(Findings& findings, const Target& target) {
  if (findings.finite("rcs_m2", "radar cross-section", target.rcs_m2, "m2") && target.rcs_m2 < 0.0)
    findings.warning(Consequence::lost_signal, "rcs_m2",
                     {.message = "the radar cross-section is negative, which counts as zero: the target is not seen",
                      .found = value_text(target.rcs_m2, "m2"),
                      .expected = "a number above 0",
                      .hint = {}});
  findings.not_negative("rcs_stddev_m2", "standard deviation of the radar cross-section", target.rcs_stddev_m2, "m2");
  findings.finite("azimuth", "pointing azimuth", target.azimuth.deg(), "deg");
  findings.finite("elevation", "pointing elevation", target.elevation.deg(), "deg");
  findings.not_negative("azimuth_stddev", "standard deviation of the azimuth", target.azimuth_stddev.deg(), "deg");
  findings.not_negative("elevation_stddev", "standard deviation of the elevation", target.elevation_stddev.deg(),
                        "deg");
  const bool used = target.reflectivity == Target::Reflectivity::directional && target.gain == Target::Gain::user;
  check_function(findings, {.field = "gain_db", .what = "reflectivity function", .parts = single_part, .used = used},
                 target.gain_db.part);
}

}  // namespace

void check_target(Findings& findings, NameCheck& platforms, const Target& target) {
  platforms.resolve(findings, "platform", target.platform);
  findings.finite("position_m", "position", target.position_m, "m");
  findings.not_negative("position_stddev_m", "standard deviation of the position", target.position_stddev_m, "m");
  check_reflectivity(findings, target);
}

void check_surface(Findings& findings, NameCheck& platforms, const Surface& surface) {
  platforms.resolve(findings, "platform", surface.platform);
  bool sound = true;
  for (const core::Vec3& corner : surface.corner_m) sound = findings.finite("corner_m", "corner", corner, "m") && sound;
  const auto& [a, b, c] = surface.corner_m;
  if (!sound) return;
  const double area_m2 = 0.5 * core::norm(core::cross(b - a, c - a));
  if (area_m2 > largest_surface_m2)
    findings.error("corner_m", {.message = "the surface is too large to be filled with points, one per square metre",
                                .found = value_text(area_m2, "m2"),
                                .expected = value_text(largest_surface_m2, "m2") + " or less",
                                .hint = "Corners are given in metres."});
  if (area_m2 == 0.0)
    findings.warning(Consequence::lost_signal, "corner_m",
                     {.message = "the surface has no area and reflects nothing",
                      .found = "three corners on a line",
                      .expected = "a triangle",
                      .hint = {}});
}

}  // namespace sarsim::scene
