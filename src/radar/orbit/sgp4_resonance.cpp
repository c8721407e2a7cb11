#include "radar/orbit/sgp4_resonance.hpp"

#include <cmath>

namespace sarsim::radar {

namespace {

constexpr double earth_rate_rad_per_min = 4.37526908801129966e-3;
constexpr double resonance_step_min = 720.0;

// A polynomial of the eccentricity, lowest power first.
double polynomial(double e, const std::array<double, 4>& c) { return c[0] + e * (c[1] + e * (c[2] + e * c[3])); }

// Eccentricity functions G_lpq of 12-hour orbits: Hujsak's fits, in three ranges of the eccentricity.
struct EccentricityFunctions {
  double g201, g211, g310, g322, g410, g422, g520, g521, g532, g533;
};

void set_low_degrees(EccentricityFunctions& g, double e) {
  if (e <= 0.65) {
    g.g211 = polynomial(e, {3.616, -13.2470, 16.2900, 0.0});
    g.g310 = polynomial(e, {-19.302, 117.3900, -228.4190, 156.5910});
    g.g322 = polynomial(e, {-18.9068, 109.7927, -214.6334, 146.5816});
    g.g410 = polynomial(e, {-41.122, 242.6940, -471.0940, 313.9530});
    g.g422 = polynomial(e, {-146.407, 841.8800, -1629.014, 1083.4350});
    g.g520 = polynomial(e, {-532.114, 3017.977, -5740.032, 3708.2760});
    return;
  }
  g.g211 = polynomial(e, {-72.099, 331.819, -508.738, 266.724});
  g.g310 = polynomial(e, {-346.844, 1582.851, -2415.925, 1246.113});
  g.g322 = polynomial(e, {-342.585, 1554.908, -2366.899, 1215.972});
  g.g410 = polynomial(e, {-1052.797, 4758.686, -7193.992, 3651.957});
  g.g422 = polynomial(e, {-3581.690, 16178.110, -24462.770, 12422.520});
  g.g520 = e <= 0.715 ? polynomial(e, {1464.74, -4664.75, 3763.64, 0.0})
                      : polynomial(e, {-5149.66, 29936.92, -54087.36, 31324.56});
}

EccentricityFunctions eccentricity_functions(double e) {
  EccentricityFunctions g{};
  g.g201 = -0.306 - (e - 0.64) * 0.440;
  set_low_degrees(g, e);
  if (e < 0.7) {
    g.g521 = polynomial(e, {-822.71072, 4568.6173, -8491.4146, 5337.524});
    g.g532 = polynomial(e, {-853.66600, 4690.2500, -8624.7700, 5341.4});
    g.g533 = polynomial(e, {-919.22770, 4988.6100, -9064.7700, 5542.21});
  } else {
    g.g521 = polynomial(e, {-51752.104, 218913.95, -309468.16, 146349.42});
    g.g532 = polynomial(e, {-40023.880, 170470.89, -242699.48, 115605.82});
    g.g533 = polynomial(e, {-37995.780, 161616.52, -229838.20, 109377.94});
  }
  return g;
}

// Inclination functions F_lmp of 12-hour orbits; c and s are cosine and sine of the inclination.
struct InclinationFunctions {
  double f220, f221, f321, f322, f441, f442, f522, f523, f542, f543;
};

InclinationFunctions inclination_functions(double c, double s) {
  const double c2 = c * c;
  const double s2 = s * s;
  InclinationFunctions f{};
  f.f220 = 0.75 * (1.0 + 2.0 * c + c2);
  f.f221 = 1.5 * s2;
  f.f321 = 1.875 * s * (1.0 - 2.0 * c - 3.0 * c2);
  f.f322 = -1.875 * s * (1.0 + 2.0 * c - 3.0 * c2);
  f.f441 = 35.0 * s2 * f.f220;
  f.f442 = 39.3750 * s2 * s2;
  f.f522 = 9.84375 * s * (s2 * (1.0 - 2.0 * c - 5.0 * c2) + 0.33333333 * (-2.0 + 4.0 * c + 6.0 * c2));
  f.f523 = s * (4.92187512 * s2 * (-2.0 - 4.0 * c + 10.0 * c2) + 6.56250012 * (1.0 + 2.0 * c - 3.0 * c2));
  f.f542 = 29.53125 * s * (2.0 - 8.0 * c + c2 * (-12.0 + 8.0 * c + 10.0 * c2));
  f.f543 = 29.53125 * s * (-2.0 - 8.0 * c + c2 * (12.0 + 8.0 * c - 10.0 * c2));
  return f;
}

}  // namespace

Sgp4Resonance::Period Sgp4Resonance::period_of(const Sgp4Elements& epoch) {
  const double n = epoch.motion;
  if (n > 0.0034906585 && n < 0.0052359877) return Period::day;
  if (n >= 8.26e-3 && n <= 9.24e-3 && epoch.eccentricity >= 0.5) return Period::half_day;
  return Period::none;
}

Sgp4Resonance::Sgp4Resonance(const Sgp4Elements& epoch, const Sgp4Rates& zonal, const Sgp4Rates& third_body,
                             double sidereal_angle_rad)
    : period_(period_of(epoch)),
      sidereal_angle_(sidereal_angle_rad),
      perigee_(epoch.perigee),
      perigee_rate_(zonal.perigee) {
  start_.motion = epoch.motion;
  const double node_drift = zonal.node + third_body.node - earth_rate_rad_per_min;
  const double anomaly_drift = zonal.anomaly + third_body.anomaly - epoch.motion;
  if (period_ == Period::day) {
    start_.longitude = sgp4_remainder(epoch.anomaly + epoch.node + epoch.perigee - sidereal_angle_);
    drift_ = anomaly_drift + zonal.perigee + third_body.perigee + node_drift;
    prepare_day(epoch);
  } else if (period_ == Period::half_day) {
    start_.longitude = sgp4_remainder(epoch.anomaly + 2.0 * (epoch.node - sidereal_angle_));
    drift_ = anomaly_drift + 2.0 * node_drift;
    prepare_half_day(epoch);
  }
}

void Sgp4Resonance::prepare_day(const Sgp4Elements& epoch) {
  const double e2 = epoch.eccentricity * epoch.eccentricity;
  const double c = std::cos(epoch.inclination);
  const double s = std::sin(epoch.inclination);
  const double a = 1.0 / epoch.axis;
  const double base = 3.0 * epoch.motion * epoch.motion * a * a;
  const double f220 = 0.75 * (1.0 + c) * (1.0 + c);
  const double f311 = 0.9375 * s * s * (1.0 + 3.0 * c) - 0.75 * (1.0 + c);
  const double f330 = 1.875 * (1.0 + c) * (1.0 + c) * (1.0 + c);
  const double g200 = 1.0 + e2 * (-2.5 + 0.8125 * e2);
  const double g300 = 1.0 + e2 * (-6.0 + 6.60937 * e2);
  const double g310 = 1.0 + 2.0 * e2;
  add({base * a * f311 * g310 * 2.1460748e-6, 1.0, 0.0, 0.13130908});
  add({2.0 * base * f220 * g200 * 1.7891679e-6, 2.0, 0.0, 2.0 * 2.8843198});
  add({3.0 * base * a * f330 * g300 * 2.2123015e-7, 3.0, 0.0, 3.0 * 0.37448087});
}

void Sgp4Resonance::prepare_half_day(const Sgp4Elements& epoch) {
  const EccentricityFunctions g = eccentricity_functions(epoch.eccentricity);
  const InclinationFunctions f = inclination_functions(std::cos(epoch.inclination), std::sin(epoch.inclination));
  // Harmonics of degree 2 to 5 lose one power of the axis each; phases are those of the Earth's tesseral harmonics.
  const double a = 1.0 / epoch.axis;
  const double base = 3.0 * epoch.motion * epoch.motion * a * a;
  const double k22 = base * 1.7891679e-6;
  const double k32 = base * a * 3.7393792e-7;
  const double k44 = 2.0 * base * a * a * 7.3636953e-9;
  const double k52 = base * a * a * a * 1.1428639e-7;
  const double k54 = 2.0 * base * a * a * a * 2.1765803e-9;
  constexpr double p22 = 5.7686396, p32 = 0.95240898, p44 = 1.8014998, p52 = 1.0508330, p54 = 4.4108898;
  add({k22 * f.f220 * g.g201, 1.0, 2.0, p22});
  add({k22 * f.f221 * g.g211, 1.0, 0.0, p22});
  add({k32 * f.f321 * g.g310, 1.0, 1.0, p32});
  add({k32 * f.f322 * g.g322, 1.0, -1.0, p32});
  add({k44 * f.f441 * g.g410, 2.0, 2.0, p44});
  add({k44 * f.f442 * g.g422, 2.0, 0.0, p44});
  add({k52 * f.f522 * g.g520, 1.0, 1.0, p52});
  add({k52 * f.f523 * g.g532, 1.0, -1.0, p52});
  add({k54 * f.f542 * g.g521, 2.0, 1.0, p54});
  add({k54 * f.f543 * g.g533, 2.0, -1.0, p54});
}

Sgp4Resonance::Slopes Sgp4Resonance::slopes_at(double time_min, const Point& point) const {
  const double perigee = perigee_ + perigee_rate_ * time_min;
  Slopes slopes;
  slopes.longitude = point.motion + drift_;
  for (std::size_t i = 0; i < count_; ++i) {
    const Term& term = terms_[i];
    const double angle = term.longitudes * point.longitude + term.perigees * perigee - term.phase;
    slopes.motion += term.amplitude * std::sin(angle);
    slopes.motion_rate += term.amplitude * term.longitudes * std::cos(angle);
  }
  slopes.motion_rate *= slopes.longitude;
  return slopes;
}

// Whole steps of 720 min from the epoch and one shorter step: the result is defined by these steps, not by the
// differential equation alone.
Sgp4Resonance::Point Sgp4Resonance::integrated(double time_min) const {
  Point point = start_;
  double reached_min = 0.0;
  for (;;) {
    const double left_min = time_min - reached_min;
    const bool last = std::abs(left_min) < resonance_step_min;
    const double step_min = last ? left_min : std::copysign(resonance_step_min, time_min);
    const Slopes slopes = slopes_at(reached_min, point);
    point.longitude += step_min * (slopes.longitude + 0.5 * step_min * slopes.motion);
    point.motion += step_min * (slopes.motion + 0.5 * step_min * slopes.motion_rate);
    if (last) return point;
    reached_min += step_min;
  }
}

void Sgp4Resonance::apply(double time_min, Sgp4Elements& mean) const {
  const Point point = integrated(time_min);
  const double sidereal_angle = sgp4_remainder(sidereal_angle_ + time_min * earth_rate_rad_per_min);
  mean.motion = point.motion;
  mean.anomaly = period_ == Period::day ? point.longitude - mean.node - mean.perigee + sidereal_angle
                                        : point.longitude - 2.0 * mean.node + 2.0 * sidereal_angle;
}

}  // namespace sarsim::radar
