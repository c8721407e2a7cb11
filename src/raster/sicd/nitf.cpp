#include "raster/sicd/nitf.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <span>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "core/report/invalid_request.hpp"
#include "core/text/number_text.hpp"
#include "radar/earth/ellipsoid.hpp"
#include "raster/table/file_problem.hpp"

namespace sarsim::raster {

namespace {

// Widths of what the headers have in common.
constexpr std::size_t security_bytes = 167;  // FSCLAS to FSCTLN.
constexpr std::size_t xml_header_bytes = 773;
constexpr std::uint64_t max_segment_bytes = 9'999'999'998;
constexpr std::size_t max_rows_of_several = 99'999;
constexpr std::size_t max_block = 8192;
constexpr std::size_t pixel_bytes = 8;

// What is wrong with a header, before it is known which file it is of.
struct HeaderFailure {
  std::string message;
  std::string found;
  std::string expected;
};

std::string trimmed(std::string_view text) {
  const std::size_t end = text.find_last_not_of(' ');
  return std::string(text.substr(0, end == std::string_view::npos ? 0 : end + 1));
}

// Takes the fields of a header one after the other.
class HeaderReader {
 public:
  HeaderReader(std::string_view bytes, std::string name) : bytes_(bytes), name_(std::move(name)) {}

  std::string_view take(std::size_t count, const char* field) {
    if (bytes_.size() - at_ < count)
      throw HeaderFailure{fmt::format("{} ends within its field {}", name_, field),
                          fmt::format("{} bytes", bytes_.size()), fmt::format("{} or more", at_ + count)};
    const std::string_view text = bytes_.substr(at_, count);
    at_ += count;
    return text;
  }
  std::string text(std::size_t count, const char* field) { return trimmed(take(count, field)); }
  void skip(std::size_t count, const char* field) { take(count, field); }
  std::uint64_t number(std::size_t count, const char* field) {
    const std::string_view text = take(count, field);
    std::uint64_t value = 0;
    for (const char digit : text) {
      if (digit < '0' || digit > '9')
        throw HeaderFailure{fmt::format("the field {} of {} is not a number", field, name_), std::string(text),
                            fmt::format("{} digits", count)};
      value = 10 * value + static_cast<std::uint64_t>(digit - '0');
    }
    return value;
  }
  [[nodiscard]] std::size_t left() const { return bytes_.size() - at_; }

