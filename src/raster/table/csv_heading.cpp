#include "raster/table/csv_heading.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "core/text/letters.hpp"
#include "core/text/number_text.hpp"
#include "core/text/quoted_word.hpp"
#include "raster/table/file_problem.hpp"

namespace sarsim::raster {

namespace {

constexpr std::array<std::string_view, 7> i_names{"i", "re", "real", "realpart", "inphase", "ivalue", "icomponent"};
constexpr std::array<std::string_view, 10> q_names{
    "q", "im", "imag", "imagpart", "imaginary", "imaginarypart", "quadrature", "quad", "qvalue", "qcomponent"};
constexpr const char* heading_hint =
    "name the columns I0,Q0,I1,Q1 as they follow, or remove the line; amplitudes and phases have to be converted";

// One name, taken apart.
struct ColumnName {
  std::string name;  // Small letters alone.
  std::optional<std::int64_t> number;
  std::string unit;

  [[nodiscard]] bool is_i() const { return std::ranges::find(i_names, name) != i_names.end(); }
  [[nodiscard]] bool is_q() const { return std::ranges::find(q_names, name) != q_names.end(); }
};

bool is_number(std::string_view text) { return !text.empty() && std::ranges::all_of(text, core::is_digit); }

std::string_view without(std::string_view text, std::string_view ends) {
  const std::size_t first = text.find_first_not_of(ends);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(ends) + 1 - first);
}

// Cuts what stands in brackets off a name: the number of a sample or a unit.
void take_brackets(std::string_view& text, ColumnName& column) {
  for (std::size_t open = text.find_last_of("[("); open != std::string_view::npos; open = text.find_last_of("[(")) {
    const std::string_view within = without(text.substr(open), "[]() \t");
    if (is_number(within))
      column.number = core::parse_integer(within);
    else
      column.unit = std::string(within);
    text = core::trimmed(text.substr(0, open));
  }
}

ColumnName column_name(std::string_view field) {
  ColumnName column;
  std::string_view text = without(field, "\"'# \t\r");
  take_brackets(text, column);
  const std::size_t line = text.find_last_of("_ ");
  if (column.unit.empty() && line != std::string_view::npos && unit_of_samples(text.substr(line + 1))) {
    column.unit = std::string(text.substr(line + 1));
    text = text.substr(0, line);
  }
  const std::size_t digits = text.find_last_not_of("0123456789") + 1;
  if (digits < text.size()) column.number = core::parse_integer(text.substr(digits));
  for (const char c : text.substr(0, digits))
    if (c != '_' && c != '-' && c != ' ' && c != '.') column.name += core::lower(c);
  return column;
}

// Reads one name after the other and keeps what is wrong with the first that is.
class HeadingReader {
 public:
  void take(std::string_view field) {
    const ColumnName column = column_name(field);
    heading_.pairs = heading_.pairs || column.is_i() || column.is_q();
    const bool second = heading_.columns++ % 2 == 1;
    if (heading_.problem) return;
    if (second ? !column.is_q() : !column.is_i())
      return refuse(field, "the headings of the columns are not those of I and Q in turn", second ? "Q" : "I");
    check_number(field, column, second);
    check_unit(field, column);
  }

  CsvHeading done() { return std::move(heading_); }

 private:
  void check_number(std::string_view field, const ColumnName& column, bool second) {
    const std::string sample = fmt::format("{}", number_.value_or(0) + (second ? 0 : 1));
    const bool first = heading_.columns == 1;
    if (!first && column.number.has_value() != number_.has_value())
      return refuse(field, "the headings number some of the samples only", number_ ? sample : "no number");
    if (!first && number_ && *column.number != *number_ + (second ? 0 : 1))
      return refuse(field, "the headings number the samples in another order", sample);
    number_ = column.number;
  }

  void check_unit(std::string_view field, const ColumnName& column) {
    if (heading_.columns == 1) {
      unit_ = column.unit;
      if (column.unit.empty()) return;
      heading_.unit = unit_of_samples(column.unit);
      if (!heading_.unit) refuse(field, "the unit of the samples is not known", "V, mV, uV, nV or count");
    } else if (column.unit != unit_) {
      refuse(field, "the columns have different units", unit_.empty() ? "no unit" : core::quoted_word(unit_));
    }
  }

  void refuse(std::string_view field, std::string message, std::string expected) {
    if (heading_.problem) return;
    heading_.problem = file_problem({}, std::move(message),
                                    fmt::format("{:.40} above column {}", core::quoted_word(field), heading_.columns),
                                    std::move(expected), heading_hint);
  }

  CsvHeading heading_;
  std::optional<std::int64_t> number_;  // Of the sample before.
  std::string unit_;
};

}  // namespace

CsvHeading csv_heading_of(std::string_view line) {
  HeadingReader reader;
  std::string_view rest = core::trimmed(line);
  const bool comment = rest.starts_with('#');
  while (!rest.empty()) {
    const std::size_t comma = std::min(rest.find(','), rest.size());
    reader.take(rest.substr(0, comma));
    rest.remove_prefix(std::min(comma + 1, rest.size()));
  }
  CsvHeading heading = reader.done();
  heading.comment = comment;
  return heading;
}

std::optional<core::Problem> problem_of_heading(const CsvHeading& heading, std::size_t values,
                                                const std::string& file) {
  const bool other_count = values > 0 && heading.columns != values;
  if (heading.columns == 0 || (heading.comment && other_count)) return std::nullopt;
  if (heading.problem) {
    core::Problem problem = *heading.problem;
    problem.place.file = file;
    return problem;
  }
  // "I,Q" alone holds for all samples of a row.
  if (!other_count || heading.columns == 2) return std::nullopt;
  return file_problem(file, "the line of names does not name the columns of the rows",
                      fmt::format("{} names", heading.columns), fmt::format("{}, one for each number", values),
                      heading_hint);
}

}  // namespace sarsim::raster
