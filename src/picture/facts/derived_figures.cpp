#include "picture/facts/derived_figures.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <set>
#include <string_view>

#include <fmt/format.h>

#include "core/maths/constants.hpp"
#include "core/text/number_text.hpp"
#include "radar/path/path.hpp"
#include "radar/target/surface.hpp"
#include "raster/table/formats.hpp"
#include "scene/check/check.hpp"
#include "scene/check/check_objects.hpp"
#include "scene/model/cloud_points.hpp"
#include "scene/model/limits.hpp"
#include "scene/schema/fields.hpp"
#include "simulate/plan/plan.hpp"
#include "simulate/plan/pulse_geometry.hpp"
#include "simulate/resolve/conventions.hpp"
#include "simulate/resolve/resolved.hpp"
#include "simulate/survey/derived.hpp"

namespace sarsim::picture {

namespace {

// Collects figures; those that are no finite numbers are left out.
class Figures {
 public:
  // A text, said with these numbers.
  void text(std::string label, std::string text, std::string formula, std::initializer_list<double> numbers = {});
  // A number with the unit that suits it, four digits.
  void number(std::string label, double value, scene::Quantity quantity, std::string formula);
  // A number with a fixed unit, four digits.
  void plain(std::string label, double value, std::string_view unit, std::string formula);
  [[nodiscard]] std::vector<DerivedFigure> take() { return std::move(figures_); }

