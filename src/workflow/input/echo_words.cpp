#include "workflow/input/echo_words.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/maths/constants.hpp"
#include "core/maths/decibels.hpp"

namespace sarsim::workflow {

namespace {

// Points of a plane add up in phase to a mirror: they have no mean power of a resolution cell.
constexpr const char* surfaces_left_out = "the echoes of surfaces, which interfere, are left out here";

std::string one_echo(const simulate::TargetVisibility& sight) {
  return fmt::format("{:.4g} V of target {}", sight.amplitude_v, sight.target + 1);
}

std::string ratio_range(double low, double high) {
  const std::string first = decibel_text(low);
  const std::string last = decibel_text(high);
  return first == last ? first : first + " to " + last;
}

std::string snr_line(const std::vector<simulate::TargetVisibility>& sights) {
  const auto [low, high] = std::ranges::minmax(sights, {}, &simulate::TargetVisibility::snr);
  const auto [weak, strong] = std::ranges::minmax(sights, {}, &simulate::TargetVisibility::processed_snr);
  return fmt::format("    SNR {} per pulse, {} with all pulses integrated\n", ratio_range(low.snr, high.snr),
                     ratio_range(weak.processed_snr, strong.processed_snr));
}

void write_sight(core::JsonWriter& json, const char* key, const simulate::EchoSummary& summary,
                 const simulate::TargetVisibility& sight) {
  json.key(key).begin_object().member("target", sight.target + 1).member("amplitude_v", sight.amplitude_v);
  json.member("pulse", static_cast<double>(sight.pulse));
  if (summary.noise) json.member("snr", sight.snr).member("processed_snr", sight.processed_snr);
  if (summary.directive)
    json.member("off_azimuth_rad", sight.off_azimuth_rad)
        .member("off_elevation_rad", sight.off_elevation_rad)
        .member("pattern", sight.pattern);
  json.end_object();
}

}  // namespace

std::string decibel_text(double ratio) {
  return ratio > 0.0 ? fmt::format("{:.1f} dB", std::round(10.0 * core::power_db(ratio)) / 10.0 + 0.0) : "none";
}

std::string off_beam_text(const simulate::TargetVisibility& sight, scene::Profile profile) {
  const bool is_signed = profile == scene::Profile::physical;
  // A thousandth of a degree is finer than any beam.
  const auto angle = [&](double rad) {
    return std::round(1e3 * core::deg_per_rad * (is_signed ? rad : std::abs(rad))) / 1e3 + 0.0;
  };
  return fmt::format("{:.4g} deg in azimuth and {:.4g} deg in elevation off the beam ({})",
                     angle(sight.off_azimuth_rad), angle(sight.off_elevation_rad), decibel_text(sight.pattern));
}

std::string echo_text(const scene::Scene& scene, const simulate::EchoSummary& summary) {
  const std::string begin =
      fmt::format("  simulation {} ({}): ", summary.simulation + 1, scene.simulations.at(summary.simulation).file);
  if (summary.sights.empty()) return scene.surfaces.empty() ? "" : begin + surfaces_left_out + "\n";
  const bool all = summary.sights.size() == summary.in_window;
  std::string text = begin + fmt::format("{} of {} targets in the window{}\n", summary.in_window, summary.targets,
                                         all ? "" : fmt::format(", {} of them examined", summary.sights.size()));
  if (!scene.surfaces.empty()) text += std::string("    ") + surfaces_left_out + "\n";
  const simulate::TargetVisibility& strongest = summary.strongest();
  const simulate::TargetVisibility& weakest = summary.weakest();
  text += "    strongest echo " + one_echo(strongest);
  if (strongest.target != weakest.target) text += ", weakest " + one_echo(weakest);
  text += "\n";
  if (summary.noise) text += snr_line(summary.sights);
  if (!summary.directive) return text;
  const auto [far, near] = std::ranges::minmax(summary.sights, {}, &simulate::TargetVisibility::pattern);
  text += fmt::format("    target {}: {}\n", near.target + 1, off_beam_text(near, scene.options.profile));
  if (far.target != near.target)
    text += fmt::format("    target {}: {}\n", far.target + 1, off_beam_text(far, scene.options.profile));
  return text;
}

void write_echoes(core::JsonWriter& json, const simulate::EchoSummary& summary) {
  json.member("targets_in_window", summary.in_window);
  if (summary.sights.empty()) return;
  write_sight(json, "strongest", summary, summary.strongest());
  write_sight(json, "weakest", summary, summary.weakest());
}

}  // namespace sarsim::workflow
