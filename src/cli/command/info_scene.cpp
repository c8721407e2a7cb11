#include "cli/command/info_scene.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>

#include <fmt/format.h>

#include "cli/command/info_places.hpp"
#include "cli/shell/figures.hpp"
#include "cli/shell/report.hpp"
#include "core/build/version.hpp"
#include "core/task/parallel.hpp"
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
std::vector<Figure> figures_of(const simulate::RadarFigures& r, bool shaped) {
  std::vector<Figure> f;
  f.push_back(figure("carrier", "lowest_carrier_hz", r.lowest_carrier_hz,
                     between(r.lowest_carrier_hz, r.highest_carrier_hz, "Hz")));
  f.push_back({"", "", "highest_carrier_hz", r.highest_carrier_hz, {}});
  f.push_back(figure("wavelength", "shortest_wavelength_m", r.shortest_wavelength_m,
                     between(r.shortest_wavelength_m, r.longest_wavelength_m, "m")));
  f.push_back({"", "", "longest_wavelength_m", r.longest_wavelength_m, {}});
  f.push_back(si_figure("bandwidth", "bandwidth_hz", r.bandwidth_hz, "Hz"));
  f.push_back(si_figure(shaped ? "range resolution" : "range resolution c/2B", "range_resolution_m",
                        r.range_resolution_m, "m"));
  if (r.synthetic_range_resolution_m > 0.0)
    f.push_back(
        si_figure("over all frequency steps", "synthetic_range_resolution_m", r.synthetic_range_resolution_m, "m"));
  f.push_back(si_figure("pulse length", "pulse_length_m", r.pulse_length_m, "m"));
  f.push_back(figure("time-bandwidth product", "time_bandwidth", r.time_bandwidth));
  f.push_back(si_figure("PRF (mean)", "mean_prf_hz", r.mean_prf_hz, "Hz"));
  f.push_back(si_figure("shortest PRI", "shortest_pri_s", r.shortest_pri_s, "s"));
  f.push_back(si_figure("unambiguous range", "unambiguous_range_m", r.unambiguous_range_m, "m"));
  f.push_back(figure("unambiguous speed", "unambiguous_speed_mps", r.unambiguous_speed_mps,
                     "+-" + core::with_prefix(r.unambiguous_speed_mps, "m/s")));
  f.push_back(figure("duty cycle", "duty_cycle", r.duty_cycle, fmt::format("{:.4g} %", 100.0 * r.duty_cycle)));
  f.push_back(si_figure("mean power", "mean_power_w", r.mean_power_w, "W"));
  f.push_back(figure("noise power kTB", "noise_power_w", r.noise_power_w, fmt::format("{:.4g} W", r.noise_power_w)));
  return f;
}

std::vector<Figure> figures_of(const simulate::Plan& plan, const simulate::SimulationFigures& s,
                               const simulate::EchoSurvey& survey, bool counts) {
  const unsigned threads = core::thread_count(0);
  const workflow::RecordingSize size = workflow::size_of(plan, threads, counts);
  const auto microseconds = [](double v) { return core::with_prefix(v, "s"); };
  const auto volts = [](double v) { return fmt::format("{:.4g} V", v); };
  std::vector<Figure> f;
  f.push_back(figure("pulses", "pulses", static_cast<double>(plan.acquisition.timing.pulses.count()),
                     fmt::format("{} ({} to {})", plan.acquisition.timing.pulses.count(),
                                 plan.acquisition.timing.pulses.first, plan.acquisition.timing.pulses.last)));
  f.push_back(figure("rows", "rows", static_cast<double>(plan.acquisition.timing.rows)));
  f.push_back(figure("samples of a row", "columns", static_cast<double>(plan.acquisition.reception.columns)));
  f.push_back(figure("file size", "bytes", size.bytes, core::bytes_text(size.bytes)));
  f.push_back(
      figure("expected time", "seconds", size.seconds,
             fmt::format("{} on {} thread{}", core::duration_text(size.seconds), threads, threads == 1 ? "" : "s")));
  f.push_back(figure("expected memory", "memory_bytes", size.memory_bytes, core::bytes_text(size.memory_bytes)));
  f.push_back(figure("window, delay", "first_delay_s", s.first_delay_s,
                     microseconds(s.first_delay_s) + " to " + microseconds(s.last_delay_s)));
  f.push_back({"", "", "last_delay_s", s.last_delay_s, {}});
  f.push_back(si_figure("column spacing", "column_spacing_m", s.column_spacing_m, "m"));
  f.push_back(figure("sampling/bandwidth", "sampling_ratio", s.sampling_ratio));
  f.push_back(
      figure("noise power per sample", "noise_power_w", s.noise_power_w, fmt::format("{:.4g} W", s.noise_power_w)));
  f.push_back(figure("intra-pulse phase error", "pulse_motion_rad", s.pulse_motion_rad,
                     fmt::format("{:.2g} rad", s.pulse_motion_rad)));
  f.push_back(figure("Doppler band", "lowest_doppler_hz", survey.lowest_doppler_hz,
                     between(survey.lowest_doppler_hz, survey.highest_doppler_hz, "Hz")));
  f.push_back({"", "", "highest_doppler_hz", survey.highest_doppler_hz, {}});
  f.push_back(figure("strongest echo", "largest_echo_v", s.largest_echo_v, volts(s.largest_echo_v)));
  f.push_back(figure("magnitude bound", "largest_sum_v", s.largest_sum_v, volts(s.largest_sum_v)));
  f.push_back(figure("LSB without clipping", "suggested_lsb_v", s.suggested_lsb_v,
                     fmt::format("{:.4g} mV", 1e3 * s.suggested_lsb_v)));
  return f;
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
      const auto figures = figures_of(
          simulate::radar_figures(simulate::resolve_radar(scene_, resolved, i), radar.power_w, resolved.conventions),
          radar.pulse == scene::Radar::Pulse::user);
      json_.begin_object().member("name", radar.name).member("platform", radar.platform);
      cli::write_json(json_, figures);
      json_.end_object();
      text_ += "\nradar " + radar.name + " on " + radar.platform + "\n" + shown(figures);
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

  // Figures without a label are for programs only.
  static std::string shown(std::vector<Figure> figures) {
    std::erase_if(figures, [](const Figure& f) { return f.label.empty(); });
    return figures_text(figures);
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
    const auto figures = figures_of(plan, simulate::simulation_figures(plan.acquisition, survey), survey, false);
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
    cli::write_json(json_, figures);
    text_ += fmt::format("\nsimulation {}: {}, {}, {}, {} bits, radar {}\n", index + 1, simulation.file,
                         workflow::format_word(simulation.format), workflow::processing_word(simulation.processing),
                         simulation.bits, plan.acquisition.link.name);
    if (scene::epoch_of(scene_.world).instant)
      text_ += fmt::format("  {:<24} {} to {}\n", "time", time_text(scene_.world, simulation.time_start_s),
                           time_text(scene_.world, simulation.time_end_s));
    text_ += shown(figures);
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
