#include "workflow/focus/focus.hpp"

#include <algorithm>
#include <iterator>
#include <memory>
#include <string>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "core/os/free_memory.hpp"
#include "core/report/invalid_request.hpp"
#include "core/task/clock.hpp"
#include "core/text/number_text.hpp"
#include "radar/path/path.hpp"
#include "scene/model/world_frame.hpp"
#include "signal/sar/sar_track.hpp"
#include "workflow/focus/air_remarks.hpp"
#include "workflow/focus/azimuth_ambiguities.hpp"
#include "workflow/focus/back_projection.hpp"
#include "workflow/focus/edge_remark.hpp"
#include "workflow/focus/flown_spectrum.hpp"
#include "workflow/focus/focus_input.hpp"
#include "workflow/focus/focus_phase_history.hpp"
#include "workflow/focus/image_collection.hpp"
#include "workflow/focus/image_reach.hpp"
#include "workflow/focus/method_choice.hpp"
#include "workflow/focus/movers.hpp"
#include "workflow/focus/sar_rows.hpp"
#include "workflow/focus/scene_grid.hpp"
#include "workflow/focus/seen_spectrum.hpp"
#include "workflow/focus/swath_remark.hpp"
#include "workflow/focus/target_aspects.hpp"
#include "workflow/image/image_output.hpp"
#include "workflow/input/output_names.hpp"
#include "workflow/input/override_words.hpp"

