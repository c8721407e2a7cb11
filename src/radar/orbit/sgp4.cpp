#include "radar/orbit/sgp4.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "core/maths/constants.hpp"
#include "core/report/expect.hpp"
#include "radar/orbit/sgp4_periodic.hpp"

namespace sarsim::radar {

namespace {

using core::Problem;
using core::Severity;

std::optional<Problem> fault_of(const MeanElements& e, const CivilTime& epoch) {
  const auto fault = [](const char* what, double value, const char* expected) {
    return core::error(what).found(fmt::format("{}", value)).expected(expected);
  };
  if (!is_valid(epoch)) return core::error("the epoch is no calendar time").found(format_civil(epoch));
  if (!(e.inclination_rad >= 0.0 && e.inclination_rad <= core::pi))
    return fault("the inclination is out of range", e.inclination_rad * core::deg_per_rad, "0 to 180 deg");
  if (!(e.eccentricity >= 0.0 && e.eccentricity < 1.0))
    return fault("the eccentricity is out of range", e.eccentricity, "0 or more and below 1");
  if (!(e.mean_motion_rad_per_s > 0.0 && std::isfinite(e.mean_motion_rad_per_s)))
    return fault("the mean motion is out of range", e.mean_motion_rad_per_s * 43200.0 / core::pi,
                 "above 0 turns a day");
  for (const double value : {e.ascending_node_rad, e.perigee_rad, e.mean_anomaly_rad, e.drag_per_earth_radius})
    if (!std::isfinite(value)) return fault("a mean element is not finite", value, "a finite number");
  return std::nullopt;
}

double axis_of(double motion) { return std::pow(Sgp4Earth::root_mu() / motion, 2.0 / 3.0); }

// Mean elements of Brouwer's theory: the published mean motion is Kozai's.
Sgp4Elements brouwer_elements(const MeanElements& e) {
  const double kozai_motion = 60.0 * e.mean_motion_rad_per_s;
  const double c = std::cos(e.inclination_rad);
  const double e2 = e.eccentricity * e.eccentricity;
  const double j2_term = 0.75 * Sgp4Earth::j2 * (3.0 * c * c - 1.0) / (std::sqrt(1.0 - e2) * (1.0 - e2));
  const double kozai_axis = axis_of(kozai_motion);
  const double d1 = j2_term / (kozai_axis * kozai_axis);
  const double axis = kozai_axis * (1.0 - d1 * (1.0 / 3.0 + d1 * (1.0 + d1 * 134.0 / 81.0)));
  Sgp4Elements b;
  b.motion = kozai_motion / (1.0 + j2_term / (axis * axis));
  b.axis = axis_of(b.motion);
  b.eccentricity = e.eccentricity;
  b.inclination = e.inclination_rad;
  b.node = e.ascending_node_rad;
  b.perigee = e.perigee_rad;
  b.anomaly = e.mean_anomaly_rad;
  return b;
}

// Days since 1950 as the difference of two Julian dates of one double each, which rounds the epoch to 4.7e-10 days (40
// us). So do the programs whose states are published: in orbits close to a parabola it moves states by 4e-6 km.
double rounded_days_since_1950(const CivilTime& epoch) {
  constexpr double julian_date_of_1950 = 2433281.5;
  const double julian_date = days_since_1950(epoch) + julian_date_of_1950;
  return julian_date - julian_date_of_1950;
}

double cube(double x) { return x * x * x; }
double fourth_power(double x) { return x * x * x * x; }

}  // namespace

double days_since_1950(const CivilTime& utc) {
  CORE_EXPECT(is_valid(utc));
  constexpr std::int64_t mjd_of_1950 = 33281;
  const std::int64_t days = mjd_of_date(utc.year, utc.month, utc.day).value_or(0) - mjd_of_1950;
  const double second = 3600 * utc.hour + 60 * utc.minute + utc.second + utc.fraction_s;
  return static_cast<double>(days) + second / 86'400.0;
}

// The density of the air falls as (q0 - s)^4/(r - s)^4, with an s that depends on the height of the perigee; lengths in
// Earth radii.
struct Sgp4::Atmosphere {
  double perigee_height_km = 0.0;
  double s = 0.0;
  double xi = 0.0;    // 1/(axis - s)
  double rise = 0.0;  // ((q0 - s) xi)^4

