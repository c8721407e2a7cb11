#include "workflow/motion/motion_files.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <functional>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "core/os/output_file.hpp"
#include "core/report/invalid_request.hpp"
#include "core/text/number_text.hpp"
#include "scene/ephemeris/interpolation_error.hpp"
#include "scene/ephemeris/write_motion.hpp"
#include "scene/model/read_path.hpp"
#include "scene/model/world_frame.hpp"
#include "scene/script/data_file.hpp"
#include "simulate/resolve/conventions.hpp"
#include "simulate/resolve/navigation.hpp"
#include "simulate/resolve/platform_motion.hpp"
#include "workflow/input/motion_input.hpp"
#include "workflow/input/output_names.hpp"

namespace sarsim::workflow {

namespace {

// Attitudes have no interpolation of their own in a file; this follows all that aircraft and satellites do.
constexpr double attitude_spacing_s = 0.1;

// A platform that can be asked for its pose at any time.
class AskedMotion {
 public:
  AskedMotion(const scene::Scene& scene, std::size_t platform, bool navigation) {
    scene::Scene smooth = scene;
    for (scene::Platform& each : smooth.platforms) {
      each.position_stddev_m = {};
      each.rotation_stddev = {};
    }
    std::vector<radar::Track> tracks = simulate::tracks_of(smooth, simulate::interpolation_rules(smooth.options));
    track_.emplace(std::move(tracks[platform]));
    if (navigation) errors_ = simulate::navigation_errors_of(scene.platforms[platform], scene.options.seed);
  }

  [[nodiscard]] radar::Pose pose(double time_s) const {
    const radar::Pose pose = track_->at(time_s, 0, steps_);
    return errors_ ? errors_->believed(pose, time_s) : pose;
  }
  [[nodiscard]] radar::PathState state(double time_s) const {
    const radar::Pose at = pose(time_s);
    return {at.position_world_m, at.velocity_world_mps, {}, {}};
  }

