#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scene/model/scene.hpp"
#include "workflow/input/output_names.hpp"

namespace sarsim::workflow {

/// One thing that a script asks for.
struct ProductJob {
  bool table = false;     ///< A geometry table; otherwise a simulation.
  std::size_t index = 0;  ///< Position in the scene's list.
  std::filesystem::path path;
};

/// The products that `words` choose, in the script's order: numbers count simulations from 1, other words are output
/// names of simulations or geometry tables (whole or base name, ignoring case). No words: all of them. Throws
/// core::InvalidRequest for a word that chooses nothing.
[[nodiscard]] std::vector<ProductJob> chosen_products(const scene::Scene& scene, const OutputNames& names,
                                                      const std::vector<std::string>& words);

}  // namespace sarsim::workflow
