#include "workflow/image/image_writer.hpp"

#include <array>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include "radar/receiver/converter.hpp"
#include "raster/format/npy_header.hpp"
#include "raster/format/sinks.hpp"
#include "raster/table/formats.hpp"

namespace sarsim::workflow {

namespace {

constexpr int count_bits = 16;

}  // namespace

bool needs_largest(const std::filesystem::path& path) {
  const auto format = raster::format_from_path(path);
  return format && raster::holds_counts(*format);
}

ImageWriter::ImageWriter(const std::filesystem::path& path, ImageContent content, bool replace, double largest)
    : path_(path), content_(std::move(content)), replace_(replace) {
  if (content_.sicd) {
    sicd_.emplace(path, content_.sicd->description, content_.sicd->backwards, replace);
    return;
  }
  const auto format = raster::format_from_path(path);
  if (!format) {
    envi_.emplace(path, content_.header, replace);
    return;
  }
  raster::Product& product = content_.product;
  product.processing = scene::Processing::matched_filter;
  product.rows = report_.rows = content_.header.lines;
  product.columns = report_.columns = content_.header.samples;
  product.bits = count_bits;
  product.lsb_v = largest > 0.0 ? largest / radar::full_scale_count(count_bits) : 1.0;
  report_.maximum_v = largest;
  report_.lsb_v = report_.best_lsb_v = product.lsb_v;
  report_.range_used = largest / (product.lsb_v * radar::full_scale_count(count_bits));
  samples_.emplace(raster::make_sink(path, product, {.format = *format, .replace = replace}), product.columns,
                   radar::Converter{count_bits, product.lsb_v});
}

ImageWriter::ImageWriter(ImageContent content) : content_(std::move(content)), replace_(false) {
  pixels_.reserve(content_.header.lines * content_.header.samples);
}

ImageWriter::~ImageWriter() = default;

void ImageWriter::append(std::span<const std::complex<float>> row) {
  if (envi_)
    envi_->append(row);
  else if (sicd_)
    sicd_->append(row);
  else if (samples_)
    samples_->append(row);
  else
    pixels_.insert(pixels_.end(), row.begin(), row.end());
}

void ImageWriter::finish() {
  if (envi_) {
    envi_->finish();
    return;
  }
  if (sicd_) {
    sicd_->finish();
    return;
  }
  if (!samples_) {
    if (pixels_.size() != content_.header.lines * content_.header.samples)
      throw std::logic_error("rows of the image are missing");
    return;
  }
  std::optional<core::OutputFile> text;
  const raster::Format* const format = raster::row_from_path(path_);
  if (format != nullptr && format->envi_header) {
    text.emplace(std::filesystem::path(path_).replace_extension(".hdr"), replace_);
    write_npy_header(*text);
  }
  samples_->finish(report_);
  if (text) text->commit();
}

InMemoryImage ImageWriter::kept() && {
  const std::size_t rows = content_.header.lines;
  const std::size_t columns = content_.header.samples;
  return {std::move(content_),
          core::rows_in_memory(std::make_shared<const std::vector<std::complex<float>>>(std::move(pixels_)), rows,
                               columns)};
}

// NPY files are flat behind their header: one for ENVI beside them makes their axes known.
void ImageWriter::write_npy_header(core::OutputFile& file) const {
  raster::EnviHeader header = content_.header;
  header.pixel = raster::EnviHeader::Pixel::complex_float;
  const std::array<std::size_t, 2> shape{header.lines, header.samples};
  header.header_offset = raster::npy_header_text("<c8", shape).size();
  const std::string text = raster::to_text(header);
  file.write(std::as_bytes(std::span(text)));
  file.secure();
}

}  // namespace sarsim::workflow
