#include "workflow/input/scene_words.hpp"

#include "raster/table/formats.hpp"

namespace sarsim::workflow {

std::string format_word(scene::FileFormat format) { return raster::word_of(raster::format_of(format)); }

std::string profile_word(scene::Profile profile) { return profile == scene::Profile::classic ? "classic" : "physical"; }

std::string pulse_word(scene::PulseDefinition pulse) {
  return pulse == scene::PulseDefinition::band_limited ? "band-limited" : "ideal";
}

std::string processing_word(scene::Processing processing) {
  switch (processing) {
    case scene::Processing::matched_filter: return "compressed";
    case scene::Processing::srp: return "range profiles";
    default: return "raw";
  }
}

}  // namespace sarsim::workflow
