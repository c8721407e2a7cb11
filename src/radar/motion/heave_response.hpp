#pragma once

#include <string>

#include "core/maths/interpolator.hpp"
#include "radar/motion/dryden.hpp"

namespace sarsim::radar {

/// How an aircraft follows the air and how something brings it back: a simple linear model of one axis.
///
///     lag s' = gust - s                          the speed s that the gust gives it
///     z' = s - 2 zeta w0 z - w0^2 integral of z  a loop that holds its place,
///
/// so that from gust to displacement s/((lag s + 1)(s^2 + 2 zeta w0 s + w0^2)): above w0 the integral of the lagged
/// gust, and nothing for a steady gust.
struct HeaveResponse {
  double lag_s = 0.0;                     ///< Positive.
  double hold_frequency_rad_per_s = 0.0;  ///< w0, positive: without the loop the displacement grows for ever.
  double hold_damping = 0.7;              ///< zeta, positive.
};

/// An aircraft's lag in plunge: 2 (W/S)/(rho g V C_La), s.
/// @param wing_loading_pa      weight over wing area, N/m^2
/// @param density_kg_per_m3    of the air
/// @param lift_slope_per_rad   of the lift coefficient over the angle of attack
[[nodiscard]] double heave_lag_s(double wing_loading_pa, double density_kg_per_m3, double airspeed_mps,
                                 double lift_slope_per_rad);

/// What gusts do to an aircraft: integration envelopes for one ErrorProcess each, with the same stream and axis.
struct GustMotion {
  core::Interpolator displacement;  ///< In m/s^0.5. Starts and ends at 0: its deviation has a slope.
  core::Interpolator velocity;      ///< Its derivative, in m/s^1.5: the vertical speed, for Doppler.
  double displacement_rms_m = 0.0;
  double velocity_rms_mps = 0.0;
  std::string fault;  ///< Which number is not positive; empty where all are.
};

/// The impulse response of gust and aircraft in series, that is, Dryden's envelope convolved with the aircraft's.
///
/// The knots are exact but for rounding (powers of the matrix exponential of the five states); they end after 12 time
/// constants of the slowest part, where below 1e-3 of the peak is left. Between knots, cubics (not a knot): to 1e-4 of
/// the peak where the fastest time constant is at least 1/40 of the slowest. The rms values are sums over the knots, to
/// 1e-3. ErrorProcess divides the envelope into 512 steps; down to the same ratio they keep the variance of the
/// displacement to 0.2 % and that of the velocity to 2 %.
[[nodiscard]] GustMotion gust_motion(const Gusts& gusts, const HeaveResponse& response);

}  // namespace sarsim::radar
