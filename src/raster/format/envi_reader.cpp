#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/text/number_text.hpp"
#include "raster/format/envi.hpp"
#include "raster/format/format_reader.hpp"
#include "raster/table/image_places.hpp"

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

// An axis by the fields of a header: "azimuth first m", "azimuth step m".
std::optional<StoredArray> axis_of(const EnviHeader& header, const std::string& field, const std::string& name,
                                   const char* long_name, std::size_t count) {
  const auto number = [&](const char* which) {
    const auto text = header.field(field + which);
    return text ? core::parse_number(*text) : std::nullopt;
  };
  const auto first = number(" first m");
  const auto step = number(" step m");
  if (!first || !step) return std::nullopt;
  return axis_here(name, ImagePlaces{{}, {}, *first, *step}.list(count), "m", long_name);
}

}  // namespace

OpenedRaster open_envi(core::InputFile file, const Format&, const RasterHints&, Integrity, const core::StopFlag*) {
  auto [image, problems] = EnviImage::open(file.path());
  if (!image) return {nullptr, std::move(problems)};
  RasterInfo info = info_of(file.path(), image->header());
  return {std::make_shared<EnviRaster>(std::move(info), std::move(*image)), std::move(problems)};
}

StoredArrays arrays_of_envi(const core::InputFile& file, const RasterHints&) {
  auto [image, problems] = EnviImage::open(file.path());
  if (!image) return std::move(problems.front());
  const EnviHeader& header = image->header();
  const bool real = header.pixel == EnviHeader::Pixel::real_float;
  std::vector<StoredArray> arrays{{.name = "samples",
                                   .type = real ? "<f4" : "<c8",
                                   .item_bytes = pixel_bytes(header.pixel),
                                   .shape = {header.lines, header.samples},
                                   .dimensions = {"line", "sample"},
                                   .offset = header.header_offset,
                                   .facts = {{"units", "V"}, {"long_name", real ? "magnitude" : "complex image"}}}};
  const bool ground = header.field("image plane") == "ground grid";
  const auto add = [&](std::optional<StoredArray> axis, std::size_t dimension) {
    if (!axis) return;
    arrays.front().dimensions[dimension] = axis->name;
    arrays.push_back(std::move(*axis));
  };
  add(axis_of(header, "azimuth", "azimuth_m", "place along the track", header.lines), 0);
  add(axis_of(header, "range", ground ? "ground_range_m" : "slant_range_m",
              ground ? "ground range" : "one-way slant range", header.samples),
      1);
  return arrays;
}

}  // namespace sarsim::raster
