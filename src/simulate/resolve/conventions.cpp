#include "simulate/resolve/conventions.hpp"

#include "core/maths/constants.hpp"

namespace sarsim {

Conventions conventions_of(Profile profile) {
  Conventions conventions;
  conventions.light_speed_mps = exact_light_speed_mps;
  conventions.boltzmann_j_per_k = boltzmann_j_per_k;
  if (profile == Profile::physical) return conventions;
  conventions.light_speed_mps = classic_light_speed_mps;
  conventions.boltzmann_j_per_k = classic_boltzmann_j_per_k;
  conventions.pattern = PatternRule::power;
  conventions.pointing = PointingRule::added_angles;
  conventions.low_pass = LowPassRule::origin;
  conventions.spacing = Conventions::SampleSpacing::window_fraction;
  conventions.compression = Conventions::Compression::pulse_energy;
  conventions.noise = Conventions::Noise::per_bandwidth;
  conventions.stc = Conventions::Stc::no_spreading;
  return conventions;
}

}  // namespace sarsim
