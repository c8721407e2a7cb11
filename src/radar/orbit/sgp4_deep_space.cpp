#include "radar/orbit/sgp4_deep_space.hpp"

#include <cmath>

#include "core/maths/constants.hpp"

namespace sarsim::radar {

namespace {

// Greenwich mean sidereal time of 1982 (Aoki et al.), UT1 taken as UTC; in [0, 2 pi).
double sidereal_angle_rad(double days_since_1950) {
  constexpr double days_to_2000 = 18263.5;  // from 1950 January 0.0 to 2000 January 1.5
  const double t = (days_since_1950 - days_to_2000) / 36525.0;
  const double seconds = 67310.54841 + t * (876600.0 * 3600.0 + 8640184.812866 + t * (0.093104 - t * 6.2e-6));
  const double angle = sgp4_remainder(seconds * core::pi / 43200.0);
  return angle < 0.0 ? angle + 2.0 * core::pi : angle;
}

// Sum of the rates of Sun and Moon as rates of the elements. Within 3 deg of the equator the node is left alone.
Sgp4Rates third_body_rates(const ThirdBodyEffect& sun, const ThirdBodyEffect& moon, double inclination) {
  constexpr double min_inclination = 5.2359877e-2;
  Sgp4Rates rates;
  rates.anomaly = sun.longitude + moon.longitude;
  rates.perigee = sun.perigee + moon.perigee;
  if (inclination < min_inclination || inclination > core::pi - min_inclination) return rates;
  rates.node = (sun.node + moon.node) / std::sin(inclination);
  rates.perigee -= std::cos(inclination) * rates.node;
  return rates;
}

ThirdBodyEffect operator+(const ThirdBodyEffect& a, const ThirdBodyEffect& b) {
  return {a.eccentricity + b.eccentricity, a.inclination + b.inclination, a.longitude + b.longitude,
          a.perigee + b.perigee, a.node + b.node};
}

// Lyddane's variables sin(i) sin(node) and sin(i) cos(node) stay regular at the equator; `mean` has the inclination
// that was changed already.
void add_by_lyddane(const ThirdBodyEffect& change, Sgp4Elements& mean) {
  const double si = std::sin(mean.inclination);
  const double ci = std::cos(mean.inclination);
  const double node = sgp4_remainder(mean.node);
  const double so = std::sin(node);
  const double co = std::cos(node);
  const double alpha = si * so + change.node * co + change.inclination * ci * so;
  const double beta = si * co - change.node * so + change.inclination * ci * co;
  const double longitude =
      mean.anomaly + mean.perigee + ci * node + change.longitude + change.perigee - change.inclination * node * si;
  double new_node = std::atan2(alpha, beta);
  if (std::abs(node - new_node) > core::pi) new_node += std::copysign(2.0 * core::pi, node - new_node);
  mean.node = new_node;
  mean.anomaly += change.longitude;
  mean.perigee = longitude - mean.anomaly - ci * new_node;
}

}  // namespace

Sgp4DeepSpace::Sgp4DeepSpace(const Sgp4Elements& epoch, const Sgp4Rates& zonal, double days_since_1950)
    : sun_(sun_of_sgp4(days_since_1950), epoch),
      moon_(moon_of_sgp4(days_since_1950), epoch),
      eccentricity_rate_(sun_.rates().eccentricity + moon_.rates().eccentricity),
      inclination_rate_(sun_.rates().inclination + moon_.rates().inclination),
      rates_(third_body_rates(sun_.rates(), moon_.rates(), epoch.inclination)),
      resonance_(epoch, zonal, rates_, sidereal_angle_rad(days_since_1950)) {}

void Sgp4DeepSpace::add_secular(double time_min, Sgp4Elements& mean) const {
  mean.eccentricity += eccentricity_rate_ * time_min;
  mean.inclination += inclination_rate_ * time_min;
  mean.perigee += rates_.perigee * time_min;
  mean.node += rates_.node * time_min;
  mean.anomaly += rates_.anomaly * time_min;
  if (resonance_.active()) resonance_.apply(time_min, mean);
}

void Sgp4DeepSpace::add_periodic(double time_min, Sgp4Elements& mean) const {
  constexpr double lyddane_below = 0.2;
  const ThirdBodyEffect change = sun_.periodic_at(time_min) + moon_.periodic_at(time_min);
  mean.inclination += change.inclination;
  mean.eccentricity += change.eccentricity;
  if (mean.inclination < lyddane_below) {
    add_by_lyddane(change, mean);
    return;
  }
  const double node = change.node / std::sin(mean.inclination);
  mean.perigee += change.perigee - std::cos(mean.inclination) * node;
  mean.node += node;
  mean.anomaly += change.longitude;
}

}  // namespace sarsim::radar
