#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "cli/command/plot_arguments.hpp"
#include "cli/command/plot_samples.hpp"
#include "cli/shell/watch.hpp"
#include "picture/image/image_figure.hpp"
#include "picture/image/image_samples.hpp"
#include "raster/format/open_raster.hpp"
#include "workflow/image/image_fields.hpp"
#include "workflow/image/placed_image.hpp"

namespace sarsim::cli {

namespace {

// Rows or columns whose places are between two limits.
simulate::IndexSpan between(const std::vector<double>& places, std::vector<double> limits, const char* option) {
  if (limits.empty()) return {0, places.size()};
  std::ranges::sort(limits);
  const auto inside = [&](double place) { return place >= limits[0] && place <= limits[1]; };
  const auto first = std::ranges::find_if(places, inside);
  if (first == places.end())
    throw core::InvalidRequest(fmt::format("{}: the file has nothing between {} and {}", option, limits[0], limits[1]),
                               fmt::format("it has {:.6g} to {:.6g}", places.front(), places.back()));
  const auto last = std::find_if_not(first, places.end(), inside);
  return {static_cast<std::size_t>(first - places.begin()), static_cast<std::size_t>(last - places.begin())};
}

std::vector<double> numbers(std::size_t count) { return raster::ImagePlaces{}.list(count); }

// The places of all rows and columns, with their names.
void name_places(const PlotArguments& a, const workflow::PlacedImage& input, picture::SampleSource& samples) {
  const std::size_t rows = input.source->rows();
  const std::size_t columns = input.source->columns();
  const bool of_times =
      a.kind == PlotKind::range_doppler || a.kind == PlotKind::doppler_time || a.kind == PlotKind::phase;
  samples.timed = input.axes && (!of_times || input.has_times());
  if (input.focused) {
    samples.row_place = input.focused->azimuth.list(rows);
    samples.column_place = input.focused->range.list(columns);
    samples.look.rows = {input.focused->azimuth.label, input.focused->azimuth.unit};
    samples.look.columns = {input.focused->range.label, input.focused->range.unit};
  } else if (input.axes) {
    samples.row_place.assign(input.axes->row_time_s.begin(),
                             input.axes->row_time_s.begin() + static_cast<std::ptrdiff_t>(rows));
    samples.column_place = input.axes->column_range_m;
    const bool cut = a.kind == PlotKind::pulse || a.kind == PlotKind::range;
    if (cut && !input.has_times()) {
      samples.row_place = numbers(rows);
      samples.look.rows = {"Row", ""};
    }
  } else {
    samples.row_place = numbers(rows);
    samples.column_place = numbers(columns);
    samples.look.rows = {"Pulse", ""};
    samples.look.columns = {"Sample", ""};
  }
}

void expect_places(const PlotArguments& a, const workflow::PlacedImage& input) {
  if (!input.focused && (!a.azimuth_m.empty() || a.at_azimuth_m))
    throw core::InvalidRequest("--azimuth and --at-azimuth are for focused images",
                               a.input + " has no header of one; choose pulses with --time");
  if (input.focused && (!a.time_s.empty() || a.at_s))
    throw core::InvalidRequest("a focused image has no times",
                               "choose along the track with --azimuth and --at-azimuth, in m");
  const bool placed = input.focused || input.axes;
  if (!placed && (!a.range_m.empty() || !a.time_s.empty()))
    throw core::InvalidRequest("the file has no range and time axes", "name the script that wrote it with --script");
  if (input.axes && !input.has_times() && (!a.time_s.empty() || a.at_s))
    throw core::InvalidRequest("the rows of the file have no times", "leave out --time and --at-time");
}

// The samples of a file, cut to what --range, --time and --azimuth leave.
picture::ImageSamples chosen_part(const PlotArguments& a, const workflow::PlacedImage& input,
                                  const core::StopFlag* stop) {
  expect_places(a, input);
  picture::ImageSamples part;
  picture::SampleSource& samples = part.samples;
  name_places(a, input, samples);
  part.rows = input.focused ? between(samples.row_place, a.azimuth_m, "--azimuth")
                            : between(samples.row_place, a.time_s, "--time");
  part.columns = between(samples.column_place, a.range_m, "--range");
  part.source = input.source;
  part.focused = input.focused;
  if (input.axes) part.row_carrier_hz = input.axes->row_carrier_hz;
  part.sample_rate_hz = input.sample_rate_hz;
  picture::begin_reading(part, stop);
  return part;
}

Plotted picture_of(const PlotArguments& a, const workflow::PlacedImage& input, const picture::ImageSamples& part,
                   Streams& streams) {
  if (!a.csv.empty())
    throw core::InvalidRequest("the picture of a file has no table", "sarsim convert gives its values as CSV");
  picture::EchoWindow look;
  take_look(a, picture::DisplayQuantity::magnitude, look);
  picture::ImageLook wanted;
  wanted.first_row = part.rows.begin;
  wanted.rows = part.rows.end - part.rows.begin;
  wanted.first_column = part.columns.begin;
  wanted.columns = part.columns.end - part.columns.begin;
  wanted.quantity = look.quantity;
  wanted.map = look.map;
  wanted.inverted = look.inverted;
  wanted.limits = look.limits;
  wanted.decibels = look.decibels;
  wanted.draw_as = look.draw_as;
  wanted.pixel_rule = look.pixel_rule;
  if (input.focused) {
    wanted.pixel_rule = picture::PixelRule::peak;  // Points may be one sample wide.
    wanted.unit = "V";
    wanted.row_places = input.focused->azimuth;
    wanted.column_places = input.focused->range;
  } else if (input.axes && !input.source->axes()) {
    if (const auto places = workflow::drawn_places(*input.axes)) {
      wanted.row_places = places->azimuth;
      wanted.column_places = places->range;
    }
  }
  core::Problems remarks;
  Plotted plotted{picture::image_figure(*input.source, wanted, plot_pixels(a), {0, streams.stop}, &remarks), {}};
  print_problems(streams, remarks);
  return plotted;
}

// Where nobody names the row or column of an image.
void cut_where_it_is_strongest(PlotArguments& a, const picture::SampleSource& samples) {
  if (a.kind == PlotKind::pulse && !a.at_azimuth_m) a.at_azimuth_m = samples.row_place.at(strongest_row(samples));
  if (a.kind == PlotKind::range && !a.at_m)
    a.at_m = samples.column_place.at(strongest_column(samples, {0, samples.row_place.size()}));
}

}  // namespace

Plotted plot_file(const PlotArguments& arguments, Streams& streams) {
  PlotArguments a = arguments;
  if (a.kind != PlotKind::picture && !is_of_samples(a.kind))
    throw core::InvalidRequest("antennas, pulses and functions are drawn from scripts",
                               "give the scene, a .scr or .toml file");
  Watch watch(streams, false);
  const workflow::PlacedImage input = workflow::open_placed_image({a.input, a.samples, a.simulation}, watch.observer());
  picture::ImageSamples part = chosen_part(a, input, streams.stop);
  if (a.kind == PlotKind::picture) return picture_of(a, input, part, streams);
  const bool cut = a.kind == PlotKind::pulse || a.kind == PlotKind::range;
  const bool complex = input.source->info().value == raster::ImageValue::complex;
  if (input.focused && !part.samples.row_place.empty()) cut_where_it_is_strongest(a, part.samples);
  if (input.focused && cut && complex && !a.recorded) {
    picture::make_finer(part, a.kind == PlotKind::pulse, streams.stop);
    // So many rows, with what lies between them.
    if (a.pulses) a.pulses = (*a.pulses - 1) * static_cast<std::int64_t>(picture::upsampled_by) + 1;
  }
  if (a.at_azimuth_m) a.at_s = a.at_azimuth_m;
  return plot_samples(a, part.samples);
}

}  // namespace sarsim::cli
