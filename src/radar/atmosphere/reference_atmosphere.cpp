#include "radar/atmosphere/reference_atmosphere.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sarsim::radar {

namespace {

// A layer of even temperature gradient: geopotential height of its base, km, with the temperature, its gradient per km
// and the pressure, hPa, there. 34.1632 K/km is g M/R.
struct Layer {
  double base_km = 0.0;
  double temperature_k = 0.0;
  double gradient_k_per_km = 0.0;
  double pressure_hpa = 0.0;
};

constexpr Layer layers[] = {{0.0, 288.15, -6.5, 1013.25},    {11.0, 216.65, 0.0, 226.3226},
                            {20.0, 216.65, 1.0, 54.74980},   {32.0, 228.65, 2.8, 8.680422},
                            {47.0, 270.65, 0.0, 1.109106},   {51.0, 270.65, -2.8, 0.6694167},
                            {71.0, 214.65, -2.0, 0.03956649}};
constexpr double last_geopotential_km = 84.852;  // 86 km of height
constexpr double radius_km = 6356.766;

double geopotential_km(double height_km) { return radius_km * height_km / (radius_km + height_km); }
double height_km_of(double geopotential_km) { return radius_km * geopotential_km / (radius_km - geopotential_km); }

// Temperature and total pressure.
struct State {
  double temperature_k = 0.0;
  double pressure_hpa = 0.0;
};

State low_state(double geopotential_km) {
  const Layer* layer = layers;
  for (const Layer& next : layers)
    if (geopotential_km > next.base_km) layer = &next;
  const double rise = geopotential_km - layer->base_km;
  const double temperature = layer->temperature_k + layer->gradient_k_per_km * rise;
  if (layer->gradient_k_per_km == 0.0)
    return {temperature, layer->pressure_hpa * std::exp(-34.1632 * rise / layer->temperature_k)};
  const double power = 34.1632 / layer->gradient_k_per_km;
  return {temperature, layer->pressure_hpa * std::pow(layer->temperature_k / temperature, power)};
}

State high_state(double height_km) {
  const double x = (height_km - 91.0) / 19.9429;
  const double h = height_km;
  const double temperature = h <= 91.0 ? 186.8673 : 263.1905 - 76.3232 * std::sqrt(1.0 - x * x);
  return {temperature,
          std::exp(95.571899 + h * (-4.011801 + h * (6.424731e-2 + h * (-4.789660e-4 + h * 1.340543e-6))))};
}

}  // namespace

AirState reference_air(double height_m, double surface_vapour_kg_per_m3) {
  if (!(height_m <= reference_top_m)) return {0.0, 195.08134, 0.0};
  const double height_km = 1e-3 * height_m;
  const double geopotential = geopotential_km(height_km);
  const State state = geopotential <= last_geopotential_km ? low_state(geopotential) : high_state(height_km);
  const double min_kg_per_m3 = 2e-6 * state.pressure_hpa * 0.2167 / state.temperature_k;
  AirState air;
  air.temperature_k = state.temperature_k;
  air.vapour_kg_per_m3 = std::max(surface_vapour_kg_per_m3 * std::exp(-0.5 * height_km), min_kg_per_m3);
  air.dry_pressure_pa = 100.0 * state.pressure_hpa - air.vapour_pressure_pa();
  return air;
}

double refractivity_of(const AirState& air) {
  const double p = 0.01 * air.dry_pressure_pa, e = 0.01 * air.vapour_pressure_pa(), t = air.temperature_k;
  return (77.6 * p + 72.0 * e + 3.75e5 * e / t) / t;
}

double next_reference_break_m(double height_m) {
  if (!(height_m < reference_top_m)) return std::numeric_limits<double>::infinity();
  const double step_m = height_m < 22e3 ? 2e3 : 5e3;
  double next_m = std::min(reference_top_m, step_m * (std::floor(height_m / step_m) + 1.0));
  const auto take = [&](double kink_m) {
    if (kink_m > height_m) next_m = std::min(next_m, kink_m);
  };
  for (const Layer& layer : layers) take(1e3 * height_km_of(layer.base_km));
  for (const double kink_m : {86e3, 91e3}) take(kink_m);
  return next_m;
}

}  // namespace sarsim::radar
