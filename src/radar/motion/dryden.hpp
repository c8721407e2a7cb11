#pragma once

#include "core/maths/interpolator.hpp"

namespace sarsim::radar {

/// How strong turbulence is (MIL-F-8785C): below 1000 ft by the wind at 20 ft of 15, 30 and 45 kn; above 2000 ft by the
/// probability that it is exceeded of 1e-2, 1e-3 and 1e-5.
enum class TurbulenceSeverity { light, moderate, severe };

/// Dryden turbulence in the axes of the flight: u along, v across, w vertical.
struct Turbulence {
  double sigma_u_mps = 0.0;
  double sigma_v_mps = 0.0;
  double sigma_w_mps = 0.0;
  double length_u_m = 1.0;  ///< Scale lengths.
  double length_v_m = 1.0;
  double length_w_m = 1.0;
};

/// Turbulence at a height above ground after MIL-F-8785C. With h in ft, below 1000 ft
///
///     L_w = h    L_u = L_v = h/(0.177 + 0.000823 h)^1.2    sigma_w = 0.1 W20
///     sigma_u = sigma_v = sigma_w (0.177 + 0.000823 h)^-0.4,
///
/// above 2000 ft L = 1750 ft and the sigma of the specification's figure 7 (as the tables of JSBSim's winds have it,
/// linear in height, constant above 45000 ft), the same on all axes; in between all six numbers are linear in height.
/// Heights below 10 ft count as 10 ft.
[[nodiscard]] Turbulence turbulence_at(double height_m, TurbulenceSeverity severity);

/// The two forms of Dryden's spectra: of gusts along the flight, and of those across and vertical.
enum class GustForm { along, across };

/// Gusts on one axis, met at constant airspeed.
struct Gusts {
  GustForm form = GustForm::across;
  double sigma_mps = 0.0;
  double length_m = 1.0;      ///< Scale length.
  double airspeed_mps = 1.0;  ///< Positive.
};

/// The integration envelope h [m/s^1.5] of gusts at a lag, 0 below lag 0: with x = V lag/L
///
///     along: sigma sqrt(2 V/L) exp(-x)    across: sigma sqrt(V/L) (sqrt 3 + (1 - sqrt 3) x) exp(-x).
///
/// White noise through it has Dryden's spectrum exactly (MIL-F-8785C).
[[nodiscard]] double gust_envelope(const Gusts& gusts, double lag_s);

/// The same as knots for ErrorProcess: cubic (not a knot), 257 of them up to x = 8. Its values are those of
/// `gust_envelope` to 1e-6 of the value at 0; the part that is cut off holds 2e-6 of the variance. The envelope jumps
/// at 0, as Dryden's gusts do: the deviation is the air's velocity and has no slope.
[[nodiscard]] core::Interpolator gust_function(const Gusts& gusts);

/// The correlation coefficient of the gusts at two times: exp(-x) along and (1 - x/2) exp(-x) across.
[[nodiscard]] double gust_correlation(const Gusts& gusts, double lag_s);

}  // namespace sarsim::radar