 private:
  std::string_view bytes_;
  std::string name_;
  std::size_t at_ = 0;
};

// A segment as the file's header counts it.
struct Part {
  std::uint64_t header = 0;
  std::uint64_t data = 0;
};

// The lengths of all segments of a kind: as many pairs of numbers as the field before them says.
std::vector<Part> parts_of(HeaderReader& reader, std::size_t header_digits, std::size_t data_digits, const char* kind) {
  std::vector<Part> parts(reader.number(3, kind));
  for (Part& part : parts) {
    part.header = reader.number(header_digits, kind);
    part.data = reader.number(data_digits, kind);
  }
  return parts;
}

std::string bytes_at(const core::InputFile& file, std::uint64_t offset, std::uint64_t count) {
  std::string bytes(static_cast<std::size_t>(count), '\0');
  file.read_all_at(offset, std::as_writable_bytes(std::span(bytes)));
  return bytes;
}

void skip_colour_tables(HeaderReader& reader) {
  const std::size_t tables = reader.number(1, "NLUTS");
  if (tables > 0) reader.skip(tables * reader.number(5, "NELUT"), "LUTD");
}

NitfImage read_image_header(std::string_view bytes, std::size_t number) {
  HeaderReader reader(bytes, fmt::format("the header of image segment {}", number + 1));
  NitfImage image;
  if (reader.take(2, "IM") != "IM")
    throw HeaderFailure{fmt::format("image segment {} has no image header", number + 1),
                        std::string(bytes.substr(0, 2)), "IM"};
  image.id = reader.text(10, "IID1");
  reader.skip(14 + 17 + 80 + security_bytes + 1 + 42, "ISORCE");
  image.rows = reader.number(8, "NROWS");
  image.columns = reader.number(8, "NCOLS");
  image.kind = reader.text(3, "PVTYPE");
  reader.skip(8 + 8 + 2 + 1, "PJUST");
  if (reader.take(1, "ICORDS") != " ") reader.skip(60, "IGEOLO");
  reader.skip(80 * reader.number(1, "NICOM"), "ICOM");
  image.compression = reader.text(2, "IC");
  if (image.compression != "NC" && image.compression != "NM") reader.skip(4, "COMRAT");
  image.bands = reader.number(1, "NBANDS");
  if (image.bands == 0) image.bands = reader.number(5, "XBANDS");
  for (std::size_t band = 0; band < image.bands; ++band) {
    reader.skip(2 + 6 + 1 + 3, "IMFLT");
    skip_colour_tables(reader);
  }
  reader.skip(1, "ISYNC");
  image.mode = reader.take(1, "IMODE").front();
  const std::uint64_t blocks = reader.number(4, "NBPR") * reader.number(4, "NBPC");
  reader.skip(4 + 4, "NPPBV");
  image.one_block = blocks == 1;
  image.bits = reader.number(2, "NBPP");
  return image;
}

NitfExtension read_extension_header(std::string_view bytes, std::size_t number) {
  HeaderReader reader(bytes, fmt::format("the header of data extension {}", number + 1));
  NitfExtension extension;
  if (reader.take(2, "DE") != "DE")
    throw HeaderFailure{fmt::format("data extension {} has no header of one", number + 1),
                        std::string(bytes.substr(0, 2)), "DE"};
  extension.id = reader.text(25, "DESID");
  reader.skip(2 + security_bytes, "DESCTLN");
  if (extension.id == "TRE_OVERFLOW") reader.skip(6 + 3, "DESITEM");
  const std::size_t own = reader.number(4, "DESSHL");
  if (own < xml_header_bytes) return extension;
  reader.skip(5 + 8 + 20 + 40 + 60 + 10 + 20, "DESSHSD");
  extension.schema = reader.text(120, "DESSHTN");
  return extension;
}

// Goes through the segments of one kind.
template <class Take>
void each_part(const core::InputFile& file, const std::vector<Part>& parts, std::uint64_t& at, const char* kind,
               const Take& take) {
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::uint64_t end = at + parts[i].header + parts[i].data;  // At most 10^6 + 10^10 each, of 999.
    if (end > file.size())
      throw HeaderFailure{fmt::format("the file ends within {} {}", kind, i + 1), fmt::format("{} bytes", file.size()),
                          fmt::format("{} or more", end)};
    take(i, at, at + parts[i].header, parts[i]);
    at = end;
  }
}

NitfFile read_segments(const core::InputFile& file) {
  constexpr std::size_t fixed_bytes = 360;  // Up to the number of image segments.
  constexpr std::size_t header_length_at = 354;
  if (file.size() < fixed_bytes)
    throw HeaderFailure{"the file ends within its header", fmt::format("{} bytes", file.size()),
                        fmt::format("{} or more", fixed_bytes)};
  const std::string fixed = bytes_at(file, 0, fixed_bytes);
  HeaderReader begin(fixed, "the file's header");
  const std::string_view version = begin.take(nitf_signature.size(), "FHDR");
  if (version != nitf_signature && version != "NSIF01.00")
    throw HeaderFailure{"the file is of another version of NITF", std::string(version), std::string(nitf_signature)};
  constexpr std::size_t file_length_at = 342;
  constexpr std::size_t file_length_digits = header_length_at - file_length_at;
  begin.skip(file_length_at - nitf_signature.size(), "FL");
  const std::string_view file_length = begin.take(file_length_digits, "FL");
  const std::uint64_t length = begin.number(6, "HL");
  if (length > file.size() || length < fixed_bytes)
    throw HeaderFailure{"the length of the file's header (HL) cannot be right", fmt::format("{}", length),
                        fmt::format("{} to {} bytes", fixed_bytes, file.size())};
  const std::string header = bytes_at(file, 0, length);
  HeaderReader reader(header, "the file's header");
  reader.skip(fixed_bytes, "HL");
  const std::vector<Part> images = parts_of(reader, 6, 10, "NUMI");
  const std::vector<Part> graphics = parts_of(reader, 4, 6, "NUMS");
  if (reader.number(3, "NUMX") != 0) throw HeaderFailure{"the reserved field NUMX is not 0", {}, "000"};
  const std::vector<Part> texts = parts_of(reader, 4, 5, "NUMT");
  const std::vector<Part> extensions = parts_of(reader, 4, 9, "NUMDES");
  NitfFile found;
  // Nines: written before it was known.
  if (file_length.find_first_not_of("0123456789") == std::string_view::npos && file_length != "999999999999")
    found.length = static_cast<std::uint64_t>(core::parse_integer(file_length).value_or(0));
  std::uint64_t at = length;
  each_part(file, images, at, "image segment",
            [&](std::size_t i, std::uint64_t start, std::uint64_t data, const Part& part) {
              NitfImage image = read_image_header(bytes_at(file, start, part.header), i);
              image.offset = data;
              image.length = part.data;
              found.images.push_back(std::move(image));
            });
  const auto pass = [](std::size_t, std::uint64_t, std::uint64_t, const Part&) {};
  each_part(file, graphics, at, "graphic segment", pass);
  each_part(file, texts, at, "text segment", pass);
  each_part(file, extensions, at, "data extension",
            [&](std::size_t i, std::uint64_t start, std::uint64_t data, const Part& part) {
              NitfExtension extension = read_extension_header(bytes_at(file, start, part.header), i);
              extension.offset = data;
              extension.length = part.data;
              found.extensions.push_back(std::move(extension));
            });
  found.end = at;
  return found;
}

// Appends the fields of a header.
class HeaderWriter {
 public:
  /// A text with blanks behind it; what is too long is cut, what is not ASCII becomes '?'.
  void text(std::string_view value, std::size_t count) {
    std::string field(value.substr(0, count));
    for (char& c : field)
      if (c < ' ' || c > '~') c = '?';
    field.resize(count, ' ');
    bytes_ += field;
  }
  void number(std::uint64_t value, std::size_t count) { bytes_ += fmt::format("{:0{}}", value, count); }
  /// Unclassified, and nothing else.
  void security() {
    text("U", 1);
    text("", security_bytes - 1);
  }
  [[nodiscard]] std::string bytes() && { return std::move(bytes_); }

