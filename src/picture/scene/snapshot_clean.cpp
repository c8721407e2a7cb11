#include "picture/scene/snapshot_clean.hpp"

#include <algorithm>
#include <cmath>

namespace sarsim::picture {

namespace {

constexpr double shortest_envelope_s = 1e-6;  // of an integration envelope; below, steps outnumber integers
constexpr double max_low_pass_steps = 1e12;   // between 0 and a low-pass function's knots

core::Angle angle_or_zero(core::Angle angle) { return std::isfinite(angle.deg()) ? angle : core::Angle{}; }

// Finite knots, ascending; of knots at one place the first.
core::SampledFunction cleaned(const core::SampledFunction& function) {
  core::SampledFunction clean{function.method, {}};
  for (const core::Knot& knot : function.knots)
    if (std::isfinite(knot.x) && std::isfinite(knot.y)) clean.knots.push_back(knot);
  std::ranges::stable_sort(clean.knots, {}, &core::Knot::x);
  const auto same_place = [](const core::Knot& a, const core::Knot& b) { return a.x == b.x; };
  clean.knots.erase(std::unique(clean.knots.begin(), clean.knots.end(), same_place), clean.knots.end());
  if (clean.method != core::Interpolation::low_pass || clean.knots.size() < 2) return clean;
  const double first = clean.knots.front().x;
  const double last = clean.knots.back().x;
  const double step = (last - first) / static_cast<double>(clean.knots.size() - 1);
  if (std::max(std::abs(first), std::abs(last)) > max_low_pass_steps * step) clean.method = core::Interpolation::linear;
  return clean;
}

template <std::size_t N>
scene::UserFunction<N> cleaned(const scene::UserFunction<N>& function) {
  scene::UserFunction<N> clean;
  for (std::size_t i = 0; i < N; ++i) clean.part[i] = cleaned(function.part[i]);
  return clean;
}

scene::UserFunction<3> cleaned_envelope(const scene::UserFunction<3>& envelope) {
  scene::UserFunction<3> clean = cleaned(envelope);
  for (core::SampledFunction& part : clean.part) {
    if (part.knots.size() < 2) continue;
    const double support = part.knots.back().x - part.knots.front().x;
    const bool far = std::abs(part.knots.front().x) > longest_time_s;
    if (support < shortest_envelope_s || !std::isfinite(support) || far) part.knots.clear();
  }
  return clean;
}

std::array<core::Angle, 3> cleaned(const std::array<core::Angle, 3>& angles) {
  return {angle_or_zero(angles[0]), angle_or_zero(angles[1]), angle_or_zero(angles[2])};
}

scene::Platform cleaned(const scene::Platform& platform) {
  scene::Platform clean = platform;
  clean.position_m = finite_or_zero(platform.position_m);
  clean.trajectory_m = cleaned(platform.trajectory_m);
  clean.rotation = cleaned(platform.rotation);
  clean.rotation_deg = cleaned(platform.rotation_deg);
  clean.rotation_rate = cleaned(platform.rotation_rate);
  clean.position_stddev_m = finite_or_zero(platform.position_stddev_m);
  clean.position_envelope = cleaned_envelope(platform.position_envelope);
  clean.rotation_stddev = cleaned(platform.rotation_stddev);
  clean.rotation_envelope = cleaned_envelope(platform.rotation_envelope);
  return clean;
}

}  // namespace

bool is_finite(const core::Vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

double finite_or_zero(double value) { return std::isfinite(value) ? value : 0.0; }

core::Vec3 finite_or_zero(const core::Vec3& v) {
  return {finite_or_zero(v.x), finite_or_zero(v.y), finite_or_zero(v.z)};
}

scene::Radar cleaned(const scene::Radar& radar) {
  scene::Radar clean;
  clean.platform = "Earth";
  clean.transmit_antenna = radar.transmit_antenna;
  clean.transmit_antenna.gain_db = cleaned(radar.transmit_antenna.gain_db);
  clean.beam = radar.beam;
  clean.beam_elevation = angle_or_zero(radar.beam_elevation);
  clean.beam_azimuth = angle_or_zero(radar.beam_azimuth);
  clean.beam_rate = angle_or_zero(radar.beam_rate);
  clean.spot_world_m = finite_or_zero(radar.spot_world_m);
  clean.beam_target_world_m = cleaned(radar.beam_target_world_m);
  return clean;
}

scene::Scene frames_of(const scene::Scene& scene) {
  scene::Scene frames;
  for (const scene::Platform& platform : scene.platforms) frames.platforms.push_back(cleaned(platform));
  frames.options = scene.options;
  frames.world = scene.world;
  return frames;
}

void put_to_rest(scene::Scene& frames) {
  for (scene::Platform& platform : frames.platforms) {
    platform.parent.clear();
    if (platform.path != scene::Platform::Path::trajectory) platform.path = scene::Platform::Path::stationary;
    if (platform.rotation_kind != scene::Platform::Rotation::user)
      platform.rotation_kind = scene::Platform::Rotation::constant;
    if (platform.position_error == scene::Platform::MotionError::gusts)
      platform.position_error = scene::Platform::MotionError::gaussian;
    platform.waves = scene::Platform::Waves::none;
  }
}

}  // namespace sarsim::picture
