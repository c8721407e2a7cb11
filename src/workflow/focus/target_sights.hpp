#pragma once

#include <cstddef>
#include <functional>
#include <span>

#include "core/maths/vector.hpp"
#include "core/task/parallel.hpp"
#include "signal/sar/sar_echoes.hpp"
#include "simulate/plan/acquisition.hpp"

namespace sarsim::workflow {

/// One target as seen by one pulse, from the antenna's position according to the echoes' track (perhaps navigation).
struct PulseSight {
  std::size_t pulse = 0;
  core::Vec3 antenna_m;    ///< World.
  core::Vec3 point_m;      ///< World.
  double amplitude = 0.0;  ///< Of its echo, sqrt(W); 0 if it is outside the recorded delays.
};

/// Largest numbers of targets and pulses; of more, an evenly spaced selection is used.
struct SightLimits {
  std::size_t targets = 512;
  std::size_t pulses = 512;
};

/// Calls `body` with the targets of a scene, counted from 0, and the sights of each over the pulses, concurrently from
/// several threads.
/// @param echoes  their track, waveform and window; no rows are read
/// @throw  Interrupted
void each_target_in_sight(const simulate::Acquisition& acquisition, const signal::EchoRows& echoes,
                          const SightLimits& limits, const core::WorkControl& control,
                          const std::function<void(std::size_t target, std::span<const PulseSight> sights)>& body);

/// Step from one target of `each_target_in_sight` to the next; 0 if there are none.
[[nodiscard]] std::size_t target_stride(const simulate::Acquisition& acquisition, const SightLimits& limits);

}  // namespace sarsim::workflow
