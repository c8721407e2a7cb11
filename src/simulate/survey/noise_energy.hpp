#pragma once

#include "simulate/resolve/resolved.hpp"

namespace sarsim::simulate {

/// k T of a radar's receiver, in joules, as ratios to noise need it: 0 below 1e-200 J (7e-178 K), which counts as no
/// noise, since ratios to so little would not be finite.
[[nodiscard]] inline double noise_energy_j(const Conventions& conventions, const Link& radar) {
  constexpr double min_j = 1e-200;
  const double energy_j = conventions.boltzmann_j_per_k * radar.noise_temperature_k;
  return energy_j >= min_j ? energy_j : 0.0;
}

}  // namespace sarsim::simulate