 private:
  std::optional<radar::Track> track_;
  std::optional<simulate::NavigationErrors> errors_;
  mutable radar::Track::ErrorSteps steps_;
};

std::size_t platform_called(const scene::Scene& scene, const std::string& name) {
  if (name.empty() && scene.platforms.size() == 1) return 0;
  if (name.empty()) throw core::InvalidRequest("the scene has several platforms", "name one with --platform");
  const std::size_t found = scene::find_platform(scene, name);
  if (found != scene::not_found) return found;
  if (const std::size_t radar = scene::find_radar(scene, name); radar != scene::not_found)
    throw core::InvalidRequest(fmt::format("'{}' is a radar", name),
                               fmt::format("name its platform: --platform {}", scene.radars[radar].platform));
  std::vector<std::string> names;
  for (const scene::Platform& platform : scene.platforms) names.push_back(platform.name);
  const std::string nearest = core::nearest_word(name, names);
  throw core::InvalidRequest(fmt::format("the scene has no platform '{}'", name),
                             nearest.empty() ? "" : fmt::format("did you mean '{}'?", nearest));
}

scene::Reconstruction reconstruction_of(MotionFormat format, const scene::Scene& scene) {
  if (format != MotionFormat::data_file) return scene::Reconstruction::hermite_degree_7;
  return scene.options.cubic_ends == core::CubicEnds::chords ? scene::Reconstruction::spline_chords
                                                             : scene::Reconstruction::spline_not_a_knot;
}

template <class Value>
Value sound(std::variant<Value, core::Problem> read) {
  if (auto* const problem = std::get_if<core::Problem>(&read)) throw core::InvalidRequest({std::move(*problem)});
  return std::get<Value>(std::move(read));
}

// Times and what the reader makes of them.
struct Sampling {
  std::vector<double> times_s;
  double spacing_s = 0.0;
  scene::InterpolationError error;
};

Sampling sampling_of(const MotionRequest& request, const AskedMotion& motion, scene::Reconstruction reconstruction,
                     double first_s, double last_s) {
  const scene::MotionPath path = [&](double time_s) { return motion.state(time_s); };
  Sampling sampling;
  if (request.spacing_s) {
    sampling.spacing_s = *request.spacing_s;
    sampling.times_s = scene::sample_times(first_s, last_s, sampling.spacing_s);
    sampling.error = sound(scene::interpolation_error(path, sampling.times_s, reconstruction));
    return sampling;
  }
  const scene::SpacingChoice chosen =
      sound(scene::spacing_for(path, {request.error_m, first_s, last_s, reconstruction}));
  sampling.spacing_s = chosen.spacing_s;
  sampling.times_s = scene::sample_times(first_s, last_s, chosen.spacing_s);
  sampling.error = chosen.error;
  return sampling;
}

std::string text_of(scene::MotionText text, core::Problems& remarks) {
  if (core::has_errors(text.problems)) throw core::InvalidRequest(core::ranked(std::move(text.problems)));
  core::append(remarks, std::move(text.problems));
  return std::move(text.text);
}

scene::MotionFacts facts_of(const scene::Scene& scene, const std::string& platform, MotionFormat format) {
  scene::MotionFacts facts;
  facts.object_name = platform;
  facts.epoch = scene::epoch_of(scene.world).instant;
  facts.earth = scene::earth_of(scene.world);
  // The same scene gives the same file: CCSDS messages, which must have a date and say what it is, have that of the
  // scene, and tables none.
  const bool is_message = format == MotionFormat::oem || format == MotionFormat::aem;
  if (!is_message || !facts.epoch) return facts;
  facts.created = radar::format_instant(*facts.epoch, radar::TimeScale::utc, 3);
  if (facts.created.ends_with('Z')) facts.created.pop_back();
  facts.created_is_epoch = true;
  return facts;
}

std::string motion_text(MotionFormat format, const AskedMotion& motion, const std::vector<double>& times_s,
                        const scene::MotionFacts& facts, core::Problems& remarks) {
  if (format == MotionFormat::aem) {
    std::vector<scene::AttitudeSample> samples;
    for (const double time_s : times_s) samples.push_back({time_s, motion.pose(time_s).world_from_platform});
    return text_of(scene::write_attitude_aem(samples, facts), remarks);
  }
  std::vector<scene::MotionSample> samples;
  for (const double time_s : times_s) {
    const radar::PathState state = motion.state(time_s);
    samples.push_back({time_s, state.position_world_m, state.velocity_world_mps});
  }
  if (format == MotionFormat::oem) return text_of(scene::write_motion_oem(samples, facts), remarks);
  if (format == MotionFormat::csv) return text_of(scene::write_motion_csv(samples, facts), remarks);
  const std::array<core::SampledFunction, 3> functions = scene::trajectory_functions(samples);
  return scene::write_data_file(functions, scene::function_blocks::trajectory);
}

struct Times {
  double first_s = 0.0;
  double last_s = 0.0;
};

Times times_of(const MotionRequest& request, const scene::Scene& scene) {
  const radar::TimeSpan needed = scene::needed_times(scene);
  const Times times{request.start_s.value_or(needed.first_s), request.end_s.value_or(needed.last_s)};
  if (!(times.first_s < times.last_s))
    throw core::InvalidRequest(fmt::format("the times {} s to {} s are empty", core::format_number(times.first_s),
                                           core::format_number(times.last_s)),
                               scene.simulations.empty() && scene.geometries.empty()
                                   ? "give --start and --end: the scene has no recording"
                                   : "give --start and an --end behind it");
  return times;
}

// States of files and orbits are made for the times of recordings; here others may be asked for.
void read_for(const Times& times, scene::Scene& scene, const std::filesystem::path& folder) {
  scene.simulations.clear();
  scene::GeometryTable table;
  table.time_start_s = times.first_s;
  table.time_end_s = times.last_s;
  scene.geometries = {table};
  core::Problems problems = read_motions(scene, folder);
  if (core::has_errors(problems)) throw core::InvalidRequest(core::ranked(std::move(problems)));
}

}  // namespace

std::optional<MotionFormat> motion_format_of(const std::string& file) {
  const std::string ending = std::filesystem::path(file).extension().string();
  if (core::equal_ignoring_case(ending, ".csv")) return MotionFormat::csv;
  if (core::equal_ignoring_case(ending, ".oem")) return MotionFormat::oem;
  if (core::equal_ignoring_case(ending, ".aem")) return MotionFormat::aem;
  if (core::equal_ignoring_case(ending, ".txt") || core::equal_ignoring_case(ending, ".dat"))
    return MotionFormat::data_file;
  return std::nullopt;
}

MotionReport write_motion(const MotionRequest& request, const core::WorkControl& control) {
  const auto format = motion_format_of(request.output);
  if (!format)
    throw core::InvalidRequest(fmt::format("'{}' names no format of motion files", request.output),
                               "end it with .csv, .oem, .aem (attitudes) or .txt (data file of a script)");
  if (request.spacing_s && !(*request.spacing_s > 0.0))
    throw core::InvalidRequest("the spacing is not above 0 s", "leave --spacing out to have it chosen");
  SceneInput input = read_scene(request.input, request.overrides, CheckLevel::values, control);
  expect_usable(input);
  expect_free_outputs({request.output}, {input.sources, request.force, "--out"});
  const std::size_t index = platform_called(input.scene, request.platform);
  const std::string name = input.scene.platforms[index].name;
  const Times times = times_of(request, input.scene);
  read_for(times, input.scene, std::filesystem::path(request.input).parent_path());
  if (request.navigation && input.scene.platforms[index].navigation == scene::Platform::Navigation::none)
    throw core::InvalidRequest(fmt::format("platform '{}' has no navigation", name),
                               "write navigation = { type = \"ins\", ... }, or leave --navigation out");
  const AskedMotion motion(input.scene, index, request.navigation);
  MotionReport report;
  report.platform = name;
  report.format = *format;
  report.first_s = times.first_s;
  report.last_s = times.last_s;
  // What is wrong with recordings is no matter of the motion.
  std::ranges::copy_if(input.problems, std::back_inserter(report.remarks), [&](const core::Problem& problem) {
    const std::string& kind = problem.subject.kind;
    return kind.empty() || kind == "platform" || kind == "world" ||
           std::ranges::any_of(input.of_files, [&](const core::Problem& known) {
             return known.message == problem.message && known.place == problem.place;
           });
  });
  Sampling sampling;
  if (*format == MotionFormat::aem) {
    sampling.spacing_s = request.spacing_s.value_or(attitude_spacing_s);
    sampling.times_s = scene::sample_times(times.first_s, times.last_s, sampling.spacing_s);
  } else {
    sampling = sampling_of(request, motion, reconstruction_of(*format, input.scene), times.first_s, times.last_s);
  }
  report.spacing_s = sampling.spacing_s;
  report.samples = sampling.times_s.size();
  report.position_error_m = sampling.error.position_m;
  report.velocity_error_mps = sampling.error.velocity_mps;
  const std::string text =
      motion_text(*format, motion, sampling.times_s, facts_of(input.scene, name, *format), report.remarks);
  core::OutputFile file(request.output, request.force);
  file.write(std::as_bytes(std::span(text)));
  file.commit();
  return report;
}

}  // namespace sarsim::workflow
