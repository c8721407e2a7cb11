#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "core/report/problem.hpp"

namespace sarsim::raster {

/// rows * columns * bytes, or nothing where that does not fit into 64 bits signed.
[[nodiscard]] inline std::optional<std::uint64_t> checked_product(std::uint64_t a, std::uint64_t b,
                                                                  std::uint64_t c = 1) {
  std::uint64_t result = 0;
  if (__builtin_mul_overflow(a, b, &result) || __builtin_mul_overflow(result, c, &result)) return std::nullopt;
  if (result > static_cast<std::uint64_t>(INT64_MAX)) return std::nullopt;
  return result;
}

/// An error about a whole file.
[[nodiscard]] inline core::Problem file_problem(const std::string& file, std::string message, std::string found = {},
                                                std::string expected = {}, std::string hint = {}) {
  return core::error(std::move(message))
      .found(std::move(found))
      .expected(std::move(expected))
      .hint(std::move(hint))
      .in(file);
}

/// The same at another severity.
[[nodiscard]] inline core::Problem with_severity(core::Problem problem, core::Severity severity) {
  problem.severity = severity;
  return problem;
}

}  // namespace sarsim::raster
