#include "workflow/focus/measure.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <set>
#include <span>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "core/maths/constants.hpp"
#include "core/maths/decibels.hpp"
#include "core/report/invalid_request.hpp"
#include "core/task/parallel.hpp"
#include "raster/format/envi.hpp"
#include "raster/format/open_raster.hpp"
#include "scene/model/world_frame.hpp"
#include "signal/measure/noise_floor.hpp"
#include "signal/sar/sar_track.hpp"
#include "workflow/focus/azimuth_ambiguities.hpp"
#include "workflow/focus/edge_remark.hpp"
#include "workflow/focus/focus_input.hpp"
#include "workflow/focus/movers.hpp"
#include "workflow/focus/target_aspects.hpp"
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
  const InMemoryImage& kept = *request.kept;
  if (!kept.origin || !kept.input)
    throw core::InvalidRequest("the image was not made by focusing", "measure the image of a focused recording");
  MeasuredImage opened{kept.content.header, reader_of(kept.rows), {}, {}};
  read_header(opened.header, request.image.string(), opened.image, opened.origin);
  return opened;
}

// The columns of the file are the rows of the image.
MeasuredImage opened_sicd(const std::string& path) {
  raster::OpenedRaster file = raster::open_raster(raster::Integrity::whole, path);
  if (!file.raster) throw core::InvalidRequest(core::ranked(std::move(file.problems)));
  auto source = sicd_source(*file.raster);
  if (!source)
    throw core::InvalidRequest(fmt::format("'{}' names no script: another program wrote it", path),
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
    throw core::InvalidRequest(fmt::format("there is no file '{}'", path), "name an image of sarsim focus");
  if (is_sicd(path)) return opened_sicd(path);
  auto [file, problems] = raster::EnviImage::open(path);
  if (!file) throw core::InvalidRequest(std::move(problems));
  if (file->header().pixel != raster::EnviHeader::Pixel::complex_float)
    throw core::InvalidRequest(fmt::format("'{}' holds magnitudes", path), "measure the complex image beside it");
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
    throw core::InvalidRequest(fmt::format("--cuts: '{}' is not a folder", pictures.string()),
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

// The frame of an image of a phase history, in the world of the scene that its targets are from: another one where the
// scene has an anchor of its own.
void turn_to_world(const scene::World& world, MeasuredImage& opened) {
  const auto earth = scene::earth_of(world);
  if (!opened.origin.anchor || !earth || earth->anchor() == *opened.origin.anchor) return;
  const radar::EarthFrame of_image(*opened.origin.anchor);
  const auto turned = [&](const core::Vec3& v) {
    return earth->world_axes_from_ecef(of_image.ecef_axes_from_world(v));
  };
  signal::ImageFrame& frame = opened.image.frame;
  frame.origin_m = earth->world_from_ecef(of_image.ecef_from_world(frame.origin_m));
  frame.along = turned(frame.along);
  frame.across = turned(frame.across);
}

// Over a flat scene an image of a phase history lies as its anchor says.
std::optional<radar::EarthFrame> earth_under(const scene::World& world, const ImageOrigin& origin) {
  if (auto earth = scene::earth_of(world)) return earth;
  if (origin.anchor) return radar::EarthFrame(*origin.anchor);
  return std::nullopt;
}

// What the header repeats of the recording: phases, places and theory follow the one or the other.
core::Problems diagnose_header(const MeasuredImage& opened, const FocusInput& input, const fs::path& file) {
  constexpr double share = 1e-6;
  constexpr double min_cosine = 0.9;  // Navigation and curved tracks turn the line by less.
  core::Problems remarks;
  const auto remark = [&](const char* field, std::string found, std::string expected) {
    remarks.push_back(
        core::warning("measure.header-contradicts",
                      fmt::format("the header of '{}' contradicts what it was made from: {}", file.string(), field))
            .found(std::move(found))
            .expected(std::move(expected))
            .hint("the header was edited, or belongs to another image: focus again"));
  };
  const signal::SarWaveform& waveform = input.echoes.waveform;
  const auto differ = [](double a, double b) { return std::abs(a - b) > share * std::abs(b); };
  // Images of phase histories have the speed of light of their standard and the middle of the band that was kept.
  if (opened.origin.anchor) return remarks;
  // That of 1998 differs by 1.4e-7, which turns phases.
  constexpr double share_of_light = 1e-8;
  if (std::abs(opened.image.light_speed_mps / waveform.light_speed_mps - 1.0) > share_of_light)
    remark("light speed mps", fmt::format("{} m/s", opened.image.light_speed_mps),
           fmt::format("{} m/s", waveform.light_speed_mps));
  if (is_of_turning_target(opened.origin)) return remarks;
  if (differ(opened.image.carrier_hz, waveform.carrier_hz))
    remark("carrier hz", fmt::format("{} Hz", opened.image.carrier_hz), fmt::format("{} Hz", waveform.carrier_hz));
  if (opened.image.frame.plane != signal::ImagePlane::slant_range || input.echoes.track.size() < 2) return remarks;
  const core::Vec3 flown = signal::fit_straight(input.echoes.track).along;
  const core::Vec3& along = opened.image.frame.along;
  if (!(core::dot(flown, along) >= min_cosine))
    remark("along", fmt::format("({:.4g}, {:.4g}, {:.4g})", along.x, along.y, along.z),
           fmt::format("({:.4g}, {:.4g}, {:.4g}), as was flown", flown.x, flown.y, flown.z));
  return remarks;
}

std::vector<TargetTheory> theories_of(const MeasuredImage& opened, const FocusInput& input,
                                      const core::WorkControl& control) {
  const bool time_domain = opened.origin.algorithm == "back-projection";
  return theory_on_image(
      {*input.acquisition, input.echoes, opened.origin.options, time_domain, opened.origin.motion != "none"},
      opened.image, control);
}

// Points that are too many to be measured one by one.
std::optional<core::Problem> note_of_clouds(const simulate::ResolvedScene& scene, std::size_t listed) {
  const std::size_t points = scene.scatterers.size() - listed;
  if (points == 0) return std::nullopt;
  if (listed == 0)
    throw core::InvalidRequest(
        fmt::format("the {} cloud points are too many to be measured individually", points),
        fmt::format("the limit is {} cloud points; add a target where an image is to be measured",
                    max_examined_targets));
  return core::note("measure.clouds-left-out", fmt::format("the {} cloud points are not measured individually", points))
      .expected(fmt::format("at most {} of them", max_examined_targets));
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

// An image whose spectrum is centred as that of a target is; without its values.
signal::FocusedImage centred_for(const signal::FocusedImage& image, const TargetTheory& theory) {
  signal::FocusedImage centred{image.frame, image.azimuth, image.range, image.carrier_hz, image.light_speed_mps, {}};
  if (theory.centre) {
    centred.azimuth.spectrum_centre_per_m = theory.centre->azimuth_per_m;
    centred.range.spectrum_centre_per_m = theory.centre->range_per_m;
  }
  return centred;
}

// The peak near the target's place, unless noise alone may make one as large.
void measure_target(const MeasuredImage& opened, const signal::ImageReader& reader, const MeasureRequest& request,
                    bool cuts, MeasuredTarget& target) {
  constexpr double noise_cells = 32.0;
  const TargetTheory& theory = target.theory;
  const signal::FocusedImage image = centred_for(opened.image, theory);
  const auto null_m = [](const auto& figures) { return figures ? figures->null : 1.0; };
  // 0.886 over the bandwidth is the width of an even spectrum, and by little that of a window's noise.
  const auto cells = [&](const auto& figures) {
    return 2.0 * target.search_m / (figures ? figures->width / 0.886 : 1.0);
  };
  target.noise_v = std::sqrt(signal::noise_power_near(image, reader, theory.place, noise_cells * null_m(theory.azimuth),
                                                      noise_cells * null_m(theory.range)));
  target.threshold = signal::peak_threshold(request.false_alarm, cells(theory.azimuth), cells(theory.range));
  std::optional<signal::PointResponse> peak =
      signal::measure_point(image, reader, theory.place, target.search_m, cuts ? &target.cuts : nullptr);
  if (!peak) return;
  target.peak_v = peak->amplitude;
  const double noise_w = target.noise_v * target.noise_v;
  const double peak_w = target.peak_v * target.peak_v;
  target.false_alarm_probability =
      noise_w > 0.0 ? signal::peak_false_alarm(peak_w / noise_w, cells(theory.azimuth), cells(theory.range)) : 0.0;
  if (peak_w > target.threshold * noise_w) target.state = state_of(target, *peak, signal::response_axes(image));
  if (target.state == TargetState::not_found) {
    target.cuts = {};
    return;
  }
  // A response a little off its place is turned by the image's carrier on the way there, which its place says already.
  peak->phase_rad = phase_at(image, *peak, theory.place);
  (target.state == TargetState::found ? target.found : target.peak) = std::move(peak);
}

// Samples of an image that are no numbers, as far as they are read: a peak, noise and spectra about one mean nothing.
class MissingSamples {
 public:
  // A reader that takes note of them.
  signal::ImageReader watched(const signal::ImageReader& reader) {
    return [this, reader](std::size_t row, std::size_t first, std::span<std::complex<float>> out) {
      reader(row, first, out);
      for (std::size_t i = 0; i < out.size(); ++i)
        if (!std::isfinite(out[i].real()) || !std::isfinite(out[i].imag())) note(row, first + i);
    };
  }
  void expect_none(const fs::path& image) const {
    if (places_.empty()) return;
    const auto [row, column] = *places_.begin();
    throw core::InvalidRequest(
        {core::error(fmt::format("'{}' has samples near its targets that are not finite numbers", image.string()))
             .found(fmt::format("{}, the first in row {}, column {} (from 0)", places_.size(), row, column))
             .expected("finite samples")
             .hint("'sarsim info --statistics' counts all of them; focus the recording again")});
  }

 private:
  void note(std::size_t row, std::size_t column) {
    const std::scoped_lock hold(lock_);
    places_.emplace(row, column);
  }

  std::mutex lock_;
  std::set<std::pair<std::size_t, std::size_t>> places_;
};

std::vector<MeasuredTarget> measured_targets(const MeasuredImage& opened, const std::vector<TargetTheory>& theories,
                                             const MeasureRequest& request, const core::WorkControl& control) {
  const bool cuts = request.cuts || !request.pictures.empty();
  std::vector<MeasuredTarget> targets(theories.size());
  MissingSamples missing;
  const signal::ImageReader reader = missing.watched(opened.reader);
  core::parallel_ranges(theories.size(), 1, control, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      targets[t].theory = theories[t];
      targets[t].picture = picture_of(request, theories[t]);
      targets[t].outside =
          theories[t].unrecorded || (theories[t].amplitude > 0.0 && !is_within(opened.image, theories[t].place));
      if (targets[t].outside)
        targets[t].state = TargetState::outside;
      else if (!(theories[t].amplitude > 0.0))
        targets[t].state = TargetState::no_echoes;
      if (!(theories[t].amplitude > 0.0) || !is_asked_for(request, theories[t])) continue;
      if (targets[t].outside) continue;
      targets[t].search_m = request.search_m.value_or(search_of(theories, theories[t]));
      measure_target(opened, reader, request, cuts, targets[t]);
    }
  });
  missing.expect_none(request.image);
  std::erase_if(targets, [&](const MeasuredTarget& target) { return !is_asked_for(request, target.theory); });
  if (targets.empty())
    throw core::InvalidRequest(fmt::format("there is no target {}", request.target.value_or(0)),
                               fmt::format("the scene has {}", theories.size()));
  return targets;
}

// Between the samples of an image its values follow from those around, which at an edge are known on one side alone.
std::optional<core::Problem> remark_on_edges(const signal::FocusedImage& image,
                                             const std::vector<MeasuredTarget>& targets) {
  constexpr double reach = 1.5;  // -3 dB widths; farther away a peak is right within 0.1 dB
  const auto is_near = [](const signal::ImageAxis& axis, double place, double width) {
    const auto [low, high] = std::minmax({axis.at(0.0), axis.at(static_cast<double>(axis.count) - 1.0)});
    return place - low < reach * width || high - place < reach * width;
  };
  std::vector<std::size_t> near;
  for (const MeasuredTarget& target : targets) {
    const signal::PointResponse* const peak = target.response();
    if (peak != nullptr && (is_near(image.azimuth, peak->place.azimuth_m, peak->azimuth.width) ||
                            is_near(image.range, peak->place.range_m, peak->range.width)))
      near.push_back(target.theory.target);
  }
  if (near.empty()) return std::nullopt;
  return core::warning(
             "measure.targets-at-edge",
             fmt::format("{} of {} targets ({}) lie within 1.5 widths of the edge of the image, which truncates their "
                         "responses: amplitude errors may reach 1 dB, position errors an eighth of a width",
                         near.size(), targets.size(), target_list(near)))
      .hint("record or focus a wider part");
}

}  // namespace

TargetState state_of(const MeasuredTarget& target, const signal::PointResponse& peak,
                     const signal::ResponseAxes& axes) {
  constexpr double max_db = 3.0;
  constexpr double hopeless_db = -20.0;
  constexpr double deviations = 3.0;
  const TargetTheory& theory = target.theory;
  const double noise_w = target.noise_v * target.noise_v;
  // One standard deviation of the place of a response of bandwidth B is sqrt(12)/(2 pi B sqrt(2 S)), S its ratio of
  // powers, where 0.886/B is its width; that of its amplitude, in parts, 1/sqrt(2 S).
  const double of_peak = std::sqrt(0.5 * noise_w) / peak.amplitude;
  const double of_theory = std::sqrt(0.5 * noise_w) / theory.amplitude;
  const double azimuth_m = peak.place.azimuth_m - theory.place.azimuth_m;
  const double range_m = peak.place.range_m - theory.place.range_m;
  const auto is_at = [&](const signal::ImagePlace& axis, const std::optional<signal::ResponseFigures>& figures,
                         const signal::ResponseFigures& measured) {
    const double width_m = figures ? figures->width : measured.width;
    const double deviation_m = std::sqrt(12.0) / (2.0 * core::pi * signal::even_response_width) * width_m * of_peak;
    return std::abs(azimuth_m * axis.azimuth_m + range_m * axis.range_m) <=
           std::max(0.5 * width_m, deviations * deviation_m);
  };
  const double part = peak.amplitude / theory.amplitude;
  if (!is_at(axes.azimuth, theory.azimuth, peak.azimuth) || !is_at(axes.range, theory.range, peak.range))
    return core::amplitude_db(part) > hopeless_db ? TargetState::displaced : TargetState::not_found;
  if (core::amplitude_db(part) < -max_db && part < 1.0 - deviations * of_theory) return TargetState::weak;
  if (core::amplitude_db(part) > max_db && part > 1.0 + deviations * of_theory) return TargetState::strong;
  return TargetState::found;
}

MeasureReport measure(const MeasureRequest& request, const core::Observer& observer) {
  if (request.search_m && !(*request.search_m > 0.0)) throw core::InvalidRequest("--search must be above 0");
  if (!(request.false_alarm >= 1e-15 && request.false_alarm <= 0.1))
    throw core::InvalidRequest(
        fmt::format("--pfa is out of range; found {:g}, expected 1e-15 to 0.1", request.false_alarm));
  const core::WorkControl control = observer.control(core::thread_count(request.threads));
  MeasuredImage opened = request.kept ? kept_image_to_measure(request) : opened_image(request.image.string());
  expect_folder(request.pictures);
  WayBack way;
  if (!request.kept) way = way_back(opened.header, opened.origin, request.image, request.input.script, observer.stop);
  observer.remarks(way.problems);
  const FocusInput input = open_focus_input(input_of(request, way, opened.origin), control);
  observer.remarks(input.of_files);
  core::append(way.problems, input.of_files);
  opened.origin.earth = earth_under(input.world, opened.origin);
  turn_to_world(input.world, opened);
  core::Problems of_header = diagnose_header(opened, input, request.image);
  observer.remarks(of_header);
  core::append(way.problems, std::move(of_header));
  const std::vector<TargetTheory> theories = theories_of(opened, input, control);
  if (auto note = note_of_clouds(*input.acquisition->scene, theories.size())) {
    observer.remarks({*note});
    way.problems.push_back(*std::move(note));
  }
  expect_free_pictures(request, theories, named_sources(input_of(request, way, opened.origin)));
  core::Problems of_echoes = diagnose_movers(*input.acquisition, input.echoes, {}, control);
  core::append(of_echoes, diagnose_edges(*input.acquisition));
  observer.remarks(of_echoes);
  core::append(way.problems, std::move(of_echoes));
  std::vector<MeasuredTarget> targets = measured_targets(opened, theories, request, control);
  if (auto edges = remark_on_edges(opened.image, targets)) {
    observer.remarks({*edges});
    way.problems.push_back(*std::move(edges));
  }
  return {opened.origin,           way.script.empty() ? way.source : way.script,
          std::move(targets),      request.false_alarm,
          std::move(way.problems), opened.image.frame};
}

}  // namespace sarsim::workflow
