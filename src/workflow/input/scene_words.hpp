#pragma once

#include <string>

#include "scene/model/scene.hpp"

/// Words for choices of a scene, as options, reports and the identity of parts have them.
namespace sarsim::workflow {

/// "ascii", "binary", "bracket", "hdf5", "csv" or "npy".
[[nodiscard]] std::string format_word(scene::FileFormat format);
/// "physical" or "classic".
[[nodiscard]] std::string profile_word(scene::Profile profile);
/// "ideal" or "band-limited".
[[nodiscard]] std::string pulse_word(scene::PulseDefinition pulse);
/// "raw", "compressed" or "range profiles".
[[nodiscard]] std::string processing_word(scene::Processing processing);

}  // namespace sarsim::workflow
