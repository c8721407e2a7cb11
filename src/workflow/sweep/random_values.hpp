#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "scene/schema/value_list.hpp"

namespace sarsim::workflow {

/// Whether a text asks for random values: "normal(", "uniform(" or "exponential(" and what follows.
[[nodiscard]] bool is_random(std::string_view text);

/// Draws values for a field of numbers: "normal(MEAN, STANDARD DEVIATION)", "uniform(LOWEST, HIGHEST)" or
/// "exponential(MEAN)". Numbers without a unit have that of the last. Values have nine digits; where all numbers are in
/// one unit they are drawn in it, so that of decibels the decibels are normal. Whole numbers are rounded.
///
/// @param seed  of the scene; a value depends on it, on `key` and on its number among the draws alone
/// @param key   of what varies, so that two fields get different values
[[nodiscard]] scene::ValueList draw_values(std::string_view text, const scene::Field& field, std::size_t count,
                                           std::uint64_t seed, std::string_view key);

}  // namespace sarsim::workflow
