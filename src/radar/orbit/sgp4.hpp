#pragma once

#include <array>
#include <optional>
#include <variant>

#include "core/report/problem.hpp"
#include "radar/earth/civil_time.hpp"
#include "radar/orbit/mean_elements.hpp"
#include "radar/orbit/orbit_state.hpp"
#include "radar/orbit/sgp4_deep_space.hpp"
#include "radar/orbit/sgp4_elements.hpp"

namespace sarsim::radar {

/// Days of 86 400 s from 1949-12-31 00:00, which Spacetrack Report 3 calls "1950 January 0.0", to a valid time of UTC.
/// The Julian date is this plus 2433281.5. Rounded to 4e-12 days (0.3 us) near the year 2030. A leap second counts as
/// the first of the next day.
[[nodiscard]] double days_since_1950(const CivilTime& utc);

/// The analytic theory for which two-line elements are made: SGP4 of Spacetrack Report 3 (Hoots and Roehrich 1980) as
/// corrected by Vallado, Crawford, Hujsak and Kelso (AIAA 2006-6753), WGS-72, improved mode, with the deep-space part
/// for periods of 225 min and more.
///
/// States are in the frame TEME (true equator, mean equinox of the date). They agree with the states published with
/// the paper to 1e-6 km and 1e-9 km/s. The theory itself is off by about 1 km at the epoch and by some km a day later.
///
/// The velocity is that of the theory, which leaves out small terms: it differs from the derivative of the position by
/// up to 3e-5 of itself on nearly circular orbits without much drag (0.02 to 0.1 m/s), and by 1e-3 and more on
/// eccentric and on decaying ones. Where phase matters, interpolate positions alone (`lagrange_8_points`) and take the
/// velocity from the polynomial.
///
/// States do not depend on earlier calls; const members are safe to call from many threads. A call takes about 0.7 us;
/// resonant orbits (about 12 h and 24 h) take 0.1 to 0.4 us more for each 12 h between epoch and time.
class Sgp4 {
 public:
  /// Prepares the theory. Refuses elements that are not numbers, an inclination outside [0, pi], an eccentricity
  /// outside [0, 1), a mean motion that is not above 0, and an epoch (UTC) that is not valid.
  [[nodiscard]] static std::variant<Sgp4, core::Problem> from(const MeanElements& elements, const CivilTime& epoch);

  /// Position and velocity in TEME, `time_s` after the epoch (negative: before it; `seconds_between` of UTC). Fails
  /// where the theory does: the eccentricity leaves [0, 1), the mean motion is used up, the orbit is inside the Earth.
  /// Refuses times beyond 100 years. The problem's message says the time in minutes from the epoch.
  [[nodiscard]] std::variant<OrbitState, core::Problem> state_at(double time_s) const;

  /// True where Sun, Moon and resonance are taken into account.
  [[nodiscard]] bool deep_space() const { return deep_.has_value(); }

 private:
  // What drag changes, in powers of the time and in periodic terms. Without the high powers: perigee below 220 km, or
  // deep space.
  struct Drag {
    double c1 = 0.0;            // of the axis
    double c4 = 0.0, c5 = 0.0;  // of the eccentricity; times B*
    double d2 = 0.0, d3 = 0.0, d4 = 0.0;
    std::array<double, 4> longitude{};  // times t^2 to t^5
    double node = 0.0;                  // times t^2
    double perigee = 0.0;               // times t
    double anomaly = 0.0;
    double eta = 0.0;
    bool high_powers = false;
  };
  struct Atmosphere;

  Sgp4() = default;
  void set_rates();
  void set_drag(double b_star);
  void set_high_powers_of_drag(const Atmosphere& air, double b_star);
  void add_drag(double time_min, Sgp4Elements& mean) const;
  [[nodiscard]] std::variant<Sgp4Elements, const char*> secular_at(double time_min) const;
  [[nodiscard]] std::variant<OrbitState, const char*> state_in_minutes(double time_min) const;

  Sgp4Elements epoch_;
  Sgp4Rates rates_;
  Drag drag_;
  std::optional<Sgp4DeepSpace> deep_;
};

}  // namespace sarsim::radar
