#include "workflow/focus/focus_phase_history.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <memory>
#include <string_view>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "core/maths/constants.hpp"
#include "core/os/free_memory.hpp"
#include "core/os/input_file.hpp"
#include "core/report/invalid_request.hpp"
#include "core/task/clock.hpp"
#include "core/text/number_text.hpp"
#include "raster/table/formats.hpp"
#include "signal/sar/back_projection.hpp"
#include "workflow/focus/phase_history_rows.hpp"
#include "workflow/image/image_output.hpp"
#include "workflow/input/earth_place.hpp"
#include "workflow/input/override_words.hpp"

namespace sarsim::workflow {

namespace fs = std::filesystem;

namespace {

using raster::PhaseVector;

// Options that say something of scenes, tracks or slant range, which a phase history leaves no choice of.
void expect_options_of_history(const FocusRequest& request) {
  const std::pair<const char*, bool> given[] = {
      {"--algorithm",
       request.algorithm != FocusAlgorithm::automatic && request.algorithm != FocusAlgorithm::back_projection},
      {"--script", !request.input.script.empty()},
      {"--simulation", request.input.simulation.has_value()},
      {"--set and its like", !words_of_overrides(request.input.overrides).empty()},
      {"--navigation", !request.navigation.empty()},
      {"--azimuth-window", request.azimuth_window.kind != signal::SarWindow::Kind::rectangular},
      {"--doppler-centroid", request.centroid != CentroidSource::geometry},
      {"--doppler-bandwidth", request.bandwidth_hz != 0.0},
      {"--start-stop", request.start_stop},
      {"--anchor", request.anchor.has_value()},
      {"--motion-compensation", request.motion.value_or(MotionOrder::none) != MotionOrder::none},
      {"--autofocus", request.autofocus}};
  for (const auto& [option, there] : given)
    if (there)
      throw core::InvalidRequest(
          fmt::format("{} means nothing for '{}', a phase history, which is back-projected onto its "
                      "image area as it is",
                      option, request.input.path),
          "leave it out; --window is over range alone");
  if (!request.output.empty() && is_sicd(request.output))
    throw core::InvalidRequest("SICD tells the scene of an image, which a phase history does not know",
                               "name the output .img, .npy or .h5");
}

std::shared_ptr<const raster::CphdFile> opened_history(const std::string& path, core::Problems& problems,
                                                       const core::StopFlag* stop) {
  auto input = core::InputFile::open(path);
  if (auto* problem = std::get_if<core::Problem>(&input)) throw core::InvalidRequest({std::move(*problem)});
  auto file = raster::CphdFile::open(std::move(std::get<core::InputFile>(input)), problems, stop);
  if (!file) throw core::InvalidRequest(core::ranked(std::move(problems)));
  return file;
}

// What a file of ours says of the scene that it was made from; empty of others.
std::string said_of_scene(const raster::CphdDescription& d, std::string_view name) {
  const auto value = [&d](std::string_view wanted) {
    const auto found = std::ranges::find(d.parameters, wanted, [](const auto& parameter) { return parameter.first; });
    return found == d.parameters.end() ? std::string() : found->second;
  };
  return value("Software").starts_with("Sarsim") ? value(name) : std::string();
}

// Of the world in which the image lies: that of the scene, or else the reference point, with y to the north.
radar::Anchor anchor_of(const raster::CphdDescription& d) {
  if (const std::string anchor = said_of_scene(d, "Anchor"); !anchor.empty())
    return anchor_from_text(anchor, "parameter Anchor of CollectionID");
  return {radar::geodetic_of(d.scene.origin_m), 0.0};
}

// Position in the list of the scene.
std::size_t simulation_of(const raster::CphdDescription& d) {
  const auto number = core::parse_integer(said_of_scene(d, "Simulation"));
  return number && *number >= 1 ? static_cast<std::size_t>(*number) - 1 : 0;
}

std::size_t channel_named(const raster::CphdFile& file, const std::string& id) {
  if (const auto channel = file.channel_of(id)) return *channel;
  std::string known;
  for (const raster::PhaseChannel& channel : file.description().channels)
    known += (known.empty() ? "" : ", ") + channel.id;
  throw core::InvalidRequest({core::error("--channel: the file has no such channel")
                                  .found(id)
                                  .expected(known)
                                  .hint("say one of them; without --channel the reference channel is taken")});
}

// The lowest and the highest spatial frequency along an axis, cycles per metre, of the echoes of the area's middle and
// corners, as they are in the image: less those of the turning by the distance from the line.
struct Band {
  double low = INFINITY;
  double high = -INFINITY;

