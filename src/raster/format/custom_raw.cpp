#include "raster/format/custom_raw.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <system_error>

#include <fmt/format.h>

#include "core/report/expect.hpp"
#include "raster/format/envi.hpp"
#include "raster/format/format_reader.hpp"
#include "raster/format/grid_raster.hpp"
#include "raster/format/raw_decode.hpp"
#include "raster/table/file_problem.hpp"

namespace sarsim::raster {

namespace {

struct NumberKind {
  RawNumber number;
  std::string_view name;
  std::size_t bytes;
};

constexpr std::array<NumberKind, 8> kinds{{
    {RawNumber::int8, "int8", 1},
    {RawNumber::uint8, "uint8", 1},
    {RawNumber::int16, "int16", 2},
    {RawNumber::uint16, "uint16", 2},
    {RawNumber::int32, "int32", 4},
    {RawNumber::uint32, "uint32", 4},
    {RawNumber::float32, "float32", 4},
    {RawNumber::float64, "float64", 8},
}};

const NumberKind& kind_of(RawNumber number) { return kinds[static_cast<std::size_t>(number)]; }

StoredGrid::Decoder decoder_of(const RawLayout& layout) {
  switch (layout.number) {
    case RawNumber::int8:
      return raw_decoder<std::int8_t>(layout.value == ImageValue::complex, layout.big_endian, layout.q_first);
    case RawNumber::uint8:
      return raw_decoder<std::uint8_t>(layout.value == ImageValue::complex, layout.big_endian, layout.q_first);
    case RawNumber::int16:
      return raw_decoder<std::int16_t>(layout.value == ImageValue::complex, layout.big_endian, layout.q_first);
    case RawNumber::uint16:
      return raw_decoder<std::uint16_t>(layout.value == ImageValue::complex, layout.big_endian, layout.q_first);
    case RawNumber::int32:
      return raw_decoder<std::int32_t>(layout.value == ImageValue::complex, layout.big_endian, layout.q_first);
    case RawNumber::uint32:
      return raw_decoder<std::uint32_t>(layout.value == ImageValue::complex, layout.big_endian, layout.q_first);
    case RawNumber::float32:
      return raw_decoder<float>(layout.value == ImageValue::complex, layout.big_endian, layout.q_first);
    case RawNumber::float64: break;
  }
  return raw_decoder<double>(layout.value == ImageValue::complex, layout.big_endian, layout.q_first);
}

std::string_view name_of(ImageValue value) {
  switch (value) {
    case ImageValue::complex: return "complex";
    case ImageValue::real: return "real";
    case ImageValue::magnitude: return "magnitude";
    case ImageValue::power: return "power";
    case ImageValue::rgb: break;
  }
  return "colour";
}

}  // namespace

std::size_t bytes_of(RawNumber number) { return kind_of(number).bytes; }
std::string_view name_of(RawNumber number) { return kind_of(number).name; }

std::string to_string(const RawLayout& layout) {
  std::string text = fmt::format("{} {}", name_of(layout.value), name_of(layout.number));
  if (bytes_of(layout.number) > 1) text += layout.big_endian ? ", big-endian" : ", little-endian";
  if (layout.offset != 0.0) text += fmt::format(", {} subtracted", layout.offset);
  if (layout.q_first && layout.value == ImageValue::complex) text += ", Q first";
  text += fmt::format(", {} samples of a row", layout.width);
  if (layout.header_bytes > 0) text += fmt::format(" after {} bytes", layout.header_bytes);
  return text;
}

core::Problems check_raw_layout(const RawLayout& layout, const std::string& file, std::uint64_t file_bytes) {
  core::Problems problems;
  if (layout.value == ImageValue::rgb)
    problems.push_back(file_problem(file, "colours are not supported in files without a description", {},
                                    "complex, real, magnitude or power"));
  if (!std::isfinite(layout.offset))
    problems.push_back(file_problem(file, "the offset is not a number", fmt::format("{}", layout.offset)));
  if (layout.width == 0)
    problems.push_back(file_problem(file, "the number of samples of a row is not known", "0", "1 or more"));
  if (layout.header_bytes >= file_bytes)
    problems.push_back(file_problem(file, "the file holds nothing after the header",
                                    fmt::format("{} bytes", file_bytes),
                                    fmt::format("more than {} bytes", layout.header_bytes)));
  if (core::has_errors(problems)) return problems;
  const std::uint64_t present = file_bytes - layout.header_bytes;
  const auto row = checked_product(layout.width, layout.sample_bytes());
  if (!row || *row > present) {
    problems.push_back(file_problem(file, "the file does not hold a single row", fmt::format("{} bytes", present),
                                    fmt::format("{} samples of {} bytes", layout.width, layout.sample_bytes()),
                                    "check the samples of a row, the type and the header"));
    return problems;
  }
  const std::uint64_t rows = present / *row;
  if (layout.height > rows)
    problems.push_back(with_severity(file_problem(file, "the file holds fewer rows", fmt::format("{}", rows),
                                                  fmt::format("{}", layout.height), "what is there is shown"),
                                     core::Severity::warning));
  const std::uint64_t wanted = layout.height > 0 ? std::min<std::uint64_t>(layout.height, rows) : rows;
  if (layout.height <= rows && present > wanted * *row)
    problems.push_back(with_severity(file_problem(file, "what follows the last row is not read",
                                                  fmt::format("{} bytes more", present - wanted * *row)),
                                     core::Severity::note));
  return problems;
}

std::size_t raw_rows(const RawLayout& layout, std::uint64_t file_bytes) {
  CORE_EXPECT(layout.width > 0);
  const std::uint64_t present = file_bytes - std::min(file_bytes, layout.header_bytes);
  const auto rows = static_cast<std::size_t>(present / (std::uint64_t{layout.width} * layout.sample_bytes()));
  return layout.height > 0 ? std::min(rows, layout.height) : rows;
}

StoredGrid grid_of(const RawLayout& layout) {
  CORE_EXPECT(layout.width > 0);
  CORE_EXPECT(layout.value != ImageValue::rgb);
  return {layout.header_bytes, layout.width, layout.sample_bytes(), decoder_of(layout), layout.offset};
}

OpenedRaster open_custom(core::InputFile file, const Format&, const RasterHints& hints, Integrity integrity,
                         const core::StopFlag*) {
  CORE_EXPECT(hints.raw.has_value());
  const RawLayout& layout = hints.raw.value();
  OpenedRaster opened{nullptr, check_raw_layout(layout, file.path().string(), file.size())};
  for (core::Problem& problem : opened.problems)
    if (integrity == Integrity::whole && problem.severity == core::Severity::warning) {
      problem.severity = core::Severity::error;
      problem.hint = "the file is cut off";
    }
  if (core::has_errors(opened.problems)) return opened;
  RasterInfo info = info_of(file, layout.width, {});
  info.value = layout.value;
  info.attributes = {{"layout", to_string(layout)}};
  const std::uint64_t most = layout.height > 0 ? layout.height : any_rows;
  opened.raster = make_grid_raster(std::move(info), std::move(file), grid_of(layout), most);
  return opened;
}

RawLayout layout_of(const EnviHeader& header) {
  RawLayout layout;
  layout.header_bytes = header.header_offset;
  layout.width = header.samples;
  layout.height = header.lines;
  layout.number = RawNumber::float32;
  layout.value = header.pixel == EnviHeader::Pixel::complex_float ? ImageValue::complex : ImageValue::magnitude;
  return layout;
}

std::optional<RawLayout> envi_layout(const std::filesystem::path& data) {
  // NumPy arrays say themselves what they are.
  if (data.extension() == ".npy") return std::nullopt;
  try {
    if (!has_envi_header(data)) return std::nullopt;
    const auto [image, problems] = EnviImage::open(data);
    if (image) return layout_of(image->header());
  } catch (const std::system_error&) {
    // Whoever opens the file says what the disk says.
  }
  return std::nullopt;
}

}  // namespace sarsim::raster
