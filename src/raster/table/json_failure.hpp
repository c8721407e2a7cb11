#pragma once

#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "raster/table/file_problem.hpp"

namespace sarsim::raster {

/// What is wrong with a text that is not JSON: where, and nothing of the text, of which the library's own words quote
/// as much as it read last.
[[nodiscard]] inline core::Problem not_json(const std::string& file, const nlohmann::json::exception& error) {
  const auto* const parsing = dynamic_cast<const nlohmann::json::parse_error*>(&error);
  return file_problem(file, "this is not JSON",
                      parsing != nullptr ? fmt::format("something else at byte {}", parsing->byte) : std::string(),
                      "an object such as { \"name\": value }");
}

}  // namespace sarsim::raster
