#include "cli/command/info_scene.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>

#include <fmt/format.h>

#include "cli/command/info_places.hpp"
#include "cli/shell/report.hpp"
#include "core/build/version.hpp"
#include "core/task/parallel.hpp"
#include "core/text/facts.hpp"
#include "core/text/number_text.hpp"
#include "scene/model/world_frame.hpp"
#include "simulate/survey/derived.hpp"
#include "simulate/survey/survey.hpp"
#include "simulate/survey/survey_echoes.hpp"
#include "workflow/focus/image_forecast.hpp"
#include "workflow/input/cloud_input.hpp"
#include "workflow/input/echo_words.hpp"
#include "workflow/input/scene_words.hpp"
#include "workflow/record/record_size.hpp"

namespace sarsim::cli {

namespace {

constexpr std::size_t max_names_listed = 20;
constexpr std::size_t max_looked_at = 1000;  // targets whose passage through the beam is looked at

std::string between(double low, double high, std::string_view unit) {
  // Adding 0 turns -0 into 0.
  if (low == high) return core::with_prefix(low + 0.0, unit);
  return core::with_prefix(low + 0.0, unit) + " to " + core::with_prefix(high + 0.0, unit);
}

std::string decibels(double ratio) { return fmt::format("{:.1f} dB", 10.0 * std::log10(ratio)); }

// @param shaped  whether the pulse is user-defined, whose resolution is a width and not c/2B
core::Facts facts_of(const simulate::RadarFigures& r, bool shaped) {
  const bool steps = r.synthetic_range_resolution_m > 0.0;
  return {core::worded("lowest_carrier_hz", "carrier", r.lowest_carrier_hz,
                       between(r.lowest_carrier_hz, r.highest_carrier_hz, "Hz")),
          {"highest_carrier_hz", "", r.highest_carrier_hz},
          core::worded("shortest_wavelength_m", "wavelength", r.shortest_wavelength_m,
                       between(r.shortest_wavelength_m, r.longest_wavelength_m, "m")),
          {"longest_wavelength_m", "", r.longest_wavelength_m},
          {"bandwidth_hz", "bandwidth", r.bandwidth_hz, "Hz"},
          {"range_resolution_m", shaped ? "range resolution" : "range resolution c/2B", r.range_resolution_m, "m"},
          {steps ? "synthetic_range_resolution_m" : "", steps ? "over all frequency steps" : "",
           r.synthetic_range_resolution_m, "m"},
          {"pulse_length_m", "pulse length", r.pulse_length_m, "m"},
          {"time_bandwidth", "time-bandwidth product", r.time_bandwidth},
          {"mean_prf_hz", "PRF (mean)", r.mean_prf_hz, "Hz"},
          {"shortest_pri_s", "shortest PRI", r.shortest_pri_s, "s"},
          {"unambiguous_range_m", "unambiguous range", r.unambiguous_range_m, "m"},
          core::worded("unambiguous_speed_mps", "unambiguous speed", r.unambiguous_speed_mps,
                       "+-" + core::with_prefix(r.unambiguous_speed_mps, "m/s")),
          core::worded("duty_cycle", "duty cycle", r.duty_cycle, fmt::format("{:.4g} %", 100.0 * r.duty_cycle)),
          {"mean_power_w", "mean power", r.mean_power_w, "W"},
          {"noise_power_w", "noise power kTB", r.noise_power_w, "W", core::significant(4)}};
}

core::Facts facts_of(const simulate::Plan& plan, const simulate::SimulationFigures& s,
                     const simulate::EchoSurvey& survey) {
  const unsigned threads = core::thread_count(0);
  const workflow::RecordingSize size = workflow::size_of(plan, threads, false);
  const radar::PulseRange& pulses = plan.acquisition.timing.pulses;
  return {core::worded("pulses", "pulses", static_cast<double>(pulses.count()),
                       fmt::format("{} ({} to {})", pulses.count(), pulses.first, pulses.last)),
          {"rows", "rows", static_cast<double>(plan.acquisition.timing.rows)},
          {"columns", "samples of a row", static_cast<double>(plan.acquisition.reception.columns)},
          core::worded("bytes", "file size", size.bytes, core::bytes_text(size.bytes)),
          core::worded("seconds", "expected time", size.seconds,
                       fmt::format("{} on {}", core::duration_text(size.seconds), counted(threads, "thread"))),
          core::worded("memory_bytes", "expected memory", size.memory_bytes, core::bytes_text(size.memory_bytes)),
          core::worded("first_delay_s", "window, delay", s.first_delay_s,
                       core::with_prefix(s.first_delay_s, "s") + " to " + core::with_prefix(s.last_delay_s, "s")),
          {"last_delay_s", "", s.last_delay_s},
          {"column_spacing_m", "column spacing", s.column_spacing_m, "m"},
          {"sampling_ratio", "sampling/bandwidth", s.sampling_ratio},
          {"noise_power_w", "noise power per sample", s.noise_power_w, "W", core::significant(4)},
          {"pulse_motion_rad", "intra-pulse phase error", s.pulse_motion_rad, "rad", core::significant(2)},
          core::worded("lowest_doppler_hz", "Doppler band", survey.lowest_doppler_hz,
                       between(survey.lowest_doppler_hz, survey.highest_doppler_hz, "Hz")),
          {"highest_doppler_hz", "", survey.highest_doppler_hz},
          {"largest_echo_v", "strongest echo", s.largest_echo_v, "V", core::significant(4)},
          {"largest_sum_v", "magnitude bound", s.largest_sum_v, "V", core::significant(4)},
          core::worded("suggested_lsb_v", "LSB without clipping", s.suggested_lsb_v,
                       fmt::format("{:.4g} mV", 1e3 * s.suggested_lsb_v))};
}

// @param sight  nothing: the target was not looked at in that detail
std::string target_line(std::size_t number, const simulate::TargetSurvey& t, const simulate::TargetVisibility* sight,
                        bool directive, scene::Profile profile) {
  std::string text =
      fmt::format("    target {:<6} {}, Doppler {}, {:.4g} V", number, between(t.nearest_m, t.farthest_m, "m"),
                  between(t.lowest_doppler_hz, t.highest_doppler_hz, "Hz"), t.largest_amplitude_v);
  if (t.snr > 0.0) text += ", SNR " + decibels(t.snr);
  if (sight != nullptr && sight->processed_snr > 0.0)
    text += fmt::format(" ({} with all pulses)", workflow::decibel_text(sight->processed_snr));
  if (sight != nullptr && directive) text += ", " + workflow::off_beam_text(*sight, profile);
  return text + (t.in_window ? "\n" : ", outside the window\n");
}

void write_survey_json(core::JsonWriter& json, std::size_t number, const simulate::TargetSurvey& t,
                       const simulate::TargetVisibility* sight) {
  json.begin_object().member("number", number).member("nearest_m", t.nearest_m).member("farthest_m", t.farthest_m);
  json.member("lowest_doppler_hz", t.lowest_doppler_hz).member("highest_doppler_hz", t.highest_doppler_hz);
  json.member("largest_amplitude_v", t.largest_amplitude_v).member("snr", t.snr).member("in_window", t.in_window);
  if (sight != nullptr)
    json.member("best_pulse", static_cast<double>(sight->pulse))
        .member("processed_snr", sight->processed_snr)
        .member("off_azimuth_rad", sight->off_azimuth_rad)
        .member("off_elevation_rad", sight->off_elevation_rad)
        .member("pattern", sight->pattern);
  json.end_object();
}

// Gathers the same facts as text and as JSON.
class SceneInfo {
 public:
  SceneInfo(const SceneInfoArguments& arguments, const scene::Scene& scene, const core::WorkControl& control)
      : arguments_(arguments), scene_(scene), control_(control) {
    json_.begin_object().member("sarsim", core::program_version).member("script", arguments.path);
    text_ = arguments.path + ": " + workflow::profile_word(scene.options.profile) + " profile, " +
            workflow::pulse_word(scene.options.pulse) + " pulses, seed " + std::to_string(scene.options.seed) + "\n";
    json_.member("profile", workflow::profile_word(scene.options.profile))
        .member("pulse", workflow::pulse_word(scene.options.pulse));
    json_.member("seed", scene.options.seed).member("tolerance", scene.options.tolerance);
  }

