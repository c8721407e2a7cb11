#pragma once

#include <string>
#include <string_view>

#include "core/report/problem.hpp"

namespace sarsim::scene {

/// The probable kind of a text or of the bytes of a file that is not a scene: "YAML", "a PNG picture", "an empty file".
/// Guessed from the first bytes and the beginnings of lines; empty if unknown.
[[nodiscard]] std::string guess_of_content(std::string_view content);

/// Whether content begins like a known binary format: PNG, HDF5, ZIP, programs.
[[nodiscard]] bool is_known_format(std::string_view content);

/// The error for a file that is not a scene, with its probable kind and what to do with it.
/// @param file  its name, for the place
[[nodiscard]] core::Problem no_scene(std::string_view content, const std::string& file);

}  // namespace sarsim::scene
