#pragma once

#include <cstddef>
#include <functional>
#include <span>

#include "core/maths/vector.hpp"
#include "core/task/parallel.hpp"
#include "signal/sar/sar_echoes.hpp"
#include "simulate/plan/plan.hpp"

namespace sarsim::workflow {

/// One pulse's sight of one target, from where the antenna is believed to have been.
struct PulseSight {
  std::size_t pulse = 0;
  core::Vec3 antenna_m;    ///< World.
  core::Vec3 point_m;      ///< World.
  double amplitude = 0.0;  ///< Of its echo, sqrt(W); 0 where no sample of the record can have it.
};

/// How much of a scene is looked at: of more targets or pulses, some that are evenly spaced.
struct SightLimits {
  std::size_t targets = 512;
  std::size_t pulses = 512;
};

/// Calls `body` with the targets of a scene, counted from 0, and the sights of each over the pulses, from many threads
/// at once.
/// @param echoes  their track, waveform and window; no rows are read
/// @throw  Interrupted
void each_target_in_sight(const simulate::Plan& plan, const signal::EchoRows& echoes, const SightLimits& limits,
                          const core::WorkControl& control,
                          const std::function<void(std::size_t target, std::span<const PulseSight> sights)>& body);

/// How many targets `each_target_in_sight` skips from one to the next; 0 where there are none.
[[nodiscard]] std::size_t target_stride(const simulate::Plan& plan, const SightLimits& limits);

}  // namespace sarsim::workflow
