#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/maths/constants.hpp"
#include "core/text/number_text.hpp"
#include "core/text/quoted_word.hpp"
#include "scene/edit/import_targets.hpp"
#include "scene/model/limits.hpp"
#include "scene/model/world_frame.hpp"
#include "workflow/input/cloud_table.hpp"

namespace sarsim::workflow {

namespace {

using scene::TargetColumns;

constexpr std::size_t piece_bytes = std::size_t{1} << 22;
constexpr std::size_t heading_bytes = std::size_t{1} << 16;
constexpr std::size_t longest_line = std::size_t{1} << 16;  // of a point: anything longer is another kind of file
constexpr std::size_t rcs_quantity = 3;

// The points of some lines.
struct TextPiece {
  radar::PointArrays arrays;
  std::size_t lines = 0;
  std::optional<TableFault> fault;  // of line `fault_line`, the first of the piece being 0
  std::size_t fault_line = 0;
};

constexpr bool is_blank(char c) { return c == ' ' || c == '\t'; }

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && (is_blank(text.back()) || text.back() == '\r')) text.remove_suffix(1);
  return text;
}

char separator_of(std::string_view line) {
  for (const char c : {'\t', ';', ','})
    if (line.find(c) != std::string_view::npos) return c;
  return ' ';
}

// Reads the lines of a file whose columns are known.
class LineReader {
 public:
  // @param rcs_m2  of points whose cell is empty
  // @param earth   of geodetic places
  LineReader(const TargetColumns& columns, double rcs_m2, std::optional<radar::EarthFrame> earth)
      : columns_(columns), rcs_m2_(rcs_m2), earth_(std::move(earth)) {
    for (std::size_t kind = 0; kind < TargetColumns::quantities; ++kind) {
      const char* base = kind == rcs_quantity ? "m2" : columns.geodetic && kind < 2 ? "deg" : "m";
      plain_ = plain_ && (columns.unit[kind].empty() || columns.unit[kind] == base);
    }
  }

  void read(std::string_view line, TextPiece& piece) const {
    if (line.size() > longest_line) {
      if (piece.fault) return;
      piece.fault_line = piece.lines;
      piece.fault = TableFault{"the line is too long for a point", fmt::format("over {} bytes", longest_line),
                               columns_.words(), "Write each point into a line of its own."};
      return;
    }
    line = trimmed(line);
    if (line.empty() || line.front() == '#' || line.front() == '!') return;
    std::array<double, TargetColumns::quantities> values{0.0, 0.0, 0.0, 1.0};
    if (!(plain_ && read_plain(line, values)) && !read_any(line, values, piece)) return;
    core::Vec3 point_m{values[0], values[1], values[2]};
    if (earth_) point_m = earth_->world_of({core::rad_per_deg * values[0], core::rad_per_deg * values[1], values[2]});
    piece.arrays.x_m.push_back(point_m.x);
    piece.arrays.y_m.push_back(point_m.y);
    piece.arrays.z_m.push_back(point_m.z);
    piece.arrays.root_rcs_m.push_back(values[3]);
  }

 private:
  // The common case: numbers without units, as many as there are columns; false, and nothing is said, for all others.
  bool read_plain(std::string_view line, std::array<double, TargetColumns::quantities>& values) const {
    const char separator = separator_of(line);
    std::array<bool, TargetColumns::quantities> met{};
    std::size_t column = 0;
    for (std::size_t at = 0; at <= line.size(); ++column) {
      const std::size_t end = std::min(line.find(separator, at), line.size());
      for (std::size_t kind = 0; kind < values.size(); ++kind)
        if (columns_.at[kind] == column) {
          if (!read_number(trimmed(line.substr(at, end - at)), values[kind])) return false;
          met[kind] = true;
        }
      at = end + 1;
      while (separator == ' ' && at < line.size() && line[at] == ' ') ++at;
    }
    const bool rcs_missing = columns_.at[rcs_quantity] && !met[rcs_quantity];
    const bool beyond_pole = earth_ && !(std::abs(values[0]) <= 90.0);
    return met[0] && met[1] && met[2] && !rcs_missing && !beyond_pole && column <= columns_.count;
  }

