#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/text/letters.hpp"
#include "core/text/number_text.hpp"
#include "core/text/quoted_word.hpp"
#include "radar/earth/geoid_problem.hpp"
#include "radar/earth/read_geoid.hpp"

namespace sarsim::radar {

namespace {

using geoid::Reading;

constexpr double max_nodes_of_side = 1e6;

// The entries of the header, in the order of `keys`.
enum Entry : std::size_t { columns, rows, x_corner, x_centre, y_corner, y_centre, cell, no_value, entries };
constexpr std::array<std::string_view, entries> keys{"ncols",     "nrows",     "xllcorner", "xllcenter",
                                                     "yllcorner", "yllcenter", "cellsize",  "nodata_value"};

// Reads a grid word by word.
class AsciiGrid {
 public:
  AsciiGrid(std::string_view text, const std::string& name) : text_(text), name_(name) {}

  Reading read() {
    if (std::optional<core::Problem> problem = read_header()) return *std::move(problem);
    if (std::optional<core::Problem> problem = fault_of_header()) return *std::move(problem);
    if (std::optional<core::Problem> problem = read_values()) return *std::move(problem);
    const double step_deg = *entry_[cell];
    const double half_deg = 0.5 * step_deg;
    const double west_deg = entry_[x_centre] ? *entry_[x_centre] : *entry_[x_corner] + half_deg;
    const double south_deg = entry_[y_centre] ? *entry_[y_centre] : *entry_[y_corner] + half_deg;
    const double north_deg = south_deg + (*entry_[rows] - 1.0) * step_deg;
    const GeoidLattice lattice{north_deg, -step_deg, west_deg, step_deg, count(rows), count(columns)};
    return geoid::grid_of(name_, lattice, std::move(values_));
  }

 private:
  [[nodiscard]] core::ProblemBuilder fault(std::string message) const {
    return core::error(std::move(message)).in(name_, line_);
  }
  [[nodiscard]] std::size_t count(Entry entry) const { return static_cast<std::size_t>(*entry_[entry]); }

  // The next word; empty at the end.
  std::string_view word() {
    while (at_ < text_.size() && core::is_blank(text_[at_])) line_ += text_[at_++] == '\n' ? 1U : 0U;
    const std::size_t begin = at_;
    while (at_ < text_.size() && !core::is_blank(text_[at_])) ++at_;
    return text_.substr(begin, at_ - begin);
  }

  // Pairs of words, up to the first word that is a number; that stays.
  std::optional<core::Problem> read_header() {
    for (;;) {
      const std::size_t before = at_;
      const std::size_t line_before = line_;
      const std::string_view key = word();
      if (key.empty() || core::parse_number(key)) {
        at_ = before;
        line_ = line_before;
        return std::nullopt;
      }
      std::size_t known = 0;
      while (known < entries && !core::equal_ignoring_case(key, keys[known])) ++known;
      if (known == entries)
        return fault("the word is not known in the header of an ASCII grid")
            .found(core::quoted_word(key))
            .expected("ncols, nrows, xllcorner or xllcenter, yllcorner or yllcenter, cellsize, NODATA_value")
            .hint("cells must have one size in latitude and longitude");
      if (entry_[known])
        return fault(fmt::format("{} appears twice", keys[known]))
            .found(core::quoted_word(key))
            .expected("one of each");
      const std::string_view value = word();
      entry_[known] = core::parse_number(value);
      if (!entry_[known])
        return fault(fmt::format("{} is not a number", keys[known]))
            .found(core::quoted_word(value))
            .expected("a finite number");
    }
  }

  std::optional<core::Problem> fault_of_header() const {
    for (const Entry side : {columns, rows}) {
      const std::optional<double>& number = entry_[side];
      if (!number) return fault(fmt::format("{} is missing", keys[side])).expected("a line with it before the values");
      const bool whole = *number >= 1.0 && *number <= max_nodes_of_side &&
                         *number == static_cast<double>(static_cast<std::int64_t>(*number));
      if (!whole)
        return fault(fmt::format("{} is no number of nodes", keys[side]))
            .found(fmt::format("{}", *number))
            .expected(fmt::format("a whole number from 1 to {}", max_nodes_of_side));
    }
    if (!entry_[cell]) return fault("cellsize is missing").expected("a line with it before the values, in degrees");
    if (entry_[x_corner].has_value() == entry_[x_centre].has_value() ||
        entry_[y_corner].has_value() == entry_[y_centre].has_value())
      return fault("the place of the grid is not clear")
          .expected("one of xllcorner and xllcenter, and one of yllcorner and yllcenter");
    // A value and the blank before it take two bytes, so that wrong counts cannot ask for more memory than there is.
    const std::size_t most = (text_.size() - at_) / 2;
    if (count(rows) * count(columns) > most)
      return fault("the file is too short for its numbers of rows and columns")
          .found(fmt::format("{} bytes of values", text_.size() - at_))
          .expected(fmt::format("{} rows of {} values", count(rows), count(columns)))
          .hint("the file may be cut off");
    return std::nullopt;
  }

  std::optional<core::Problem> read_values() {
    const double none = entry_[no_value].value_or(-9999.0);
    const std::size_t all = count(rows) * count(columns);
    values_.reserve(all);
    for (std::size_t i = 0; i < all; ++i) {
      const std::string_view text = word();
      if (text.empty())
        return fault("the values end early")
            .found(fmt::format("{} values", i))
            .expected(fmt::format("{} rows of {}", count(rows), count(columns)))
            .hint("the file may be cut off");
      const std::optional<double> value = core::parse_number(text);
      if (!value)
        return fault("a value is not a number")
            .found(core::quoted_word(text))
            .expected("a finite number in m")
            .hint(text.find(',') == std::string_view::npos ? "" : "write a point, not a comma");
      // A float holds no larger ones; `GeoidGrid` refuses much smaller ones.
      if (*value != none && !(std::abs(*value) <= 1e30))
        return fault("a value is too large").found(core::quoted_word(text)).expected("an undulation in m");
      values_.push_back(*value == none ? std::numeric_limits<float>::quiet_NaN() : static_cast<float>(*value));
    }
    if (const std::string_view rest = word(); !rest.empty())
      return fault("there is more in the file than its values")
          .found(core::quoted_word(rest))
          .expected(fmt::format("an end after {} values", all))
          .hint("correct ncols and nrows");
    return std::nullopt;
  }

  std::string_view text_;
  const std::string& name_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
  std::array<std::optional<double>, entries> entry_;
  std::vector<float> values_;
};

}  // namespace

std::variant<GeoidGrid, core::Problem> read_geoid_ascii(std::string_view bytes, const std::string& name) {
  return AsciiGrid(bytes, name).read();
}

}  // namespace sarsim::radar
