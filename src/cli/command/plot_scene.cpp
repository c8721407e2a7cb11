#include <algorithm>
#include <tuple>

#include <fmt/format.h>

#include "cli/command/plot_arguments.hpp"
#include "cli/command/plot_samples.hpp"
#include "core/text/number_text.hpp"
#include "picture/echo/echo_figure.hpp"
#include "picture/echo/echo_picture.hpp"
#include "picture/echo/preview.hpp"
#include "picture/figure/antenna_figure.hpp"
#include "picture/figure/function_figure.hpp"
#include "picture/figure/pulse_figure.hpp"
#include "picture/scene/track_figure.hpp"
#include "scene/model/object.hpp"
#include "scene/schema/fields.hpp"

namespace sarsim::cli {

namespace {

// ---- Which samples ----------------------------------------------------------------------------------------------

scene::Simulation chosen_simulation(const PlotArguments& a, const scene::Scene& scene) {
  if (a.simulation) {
    const auto number = static_cast<std::size_t>(*a.simulation);
    if (number > scene.simulations.size())
      throw core::InvalidRequest(fmt::format("the scene has no recording {}", number),
                                 scene.simulations.empty()
                                     ? "it has none: choose with --radar"
                                     : fmt::format("recordings have the numbers 1 to {}", scene.simulations.size()));
    return scene.simulations[number - 1];
  }
  if (a.radar.empty() && !scene.simulations.empty()) return scene.simulations[0];
  if (scene.radars.empty())
    throw core::InvalidRequest(a.input + ": the scene has no radar", "add a [[radar]]; in a .scr, a $RADAR");
  scene::Simulation simulation;
  simulation.radar = scene.radars[a.radar.empty() ? 0 : workflow::radar_named(scene, a.radar)].name;
  return simulation;
}

picture::EchoWindow chosen_window(const PlotArguments& a, const scene::Scene& scene, bool& show_all) {
  const scene::Simulation simulation = chosen_simulation(a, scene);
  picture::EchoWindow window = picture::window_of(simulation);
  const bool stored = simulation.sample_rate_hz > 0.0;
  show_all = !stored && a.range_m.empty();
  if (!stored) window = picture::new_echo_window(simulation.radar, a.processing.value_or(scene::Processing::raw));
  if (a.processing) window.recording.processing = *a.processing;
  if (a.screen) window.sampling.kind = picture::Sampling::Kind::screen;
  if (a.rate_hz) {
    window.sampling = {picture::Sampling::Kind::rate, *a.rate_hz, 1.0};
    window.recording.sample_rate_hz = *a.rate_hz;
  }
  picture::EchoView view = picture::view_of(window);
  if (!a.range_m.empty()) std::tie(view.range_start_m, view.range_end_m) = std::pair(a.range_m[0], a.range_m[1]);
  if (!a.time_s.empty()) std::tie(view.time_start_s, view.time_end_s) = std::pair(a.time_s[0], a.time_s[1]);
  picture::set_view(window, picture::mended(view));
  take_look(a, picture::DisplayQuantity::real, window);
  return window;
}

// What is wrong with the recording, with the options that stand in for its values.
core::InvalidRequest with_options(core::Problems problems) {
  for (core::Problem& problem : problems) {
    const std::string& field = problem.subject.field;
    const bool sampled = field.starts_with("range") || field.starts_with("sample_rate");
    if (!sampled && !field.starts_with("time")) continue;
    if (!problem.hint.empty()) problem.hint += ' ';
    problem.hint += sampled ? "Choose others with --rate and --range." : "Choose another with --time.";
  }
  return core::InvalidRequest(std::move(problems));
}

// The echo matrix of a window, as a simulation window computes it.
std::shared_ptr<const picture::EchoMatrix> computed(const picture::PreviewRequest& request,
                                                    const core::StopFlag* stop) {
  picture::PreviewEvent end = picture::shown(request, stop);
  if (end.kind == picture::PreviewEvent::Kind::failed) throw with_options(std::move(end.problems));
  return end.matrix;
}

constexpr std::size_t samples_per_pixel = 4;  // of curves

Plotted picture(const PlotArguments& a, const scene::Scene& scene, const core::StopFlag* stop) {
  bool show_all = false;
  const picture::EchoWindow window = chosen_window(a, scene, show_all);
  // One sample of many shows as much on the screen's grid, unless those in between or the very values are wanted.
  const bool exact = a.rate_hz || a.peak || !a.csv.empty();
  picture::PreviewRequest request{std::make_shared<scene::Scene>(scene),
                                  window,
                                  plot_pixels(a),
                                  simulate::Engine::automatic,
                                  show_all,
                                  exact ? picture::LongRows::computed : picture::LongRows::by_screen};
  auto matrix = computed(request, stop);
  // Curves show what lies between the pixels of a chirp.
  if (!a.screen && picture::drawn_as(window, *matrix) == picture::DrawAs::curves_per_pulse) {
    request.size.width_px *= samples_per_pixel;
    matrix = computed(request, stop);
  }
  Plotted plotted{picture::echo_figure(*matrix, window), {}};
  if (!a.csv.empty()) plotted.table = picture::sample_table(picture::echo_block(*matrix), {}, true, true, ',');
  return plotted;
}

// ---- Cuts and radar views ---------------------------------------------------------------------------------------

// Every range at which something can answer: two pulses before the nearest target to two behind the farthest, as in a
// new window.
void show_all_targets(const scene::Scene& scene, picture::EchoWindow& window, const core::StopFlag* stop) {
  picture::EchoWindow asked = window;
  asked.sampling.kind = picture::Sampling::Kind::screen;
  const auto matrix =
      computed({std::make_shared<scene::Scene>(scene), asked, {16, 16}, simulate::Engine::automatic, true}, stop);
  picture::set_view(window, picture::view_of(matrix->window()));
}

std::shared_ptr<const simulate::Plan> chosen_plan(const PlotArguments& a, workflow::SceneInput& input,
                                                  const core::StopFlag* stop) {
  bool show_all = false;
  picture::EchoWindow window = chosen_window(a, input.scene, show_all);
  if (show_all) show_all_targets(input.scene, window, stop);
  workflow::resolve_once(input, {core::thread_count(0), stop});
  picture::PlotSize size = plot_pixels(a);
  // Cuts are smooth; a profile, spectrum or phase is of the samples that a run saves.
  const bool cut = a.kind == PlotKind::pulse || a.kind == PlotKind::range;
  const bool smooth = a.screen || (cut && !a.recorded);
  if (!smooth) size.width_px = 1;
  if (smooth && !a.screen) size.width_px *= samples_per_pixel;
  if (!smooth && window.sampling.kind == picture::Sampling::Kind::screen)
    window.sampling = {picture::Sampling::Kind::multiple, 0.0, 1.0};
  picture::ShownPlan planned = picture::plan_shown(input.scene, input.resolved, window, size,
                                                   simulate::Engine::automatic, picture::LongRows::computed, stop);
  if (!planned.plan) throw with_options(std::move(planned.problems));
  return planned.plan;
}

Plotted of_samples(const PlotArguments& a, workflow::SceneInput& input, const core::StopFlag* stop) {
  const auto plan = chosen_plan(a, input, stop);
  picture::SampleSource samples = picture::samples_of(plan, stop);
  samples.look.quantity = picture::DisplayQuantity::real;
  return plot_samples(a, samples);
}

// ---- Antennas, pulses, functions --------------------------------------------------------------------------------

std::size_t chosen_radar(const PlotArguments& a, const scene::Scene& scene) {
  if (!a.radar.empty() || scene.radars.empty()) return workflow::radar_named(scene, a.radar);
  return workflow::radar_named(scene, chosen_simulation(a, scene).radar);
}

// Offsets repeat after a turn.
void take_angles(const PlotArguments& a, picture::AntennaLook& look) {
  constexpr double turn_deg = 360.0;
  if (a.angles_deg.size() != 2) return;
  std::tie(look.first_deg, look.last_deg) = std::minmax(a.angles_deg[0], a.angles_deg[1]);
  if (look.first_deg < -turn_deg || look.last_deg > turn_deg)
    throw core::InvalidRequest(fmt::format("--angles: {} to {} deg go beyond a turn", a.angles_deg[0], a.angles_deg[1]),
                               "choose offsets from -360 to 360 deg");
  if (!(look.first_deg < look.last_deg)) throw core::InvalidRequest("--angles: the two angles are the same");
}

Plotted of_radar(const PlotArguments& a, workflow::SceneInput& input, const core::StopFlag* stop) {
  const std::size_t number = chosen_radar(a, input.scene);
  workflow::resolve_once(input, {core::thread_count(0), stop});
  const simulate::Link radar = simulate::resolve_radar(input.scene, *input.resolved, number);
  Plotted plotted;
  if (a.kind == PlotKind::sent) {
    plotted.figure = picture::sent_pulse_figure(radar.pulse, a.span_db.value_or(60.0));
  } else {
    picture::AntennaLook look;
    look.quantity = a.quantity.value_or(look.quantity);
    look.span_db = a.span_db.value_or(look.span_db);
    if (look.quantity == picture::DisplayQuantity::imaginary || look.quantity == picture::DisplayQuantity::phase)
      throw core::InvalidRequest("--show: an antenna's pattern is real",
                                 "choose real (with its sign), magnitude or db");
    take_angles(a, look);
    plotted.figure = picture::antenna_figure(radar, input.resolved->conventions.pattern, look);
  }
  if (!a.csv.empty()) plotted.table = picture::curves_table(plotted.figure, ',');
  return plotted;
}

// A user-defined function that a script uses.
struct UsedFunction {
  scene::AnyObject object;
  std::string name;   ///< "Plane:trajectory_m"
  std::string field;  ///< "trajectory_m"
};

std::vector<UsedFunction> used_functions(const scene::Scene& scene) {
  std::vector<UsedFunction> used;
  for (const scene::ObjectKind kind :
       {scene::ObjectKind::platform, scene::ObjectKind::radar, scene::ObjectKind::target})
    for (std::size_t i = 0; i < scene::count_of(scene, kind); ++i) {
      const scene::AnyObject object = scene::object_of(scene, {kind, i});
      const std::string name =
          kind == scene::ObjectKind::target ? fmt::format("target:{}", i + 1) : scene::label_of(scene, {kind, i});
      for (const scene::Field& field : scene::fields_of(kind))
        if (field.kind == scene::FieldKind::function && scene::field_applies(object, field.id))
          used.push_back({object, name + ":" + field.id, field.id});
    }
  return used;
}

bool begins_with(std::string_view text, std::string_view beginning) {
  return text.size() >= beginning.size() && core::equal_ignoring_case(text.substr(0, beginning.size()), beginning);
}

// By its whole name, the beginning of it, or the same of the field alone.
UsedFunction chosen_function(const PlotArguments& a, const scene::Scene& scene) {
  std::vector<UsedFunction> all = used_functions(scene);
  if (all.empty())
    throw core::InvalidRequest(a.input + ": the script uses no user-defined function",
                               "trajectories and user patterns are some");
  std::vector<UsedFunction> found;
  for (const UsedFunction& one : all)
    if (begins_with(one.name, a.function) || begins_with(one.field, a.function)) found.push_back(one);
  if (found.size() == 1) return found[0];
  const auto whole = std::ranges::find_if(
      found, [&](const UsedFunction& one) { return core::equal_ignoring_case(one.name, a.function); });
  if (whole != found.end()) return *whole;
  std::string names;
  for (const UsedFunction& one : found.empty() ? all : found) names += (names.empty() ? "" : ", ") + one.name;
  const std::string message = a.function.empty() ? fmt::format("the script uses {} functions", all.size())
                              : found.empty()    ? fmt::format("the script uses no function '{}'", a.function)
                                                 : fmt::format("'{}' may be any of {}", a.function, found.size());
  throw core::InvalidRequest("--function: " + message, "choose one of " + names);
}

Plotted of_function(const PlotArguments& a, const workflow::SceneInput& input) {
  const UsedFunction function = chosen_function(a, input.scene);
  const bool by_role = simulate::conventions_of(input.scene.options.profile).function_ends ==
                       simulate::Conventions::FunctionEnds::by_role;
  Plotted plotted;
  plotted.figure = picture::function_figure(scene::function_info(function.object, function.field),
                                            scene::function_of(function.object, function.field),
                                            {simulate::interpolation_rules(input.scene.options), by_role}, a.compare);
  if (!a.csv.empty()) plotted.table = picture::curves_table(plotted.figure, ',');
  return plotted;
}

// ---- Maps -------------------------------------------------------------------------------------------------------

Plotted of_ground(const PlotArguments& a, workflow::SceneInput& input, const core::StopFlag* stop) {
  const bool footprint = a.kind == PlotKind::footprint;
  const std::size_t number = footprint ? chosen_radar(a, input.scene) : 0;
  radar::TimeSpan times = picture::shown_times(input.scene);
  if (a.simulation) {
    const scene::Simulation simulation = chosen_simulation(a, input.scene);
    times = {simulation.time_start_s, simulation.time_end_s};
  }
  if (a.time_s.size() == 2) std::tie(times.first_s, times.last_s) = std::minmax(a.time_s[0], a.time_s[1]);
  if (!(times.first_s < times.last_s)) throw core::InvalidRequest("--time: the two times are the same");
  workflow::resolve_once(input, {core::thread_count(0), stop});
  Plotted plotted;
  plotted.figure = footprint ? picture::footprint_figure(input.scene, *input.resolved, number, times)
                             : picture::track_figure(input.scene, *input.resolved, times);
  if (!a.csv.empty()) plotted.table = picture::curves_table(plotted.figure, ',');
  return plotted;
}

}  // namespace

Plotted plot_scene(const PlotArguments& a, Streams& streams) {
  if (!a.azimuth_m.empty() || a.at_azimuth_m)
    throw core::InvalidRequest("--azimuth and --at-azimuth are for focused images",
                               "rows of a script's echoes have times: --time");
  workflow::SceneInput input =
      workflow::read_scene(a.input, a.overrides, workflow::CheckLevel::values, {core::thread_count(0), streams.stop});
  workflow::expect_usable(input);
  print_problems(streams, input.of_files);
  switch (a.kind) {
    case PlotKind::picture: return picture(a, input.scene, streams.stop);
    case PlotKind::antenna:
    case PlotKind::sent: return of_radar(a, input, streams.stop);
    case PlotKind::function: return of_function(a, input);
    case PlotKind::track:
    case PlotKind::footprint: return of_ground(a, input, streams.stop);
    default: return of_samples(a, input, streams.stop);
  }
}

}  // namespace sarsim::cli