  static bool read_number(std::string_view cell, double& value) {
    const char* const end = cell.data() + cell.size();
    const auto [stop, error] = std::from_chars(cell.data(), end, value);
    return error == std::errc{} && stop == end && !cell.empty() && scene::computable(value);
  }

  // Cells with units or quotes, and whatever is wrong.
  bool read_any(std::string_view line, std::array<double, TargetColumns::quantities>& values, TextPiece& piece) const {
    const std::vector<scene::TableLine> lines = scene::table_lines(line);
    if (lines.empty()) return false;
    scene::TargetLine read = scene::read_target_line(lines.front(), columns_);
    values = read.values;
    const auto rcs = columns_.at[rcs_quantity];
    if (rcs && (*rcs >= lines.front().cells.size() || lines.front().cells[*rcs].empty()))
      values[rcs_quantity] = rcs_m2_;
    if (read.message.empty()) return true;
    if (!piece.fault) {
      piece.fault_line = piece.lines;
      piece.fault = TableFault{std::move(read.message), std::move(read.found), columns_.words(), {}};
    }
    return false;
  }

  TargetColumns columns_;
  double rcs_m2_;
  std::optional<radar::EarthFrame> earth_;
  bool plain_ = true;
};

// The whole lines that begin in piece number `number` of a file.
std::string lines_of(const core::InputFile& file, std::size_t number) {
  const std::uint64_t begin = std::uint64_t{number} * piece_bytes;
  // From the byte before on: where that ends a line, the piece begins with one.
  const std::uint64_t from = begin > 0 ? begin - 1 : 0;
  std::string text(static_cast<std::size_t>(std::min(begin + piece_bytes, file.size()) - from), '\0');
  file.read_all_at(from, std::as_writable_bytes(std::span(text)));
  if (begin > 0) {
    const std::size_t end = text.find('\n');
    if (end == std::string::npos) return {};
    text.erase(0, end + 1);
  }
  // Of a line that is too long no more than shows it.
  for (std::uint64_t at = begin + piece_bytes;
       at < file.size() && at <= begin + piece_bytes + 2 * longest_line && !text.ends_with('\n');) {
    std::string more(static_cast<std::size_t>(std::min<std::uint64_t>(4096, file.size() - at)), '\0');
    file.read_all_at(at, std::as_writable_bytes(std::span(more)));
    at += more.size();
    more.resize(std::min(more.find('\n'), more.size() - 1) + 1);
    text += more;
  }
  return text;
}

TextPiece read_piece(std::string_view text, const LineReader& reader, std::size_t heading_lines) {
  TextPiece piece;
  for (std::size_t at = 0; at < text.size(); ++piece.lines) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    if (piece.lines >= heading_lines) reader.read(text.substr(at, end - at), piece);
    at = end + 1;
  }
  return piece;
}

void append(radar::PointArrays& all, const radar::PointArrays& more, double share) {
  for (auto column : {&radar::PointArrays::x_m, &radar::PointArrays::y_m, &radar::PointArrays::z_m,
                      &radar::PointArrays::root_rcs_m}) {
    std::vector<double>& list = all.*column;
    if (list.empty()) list.reserve(static_cast<std::size_t>(1.02 * static_cast<double>((more.*column).size()) / share));
    list.insert(list.end(), (more.*column).begin(), (more.*column).end());
  }
}

struct Heading {
  TargetColumns columns;
  std::size_t lines = 0;  // up to and with the line of names
  std::optional<TableFault> fault;
};

