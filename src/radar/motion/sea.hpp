#pragma once

#include <optional>
#include <vector>

#include "core/maths/random.hpp"

namespace sarsim::radar {

/// A developed sea without swell.
struct Sea {
  double significant_height_m = 0.0;  ///< Hs: 4 times the standard deviation of the surface.
  double peak_period_s = 1.0;         ///< Tp: of the most energetic waves.
};

/// The sea of a sea state 2 to 8: mean significant height of NATO STANAG 4194 and its most probable peak period for the
/// North Atlantic over the year (Bales, Lee, Voelker: DTNSRDC/SPD-0919-01, 1981; state 2 has no agreed period, others
/// print 6.3 s). The heights lie within the bands of WMO code table 3700. States 0 and 1, which hardly move a ship,
/// have 0.05 m and no known period: 3 s is ours. Nothing for other numbers; state 9 has no mean.
[[nodiscard]] std::optional<Sea> sea_of_state(int state);

/// Bretschneider's spectrum of the surface (ITTC 1978, two parameters), m^2 s/rad, wp = 2 pi/Tp:
///
///     S(w) = (5/16) Hs^2 wp^4 w^-5 exp(-1.25 (wp/w)^4).
[[nodiscard]] double wave_spectrum(const Sea& sea, double frequency_rad_per_s);

/// Its integral m0 = Hs^2/16: the variance of the surface, m^2.
[[nodiscard]] double wave_variance_m2(const Sea& sea);

/// Mean time between upward crossings of zero, 2 pi sqrt(m0/m2) = Tp/(1.25 pi)^(1/4) = 0.7104 Tp.
[[nodiscard]] double zero_crossing_period_s(const Sea& sea);

/// The frequency below which that share of the variance lies, between 0 and 1: wp (1.25/-ln share)^(1/4), rad/s.
[[nodiscard]] double frequency_of_share_rad_per_s(const Sea& sea, double share);

/// One of the sinusoidal waves that stand for a sea.
struct Wave {
  double frequency_rad_per_s = 0.0;  ///< As a fixed observer sees it.
  double phase_rad = 0.0;
  double from_share = 0.0;  ///< The shares of the variance that it stands for.
  double to_share = 0.0;
};

/// Waves of equal energy: the spectrum is cut into `count` parts of equal variance, and each wave has a random phase
/// and a random frequency in the middle half of its part. Their variance is m0 exactly, each amplitude
/// sqrt(2 m0/count); the frequencies have no common multiple, so that the sea does not repeat.
/// @param count   20 to 40 look like a sea
/// @param stream  of that sea; the numbers (0 to count - 1, 0) are used
[[nodiscard]] std::vector<Wave> waves_of(const Sea& sea, int count, const core::RandomStream& stream);

}  // namespace sarsim::radar