  void take(double frequency) {
    low = std::min(low, frequency);
    high = std::max(high, frequency);
  }
};

// What is needed to lay a grid over the image area.
struct Area {
  core::Vec3 origin_m, x, y;  // world
  raster::AreaRectangle rectangle;
};

Band band_along(const core::Vec3& axis, const Area& area, const std::vector<PhaseVector>& vectors,
                const PhaseHistoryRows& rows, const signal::ReferenceTrack& line, double carrier_hz, bool bistatic,
                const radar::EarthFrame& earth) {
  constexpr double step_m = 0.01;
  const double c = core::exact_light_speed_mps;
  Band band;
  const raster::AreaRectangle& a = area.rectangle;
  for (const double x : {a.x1, 0.5 * (a.x1 + a.x2), a.x2})
    for (const double y : {a.y1, 0.5 * (a.y1 + a.y2), a.y2}) {
      const core::Vec3 point_m = area.origin_m + x * area.x + y * area.y;
      const double turning =
          carrier_hz * 2.0 / c *
          (signal::distance_from(line, point_m + step_m * axis) - signal::distance_from(line, point_m)) / step_m;
      for (const PhaseVector& v : vectors) {
        const core::Vec3 out = point_m - rows.track_point(v).position_m;
        const core::Vec3 back = bistatic ? point_m - earth.world_from_ecef(v.rcv_m) : out;
        const double slope = core::dot(out, axis) / core::norm(out) + core::dot(back, axis) / core::norm(back);
        for (const double fx_hz : {v.fx1_hz, v.fx2_hz}) band.take(fx_hz * slope / c - turning);
      }
    }
  return band;
}

// Metres in azimuth after which a point appears again: the phases of points so far apart differ by whole turns from
// pulse to pulse. A mean over all pulses.
double repeats_after_m(const signal::FocusedImage& image, const std::vector<PhaseVector>& vectors, std::size_t pulses,
                       const PhaseHistoryRows& rows, const raster::CphdDescription& d, const radar::EarthFrame& earth) {
  const core::Vec3& axis = image.frame.along;
  const core::Vec3 middle_m = earth.world_from_ecef(d.scene.origin_m);
  const auto turns_per_m = [&](const PhaseVector& v) {
    const core::Vec3 out = middle_m - rows.track_point(v).position_m;
    const core::Vec3 back = d.bistatic ? middle_m - earth.world_from_ecef(v.rcv_m) : out;
    return image.carrier_hz / image.light_speed_mps *
           (core::dot(out, axis) / core::norm(out) + core::dot(back, axis) / core::norm(back));
  };
  const double step = std::abs(turns_per_m(vectors.back()) - turns_per_m(vectors.front()));
  return step > 0.0 ? static_cast<double>(pulses - 1) / step : std::numeric_limits<double>::infinity();
}

// Where pulses are too far apart for the width of the image.
void remark_on_repetition(const signal::FocusedImage& image, double repeats_m, core::Problems& problems) {
  const double width_m = static_cast<double>(image.azimuth.count) * image.azimuth.step_m;
  if (!(repeats_m < width_m)) return;
  problems.push_back(
      core::warning("focus.pulses-too-far-apart",
                    fmt::format("pulses are too far apart for the image: a point appears again every {:.4g} m in "
                                "azimuth (azimuth ambiguity) unless outside the beam, and the image is {:.4g} m wide",
                                repeats_m, width_m))
          .hint(fmt::format("focus a part that is narrower, for instance --azimuth {:.3g}:{:.3g}", -0.45 * repeats_m,
                            0.45 * repeats_m)));
}

// An axis over [low, high] whose samples tell all frequencies of a band apart.
signal::ImageAxis axis_over(double low_m, double high_m, const Band& band) {
  constexpr double spare = 1.25;
  constexpr double min_per_m = 1e-4;
  signal::ImageAxis axis;
  axis.step_m = 1.0 / std::max(spare * (band.high - band.low), min_per_m);
  axis.first_m = std::ceil(low_m / axis.step_m) * axis.step_m;
  const double count = std::floor(high_m / axis.step_m) - std::ceil(low_m / axis.step_m) + 1.0;
  axis.count = count >= 1.0 ? static_cast<std::size_t>(std::min(count, 0x1p40)) : 0;
  axis.spectrum_centre_per_m = 0.5 * (band.low + band.high);
  return axis;
}

void expect_room(const signal::FocusedImage& image, const FocusRequest& request) {
  const double bytes = 8.0 * static_cast<double>(image.azimuth.count) * static_cast<double>(image.range.count) * 2.0;
  const std::size_t allowed = request.memory_bytes.value_or(core::free_memory_bytes().value_or(0) / 2);
  if (allowed == 0 || bytes <= static_cast<double>(allowed)) return;
  throw core::InvalidRequest(
      fmt::format("an image of {} x {} samples takes {}, but {} may be used", image.azimuth.count, image.range.count,
                  core::bytes_text(bytes), core::bytes_text(static_cast<double>(allowed))),
      "give a part of the area with --azimuth FIRST:LAST and --range FIRST:LAST, or more --memory");
}

// Axes and frame of the image, without values.
signal::FocusedImage image_over(const raster::CphdDescription& d, const PhaseHistoryRows& rows,
                                const std::vector<PhaseVector>& vectors, const signal::ReferenceTrack& line,
                                const radar::EarthFrame& earth, const FocusRequest& request) {
  Area area{earth.world_from_ecef(d.scene.origin_m), earth.world_axes_from_ecef(d.scene.x_axis),
            earth.world_axes_from_ecef(d.scene.y_axis), d.scene.area};
  area.origin_m = area.origin_m + request.ground_m.value_or(0.0) * core::cross(area.x, area.y);
  raster::AreaRectangle& a = area.rectangle;
  if (request.azimuth_area)
    std::tie(a.x1, a.x2) = std::pair(request.azimuth_area->first_m, request.azimuth_area->last_m);
  if (request.range_area) std::tie(a.y1, a.y2) = std::pair(request.range_area->first_m, request.range_area->last_m);
  signal::FocusedImage image;
  image.carrier_hz = rows.channel().centre_hz;
  image.light_speed_mps = core::exact_light_speed_mps;
  image.frame = {signal::ImagePlane::ground_grid, area.origin_m, area.x, area.y, core::norm(line.velocity_mps)};
  const auto band = [&](const core::Vec3& axis) {
    return band_along(axis, area, vectors, rows, line, image.carrier_hz, d.bistatic, earth);
  };
  image.azimuth = axis_over(a.x1, a.x2, band(area.x));
  image.range = axis_over(a.y1, a.y2, band(area.y));
  if (image.azimuth.count == 0 || image.range.count == 0)
    throw core::InvalidRequest("no sample of the image lies in the area of --azimuth and --range",
                               "give a larger area");
  return image;
}

// One pulse tells ranges apart and no directions.
void expect_several(std::size_t vectors, const raster::PhaseChannel& channel, const std::string& path) {
  if (vectors > 1) return;
  throw core::InvalidRequest(
      {core::error(fmt::format("channel '{}' has a signal in one vector: one pulse makes no image", channel.id))
           .found(fmt::format("{} of {} vectors", vectors, channel.vectors))
           .expected("two vectors or more")
           .hint("the image viewer and sarsim plot show the vector itself; --channel chooses another channel")
           .in(path)});
}

signal::BackProjectionOptions weights_of(const FocusRequest& request) {
  signal::BackProjectionOptions back;
  if (request.range_window.kind != signal::SarWindow::Kind::rectangular)
    back.range_window = [weight = signal::weight_of(request.range_window)](double x) { return weight(x - 0.5); };
  return back;
}

// Sums all vectors over the grid, block by block.
void sum_up(const PhaseHistoryRows& rows, const signal::PointGrid& grid, const signal::BackProjectionOptions& options,
            const core::WorkControl& control, const core::ProgressReport& progress, signal::FocusedImage& image) {
  image.values.assign(grid.rows * grid.columns, {});
  const std::size_t vectors = rows.channel().vectors;
  std::size_t used = 0;
  for (std::size_t first = 0; first < vectors;) {
    const std::size_t count = rows.together(first);
    const signal::SarEchoes echoes = rows.echoes(first, count, control);
    const auto pulses = static_cast<float>(echoes.track.size());
    if (!echoes.track.empty()) {
      const auto values = signal::back_project(echoes, grid, options, control);
      for (std::size_t i = 0; i < values.size(); ++i) image.values[i] += pulses * values[i];
    }
    used += echoes.track.size();
    first += count;
    if (progress) progress({first, vectors, grid.rows * grid.columns});
  }
  if (used == 0) throw core::InvalidRequest("no vector of the channel has a signal (SIGNAL is 0 in all of them)");
  const float share = 1.0F / static_cast<float>(used);
  for (std::complex<float>& value : image.values) value *= share;
}

}  // namespace

bool is_phase_history(const std::string& path) {
  const raster::Format* const row = raster::row_from_path(path);
  if (row != nullptr && row->signature == "CPHD/") return true;
  constexpr std::string_view signature = "CPHD/";
  return core::beginning_of(path, signature.size()) == signature;
}

FocusReport focus_phase_history(const FocusRequest& asked, const core::Observer& observer) {
  const double begin_s = core::now_s();
  expect_options_of_history(asked);
  FocusRequest request = asked;
  request.algorithm = FocusAlgorithm::back_projection;
  request.grid = FocusGrid::ground;
  validate(request);
  const core::WorkControl control = observer.control(core::thread_count(request.threads));
  FocusReport report;
  report.files = outputs_of(request);
  report.algorithm = request.algorithm;
  report.grid = *request.grid;
  const auto file = opened_history(request.input.path, report.problems, observer.stop);
  const raster::CphdDescription& d = file->description();
  const std::size_t channel = channel_named(*file, request.channel);
  if (request.sign && *request.sign == d.sign)
    report.problems.push_back(core::note("focus.needless-sign", "--sign repeats what the file says itself"));
  const radar::EarthFrame earth(anchor_of(d));
  const PhaseHistoryRows rows(file, channel, request.sign, earth);
  constexpr std::size_t max_looks = 1024;
  const std::vector<PhaseVector> vectors = rows.some_vectors(max_looks);
  if (vectors.empty()) throw core::InvalidRequest("no vector of the channel has a signal (SIGNAL is 0 in all of them)");
  expect_several(vectors.size(), rows.channel(), request.input.path);
  std::vector<signal::TrackPoint> track;
  for (const PhaseVector& vector : vectors) track.push_back(rows.track_point(vector));
  const signal::ReferenceTrack line = signal::fitted_track(track);
  auto image = std::make_shared<signal::FocusedImage>(image_over(d, rows, vectors, line, earth, request));
  expect_room(*image, request);
  remark_on_repetition(*image, repeats_after_m(*image, vectors, rows.channel().vectors, rows, d, earth),
                       report.problems);
  report.problems = core::ranked(std::move(report.problems));
  observer.remarks(report.problems);
  const signal::PointGrid grid = signal::points_of(image->frame, image->azimuth, image->range);
  report.options.range_window = request.range_window;
  sum_up(rows, grid, weights_of(request), control, observer.stage(request.output.string()), *image);
  signal::turn_to_baseband(*image, grid, line, control);
  report.image = signal::rows_of(std::shared_ptr<const signal::FocusedImage>(image));
  report.input = request.input;
  report.origin = {.source = request.input.path,
                   .script = {},
                   .settings = {},
                   .simulation = simulation_of(d),
                   .algorithm = word_of(request.algorithm),
                   .options = report.options,
                   .motion = "none",
                   .radar = d.collector,
                   .run = {},
                   .earth = earth,
                   .anchor = earth.anchor()};
  for (const fs::path& path : report.files)
    if (path.has_parent_path()) fs::create_directories(path.parent_path());
  if (!request.output.empty())
    write_image(report.image, report.origin, request.output, request.force, false, observer.stop);
  if (request.magnitude)
    write_image(report.image, report.origin, magnitude_path(request.output), request.force, true, observer.stop);
  report.seconds = core::now_s() - begin_s;
  return report;
}

}  // namespace sarsim::workflow