 private:
  std::vector<DerivedFigure> figures_;
};

// What of a radar can be computed with. A faulty part is replaced by the initial one, and what depends on it is not to
// be shown.
struct SoundRadar {
  scene::Radar radar;  // Stands on "Earth".
  bool pulse = true;
  bool repetition = true;
  bool carrier = true;
  bool power = true;
  bool noise = true;
  bool antenna = true;  // Antennas and direction.
};

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

// Four digits with the unit that suits the size.
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

// Fields of one object with an error, as `check` names them, in a scene of a few objects.
std::set<std::string> faulty_fields(const scene::Scene& scene, std::string_view kind, std::size_t index = 0) {
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

// A platform without its random errors; nothing where it has an error of another kind.
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

// The figures of one object each, those of what moves at a time; faulty parts are left out.
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

constexpr double exact_integers = 0x1p53;

// Pulses that leave within a window; nothing where they cannot be counted.
template <class Product>
std::optional<radar::PulseRange> pulses_of(const Product& product, const SoundRadar& sound) {
  const auto repetition = scene::repetition_of(sound.radar);
  if (!sound.repetition || !repetition) return std::nullopt;
  if (!scene::computable(product.time_start_s) || !scene::computable(product.time_end_s)) return std::nullopt;
  const double farthest_s = std::max(std::abs(product.time_start_s), std::abs(product.time_end_s));
  if (farthest_s / repetition->mean_interval_s() >= exact_integers) return std::nullopt;
  return repetition->pulses_in(product.time_start_s, product.time_end_s);
}

template <class Product>
bool window_is_sound(const Product& product) {
  return scene::computable(product.range_start_m) && scene::computable(product.range_end_m) &&
         product.range_end_m > product.range_start_m;
}

void pulse_figures(Figures& figures, const std::optional<radar::PulseRange>& pulses) {
  if (!pulses) return;
  figures.text(
      "Pulses",
      pulses->count() > 0 ? fmt::format("{} ({} to {})", pulses->count(), pulses->first, pulses->last) : "none",
      "sent from the start to the end, both included");
}

struct Shape {
  double rows;
  double columns;
};

// Of a synthetic range profile a row holds a burst, each sample of which becomes a profile of as many bins as steps.
Shape shape_of(const scene::Simulation& simulation, const scene::Radar& radar, const radar::PulseRange& pulses,
               double samples) {
  if (simulation.processing != scene::Processing::srp) return {static_cast<double>(pulses.count()), samples};
  const std::int64_t burst = std::max<std::int64_t>(1, std::int64_t{radar.carrier_steps} * radar.pulses_per_step);
  const std::int64_t first = -radar::floor_divide(-pulses.first, burst);
  const std::int64_t beyond = radar::floor_divide(pulses.last + 1, burst);
  return {static_cast<double>(std::max<std::int64_t>(0, beyond - first)), samples * radar.carrier_steps};
}

void size_figures(Figures& figures, const scene::Simulation& simulation, const Shape& shape) {
  figures.text(
      "Size", fmt::format("{} rows of {} samples", core::format_number(shape.rows), core::format_number(shape.columns)),
      "a row for each pulse, or for each burst of a synthetic range profile", {shape.rows, shape.columns});
  const raster::Format& format = raster::format_of(simulation.format);
  const double bytes = format.max_sample_bytes(std::clamp(simulation.bits, 1, 64));
  figures.text(
      "File",
      fmt::format("{}{}", format.is_text() ? "up to " : "", core::bytes_text(shape.rows * shape.columns * bytes)),
      fmt::format("rows x samples x {:g} bytes", bytes));
}

void unambiguous_figure(Figures& figures, const scene::Simulation& simulation, const scene::Radar& radar,
                        double light_speed_mps) {
  const auto repetition = scene::repetition_of(radar);
  if (!repetition) return;
  const double range_m = radar::range_of(repetition->shortest_interval_s(), light_speed_mps);
  const bool within = simulation.range_end_m <= range_m;
  figures.text("Unambiguous range",
               fmt::format("{}, {}", rounded_text(range_m, scene::Quantity::length),
                           within ? "the window lies within" : "the window reaches beyond"),
               "c PRI/2 of the shortest interval", {range_m});
}

void converter_figures(Figures& figures, const scene::Simulation& simulation) {
  if (simulation.bits < 1 || simulation.bits > 64 || !scene::computable(simulation.lsb_v)) return;
  const double counts = std::max(1.0, std::ldexp(1.0, simulation.bits - 1) - 1.0);
  figures.plain("Dynamic range", 20.0 * std::log10(counts), "dB", "20 log10(2^(bits-1) - 1)");
  if (simulation.lsb_v > 0.0)
    figures.number("Full scale", simulation.lsb_v * counts, scene::Quantity::voltage, "LSB (2^(bits-1) - 1)");
  else
    figures.text("LSB", "estimated when it runs", "largest magnitude/(2^(bits-1) - 1)");
}

void simulation_figures_of(Figures& figures, const scene::Scene& scene, std::size_t index) {
  const scene::Simulation& simulation = scene.simulations.at(index);
  const double c = simulate::conventions_of(scene.options.profile).light_speed_mps;
  const std::size_t radar_index = scene::find_radar(scene, simulation.radar);
  const bool rate = scene::computable(simulation.sample_rate_hz) && simulation.sample_rate_hz > 0.0;
  const double samples = rate && window_is_sound(simulation) ? simulate::sample_count(simulation, c) : 0.0;
  if (rate)
    figures.number("Sample spacing", radar::range_of_cycle(simulation.sample_rate_hz, c), scene::Quantity::length,
                   "c/(2 fs)");
  if (samples >= 1.0) figures.text("Range samples", core::format_number(samples), "round(2 fs (end - start)/c)");
  if (radar_index != scene::not_found) {
    const SoundRadar sound = sound_radar(scene, radar_index);
    const auto pulses = pulses_of(simulation, sound);
    pulse_figures(figures, pulses);
    const bool sizes = simulation.processing != scene::Processing::srp || sound.carrier;
    if (pulses && samples >= 1.0 && sizes)
      size_figures(figures, simulation, shape_of(simulation, sound.radar, *pulses, samples));
    const auto bandwidth_hz = scene::nominal_bandwidth_hz(sound.radar);
    if (rate && sound.pulse && bandwidth_hz && *bandwidth_hz > 0.0)
      figures.plain("Sampling ratio", simulation.sample_rate_hz / *bandwidth_hz, "x Nyquist",
                    "fs/B; below 1 the echoes alias");
    if (sound.repetition && window_is_sound(simulation)) unambiguous_figure(figures, simulation, sound.radar, c);
  }
  converter_figures(figures, simulation);
}

void geometry_figures(Figures& figures, const scene::Scene& scene, std::size_t index) {
  const scene::GeometryTable& table = scene.geometries.at(index);
  const std::size_t radar = scene::find_radar(scene, table.radar);
  if (radar == scene::not_found) return;
  pulse_figures(figures, pulses_of(table, sound_radar(scene, radar)));
}

constexpr std::size_t max_radars = 8;  // whose view of a target is told

void waveform_figures(Figures& figures, const SoundRadar& sound, const simulate::RadarFigures& f) {
  const bool shaped = sound.radar.pulse == scene::Radar::Pulse::user;
  if (sound.carrier && f.lowest_carrier_hz == f.highest_carrier_hz)
    figures.number("Wavelength", f.longest_wavelength_m, scene::Quantity::length, "lambda = c/f");
  else if (sound.carrier)
    figures.text("Wavelength",
                 fmt::format("{} to {}", rounded_text(f.shortest_wavelength_m, scene::Quantity::length),
                             rounded_text(f.longest_wavelength_m, scene::Quantity::length)),
                 "lambda = c/f", {f.shortest_wavelength_m, f.longest_wavelength_m});
  if (sound.pulse) {
    figures.number("Bandwidth", f.bandwidth_hz, scene::Quantity::frequency,
                   "|B| of a chirp, chips/Tp of a code, else 1/Tp; of a given pulse what holds 99 % of its energy");
    figures.number("Range resolution", f.range_resolution_m, scene::Quantity::length,
                   shaped ? "c/2 times the half-power width of the pulse's autocorrelation" : "c/(2 B)");
  }
  if (sound.carrier && f.synthetic_range_resolution_m > 0.0)
    figures.number("Synthetic range resolution", f.synthetic_range_resolution_m, scene::Quantity::length,
                   "c/(2 N step) of N frequency steps");
  if (!sound.pulse) return;
  figures.number("Pulse length", f.pulse_length_m, scene::Quantity::length,
                 "c Tp in space; half of it on the range axis");
  figures.plain("Time-bandwidth product", f.time_bandwidth, "", "B Tp");
}

void repetition_figures(Figures& figures, const SoundRadar& sound, const simulate::RadarFigures& f) {
  if (!sound.repetition) return;
  figures.number("Pulse interval", f.shortest_pri_s, scene::Quantity::time, "1/PRF, the shortest of a list");
  figures.number("Unambiguous range", f.unambiguous_range_m, scene::Quantity::length,
                 "c PRI/2 of the shortest interval");
  if (sound.carrier)
    figures.text("Unambiguous velocity", fmt::format("+/- {:.4g} m/s", f.unambiguous_speed_mps), "lambda PRF/4",
                 {f.unambiguous_speed_mps});
  if (!sound.pulse) return;
  figures.plain("Duty cycle", 100.0 * f.duty_cycle, "%", "Tp PRF");
  if (sound.power)
    figures.number("Mean power", f.mean_power_w, scene::Quantity::power, "P Tp PRF times the mean of |pulse|^2");
}

std::string watts(double value, std::string_view unit) { return core::with_prefix(value, unit, 4); }

// One radar and one target with what carries them, sound as far as the flags say.
struct Sighting {
  scene::Scene scene;
  SoundRadar radar;
  bool reflectivity = true;
};

// Puts the platform that `name` means into the small scene and makes the name exact; false where it cannot be used.
bool carry(const scene::Scene& scene, scene::Scene& into, std::string& name) {
  const std::size_t index = scene::find_platform(scene, name);
  if (index == scene::not_found) return core::equal_ignoring_case(name, "Earth");
  auto nominal = nominal_platform(scene.platforms[index], scene.world);
  if (!nominal) return false;
  name = nominal->name;
  const bool known = std::ranges::any_of(into.platforms, [&](const scene::Platform& p) { return p.name == name; });
  if (!known) into.platforms.push_back(std::move(*nominal));
  return true;
}

std::optional<Sighting> sighting_of(const scene::Scene& scene, const scene::Target& target, std::size_t radar) {
  Sighting s{.scene = {}, .radar = sound_radar(scene, radar)};
  s.scene.options.profile = scene.options.profile;
  s.scene.world = scene.world;
  scene::Target seen = target;
  scene::TargetTraits& traits = seen.traits.edit();
  traits.position_stddev_m = {};
  traits.rcs_stddev_m2 = 0.0;
  traits.azimuth_stddev = traits.elevation_stddev = {};
  s.radar.radar.platform = scene.radars[radar].platform;
  std::string carrier = *seen.platform;
  if (!carry(scene, s.scene, s.radar.radar.platform) || !carry(scene, s.scene, carrier)) return std::nullopt;
  seen.platform = carrier;
  s.scene.targets.push_back(seen);
  const std::set<std::string> faulty = faulty_fields(s.scene, "target");
  if (faulty.contains("position_m")) return std::nullopt;
  if (!faulty.empty()) {
    s.reflectivity = false;
    scene::Target bare;
    bare.platform = seen.platform;
    bare.position_m = seen.position_m;
    s.scene.targets.front() = bare;
  }
  return s;
}

// Moves a pulse of the radar to exactly this time, with the carrier that the nearest one has.
void send_at(scene::Radar& radar, double time_s) {
  const auto repetition = scene::repetition_of(radar);
  if (radar.carrier == scene::Radar::Carrier::single || !repetition) return;
  const double pulses = std::clamp(time_s / repetition->mean_interval_s(), -1e15, 1e15);
  const double guess_s = pulses * repetition->mean_interval_s();
  const radar::PulseRange near = repetition->pulses_in(guess_s - repetition->mean_interval_s(), guess_s);
  const std::int64_t pulse = near.count() > 0 ? near.last : std::llround(pulses);
  scene::Scene alone;
  alone.radars.push_back(radar);
  alone.radars.front().platform = "Earth";
  radar.carrier_hz = simulate::resolve_radar(alone, simulate::resolve(alone), 0).carrier.carrier_hz(pulse);
  radar.carrier = scene::Radar::Carrier::single;
}

void sighting_figures(Figures& figures, Sighting& s, double time_s, const std::string& suffix) {
  send_at(s.radar.radar, time_s);
  s.scene.radars.push_back(s.radar.radar);
  const simulate::ResolvedScene resolved = simulate::resolve(s.scene);
  simulate::Link radar = simulate::resolve_radar(s.scene, resolved, 0);
  if (std::abs(time_s) < 1e-200) time_s = 0.0;  // so that its reciprocal is a number
  if (time_s != 0.0) radar.repetition = radar::Repetition::constant(1.0 / std::abs(time_s));
  simulate::PulseGeometry geometry(resolved, radar);
  geometry.set_pulse(time_s < 0.0 ? -1 : time_s > 0.0 ? 1 : 0);
  const simulate::ScattererView view = geometry.view(0);
  figures.number("Range" + suffix, view.distance_m, scene::Quantity::length,
                 fmt::format("|r| at {:g} s, one way", time_s));
  figures.number("Delay" + suffix, view.delay_s, scene::Quantity::time, "2 R/(c - v)");
  figures.plain("Radial speed" + suffix, view.speed_mps, "m/s", "dR/dt, positive receding");
  const bool amplitude = s.reflectivity && s.radar.carrier && s.radar.power && s.radar.antenna;
  if (!amplitude || !std::isfinite(view.amplitude_sqrt_w)) return;
  const double power_w = view.amplitude_sqrt_w * view.amplitude_sqrt_w;
  figures.text("Received power" + suffix, power_w > 0.0 ? watts(power_w, "W") : "0 W, not seen",
               "Pt Gt Gr lambda^2 RCS/((4 pi)^3 R^4 L)", {power_w});
  const double noise_j = resolved.conventions.boltzmann_j_per_k * radar.noise_temperature_k;
  if (!s.radar.pulse || !s.radar.noise || !(noise_j > 0.0) || !(power_w > 0.0)) return;
  figures.plain("SNR" + suffix, 10.0 * std::log10(power_w * radar.pulse.width_s / noise_j), "dB",
                "Pr Tp/(k T): of one pulse, after a matched filter");
}

void radar_figures_of(Figures& figures, const scene::Scene& scene, std::size_t index) {
  const SoundRadar sound = sound_radar(scene, index);
  scene::Scene alone;
  alone.options.profile = scene.options.profile;
  alone.radars.push_back(sound.radar);
  const simulate::ResolvedScene resolved = simulate::resolve(alone);
  const simulate::RadarFigures f =
      simulate::radar_figures(simulate::resolve_radar(alone, resolved, 0), sound.radar.power_w, resolved.conventions);
  waveform_figures(figures, sound, f);
  repetition_figures(figures, sound, f);
  if (sound.noise && sound.pulse)
    figures.text("Noise power", f.noise_power_w > 0.0 ? watts(f.noise_power_w, "W") : "no noise", "k T B",
                 {f.noise_power_w});
}

void target_figures(Figures& figures, const scene::Scene& scene, std::size_t index, double time_s) {
  const std::size_t count = std::min(scene.radars.size(), max_radars);
  for (std::size_t radar = 0; radar < count; ++radar) {
    auto sighting = sighting_of(scene, scene.targets.at(index), radar);
    const std::string suffix = scene.radars.size() > 1 ? fmt::format(" ({})", scene.radars[radar].name) : "";
    if (sighting) sighting_figures(figures, *sighting, time_s, suffix);
  }
}

}  // namespace

std::vector<DerivedFigure> derived_figures(const scene::Scene& scene, scene::ObjectId id, double time_s) {
  Figures figures;
  if (!scene::has_object(scene, id) || !scene::computable(time_s)) return {};
  // What `check` lets pass can be computed; should something else stand in the way, the figures so far are what can be
  // said, and a panel must never fail over them.
  try {
    switch (id.kind) {
      case scene::ObjectKind::platform: platform_figures(figures, scene, id.index, time_s); break;
      case scene::ObjectKind::target: target_figures(figures, scene, id.index, time_s); break;
      case scene::ObjectKind::cloud: cloud_figures(figures, scene, id.index); break;
      case scene::ObjectKind::surface: surface_figures(figures, scene, id.index); break;
      case scene::ObjectKind::radar: radar_figures_of(figures, scene, id.index); break;
      case scene::ObjectKind::simulation: simulation_figures_of(figures, scene, id.index); break;
      case scene::ObjectKind::geometry: geometry_figures(figures, scene, id.index); break;
    }
  } catch (const std::exception&) {
    return figures.take();
  }
  return figures.take();
}

}  // namespace sarsim::picture
