#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/os/input_file.hpp"
#include "core/report/problem.hpp"

/// The container NITF 2.1 (MIL-STD-2500C; NSIF 1.0 is the same), as far as images of one block without compression and
/// extensions that hold a text need it (docs/formats/sicd.md).
namespace sarsim::raster {

/// The beginning of every file of NITF 2.1.
inline constexpr std::string_view nitf_signature = "NITF02.10";
/// As much of it as tells the format from others.
inline constexpr std::string_view nitf_begin = nitf_signature.substr(0, 4);

/// An image segment of a file.
struct NitfImage {
  std::string id;           ///< IID1.
  std::string kind;         ///< PVTYPE: "R" numbers of IEEE 754, "SI" signed integers, "INT" unsigned ones.
  std::string compression;  ///< IC: "NC" none.
  std::size_t rows = 0;
  std::size_t columns = 0;
  std::size_t bits = 0;   ///< NBPP: of a number.
  std::size_t bands = 0;  ///< Numbers of a pixel.
  char mode = 'B';        ///< IMODE: 'P' the numbers of a pixel lie together.
  bool one_block = true;
  std::uint64_t offset = 0;  ///< Of its first byte in the file.
  std::uint64_t length = 0;  ///< Bytes.
};

/// An extension that holds data (DES).
struct NitfExtension {
  std::string id;      ///< DESID: "XML_DATA_CONTENT".
  std::string schema;  ///< DESSHTN, the name space of an XML text; empty where it says none.
  std::uint64_t offset = 0;
  std::uint64_t length = 0;
};

/// What a file holds.
struct NitfFile {
  std::vector<NitfImage> images;
  std::vector<NitfExtension> extensions;
  std::optional<std::uint64_t> length;  ///< FL, of the file; nothing where the header leaves it open.
  std::uint64_t end = 0;                ///< Behind the last segment that the header names.
};

/// Reads the headers of a file, each once, in the order of the file. Segments that are neither images nor data
/// extensions are passed over. The problem says which field holds what it may not, or that the file ends too soon:
/// every segment that is returned lies within the file.
[[nodiscard]] std::variant<NitfFile, core::Problem> read_nitf(const core::InputFile& file);

/// A place of a corner, degrees.
struct NitfCorner {
  double latitude_deg = 0.0;
  double longitude_deg = 0.0;
};

/// What is said of an image of complex floats that goes into a file of its own.
struct NitfContent {
  std::size_t rows = 0;
  std::size_t columns = 0;
  std::string date;   ///< CCYYMMDDhhmmss: of the image, and of the file, which says no other.
  std::string title;  ///< Of file and image.
  std::string source;
  std::array<NitfCorner, 4> corners;  ///< First row first column, first row last column, last row last, last row first.
  std::array<std::array<double, 3>, 4> corners_ecf_m;  ///< The same on the ellipsoid: segments share their corners.
  std::string schema;                                  ///< Name space of the XML text.
  std::string schema_title;                            ///< Of the document that describes it.
  std::string schema_version;
  std::string schema_date;  ///< As ISO 8601.
  std::string xml;
};

/// Rows of an image that lie in one segment.
struct NitfRows {
  std::size_t first = 0;
  std::size_t count = 0;
  std::uint64_t offset = 0;  ///< Of its first byte in the file.
};

/// A file that is laid out: everything but its pixels, and where these go.
struct NitfLayout {
  /// Bytes and where they stand: headers before the pixels of each segment, the text behind the last one.
  std::vector<std::pair<std::uint64_t, std::string>> texts;
  std::vector<NitfRows> segments;
  std::uint64_t size = 0;  ///< Of the file.
};

/// How many rows a segment of an image holds at most: segments have no more than 9 999 999 998 bytes and, where there
/// are several, 99 999 rows (SICD Volume 2, 3.2). All of them where one segment is enough.
[[nodiscard]] std::size_t nitf_rows_of_segment(std::size_t rows, std::size_t columns);

/// Lays a file out: image segments of complex numbers of two 32-bit floats, most significant byte first, I before Q,
/// then the text. Throws core::InvalidRequest for what the format cannot hold: 10^12 bytes, 999 segments, 99 999 999
/// columns.
[[nodiscard]] NitfLayout lay_out_nitf(const NitfContent& content);

}  // namespace sarsim::raster
