#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "simulate/plan/sink.hpp"

namespace sarsim::raster {

/// What a file says of itself: name, value.
using FileAttributes = std::vector<std::pair<std::string, std::string>>;

/// The value of an attribute; empty where there is none.
[[nodiscard]] std::string attribute_of(const FileAttributes& attributes, std::string_view name);

/// Whether a product knows the value of an attribute.
[[nodiscard]] inline bool is_known(const simulate::Product& product, std::string_view name) {
  return std::ranges::find(product.unknown, name) == product.unknown.end();
}

/// The word of the attribute `processing`: raw, matched_filter or srp.
[[nodiscard]] std::string attribute_word(scene::Processing processing);

/// Gives a product what the attributes of a recording (docs/formats/samples.md) say of its origin: radar, processing,
/// engine, profile, pulse, seed and tolerance. What is missing, or no such value, stays as it is and counts as unknown.
void take_origin(const FileAttributes& attributes, simulate::Product& product);

}  // namespace sarsim::raster
