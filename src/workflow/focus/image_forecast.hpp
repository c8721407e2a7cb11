#pragma once

#include <cstddef>
#include <optional>

#include "core/task/parallel.hpp"
#include "scene/model/scene.hpp"

namespace sarsim::workflow {

/// What a point will look like in an image that is focused with the usual options.
struct ImageForecast {
  std::size_t target = 0;        ///< Position in the scene's list, from 0.
  double azimuth_width_m = 0.0;  ///< -3 dB.
  std::optional<double>
      range_width_m;     ///< Nothing for pulses other than chirps, and echoes that are not recorded whole.
  double range_m = 0.0;  ///< Of its closest approach.
  /// Length of the flight that evenly strong echoes of this width take: 0.886 wavelength range/(2 width).
  double aperture_m = 0.0;
};

/// The image of one target of a simulation; nothing where such a recording cannot be focused, or the target is not
/// seen. Reads no echoes.
[[nodiscard]] std::optional<ImageForecast> forecast_image(const scene::Scene& scene, std::size_t simulation,
                                                          std::size_t target, const core::WorkControl& control = {});

}  // namespace sarsim::workflow
