#include "workflow/focus/measure.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "core/maths/constants.hpp"
#include "core/report/refused.hpp"
#include "core/task/parallel.hpp"
#include "raster/format/envi.hpp"
#include "raster/format/open_raster.hpp"
#include "scene/model/world_frame.hpp"
#include "signal/measure/noise_floor.hpp"
#include "signal/sar/sar_track.hpp"
#include "workflow/focus/focus_input.hpp"
#include "workflow/focus/movers.hpp"
#include "workflow/focus/sar_ghosts.hpp"
#include "workflow/image/image_output.hpp"
#include "workflow/image/image_script.hpp"
#include "workflow/image/sicd_image.hpp"
#include "workflow/input/output_names.hpp"
#include "workflow/input/override_words.hpp"

namespace sarsim::workflow {

namespace fs = std::filesystem;

namespace {

struct MeasuredImage {
  raster::EnviHeader header;
  signal::ImageReader reader;
  signal::FocusedImage image;
  ImageOrigin origin;
};

// Reads parts of the rows of an image in memory.
signal::ImageReader reader_of(const core::SampleRows<float>& rows) {
  return [rows](std::size_t row, std::size_t first, std::span<std::complex<float>> out) {
    std::vector<std::complex<float>> whole(rows.columns);
    rows.read(row, whole);
    std::copy_n(whole.begin() + static_cast<std::ptrdiff_t>(first), out.size(), out.begin());
  };
}

MeasuredImage kept_image_to_measure(const MeasureRequest& request) {
  const KeptImage& kept = *request.kept;
  if (!kept.origin || !kept.input)
    throw core::Refused("the image was not made by focusing", "measure the image of a focused recording");
  MeasuredImage opened{kept.content.header, reader_of(kept.rows), {}, {}};
  read_header(opened.header, request.image.string(), opened.image, opened.origin);
  return opened;
}

// The columns of the file are the rows of the image.
MeasuredImage opened_sicd(const std::string& path) {
  raster::OpenedRaster file = raster::open_raster(raster::Integrity::whole, path);
  if (!file.raster) throw core::Refused(core::ranked(std::move(file.problems)));
  auto source = sicd_source(*file.raster);
  if (!source)
    throw core::Refused(fmt::format("'{}' says nothing of a script: it is of another program", path),
                        "measure images of sarsim focus; the image viewer measures points of any image");
  MeasuredImage opened{std::move(source->header), {}, {}, {}};
  opened.reader = [raster = file.raster, backwards = source->backwards](std::size_t row, std::size_t first,
                                                                        std::span<std::complex<float>> out) {
    const std::size_t column = backwards ? raster->columns() - 1 - row : row;
    raster->read_window({first, out.size(), column, 1, 1, 1}, out);
  };
  read_header(opened.header, path, opened.image, opened.origin);
  return opened;
}

MeasuredImage opened_image(const std::string& path) {
  if (!fs::exists(path))
    throw core::Refused(fmt::format("there is no file '{}'", path), "name an image of sarsim focus");
  if (is_sicd(path)) return opened_sicd(path);
  auto [file, problems] = raster::EnviImage::open(path);
  if (!file) throw core::Refused(std::move(problems));
  if (file->header().pixel != raster::EnviHeader::Pixel::complex_float)
    throw core::Refused(fmt::format("'{}' holds magnitudes", path), "measure the complex image beside it");
  MeasuredImage opened{file->header(),
                       [file = *file](std::size_t row, std::size_t first, std::span<std::complex<float>> out) {
                         file.read(row, first, out);
                       },
                       {},
                       {}};
  read_header(opened.header, raster::envi_header_of(path).string(), opened.image, opened.origin);
  return opened;
}

// What was focused, as the header says, unless the request says otherwise.
RecordingArguments input_of(const MeasureRequest& request, const WayBack& way, const ImageOrigin& origin) {
  RecordingArguments input = request.input;
  if (request.kept) input = *request.kept->input;
  if (!input.simulation) input.simulation = static_cast<std::int64_t>(origin.simulation) + 1;
  if (request.kept) return input;
  input.path = way.source;
  input.script = way.script;
  input.overrides = overrides_from_words(origin.settings);
  return input;
}

void expect_folder(const fs::path& pictures) {
  if (!pictures.empty() && fs::exists(pictures) && !fs::is_directory(pictures))
    throw core::Refused(fmt::format("--cuts: '{}' is not a folder", pictures.string()),
                        "name a folder; it is made when missing");
}

// Half the distance to the nearest other target, at most three cells: the peak found shall be that of the target.
double search_of(const std::vector<TargetTheory>& theories, const TargetTheory& theory) {
  const double cell_m = std::max(theory.azimuth ? theory.azimuth->null : 1.0, theory.range ? theory.range->null : 1.0);
  double search_m = 3.0 * cell_m;
  for (const TargetTheory& other : theories) {
    if (other.target == theory.target || !(other.amplitude > 0.0)) continue;
    const double distance_m =
        std::hypot(other.place.azimuth_m - theory.place.azimuth_m, other.place.range_m - theory.place.range_m);
    search_m = std::min(search_m, std::max(0.5 * distance_m, 0.5 * cell_m));
  }
  return search_m;
}

std::vector<TargetTheory> theories_of(const MeasuredImage& opened, const FocusInput& input,
                                      const core::WorkControl& control) {
  const bool time_domain = opened.origin.algorithm == "back-projection";
  return theory_on_image(
      {*input.plan, input.echoes, opened.origin.options, time_domain, opened.origin.motion != "none"},
      opened.image.frame, control);
}

// Points that are too many to be measured one by one.
std::optional<core::Problem> note_of_clouds(const simulate::ResolvedScene& scene, std::size_t listed) {
  const std::size_t points = scene.scatterers.size() - listed;
  if (points == 0) return std::nullopt;
  if (listed == 0)
    throw core::Refused(fmt::format("the {} points of the clouds are too many to be measured one by one", points),
                        fmt::format("the limit is {} cloud points; add a target where an image is to be measured",
                                    most_examined_targets));
  return core::problem_of(core::Severity::note,
                          fmt::format("the {} points of the clouds are not measured one by one", points), {},
                          fmt::format("at most {} of them", most_examined_targets), {});
}

bool is_asked_for(const MeasureRequest& request, const TargetTheory& theory) {
  return !request.target || theory.target + 1 == *request.target;
}

fs::path picture_of(const MeasureRequest& request, const TargetTheory& theory) {
  if (request.pictures.empty()) return {};
  return request.pictures / fmt::format("target-{}.png", theory.target + 1);
}

// Before anything is measured.
void expect_free_pictures(const MeasureRequest& request, const std::vector<TargetTheory>& theories,
                          std::vector<fs::path> sources) {
  if (request.pictures.empty()) return;
  sources.push_back(request.image);
  std::vector<fs::path> pictures;
  for (const TargetTheory& theory : theories)
    if (is_asked_for(request, theory)) pictures.push_back(picture_of(request, theory));
  expect_free_outputs(pictures, {InputList::named(std::move(sources)), request.force, "--cuts", request.pictures});
}

// Of a peak, carried from where it was found to a place near it.
double phase_at(const signal::FocusedImage& image, const signal::PointResponse& found,
                const signal::ImagePlace& place) {
  const double turns = image.azimuth.spectrum_centre_per_m * (place.azimuth_m - found.place.azimuth_m) +
                       image.range.spectrum_centre_per_m * (place.range_m - found.place.range_m);
  return std::remainder(found.phase_rad + 2.0 * core::pi * turns, 2.0 * core::pi);
}

bool is_within(const signal::ImageAxis& axis, double place) {
  const auto [low, high] = std::minmax({axis.at(0.0), axis.at(static_cast<double>(axis.count) - 1.0)});
  return place >= low && place <= high;
}

bool is_within(const signal::FocusedImage& image, const signal::ImagePlace& place) {
  return is_within(image.azimuth, place.azimuth_m) && is_within(image.range, place.range_m);
}

// The peak near the target's place, unless noise alone may make one as large.
void measure_target(const MeasuredImage& opened, const signal::ImageReader& reader, const MeasureRequest& request,
                    bool cuts, MeasuredTarget& target) {
  constexpr double noise_cells = 32.0;
  const TargetTheory& theory = target.theory;
  const auto null_m = [](const auto& figures) { return figures ? figures->null : 1.0; };
  // 0.886 over the bandwidth is the width of an even spectrum, and by little that of a window's noise.
  const auto cells = [&](const auto& figures) {
    return 2.0 * target.search_m / (figures ? figures->width / 0.886 : 1.0);
  };
  target.noise_v = std::sqrt(signal::noise_power_near(
      opened.image, reader, theory.place, noise_cells * null_m(theory.azimuth), noise_cells * null_m(theory.range)));
  target.threshold = signal::peak_threshold(request.false_alarm, cells(theory.azimuth), cells(theory.range));
  target.found =
      signal::measure_point(opened.image, reader, theory.place, target.search_m, cuts ? &target.cuts : nullptr);
  if (!target.found) return;
  target.peak_v = target.found->amplitude;
  // A response a little off its place is turned by the image's carrier on the way there, which its place says already.
  target.found->phase_rad = phase_at(opened.image, *target.found, theory.place);
  if (target.peak_v * target.peak_v > target.threshold * target.noise_v * target.noise_v) return;
  target.found.reset();
  target.cuts = {};
}

std::vector<MeasuredTarget> measured_targets(const MeasuredImage& opened, const std::vector<TargetTheory>& theories,
                                             const MeasureRequest& request, const core::WorkControl& control) {
  const bool cuts = request.cuts || !request.pictures.empty();
  std::vector<MeasuredTarget> targets(theories.size());
  core::parallel_ranges(theories.size(), 1, control, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      targets[t].theory = theories[t];
      targets[t].picture = picture_of(request, theories[t]);
      if (!(theories[t].amplitude > 0.0) || !is_asked_for(request, theories[t])) continue;
      targets[t].outside = !is_within(opened.image, theories[t].place);
      if (targets[t].outside) continue;
      targets[t].search_m = request.search_m.value_or(search_of(theories, theories[t]));
      measure_target(opened, opened.reader, request, cuts, targets[t]);
    }
  });
  std::erase_if(targets, [&](const MeasuredTarget& target) { return !is_asked_for(request, target.theory); });
  if (targets.empty())
    throw core::Refused(fmt::format("there is no target {}", request.target.value_or(0)),
                        fmt::format("the script has {}", theories.size()));
  return targets;
}

}  // namespace

