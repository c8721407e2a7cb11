#pragma once

#include "core/maths/constants.hpp"

namespace sarsim::radar {

// Doubling and halving are exact, so each function here rounds as the formula in its comment does, read from left to
// right, wherever in it the 2 stands. The speed of light is an argument: the classic and the exact one differ.

/// The way of an echo: from the transmitting antenna out to a point and from there back to the receiving one, m.
struct Path {
  double out_m = 0.0;
  double back_m = 0.0;

  /// Out and back together.
  [[nodiscard]] constexpr double length_m() const { return out_m + back_m; }
};

/// The path to a point at that distance where one antenna transmits and receives.
[[nodiscard]] constexpr Path there_and_back(double range_m) { return {range_m, range_m}; }

/// Delay of the echo over a path whose ends rest, s: (out + back)/c.
[[nodiscard]] constexpr double delay_of(const Path& path, double light_speed_mps) {
  return path.length_m() / light_speed_mps;
}

/// Delay of the echo of a point that recedes at `speed_mps`: (out + back)/(c - v) (physics rule 5). Both ways have
/// their lengths when the pulse is sent; v is below c.
[[nodiscard]] constexpr double moving_delay_of(const Path& path, double speed_mps, double light_speed_mps) {
  return path.length_m() / (light_speed_mps - speed_mps);
}

/// Two-way delay of a one-way range, s: 2 R/c. Being linear it turns a range rate in m/s into a rate of delay, too.
[[nodiscard]] constexpr double delay_of(double range_m, double light_speed_mps) {
  return delay_of(there_and_back(range_m), light_speed_mps);
}

/// Half the length of a path: the range that its delay stands for, m.
[[nodiscard]] constexpr double range_of(const Path& path) { return 0.5 * path.length_m(); }

/// One-way range of a two-way delay, m: c t/2.
[[nodiscard]] constexpr double range_of(double delay_s, double light_speed_mps) {
  return 0.5 * light_speed_mps * delay_s;
}

/// One-way range in which an oscillation of that frequency turns once on the way there and back, m: (c/2)/f. The range
/// cell of a band, the spacing of samples at a rate, half the wavelength of a carrier.
[[nodiscard]] constexpr double range_of_cycle(double frequency_hz, double light_speed_mps) {
  return 0.5 * light_speed_mps / frequency_hz;
}

/// Wavelength of a frequency, m: c/f.
[[nodiscard]] constexpr double wavelength_of(double frequency_hz, double light_speed_mps) {
  return light_speed_mps / frequency_hz;
}

/// Turns of the phase at a frequency over a metre of one-way range, 1/m: 2 f/c.
[[nodiscard]] constexpr double turns_per_m(double frequency_hz, double light_speed_mps) {
  return 2.0 * frequency_hz / light_speed_mps;
}

/// Turns of the phase at a frequency over the way to a range and back: 2 R f/c. At a rate of samples it is their
/// number.
[[nodiscard]] constexpr double turns_of(double range_m, double frequency_hz, double light_speed_mps) {
  return 2.0 * range_m * frequency_hz / light_speed_mps;
}

/// The same at a wavelength: 2 R/lambda.
[[nodiscard]] constexpr double turns_of(double range_m, double wavelength_m) { return 2.0 * range_m / wavelength_m; }

/// Frequency whose phase makes so many turns over the way to a range and back, Hz: n c/(2 R). The rate at which so many
/// samples lie within a range.
[[nodiscard]] constexpr double frequency_of_turns(double turns, double range_m, double light_speed_mps) {
  return turns * light_speed_mps / (2.0 * range_m);
}

/// One-way range over which, there and back, the phase at a frequency turns by so many radians, m: phi c/(4 pi f).
[[nodiscard]] constexpr double range_of_phase(double phase_rad, double frequency_hz, double light_speed_mps) {
  return phase_rad * light_speed_mps / (4.0 * core::pi * frequency_hz);
}

/// Doppler shift of the echo of a point that recedes at `speed_mps`, Hz, to the first order in v/c: -2 v f/c.
[[nodiscard]] constexpr double doppler_of(double speed_mps, double carrier_hz, double light_speed_mps) {
  return -turns_of(speed_mps, carrier_hz, light_speed_mps);
}

/// Speed at which a point recedes whose echo has that Doppler shift, m/s: -f_D c/(2 f).
[[nodiscard]] constexpr double speed_of(double doppler_hz, double carrier_hz, double light_speed_mps) {
  return -doppler_hz * light_speed_mps / (2.0 * carrier_hz);
}

/// The same at a wavelength: -f_D lambda/2.
[[nodiscard]] constexpr double speed_of(double doppler_hz, double wavelength_m) {
  return -0.5 * wavelength_m * doppler_hz;
}

}  // namespace sarsim::radar
