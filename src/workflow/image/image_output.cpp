#include "workflow/image/image_output.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/report/invalid_request.hpp"
#include "core/text/number_text.hpp"
#include "radar/path/path.hpp"
#include "raster/table/formats.hpp"
#include "scene/schema/trade_words.hpp"
#include "workflow/image/image_facts.hpp"
#include "workflow/image/image_script.hpp"
#include "workflow/image/image_writer.hpp"
#include "workflow/image/map_fields.hpp"
#include "workflow/image/sicd_image.hpp"

namespace sarsim::workflow {

namespace fs = std::filesystem;

namespace {

// Calls use(row) for every row of an image.
template <class Use>
void each_row(const core::SampleRows<float>& image, const core::StopFlag* stop, const Use& use) {
  std::vector<std::complex<float>> row(image.columns);
  for (std::size_t r = 0; r < image.rows; ++r) {
    if (stop != nullptr && stop->requested()) throw core::Interrupted();
    image.read(r, row);
    use(std::span<const std::complex<float>>(row));
  }
}

raster::Product product_of(const signal::FocusedImage& image, const ImageOrigin& origin) {
  raster::Product product;
  product.radar = origin.radar;
  product.options = origin.run;
  // A row is where the antenna passes at that time.
  const double speed = image.frame.speed_mps;
  product.row_time_s = [axis = image.azimuth, speed](std::size_t row) {
    return axis.at(static_cast<double>(row)) / speed;
  };
  product.row_carrier_hz = [carrier = image.carrier_hz](std::size_t) { return carrier; };
  product.image.rows = is_of_turning_target(origin) ? "cross_range_m" : "azimuth_m";
  product.image.row_m = [axis = image.azimuth](std::size_t row) { return axis.at(static_cast<double>(row)); };
  if (image.frame.plane == signal::ImagePlane::ground_grid) product.image.columns = "ground_range_m";
  if (is_on_the_earth(image, origin)) {
    GridFacts facts = grid_facts(image, *origin.earth);
    product.image.facts = std::move(facts.file);
    product.image.map = std::move(facts.map);
  }
  product.column_range_m = [axis = image.range](std::size_t column) { return axis.at(static_cast<double>(column)); };
  product.sample_rate_hz = radar::frequency_of_turns(1.0, image.range.step_m, image.light_speed_mps);
  product.engine = "focus";
  return product;
}

double largest_of(const core::SampleRows<float>& image, const core::StopFlag* stop) {
  float largest = 0.0F;
  each_row(image, stop, [&](std::span<const std::complex<float>> row) {
    for (const std::complex<float> value : row) largest = std::max(largest, std::abs(value));
  });
  return static_cast<double>(largest);
}

bool carries_axes(const fs::path& path) {
  const auto format = raster::format_from_path(path);
  return format && raster::format_of(*format).carries_axes;
}

void expect_place(const InMemoryImage& image, const fs::path& path) {
  if (image.origin && image.origin->collection) return;
  throw core::InvalidRequest(
      fmt::format("'{}': SICD is for focused images whose place on the Earth is known", path.string()),
      "focus a scene over the Earth, or with an anchor; or name it .img");
}

SicdImage sicd_of(const InMemoryImage& image, const raster::EnviHeader& header, const fs::path& path) {
  signal::FocusedImage axes;
  ImageOrigin ignored;
  read_header(header, path.string(), axes, ignored);
  return sicd_of(axes, *image.origin, *image.origin->collection, header, path.stem().string());
}

// The picture's name where `plot` writes that kind, or that of a PNG.
fs::path drawn_as(fs::path path) {
  const std::string extension = path.extension().string();
  for (const char* const drawn : {".png", ".svg", ".pdf"})
    if (core::equal_ignoring_case(extension, drawn)) return path;
  return path.replace_extension(".png");
}

}  // namespace

void expect_no_picture(const fs::path& path, std::string_view option) {
  static constexpr std::string_view pictures[] = {".png", ".jpg", ".jpeg", ".tif", ".tiff",
                                                  ".bmp", ".gif", ".svg",  ".pdf"};
  const std::string extension = path.extension().string();
  for (const std::string_view picture : pictures)
    if (core::equal_ignoring_case(extension, picture))
      throw core::InvalidRequest(
          fmt::format("{} '{}' is the name of a picture, but images are written as complex samples", option,
                      path.string()),
          fmt::format("name it {0}; 'sarsim plot {0} -o {1}' then draws it",
                      fs::path(path).replace_extension(".img").string(), drawn_as(path).string()));
}

bool is_sicd(const fs::path& path) { return raster::row_from_path(path) == &raster::sicd_format(); }

bool is_envi(const fs::path& path) { return !raster::format_from_path(path) && !is_sicd(path); }

void expect_image_ending(const fs::path& path, std::string_view option) {
  expect_no_picture(path, option);
  const std::string extension = path.extension().string();
  if (extension.empty() || extension == ".hdr") return;  // Of headers the list of outputs says more.
  const raster::Format* const row = raster::row_from_path(path);
  if (row != nullptr && (row->recording || row == &raster::envi_format() || row == &raster::sicd_format())) return;
  const scene::TradeChoice* const meant = scene::trade_choice(extension, "format");
  const auto format = meant == nullptr ? std::nullopt : raster::format_from_name(meant->word);
  const auto named = [&](std::string_view ending) { return fs::path(path).replace_extension(ending).string(); };
  throw core::InvalidRequest(
      fmt::format("{}: the extension of '{}' names no format of images", option, path.string()),
      format ? fmt::format("name it {}{}{}", named(raster::extension_of(*format)), meant->note.empty() ? "" : ": ",
                           meant->note)
             : fmt::format("name it {} for ENVI, or end it with {}", named(".img"), raster::image_extensions()));
}

void expect_no_sicd(const fs::path& path, std::string_view option) {
  if (is_sicd(path))
    throw core::InvalidRequest(
        fmt::format("{} '{}' is the name of a SICD file, which only images of sarsim focus become", option,
                    path.string()),
        fmt::format("name it {}", fs::path(path).replace_extension(".img").string()));
}

fs::path magnitude_path(const fs::path& path) {
  return path.parent_path() / (path.stem().string() + "-magnitude" + path.extension().string());
}

std::vector<fs::path> files_of_image(const fs::path& path) {
  const auto format = raster::format_from_path(path);
  if (is_sicd(path)) return {path};
  if (format && !raster::format_of(*format).envi_header) return raster::files_of(&raster::format_of(*format), path);
  return {path, fs::path(path).replace_extension(".hdr")};
}

InMemoryImage in_memory_image(const signal::FocusedRows& image, const ImageOrigin& origin) {
  return {{header_of(image.image, origin), product_of(image.image, origin), {}}, image, origin};
}

void write_image(const InMemoryImage& image, const fs::path& path, bool replace, const core::StopFlag* stop) {
  if (is_sicd(path)) expect_place(image, path);
  if (image.write) return image.write(path, replace, stop);
  ImageContent content = image.content;
  if (image.origin && (files_of_image(path).size() > 1 || is_sicd(path) || carries_axes(path)))
    add_way_back(content.header, *image.origin, path, stop);
  if (is_sicd(path)) content.sicd = sicd_of(image, content.header, path);
  if (image.origin && carries_axes(path))
    std::ranges::move(facts_of_header(content.header), std::back_inserter(content.product.image.facts));
  const bool look = image.largest_if_needed ? needs_largest(path) : !is_envi(path) && !is_sicd(path);
  ImageWriter writer(path, std::move(content), replace, look ? largest_of(image.rows, stop) : 0.0);
  each_row(image.rows, stop, [&](std::span<const std::complex<float>> row) { writer.append(row); });
  writer.finish();
}

void write_image(const signal::FocusedRows& image, const ImageOrigin& origin, const fs::path& path, bool replace,
                 bool magnitude, const core::StopFlag* stop) {
  InMemoryImage written = in_memory_image(image, origin);
  if (magnitude) written.content.header.pixel = raster::EnviHeader::Pixel::real_float;
  write_image(written, path, replace, stop);
}

}  // namespace sarsim::workflow