MeasureReport measure(const MeasureRequest& request, const core::Observer& observer) {
  if (request.search_m && !(*request.search_m > 0.0)) throw core::Refused("--search must be above 0");
  if (!(request.false_alarm >= 1e-15 && request.false_alarm <= 0.1))
    throw core::Refused(fmt::format("--pfa is out of range; found {:g}, expected 1e-15 to 0.1", request.false_alarm));
  const core::WorkControl control = observer.control(core::thread_count(request.threads));
  MeasuredImage opened = request.kept ? kept_image_to_measure(request) : opened_image(request.image.string());
  expect_folder(request.pictures);
  WayBack way;
  if (!request.kept) way = way_back(opened.header, opened.origin, request.image, request.input.script);
  observer.remarks(way.problems);
  const FocusInput input = open_focus_input(input_of(request, way, opened.origin), control);
  opened.origin.earth = scene::earth_of(input.world);
  const std::vector<TargetTheory> theories = theories_of(opened, input, control);
  if (auto note = note_of_clouds(*input.plan->scene, theories.size())) {
    observer.remarks({*note});
    way.problems.push_back(*std::move(note));
  }
  expect_free_pictures(request, theories, named_sources(input_of(request, way, opened.origin)));
  core::Problems movers = remarks_on_movers(*input.plan, input.echoes, {}, control);
  observer.remarks(movers);
  std::ranges::move(movers, std::back_inserter(way.problems));
  return {opened.origin, measured_targets(opened, theories, request, control), request.false_alarm,
          std::move(way.problems), opened.image.frame};
}

}  // namespace sarsim::workflow
