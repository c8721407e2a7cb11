#include "radar/atmosphere/atmosphere_table.hpp"

#include <algorithm>
#include <cmath>

#include "radar/atmosphere/path_integral.hpp"

namespace sarsim::radar {

namespace {

constexpr double margin_m = 10.0;
constexpr double air_scale_heights = 40.0;

// Sine of the elevation at which a line leaves a height that just touches a lower height.
double horizon_sine(double height_m, double floor_m, double earth_radius_m) {
  const double ratio = (earth_radius_m + floor_m) / (earth_radius_m + height_m);
  return -std::sqrt(std::max(0.0, (1.0 - ratio) * (1.0 + ratio)));
}

}  // namespace

AtmosphereTable::AtmosphereTable(const Atmosphere& atmosphere, double carrier_hz, double earth_radius_m,
                                 HeightSpan heights_of_scatterers, HeightSpan heights_of_radar)
    : model_(atmosphere, carrier_hz), earth_radius_m_(earth_radius_m), curvature_per_m_(1.0 / earth_radius_m) {
  if (curvature_per_m_ == 0.0) return;
  if (atmosphere.refraction == Refraction::exponential) air_top_m_ = air_scale_heights * atmosphere.scale_height_m;
  if (atmosphere.gases) gas_top_m_ = reference_top_m;
  const double floor_m = std::min({0.0, heights_of_scatterers.low_m, heights_of_radar.low_m}) - margin_m;
  scatterers_ = tabulate(heights_of_scatterers, floor_m);
  radars_ = tabulate(heights_of_radar, floor_m);
}

AtmosphereTable::Above AtmosphereTable::tabulate(HeightSpan heights, double floor_m) const {
  Above above;
  const HeightSpan wide{heights.low_m - margin_m, heights.high_m + margin_m};
  const auto grid_below = [&](double top_m, double height_step_m, double sine_step) {
    const HeightSpan clipped{wide.low_m, std::min(wide.high_m, top_m)};
    return SlantTable::Grid{clipped, height_step_m, horizon_sine(clipped.high_m, floor_m, earth_radius_m_), sine_step};
  };
  if (wide.low_m < air_top_m_) {
    const ExponentialRefractivity air = model_.exponential();
    above.air = SlantTable(grid_below(air_top_m_, 50e3, 0.008), [&](double height_m, double sine) {
      const double scale = 1e-6 * air.surface / air.value(height_m);
      return scale * integral_along(endless_climb(height_m, sine, earth_radius_m_), air);
    });
  }
  if (wide.low_m < gas_top_m_)
    above.gas = SlantTable(grid_below(gas_top_m_, 1e3, 0.006), [&](double height_m, double sine) {
      return integral_along(endless_climb(height_m, sine, earth_radius_m_), *model_.gases());
    });
  return above;
}

bool AtmosphereTable::holds(const End& end) const {
  const auto covers = [&](const SlantTable& table, double top_m) {
    if (top_m == nothing_m) return true;
    return end.height_m >= top_m ? end.sine >= 0.0 : table.holds(end.height_m, end.sine);
  };
  return covers(end.above.air, air_top_m_) && covers(end.above.gas, gas_top_m_);
}

double AtmosphereTable::air_above_m(const End& end) const {
  if (end.height_m >= air_top_m_) return 0.0;
  return end.above.air.at(end.height_m, end.sine) * std::exp(-end.height_m / model_.atmosphere().scale_height_m);
}

double AtmosphereTable::gas_above_db(const End& end) const {
  return end.height_m >= gas_top_m_ ? 0.0 : end.above.gas.at(end.height_m, end.sine);
}

PathEffect AtmosphereTable::at(double scatterer_height_m, double radar_height_m, double distance_m) const {
  const StraightPath line = path(scatterer_height_m, radar_height_m, distance_m);
  const double c = curvature_per_m_;
  if (c == 0.0 || distance_m == 0.0) return model_.effect(line);
  const bool radar_above = radar_height_m >= scatterer_height_m;
  const double low_m = radar_above ? scatterer_height_m : radar_height_m;
  const double high_m = radar_above ? radar_height_m : scatterer_height_m;
  const double mean_rise = 0.5 * (high_m - low_m) * (2.0 + c * (high_m + low_m)) / distance_m;
  const double half_turn = 0.5 * c * distance_m;
  const End low{radar_above ? scatterers_ : radars_, low_m, (mean_rise - half_turn) / (1.0 + c * low_m)};
  const End high{radar_above ? radars_ : scatterers_, high_m, (mean_rise + half_turn) / (1.0 + c * high_m)};
  if (!holds(low) || !holds(high)) return model_.effect(line);
  PathEffect effect;
  effect.delay_m =
      model_.atmosphere().refraction == Refraction::linear ? model_.air_m(line) : air_above_m(low) - air_above_m(high);
  effect.phase_m = effect.delay_m;
  effect.loss_db = std::max(0.0, gas_above_db(low) - gas_above_db(high));
  model_.add_closed_forms(line, effect);
  return effect;
}

}  // namespace sarsim::radar