 private:
  std::string bytes_;
};

// "340812S" of a latitude, "0183012E" of a longitude: whole seconds of arc.
std::string degrees_text(double degrees, std::size_t digits, char positive, char negative) {
  const auto seconds = static_cast<long long>(std::llround(std::abs(degrees) * 3600.0));
  return fmt::format("{:0{}}{:02}{:02}{}", seconds / 3600, digits, seconds / 60 % 60, seconds % 60,
                     degrees < 0.0 ? negative : positive);
}

using Corners = std::array<NitfCorner, 4>;

std::string corners_text(const Corners& corners) {
  std::string text;
  for (const NitfCorner& corner : corners)
    text += degrees_text(corner.latitude_deg, 2, 'N', 'S') + degrees_text(corner.longitude_deg, 3, 'E', 'W');
  return text;
}

// The corners of some rows: between those of the image on straight lines through the Earth (SICD Volume 2, 3.2).
Corners corners_of_rows(const NitfContent& content, std::size_t first, std::size_t next) {
  const auto between = [&](std::size_t from, std::size_t to, std::size_t row) {
    const double part = static_cast<double>(row) / std::max(1.0, static_cast<double>(content.rows) - 1.0);
    const auto& a = content.corners_ecf_m[from];
    const auto& b = content.corners_ecf_m[to];
    const radar::Geodetic place = radar::geodetic_of(
        core::Vec3{a[0] + part * (b[0] - a[0]), a[1] + part * (b[1] - a[1]), a[2] + part * (b[2] - a[2])});
    constexpr double deg = 57.29577951308232;
    return NitfCorner{deg * place.latitude_rad, deg * place.longitude_rad};
  };
  if (first == 0 && next >= content.rows) return content.corners;
  const std::size_t last = std::min(next, content.rows - 1);
  return {between(0, 3, first), between(1, 2, first), between(1, 2, last), between(0, 3, last)};
}

std::string image_header(const NitfContent& content, const NitfRows& rows, std::size_t number, std::size_t of,
                         std::size_t rows_before) {
  HeaderWriter header;
  header.text("IM", 2);
  header.text(of == 1 ? "SICD000" : fmt::format("SICD{:03}", number + 1), 10);
  header.text(content.date, 14);
  header.text("", 17);
  header.text(content.title, 80);
  header.security();
  header.number(0, 1);  // ENCRYP
  header.text(content.source, 42);
  header.number(rows.count, 8);
  header.number(content.columns, 8);
  header.text("R", 3);
  header.text("NODISPLY", 8);
  header.text("SAR", 8);
  header.number(32, 2);  // ABPP
  header.text("R", 1);   // PJUST
  header.text("G", 1);   // ICORDS
  header.text(corners_text(corners_of_rows(content, rows.first, rows.first + rows.count)), 60);
  header.number(0, 1);  // NICOM
  header.text("NC", 2);
  header.number(2, 1);  // NBANDS
  for (const char* component : {"I", "Q"}) {
    header.text("", 2);
    header.text(component, 6);
    header.text("N", 1);
    header.text("", 3);
    header.number(0, 1);
  }
  header.number(0, 1);  // ISYNC
  header.text("P", 1);
  header.number(1, 4);
  header.number(1, 4);
  header.number(content.columns > max_block ? 0 : content.columns, 4);
  header.number(rows.count > max_block ? 0 : rows.count, 4);
  header.number(32, 2);          // NBPP
  header.number(number + 1, 3);  // IDLVL
  header.number(number, 3);      // IALVL
  header.number(rows_before, 5);
  header.number(0, 5);
  header.text("1.0", 4);  // IMAG
  header.number(0, 5);    // UDIDL
  header.number(0, 5);    // IXSHDL
  return std::move(header).bytes();
}

std::string extension_header(const NitfContent& content) {
  HeaderWriter header;
  header.text("DE", 2);
  header.text("XML_DATA_CONTENT", 25);
  header.number(1, 2);
  header.security();
  header.number(xml_header_bytes, 4);
  header.number(99999, 5);  // DESCRC: not computed.
  header.text("XML", 8);
  const std::string& t = content.date;
  header.text(fmt::format("{}-{}-{}T{}:{}:{}Z", t.substr(0, 4), t.substr(4, 2), t.substr(6, 2), t.substr(8, 2),
                          t.substr(10, 2), t.substr(12, 2)),
              20);
  header.text("", 40);
  header.text(content.schema_title, 60);
  header.text(content.schema_version, 10);
  header.text(content.schema_date, 20);
  header.text(content.schema, 120);
  std::string outline;
  for (const std::size_t corner : {0U, 1U, 2U, 3U, 0U})
    outline += fmt::format("{:+012.8f}{:+013.8f}", content.corners[corner].latitude_deg,
                           content.corners[corner].longitude_deg);
  header.text(outline, 125);
  header.text("", 25 + 20 + 120 + 200);
  return std::move(header).bytes();
}

// 2048, 8192 and 65536 rows or columns, and 50 MB, 1 GB, 2 GB and 10 GB, bound the levels of complexity.
int complexity_level(const NitfContent& content, std::uint64_t bytes) {
  struct Level {
    int level;
    std::size_t most;
    std::uint64_t bytes;
  };
  constexpr Level levels[] = {
      {3, 2048, 52'428'799}, {5, 8192, 1'073'741'823}, {6, 65'536, 2'147'483'647}, {7, 99'999'999, 10'737'418'239}};
  for (const Level& level : levels)
    if (std::max(content.rows, content.columns) <= level.most && bytes <= level.bytes) return level.level;
  return 9;
}

std::string file_header(const NitfContent& content, const std::vector<Part>& images, const Part& extension,
                        std::uint64_t size, std::size_t length) {
  HeaderWriter header;
  header.text(nitf_signature, nitf_signature.size());
  header.number(static_cast<std::uint64_t>(complexity_level(content, size)), 2);
  header.text("BF01", 4);
  header.text("SARSIM", 10);  // OSTAID
  header.text(content.date, 14);
  header.text(content.title, 80);
  header.security();
  header.number(0, 5);    // FSCOP
  header.number(0, 5);    // FSCPYS
  header.number(0, 1);    // ENCRYP
  header.text("   ", 3);  // FBKGC, three bytes of colour.
  header.text("", 24);
  header.text("", 18);
  header.number(size, 12);
  header.number(length, 6);
  header.number(images.size(), 3);
  for (const Part& image : images) {
    header.number(image.header, 6);
    header.number(image.data, 10);
  }
  header.number(0, 3);
  header.number(0, 3);
  header.number(0, 3);
  header.number(1, 3);
  header.number(extension.header, 4);
  header.number(extension.data, 9);
  header.number(0, 3);
  header.number(0, 5);
  header.number(0, 5);
  return std::move(header).bytes();
}

[[noreturn]] void refuse_size(const NitfContent& content, const char* limit) {
  throw core::InvalidRequest(
      fmt::format("an image of {} x {} pixels is too large for NITF: {}", content.rows, content.columns, limit),
      "focus a smaller area with --azimuth and --range, or name the output .img");
}

}  // namespace

