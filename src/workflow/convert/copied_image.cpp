#include "workflow/convert/copied_image.hpp"

#include <array>
#include <span>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "core/os/output_file.hpp"
#include "core/report/invalid_request.hpp"
#include "raster/format/npy_header.hpp"
#include "workflow/image/image_facts.hpp"

namespace sarsim::workflow {

namespace fs = std::filesystem;

namespace {

class PixelSink final : public raster::Sink {
 public:
  PixelSink(const fs::path& path, const raster::EnviHeader& header, bool replace)
      : complex_(header.pixel == raster::EnviHeader::Pixel::complex_float),
        lines_(header.lines),
        file_(path, replace) {}

  [[nodiscard]] bool wants_counts() const override { return false; }
  [[nodiscard]] std::vector<std::byte> encode(const raster::Block& block) const override {
    std::vector<float> parts;
    parts.reserve((complex_ ? 2 : 1) * block.volts.size());
    for (const std::complex<double> value : block.volts) {
      parts.push_back(static_cast<float>(value.real()));
      if (complex_) parts.push_back(static_cast<float>(value.imag()));
    }
    const auto bytes = std::as_bytes(std::span(parts));
    return {bytes.begin(), bytes.end()};
  }
  void append(std::span<const std::byte> bytes, std::size_t first_row, std::size_t rows) override {
    if (first_row != done_) throw std::logic_error("rows of an image that do not follow one another");
    file_.write(bytes);
    done_ += rows;
  }
  void finish(const raster::RunReport&) override {
    if (done_ != lines_) throw std::logic_error("rows of this image are missing");
    file_.commit();
  }

 private:
  bool complex_;
  std::size_t lines_;
  std::size_t done_ = 0;
  core::OutputFile file_;
};

fs::path folder_of(const fs::path& file) { return file.has_parent_path() ? file.parent_path() : fs::path("."); }

}  // namespace

std::optional<raster::EnviHeader> header_beside(const fs::path& path, const raster::Raster& file) {
  if (auto header = header_of_facts(file)) return header;
  if (!file.info().format->envi_header || (file.info().format->recording && !raster::has_envi_header(path)))
    return std::nullopt;
  auto [image, problems] = raster::EnviImage::open(path);
  if (!image) throw core::InvalidRequest(std::move(problems));
  const raster::EnviHeader& header = image->header();
  if (header.lines != file.rows() || header.samples != file.columns()) return std::nullopt;
  return header;
}

fs::path header_file_of_copy(const fs::path& image, const fs::path& copy) {
  const fs::path replaced = fs::path(copy).replace_extension(".hdr");
  std::error_code ignored;
  const bool taken = replaced == copy || fs::equivalent(replaced, raster::envi_header_of(image), ignored);
  return taken ? fs::path(copy.string() + ".hdr") : replaced;
}

raster::EnviHeader header_of_copy(raster::EnviHeader header, const fs::path& image, const fs::path& copy, bool array) {
  header.header_offset = 0;
  if (array) {
    const std::array<std::size_t, 2> shape{header.lines, header.samples};
    header.pixel = raster::EnviHeader::Pixel::complex_float;
    header.header_offset = raster::npy_header_text("<c8", shape).size();
  }
  for (auto& [name, value] : header.fields) {
    if (value.empty() || (name != "source from image" && name != "script from image")) continue;
    std::error_code failure;
    const fs::path seen = fs::proximate(folder_of(image) / value, folder_of(copy), failure);
    value = failure ? std::string() : seen.string();
  }
  return header;
}

bool is_of_magnitudes(const raster::EnviHeader& header) {
  return header.pixel == raster::EnviHeader::Pixel::real_float && header.field("image plane");
}

std::unique_ptr<raster::Sink> make_pixel_sink(const fs::path& path, const raster::EnviHeader& header, bool replace) {
  return std::make_unique<PixelSink>(path, header, replace);
}

}  // namespace sarsim::workflow
