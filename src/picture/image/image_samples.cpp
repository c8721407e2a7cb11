#include "picture/image/image_samples.hpp"

#include <algorithm>
#include <iterator>
#include <span>
#include <utility>

#include "core/maths/constants.hpp"
#include "core/maths/upsample.hpp"
#include "core/report/invalid_request.hpp"
#include "raster/table/sample_gate.hpp"

namespace sarsim::picture {

namespace {

std::vector<double> cut_out(const std::vector<double>& list, std::size_t begin, std::size_t end) {
  return {list.begin() + static_cast<std::ptrdiff_t>(begin), list.begin() + static_cast<std::ptrdiff_t>(end)};
}

// Curves, means and transforms of a line would all be spoilt by one sample.
void expect_usable(const raster::Raster& source, std::span<const std::complex<double>> samples,
                   const raster::ImageWindow& window) {
  const auto bad = std::ranges::find_if_not(samples, raster::is_usable_sample);
  if (bad == samples.end()) return;
  const auto at = static_cast<std::size_t>(bad - samples.begin());
  throw core::InvalidRequest({raster::unusable_sample(source.info().path.string(), window.row(at / window.cols),
                                                      window.column(at % window.cols), *bad)});
}

// Reads rows and columns of a part; outlives what it is made from.
std::function<EchoBlock(simulate::IndexSpan, simulate::IndexSpan)> reader_of(const ImageSamples& part,
                                                                             const core::StopFlag* stop) {
  return [source = part.source, row_carrier_hz = part.row_carrier_hz, sample_rate_hz = part.sample_rate_hz,
          part_rows = part.rows, part_columns = part.columns, row_place = part.samples.row_place,
          column_place = part.samples.column_place, scale = part.scale,
          stop](simulate::IndexSpan rows, simulate::IndexSpan columns) {
    EchoBlock block;
    block.rows = rows.end - rows.begin;
    block.columns = columns.end - columns.begin;
    block.time_s = cut_out(row_place, rows.begin, rows.end);
    block.range_m = cut_out(column_place, columns.begin, columns.end);
    const std::size_t first = part_rows.begin + rows.begin;
    if (!row_carrier_hz.empty()) block.carrier_hz = cut_out(row_carrier_hz, first, first + block.rows);
    block.sample_rate_hz = sample_rate_hz;
    block.light_speed_mps = core::exact_light_speed_mps;
    std::vector<std::complex<float>> read(block.rows * block.columns);
    const raster::ImageWindow window{first, block.rows, part_columns.begin + columns.begin, block.columns, 1, 1};
    source->read_window(window, read, {core::thread_count(0), stop});
    for (const std::complex<float>& sample : read) block.samples.push_back(scale * std::complex<double>(sample));
    expect_usable(*source, block.samples, window);
    return block;
  };
}

// One line of an image along which a cut goes, and the places of its finer samples.
struct FineLine {
  std::vector<double> place;
  std::vector<std::complex<double>> value;
};

FineLine fine_line(const raster::Raster& source, const raster::FocusedPlaces& focused, bool along_range,
                   std::size_t number, const core::StopFlag* stop) {
  const raster::ImagePlaces& places = along_range ? focused.range : focused.azimuth;
  const double centre = along_range ? focused.range_centre_per_m : focused.azimuth_centre_per_m;
  const std::size_t count = along_range ? source.columns() : source.rows();
  std::vector<std::complex<float>> read(count);
  const raster::ImageWindow window =
      along_range ? raster::ImageWindow{number, 1, 0, count, 1, 1} : raster::ImageWindow{0, count, number, 1, 1, 1};
  source.read_window(window, read, {core::thread_count(0), stop});
  const std::vector<std::complex<double>> samples(read.begin(), read.end());
  expect_usable(source, samples, window);
  FineLine line;
  line.value = core::upsample(samples, centre * places.step, upsampled_by);
  // Behind the last sample the line would lead back to the first.
  line.value.resize((count - 1) * upsampled_by + 1);
  for (std::size_t i = 0; i < line.value.size(); ++i)
    line.place.push_back(places.first + places.step * static_cast<double>(i) / static_cast<double>(upsampled_by));
  return line;
}

}  // namespace

SampleSource samples_of(std::shared_ptr<const simulate::Plan> plan, const core::StopFlag* stop) {
  SampleSource samples;
  samples.column_place = plan->acquisition.reception.column_range_m;
  for (std::size_t r = 0; r < plan->acquisition.timing.rows; ++r)
    samples.row_place.push_back(
        plan->acquisition.link.repetition.send_time_s(plan->acquisition.timing.first_pulse_of_row(r)));
  samples.read = [plan = std::move(plan), stop](simulate::IndexSpan rows, simulate::IndexSpan columns) {
    return echo_block(*plan, rows, columns, {core::thread_count(0), stop});
  };
  return samples;
}

EchoBlock echo_block(const EchoMatrix& matrix) {
  EchoBlock block;
  block.rows = matrix.rows();
  block.columns = matrix.columns();
  for (std::size_t r = 0; r < block.rows; ++r) {
    block.time_s.push_back(matrix.time_s(r));
    block.samples.insert(block.samples.end(), matrix.row(r).begin(), matrix.row(r).end());
  }
  for (std::size_t c = 0; c < block.columns; ++c) block.range_m.push_back(matrix.range_m(c));
  return block;
}

void say_unit(Figure& figure, const std::string& unit) {
  if (unit == "V") return;
  for (FigurePanel& panel : figure.panels) {
    if (panel.y.unit == "V") panel.y.unit = unit;
    if (panel.y.unit == "W/Hz") panel.y.unit = unit + "^2/Hz";
    if (panel.y.label == "Level above 1 V") panel.y.label = "Level above 1 " + unit;
    if (panel.y.label == "Density above 1 W/Hz") panel.y.label = "Density above 1 " + unit + "^2/Hz";
  }
}

void begin_reading(ImageSamples& part, const core::StopFlag* stop) {
  SampleSource& samples = part.samples;
  samples.row_place = cut_out(samples.row_place, part.rows.begin, part.rows.end);
  samples.column_place = cut_out(samples.column_place, part.columns.begin, part.columns.end);
  const raster::RasterInfo& info = part.source->info();
  const double volts = info.counts ? info.lsb_v.value_or(0.0) : 1.0;
  if (!(volts > 0.0)) samples.look.unit = "counts";
  part.scale = volts > 0.0 ? volts : 1.0;
  samples.read = reader_of(part, stop);
}

void make_finer(ImageSamples& part, bool along_range, const core::StopFlag* stop) {
  SampleSource& samples = part.samples;
  const std::size_t first_line = along_range ? part.rows.begin : part.columns.begin;
  auto& places = along_range ? samples.column_place : samples.row_place;
  const auto inside = [low = places.front(), high = places.back()](double place) {
    return place >= low && place <= high;
  };
  const FineLine all = fine_line(*part.source, *part.focused, along_range, first_line, stop);
  const auto first = static_cast<std::size_t>(std::ranges::find_if(all.place, inside) - all.place.begin());
  std::vector<double> kept;
  std::ranges::copy_if(all.place, std::back_inserter(kept), inside);
  places = std::move(kept);
  samples.read = [source = part.source, focused = *part.focused, along_range, first_line, first,
                  rows_at = samples.row_place, columns_at = samples.column_place,
                  stop](simulate::IndexSpan rows, simulate::IndexSpan columns) {
    const std::size_t number = first_line + (along_range ? rows.begin : columns.begin);
    const simulate::IndexSpan span = along_range ? columns : rows;
    const FineLine line = fine_line(*source, focused, along_range, number, stop);
    EchoBlock block;
    block.rows = rows.end - rows.begin;
    block.columns = columns.end - columns.begin;
    block.time_s = cut_out(rows_at, rows.begin, rows.end);
    block.range_m = cut_out(columns_at, columns.begin, columns.end);
    const auto begin = line.value.begin() + static_cast<std::ptrdiff_t>(first + span.begin);
    block.samples.assign(begin, begin + static_cast<std::ptrdiff_t>(span.end - span.begin));
    return block;
  };
}

}  // namespace sarsim::picture
