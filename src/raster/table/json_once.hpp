#pragma once

#include <string>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

namespace sarsim::raster {

/// Reads JSON in which each key of an object has to be there once: of two, parsers take the one or the other. Throws
/// nlohmann::json::exception for what is no JSON.
/// @param twice  becomes the first key that is there twice, shortened; stays as it is where none is
[[nodiscard]] nlohmann::json parse_json_once(std::string_view text, std::string& twice);

}  // namespace sarsim::raster
