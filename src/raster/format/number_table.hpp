#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>

#include "core/report/problem.hpp"
#include "core/task/stop.hpp"

namespace sarsim::raster {

/// Who takes the numbers of a table, some rows at a time.
struct NumberTableTaker {
  /// Called first, with the size; what it returns is why the table is not wanted.
  std::function<std::optional<core::Problem>(std::uint64_t rows, std::uint64_t columns)> begin;
  /// Called with whole rows in their order, one behind the other.
  std::function<void(std::uint64_t first_row, std::span<const double> numbers)> take;
  const core::StopFlag* stop = nullptr;  ///< Asked before each of them; a requested stop throws Interrupted.
};

}  // namespace sarsim::raster
