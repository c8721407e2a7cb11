#include "simulate/resolve/conventions.hpp"

#include "core/maths/constants.hpp"

namespace sarsim::simulate {

Conventions conventions_of(scene::Profile profile) {
  Conventions conventions;
  conventions.light_speed_mps = core::exact_light_speed_mps;
  conventions.boltzmann_j_per_k = core::boltzmann_j_per_k;
  if (profile == scene::Profile::physical) return conventions;
  conventions.light_speed_mps = core::classic_light_speed_mps;
  conventions.boltzmann_j_per_k = core::classic_boltzmann_j_per_k;
  conventions.pattern = radar::PatternRule::power;
  conventions.pointing = radar::PointingRule::added_angles;
  conventions.low_pass = core::LowPassRule::origin;
  conventions.light_time = radar::LightTime::thesis;
  conventions.doppler = radar::DopplerRule::thesis;
  conventions.spacing = Conventions::SampleSpacing::window_fraction;
  conventions.compression = Conventions::Compression::pulse_energy;
  conventions.noise = Conventions::Noise::per_bandwidth;
  conventions.stc = Conventions::Stc::no_spreading;
  conventions.reception = Conventions::Reception::own_pulse;
  conventions.function_ends = Conventions::FunctionEnds::by_method;
  conventions.usual_kept_widths = 1.0;
  return conventions;
}

core::InterpolationRules interpolation_rules(const scene::RunOptions& options) {
  return {conventions_of(options.profile).low_pass, options.cubic_ends};
}

core::InterpolationRules interpolation_rules(const scene::RunOptions& options, scene::FunctionRole role) {
  return scene::rules_for(role, interpolation_rules(options),
                          conventions_of(options.profile).function_ends == Conventions::FunctionEnds::by_role);
}

}  // namespace sarsim::simulate
