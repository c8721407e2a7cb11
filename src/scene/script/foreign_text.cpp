#include "scene/script/foreign_text.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "core/text/letters.hpp"
#include "core/text/number_text.hpp"
#include "core/text/separated.hpp"
#include "scene/model/scene.hpp"

namespace sarsim::scene {

namespace {

constexpr const char* see_info = "sarsim info FILE shows what it contains; name the scene that made it";
constexpr const char* as_toml = "write it as TOML that begins with format = \"sarsim 2\" (sarsim new A.toml)";

// How content begins, what that is, and what to do.
struct Signature {
  std::string_view bytes;
  const char* kind;
  const char* hint;
};

using std::string_view_literals::operator""sv;

constexpr Signature signatures[] = {
    {"\x89PNG\r\n"sv, "a PNG picture", ""},
    {"\x89HDF\r\n\x1a\n"sv, "an HDF5 file", see_info},
    {"MATLAB 5.0 MAT-file"sv, "a MATLAB file (.mat, version 5)", "save it as text, or write a scene"},
    {"MATLAB 7.3 MAT-file"sv, "a MATLAB file (.mat, version 7.3, HDF5)", see_info},
    {"\x93NUMPY"sv, "a NumPy array", see_info},
    {"CPHD/"sv, "a CPHD file", see_info},
    {"CRSD/"sv, "a CRSD file", see_info},
    {"NITF0"sv, "a NITF file", see_info},
    {"CDF\x01"sv, "a NetCDF file", see_info},
    {"CDF\x02"sv, "a NetCDF file", see_info},
    {"\x1f\x8b"sv, "a gzip file", "unpack it first: gunzip FILE"},
    {"BZh"sv, "a bzip2 file", "unpack it first: bunzip2 FILE"},
    {"\xFD"
     "7zXZ"sv,
     "an xz file", "unpack it first: unxz FILE"},
    {"\x28\xB5\x2F\xFD"sv, "a zstd file", "unpack it first: unzstd FILE"},
    {"7z\xBC\xAF"sv, "a 7z archive", "unpack it first"},
    {"\x7f"
     "ELF"sv,
     "a program (ELF)", ""},
    {"MZ\x90"sv, "a program (EXE)", ""},
    {"%PDF-"sv, "a PDF document", ""},
    {"%!PS"sv, "a PostScript document", ""},
    {"II*\0"sv, "a TIFF picture, perhaps GeoTIFF", "gdal_translate -of ENVI makes an image that can be read"},
    {"MM\0*"sv, "a TIFF picture, perhaps GeoTIFF", "gdal_translate -of ENVI makes an image that can be read"},
    {"\xFF\xD8\xFF"sv, "a JPEG picture", ""},
    {"GIF8"sv, "a GIF picture", ""},
    {"\x59\xa6\x6a\x95"sv, "a Sun raster picture", see_info},
    {"SQLite format 3"sv, "an SQLite database", ""},
    {"PAR1"sv, "a Parquet table", "save it as CSV and name it in a [[cloud]]"},
    {"\x80\x04\x95"sv, "a Python pickle", "write a scene: sarsim.Scene.save in Python"},
    {"ENVI\n"sv, "the header of an ENVI image", see_info},
    {"ENVI\r\n"sv, "the header of an ENVI image", see_info},
    {"\xFF\xFE"sv, "text in UTF-16", "save it as UTF-8 or ASCII"},
    {"\xFE\xFF"sv, "text in UTF-16", "save it as UTF-8 or ASCII"},
};

std::optional<Signature> signature_of(std::string_view content) {
  const auto* const found =
      std::ranges::find_if(signatures, [&](const Signature& s) { return content.starts_with(s.bytes); });
  if (found != std::end(signatures)) return *found;
  if (content.starts_with("PK\x03\x04"sv)) {
    const std::string_view begin = content.substr(0, 256);
    if (begin.find(".npy") != begin.npos)
      return Signature{"", "NumPy arrays in a ZIP archive (.npz)",
                       "save one array: numpy.save('a.npy', arrays['NAME'])"};
    if (begin.find("[Content_Types]") != begin.npos || begin.find("mimetype") != begin.npos)
      return Signature{"", "an office document (ZIP)", "save it as text"};
    return Signature{"", "a ZIP archive", "unpack it first: unzip FILE"};
  }
  constexpr std::size_t tar_mark = 257;
  if (content.size() > tar_mark + 5 && content.substr(tar_mark, 5) == "ustar")
    return Signature{"", "a tar archive", "unpack it first: tar xf FILE"};
  constexpr std::size_t user_block = 512;  // Of MATLAB's HDF5 files, and of others.
  if (content.size() > user_block && content.substr(user_block).starts_with("\x89HDF\r\n"sv))
    return Signature{"", "an HDF5 file", see_info};
  return std::nullopt;
}

// Lines without blanks at their ends, the empty ones left out; as many as tell.
std::vector<std::string_view> first_lines(std::string_view content) {
  constexpr std::size_t most = 200;
  std::vector<std::string_view> lines;
  content = content.substr(0, std::size_t{1} << 16U);
  while (!content.empty() && lines.size() < most) {
    const std::size_t end = std::min(content.find_first_of("\r\n"), content.size());
    if (const std::string_view line = core::trimmed(content.substr(0, end)); !line.empty()) lines.push_back(line);
    content.remove_prefix(std::min(end + 1, content.size()));
  }
  return lines;
}

template <class Test>
double share_of(const std::vector<std::string_view>& lines, const Test& test) {
  return static_cast<double>(std::ranges::count_if(lines, test)) /
         static_cast<double>(std::max<std::size_t>(lines.size(), 1));
}

bool is_name_letter(char c) { return core::is_digit(c) || core::is_letter(c) || c == '_' || c == '-' || c == '.'; }

// "key: value", "- item" or a comment.
bool is_yaml_line(std::string_view line) {
  if (line.starts_with("- ") || line == "-" || line.starts_with('#') || line == "---") return true;
  const std::size_t colon = line.find(':');
  if (colon == std::string_view::npos || colon == 0) return false;
  if (colon + 1 < line.size() && line[colon + 1] != ' ') return false;
  return std::ranges::all_of(line.substr(0, colon),
                             [](char c) { return is_name_letter(c) || c == ' ' || c == '"' || c == '\''; });
}

bool is_number_list(std::string_view line, char separator, std::size_t& columns) {
  const std::vector<std::string_view> pieces = core::pieces_of(line, separator);
  columns = pieces.size();
  return std::ranges::all_of(pieces, [](std::string_view piece) { return core::parse_number(piece).has_value(); });
}

// A table: most lines are numbers, as many in each. The first one may be a title.
bool is_table(const std::vector<std::string_view>& lines, char separator) {
  std::size_t columns = 0;
  std::size_t tables = 0;
  for (const std::string_view line : lines) {
    std::size_t found = 0;
    if (!is_number_list(line, separator, found) || found < 2) continue;
    if (columns == 0) columns = found;
    tables += found == columns ? 1 : 0;
  }
  return tables >= 1 && 2 * tables >= lines.size();
}

// A title and rows of as many cells, numbers or not.
bool is_csv(const std::vector<std::string_view>& lines) {
  if (lines.size() < 2) return false;
  const auto commas = [](std::string_view line) { return std::ranges::count(line, ','); };
  const auto wanted = commas(lines.front());
  return wanted > 0 && std::ranges::all_of(lines, [&](std::string_view line) { return commas(line) == wanted; });
}

std::string markup_of(std::string_view content) {
  const std::string begin = core::lower_case(content.substr(0, 4096));
  for (const auto& [mark, kind] :
       {std::pair("<kml", "KML"), std::pair("<gpx", "GPX"), std::pair("<svg", "an SVG picture"),
        std::pair("<html", "HTML"), std::pair("<!doctype html", "HTML"),
        std::pair("<simulation", "XML, perhaps a scene of FERS")})
    if (begin.find(mark) != std::string::npos) return kind;
  return "XML";
}

bool has_line(const std::vector<std::string_view>& lines, std::initializer_list<std::string_view> beginnings) {
  return std::ranges::any_of(lines, [&](std::string_view line) {
    return std::ranges::any_of(beginnings, [&](std::string_view begin) { return line.starts_with(begin); });
  });
}

// Orbits and programs are told by words that each of them has.
std::string known_text(const std::vector<std::string_view>& lines) {
  const std::string_view first = lines.front();
  if (first.starts_with("#!")) return first.find("python") != first.npos ? "a Python program" : "a shell script";
  if (first.starts_with("CCSDS_")) return "an orbit or attitude file of CCSDS";
  if (has_line(lines, {"#c", "#d"}) && has_line(lines, {"+ "}) && has_line(lines, {"* "})) return "an orbit file (SP3)";
  constexpr std::size_t tle_columns = 69;
  const auto is_tle = [](std::string_view line) {
    return line.size() == tle_columns && (line.starts_with("1 ") || line.starts_with("2 "));
  };
  if (std::ranges::any_of(lines, is_tle)) return "orbital elements (TLE)";
  const auto is_python = [](std::string_view line) {
    return line.starts_with("import ") || line.starts_with("print(") ||
           ((line.starts_with("def ") || line.starts_with("class ")) && line.ends_with(':')) ||
           (line.starts_with("from ") && line.find(" import ") != line.npos);
  };
  if (std::ranges::any_of(lines, is_python)) return "a Python program";
  if (has_line(lines, {"#include", "#pragma", "int main"})) return "a C or C++ source";
  const auto ends_as_statement = [](std::string_view line) {
    return line.ends_with(';') && line.find('=') != std::string_view::npos;
  };
  const double statements = share_of(lines, ends_as_statement);
  if (has_line(lines, {"function ", "clear all", "close all", "clc;"}) || statements >= 0.5 ||
      (has_line(lines, {"%"}) && statements > 0.0))
    return "a MATLAB program";
  if (has_line(lines, {"\\documentclass", "\\begin{"})) return "LaTeX";
  return {};
}

std::string guess_of_text(std::string_view content) {
  if (content.starts_with("\xEF\xBB\xBF")) content.remove_prefix(3);
  const std::vector<std::string_view> lines = first_lines(content);
  if (lines.empty()) return "an empty file";
  if (lines.front().starts_with('<')) return markup_of(content);
  if (lines.front().starts_with('{')) return "JSON";
  if (std::string known = known_text(lines); !known.empty()) return known;
  const bool bracket = lines.front().starts_with('[');
  if (bracket && (lines.front().size() == 1 || lines.front().find_first_of("{,\"") != std::string_view::npos))
    return "JSON";
  if (is_table(lines, ',') || is_table(lines, ';')) return "a table of numbers (CSV)";
  if (is_table(lines, '\t') || is_table(lines, ' ')) return "a table of numbers";
  constexpr double max_lines = 0.8;
  std::vector<std::string_view> bare;
  std::ranges::copy_if(lines, std::back_inserter(bare), [](std::string_view line) { return !line.starts_with('#'); });
  const bool yaml = lines.front() == "---" || lines.front().starts_with("%YAML") ||
                    (!bare.empty() && share_of(bare, is_yaml_line) >= max_lines);
  if (yaml) return "YAML";
  const bool sections = std::ranges::any_of(lines, [](std::string_view line) {
    return line.starts_with('[') && line.ends_with(']') && !line.starts_with("[[");
  });
  const auto is_assignment = [](std::string_view line) { return line.find('=') != std::string_view::npos; };
  if (sections && share_of(lines, is_assignment) > 0.0) return "an INI file";
  if (is_csv(lines)) return "a table (CSV)";
  return {};
}

bool is_text(std::string_view content) {
  const auto is_control = [](char c) {
    return (static_cast<unsigned char>(c) < 0x20U && c != '\n' && c != '\r' && c != '\t' && c != '\f' && c != '\x1a') ||
           c == '\x7f';
  };
  return std::ranges::none_of(content.substr(0, std::size_t{1} << 16U), is_control);
}

struct Guess {
  std::string kind;
  std::string hint;
};

Guess guess_with_hint(std::string_view content) {
  if (content.empty()) return {"an empty file", "sarsim new A.toml writes a scene to begin with"};
  if (const auto signature = signature_of(content)) return {signature->kind, signature->hint};
  if (!is_text(content)) return {"binary data", see_info};
  std::string kind = guess_of_text(content);
  if (kind == "an empty file") return {kind, "sarsim new A.toml writes a scene to begin with"};
  if (kind.starts_with("a table"))
    return {kind, "samples: sarsim info FILE; points of targets: name it as the file of a [[cloud]]"};
  if (kind.starts_with("an orbit") || kind.starts_with("orbital"))
    return {kind, "name it as the file of a platform's orbit (sarsim explain platform.orbit)"};
  if (kind == "a Python program" || kind == "a shell script")
    return {kind, "run it, and name the scene that it writes"};
  return {std::move(kind), as_toml};
}

}  // namespace

std::string guess_of_content(std::string_view content) { return guess_with_hint(content).kind; }

bool is_known_format(std::string_view content) {
  const auto signature = signature_of(content);
  return signature && !std::string_view(signature->kind).starts_with("text");
}

core::Problem no_scene(std::string_view content, const std::string& file) {
  Guess guess = guess_with_hint(content);
  return core::error(guess.kind.empty() ? std::string("this is no scene: it has no command")
                                        : fmt::format("this is no scene: it seems to be {}", guess.kind))
      .expected("TOML with format = \"sarsim 2\", the same as JSON, or a script with commands such as $PLATFORM")
      .hint(std::move(guess.hint))
      .in(file);
}

}  // namespace sarsim::scene
