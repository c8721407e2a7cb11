#include "raster/format/sun_raster.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

#include "core/os/output_file.hpp"
#include "raster/table/file_problem.hpp"

namespace sarsim::raster {

namespace {

// A run of three bytes stands for up to 256 others, so no compressed file holds more than that.
constexpr std::uint64_t max_expansion = 256 / 3 + 1;
constexpr std::uint32_t max_map_bytes = 3U * 256U;
constexpr const char* supported =
    "types 0 (old), 1 (standard), 2 (run-length) and 3 (RGB) with 1, 8, 24 or 32 bits of a pixel";

std::uint32_t big_endian(std::span<const std::byte> bytes) {
  std::uint32_t value = 0;
  for (const std::byte byte : bytes.first(4)) value = value << 8U | std::to_integer<std::uint32_t>(byte);
  return value;
}

void put_big_endian(std::vector<std::byte>& bytes, std::uint32_t value) {
  for (const unsigned shift : {24U, 16U, 8U, 0U}) bytes.push_back(static_cast<std::byte>(value >> shift));
}

std::string name_of_type(std::uint32_t type) {
  switch (type) {
    case 4: return "4 (TIFF)";
    case 5: return "5 (IFF)";
    case 0xffff: return "65535 (experimental)";
    default: return fmt::format("{}", type);
  }
}

std::optional<core::Problem> kind_problem(const std::string& name, std::uint32_t type, std::uint32_t depth,
                                          std::uint32_t map_type) {
  if (type > 3)
    return file_problem(name, "this type of Sun raster is not supported", name_of_type(type), supported,
                        "convert it to one of those");
  if (depth != 1 && depth != 8 && depth != 24 && depth != 32)
    return file_problem(name, "this depth of a Sun raster is not supported", fmt::format("{} bits of a pixel", depth),
                        supported, "convert it to one of those");
  if (map_type > 2)
    return file_problem(name, "this type of colour map is not supported", fmt::format("{}", map_type),
                        "0 (none), 1 (red, green, blue) or 2 (raw)");
  return std::nullopt;
}

std::optional<core::Problem> map_problem(const std::string& name, const SunRasterHeader& header) {
  if (header.map_type != 1 || header.depth > 8) return std::nullopt;
  const std::uint32_t most = header.depth == 1 ? 6U : max_map_bytes;
  if (header.map_length % 3 == 0 && header.map_length <= most) return std::nullopt;
  return file_problem(name, "the colour map has a wrong length", fmt::format("{} bytes", header.map_length),
                      fmt::format("a multiple of 3 up to {}", most));
}

std::optional<core::Problem> size_problem(const std::string& name, const SunRasterHeader& header,
                                          std::uint64_t file_bytes) {
  if (header.width == 0 || header.height == 0)
    return file_problem(name, "the picture has no pixels", fmt::format("{} x {}", header.width, header.height));
  if (header.data_offset() > file_bytes)
    return file_problem(name, "the file ends within the colour map",
                        fmt::format("{} bytes", file_bytes - std::min<std::uint64_t>(file_bytes, header.bytes)),
                        fmt::format("{} bytes", header.map_length), "the file is cut off");
  // Both factors are below 2^37 and 2^32, so the product needs a check.
  const auto pixels = checked_product(header.row_bytes(), header.height);
  const std::uint64_t present = file_bytes - header.data_offset();
  const bool packed = header.type == SunType::run_length;
  const std::uint64_t most = packed ? present * max_expansion : present;
  if (pixels && *pixels <= most) return std::nullopt;
  return file_problem(name,
                      packed ? "the file is too short for the size that it claims" : "the file ends within the picture",
                      fmt::format("{} bytes", present),
                      fmt::format("{} x {} pixels of {} bits{}", header.width, header.height, header.depth,
                                  pixels && !packed ? fmt::format(", {} bytes", *pixels) : std::string()),
                      "the file is cut off, or its header is damaged");
}

std::vector<std::byte> header_bytes(std::size_t width, std::size_t height, std::uint32_t depth) {
  constexpr std::size_t most = std::numeric_limits<std::int32_t>::max();
  if (width == 0 || height == 0 || width > most || height > most)
    throw std::invalid_argument(fmt::format("{} x {} pixels do not fit into a Sun raster", width, height));
  SunRasterHeader header;
  header.width = static_cast<std::uint32_t>(width);
  header.height = static_cast<std::uint32_t>(height);
  header.depth = depth;
  const auto length = checked_product(header.row_bytes(), height);
  if (!length || *length > most)
    throw std::invalid_argument(fmt::format("{} x {} pixels are too many for a Sun raster", width, height));
  std::vector<std::byte> bytes;
  for (const std::uint32_t value :
       {SunRasterHeader::magic, header.width, header.height, depth, static_cast<std::uint32_t>(*length), 1U, 0U, 0U})
    put_big_endian(bytes, value);
  return bytes;
}

// Writes rows one at a time; `put_row(y, bytes)` appends the pixels of a row.
template <class PutRow>
void write_rows(const std::filesystem::path& path, std::size_t width, std::size_t height, std::uint32_t depth,
                bool replace, const PutRow& put_row) {
  const std::vector<std::byte> begin = header_bytes(width, height, depth);
  core::OutputFile file(path, replace);
  file.write(begin);
  std::vector<std::byte> row;
  for (std::size_t y = 0; y < height; ++y) {
    row.clear();
    put_row(y, row);
    if (row.size() % 2 != 0) row.push_back(std::byte{0});
    file.write(row);
  }
  file.commit();
}

void require_pixels(std::size_t width, std::size_t height, std::size_t found) {
  if (checked_product(width, height) != found)
    throw std::invalid_argument(fmt::format("{} pixels are not a picture of {} x {}", found, width, height));
}

std::uint8_t byte_at(std::span<const std::byte> bytes, std::uint64_t index) {
  return std::to_integer<std::uint8_t>(bytes[static_cast<std::size_t>(index)]);
}

bool is_sun_raster(std::span<const std::byte> begin) {
  return begin.size() >= 4 && big_endian(begin) == SunRasterHeader::magic;
}

}  // namespace

std::variant<SunRasterHeader, core::Problem> read_sun_header(const core::InputFile& file) {
  const std::string name = file.path().string();
  std::array<std::byte, SunRasterHeader::bytes> bytes{};
  const std::size_t got = file.read_at(0, bytes);
  if (!is_sun_raster(std::span(bytes).first(got)))
    return file_problem(name, "the file is not a Sun raster: it does not begin with 59 A6 6A 95");
  if (got < bytes.size())
    return file_problem(name, "the file ends within the header", fmt::format("{} bytes", got),
                        fmt::format("{} bytes", bytes.size()), "the file is cut off");
  const auto field = [&](std::size_t index) { return big_endian(std::span(bytes).subspan(4 * index)); };
  SunRasterHeader header;
  header.width = field(1);
  header.height = field(2);
  header.depth = field(3);
  header.length = field(4);
  header.map_type = field(6);
  header.map_length = field(7);
  if (auto problem = kind_problem(name, field(5), header.depth, header.map_type)) return std::move(*problem);
  header.type = static_cast<SunType>(field(5));
  if (auto problem = map_problem(name, header)) return std::move(*problem);
  if (auto problem = size_problem(name, header, file.size())) return std::move(*problem);
  return header;
}

SunPixels::SunPixels(const core::InputFile& file, const SunRasterHeader& header)
    : header_(header), grey_(header.depth <= 8) {
  if (header.depth > 8) return;
  if (header.map_type != 1 || header.map_length == 0) {
    for (std::size_t i = 0; i < map_.size(); ++i) {
      const auto level = static_cast<std::uint8_t>(header.depth == 1 ? (i == 0 ? 255 : 0) : i);
      map_[i] = {level, level, level};
    }
    return;
  }
  std::vector<std::byte> stored(header.map_length);
  file.read_all_at(SunRasterHeader::bytes, stored);
  const std::size_t entries = stored.size() / 3;
  for (std::size_t i = 0; i < entries; ++i) {
    map_[i] = {byte_at(stored, i), byte_at(stored, entries + i), byte_at(stored, 2 * entries + i)};
    grey_ = grey_ && map_[i].red == map_[i].green && map_[i].green == map_[i].blue;
  }
}

Rgb SunPixels::colour(std::span<const std::byte> bytes, std::uint64_t first_byte, std::uint64_t column) const {
  switch (header_.depth) {
    case 1: return map_[static_cast<std::uint8_t>(byte_at(bytes, column / 8 - first_byte) >> (7 - column % 8)) & 1U];
    case 8: return map_[byte_at(bytes, column - first_byte)];
    default: break;
  }
  // Of 32 bits the first byte is padding.
  const std::uint64_t at = column * (header_.depth / 8) - first_byte + (header_.depth == 32 ? 1 : 0);
  const Rgb stored{byte_at(bytes, at), byte_at(bytes, at + 1), byte_at(bytes, at + 2)};
  return header_.type == SunType::rgb ? stored : Rgb{stored.blue, stored.green, stored.red};
}

void write_sun_raster(const std::filesystem::path& path, std::size_t width, std::size_t height,
                      std::span<const std::uint8_t> grey, bool replace) {
  require_pixels(width, height, grey.size());
  write_rows(path, width, height, 8, replace, [&](std::size_t y, std::vector<std::byte>& row) {
    const auto pixels = std::as_bytes(grey.subspan(y * width, width));
    row.assign(pixels.begin(), pixels.end());
  });
}

void write_sun_raster(const std::filesystem::path& path, std::size_t width, std::size_t height,
                      std::span<const Rgb> colour, bool replace) {
  require_pixels(width, height, colour.size());
  write_rows(path, width, height, 24, replace, [&](std::size_t y, std::vector<std::byte>& row) {
    for (const Rgb& pixel : colour.subspan(y * width, width))
      for (const std::uint8_t part : {pixel.blue, pixel.green, pixel.red}) row.push_back(static_cast<std::byte>(part));
  });
}

}  // namespace sarsim::raster
