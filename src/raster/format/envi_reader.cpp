#include "raster/format/envi_reader.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "raster/format/envi.hpp"

namespace sarsim::raster {

namespace {

class EnviReader : public SampleReader {
 public:
  EnviReader(SampleFileInfo info, EnviImage image) : SampleReader(std::move(info)), image_(std::move(image)) {}

  void read_rows(std::size_t first, std::size_t count, std::span<std::complex<double>> out) const override {
    const std::size_t columns = image_.header().samples;
    std::vector<std::complex<float>> line(columns);
    for (std::size_t row = 0; row < count; ++row) {
      image_.read(first + row, 0, line);
      std::ranges::copy(line, out.begin() + static_cast<std::ptrdiff_t>(row * columns));
    }
  }

 private:
  EnviImage image_;
};

SampleFileInfo info_of(const EnviHeader& header) {
  SampleFileInfo info;
  info.rows = header.lines;
  info.columns = header.samples;
  info.counts = false;
  info.attributes = {{"description", header.description},
                     {"data type", header.pixel == EnviHeader::Pixel::real_float ? "float" : "complex float"}};
  for (const auto& [name, value] : header.fields)
    info.attributes.emplace_back(name == "script" ? "script file" : name, value);
  return info;
}

}  // namespace

OpenedReader open_envi(const std::filesystem::path& data) {
  auto [image, problems] = EnviImage::open(data);
  if (!image) return {nullptr, std::move(problems)};
  SampleFileInfo info = info_of(image->header());
  return {std::make_unique<EnviReader>(std::move(info), std::move(*image)), std::move(problems)};
}

}  // namespace sarsim::raster
