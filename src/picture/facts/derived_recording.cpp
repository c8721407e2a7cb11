#include <algorithm>

#include <fmt/format.h>

#include "core/text/number_text.hpp"
#include "picture/facts/derived_parts.hpp"
#include "radar/path/path.hpp"
#include "raster/table/formats.hpp"
#include "scene/check/check_objects.hpp"
#include "scene/model/limits.hpp"
#include "simulate/plan/plan.hpp"
#include "simulate/resolve/conventions.hpp"

namespace sarsim::picture::derived {

namespace {

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

}  // namespace

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

}  // namespace sarsim::picture::derived
