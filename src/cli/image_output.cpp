#include "cli/image_output.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include "data/formats.hpp"
#include "data/npy_header.hpp"
#include "data/output_file.hpp"
#include "data/sinks.hpp"
#include "receiver/converter.hpp"

namespace sarsim::cli {

namespace fs = std::filesystem;

namespace {

constexpr int count_bits = 16;

// Calls use(row number, row) for every row of an image.
template <class Use>
void each_row(const FocusedRows& image, const StopFlag* stop, const Use& use) {
  std::vector<std::complex<float>> row(image.image.range.count);
  for (std::size_t r = 0; r < image.image.azimuth.count; ++r) {
    if (stop != nullptr && stop->requested()) throw Interrupted();
    image.read(r, row);
    use(r, std::span<const std::complex<float>>(row));
  }
}

void write_envi(const FocusedRows& image, EnviHeader header, const fs::path& path, bool replace, bool magnitude,
                const StopFlag* stop) {
  if (magnitude) header.pixel = EnviHeader::Pixel::real_float;
  EnviWriter writer(path, std::move(header), replace);
  each_row(image, stop, [&](std::size_t, std::span<const std::complex<float>> row) { writer.append(row); });
  writer.finish();
}

Product product_of(const FocusedImage& image, const ImageOrigin& origin) {
  Product product;
  product.radar = origin.radar;
  product.options = origin.run;
  product.processing = Processing::matched_filter;
  product.rows = image.azimuth.count;
  product.columns = image.range.count;
  // A row is where the antenna passes at that time.
  const double speed = image.frame.speed_mps;
  product.row_time_s = [axis = image.azimuth, speed](std::size_t row) {
    return axis.at(static_cast<double>(row)) / speed;
  };
  product.row_carrier_hz = [carrier = image.carrier_hz](std::size_t) { return carrier; };
  product.column_range_m = [axis = image.range](std::size_t column) { return axis.at(static_cast<double>(column)); };
  product.sample_rate_hz = 0.5 * image.light_speed_mps / image.range.step_m;
  product.bits = count_bits;
  product.engine = "focus";
  return product;
}

double largest_of(const FocusedRows& image, const StopFlag* stop) {
  float largest = 0.0F;
  each_row(image, stop, [&](std::size_t, std::span<const std::complex<float>> row) {
    for (const std::complex<float> value : row) largest = std::max(largest, std::abs(value));
  });
  return static_cast<double>(largest);
}

void write_samples(const FocusedRows& image, const ImageOrigin& origin, FileFormat format, const fs::path& path,
                   bool replace, const StopFlag* stop) {
  Product product = product_of(image.image, origin);
  RunReport report;
  report.rows = product.rows;
  report.columns = product.columns;
  report.maximum_v = largest_of(image, stop);
  product.lsb_v = report.maximum_v > 0.0 ? report.maximum_v / full_scale_count(count_bits) : 1.0;
  report.lsb_v = report.best_lsb_v = product.lsb_v;
  report.range_used = report.maximum_v / (product.lsb_v * full_scale_count(count_bits));
  const std::unique_ptr<Sink> sink = make_sink(path, product, {.format = format, .replace = replace});
  ConversionTally tally;
  std::vector<std::complex<double>> volts(product.columns);
  std::vector<std::int64_t> counts(sink->wants_counts() ? 2 * product.columns : 0);
  each_row(image, stop, [&](std::size_t r, std::span<const std::complex<float>> row) {
    std::ranges::transform(row, volts.begin(), [](std::complex<float> v) { return std::complex<double>(v); });
    Converter{count_bits, product.lsb_v}.convert(volts, counts, tally);
    sink->append(sink->encode({r, 1, product.columns, volts, counts}), r, 1);
  });
  report.zero = tally.zero;
  sink->finish(report);
}

// NPY files are flat behind their header: one for ENVI beside them makes their axes known.
void write_npy_header(OutputFile& file, const FocusedImage& image, EnviHeader header) {
  const std::array<std::size_t, 2> shape{image.azimuth.count, image.range.count};
  header.header_offset = npy_header_text("<c8", shape).size();
  const std::string text = to_text(header);
  file.write(std::as_bytes(std::span(text)));
  file.secure();
}

}  // namespace

bool is_envi(const fs::path& path) { return !format_from_path(path); }

fs::path magnitude_path(const fs::path& path) {
  return path.parent_path() / (path.stem().string() + "-magnitude" + path.extension().string());
}

std::vector<fs::path> files_of_image(const fs::path& path) {
  const auto format = format_from_path(path);
  if (format && *format != FileFormat::npy) return {path};
  return {path, fs::path(path).replace_extension(".hdr")};
}

void write_image(const FocusedRows& image, const ImageOrigin& origin, const fs::path& path, bool replace,
                 bool magnitude, const StopFlag* stop) {
  EnviHeader header = header_of(image.image, origin);
  const auto format = format_from_path(path);
  if (!format) {
    write_envi(image, std::move(header), path, replace, magnitude, stop);
    return;
  }
  std::optional<OutputFile> text;
  if (*format == FileFormat::npy) {
    text.emplace(fs::path(path).replace_extension(".hdr"), replace);
    write_npy_header(*text, image.image, std::move(header));
  }
  write_samples(image, origin, *format, path, replace, stop);
  if (text) text->commit();
}

}  // namespace sarsim::cli
