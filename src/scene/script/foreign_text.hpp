#pragma once

#include <string>
#include <string_view>

#include "core/report/problem.hpp"

namespace sarsim::scene {

/// What a text or the bytes of a file seem to be that are no scene, in words: "YAML", "a PNG picture", "an empty file".
/// A guess by the first bytes and by how lines begin; empty where nothing tells.
[[nodiscard]] std::string guess_of_content(std::string_view content);

/// Whether content begins as one of the formats that are no text: PNG, HDF5, ZIP, programs.
[[nodiscard]] bool is_known_format(std::string_view content);

/// The error of a file that is no scene, naming what it seems to be and what to do with that.
/// @param file  its name, for the place
[[nodiscard]] core::Problem no_scene(std::string_view content, const std::string& file);

}  // namespace sarsim::scene