// A column of phases is met by name.
bool names_phase(const scene::TableLine& line) {
  return std::ranges::any_of(scene::headings_of(line), [](const scene::ColumnHeading& heading) {
    return heading.name == "phase" || heading.name == "phase_deg" || heading.name == "phase_rad";
  });
}

Heading heading_of(const core::InputFile& file, const PointTable& table) {
  Heading heading;
  std::string text(static_cast<std::size_t>(std::min<std::uint64_t>(heading_bytes, file.size())), '\0');
  file.read_all_at(0, std::as_writable_bytes(std::span(text)));
  if (text.find('\0') != std::string::npos) {
    heading.fault = TableFault{"the file is none of the formats that are read", {}, "NPY, HDF5, or lines of text", {}};
    return heading;
  }
  if (text.find('\r') != std::string::npos && text.find('\n') == std::string::npos) {
    heading.fault = TableFault{"the lines end with carriage returns alone", {}, "lines that end with a line feed", {}};
    return heading;
  }
  const std::vector<scene::TableLine> lines = scene::table_lines(text);
  if (lines.empty()) return heading;
  core::Problems problems;
  heading.columns = scene::target_columns(lines.front(), problems);
  if (!problems.empty()) {
    heading.fault =
        TableFault{problems.front().message, core::quoted_word(problems.front().found), problems.front().expected, {}};
    return heading;
  }
  if (auto problem = scene::problem_of_places(heading.columns, lines.front(), table.world, table.platform)) {
    heading.fault = TableFault{problem->message, problem->found, problem->expected, problem->hint};
    return heading;
  }
  if (heading.columns.heading) {
    heading.lines = lines.front().number;
    if (names_phase(lines.front()))
      heading.fault = TableFault{"the table has a column of phases, which echoes cannot have yet",
                                 core::quoted_word(lines.front().text), "x, y, z and, where there is one, rcs",
                                 "Leave the column out, or give it another name to have it ignored."};
  } else {
    heading.columns.at[rcs_quantity] =
        lines.front().cells.size() > rcs_quantity ? std::optional<std::size_t>(rcs_quantity) : std::nullopt;
    heading.columns.count = lines.front().cells.size();
    if (lines.front().cells.size() > TargetColumns::quantities)
      heading.fault = TableFault{"the lines have more columns than a point has values, and no line says what they are",
                                 fmt::format("{} columns", lines.front().cells.size()),
                                 "x, y, z and, where there is one, the cross-section",
                                 "Begin the file with a line of names: x,y,z,rcs."};
  }
  return heading;
}

}  // namespace

std::optional<TableFault> read_text_points(const core::InputFile& file, PointTable& table,
                                           const core::WorkControl& control) {
  Heading heading = heading_of(file, table);
  if (heading.fault) return std::move(heading.fault);
  table.row_word = "line";
  table.first_row = heading.lines + 1;
  table.own_rcs = heading.columns.at[rcs_quantity].has_value();
  table.geodetic = heading.columns.geodetic;
  const LineReader reader(heading.columns, table.rcs_m2,
                          table.geodetic ? scene::earth_of(table.world) : std::optional<radar::EarthFrame>());
  const auto pieces = static_cast<std::size_t>((file.size() + piece_bytes - 1) / piece_bytes);
  std::size_t lines = 0;
  std::optional<TableFault> fault;
  core::ordered_parallel<TextPiece>(
      pieces, control.threads,
      [&] { return [&](std::size_t i) { return read_piece(lines_of(file, i), reader, i == 0 ? heading.lines : 0); }; },
      [&](std::size_t i, TextPiece&& piece) {
        if (fault) return;
        if (piece.fault) {
          fault = std::move(piece.fault);
          fault->message = fmt::format("line {}: {}", lines + piece.fault_line + 1, fault->message);
        }
        lines += piece.lines;
        append(table.arrays, piece.arrays, static_cast<double>(i + 1) / static_cast<double>(pieces));
      },
      control.stop);
  return fault;
}

}  // namespace sarsim::workflow
