#include "radar/atmosphere/gas.hpp"

#include <algorithm>
#include <cmath>

#include "radar/atmosphere/gas_lines.hpp"
#include "radar/atmosphere/refractivity.hpp"
#include "radar/atmosphere/straight_path.hpp"

namespace sarsim::radar {

namespace {

// Air in the quantities of the recommendation.
struct Conditions {
  double p = 0.0;      // dry pressure, hPa
  double e = 0.0;      // of the vapour, hPa
  double theta = 1.0;  // 300 K/T
};

// Equation 5 for one line: its width and the interference between lines, which has the same sign in both wings.
double shape(double f, double line, double width, double interference) {
  const double below = line - f, above = line + f;
  return f / line *
         ((width - interference * below) / (below * below + width * width) +
          (width - interference * above) / (above * above + width * width));
}

double oxygen_sum(double f, const Conditions& air) {
  const auto& [p, e, theta] = air;
  const double dry_width = std::pow(theta, 0.8);
  const double strength = 1e-7 * p * theta * theta * theta;
  double sum = 0.0;
  for (const OxygenLine& line : oxygen_lines) {
    const double collisions = 1e-4 * line.a3 * (p * dry_width + 1.1 * e * theta);
    const double width = std::sqrt(collisions * collisions + 2.25e-6);  // Zeeman splitting
    const double interference = 1e-4 * (line.a5 + line.a6 * theta) * (p + e) * dry_width;
    sum += line.a1 * strength * std::exp(line.a2 * (1.0 - theta)) * shape(f, line.frequency_ghz, width, interference);
  }
  return sum;
}

// Equations 8 and 9.
double dry_continuum(double f, const Conditions& air) {
  const auto& [p, e, theta] = air;
  const double debye_ghz = 5.6e-4 * (p + e) * std::pow(theta, 0.8);
  const double ratio = f / debye_ghz;
  return f * p * theta * theta *
         (6.14e-5 / (debye_ghz * (1.0 + ratio * ratio)) +
          1.4e-12 * p * std::pow(theta, 1.5) / (1.0 + 1.9e-5 * std::pow(f, 1.5)));
}

double vapour_sum(double f, const Conditions& air) {
  const auto& [p, e, theta] = air;
  const double strength = 0.1 * e * std::pow(theta, 3.5);
  double sum = 0.0;
  for (const VapourLine& line : vapour_lines) {
    const double collisions = 1e-4 * line.b3 * (p * std::pow(theta, line.b4) + line.b5 * e * std::pow(theta, line.b6));
    const double doppler2 = 2.1316e-12 * line.frequency_ghz * line.frequency_ghz / theta;
    const double width = 0.535 * collisions + std::sqrt(0.217 * collisions * collisions + doppler2);
    sum += line.b1 * strength * std::exp(line.b2 * (1.0 - theta)) * shape(f, line.frequency_ghz, width, 0.0);
  }
  return sum;
}

constexpr int shells = 922;

// Lower boundary of shell i, counted from 0, m (P.676-13, equation 15).
double shell_base_m(int i) { return 0.1 * std::expm1(0.01 * i) / std::expm1(0.01); }

}  // namespace

GasLoss gas_loss(double carrier_hz, const AirState& air) {
  if (air.dry_pressure_pa <= 0.0) return {};
  const double f = 1e-9 * carrier_hz;
  const Conditions conditions{0.01 * air.dry_pressure_pa, 0.01 * air.vapour_pressure_pa(), 300.0 / air.temperature_k};
  const double db_per_m = 1e-3 * 0.1820 * f;
  return {db_per_m * (oxygen_sum(f, conditions) + dry_continuum(f, conditions)), db_per_m * vapour_sum(f, conditions)};
}

double slant_gas_loss_db(double carrier_hz, double elevation_rad, double height_m, double surface_vapour_kg_per_m3) {
  double loss_db = 0.0, begin_m = height_m;
  double cosine = std::cos(elevation_rad), index_below = 0.0;
  for (int i = 0; i < shells; ++i) {
    const double end_m = std::min(shell_base_m(i + 1), reference_top_m);
    if (end_m <= begin_m) continue;
    const AirState air = reference_air(0.5 * (begin_m + end_m), surface_vapour_kg_per_m3);
    const double index = 1.0 + 1e-6 * refractivity_of(air);
    if (index_below > 0.0) cosine = std::min(1.0, cosine * index_below / index);
    const double sine = std::sqrt((1.0 - cosine) * (1.0 + cosine));
    const double chord_m = endless_climb(begin_m, sine, mean_earth_radius_m).distance_to(end_m);
    loss_db += chord_m * gas_loss(carrier_hz, air).sum_db_per_m();
    cosine *= (mean_earth_radius_m + begin_m) / (mean_earth_radius_m + end_m);
    index_below = index;
    begin_m = end_m;
  }
  return loss_db;
}

}  // namespace sarsim::radar
