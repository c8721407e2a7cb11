#include "workflow/focus/focus_input.hpp"

#include "core/report/invalid_request.hpp"
#include "radar/motion/motion_path.hpp"
#include "radar/path/path.hpp"
#include "scene/model/read_path.hpp"
#include "workflow/focus/navigation_check.hpp"
#include "workflow/focus/sar_rows.hpp"
#include "workflow/input/motion_input.hpp"

namespace sarsim::workflow {

namespace {

// A radar like that of the recording on the platform of the navigation, so that what is lost between its states counts.
void add_radar(const scene::Scene& scene, std::size_t simulation, scene::Scene& believed) {
  if (simulation >= scene.simulations.size()) return;
  const std::size_t radar = scene::find_radar(scene, scene.simulations[simulation].radar);
  if (radar == scene::not_found) return;
  believed.platforms.front().name = "navigation";
  scene::Radar& copy = believed.radars.emplace_back(scene.radars[radar]);
  copy.platform = believed.platforms.front().name;
  believed.geometries.front().radar = copy.name;
}

// The echoes seem to come from where the navigation says that the antenna was.
void believe(const std::string& file, const scene::Scene& scene, FocusInput& focus) {
  if (file.empty()) return;
  scene::Scene believed;
  believed.world = scene.world;
  scene::Platform& platform = believed.platforms.emplace_back();
  platform.path = scene::Platform::Path::ephemeris;
  platform.ephemeris_file = file;
  scene::GeometryTable& times = believed.geometries.emplace_back();
  times.time_start_s = focus.echoes.track.front().time_s;
  times.time_end_s = focus.echoes.track.back().time_s;
  add_radar(scene, focus.simulation, believed);
  core::Problems problems = read_motions(believed, {});
  for (core::Problem& problem : problems) problem.subject = {};
  if (core::has_errors(problems)) throw core::InvalidRequest(core::ranked(std::move(problems)));
  core::append(focus.problems, std::move(problems));
  const radar::MotionPath path = radar::StatePath{platform.read_path->states};
  std::vector<signal::TrackPoint> track =
      track_along(*focus.acquisition, [&](double time_s) { return path.state(time_s).position_world_m; });
  const double farthest_m = radar::range_of(
      focus.echoes.first_delay_s + static_cast<double>(focus.echoes.columns) / focus.echoes.waveform.sample_rate_hz,
      focus.echoes.waveform.light_speed_mps);
  core::Problems of_track = problems_of_navigation(file, focus.echoes.track, track, farthest_m);
  if (core::has_errors(of_track)) throw core::InvalidRequest(core::ranked(std::move(of_track)));
  core::append(focus.problems, std::move(of_track));
  focus.echoes.track = std::move(track);
}

FocusInput of_script(const RecordingArguments& arguments, const core::WorkControl& control,
                     const std::string& navigation) {
  auto [input, simulation] = open_script(arguments, records_pulses, control);
  FocusInput focus = focus_input_of(input.scene, simulation, input.resolved);
  core::append(focus.problems, std::move(input.problems));
  if (core::has_errors(focus.problems)) throw core::InvalidRequest(core::ranked(std::move(focus.problems)));
  believe(navigation, input.scene, focus);
  focus.of_files = std::move(input.of_files);
  focus.sources = std::move(input.sources);
  return focus;
}

FocusInput of_file(const RecordingArguments& arguments, const core::WorkControl& control,
                   const std::string& navigation) {
  StoredRecording stored = open_recording(
      arguments, records_pulses,
      [](const simulate::Acquisition& acquisition) { return problems_of_sar(acquisition, true); }, control);
  FocusInput focus{stored.acquisition, {}, stored.simulation, std::move(stored.problems), stored.scene.world};
  focus.echoes = sar_rows_of_recording(focus.acquisition, stored.rows);
  believe(navigation, stored.scene, focus);
  focus.of_files = std::move(stored.of_files);
  focus.sources = std::move(stored.sources);
  focus.recording = std::move(stored.file);
  return focus;
}

}  // namespace

FocusInput focus_input_of(scene::Scene& scene, std::size_t simulation,
                          const std::shared_ptr<const simulate::ResolvedScene>& resolved) {
  return focus_input_of(scene, simulation, simulate::acquisition_of(scene, simulation, resolved));
}

FocusInput focus_input_of(scene::Scene& scene, std::size_t simulation, const simulate::Acquisition& window) {
  FocusInput focus;
  focus.simulation = simulation;
  focus.world = scene.world;
  focus.problems = problems_of_sar(window, false);
  if (core::has_errors(focus.problems)) return focus;
  scene::Simulation& recorded = scene.simulations[simulation];
  recorded = recorded_for_sar(recorded, window);
  focus.acquisition =
      std::make_shared<const simulate::Acquisition>(simulate::acquisition_of(scene, simulation, window.scene));
  focus.echoes = sar_rows_of_scene(focus.acquisition, window.reception.columns);
  return focus;
}

FocusInput open_focus_input(const RecordingArguments& arguments, const core::WorkControl& control,
                            const std::string& navigation) {
  FocusInput focus =
      names_script(arguments) ? of_script(arguments, control, navigation) : of_file(arguments, control, navigation);
  focus.problems = core::ranked(std::move(focus.problems));
  return focus;
}

}  // namespace sarsim::workflow
