#pragma once

#include <optional>

#include "simulate/plan/acquisition.hpp"

namespace sarsim::simulate {

/// How a beam that turns about the vertical jumps from pulse to pulse.
struct BeamSteps {
  double step_rad = 0.0;     ///< The largest turn of its azimuth from one pulse to the next.
  double width_rad = 0.0;    ///< Of azimuths that one pulse illuminates: between the half-power points, one way, of the
                             ///< narrower antenna, wider where the beam is raised or lowered.
  double sector_rad = 0.0;   ///< Azimuths from the first direction to the last, at most a whole turn.
  double unlit_share = 0.0;  ///< Of the sector: directions that no pulse illuminates.
};

/// Of beams that turn with a constant rate and of beams that turn with their platform; nothing where no step exceeds
/// the width. Of more than 262144 pulses the first ones are examined.
[[nodiscard]] std::optional<BeamSteps> beam_steps(const Acquisition& acquisition);

}  // namespace sarsim::simulate
