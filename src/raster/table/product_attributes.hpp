#pragma once

#include <algorithm>
#include <string_view>

#include "raster/table/attribute_words.hpp"
#include "raster/table/sink.hpp"

namespace sarsim::raster {

/// Whether a product knows the value of an attribute.
[[nodiscard]] inline bool is_known(const Product& product, std::string_view name) {
  return std::ranges::find(product.unknown, name) == product.unknown.end();
}

/// Gives a product what the attributes of a recording (docs/formats/samples.md) say of its origin: radar, processing,
/// engine, profile, pulse, seed and tolerance. What is missing, or no such value, stays as it is and counts as unknown.
void take_origin(const FileAttributes& attributes, Product& product);

}  // namespace sarsim::raster
