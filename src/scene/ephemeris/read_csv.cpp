#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include <fmt/format.h>

#include "core/text/letters.hpp"
#include "core/text/number_text.hpp"
#include "core/text/separated.hpp"
#include "scene/ephemeris/formats.hpp"
#include "scene/ephemeris/known_words.hpp"
#include "scene/ephemeris/state_collector.hpp"
#include "scene/ephemeris/text_lines.hpp"

namespace sarsim::scene::ephemeris {

namespace {

constexpr std::size_t max_columns = 7;
using CsvCells = std::array<std::string_view, max_columns>;

char csv_separator(std::string_view line) {
  for (const char c : {';', ','})
    if (line.find(c) != std::string_view::npos) return c;
  return ' ';
}

// The cells of a line; the number of them may be more than there is room for.
std::size_t split_cells(std::string_view line, char separator, CsvCells& cells) {
  if (separator == ' ') return split_words(line, cells);
  std::size_t count = 0;
  core::each_piece(line, separator, [&](std::string_view cell) {
    if (count < cells.size()) cells[count] = cell;
    ++count;
  });
  return count;
}

// The names that a column may have, without blanks, brackets and quotes.
bool is_column(std::size_t column, std::string_view name) {
  constexpr std::array<std::string_view, max_columns> names{"t", "x", "y", "z", "vx", "vy", "vz"};
  std::string plain;
  for (const char c : name.substr(0, 40))
    if (core::is_digit(c) || core::is_letter(c) || c == '_' || c == '/') plain += core::lower(c);
  std::string_view unit = plain;
  if (column == 0) {
    const bool other = plain == "time" || plain == "utc" || plain == "epoch" || plain == "time_s" || plain == "times";
    return other || plain == "t" || plain == "t_s" || plain == "ts" || plain == "time_utc" || plain == "timeutc";
  }
  if (!unit.starts_with(names[column])) return false;
  unit.remove_prefix(names[column].size());
  if (unit.starts_with('_')) unit.remove_prefix(1);
  return unit.empty() || (column < 4 ? unit == "m" : unit == "mps" || unit == "m/s" || unit == "m_s");
}

// Reads our own table: t, x, y, z and, where there are any, vx, vy, vz.
class CsvReader {
 public:
  explicit CsvReader(const ReaderInput& input)
      : problems_(input.problems), text_(input.text), collector_(file_, problems_, "m", input.without_earth) {}

  EphemerisFile read() {
    TextLines lines(text_);
    std::string_view line;
    while (!collector_.full() && !hopeless_ && lines.next_filled(line)) {
      if (line.front() == '#' || line.front() == '!') continue;
      take(line);
      last_ = line;
    }
    if (!hopeless_) collector_.finish(last_);
    return std::move(file_);
  }

 private:
  void take(std::string_view line) {
    const std::size_t count = split_cells(line, separator_, cells_);
    if (columns_ == 0) return take_first(line);
    if (count != columns_) {
      if (!problems_.again(odd_count_))
        odd_count_ = problems_.error(line, {"the line has another number of cells than those before",
                                            fmt::format("{} cells", count), fmt::format("{}", columns_), ""});
      return;
    }
    take_row();
  }

  // The first line that is not a comment: names of columns or numbers.
  void take_first(std::string_view line) {
    separator_ = csv_separator(line);
    const std::size_t count = split_cells(line, separator_, cells_);
    if (count != 4 && count != 7) {
      problems_.error(line, {"the table has a wrong number of columns", fmt::format("{} columns", count),
                             "4 (t, x, y, z) or 7 (and vx, vy, vz)", ""});
      hopeless_ = true;
      return;
    }
    columns_ = count;
    const char first = cells_[0].empty() ? 't' : cells_[0].front();
    if (core::is_digit(first) || first == '-' || first == '+' || first == '.') {
      file_.form = radar::parse_civil(cells_[0]).time ? TimeForm::civil : TimeForm::since_epoch;
      form_known_ = true;
      return take_row();
    }
    for (std::size_t column = 0; column < count; ++column)
      if (!is_column(column, cells_[column]))
        problems_.error(cells_[column], {fmt::format("column {} has another name than it should", column + 1),
                                         core::clipped(cells_[column]),
                                         "t, x, y, z in s and m and, where there are any, vx, vy, vz in m/s",
                                         "put the columns in this order, in these units"});
    hopeless_ = problems_.has_errors();
  }

  void take_row() {
    if (!form_known_) file_.form = radar::parse_civil(cells_[0]).time ? TimeForm::civil : TimeForm::since_epoch;
    form_known_ = true;
    EphemerisState state;
    std::array<double, max_columns> values{};
    bool good = file_.form == TimeForm::civil
                    ? read_time(cells_[0], "the time of a state", file_.scale, problems_, state.time)
                    : read_number(cells_[0], "the time of a state", "s", 0, problems_, state.since_epoch_s);
    for (std::size_t i = 1; i < columns_; ++i)
      good &= read_number(cells_[i], i < 4 ? "a position" : "a velocity", i < 4 ? "m" : "m/s", 0, problems_, values[i]);
    if (good) add(state, values);
  }

  void add(EphemerisState& state, const std::array<double, max_columns>& values) {
    state.position_m = {values[1], values[2], values[3]};
    if (columns_ == max_columns) state.velocity_mps = core::Vec3{values[4], values[5], values[6]};
    collector_.add(state, cells_[0], cells_[1]);
  }

  FileProblems& problems_;
  std::string_view text_;
  EphemerisFile file_;
  StateCollector collector_;
  CsvCells cells_{};
  char separator_ = ' ';
  std::size_t columns_ = 0;
  bool form_known_ = false;
  bool hopeless_ = false;
  std::string_view last_;
  FileProblems::Mark odd_count_ = 0;
};

}  // namespace

EphemerisFile read_csv(const ReaderInput& input) { return CsvReader(input).read(); }

}  // namespace sarsim::scene::ephemeris