  void add_objects() {
    json_.key("objects").begin_object();
    add_named("platforms", names_of(scene_.platforms));
    add_named("radars", names_of(scene_.radars));
    const auto count = [this](const char* kind, std::size_t number) {
      json_.member(kind, number);
      if (number > 0) text_ += fmt::format("  {:<24} {}\n", kind, number);
    };
    count("targets", scene_.targets.size());
    count("clouds", scene_.clouds.size());
    if (!scene_.clouds.empty()) count("cloud_points", workflow::cloud_points(scene_));
    count("surfaces", scene_.surfaces.size());
    count("simulations", scene_.simulations.size());
    count("geometries", scene_.geometries.size());
    json_.end_object();
  }

  void add_world(const simulate::ResolvedScene& resolved) {
    text_ += world_text(scene_, resolved, arguments_.all, json_);
  }

  void add_radars(const simulate::ResolvedScene& resolved) {
    json_.key("radars").begin_array();
    for (std::size_t i = 0; i < scene_.radars.size(); ++i) {
      const scene::Radar& radar = scene_.radars[i];
      const core::Facts figures = facts_of(
          simulate::radar_figures(simulate::resolve_radar(scene_, resolved, i), radar.power_w, resolved.conventions),
          radar.pulse == scene::Radar::Pulse::user);
      json_.begin_object().member("name", radar.name).member("platform", radar.platform);
      core::write_json(json_, figures);
      json_.end_object();
      text_ += "\nradar " + radar.name + " on " + radar.platform + "\n" + core::text_of(figures);
    }
    json_.end_array();
  }

