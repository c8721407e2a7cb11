#include <algorithm>

#include "scene/check/check_objects.hpp"
#include "scene/check/check_values.hpp"

namespace sarsim::scene {

namespace {

void check_path(Findings& findings, const Platform& platform) {
  const bool moves = platform.path == Platform::Path::trajectory;
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
                     {.id = "attitude.not-moving",
                      .message = "the platform is aligned with its velocity but does not move",
                      .found = "a trajectory of single points",
                      .expected = "a trajectory of at least two points",
                      .hint = "Give a rotation instead."});
}

void check_rotation(Findings& findings, const Platform& platform) {
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
    findings.error(field, {.id = "motion-error.single-point",
                           .message = "the " + std::string(what) + " has a single point on one axis",
                           .found = "1 point",
                           .expected = "at least two points, or none for no error on that axis",
                           .hint = "The function is the response to white noise and needs a length in time."});
}

void check_errors(Findings& findings, const Platform& platform) {
  check_envelope(findings, "position_envelope", "position error function",
                 platform.position_error == Platform::MotionError::envelope, platform.position_envelope);
  check_envelope(findings, "rotation_envelope", "rotation error function",
                 platform.rotation_error == Platform::MotionError::envelope, platform.rotation_envelope);
}

}  // namespace

void check_platform(Findings& findings, const Platform& platform) {
  check_values(findings, platform);
  check_path(findings, platform);
  check_rotation(findings, platform);
  check_errors(findings, platform);
}

}  // namespace sarsim::scene
