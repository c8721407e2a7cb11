#include "workflow/input/motion_input.hpp"

#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "core/maths/constants.hpp"
#include "radar/earth/instant.hpp"
#include "scene/ephemeris/read_ephemeris.hpp"
#include "scene/ephemeris/sample_accuracy.hpp"
#include "scene/model/orbit.hpp"
#include "scene/model/read_path.hpp"
#include "scene/model/world_frame.hpp"
#include "scene/script/reader.hpp"
#include "workflow/input/cloud_input.hpp"
#include "workflow/input/function_tables.hpp"
#include "workflow/input/motion_accuracy.hpp"
#include "workflow/input/platform_path.hpp"
#include "workflow/input/sample_gaps.hpp"
#include "workflow/input/world_axes.hpp"

namespace sarsim::workflow {

namespace fs = std::filesystem;

namespace {

using scene::Platform;

// From one attitude to the next; a third of a turn. Which way around a larger turn goes is a guess.
constexpr double max_turn_rad = 2.0 * core::pi / 3.0;

// Nothing where there is none, which a problem says.
std::optional<FileText> text_of_file(const std::string& name, const fs::path& folder, core::Problems& problems) {
  const scene::DataFileText data = scene::disk_loader(folder)(name);
  if (!data.failure.empty() || data.path.empty()) {
    problems.push_back(core::error("the file of the motion cannot be read")
                           .found(name)
                           .hint(data.failure.empty() ? "check the name and the folder" : data.failure));
    return std::nullopt;
  }
  return FileText{data.text, data.path};
}

// Makes the attitude of one platform.
std::shared_ptr<const scene::ReadAttitude> attitude_of(const scene::Scene& scene, const Platform& platform,
                                                       const FileText& file, core::Problems& problems) {
  const auto refuse = [&](core::Problem problem) {
    problems.push_back(std::move(problem));
    return nullptr;
  };
  const WorldAxes axes(scene.world);
  if (scene::orbit_format_of(file.text) != scene::OrbitFormat::aem)
    return refuse(
        core::error(fmt::format("{} is not an attitude file", platform.attitude_file)).expected("a CCSDS AEM (KVN)"));
  if (!axes.earth() || !axes.epoch())
    return refuse(core::error(fmt::format("the attitudes in {} need the Earth and an epoch", platform.attitude_file))
                      .expected("[world] with frame = \"earth\", an anchor and an epoch"));
  scene::AttitudeReading reading = scene::read_attitude(file.text, file.path, {platform.satellite});
  const bool broken = core::has_errors(reading.problems);
  core::append(problems, std::move(reading.problems));
  if (broken) return nullptr;
  const radar::TimeSpan needed = scene::needed_times(scene);
  std::vector<radar::TimeSpan> spans;
  for (const scene::AttitudeSegment& segment : reading.file.segments) {
    radar::AttitudeSamples samples;
    std::vector<double>& times_s = samples.time_s;
    for (const scene::AttitudeState& state : segment.states) {
      const auto read = radar::instant_of(state.time, reading.file.scale, axes.orientation().dut1_s);
      if (!read.instant) return refuse(core::error(fmt::format("{}: {}", platform.attitude_file, read.failure)));
      times_s.push_back(radar::seconds_between(*axes.epoch(), *read.instant));
      samples.world_from_platform.push_back(
          radar::quaternion_of(axes.world_from(reading.file.reference, times_s.back()) *
                               core::transposed(scene::turned_from_first(state.body_from_reference))));
    }
    const auto usable_s = [&](const std::optional<radar::CivilTime>& time, double otherwise_s) {
      if (!time) return otherwise_s;
      const auto at = radar::instant_of(*time, reading.file.scale, axes.orientation().dut1_s);
      return at.instant ? radar::seconds_between(*axes.epoch(), *at.instant) : otherwise_s;
    };
    const radar::TimeSpan usable{usable_s(segment.usable.start, times_s.front()),
                                 usable_s(segment.usable.stop, times_s.back())};
    spans.push_back(usable);
    if (usable.first_s > needed.first_s || usable.last_s < needed.last_s) continue;
    if (const auto gap = gap_within(times_s, needed))
      return refuse(core::error(fmt::format("the attitudes of {} have a gap", platform.attitude_file))
                        .found(typed_times(*gap, axes))
                        .expected("attitudes evenly spaced over the recordings")
                        .hint(no_way_over_gaps));
    auto read = std::make_shared<scene::ReadAttitude>();
    read->usable = usable;
    const auto turn = scene::largest_turn(samples, needed);
    if (turn && turn->step > max_turn_rad)
      return refuse(
          core::error(fmt::format("{}: an attitude is turned too far from the one before it", platform.attitude_file))
              .found(fmt::format("{:.4g} deg within {:.6g} s from {:.6g} s on", turn->step * core::deg_per_rad,
                                 turn->spacing_s, turn->at_s))
              .expected(fmt::format("at most {:g} deg", max_turn_rad * core::deg_per_rad))
              .hint("the direction of rotation is ambiguous: use a file with closer attitudes, and check the order of "
                    "its numbers"));
    // Elsewhere it says that something is wrong with the file.
    const auto elsewhere = scene::largest_turn(samples, {times_s.front(), times_s.back()});
    if (elsewhere && elsewhere->step > max_turn_rad) {
      problems.push_back(
          core::warning("motion-file.turn",
                        fmt::format("{}: an attitude beside the recordings is turned far from the one before it",
                                    platform.attitude_file))
              .found(fmt::format("{:.4g} deg within {:.6g} s from {:.6g} s on", elsewhere->step * core::deg_per_rad,
                                 elsewhere->spacing_s, elsewhere->at_s))
              .expected(fmt::format("at most {:g} deg", max_turn_rad * core::deg_per_rad))
              .hint("check the order of its numbers"));
    }
    if (const auto accuracy = scene::accuracy_between(samples, needed))
      read->accuracy = {accuracy->error, accuracy->at_s, accuracy->spacing_s};
    auto table = radar::AttitudeTable::from(samples);
    if (auto* const problem = std::get_if<core::Problem>(&table)) return refuse(std::move(*problem));
    read->attitudes = std::make_shared<const radar::AttitudeTable>(std::get<radar::AttitudeTable>(std::move(table)));
    return read;
  }
  const bool one = spans.size() == 1;
  const radar::TimeSpan all{spans.front().first_s, spans.back().last_s};
  const std::string who = one ? platform.attitude_file : fmt::format("no segment of {}", platform.attitude_file);
  return refuse(
      core::error(fmt::format("{} {} the recordings", who, one ? "does not cover" : "covers"))
          .found(one ? typed_times(all, axes) : fmt::format("{} segments, {}", spans.size(), typed_times(all, axes)))
          .expected(typed_times(needed, axes))
          .hint("change the epoch or the times of the recordings, or take another file"));
}

std::string world_key(const scene::Scene& scene) {
  const scene::World& world = scene.world;
  const radar::TimeSpan needed = scene::needed_times(scene);
  return fmt::format("{}|{}|{}|{}|{}|{}|{}|{}|{}", static_cast<int>(world.frame), world.epoch, world.latitude.deg(),
                     world.longitude.deg(), world.height_m, world.heading.deg(), world.dut1_s, needed.first_s,
                     needed.last_s);
}

std::string key_of_path(const Platform& p, const std::string& world) {
  if (p.path == Platform::Path::orbit)
    return fmt::format("{}|{}|{}|{}|{}|{}|{}", world, p.semi_major_axis_m, p.eccentricity, p.inclination.deg(),
                       p.node_longitude.deg(), p.perigee.deg(), p.anomaly.deg());
  if (p.path == Platform::Path::state) {
    const core::Vec3& at = p.state_position_m;
    const core::Vec3& to = p.state_velocity_mps;
    return fmt::format("{}|{}|{}|{}|{}|{}|{}", world, at.x, at.y, at.z, to.x, to.y, to.z);
  }
  return fmt::format("{}|{}|{}|{}", world, p.ephemeris_file, p.satellite, static_cast<int>(p.interpolation));
}

void read_path(scene::Scene& scene, Platform& platform, const fs::path& folder, core::Problems& problems) {
  const bool from_file = platform.path == Platform::Path::ephemeris;
  if (!scene::is_orbit(platform.path)) {
    platform.read_path = {};
    return;
  }
  const std::string key = key_of_path(platform, world_key(scene));
  if (platform.read_path && platform.read_path->made_of == key) {
    problems = platform.read_path->remarks;
    return;
  }
  platform.read_path = {};
  if (from_file && platform.ephemeris_file.empty()) return;  // `check` says it.
  std::optional<FileText> file;
  if (from_file && !(file = text_of_file(platform.ephemeris_file, folder, problems))) return;
  const auto made = path_of_platform(scene, platform, file, problems);
  if (!made) return;
  auto kept = std::make_shared<scene::ReadPath>(*made);
  kept->made_of = key;
  kept->remarks = problems;
  platform.read_path = std::shared_ptr<const scene::ReadPath>(std::move(kept));
}

void read_attitude(scene::Scene& scene, Platform& platform, const fs::path& folder, core::Problems& problems) {
  if (platform.rotation_kind != Platform::Rotation::quaternions) {
    platform.read_attitude = {};
    return;
  }
  const std::string key = fmt::format("{}|{}|{}", world_key(scene), platform.attitude_file, platform.satellite);
  if (platform.read_attitude && platform.read_attitude->made_of == key) {
    problems = platform.read_attitude->remarks;
    return;
  }
  platform.read_attitude = {};
  if (platform.attitude_file.empty()) return;
  const auto file = text_of_file(platform.attitude_file, folder, problems);
  if (!file) return;
  const auto made = attitude_of(scene, platform, *file, problems);
  if (!made) return;
  auto kept = std::make_shared<scene::ReadAttitude>(*made);
  kept->made_of = key;
  kept->remarks = problems;
  platform.read_attitude = std::shared_ptr<const scene::ReadAttitude>(std::move(kept));
}

}  // namespace

core::Problems read_motions(scene::Scene& scene, const fs::path& folder) {
  core::Problems all;
  if (!scene::epoch_of(scene.world).failure.empty()) return all;  // `check` says it.
  for (std::size_t i = 0; i < scene.platforms.size(); ++i) {
    const auto add = [&](core::Problems problems, const char* field) {
      for (core::Problem& problem : problems) {
        problem.subject = {"platform", i, problem.subject.field.empty() ? field : problem.subject.field};
        all.push_back(std::move(problem));
      }
    };
    Platform& platform = scene.platforms[i];
    core::Problems of_path, of_attitude;
    read_path(scene, platform, folder, of_path);
    core::append(of_path, problems_between_states(scene, i));
    add(std::move(of_path), platform.path == Platform::Path::ephemeris ? "ephemeris_file" : "path");
    read_attitude(scene, platform, folder, of_attitude);
    core::append(of_attitude, problems_between_attitudes(scene, i));
    add(std::move(of_attitude), "attitude_file");
  }
  return all;
}

core::Problems read_files_of(scene::Scene& scene, const fs::path& folder, const core::WorkControl& control) {
  core::Problems problems = read_clouds(scene, folder, control);
  core::append(problems, read_motions(scene, folder));
  core::append(problems, read_function_tables(scene, folder, control));
  return problems;
}

}  // namespace sarsim::workflow
