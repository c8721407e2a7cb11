#include <algorithm>
#include <array>

#include "scene/check/check_objects.hpp"

namespace sarsim::scene {

namespace {

core::Vec3 degrees(const std::array<core::Angle, 3>& angles) {
  return {angles[0].deg(), angles[1].deg(), angles[2].deg()};
}

void check_path(Findings& findings, const Platform& platform) {
  const bool moves = platform.path == Platform::Path::trajectory;
  findings.finite("position_m", "position", platform.position_m, "m");
  const bool sound = check_function(findings,
                                    {.field = "trajectory_m",
                                     .what = "trajectory",
                                     .parts = coordinate_parts,
                                     .used = moves,
                                     .empty = FunctionRule::Empty::constant_zero},
                                    platform.trajectory_m.part);
  if (!moves || !platform.aligned || !sound) return;
  if (std::ranges::all_of(platform.trajectory_m.part,
                          [](const core::SampledFunction& f) { return f.knots.size() < 2; }))
    findings.warning(Consequence::surprise, "aligned",
                     {.message = "the platform is aligned with its velocity but does not move",
                      .found = "a trajectory of single points",
                      .expected = "a trajectory of at least two points",
                      .hint = "Give a rotation instead."});
}

void check_rotation(Findings& findings, const Platform& platform) {
  findings.finite("rotation", "rotation", degrees(platform.rotation), "deg");
  findings.finite("rotation_rate", "rotation rate", degrees(platform.rotation_rate), "deg/s");
  check_function(findings,
                 {.field = "rotation_deg",
                  .what = "rotation",
                  .parts = coordinate_parts,
                  .used = platform.rotation_kind == Platform::Rotation::user,
                  .empty = FunctionRule::Empty::constant_zero},
                 platform.rotation_deg.part);
}

// No points: no error on that axis. One point has no length over which noise could be integrated.
void check_envelope(Findings& findings, std::string_view field, std::string_view what, bool used,
                    const UserFunction<3>& envelope) {
  check_function(
      findings,
      {.field = field, .what = what, .parts = coordinate_parts, .used = used, .empty = FunctionRule::Empty::allowed},
      envelope.part);
  if (used && std::ranges::any_of(envelope.part, [](const core::SampledFunction& f) { return f.knots.size() == 1; }))
    findings.error(field, {.message = "the " + std::string(what) + " has a single point on one axis",
                           .found = "1 point",
                           .expected = "at least two points, or none for no error on that axis",
                           .hint = "The function is the response to white noise and needs a length in time."});
}

void check_errors(Findings& findings, const Platform& platform) {
  findings.not_negative("position_stddev_m", "standard deviation of the position", platform.position_stddev_m, "m");
  findings.not_negative("rotation_stddev", "standard deviation of the rotation", degrees(platform.rotation_stddev),
                        "deg");
  check_envelope(findings, "position_envelope", "position error function",
                 platform.position_error == Platform::MotionError::envelope, platform.position_envelope);
  check_envelope(findings, "rotation_envelope", "rotation error function",
                 platform.rotation_error == Platform::MotionError::envelope, platform.rotation_envelope);
}

}  // namespace

void check_platform(Findings& findings, const Platform& platform) {
  check_path(findings, platform);
  check_rotation(findings, platform);
  check_errors(findings, platform);
}

}  // namespace sarsim::scene