  explicit Atmosphere(const Sgp4Elements& epoch)
      : perigee_height_km((epoch.axis * (1.0 - epoch.eccentricity) - 1.0) * Sgp4Earth::radius_km) {
    constexpr double q0_km = 120.0;
    double s_km = 78.0;
    if (perigee_height_km < 98.0)
      s_km = 20.0;
    else if (perigee_height_km < 156.0)
      s_km = perigee_height_km - 78.0;
    s = 1.0 + s_km / Sgp4Earth::radius_km;
    xi = 1.0 / (epoch.axis - s);
    rise = fourth_power((q0_km - s_km) / Sgp4Earth::radius_km * xi);
  }
};

std::variant<Sgp4, core::Problem> Sgp4::from(const MeanElements& elements, const CivilTime& epoch) {
  if (std::optional<Problem> fault = fault_of(elements, epoch)) return *std::move(fault);
  constexpr double deep_space_from_min = 225.0;
  Sgp4 model;
  model.epoch_ = brouwer_elements(elements);
  model.set_rates();
  const bool deep = 2.0 * core::pi / model.epoch_.motion >= deep_space_from_min;
  model.set_drag(elements.drag_per_earth_radius);
  const Atmosphere air(model.epoch_);
  if (!deep && air.perigee_height_km >= 220.0) model.set_high_powers_of_drag(air, elements.drag_per_earth_radius);
  if (deep) model.deep_.emplace(model.epoch_, model.rates_, rounded_days_since_1950(epoch));
  return model;
}

// Secular rates of Brouwer's theory in J2, J2^2 and J4.
void Sgp4::set_rates() {
  const double c = std::cos(epoch_.inclination);
  const double c2 = c * c;
  const double c4 = c2 * c2;
  const double b2 = 1.0 - epoch_.eccentricity * epoch_.eccentricity;
  const double b = std::sqrt(b2);
  const double p = epoch_.axis * b2;
  const double k1 = 1.5 * Sgp4Earth::j2 / (p * p) * epoch_.motion;
  const double k2 = 0.5 * k1 * Sgp4Earth::j2 / (p * p);
  const double k4 = -0.46875 * Sgp4Earth::j4 / fourth_power(p) * epoch_.motion;
  rates_.anomaly = epoch_.motion + 0.5 * k1 * b * (3.0 * c2 - 1.0) + 0.0625 * k2 * b * (13.0 - 78.0 * c2 + 137.0 * c4);
  rates_.perigee =
      -0.5 * k1 * (1.0 - 5.0 * c2) + 0.0625 * k2 * (7.0 - 114.0 * c2 + 395.0 * c4) + k4 * (3.0 - 36.0 * c2 + 49.0 * c4);
  rates_.node = -k1 * c + (0.5 * k2 * (4.0 - 19.0 * c2) + 2.0 * k4 * (3.0 - 7.0 * c2)) * c;
}

// Coefficients C1 to C5 of Spacetrack Report 3 and what follows from them.
void Sgp4::set_drag(double b_star) {
  const Atmosphere air(epoch_);
  const double a = epoch_.axis, e = epoch_.eccentricity, n = epoch_.motion;
  const double c = std::cos(epoch_.inclination), s = std::sin(epoch_.inclination);
  const double b2 = 1.0 - e * e;
  const double eta = a * e * air.xi;
  const double eta2 = eta * eta;
  const double e_eta = e * eta;
  const double psi2 = std::abs(1.0 - eta2);
  const double scale = air.rise / std::pow(psi2, 3.5);
  const double flattening = 3.0 * c * c - 1.0;
  const double c2 = scale * n *
                    (a * (1.0 + 1.5 * eta2 + e_eta * (4.0 + eta2)) +
                     0.375 * Sgp4Earth::j2 * air.xi / psi2 * flattening * (8.0 + 3.0 * eta2 * (8.0 + eta2)));
  const double by_j2 = -3.0 * flattening * (1.0 - 2.0 * e_eta + eta2 * (1.5 - 0.5 * e_eta)) +
                       0.75 * s * s * (2.0 * eta2 - e_eta * (1.0 + eta2)) * std::cos(2.0 * epoch_.perigee);
  drag_.eta = eta;
  drag_.c1 = b_star * c2;
  drag_.c4 = b_star * 2.0 * n * scale * a * b2 *
             (eta * (2.0 + 0.5 * eta2) + e * (0.5 + 2.0 * eta2) - Sgp4Earth::j2 * air.xi / (a * psi2) * by_j2);
  drag_.c5 = b_star * 2.0 * scale * a * b2 * (1.0 + 2.75 * (eta2 + e_eta) + e_eta * eta2);
  drag_.longitude[0] = 1.5 * drag_.c1;
  const double p = a * b2;
  drag_.node = 3.5 * b2 * (-1.5 * Sgp4Earth::j2 / (p * p) * n * c) * drag_.c1;
}

// Powers of the time up to 5, and the periodic terms of anomaly and perigee.
void Sgp4::set_high_powers_of_drag(const Atmosphere& air, double b_star) {
  const double a = epoch_.axis, e = epoch_.eccentricity;
  const double c1 = drag_.c1;
  drag_.high_powers = true;
  drag_.d2 = 4.0 * a * air.xi * c1 * c1;
  const double t = drag_.d2 * air.xi * c1 / 3.0;
  drag_.d3 = (17.0 * a + air.s) * t;
  drag_.d4 = 0.5 * t * a * air.xi * (221.0 * a + 31.0 * air.s) * c1;
  drag_.longitude[1] = drag_.d2 + 2.0 * c1 * c1;
  drag_.longitude[2] = 0.25 * (3.0 * drag_.d3 + c1 * (12.0 * drag_.d2 + 10.0 * c1 * c1));
  drag_.longitude[3] = 0.2 * (3.0 * drag_.d4 + 12.0 * c1 * drag_.d3 + 6.0 * drag_.d2 * drag_.d2 +
                              15.0 * c1 * c1 * (2.0 * drag_.d2 + c1 * c1));
  if (e <= 1.0e-4) return;
  const double b_star_rise = b_star * air.rise;
  drag_.perigee = -2.0 * b_star_rise * air.xi * (Sgp4Earth::j3 / Sgp4Earth::j2) * epoch_.motion *
                  std::sin(epoch_.inclination) / e * std::cos(epoch_.perigee);
  drag_.anomaly = -2.0 / 3.0 * b_star_rise / (e * drag_.eta);
}

// Everything that drag changes but the node. Expects a mean motion above 0.
void Sgp4::add_drag(double t, Sgp4Elements& mean) const {
  const double t2 = t * t;
  double shrinkage = 1.0 - drag_.c1 * t;
  double rounding = drag_.c4 * t;
  double longitude = drag_.longitude[0] * t2;
  if (drag_.high_powers) {
    const double at_epoch = cube(1.0 + drag_.eta * std::cos(epoch_.anomaly));
    const double now = cube(1.0 + drag_.eta * std::cos(mean.anomaly));
    const double shift = drag_.perigee * t + drag_.anomaly * (now - at_epoch);
    mean.anomaly += shift;
    mean.perigee -= shift;
    shrinkage -= t2 * (drag_.d2 + t * (drag_.d3 + t * drag_.d4));
    rounding += drag_.c5 * (std::sin(mean.anomaly) - std::sin(epoch_.anomaly));
    longitude += t2 * t * (drag_.longitude[1] + t * (drag_.longitude[2] + t * drag_.longitude[3]));
  }
  mean.axis = axis_of(mean.motion) * shrinkage * shrinkage;
  mean.motion = Sgp4Earth::root_mu() / std::pow(mean.axis, 1.5);
  mean.eccentricity -= rounding;
  mean.anomaly += epoch_.motion * longitude;
}

std::variant<Sgp4Elements, const char*> Sgp4::secular_at(double t) const {
  Sgp4Elements mean = epoch_;
  mean.anomaly += rates_.anomaly * t;
  mean.perigee += rates_.perigee * t;
  mean.node += rates_.node * t + drag_.node * t * t;
  if (deep_) deep_->add_secular(t, mean);
  if (!(mean.motion > 0.0)) return "the mean motion is not above 0";
  add_drag(t, mean);
  if (!(mean.eccentricity < 1.0 && mean.eccentricity >= -0.001)) return "the mean eccentricity has left 0 to 1";
  constexpr double min_eccentricity = 1.0e-6;
  mean.eccentricity = std::max(mean.eccentricity, min_eccentricity);
  mean.node = sgp4_remainder(mean.node);
  mean.perigee = sgp4_remainder(mean.perigee);
  mean.anomaly = sgp4_remainder(mean.anomaly);
  return mean;
}

std::variant<OrbitState, const char*> Sgp4::state_in_minutes(double time_min) const {
  std::variant<Sgp4Elements, const char*> secular = secular_at(time_min);
  if (const auto* why = std::get_if<const char*>(&secular)) return *why;
  auto& mean = std::get<Sgp4Elements>(secular);
  if (deep_) deep_->add_periodic(time_min, mean);
  if (mean.inclination < 0.0) {
    mean.inclination = -mean.inclination;
    mean.node += core::pi;
    mean.perigee -= core::pi;
  }
  if (!(mean.eccentricity >= 0.0 && mean.eccentricity <= 1.0))
    return "the eccentricity with the terms of Sun and Moon has left 0 to 1";
  return sgp4_state(mean);
}

std::variant<OrbitState, core::Problem> Sgp4::state_at(double time_s) const {
  constexpr double longest_min = 100.0 * 365.25 * 1440.0;
  const double time_min = time_s / 60.0;
  const auto problem = [&](std::string_view why) {
    constexpr double day_min = 1440.0;
    // Within a day no other epoch of the same orbit helps.
    const bool is_far = std::abs(time_min) > day_min && std::holds_alternative<OrbitState>(state_in_minutes(0.0));
    const std::string hint =
        is_far ? std::string("use elements of an epoch nearer to the recording")
               : fmt::format(
                     "the theory does not hold for this orbit, of eccentricity {:.4g} and {:.4g} revolutions a "
                     "day: take states (OEM, SP3) instead of mean elements",
                     epoch_.eccentricity, epoch_.motion * day_min / (2.0 * core::pi));
    return core::error(fmt::format("SGP4 fails {:.6g} min after the epoch: {}", time_min, why)).hint(hint);
  };
  if (!(std::abs(time_min) <= longest_min)) return problem("it is more than 100 years away");
  const std::variant<OrbitState, const char*> result = state_in_minutes(time_min);
  if (const auto* why = std::get_if<const char*>(&result)) return problem(*why);
  return std::get<OrbitState>(result);
}

}  // namespace sarsim::radar
