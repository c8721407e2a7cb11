#include "picture/facts/derived_figures.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/maths/constants.hpp"
#include "core/text/number_text.hpp"
#include "picture/facts/derived_parts.hpp"
#include "radar/target/surface.hpp"
#include "scene/check/check.hpp"
#include "scene/model/cloud_points.hpp"
#include "scene/model/limits.hpp"
#include "simulate/resolve/resolved.hpp"

namespace sarsim::picture {

namespace derived {

namespace {

double rounded(double value) { return core::parse_number(fmt::format("{:.4g}", value)).value_or(value); }

bool is_one_of(const std::set<std::string>& fields, std::initializer_list<std::string_view> names) {
  return std::ranges::any_of(names, [&](std::string_view name) { return fields.contains(std::string(name)); });
}

void take_waveform(SoundRadar& sound, const std::set<std::string>& faulty) {
  const scene::Radar initial;
  scene::Radar& r = sound.radar;
  if (is_one_of(faulty,
                {"bandwidth_hz", "barker_code", "pulse_iq", "pulse_width_s", "rise_s", "fall_s", "envelope_gain"})) {
    sound.pulse = false;
    r.pulse = initial.pulse;
    r.bandwidth_hz = initial.bandwidth_hz;
    r.barker_code = initial.barker_code;
    r.pulse_iq = {};
    r.pulse_width_s = initial.pulse_width_s;
    r.envelope = initial.envelope;
    r.rise_s = r.fall_s = 0.0;
    r.envelope_gain = {};
  }
  if (is_one_of(faulty, {"prf_hz", "pri_s"})) {
    sound.repetition = false;
    r.repetition = initial.repetition;
    r.prf_hz = initial.prf_hz;
    r.pri_s = {};
  }
  if (is_one_of(faulty, {"carrier_hz", "carrier_step_hz", "carrier_steps", "pulses_per_step", "carrier_list_hz"})) {
    sound.carrier = false;
    r.carrier = initial.carrier;
    r.carrier_hz = initial.carrier_hz;
    r.carrier_step_hz = initial.carrier_step_hz;
    r.carrier_steps = initial.carrier_steps;
    r.pulses_per_step = initial.pulses_per_step;
    r.carrier_list_hz = {};
  }
}

void take_power(SoundRadar& sound, const std::set<std::string>& faulty) {
  scene::Radar& r = sound.radar;
  if (is_one_of(faulty, {"power_w", "transmit_gain", "receive_gain", "losses"})) {
    sound.power = false;
    r.power_w = scene::Radar{}.power_w;
    r.transmit_gain = r.receive_gain = r.losses = {};
  }
  if (faulty.contains("noise_temperature_k")) {
    sound.noise = false;
    r.noise_temperature_k = 0.0;
  }
}

void take_antenna(SoundRadar& sound, const std::set<std::string>& faulty) {
  scene::Radar& r = sound.radar;
  const bool antenna = std::ranges::any_of(faulty, [](const std::string& field) {
    return field.starts_with("transmit_antenna") || field.starts_with("receive_antenna");
  });
  if (antenna ||
      is_one_of(faulty, {"beam_elevation", "beam_azimuth", "beam_rate", "spot_world_m", "beam_target_world_m"})) {
    sound.antenna = false;
    r.transmit_antenna = r.receive_antenna = {};
    r.same_antenna = true;
    r.beam = scene::Radar::Beam::fixed;
    r.beam_elevation = r.beam_azimuth = r.beam_rate = {};
    r.spot_world_m = {};
    r.beam_target_world_m = {};
  }
}

}  // namespace

std::string rounded_text(double value, scene::Quantity quantity) {
  return scene::quantity_text(rounded(value), quantity);
}

void Figures::text(std::string label, std::string text, std::string formula, std::initializer_list<double> numbers) {
  if (std::ranges::any_of(numbers, [](double number) { return !std::isfinite(number); })) return;
  figures_.push_back({std::move(label), std::move(text), std::move(formula)});
}

void Figures::number(std::string label, double value, scene::Quantity quantity, std::string formula) {
  if (std::isfinite(value)) text(std::move(label), rounded_text(value, quantity), std::move(formula));
}

void Figures::plain(std::string label, double value, std::string_view unit, std::string formula) {
  if (!std::isfinite(value)) return;
  text(std::move(label), fmt::format("{:.4g}{}{}", value + 0.0, unit.empty() ? "" : " ", unit), std::move(formula));
}

std::set<std::string> faulty_fields(const scene::Scene& scene, std::string_view kind, std::size_t index) {
  std::set<std::string> fields;
  for (const core::Problem& problem : scene::check(scene))
    if (problem.severity == core::Severity::error && problem.subject.kind == kind && problem.subject.index == index)
      fields.insert(problem.subject.field);
  return fields;
}

SoundRadar sound_radar(const scene::Scene& scene, std::size_t index) {
  SoundRadar sound{scene.radars.at(index)};
  scene::Radar& r = sound.radar;
  r.platform = "Earth";
  // Neither shapes what is computed here: the filter's window and the gain over range.
  r.window = scene::Radar::Window::rectangular;
  r.hanning_pedestal = 1.0;
  r.window_gain = {};
  r.stc = scene::Radar::Stc::none;
  r.stc_gain = {};
  scene::Scene alone;
  alone.radars.push_back(r);
  const std::set<std::string> faulty = faulty_fields(alone, "radar");
  take_waveform(sound, faulty);
  take_power(sound, faulty);
  take_antenna(sound, faulty);
  return sound;
}

std::optional<scene::Platform> nominal_platform(scene::Platform platform, const scene::World& world) {
  // What depends on others cannot be looked at alone.
  if (!platform.parent.empty() || platform.path == scene::Platform::Path::relative) return std::nullopt;
  if (platform.name.empty()) platform.name = "Platform";
  platform.position_error = platform.rotation_error = scene::Platform::MotionError::gaussian;
  platform.position_stddev_m = {};
  platform.rotation_stddev = {};
  platform.position_envelope = {};
  platform.rotation_envelope = {};
  scene::Scene alone;
  alone.world = world;
  alone.platforms.push_back(std::move(platform));
  if (!faulty_fields(alone, "platform").empty()) return std::nullopt;
  return std::move(alone.platforms.front());
}

void platform_figures(Figures& figures, const scene::Scene& scene, std::size_t index, double time_s) {
  auto nominal = nominal_platform(scene.platforms.at(index), scene.world);
  if (!nominal) return;
  scene::Scene alone;
  alone.options.profile = scene.options.profile;
  alone.world = scene.world;
  alone.platforms.push_back(std::move(*nominal));
  const radar::Pose pose = simulate::resolve(alone).platforms.front().track.at(time_s, 0);
  const core::Vec3& at = pose.position_world_m;
  const core::Vec3& velocity = pose.velocity_world_mps;
  figures.text("Position",
               fmt::format("{}, {}, {}", rounded_text(at.x, scene::Quantity::length),
                           rounded_text(at.y, scene::Quantity::length), rounded_text(at.z, scene::Quantity::length)),
               fmt::format("x, y, z in the world at {:g} s", time_s), {at.x, at.y, at.z});
  figures.plain("Speed", core::norm(velocity), "m/s", "|dr/dt|");
  if (core::norm(velocity) == 0.0) return;
  figures.plain("Course", core::azimuth_rad(velocity) * core::deg_per_rad, "deg",
                "azimuth of the velocity, from +y towards +x");
  figures.plain("Climb", core::elevation_rad(velocity) * core::deg_per_rad, "deg", "elevation of the velocity");
}

void cloud_figures(Figures& figures, const scene::Scene& scene, std::size_t index) {
  const scene::Cloud& cloud = scene.clouds.at(index);
  if (scene::point_count(cloud) == 0) return;
  const scene::CloudPoints& points = *cloud.points;
  figures.text("Points", fmt::format("{}", points.arrays.size()),
               points.own_rcs ? "each with its cross-section" : "all with the cross-section of the cloud");
  const core::Vec3 extent_m = points.max_m - points.min_m;
  const core::Vec3 middle_m = 0.5 * (points.max_m + points.min_m);
  const auto triple = [](const core::Vec3& at) {
    return fmt::format("{}, {}, {}", rounded_text(at.x, scene::Quantity::length),
                       rounded_text(at.y, scene::Quantity::length), rounded_text(at.z, scene::Quantity::length));
  };
  figures.text("Extent", triple(extent_m), "of the box around the points, in the platform's frame",
               {extent_m.x, extent_m.y, extent_m.z});
  figures.text("Middle", triple(middle_m), "of that box", {middle_m.x, middle_m.y, middle_m.z});
}

void surface_figures(Figures& figures, const scene::Scene& scene, std::size_t index) {
  const auto& corners = scene.surfaces.at(index).corner_m;
  const core::Vec3 normal = core::cross(corners[1] - corners[0], corners[2] - corners[0]);
  const double area_m2 = 0.5 * core::norm(normal);
  if (!std::isfinite(area_m2)) return;
  figures.number("Area", area_m2, scene::Quantity::area, "|(p2 - p1) x (p3 - p1)|/2");
  figures.text("Scatterers",
               core::format_number(std::round(radar::expected_points(corners, simulate::surface_points_per_m2))),
               "one per square metre");
  if (area_m2 == 0.0) return;
  figures.plain("Normal azimuth", core::azimuth_rad(normal) * core::deg_per_rad, "deg",
                "of (p2 - p1) x (p3 - p1), the front");
  figures.plain("Normal elevation", core::elevation_rad(normal) * core::deg_per_rad, "deg",
                "of (p2 - p1) x (p3 - p1), the front");
}

}  // namespace derived

std::vector<DerivedFigure> derived_figures(const scene::Scene& scene, scene::ObjectId id, double time_s) {
  derived::Figures figures;
  if (!scene::has_object(scene, id) || !scene::computable(time_s)) return {};
  // What `check` lets pass can be computed; should something else stand in the way, the figures so far are what can be
  // said, and a panel must never fail over them.
  try {
    switch (id.kind) {
      case scene::ObjectKind::platform: derived::platform_figures(figures, scene, id.index, time_s); break;
      case scene::ObjectKind::target: derived::target_figures(figures, scene, id.index, time_s); break;
      case scene::ObjectKind::cloud: derived::cloud_figures(figures, scene, id.index); break;
      case scene::ObjectKind::surface: derived::surface_figures(figures, scene, id.index); break;
      case scene::ObjectKind::radar: derived::radar_figures_of(figures, scene, id.index); break;
      case scene::ObjectKind::simulation: derived::simulation_figures_of(figures, scene, id.index); break;
      case scene::ObjectKind::geometry: derived::geometry_figures(figures, scene, id.index); break;
    }
  } catch (const std::exception&) {
    return figures.take();
  }
  return figures.take();
}

}  // namespace sarsim::picture
