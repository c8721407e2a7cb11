#pragma once

#include <string>
#include <vector>

#include "core/maths/angle.hpp"
#include "scene/model/user_function.hpp"

namespace sarsim::scene {

/// One antenna of a radar: its gain against the offset from the beam's direction.
struct Antenna {
  /// Gain 1 everywhere, sin(x)/x, or points.
  enum class Pattern { isotropic, sinx, user };

  Pattern pattern = Pattern::isotropic;
  core::Angle elevation_beamwidth = core::Angle::from_deg(10.0);  ///< Pattern::sinx.
  core::Angle azimuth_beamwidth = core::Angle::from_deg(10.0);
  UserFunction<2> gain_db;  ///< Azimuth cut, elevation cut: one-way power [dB] against offset [deg]; Pattern::user.

  friend bool operator==(const Antenna&, const Antenna&) = default;
};

/// A transmitter and receiver at the origin of its platform (script `$RADAR`, thesis 4.4).
struct Radar {
  /// One frequency, a linear sweep, I and Q by points, or a Barker code.
  enum class Pulse { mono, chirp, user, barker };
  /// Full amplitude throughout, straight rise and fall, or points.
  enum class Envelope { rectangular, linear, user };
  /// One repetition frequency, or a list of intervals.
  enum class Repetition { constant, user };
  /// One carrier, evenly spaced steps, or a list.
  enum class Carrier { single, stepped, user };
  /// A fixed direction, a turning one, a point that is looked at, or angles against time.
  enum class Beam { fixed, rotating, spot, user };
  /// Weights of the matched filter.
  enum class Window { rectangular, hanning, bartlett, hamming, user, blackman, kaiser, taylor };
  /// Sensitivity-time control: none, gain with the square of the range, or points.
  enum class Stc { none, range_law, user };

  std::string name = "Radar1";
  std::string platform = "Earth";

  Pulse pulse = Pulse::mono;
  double bandwidth_hz = 50e6;  ///< Pulse::chirp; negative sweeps down.
  UserFunction<2> pulse_iq;    ///< I, Q against the fraction of the pulse width; Pulse::user.
  int barker_code = 6;         ///< 0 to 6, lengths 2, 3, 4, 5, 7, 11, 13; Pulse::barker.
  double pulse_width_s = 5e-6;
  Envelope envelope = Envelope::rectangular;
  double rise_s = 0.0;  ///< Envelope::linear.
  double fall_s = 0.0;
  UserFunction<1> envelope_gain;  ///< Against the fraction of the pulse width; Envelope::user.

  Repetition repetition = Repetition::constant;
  double prf_hz = 1000.0;  ///< Repetition::constant.
  UserFunction<1> pri_s;   ///< y: interval after each pulse, in turn; x is ignored; Repetition::user.
  Carrier carrier = Carrier::single;
  double carrier_hz = 1e9;  ///< Carrier::single, and the start frequency of Carrier::stepped.
  double carrier_step_hz = 0.1e9;
  int carrier_steps = 66;
  int pulses_per_step = 2;
  UserFunction<1> carrier_list_hz;  ///< y: carrier of each pulse, in turn; x is ignored; Carrier::user.

  double power_w = 1000.0;
  core::PowerRatio transmit_gain;
  core::PowerRatio receive_gain;
  core::PowerRatio losses;
  double noise_temperature_k = 0.0;

  Antenna transmit_antenna;
  bool same_antenna = true;  ///< Receive with the transmit antenna.
  Antenna receive_antenna;   ///< Where not the same.
  Beam beam = Beam::fixed;
  core::Angle beam_elevation;           ///< Beam::fixed, Beam::rotating; in the platform's frame.
  core::Angle beam_azimuth;             ///< Beam::fixed.
  core::Angle beam_rate;                ///< Per second; Beam::rotating.
  core::Vec3 spot_world_m;              ///< Beam::spot.
  UserFunction<3> beam_target_world_m;  ///< World point looked at [m] against time [s]; Beam::user.

  Window window = Window::rectangular;
  double hanning_pedestal = 0.0;
  double kaiser_beta = 2.5;           ///< Window::kaiser.
  double taylor_sidelobes_db = 35.0;  ///< Window::taylor: how far they lie below the peak.
  int taylor_equal_sidelobes = 5;     ///< Window::taylor: nbar.
  UserFunction<1> window_gain;        ///< Against the fraction of the pulse width; Window::user.
  Stc stc = Stc::none;
  UserFunction<1> stc_gain;  ///< Voltage gain against range [m]; Stc::user.

  friend bool operator==(const Radar&, const Radar&) = default;
};

}  // namespace sarsim::scene
