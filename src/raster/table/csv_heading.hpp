#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "core/report/problem.hpp"
#include "raster/table/cf_attributes.hpp"

namespace sarsim::raster {

/// What the line of names of a CSV file says of its columns: I and Q in turn, for one sample after the other.
struct CsvHeading {
  std::size_t columns = 0;         ///< Names; 0 where there is no such line.
  bool comment = false;            ///< It begins with '#': a line of names only where it has one for each number.
  bool pairs = false;              ///< One of the names is that of I or Q.
  std::optional<SampleUnit> unit;  ///< Of all columns; nothing where the names have none.
  std::optional<core::Problem> problem = std::nullopt;  ///< The first name that is not the one that belongs there.
};

/// Reads a line of names. Known are I, Q, re, im and the like, with the number of the sample behind ("I0", "I_0",
/// "I[0]") and a unit in brackets or behind the name ("I [mV]", "I_mV"), with or without quotes.
[[nodiscard]] CsvHeading csv_heading_of(std::string_view line);

/// Why samples cannot be read below such a line: names that are not understood or stand in another order, and another
/// number of them than of numbers in a row. Nothing where there is no line, or a comment.
/// @param values  numbers of a row
[[nodiscard]] std::optional<core::Problem> problem_of_heading(const CsvHeading& heading, std::size_t values,
                                                              const std::string& file);

}  // namespace sarsim::raster
