#include <algorithm>
#include <cmath>
#include <filesystem>
#include <tuple>

#include <fmt/format.h>

#include "cli/command/plot_arguments.hpp"
#include "cli/command/plot_samples.hpp"
#include "core/maths/constants.hpp"
#include "core/maths/finer.hpp"
#include "core/text/number_text.hpp"
#include "picture/image/envi_layout.hpp"
#include "picture/image/image_figure.hpp"
#include "raster/format/open_raster.hpp"
#include "workflow/image/image_fields.hpp"

namespace sarsim::cli {

namespace fs = std::filesystem;

namespace {

// An image that a command of ours made: rows along the track, bursts, northings ... instead of pulses.
struct FocusedPlaces {
  picture::ImagePlaces azimuth;
  picture::ImagePlaces range;
  double azimuth_centre_per_m = 0.0;  // middles of the image's spectrum
  double range_centre_per_m = 0.0;
};

// What a file is, and where its samples are.
struct Input {
  std::shared_ptr<raster::Raster> source;
  std::optional<FocusedPlaces> focused;
  std::optional<raster::RasterAxes> axes;  // times, carriers and ranges; of the file or of its script
  double sample_rate_hz = 0.0;
};

// The header that says how a focused image is laid out, or nothing where there is none.
std::optional<raster::EnviHeader> focused_header(const std::string& path) {
  const std::string ending = fs::path(path).extension().string();
  if ((ending != ".img" && ending != ".npy") || !raster::has_envi_header(path)) return std::nullopt;
  auto [image, problems] = raster::EnviImage::open(path);
  if (!image) throw core::Refused(std::move(problems));
  return image->header();
}

// Where the header says the places of an axis, or the numbers of its rows or columns.
picture::ImagePlaces places_said(const raster::EnviHeader& header, const picture::ImagePlaces& wanted,
                                 const std::string& key, const std::string& otherwise) {
  const auto first = core::parse_number(header.field(key + " first " + wanted.unit).value_or(""));
  const auto step = core::parse_number(header.field(key + " step " + wanted.unit).value_or(""));
  if (!first || !step || *step == 0.0) return {otherwise, ""};
  return {wanted.label, wanted.unit, *first, *step};
}

// Search pictures, range-Doppler maps and range profiles.
FocusedPlaces places_of_product(const raster::EnviHeader& header) {
  if (header.field("map") == "ppi")
    return {places_said(header, {"North", "m"}, "y", "Row"), places_said(header, {"East", "m"}, "x", "Column")};
  const picture::ImagePlaces range = places_said(header, {"Slant range", "m"}, "range", "Column");
  if (!header.field("map")) return {{"Profile", "", 1.0}, range};
  if (header.field("intervals") != "1") return {{"Row of all maps", "", 1.0}, range};
  picture::ImagePlaces doppler = places_said(header, {"Doppler frequency", "hz"}, "doppler", "Row");
  if (doppler.unit == "hz") doppler.unit = "Hz";
  return {doppler, range};
}

FocusedPlaces places_of(const raster::EnviHeader& header, const std::string& path) {
  if (!header.field("image plane")) return places_of_product(header);
  signal::FocusedImage image;
  workflow::ImageOrigin origin;
  workflow::read_header(header, raster::envi_header_of(path).string(), image, origin);
  const bool turning = workflow::is_of_turning_target(origin);
  const char* along = turning ? "Cross-range" : "Azimuth";
  const char* range = turning                                                ? "Along the line of sight"
                      : image.frame.plane == signal::ImagePlane::slant_range ? "Slant range"
                                                                             : "Ground range";
  return {{along, "m", image.azimuth.first_m, image.azimuth.step_m},
          {range, "m", image.range.first_m, image.range.step_m},
          image.azimuth.spectrum_centre_per_m,
          image.range.spectrum_centre_per_m};
}

raster::RasterAxes axes_of(const simulate::Plan& plan) {
  raster::RasterAxes axes;
  for (std::size_t r = 0; r < plan.rows; ++r) {
    const std::int64_t pulse = plan.first_pulse_of_row(r);
    axes.row_time_s.push_back(plan.radar.repetition.send_time_s(pulse));
    axes.row_carrier_hz.push_back(plan.radar.carrier.carrier_hz(pulse));
  }
  axes.column_range_m = plan.column_range_m;
  return axes;
}

void expect_no_hints(const PlotArguments& a) {
  const workflow::SampleArguments& samples = a.samples;
  if (samples.format || samples.columns || samples.bits || samples.lsb_v || !samples.script.empty())
    throw core::Refused(fmt::format("'{}' has a header, which says all about its samples", a.input),
                        "leave out --from, --columns, --bits, --lsb and --script");
}

Input opened(const PlotArguments& a, Streams& streams) {
  Input input;
  const auto header = focused_header(a.input);
  raster::RasterHints hints;
  if (header) {
    expect_no_hints(a);
    hints.raw = picture::layout_of(*header);
    input.focused = places_of(*header, a.input);
  } else {
    hints = workflow::hints_for(a.input, a.samples, a.simulation);
  }
  raster::OpenedRaster opened = raster::open_raster(raster::Integrity::partial, a.input, hints);
  if (!opened.raster) throw core::Refused(core::ranked(std::move(opened.problems)));
  print_problems(streams, core::ranked(std::move(opened.problems)));
  opened.raster->wait_until_indexed(streams.stop);
  // A picture of a part of the rows would be taken for one of all.
  core::Problems found = opened.raster->problems();
  if (core::has_errors(found)) throw core::Refused(core::ranked(std::move(found)));
  print_problems(streams, core::ranked(std::move(found)));
  if (opened.raster->rows() == 0 || opened.raster->columns() == 0) throw core::Refused(a.input + " holds no samples");
  input.source = std::move(opened.raster);
  if (header) return input;
  input.axes = input.source->axes();
  input.sample_rate_hz = input.source->info().sample_rate_hz.value_or(0.0);
  if (!input.axes && !a.samples.script.empty()) {
    const simulate::Plan plan = workflow::plan_of_file(a.input, a.samples.script, a.simulation);
    input.axes = axes_of(plan);
    input.sample_rate_hz = 1.0 / plan.raw_grid.interval_s;
  }
  const bool fits = input.axes && input.axes->row_time_s.size() >= input.source->rows() &&
                    input.axes->column_range_m.size() == input.source->columns();
  if (!fits) input.axes.reset();
  return input;
}

// ---- Which part -------------------------------------------------------------------------------------------------

// Rows or columns whose places are between two limits.
simulate::IndexSpan between(const std::vector<double>& places, std::vector<double> limits, const char* option) {
  if (limits.empty()) return {0, places.size()};
  std::ranges::sort(limits);
  const auto inside = [&](double place) { return place >= limits[0] && place <= limits[1]; };
  const auto first = std::ranges::find_if(places, inside);
  if (first == places.end())
    throw core::Refused(fmt::format("{}: the file has nothing between {} and {}", option, limits[0], limits[1]),
                        fmt::format("it has {:.6g} to {:.6g}", places.front(), places.back()));
  const auto last = std::find_if_not(first, places.end(), inside);
  return {static_cast<std::size_t>(first - places.begin()), static_cast<std::size_t>(last - places.begin())};
}

std::vector<double> even_places(const picture::ImagePlaces& places, std::size_t count) {
  std::vector<double> list;
  for (std::size_t i = 0; i < count; ++i) list.push_back(places.first + places.step * static_cast<double>(i));
  return list;
}

std::vector<double> numbers(std::size_t count) { return even_places({}, count); }

// Rows of pictures that are kept as HDF5 were sent at no time.
bool has_times(const Input& input) {
  return input.axes && std::ranges::all_of(input.axes->row_time_s, [](double time) { return std::isfinite(time); });
}

// The samples of a file, with the names of their places, cut to what --range, --time and --azimuth leave.
struct Part {
  simulate::IndexSpan rows;
  simulate::IndexSpan columns;
  PlotSamples samples;
};

void name_places(const PlotArguments& a, const Input& input, PlotSamples& samples) {
  const std::size_t rows = input.source->rows();
  const std::size_t columns = input.source->columns();
  const bool of_times = a.kind == PlotKind::range_doppler || a.kind == PlotKind::phase;
  samples.timed = input.axes && (!of_times || has_times(input));
  if (input.focused) {
    samples.row_place = even_places(input.focused->azimuth, rows);
    samples.column_place = even_places(input.focused->range, columns);
    samples.look.rows = {input.focused->azimuth.label, input.focused->azimuth.unit};
    samples.look.columns = {input.focused->range.label, input.focused->range.unit};
  } else if (input.axes) {
    samples.row_place.assign(input.axes->row_time_s.begin(),
                             input.axes->row_time_s.begin() + static_cast<std::ptrdiff_t>(rows));
    samples.column_place = input.axes->column_range_m;
    const bool cut = a.kind == PlotKind::pulse || a.kind == PlotKind::range;
    if (cut && !has_times(input)) {
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

void expect_places(const PlotArguments& a, const Input& input) {
  if (!input.focused && (!a.azimuth_m.empty() || a.at_azimuth_m))
    throw core::Refused("--azimuth and --at-azimuth are for focused images",
                        a.input + " has no header of one; choose pulses with --time");
  if (input.focused && (!a.time_s.empty() || a.at_s))
    throw core::Refused("a focused image has no times", "choose along the track with --azimuth and --at-azimuth, in m");
  const bool placed = input.focused || input.axes;
  if (!placed && (!a.range_m.empty() || !a.time_s.empty()))
    throw core::Refused("the file does not say its ranges and times", "name the script that wrote it with --script");
  if (input.axes && !has_times(input) && (!a.time_s.empty() || a.at_s))
    throw core::Refused("the rows of the file have no times", "leave out --time and --at-time");
}

std::vector<double> cut_out(const std::vector<double>& list, std::size_t begin, std::size_t end) {
  return {list.begin() + static_cast<std::ptrdiff_t>(begin), list.begin() + static_cast<std::ptrdiff_t>(end)};
}

// Reads rows and columns of a part; outlives what it is made from.
std::function<picture::EchoBlock(simulate::IndexSpan, simulate::IndexSpan)> reader_of(const Input& input,
                                                                                      const Part& part, double scale,
                                                                                      const core::StopFlag* stop) {
  return
      [input, part_rows = part.rows, part_columns = part.columns, row_place = part.samples.row_place,
       column_place = part.samples.column_place, scale, stop](simulate::IndexSpan rows, simulate::IndexSpan columns) {
        picture::EchoBlock block;
        block.rows = rows.end - rows.begin;
        block.columns = columns.end - columns.begin;
        block.time_s = cut_out(row_place, rows.begin, rows.end);
        block.range_m = cut_out(column_place, columns.begin, columns.end);
        const std::size_t first = part_rows.begin + rows.begin;
        if (input.axes) block.carrier_hz = cut_out(input.axes->row_carrier_hz, first, first + block.rows);
        block.sample_rate_hz = input.sample_rate_hz;
        block.light_speed_mps = core::exact_light_speed_mps;
        std::vector<std::complex<float>> read(block.rows * block.columns);
        const raster::ImageWindow window{first, block.rows, part_columns.begin + columns.begin, block.columns, 1, 1};
        input.source->read_window(window, read, {core::thread_count(0), stop});
        for (const std::complex<float>& sample : read) block.samples.push_back(scale * std::complex<double>(sample));
        return block;
      };
}

Part chosen_part(const PlotArguments& a, const Input& input, const core::StopFlag* stop) {
  expect_places(a, input);
  Part part;
  PlotSamples& samples = part.samples;
  name_places(a, input, samples);
  part.rows = input.focused ? between(samples.row_place, a.azimuth_m, "--azimuth")
                            : between(samples.row_place, a.time_s, "--time");
  part.columns = between(samples.column_place, a.range_m, "--range");
  samples.row_place = cut_out(samples.row_place, part.rows.begin, part.rows.end);
  samples.column_place = cut_out(samples.column_place, part.columns.begin, part.columns.end);
  const raster::RasterInfo& info = input.source->info();
  const double volts = info.counts ? info.lsb_v.value_or(0.0) : 1.0;
  if (!(volts > 0.0)) samples.look.unit = "counts";
  samples.read = reader_of(input, part, volts > 0.0 ? volts : 1.0, stop);
  return part;
}

// ---- Cuts through focused images --------------------------------------------------------------------------------

// An image has a sample or two for each width of a point: a cut shows what lies between them, too.
constexpr std::size_t finer_by = 16;

// One line of an image along which a cut goes, and the places of its finer samples.
struct FineLine {
  std::vector<double> place;
  std::vector<std::complex<double>> value;
};

FineLine fine_line(const Input& input, bool along_range, std::size_t number, const core::StopFlag* stop) {
  const picture::ImagePlaces& places = along_range ? input.focused->range : input.focused->azimuth;
  const double centre = along_range ? input.focused->range_centre_per_m : input.focused->azimuth_centre_per_m;
  const std::size_t count = along_range ? input.source->columns() : input.source->rows();
  std::vector<std::complex<float>> read(count);
  input.source->read_window(
      along_range ? raster::ImageWindow{number, 1, 0, count, 1, 1} : raster::ImageWindow{0, count, number, 1, 1, 1},
      read, {core::thread_count(0), stop});
  FineLine line;
  line.value = core::finer(std::vector<std::complex<double>>(read.begin(), read.end()), centre * places.step, finer_by);
  // Behind the last sample the line would lead back to the first.
  line.value.resize((count - 1) * finer_by + 1);
  for (std::size_t i = 0; i < line.value.size(); ++i)
    line.place.push_back(places.first + places.step * static_cast<double>(i) / static_cast<double>(finer_by));
  return line;
}

// Gives a cut the finer places of its line, inside the part.
void make_finer(const PlotArguments& a, const Input& input, Part& part, const core::StopFlag* stop) {
  const bool along_range = a.kind == PlotKind::pulse;
  PlotSamples& samples = part.samples;
  const std::size_t first_line = along_range ? part.rows.begin : part.columns.begin;
  auto& places = along_range ? samples.column_place : samples.row_place;
  const auto inside = [low = places.front(), high = places.back()](double place) {
    return place >= low && place <= high;
  };
  const FineLine all = fine_line(input, along_range, first_line, stop);
  const auto first = static_cast<std::size_t>(std::ranges::find_if(all.place, inside) - all.place.begin());
  std::vector<double> kept;
  std::ranges::copy_if(all.place, std::back_inserter(kept), inside);
  places = std::move(kept);
  samples.read = [input, along_range, first_line, first, rows_at = samples.row_place, columns_at = samples.column_place,
                  stop](simulate::IndexSpan rows, simulate::IndexSpan columns) {
    const std::size_t number = first_line + (along_range ? rows.begin : columns.begin);
    const simulate::IndexSpan span = along_range ? columns : rows;
    const FineLine line = fine_line(input, along_range, number, stop);
    picture::EchoBlock block;
    block.rows = rows.end - rows.begin;
    block.columns = columns.end - columns.begin;
    block.time_s = cut_out(rows_at, rows.begin, rows.end);
    block.range_m = cut_out(columns_at, columns.begin, columns.end);
    const auto begin = line.value.begin() + static_cast<std::ptrdiff_t>(first + span.begin);
    block.samples.assign(begin, begin + static_cast<std::ptrdiff_t>(span.end - span.begin));
    return block;
  };
}

Plotted picture(const PlotArguments& a, const Input& input, const Part& part, const core::StopFlag* stop) {
  if (!a.csv.empty())
    throw core::Refused("the picture of a file has no table", "sarsim convert gives its values as CSV");
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
    wanted.unit = "V";
    wanted.row_places = input.focused->azimuth;
    wanted.column_places = input.focused->range;
  } else if (input.axes && !input.source->axes()) {
    const auto even = [](const char* label, const char* unit, const std::vector<double>& places) {
      const double step =
          places.size() < 2 ? 1.0 : (places.back() - places.front()) / static_cast<double>(places.size() - 1);
      return picture::ImagePlaces{label, unit, places.front(), step};
    };
    wanted.row_places = even("Azimuth time", "s", input.axes->row_time_s);
    wanted.column_places = even("Slant range", "m", input.axes->column_range_m);
  }
  return {picture::image_figure(*input.source, wanted, plot_pixels(a), {0, stop}), {}};
}

}  // namespace

Plotted plot_file(const PlotArguments& arguments, Streams& streams) {
  PlotArguments a = arguments;
  if (a.kind != PlotKind::picture && !is_of_samples(a.kind))
    throw core::Refused("antennas, pulses and functions are drawn from scripts", "give the .scr file");
  const Input input = opened(a, streams);
  Part part = chosen_part(a, input, streams.stop);
  if (a.kind == PlotKind::picture) return picture(a, input, part, streams.stop);
  const bool cut = a.kind == PlotKind::pulse || a.kind == PlotKind::range;
  const bool complex = input.source->info().value == raster::ImageValue::complex;
  if (input.focused && cut && complex && !a.recorded) {
    make_finer(a, input, part, streams.stop);
    // So many rows, with what lies between them.
    if (a.pulses) a.pulses = (*a.pulses - 1) * static_cast<std::int64_t>(finer_by) + 1;
  }
  if (a.at_azimuth_m) a.at_s = a.at_azimuth_m;
  return plot_samples(a, part.samples);
}

}  // namespace sarsim::cli
