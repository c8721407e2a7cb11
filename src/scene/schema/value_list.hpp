#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "scene/schema/fields.hpp"

namespace sarsim::scene {

/// Values for a field as texts that `set_field` takes, or why there are none, in words.
struct ValueList {
  std::vector<std::string> texts;
  std::string failure;
};

/// Reads the values that a field shall take, one after the other: values separated by commas, each a single value or,
/// for numbers, a range `start:step:end` or `first..last` in steps of one. An end belongs to its range where steps
/// reach it to within a billionth of a step. Numbers without a unit have the unit with which their list ends, if it
/// has one: "1,2,5GHz", "10:10:100MHz". Quotation marks keep commas within a value.
///
/// Members of a range are decimal numbers as people count them, to 15 digits: "0:0.1:1" holds 0.3. A range in decibels
/// counts decibels.
///
/// @param most  more values than that are a failure
[[nodiscard]] ValueList read_value_list(std::string_view text, const Field& field, std::size_t most);

}  // namespace sarsim::scene
