#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "raster/format/open_raster.hpp"
#include "scene/model/scene.hpp"

namespace sarsim::workflow {

/// Which of several names may be that of a file.
struct NamesAlike {
  std::vector<std::size_t> found;  ///< Positions, ascending.
  bool whole = false;              ///< The whole name is the same; otherwise all but the extension.
};

/// Looks for the name of a file among others, ignoring its folder and case: the whole name first, then names that
/// differ by the extension alone, of which there may be several.
[[nodiscard]] NamesAlike names_alike(const std::vector<std::string>& names, const std::filesystem::path& file);

/// What a scene says of a file that one of its simulations writes: shape, bits, LSB and format. The simulation is the
/// one whose output has the name of the file, ignoring case and folders, otherwise the only one with another extension
/// (and then without a format). The number of rows of synthetic range profiles is left open. Nothing where there is
/// none or where there are several, where its radar and window would not pass `check`, or where its rows are longer
/// than 2^31 samples. Throws nothing.
[[nodiscard]] std::optional<raster::RasterHints> hints_from_scene(const scene::Scene& scene,
                                                                  const std::filesystem::path& file);

}  // namespace sarsim::workflow
