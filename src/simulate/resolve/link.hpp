#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "core/maths/interpolator.hpp"
#include "radar/antenna/beam.hpp"
#include "radar/antenna/pattern.hpp"
#include "radar/waveform/pulse.hpp"
#include "radar/waveform/schedule.hpp"
#include "scene/model/radar.hpp"
#include "signal/compress/range_compression.hpp"
#include "simulate/resolve/air_paths.hpp"

namespace sarsim::simulate {

/// A transmitter and the receiver that receives its echoes, both of one radar: its platform by number, its functions
/// ready.
struct Link {
  std::string name;
  std::uint32_t platform = 0;
  radar::Pulse pulse;
  radar::Repetition repetition;
  radar::CarrierPlan carrier;
  double radiated_w = 0.0;  ///< Power times gains over losses: P Gt Gr/L.
  double noise_temperature_k = 0.0;
  radar::AntennaPattern transmit;
  radar::AntennaPattern receive;
  radar::Beam beam;
  signal::WindowFunction window;
  scene::Radar::Stc stc = scene::Radar::Stc::none;
  core::Interpolator stc_gain;
  std::shared_ptr<const AirPaths> air;  ///< Null without an atmosphere.
};

}  // namespace sarsim::simulate
