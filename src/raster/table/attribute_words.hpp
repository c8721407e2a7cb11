#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "scene/model/recording.hpp"

namespace sarsim::raster {

/// What a file says of itself: name, value.
using FileAttributes = std::vector<std::pair<std::string, std::string>>;

/// The value of an attribute; empty where there is none.
[[nodiscard]] std::string attribute_of(const FileAttributes& attributes, std::string_view name);

/// The word of the attribute `processing`: raw, matched_filter or srp.
[[nodiscard]] std::string attribute_word(scene::Processing processing);
/// What such a word says; nothing for any other word.
[[nodiscard]] std::optional<scene::Processing> processing_of(std::string_view word);

}  // namespace sarsim::raster
