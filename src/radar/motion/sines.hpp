#pragma once

#include <array>
#include <vector>

#include "core/maths/interpolator.hpp"

namespace sarsim::radar {

/// What an oscillation moves: a coordinate or an angle of rotation.
enum class SineAxis { x, y, z, roll, pitch, yaw };

/// An oscillation: amplitude sin(2 pi frequency t + phase).
struct Sine {
  SineAxis axis = SineAxis::x;
  double amplitude = 0.0;     ///< In m, or rad for roll, pitch and yaw.
  double frequency_hz = 0.0;  ///< May be negative: the phase runs backwards.
  double phase_rad = 0.0;
};

/// What sines add to a path and to its angles, with derivatives in time.
struct SineState {
  std::array<core::Jet, 3> position_m;    ///< x, y, z, in the frame in which the caller adds them.
  std::array<core::Jet, 3> rotation_rad;  ///< Roll, pitch, yaw: angles of world_from_platform.
};

/// The sum of sines at any time. The phase's whole turns are taken away first, so that the error is that of the product
/// of frequency and time: 2e-16 of it, in turns.
[[nodiscard]] SineState sines_at(const std::vector<Sine>& sines, double time_s);

/// No acceleration of the position exceeds this, m/s^2: the sums of amplitude (2 pi f)^2 of x, y and z.
[[nodiscard]] double acceleration_bound_mps2(const std::vector<Sine>& sines);

/// The mean square of what the sines do on one axis, for frequencies that differ: half the sum of squared amplitudes.
[[nodiscard]] double variance(const std::vector<Sine>& sines, SineAxis axis);

}  // namespace sarsim::radar
