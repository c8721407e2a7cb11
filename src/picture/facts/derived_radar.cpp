#include <algorithm>

#include <fmt/format.h>

#include "core/text/number_text.hpp"
#include "picture/facts/derived_parts.hpp"
#include "scene/check/check_objects.hpp"
#include "simulate/plan/pulse_geometry.hpp"
#include "simulate/survey/derived.hpp"

namespace sarsim::picture::derived {

namespace {

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

}  // namespace

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

}  // namespace sarsim::picture::derived
