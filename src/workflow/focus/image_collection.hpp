#pragma once

#include "core/task/parallel.hpp"
#include "signal/sar/focusing.hpp"
#include "workflow/focus/focus_input.hpp"
#include "workflow/image/sicd_image.hpp"
#include "workflow/input/earth_place.hpp"

namespace sarsim::workflow {

/// How an image was made of its echoes.
struct ImageMaking {
  const signal::FocusedImage& image;
  const signal::FocusOptions& options;
  bool in_time = false;  ///< By back-projection, which keeps all Doppler frequencies.
  bool autofocused = false;
};

/// How the echoes of an image were collected. When its places were seen follows from the strength that the echoes of a
/// resting point there would have: antenna, flight and recording as they are, within the Doppler band that was kept.
/// @param input  with the track of the recording, not yet compensated; no rows are read
/// @throw Interrupted
[[nodiscard]] ImageCollection collection_of(const FocusInput& input, const ImageMaking& making, const EarthPlace& place,
                                            const core::WorkControl& control);

}  // namespace sarsim::workflow
