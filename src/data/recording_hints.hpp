#pragma once

#include <filesystem>
#include <optional>

#include "data/sample_reader.hpp"
#include "scene/scene.hpp"

namespace sarsim {

/// What a scene says of a file that one of its simulations writes: shape, bits, LSB and format. The simulation is the
/// one whose output has the name of the file, ignoring case and folders, otherwise with another extension (and then
/// without a format). The number of rows of synthetic range profiles is left open. Nothing where there is none, where
/// its radar and window would not pass `check`, or where its rows are longer than 2^31 samples. Throws nothing.
[[nodiscard]] std::optional<SampleFileHints> hints_from_scene(const Scene& scene, const std::filesystem::path& file);

}  // namespace sarsim