  void add_simulations(const std::shared_ptr<const simulate::ResolvedScene>& resolved,
                       const std::vector<simulate::EchoSummary>& echoes) {
    echoes_ = &echoes;
    json_.key("simulations").begin_array();
    for (std::size_t i = 0; i < scene_.simulations.size(); ++i)
      add_simulation(i, simulate::make_plan(scene_, i, resolved, simulate::Engine::automatic, control_.stop));
    json_.end_array();
  }

  [[nodiscard]] const std::string& text() const { return text_; }
  [[nodiscard]] std::string json() { return json_.end_object().text(); }

 private:
  template <class Objects>
  static std::vector<std::string> names_of(const Objects& objects) {
    std::vector<std::string> names;
    for (const auto& object : objects) names.push_back(object.name);
    return names;
  }

  void add_named(const char* kind, const std::vector<std::string>& names) {
    std::string list;
    json_.key(kind).begin_array();
    for (std::size_t i = 0; i < names.size(); ++i) {
      json_.value(names[i]);
      if (i < max_names_listed || arguments_.all) list += (i == 0 ? "" : ", ") + names[i];
      if (i == max_names_listed && !arguments_.all) list += ", ...";
    }
    json_.end_array();
    if (!names.empty()) text_ += fmt::format("  {:<24} {} ({})\n", kind, names.size(), list);
  }

  void add_simulation(std::size_t index, const simulate::Plan& plan) {
    simulate::Acquisition looked_at = plan.acquisition;
    looked_at.scene = simulate::thinned(looked_at.scene, workflow::max_cloud_looks);
    const simulate::EchoSurvey survey = simulate::survey_echoes(looked_at, control_);
    const core::Facts figures = facts_of(plan, simulate::simulation_figures(plan.acquisition, survey), survey);
    const scene::Simulation& simulation = plan.acquisition.simulation;
    json_.begin_object()
        .member("number", index + 1)
        .member("file", simulation.file)
        .member("radar", plan.acquisition.link.name);
    json_.member("format", workflow::format_word(simulation.format))
        .member("processing", workflow::processing_word(simulation.processing));
    json_.member("bits", simulation.bits).member("lsb_v", simulation.lsb_v);
    json_.member("pulses_surveyed", survey.pulses_sampled).member("all_pulses_surveyed", survey.all_pulses);
    write_utc(json_, scene_.world, simulation.time_start_s, simulation.time_end_s);
    core::write_json(json_, figures);
    text_ += fmt::format("\nsimulation {}: {}, {}, {}, {} bits, radar {}\n", index + 1, simulation.file,
                         workflow::format_word(simulation.format), workflow::processing_word(simulation.processing),
                         simulation.bits, plan.acquisition.link.name);
    if (scene::epoch_of(scene_.world).instant)
      text_ += fmt::format("  {:<24} {} to {}\n", "time", time_text(scene_.world, simulation.time_start_s),
                           time_text(scene_.world, simulation.time_end_s));
    text_ += core::text_of(figures);
    const auto summary = std::ranges::find(*echoes_, index, &simulate::EchoSummary::simulation);
    if (summary != echoes_->end()) {
      workflow::write_echoes(json_, *summary);
      text_ += workflow::echo_text(scene_, *summary);
      add_image(index, *summary);
    }
    add_targets(plan.acquisition, survey, summary != echoes_->end() && summary->directive);
    json_.end_object();
  }

