#pragma once

#include "core/maths/interpolator.hpp"

namespace sarsim::radar {

/// Mean radius of the Earth that Schuler's period of 84.4 minutes belongs to, m.
inline constexpr double schuler_radius_m = 6'371'000.0;

/// Schuler's frequency sqrt(g/R), rad/s: a level inertial platform swings with it.
[[nodiscard]] double schuler_frequency_rad_per_s();

/// The integration envelope of a first-order Gauss-Markov process, sigma sqrt(2/T) exp(-lag/T): mean 0, standard
/// deviation sigma, correlation coefficient exp(-lag/T). For velocities and attitudes of a navigation. Cubic knots (not
/// a knot) up to 8 T: values to 1e-6 of the first; the part that is cut off holds 2e-7 of the variance.
/// @param sigma               in the unit of the deviation
/// @param correlation_time_s  T, positive
[[nodiscard]] core::Interpolator gauss_markov_function(double sigma, double correlation_time_s);

/// The same of second order, c u exp(-u/s) with s = T/2 and c = 2 sigma s^(-3/2): mean 0, standard deviation sigma,
/// correlation coefficient (1 + lag/s) exp(-lag/s), whose integral is T. Its deviation has a velocity, of standard
/// deviation sigma/s. For positions and attitudes that are followed closely. Cubic knots up to 12 s.
[[nodiscard]] core::Interpolator smooth_wander_function(double sigma, double correlation_time_s);

/// The integration envelope of a random walk: a box. The difference of two deviations has the variance
/// density^2 lag while the lag is below the duration, as a random walk has; beyond it no longer grows.
/// @param density     deviation per square root of time: angular random walk in rad/s^0.5
/// @param duration_s  the longest time over which the walk matters: that of a recording, positive
[[nodiscard]] core::Interpolator random_walk_function(double density, double duration_s);

/// Constant errors of the sensors on one horizontal axis, and the instant of the last alignment.
struct InsBias {
  double accelerometer_mps2 = 0.0;
  double gyro_rad_per_s = 0.0;  ///< Of the gyro that feels the tilt of that axis.
  double aligned_s = 0.0;       ///< Errors are 0 then and before.
};

/// What the errors of position do beyond the first minutes.
enum class InsModel {
  polynomial,  ///< Grow as b t^2/2 and g eps t^3/6: right for t far below 84 minutes.
  schuler,     ///< Swing: b/w^2 (1 - cos w t) and g eps/w^2 (t - sin(w t)/w), w Schuler's frequency.
};

/// The position error that biases make, m, and its derivatives.
[[nodiscard]] core::Jet position_error(const InsBias& bias, InsModel model, double time_s);

/// Standard deviations that white noise of the sensors gives after a time.
/// @{
/// Angle: density sqrt(t), of an angular random walk in rad/s^0.5.
[[nodiscard]] double angle_walk_rad(double density_rad_per_root_s, double elapsed_s);
/// Position of a tilt that walks: g density sqrt(t^5/20), m.
[[nodiscard]] double tilt_walk_position_m(double density_rad_per_root_s, double elapsed_s);
/// Position of a velocity random walk in m/s^1.5: density sqrt(t^3/3), m.
[[nodiscard]] double velocity_walk_position_m(double density_mps_per_root_s, double elapsed_s);
/// @}

/// Level of the first paired echoes of a sinusoidal path error of that amplitude in the line of sight, relative to the
/// response: 20 log10(2 pi amplitude/wavelength) dB, for amplitudes well below the wavelength.
[[nodiscard]] double paired_echo_db(double amplitude_m, double wavelength_m);

}  // namespace sarsim::radar