namespace sarsim::workflow {

namespace fs = std::filesystem;

namespace {

bool in_time(const FocusRequest& request) { return request.algorithm == FocusAlgorithm::back_projection; }

// Half of the memory that is free, where nobody said how much.
std::size_t memory_for(const FocusRequest& request) {
  constexpr std::size_t where_unknown = std::size_t{2} << 30;
  return request.memory_bytes.value_or(core::free_memory_bytes().value_or(where_unknown) / 2);
}

signal::FocusOptions options_of(const FocusRequest& request) {
  signal::FocusOptions options;
  if (request.algorithm == FocusAlgorithm::range_doppler) options.method = signal::FocusMethod::range_doppler;
  if (request.algorithm == FocusAlgorithm::chirp_scaling) options.method = signal::FocusMethod::chirp_scaling;
  options.range_window = request.range_window;
  options.azimuth_window = request.azimuth_window;
  options.doppler_bandwidth_hz = request.bandwidth_hz;
  options.azimuth_area = request.azimuth_area;
  options.range_area = request.range_area;
  options.memory_bytes = memory_for(request);
  options.scratch_folder = request.scratch_folder;
  return options;
}

// What does not move cannot be focused, which `problems_of_echoes` says.
bool moves(const signal::EchoRows& echoes) {
  return echoes.track.size() >= 2 && signal::fit_straight(echoes.track).speed_mps > 0.0;
}

// The middle of the Doppler band as the echoes have it, or `otherwise`.
double measured_centroid_hz(const FocusRequest& request, const signal::EchoRows& echoes, double otherwise_hz,
                            const core::WorkControl& control) {
  if (request.centroid != CentroidSource::measured || echoes.columns == 0) return otherwise_hz;
  return signal::measured_doppler_centroid_hz(echoes, otherwise_hz, control);
}

// From the line where compensation of motion moves the echoes there, else as it is flown.
double geometric_centroid_hz(const FocusRequest& request, const FocusInput& input, const core::WorkControl& control) {
  const signal::SarWaveform& wave = input.echoes.waveform;
  const double limit_m = radar::wavelength_of(wave.carrier_hz, wave.light_speed_mps) / 16.0;
  if (!in_time(request) && signal::fit_straight(input.echoes.track).worst_position_m > limit_m)
    if (const auto of_line = line_doppler_centroid_hz(*input.acquisition, input.echoes, control)) return *of_line;
  return geometric_doppler_centroid_hz(*input.acquisition);
}

// As it is known before motion is compensated; measured, it is that of the echoes as they came.
double first_centroid_hz(const FocusRequest& request, const FocusInput& input, const core::WorkControl& control) {
  if (request.centroid == CentroidSource::given) return request.given_centroid_hz;
  if (!moves(input.echoes)) return 0.0;
  return measured_centroid_hz(request, input.echoes, geometric_centroid_hz(request, input, control), control);
}

core::Problems problems_of_echoes(const FocusRequest& request, const signal::EchoRows& echoes,
                                  const signal::FocusOptions& options) {
  return in_time(request) ? signal::problems_of_focusing_in_time(echoes, options)
                          : signal::problems_of_focusing(echoes, options);
}

MotionOrder wanted_motion(const FocusRequest& request, const signal::EchoRows& echoes, const core::Problems& problems) {
  if (in_time(request) || !moves(echoes)) return MotionOrder::none;
  if (request.motion) return *request.motion;
  return wants_compensation(problems) ? MotionOrder::second : MotionOrder::none;
}

// What compensation does not mend is said before it.
void expect_focusable(const FocusInput& input, core::Problems problems, MotionOrder motion) {
  if (motion != MotionOrder::none) expect_one_way(input.echoes);
  std::erase_if(problems, [&](const core::Problem& problem) {
    return problem.severity != core::Severity::error ||
           (motion != MotionOrder::none && problem.subject.field == signal::track_field);
  });
  if (problems.empty()) return;
  core::append(problems, input.problems);
  throw core::InvalidRequest(core::ranked(std::move(problems)));
}

// Progress of a stage whose clock begins now.
core::ProgressReport begun_stage(const core::Observer& observer, std::string name) {
  core::ProgressReport progress = observer.stage(std::move(name));
  if (progress) progress({});
  return progress;
}

std::string name_of(const FocusRequest& request) {
  return request.output.empty() ? request.input.path : request.output.string();
}

// Whether the image is a grid around the scene: the line that fits the flight says nothing of it.
bool around_scene(const FocusRequest& request, const signal::EchoRows& echoes) {
  return in_time(request) && request.grid == FocusGrid::ground && moves(echoes) && !flies_along_a_line(echoes);
}

AmbiguitiesIn ambiguities_in(const FocusRequest& request, const signal::EchoRows& echoes) {
  if (around_scene(request, echoes)) return AmbiguitiesIn::circle;
  return in_time(request) ? AmbiguitiesIn::time : AmbiguitiesIn::frequency;
}

core::Vec3 ground_of(const FocusRequest& request, const simulate::Acquisition& acquisition) {
  core::Vec3 scene_m = scene_middle_m(acquisition);
  if (request.ground_m) scene_m.z = *request.ground_m;
  return scene_m;
}

// What the image has to hold.
std::optional<signal::ImageSpectrum> spectrum_of_image(const FocusRequest& request, const FocusPipeline& work,
                                                       const core::WorkControl& control) {
  const DopplerBand kept{work.options.doppler_centroid_hz, work.options.doppler_bandwidth_hz};
  const simulate::Acquisition& acquisition = *work.input.acquisition;
  const signal::EchoRows& echoes = work.input.echoes;
  if (!in_time(request) || !moves(echoes))
    return seen_spectrum(acquisition, echoes, kept, in_time(request) ? SeenPulses::all : SeenPulses::sampled, control);
  return flown_spectrum(acquisition, echoes, {}, ground_of(request, acquisition), kept, control);
}

// The image holds what the recording has seen, where that is affordable.
void reach_targets_of(const FocusRequest& request, FocusPipeline& work, const core::WorkControl& control) {
  if (!moves(work.input.echoes)) return;
  DopplerBand kept{work.options.doppler_centroid_hz, work.options.doppler_bandwidth_hz};
  if (!in_time(request) && kept.width_hz <= 0.0)
    kept.width_hz = 1.0 / signal::fit_straight(work.input.echoes.track).interval_s;
  work.to_show = targets_to_show(*work.input.acquisition, work.input.echoes, kept, control);
  reach_targets(work.to_show, work.input.echoes, work.options);
}

// @param[in,out] request  its algorithm becomes the one that will be used
FocusPipeline work_on(FocusInput input, FocusRequest& request, const core::WorkControl& control) {
  FocusPipeline work{.request = {}, .input = std::move(input), .options = options_of(request), .problems = {}};
  choose_beforehand(request, work.input);
  const bool around = around_scene(request, work.input.echoes);
  work.options.doppler_centroid_hz = around ? 0.0 : first_centroid_hz(request, work.input, control);
  work.problems = problems_of_echoes(request, work.input.echoes, work.options);
  work.motion = wanted_motion(request, work.input.echoes, work.problems);
  expect_focusable(work.input, work.problems, work.motion);
  if (!around) {
    work.options.spectrum = spectrum_of_image(request, work, control);
    reach_targets_of(request, work, control);
  }
  const bool was_in_time = in_time(request);
  choose_method(request, work, control);
  work.problems = problems_of_echoes(request, work.input.echoes, work.options);
  if (!around && in_time(request) != was_in_time) {
    work.options.spectrum = spectrum_of_image(request, work, control);
    reach_targets_of(request, work, control);
  }
  return work;
}

void compensate_work(FocusPipeline& work, const FocusRequest& request, const core::WorkControl& control,
                     const core::Observer& observer) {
  work.strays_m = signal::fit_straight(work.input.echoes.track).worst_position_m;
  compensate(work.input, work.motion, request.ground_m, work.options, control,
             begun_stage(observer, name_of(request) + ": motion compensation"));
  work.options.doppler_centroid_hz =
      measured_centroid_hz(request, work.input.echoes, work.options.doppler_centroid_hz, control);
  work.problems = problems_of_echoes(request, work.input.echoes, work.options);
}

// All that there is to say of the work before it is done, ranked.
core::Problems problems_of_work(const FocusPipeline& work, const FocusRequest& request,
                                const core::WorkControl& control) {
  core::Problems problems = work.input.problems;
  core::append(problems, work.problems);
  if (core::has_errors(problems)) throw core::InvalidRequest(core::ranked(std::move(problems)));
  core::append(problems, diagnose_area(work.input.echoes, work.options));
  const DopplerBand kept{work.options.doppler_centroid_hz, work.options.doppler_bandwidth_hz};
  core::append(problems, diagnose_sar(*work.input.acquisition, work.input.echoes, kept,
                                      ambiguities_in(request, work.input.echoes), control));
  core::append(problems, diagnose_air(*work.input.acquisition));
  core::append(problems, diagnose_edges(*work.input.acquisition));
  if (!in_time(request))
    core::append(problems, diagnose_swath_loss(*work.input.acquisition, work.input.echoes, work.options, control));
  return core::ranked(std::move(problems));
}

signal::FocusedImage slant_axes(const FocusPipeline& work, const FocusRequest& request,
                                const std::vector<SarTarget>& targets, const signal::FocusOptions& options) {
  return in_time(request) ? back_projection_axes(work.input.echoes, targets, options)
                          : signal::image_of(work.input.echoes, options);
}

// Axes and frame of the image of slant range that is to be made. Adds remarks on a grid that differs from that of the
// recording.
signal::FocusedImage image_axes(FocusPipeline& work, const FocusRequest& request, const std::vector<SarTarget>& targets,
                                const core::WorkControl& control) {
  if (around_scene(request, work.input.echoes)) return scene_grid_axes(work.input, request.ground_m, control);
  const auto axes_for = [&](const signal::FocusOptions& options) {
    return slant_axes(work, request, targets, options);
  };
  signal::FocusedImage axes = axes_for(work.options);
  expect_samples(axes);
  if (!work.options.spectrum) return axes;
  signal::FocusOptions coarse = work.options;
  coarse.spectrum.reset();
  core::append(work.input.problems, diagnose_grid(axes_for(coarse), axes, *work.options.spectrum));
  core::append(work.input.problems, diagnose_carriers(work.input.echoes, *work.options.spectrum));
  return axes;
}

void remark_on_movers(FocusPipeline& work, signal::FocusedImage axes, const core::WorkControl& control) {
  if (work.options.azimuth_area) signal::cut_axis(axes.azimuth, *work.options.azimuth_area);
  core::append(work.input.problems, diagnose_movers(*work.input.acquisition, work.input.echoes, axes, control));
}

// @param axes  of slant range, or of the grid around a scene
void remark_on_outside(FocusPipeline& work, const FocusRequest& request, const signal::FocusedImage& axes) {
  if (around_scene(request, work.input.echoes)) return;
  core::append(work.input.problems, diagnose_outside(work.to_show, axes, work.options, in_time(request)));
}

signal::FocusedRows focused_rows(const FocusPipeline& work, const FocusRequest& request, signal::FocusedImage axes,
                                 const core::WorkControl& control, const core::Observer& observer) {
  const core::ProgressReport progress = begun_stage(observer, name_of(request));
  if (in_time(request)) {
    const BackProjectionChoice choice{request.grid == FocusGrid::ground, request.ground_m, request.start_stop};
    return back_projected(work.input, std::move(axes), choice, work.options, control, progress);
  }
  signal::FocusOptions options = work.options;
  if (work.motion != MotionOrder::none) options.memory_bytes /= 2;  // The compensated echoes have the other half.
  return signal::focus_rows(work.input.echoes, options, control, progress);
}

ImageOrigin origin_of(const FocusPipeline& work, const FocusRequest& request) {
  ImageOrigin origin{request.input.path,
                     request.input.script,
                     words_of_overrides(request.input.overrides),
                     work.input.simulation,
                     word_of(request.algorithm),
                     work.options,
                     to_string(work.motion),
                     work.input.acquisition->link.name,
                     work.input.acquisition->scene->options,
                     scene::earth_of(work.input.world)};
  // An image does not name a dataset beside the usual one.
  if (request.input.dataset.empty()) origin.recording = work.input.recording;
  return origin;
}

void write_outputs(const FocusReport& report, const FocusRequest& request, const core::StopFlag* stop) {
  for (const fs::path& path : report.files)
    if (path.has_parent_path()) fs::create_directories(path.parent_path());
  if (!request.output.empty()) write_image(report.image, report.origin, request.output, request.force, false, stop);
  if (request.magnitude)
    write_image(report.image, report.origin, magnitude_path(request.output), request.force, true, stop);
  if (report.autofocus && !request.autofocus_phase.empty())
    write_phase(*report.autofocus, request.autofocus_phase, request.force);
}

// Where on the Earth a SICD file is; said before the work begins. An image that is kept may become one later, where
// its place is known.
std::optional<EarthPlace> wanted_place(const FocusRequest& request, FocusInput& input) {
  const bool kept = request.output.empty() && (request.anchor || scene::earth_of(input.world));
  if (!kept && !is_sicd(request.output)) return std::nullopt;
  EarthPlace place = earth_place(input.world, request.anchor, "SICD");
  if (!kept) core::append(input.problems, place.remarks);
  return place;
}

}  // namespace

core::Problems diagnose_focus(FocusInput input, const core::WorkControl& control) {
  FocusRequest request;
  request.memory_bytes = 0;  // The same on all machines.
  const FocusPipeline work = work_on(std::move(input), request, control);
  core::Problems problems = work.input.problems;
  std::ranges::copy_if(work.problems, std::back_inserter(problems), [&](const core::Problem& problem) {
    return work.motion == MotionOrder::none || problem.subject.field != signal::track_field;
  });
  const simulate::Acquisition& acquisition = *work.input.acquisition;
  const signal::EchoRows& echoes = work.input.echoes;
  if (work.options.spectrum) core::append(problems, diagnose_carriers(echoes, *work.options.spectrum));
  std::optional<signal::FocusedImage> axes;
  if (moves(echoes) && !around_scene(request, echoes)) axes = slant_axes(work, request, work.to_show, work.options);
  core::append(problems, diagnose_movers(acquisition, echoes, axes, control));
  if (axes) core::append(problems, diagnose_outside(work.to_show, *axes, work.options, in_time(request)));
  const DopplerBand kept{work.options.doppler_centroid_hz, work.options.doppler_bandwidth_hz};
  core::append(problems,
               diagnose_ghosts(acquisition, echoes, kept, ambiguities_in(request, work.input.echoes), control));
  core::append(problems, diagnose_air(acquisition));
  core::append(problems, diagnose_edges(acquisition));
  return core::ranked(std::move(problems));
}

InMemoryImage in_memory_image(const FocusReport& report) {
  InMemoryImage kept = in_memory_image(report.image, report.origin);
  kept.input = report.input;
  return kept;
}

std::vector<TargetTheory> theory_of_focus(const FocusRequest& asked, const core::Observer& observer) {
  FocusRequest request = asked;
  const core::WorkControl control = observer.control(core::thread_count(request.threads));
  const FocusPipeline work = work_on(open_focus_input(request.input, control, request.navigation), request, control);
  observer.remarks(work.input.problems);
  signal::EchoRows echoes = work.input.echoes;
  echoes.compensated = in_time(request) || work.motion != MotionOrder::none;
  return theory_of_targets(*work.input.acquisition, echoes, work.options, in_time(request), control);
}

FocusPipeline begin_focus(FocusInput input, const FocusRequest& asked, const core::WorkControl& control) {
  validate(asked);
  expect_free_outputs(outputs_of(asked), {input.sources, asked.force, "--out"});
  FocusRequest request = asked;
  auto place = wanted_place(request, input);
  FocusPipeline work = work_on(std::move(input), request, control);
  work.request = std::move(request);
  work.place = std::move(place);
  return work;
}

std::vector<TargetTheory> targets_on_image(const FocusPipeline& begun, const signal::FocusedImage& image,
                                           const core::WorkControl& control) {
  std::vector<TargetTheory> theories = theory_on_image({*begun.input.acquisition, begun.input.echoes, begun.options,
                                                        in_time(begun.request), begun.motion != MotionOrder::none},
                                                       image, control);
  std::erase_if(theories, [](const TargetTheory& theory) { return !(theory.amplitude > 0.0); });
  return theories;
}

core::Problems diagnose_image(FocusPipeline begun, FocusPipeline ended, const signal::FocusedImage& image,
                              const core::WorkControl& control) {
  remark_on_movers(begun, image, control);
  if (image.frame.plane == signal::ImagePlane::slant_range) remark_on_outside(begun, begun.request, image);
  ended.input.problems = std::move(begun.input.problems);
  return problems_of_work(ended, ended.request, control);
}

FocusReport end_focus(FocusPipeline& work, const core::Observer& observer, FocusRemarks remarks) {
  const double begin_s = core::now_s();
  const FocusRequest& request = work.request;
  const std::optional<EarthPlace>& place = work.place;
  const core::WorkControl control = observer.control(core::thread_count(request.threads));
  const FocusInput recorded = place ? work.input : FocusInput{};  // Before its motion is compensated.
  const AutofocusChoice choice{request.autofocus_piece_m.value_or(0.0), work.options.memory_bytes};
  std::vector<SarTarget> targets;
  const auto look_at_targets = [&] {
    targets = targets_from_line(*work.input.acquisition, work.input.echoes, control);
  };
  if (request.autofocus || in_time(request)) look_at_targets();
  const signal::FocusedImage axes = image_axes(work, request, targets, control);
  if (remarks == FocusRemarks::first) {
    remark_on_movers(work, axes, control);
    remark_on_outside(work, request, axes);
  }
  if (request.autofocus) expect_autofocus(axes, work.input.echoes, targets, choice, work.options);
  if (work.motion != MotionOrder::none) {
    compensate_work(work, request, control, observer);
    if (request.autofocus) look_at_targets();
  }
  FocusReport report{
      .files = outputs_of(request),
      .image = {},
      .origin = origin_of(work, request),
      .input = request.input,
      .simulation = work.input.simulation,
      .algorithm = request.algorithm,
      .grid = request.grid.value_or(FocusGrid::slant),
      .options = work.options,
      .motion = work.motion,
      .strays_m = work.strays_m,
      .autofocus = {},
      .problems = remarks == FocusRemarks::first ? problems_of_work(work, request, control) : core::Problems()};
  observer.remarks(report.problems);
  report.image = focused_rows(work, request, axes, control, observer);
  if (request.autofocus) {
    std::tie(report.image, report.autofocus) =
        autofocused(report.image, work.input.echoes, targets, choice, work.options, control);
    const core::Problems failed = diagnose_autofocus(*report.autofocus);
    observer.remarks(failed);
    core::append(report.problems, failed);
  }
  if (place) {
    const bool refocused = report.autofocus && report.autofocus->applied;
    const ImageMaking making{report.image.image, work.options, in_time(request), refocused};
    report.origin.collection =
        std::make_shared<const ImageCollection>(collection_of(recorded, making, *place, control));
  }
  write_outputs(report, request, observer.stop);
  report.seconds = core::now_s() - begin_s;
  return report;
}

FocusReport focus(const FocusRequest& request, const core::Observer& observer) {
  const double begin_s = core::now_s();
  if (!request.input.held) expect_no_image(request.input.path);
  if (is_phase_history(request.input.path)) return focus_phase_history(request, observer);
  if (!request.channel.empty() || request.sign)
    throw core::InvalidRequest("--channel and --sign are for phase histories (CPHD)", "leave them out");
  validate(request);
  const core::WorkControl control = observer.control(core::thread_count(request.threads));
  FocusInput input = open_focus_input(request.input, control, request.navigation);
  FocusPipeline work = begin_focus(std::move(input), request, control);
  FocusReport report = end_focus(work, observer);
  report.seconds = core::now_s() - begin_s;
  return report;
}

}  // namespace sarsim::workflow