  // What focusing will make of the strongest target.
  void add_image(std::size_t index, const simulate::EchoSummary& summary) {
    json_.key("image");
    const bool listed = !summary.sights.empty() && summary.strongest().target < scene_.targets.size();
    const auto image = listed ? workflow::forecast_image(scene_, index, summary.strongest().target, control_)
                              : std::optional<workflow::ImageForecast>();
    if (!image) {
      json_.null();
      return;
    }
    text_ += fmt::format("    image of target {}: {:.4g} m in azimuth", image->target + 1, image->azimuth_width_m);
    if (image->range_width_m) text_ += fmt::format(", {:.4g} m in range", *image->range_width_m);
    text_ += fmt::format(" (-3 dB), by an aperture of {:.4g} m", image->aperture_m);
    if (summary.noise) text_ += fmt::format("; SNR {}", workflow::decibel_text(summary.strongest().processed_snr));
    text_ += "\n";
    json_.begin_object().member("target", image->target + 1).member("azimuth_width_m", image->azimuth_width_m);
    json_.key("range_width_m");
    image->range_width_m ? json_.value(*image->range_width_m) : json_.null();
    json_.member("range_m", image->range_m).member("aperture_m", image->aperture_m).end_object();
  }

  void add_targets(const simulate::Acquisition& acquisition, const simulate::EchoSurvey& survey, bool directive) {
    // Of large clouds only some points were looked at, and nobody could tell which.
    const bool whole = survey.targets.size() == acquisition.scene->scatterers.size();
    const std::size_t listed = whole ? survey.targets.size() : acquisition.scene->scatterers.targets();
    const std::size_t count = arguments_.all ? listed : std::min(listed, max_names_listed);
    if (count > 0)
      text_ += survey.all_pulses ? "  targets\n"
                                 : fmt::format("  targets (estimated from {} of {} pulses)\n", survey.pulses_sampled,
                                               acquisition.timing.pulses.count());
    std::vector<std::size_t> looked_at(std::min(count, max_looked_at));
    std::iota(looked_at.begin(), looked_at.end(), std::size_t{0});
    const std::vector<simulate::TargetVisibility> sights =
        simulate::VisibilitySurvey(acquisition, looked_at).look(control_);
    json_.key("targets").begin_array();
    for (std::size_t i = 0; i < count; ++i) {
      const simulate::TargetVisibility* sight = i < sights.size() ? &sights[i] : nullptr;
      text_ += target_line(i + 1, survey.targets[i], sight, directive, scene_.options.profile);
      write_survey_json(json_, i + 1, survey.targets[i], sight);
    }
    json_.end_array();
    if (count < listed) text_ += fmt::format("    ... and {} more; list them with --all\n", listed - count);
  }

  const SceneInfoArguments& arguments_;
  const scene::Scene& scene_;
  core::WorkControl control_;
  const std::vector<simulate::EchoSummary>* echoes_ = nullptr;
  core::JsonWriter json_;
  std::string text_;
};

}  // namespace

ExitStatus print_scene_info(const SceneInfoArguments& arguments, Streams& streams) {
  const core::WorkControl control{core::thread_count(0), streams.stop};
  workflow::SceneInput input =
      workflow::read_scene(arguments.path, arguments.overrides, workflow::CheckLevel::echoes, control);
  workflow::expect_usable(input);
  print_problems(streams, input.problems);
  workflow::resolve_once(input, control);
  SceneInfo info(arguments, input.scene, control);
  info.add_objects();
  info.add_world(*input.resolved);
  info.add_radars(*input.resolved);
  info.add_simulations(input.resolved, input.echoes);
  write_out(streams, arguments.json ? info.json() : info.text());
  return exit_done;
}

}  // namespace sarsim::cli
