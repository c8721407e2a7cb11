#include <utility>

#include "raster/format/envi.hpp"
#include "raster/format/format_reader.hpp"

namespace sarsim::raster {

namespace {

class EnviRaster final : public Raster {
 public:
  EnviRaster(RasterInfo info, EnviImage image) : Raster(std::move(info)), image_(std::move(image)) {}

  [[nodiscard]] std::size_t rows() const override { return image_.header().lines; }
  [[nodiscard]] double read_cost_s(const ImageWindow& window) const override {
    return static_cast<double>(window.rows) * (20e-6 + static_cast<double>(columns()) * 3e-9);
  }

 protected:
  void read_samples(const ImageWindow& window, std::span<std::complex<float>> out,
                    const core::WorkControl& control) const override {
    std::vector<std::complex<float>> line(window.cols == columns() ? 0 : columns());
    for (std::size_t i = 0; i < window.rows; ++i) {
      if (control.stop != nullptr && control.stop->requested()) throw core::Interrupted();
      const auto row = out.subspan(i * window.cols, window.cols);
      image_.read(window.row(i), 0, line.empty() ? row : std::span(line));
      for (std::size_t k = 0; !line.empty() && k < window.cols; ++k) row[k] = line[window.column(k)];
    }
  }

 private:
  EnviImage image_;
};

RasterInfo info_of(const std::filesystem::path& path, const EnviHeader& header) {
  RasterInfo info;
  info.path = path;
  info.columns = header.samples;
  info.attributes = {{"description", header.description},
                     {"data type", header.pixel == EnviHeader::Pixel::real_float ? "float" : "complex float"}};
  for (const auto& [name, value] : header.fields)
    info.attributes.emplace_back(name == "script" ? "script file" : name, value);
  return info;
}

}  // namespace

OpenedRaster open_envi(core::InputFile file, const Format&, const RasterHints&, Integrity) {
  auto [image, problems] = EnviImage::open(file.path());
  if (!image) return {nullptr, std::move(problems)};
  RasterInfo info = info_of(file.path(), image->header());
  return {std::make_shared<EnviRaster>(std::move(info), std::move(*image)), std::move(problems)};
}

}  // namespace sarsim::raster