std::variant<NitfFile, core::Problem> read_nitf(const core::InputFile& file) {
  try {
    return read_segments(file);
  } catch (const HeaderFailure& failure) {
    return file_problem(file.path().string(), failure.message, failure.found, failure.expected);
  }
}

std::size_t nitf_rows_of_segment(std::size_t rows, std::size_t columns) {
  const auto bytes = checked_product(rows, columns, pixel_bytes);
  if (bytes && *bytes <= max_segment_bytes) return rows;
  const std::uint64_t by_bytes = max_segment_bytes / (std::uint64_t{columns} * pixel_bytes);
  return static_cast<std::size_t>(std::min<std::uint64_t>(by_bytes, max_rows_of_several));
}

NitfLayout lay_out_nitf(const NitfContent& content) {
  constexpr std::size_t max_columns = 99'999'999;
  constexpr std::size_t max_segments = 999;
  constexpr std::uint64_t max_bytes = 999'999'999'998;
  if (content.columns > max_columns || content.rows > max_columns)
    refuse_size(content, "it has 99 999 999 rows and columns at most");
  const std::size_t at_once = nitf_rows_of_segment(content.rows, content.columns);
  const std::size_t count = (content.rows + at_once - 1) / at_once;
  if (count > max_segments) refuse_size(content, "it has 999 segments of 10 GB at most");
  NitfLayout layout;
  std::vector<std::string> headers;
  std::vector<Part> images;
  for (std::size_t i = 0; i < count; ++i) {
    const NitfRows rows{i * at_once, std::min(at_once, content.rows - i * at_once), 0};
    headers.push_back(image_header(content, rows, i, count, i == 0 ? 0 : at_once));
    images.push_back({headers.back().size(), std::uint64_t{rows.count} * content.columns * pixel_bytes});
    layout.segments.push_back(rows);
  }
  const std::string last = extension_header(content);
  const Part extension{last.size(), content.xml.size()};
  const std::size_t length = file_header(content, images, extension, 0, 0).size();
  std::uint64_t at = length;
  for (std::size_t i = 0; i < count; ++i) {
    layout.texts.emplace_back(at, headers[i]);
    layout.segments[i].offset = at + images[i].header;
    at += images[i].header + images[i].data;
  }
  layout.texts.emplace_back(at, last + content.xml);
  layout.size = at + extension.header + extension.data;
  if (layout.size > max_bytes) refuse_size(content, "it has 1 TB at most");
  layout.texts.emplace(layout.texts.begin(), 0, file_header(content, images, extension, layout.size, length));
  return layout;
}

}  // namespace sarsim::raster
