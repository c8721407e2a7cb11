#pragma once

namespace sarsim::radar {

/// How Doppler acts inside a pulse.
enum class DopplerRule {
  stretch,  ///< What comes back at u was sent at e = u - (D u + a u^2/2); the carrier turns by what lies between.
  thesis,   ///< The pulse keeps its length; its phase turns by D (f u + K u^2/2) (thesis 6.24).
};

/// Relates when a part of a pulse was sent to when it comes back, each from the pulse's middle, s. Times of the echo
/// are u, times of the pulse e = u - late(u).
struct PulseClock {
  double doppler = 0.0;        ///< D = tau'/(1 + tau').
  double dilation_rate = 0.0;  ///< a = tau''/(1 + tau')^3.

  [[nodiscard]] constexpr bool ticks_evenly() const { return doppler == 0.0 && dilation_rate == 0.0; }
  /// By how much what comes back at u is later than without motion.
  [[nodiscard]] constexpr double late(double u_s) const { return (doppler + 0.5 * dilation_rate * u_s) * u_s; }
  /// When what comes back at u was sent.
  [[nodiscard]] constexpr double sent(double u_s) const { return u_s - late(u_s); }
  /// By how much what was sent at e comes back later than without motion: late(e + late_of(e)).
  [[nodiscard]] constexpr double late_of(double e_s) const {
    if (ticks_evenly()) return 0.0;
    const double rate = 1.0 / (1.0 - doppler);
    double u_s = e_s * rate;
    if (dilation_rate == 0.0) return doppler * u_s;
    // A contraction by a u, far below 1: two rounds leave less than rounding does.
    for (int round = 0; round < 3; ++round) u_s = (e_s + 0.5 * dilation_rate * u_s * u_s) * rate;
    return late(u_s);
  }
};

}  // namespace sarsim::radar
