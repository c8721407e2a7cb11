#include "cli/doppler_image.hpp"

#include <algorithm>
#include <array>

#include "cli/image_output.hpp"
#include "data/formats.hpp"
#include "data/npy_header.hpp"
#include "data/sinks.hpp"
#include "receiver/converter.hpp"

namespace sarsim::cli {

namespace {

constexpr int count_bits = 16;

}  // namespace

bool needs_largest(const std::filesystem::path& path) {
  const auto format = format_from_path(path);
  return format && *format != FileFormat::hdf5 && *format != FileFormat::npy;
}

MapImageWriter::MapImageWriter(const std::filesystem::path& path, MapImage image, bool replace, double largest)
    : path_(path), image_(std::move(image)), replace_(replace) {
  const auto format = format_from_path(path);
  if (!format) {
    envi_.emplace(path, header(), replace);
    return;
  }
  Product& product = image_.product;
  product.processing = Processing::matched_filter;
  product.rows = image_.rows;
  product.columns = image_.columns;
  product.bits = count_bits;
  report_.rows = product.rows;
  report_.columns = product.columns;
  report_.maximum_v = largest;
  product.lsb_v = largest > 0.0 ? largest / full_scale_count(count_bits) : 1.0;
  report_.lsb_v = report_.best_lsb_v = product.lsb_v;
  report_.range_used = largest / (product.lsb_v * full_scale_count(count_bits));
  sink_ = make_sink(path, product, {.format = *format, .replace = replace});
  volts_.resize(image_.columns);
  if (sink_->wants_counts()) counts_.resize(2 * image_.columns);
}

MapImageWriter::~MapImageWriter() = default;

void MapImageWriter::append(std::span<const std::complex<float>> row) {
  if (envi_) {
    envi_->append(row);
    return;
  }
  std::ranges::transform(row, volts_.begin(), [](std::complex<float> v) { return std::complex<double>(v); });
  if (sink_->wants_counts()) {
    ConversionTally tally;
    Converter{count_bits, image_.product.lsb_v}.convert(volts_, counts_, tally);
    report_.zero += tally.zero;
  }
  sink_->append(sink_->encode({rows_, 1, image_.columns, volts_, counts_}), rows_, 1);
  ++rows_;
}

void MapImageWriter::finish() {
  if (envi_) {
    envi_->finish();
    return;
  }
  std::optional<OutputFile> text;
  if (format_from_path(path_) == FileFormat::npy) {
    text.emplace(std::filesystem::path(path_).replace_extension(".hdr"), replace_);
    write_npy_header(*text);
  }
  sink_->finish(report_);
  if (text) text->commit();
}

EnviHeader MapImageWriter::header() const {
  EnviHeader header;
  header.samples = image_.columns;
  header.lines = image_.rows;
  header.description = image_.description;
  header.fields = image_.fields;
  if (image_.real) header.pixel = EnviHeader::Pixel::real_float;
  return header;
}

// NPY files are flat behind their header: one for ENVI beside them makes their axes known.
void MapImageWriter::write_npy_header(OutputFile& file) const {
  EnviHeader text = header();
  text.pixel = EnviHeader::Pixel::complex_float;
  const std::array<std::size_t, 2> shape{image_.rows, image_.columns};
  text.header_offset = npy_header_text("<c8", shape).size();
  const std::string bytes = to_text(text);
  file.write(std::as_bytes(std::span(bytes)));
  file.secure();
}

}  // namespace sarsim::cli
