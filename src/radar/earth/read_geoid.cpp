#include "radar/earth/read_geoid.hpp"

#include <bit>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/text/letters.hpp"
#include "core/text/number_text.hpp"
#include "radar/earth/geoid_problem.hpp"

namespace sarsim::radar {

namespace {

constexpr std::size_t gtx_header_bytes = 40;

// A number with its highest byte first.
template <class Bits>
Bits bits_at(std::string_view bytes, std::size_t at) {
  Bits bits = 0;
  for (std::size_t i = 0; i < sizeof(Bits); ++i)
    bits = static_cast<Bits>((bits << 8U) | static_cast<unsigned char>(bytes[at + i]));
  return bits;
}

// The header of GTX, not checked.
struct GtxHeader {
  GeoidLattice lattice;
  std::int64_t rows = 0;
  std::int64_t columns = 0;

  // Negative counts have none.
  [[nodiscard]] std::uint64_t values() const {
    return rows > 0 && columns > 0 ? static_cast<std::uint64_t>(rows) * static_cast<std::uint64_t>(columns) : 0;
  }
};

std::optional<GtxHeader> gtx_header(std::string_view bytes) {
  if (bytes.size() < gtx_header_bytes) return std::nullopt;
  const auto real = [&](std::size_t at) { return std::bit_cast<double>(bits_at<std::uint64_t>(bytes, at)); };
  const auto count = [&](std::size_t at) { return std::bit_cast<std::int32_t>(bits_at<std::uint32_t>(bytes, at)); };
  GtxHeader header;
  header.lattice = {real(0), real(16), real(8), real(24), 0, 0};
  header.rows = count(32);
  header.columns = count(36);
  return header;
}

bool begins_with_word(std::string_view bytes, std::string_view word) {
  while (!bytes.empty() && core::is_blank(bytes.front())) bytes.remove_prefix(1);
  return bytes.size() > word.size() && core::equal_ignoring_case(bytes.substr(0, word.size()), word) &&
         core::is_blank(bytes[word.size()]);
}

bool is_ascii_grid(std::string_view bytes) {
  const std::string_view head = bytes.substr(0, 256);
  for (const std::string_view word :
       {"ncols", "nrows", "xllcorner", "xllcenter", "yllcorner", "yllcenter", "cellsize", "nodata_value"})
    if (begins_with_word(head, word)) return true;
  return false;
}

bool is_gtx(std::string_view bytes) {
  const std::optional<GtxHeader> header = gtx_header(bytes);
  if (!header || header->values() == 0) return false;
  const std::uint64_t values = (bytes.size() - gtx_header_bytes) / sizeof(float);
  const bool near_length = header->values() == values || header->values() == values + 1;
  return near_length && std::abs(header->lattice.first_latitude_deg) <= 91.0;
}

}  // namespace

GeoidFormat geoid_format_of(std::string_view bytes) {
  if (bytes.starts_with("P5")) return GeoidFormat::pgm;
  if (is_ascii_grid(bytes)) return GeoidFormat::ascii;
  return is_gtx(bytes) ? GeoidFormat::gtx : GeoidFormat::unknown;
}

std::variant<GeoidGrid, core::Problem> read_geoid(std::string_view bytes, const std::string& name) {
  switch (geoid_format_of(bytes)) {
    case GeoidFormat::pgm: return read_geoid_pgm(bytes, name);
    case GeoidFormat::gtx: return read_geoid_gtx(bytes, name);
    case GeoidFormat::ascii: return read_geoid_ascii(bytes, name);
    case GeoidFormat::unknown: break;
  }
  return core::error("the file is no grid of the geoid that could be read")
      .found(fmt::format("{} bytes", bytes.size()))
      .expected("GeographicLib's PGM (begins with P5), NOAA's GTX, or an ASCII grid (begins with ncols)")
      .hint("a GTX file that was cut off is not known as one: compare its length with the original's")
      .in(name);
}

std::variant<GeoidGrid, core::Problem> read_geoid_gtx(std::string_view bytes, const std::string& name) {
  constexpr float no_value = -88.8888F;
  const std::optional<GtxHeader> header = gtx_header(bytes);
  if (!header)
    return core::error("the GTX file ends within its header")
        .found(fmt::format("{} bytes", bytes.size()))
        .expected(fmt::format("at least {}", gtx_header_bytes))
        .hint("the file may be cut off")
        .in(name);
  const std::uint64_t count = header->values();
  if (count == 0)
    return core::error("the numbers of rows and columns cannot be")
        .found(fmt::format("{} and {}", header->rows, header->columns))
        .expected("numbers above 0")
        .hint("is this a GTX file with the highest byte first?")
        .in(name);
  const std::size_t data_bytes = bytes.size() - gtx_header_bytes;
  if (data_bytes / sizeof(float) != count || data_bytes % sizeof(float) != 0)
    return core::error("the GTX file does not hold as many values as its header says")
        .found(fmt::format("{} bytes behind the header", data_bytes))
        .expected(fmt::format("{} rows of {} values of 4 bytes", header->rows, header->columns))
        .hint("the file may be cut off, or hold something else at its end")
        .in(name);
  if (!(header->lattice.latitude_step_deg > 0.0))
    return core::error("the step of the latitude is not above 0")
        .found(fmt::format("{} deg", header->lattice.latitude_step_deg))
        .expected("rows from the south to the north")
        .in(name);
  std::vector<float> values(count);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto value = std::bit_cast<float>(bits_at<std::uint32_t>(bytes, gtx_header_bytes + sizeof(float) * i));
    if (!std::isfinite(value))
      return core::error(fmt::format("value {} of the GTX file is not finite", i + 1))
          .found(fmt::format("{}", value))
          .expected("an undulation in m, or -88.8888 for none")
          .in(name);
    values[i] = std::abs(value - no_value) < 1e-3F ? std::numeric_limits<float>::quiet_NaN() : value;
  }
  GeoidLattice lattice = header->lattice;
  lattice.rows = static_cast<std::size_t>(header->rows);
  lattice.columns = static_cast<std::size_t>(header->columns);
  return geoid::grid_of(name, lattice, std::move(values));
}

}  // namespace sarsim::radar
