#include "raster/format/image_export.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/report/invalid_request.hpp"
#include "radar/receiver/converter.hpp"
#include "raster/table/formats.hpp"
#include "raster/table/product_attributes.hpp"
#include "raster/table/raster_writer.hpp"

namespace sarsim::raster {

namespace {

constexpr std::size_t samples_at_once = std::size_t{1} << 18;

// Consecutive rows of a window, some MB at a time: use(first row of the window, samples).
template <class Use>
void for_each_block(const Raster& source, const ImageWindow& window, const core::WorkControl& control, const Use& use) {
  const std::size_t at_once = std::max<std::size_t>(1, samples_at_once / window.cols);
  std::vector<std::complex<float>> samples;
  for (std::size_t i = 0; i < window.rows; i += at_once) {
    if (control.stop != nullptr && control.stop->requested()) throw core::Interrupted();
    ImageWindow part = window;
    part.row0 = window.row(i);
    part.rows = std::min(at_once, window.rows - i);
    samples.resize(part.samples());
    source.read_window(part, samples, control);
    use(i, samples);
  }
}

double magnitude_of(const std::complex<double>& value) {
  const double magnitude = std::abs(value);
  return std::isfinite(magnitude) ? magnitude : 0.0;
}

double largest_magnitude(const Raster& source, const ImageWindow& window, const core::WorkControl& control) {
  double largest = 0.0;
  for_each_block(source, window, control, [&](std::size_t, const std::vector<std::complex<float>>& samples) {
    for (const auto& sample : samples) largest = std::max(largest, magnitude_of(std::complex<double>(sample)));
  });
  return largest;
}

// Picks what a window takes of an axis; `unknown` where the axis ends before.
template <class Value>
std::function<Value(std::size_t)> picked(std::vector<Value> axis, std::size_t first, std::size_t step, Value unknown) {
  return [axis = std::move(axis), first, step, unknown](std::size_t i) {
    const std::size_t at = first + i * step;
    return at < axis.size() ? axis[at] : unknown;
  };
}

Product product_of(const Raster& source, const ImageWindow& window, const ImageExport& options) {
  const RasterInfo& info = source.info();
  Product product;
  product.rows = window.rows;
  product.columns = window.cols;
  if (auto axes = source.axes()) {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    product.row_time_s = picked(std::move(axes->row_time_s), window.row0, window.row_step, unknown);
    product.row_carrier_hz = picked(std::move(axes->row_carrier_hz), window.row0, window.row_step, unknown);
    product.column_range_m = picked(std::move(axes->column_range_m), window.col0, window.col_step, unknown);
    product.image.columns = axes->column_axis;
    product.image.rows = axes->row_axis;
    if (!axes->row_m.empty())
      product.image.row_m = picked(std::move(axes->row_m), window.row0, window.row_step, unknown);
    constexpr std::array nowhere{unknown, unknown, unknown};
    if (!axes->row_pose.empty())
      product.row_pose =
          picked(std::move(axes->row_pose), window.row0, window.row_step, RowPose{nowhere, nowhere, nowhere});
  }
  product.sample_rate_hz = info.sample_rate_hz.value_or(0.0) / static_cast<double>(window.col_step);
  product.bits = options.bits > 0 ? options.bits : info.bits > 0 ? info.bits : 16;
  take_origin(info.attributes, product);
  product.engine = "selection of " + info.path.filename().string();
  std::erase(product.unknown, "engine");
  if (!info.sample_rate_hz) product.unknown.emplace_back("sample_rate_hz");
  if (options.bits <= 0 && info.bits <= 0 && !holds_counts(options.sink.format, options.sink.counts))
    product.unknown.emplace_back("bits");
  return product;
}

}  // namespace

void expect_single_precision(std::span<const std::complex<double>> volts, std::size_t first_row, std::size_t columns) {
  constexpr double most = std::numeric_limits<float>::max();
  const auto fits = [](double part) { return !(std::abs(part) > most) || std::isinf(part); };
  const auto bad = std::ranges::find_if_not(
      volts, [&](const std::complex<double>& value) { return fits(value.real()) && fits(value.imag()); });
  if (bad == volts.end()) return;
  const auto at = static_cast<std::size_t>(bad - volts.begin());
  throw core::InvalidRequest(
      {core::error(fmt::format("row {}, sample {} (from 0) is too large for the single precision of the new file",
                               first_row + at / columns, at % columns))
           .found(fmt::format("{:g} + {:g}j V", bad->real(), bad->imag()))
           .expected("volts below 3.4e38")
           .hint("scale the samples, or give a smaller LSB where they are counts")});
}

RunReport export_window(const Raster& source, const ImageWindow& window, const std::filesystem::path& path,
                        const ImageExport& options, const core::WorkControl& control,
                        const core::ProgressReport& progress) {
  if (window.samples() == 0) throw std::out_of_range("an empty selection cannot be stored");
  const auto begin = std::chrono::steady_clock::now();
  Product product = product_of(source, window, options);
  const bool from_counts = source.info().counts;
  const bool lsb_is_known = options.lsb_v > 0.0 || source.info().lsb_v || from_counts;
  if (!lsb_is_known && !holds_counts(options.sink.format, options.sink.counts)) product.unknown.emplace_back("lsb_v");
  auto sink = make_sink(path, product, options.sink);
  const double steps = radar::full_scale_count(product.bits);
  double lsb_v = options.lsb_v > 0.0 ? options.lsb_v : source.info().lsb_v.value_or(from_counts ? 1.0 : 0.0);
  if (!(lsb_v > 0.0) && sink->wants_counts()) lsb_v = largest_magnitude(source, window, control) / steps;
  if (!(lsb_v > 0.0)) lsb_v = 1.0;
  // Numbers that are stored as they are pass through no converter.
  const double volts_of_value = from_counts ? lsb_v : 1.0;
  const double factor = sink->wants_counts() ? 1.0 : volts_of_value;
  const bool single = !sink->wants_counts() && !options.sink.doubles;
  RasterWriter writer(std::move(sink), window.cols, {product.bits, from_counts ? 1.0 : lsb_v});
  RunReport report;
  report.rows = window.rows;
  report.columns = window.cols;
  std::vector<std::complex<double>> values;
  for_each_block(source, window, control, [&](std::size_t row, const std::vector<std::complex<float>>& samples) {
    values.assign(samples.begin(), samples.end());
    for (auto& value : values) {
      report.maximum_v = std::max(report.maximum_v, magnitude_of(value) * volts_of_value);
      value *= factor;
    }
    if (single) expect_single_precision(values, row, window.cols);
    writer.append(values);
    if (progress) progress({row + samples.size() / window.cols, window.rows, window.cols});
  });
  report.saturated = writer.tally().saturated;
  report.zero = writer.tally().zero;
  report.not_numbers = writer.tally().not_numbers;
  report.lsb_v = lsb_v;
  report.best_lsb_v = report.maximum_v / steps;
  report.range_used = report.maximum_v / (lsb_v * steps);
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  writer.finish(report);
  return report;
}

}  // namespace sarsim::raster
