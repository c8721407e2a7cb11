#include "radar/atmosphere/atmosphere.hpp"

#include "core/report/expect.hpp"

namespace sarsim::radar {

AtmosphereModel::AtmosphereModel(const Atmosphere& atmosphere, double carrier_hz)
    : atmosphere_(atmosphere), carrier_hz_(carrier_hz), rain_laws_(rain_laws(carrier_hz)) {
  CORE_EXPECT(carrier_hz > 0.0 && atmosphere.surface_refractivity > 0.0 && atmosphere.scale_height_m > 0.0);
  CORE_EXPECT(atmosphere.refraction != Refraction::linear || atmosphere.k_factor > 1.0);
  if (atmosphere.gases) gases_.emplace(carrier_hz, atmosphere.surface_vapour_kg_per_m3);
}

double AtmosphereModel::air_m(const StraightPath& path) const {
  switch (atmosphere_.refraction) {
    case Refraction::none: return 0.0;
    case Refraction::exponential: return excess_path_m(exponential(), path);
    case Refraction::linear: break;
  }
  const LinearRefractivity air{atmosphere_.surface_refractivity, gradient_of_k_per_m(atmosphere_.k_factor)};
  return excess_path_m(air, path);
}

double AtmosphereModel::gas_db(const StraightPath& path) const { return gases_ ? gas_loss_db(*gases_, path) : 0.0; }

void AtmosphereModel::add_closed_forms(const StraightPath& path, PathEffect& effect) const {
  if (atmosphere_.rain_rate_mm_per_h > 0.0) {
    const UniformRain rain{atmosphere_.rain_rate_mm_per_h, atmosphere_.rain_top_m, atmosphere_.polarisation_tilt_rad};
    effect.loss_db += rain_loss_db(rain, rain_laws_, path);
  }
  if (atmosphere_.vertical_tec_per_m2 == 0.0) return;
  const double slant_tec = atmosphere_.vertical_tec_per_m2 * shell_factor(path, atmosphere_.shell_height_m);
  const double group_m = ionosphere_group_m(slant_tec, carrier_hz_);
  effect.delay_m += group_m;
  effect.phase_m -= group_m;
  effect.faraday_rad += faraday_rad(slant_tec, atmosphere_.field_along_path_t, carrier_hz_);
}

PathEffect AtmosphereModel::effect(const StraightPath& path) const {
  if (path.distance_m == 0.0) return {};
  const double excess_m = air_m(path);
  PathEffect effect{excess_m, excess_m, gas_db(path), 0.0};
  add_closed_forms(path, effect);
  return effect;
}

PathEffect path_effect(const Atmosphere& atmosphere, double carrier_hz, const StraightPath& path) {
  return AtmosphereModel(atmosphere, carrier_hz).effect(path);
}

}  // namespace sarsim::radar
