#pragma once

#include <complex>
#include <vector>

#include "core/maths/random.hpp"
#include "radar/motion/sea.hpp"
#include "radar/motion/sines.hpp"

namespace sarsim::radar {

/// The few numbers of a ship that its motion in waves depends on here.
struct Hull {
  double length_m = 1.0;  ///< At the waterline.
  double beam_m = 1.0;    ///< At the waterline.
  double draught_m = 1.0;
  double metacentric_height_m = 1.0;  ///< GM: how stiff it is against roll; positive.
  double roll_damping = 0.1;          ///< Share of the critical damping; 0.05 bare, 0.1 with bilge keels; positive.
};

/// How a ship goes through waves.
struct Course {
  double speed_mps = 0.0;
  /// Where the waves go, counterclockwise from where the bow points: 0 following, pi/2 from starboard, pi head seas.
  double waves_to_rad = 0.0;
};

/// The frequency with which a ship meets waves, w - w^2 V cos(mu)/g in deep water, rad/s; negative where it overtakes
/// them.
[[nodiscard]] double encounter_frequency_rad_per_s(const Course& course, double frequency_rad_per_s);

/// The natural roll period 2 C B/sqrt(GM), C = 0.373 + 0.023 B/d - 0.043 L/100, s (IMO, Intact Stability Code 2008, A
/// 2.3; lengths in m).
[[nodiscard]] double roll_period_s(const Hull& hull);

/// What a wave of 1 m amplitude does, as complex amplitudes: re cos(we t) - im sin(we t) for the surface cos(we t) at
/// the ship's middle.
struct WaveResponse {
  std::complex<double> heave;            ///< Up, in m/m.
  std::complex<double> roll_rad_per_m;   ///< Positive: port side down, as angles of world_from_platform.
  std::complex<double> pitch_rad_per_m;  ///< Positive: bow up.
};

/// A simple model, not a strip theory: a box that follows the water around it.
///
/// Heave is the surface's mean over length and beam, pitch the slope of the straight line that fits it best along the
/// ship, roll the mean slope across it; all three weakened by exp(-k d/2), the wave's pressure halfway down. Roll goes
/// through the resonance w0^2/(w0^2 - we^2 + 2 j zeta w0 we) of `roll_period_s`. Heave and pitch have no resonance, and
/// there is no surge, sway or yaw. Good to a factor of two for merchant ships and frigates in waves longer than half of
/// them; too quiet for heave and pitch in head seas near their resonance.
[[nodiscard]] WaveResponse response_of(const Hull& hull, const Course& course, double frequency_rad_per_s);

/// The surface where a ship is, as sines of z: variance m0 exactly.
[[nodiscard]] std::vector<Sine> surface_sines(const Sea& sea, const Course& course, int count,
                                              const core::RandomStream& stream);

/// Heave (z), roll and pitch of a ship in a sea: one sine each for every wave of `waves_of`, with their phases. The
/// amplitude holds the mean square of the response over the wave's part of the spectrum (a sum of 32 points), so that
/// few waves have the variance of the whole spectrum even across the narrow resonance of roll.
[[nodiscard]] std::vector<Sine> ship_sines(const Hull& hull, const Course& course, const Sea& sea, int count,
                                           const core::RandomStream& stream);

}  // namespace sarsim::radar
