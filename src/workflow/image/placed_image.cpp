#include "workflow/image/placed_image.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "core/report/invalid_request.hpp"
#include "core/text/number_text.hpp"
#include "core/text/separated.hpp"
#include "raster/format/custom_raw.hpp"
#include "raster/format/envi.hpp"
#include "simulate/plan/acquisition.hpp"
#include "workflow/image/image_fields.hpp"

namespace sarsim::workflow {

namespace fs = std::filesystem;

namespace {

// The header that says how a focused image is laid out, or nothing where there is none.
std::optional<raster::EnviHeader> focused_header(const std::string& path) {
  const std::string ending = fs::path(path).extension().string();
  if ((ending != ".img" && ending != ".npy") || !raster::has_envi_header(path)) return std::nullopt;
  auto [image, problems] = raster::EnviImage::open(path);
  if (!image) throw core::InvalidRequest(std::move(problems));
  return image->header();
}

// Where the header says the places of an axis, or the numbers of its rows or columns.
raster::ImagePlaces places_said(const raster::EnviHeader& header, const raster::ImagePlaces& wanted,
                                const std::string& key, const std::string& otherwise) {
  const auto first = core::parse_number(header.field(key + " first " + wanted.unit).value_or(""));
  const auto step = core::parse_number(header.field(key + " step " + wanted.unit).value_or(""));
  if (!first || !step || *step == 0.0) return {otherwise, ""};
  return {wanted.label, wanted.unit, *first, *step};
}

// The places that a header lists one by one, where they are evenly spaced to a tenth of a step.
std::optional<raster::ImagePlaces> even_places(const raster::EnviHeader& header, const std::string& key,
                                               const char* label, const char* unit) {
  const auto listed = core::numbers_of_list(header.field(key).value_or(""));
  if (!listed) return std::nullopt;
  const std::vector<double>& places = *listed;
  if (places.size() < 2 || places.size() != header.lines) return std::nullopt;
  const double step = (places.back() - places.front()) / static_cast<double>(places.size() - 1);
  for (std::size_t i = 0; i < places.size(); ++i)
    if (!(std::abs(places[i] - places.front() - step * static_cast<double>(i)) <= 0.1 * std::abs(step)))
      return std::nullopt;
  if (step == 0.0) return std::nullopt;
  return raster::ImagePlaces{label, unit, places.front(), step};
}

// From where the target was seen, or when; burst after burst where neither grows evenly.
raster::ImagePlaces places_of_profiles(const raster::EnviHeader& header) {
  if (const auto aspect = even_places(header, "aspect deg", "Aspect", "deg")) return *aspect;
  if (const auto time = even_places(header, "time s", "Time", "s")) return *time;
  return {"Profile", "", 1.0};
}

// Search pictures, range-Doppler maps and range profiles.
raster::FocusedPlaces places_of_product(const raster::EnviHeader& header) {
  if (header.field("map") == "ppi")
    return {places_said(header, {"North", "m"}, "y", "Row"), places_said(header, {"East", "m"}, "x", "Column")};
  const raster::ImagePlaces range = places_said(header, {"Slant range", "m"}, "range", "Column");
  if (!header.field("map")) return {places_of_profiles(header), range};
  if (header.field("intervals") != "1") return {{"Row of all maps", "", 1.0}, range};
  raster::ImagePlaces doppler = places_said(header, {"Doppler frequency", "hz"}, "doppler", "Row");
  if (doppler.unit == "hz") doppler.unit = "Hz";
  return {doppler, range};
}

raster::RasterAxes axes_of(const simulate::Acquisition& acquisition) {
  raster::RasterAxes axes;
  for (std::size_t r = 0; r < acquisition.timing.rows; ++r) {
    const std::int64_t pulse = acquisition.timing.first_pulse_of_row(r);
    axes.row_time_s.push_back(acquisition.link.repetition.send_time_s(pulse));
    axes.row_carrier_hz.push_back(acquisition.link.carrier.carrier_hz(pulse));
  }
  axes.column_range_m = acquisition.reception.column_range_m;
  return axes;
}

void expect_no_hints(const PlacedImageRequest& request) {
  const SampleArguments& samples = request.samples;
  if (samples.format || samples.columns || samples.bits || samples.lsb_v || !samples.script.empty() ||
      !samples.dataset.empty())
    throw core::InvalidRequest(fmt::format("'{}' has a header, which says all about its samples", request.path),
                               "leave out --from, --columns, --bits, --lsb, --dataset and --script");
}

}  // namespace

raster::FocusedPlaces places_of(const raster::EnviHeader& header, const std::string& file) {
  if (!header.field("image plane")) return places_of_product(header);
  signal::FocusedImage image;
  ImageOrigin origin;
  read_header(header, file, image, origin);
  const bool turning = is_of_turning_target(origin);
  const char* along = turning ? "Cross-range" : "Azimuth";
  const char* range = turning                                                ? "Along the line of sight"
                      : image.frame.plane == signal::ImagePlane::slant_range ? "Slant range"
                                                                             : "Ground range";
  return {{along, "m", image.azimuth.first_m, image.azimuth.step_m},
          {range, "m", image.range.first_m, image.range.step_m},
          image.azimuth.spectrum_centre_per_m,
          image.range.spectrum_centre_per_m};
}

std::optional<raster::FocusedPlaces> drawn_places(const raster::RasterAxes& axes) {
  const auto even = [](const char* label, const char* unit,
                       const std::vector<double>& places) -> std::optional<raster::ImagePlaces> {
    if (places.empty() || !std::isfinite(places.front()) || !std::isfinite(places.back())) return std::nullopt;
    const double step =
        places.size() < 2 ? 1.0 : (places.back() - places.front()) / static_cast<double>(places.size() - 1);
    return raster::ImagePlaces{label, unit, places.front(), step};
  };
  const auto times = even("Azimuth time", "s", axes.row_time_s);
  const auto ranges = even("Slant range", "m", axes.column_range_m);
  if (!times && !ranges) return std::nullopt;
  raster::FocusedPlaces places;
  places.azimuth = times.value_or(raster::ImagePlaces{"Row", ""});
  places.range = ranges.value_or(raster::ImagePlaces{"Sample", ""});
  return places;
}

std::string algorithm_said(const fs::path& path) {
  const auto header = focused_header(path.string());
  return header ? header->field("algorithm").value_or("") : "";
}

std::optional<raster::FocusedPlaces> drawn_places(const fs::path& path, const raster::Raster& source) {
  if (const auto header = focused_header(path.string()))
    return places_of(*header, raster::envi_header_of(path.string()).string());
  if (source.info().places) return source.info().places;
  const auto axes = source.axes();
  return axes ? drawn_places(*axes) : std::nullopt;
}

PlacedImage open_placed_image(const PlacedImageRequest& request, const core::Observer& observer) {
  PlacedImage input;
  const auto header = focused_header(request.path);
  raster::RasterHints hints;
  if (header) {
    expect_no_hints(request);
    hints.raw = raster::layout_of(*header);
    input.header = header;
    input.focused = places_of(*header, raster::envi_header_of(request.path).string());
  } else {
    hints = hints_for(request.path, request.samples, request.simulation, observer);
  }
  raster::OpenedRaster opened = raster::open_raster(raster::Integrity::partial, request.path, hints, observer.stop);
  if (!opened.raster) throw core::InvalidRequest(core::ranked(std::move(opened.problems)));
  observer.remarks(core::ranked(std::move(opened.problems)));
  opened.raster->wait_until_indexed(observer.stop);
  // A picture of a part of the rows would be taken for one of all.
  core::Problems found = opened.raster->problems();
  if (core::has_errors(found)) throw core::InvalidRequest(core::ranked(std::move(found)));
  observer.remarks(core::ranked(std::move(found)));
  if (opened.raster->rows() == 0 || opened.raster->columns() == 0)
    throw core::InvalidRequest(request.path + " holds no samples");
  input.source = std::move(opened.raster);
  if (header) return input;
  input.focused = input.source->info().places;
  if (input.focused) return input;
  input.axes = input.source->axes();
  input.sample_rate_hz = input.source->info().sample_rate_hz.value_or(0.0);
  if (!input.axes && !request.samples.script.empty()) {
    const simulate::Acquisition acquisition =
        acquisition_of_file(request.path, request.samples.script, request.simulation, observer.stop);
    input.axes = axes_of(acquisition);
    input.sample_rate_hz = 1.0 / acquisition.reception.raw_grid.interval_s;
  }
  const bool fits = input.axes && input.axes->row_time_s.size() >= input.source->rows() &&
                    input.axes->column_range_m.size() == input.source->columns();
  if (!fits) input.axes.reset();
  return input;
}

}  // namespace sarsim::workflow
