#include "raster/table/sample_gate.hpp"

#include <cmath>

#include <fmt/format.h>

#include "raster/table/file_problem.hpp"

namespace sarsim::raster {

bool is_usable_sample(const std::complex<double>& value) {
  // False where one is not a number.
  return std::abs(value.real()) <= largest_usable_v && std::abs(value.imag()) <= largest_usable_v;
}

core::Problem unusable_sample(const std::string& source, std::size_t row, std::size_t column,
                              const std::complex<double>& value) {
  const bool no_number = std::isnan(value.real()) || std::isnan(value.imag());
  return file_problem(source,
                      no_number ? fmt::format("row {}, sample {} (from 0) is not a number", row, column)
                                : fmt::format("row {}, sample {} (from 0) is too large to compute with", row, column),
                      fmt::format("{} + {}j V", value.real(), value.imag()),
                      fmt::format("finite numbers, up to {:g} V", largest_usable_v),
                      "set it to 0 or record again; sarsim info --statistics counts such samples");
}

}  // namespace sarsim::raster
