#pragma once

#include <string_view>

#include "core/toml/document.hpp"
#include "core/toml/values.hpp"

namespace sarsim::core::toml {

/// What is wrong with a word; all parts are literals.
struct Complaint {
  const char* message = nullptr;  ///< Null where nothing is wrong.
  const char* expected = "";
  const char* hint = "";
};

/// What is wrong with a word that `scalar_kind` took for a number, boolean or date-time.
[[nodiscard]] Complaint complaint_about(std::string_view word, Kind kind);

/// Reads a date, a time or both; fields that the kind does not have are 0.
/// @returns what is wrong; then `result` is unfinished
[[nodiscard]] Complaint read_date_time(std::string_view word, Kind kind, DateTime& result);

}  // namespace sarsim::core::toml
