#pragma once

#include <complex>
#include <span>
#include <vector>

#include "radar/waveform/pulse.hpp"

namespace sarsim::radar {

/// A pulse confined to the band [-F, F] (decision 7): the hard-edged pulse p after the linear-phase filter
///
///     h(t) = 2 Fc sinc(2 Fc t) exp(beta (sqrt(1 - (t/Th)^2) - 1)),   |t| <= Th,
///
/// with Fc = 0.92 F, Th = 28/F and beta = 14. Its response is 1 to 1e-6 up to 0.84 F and below 1e-6 (-120 dB) beyond F,
/// and it has ended 28/F before and after the pulse, so that an echo touches a finite number of samples. Window: the
/// exponential of a semicircle (Barnett, Magland, af Klinteberg 2019). Where a kept width is given, the filtered pulse
/// is cut hard to that length about its centre, as the original's "pulse width used".
///
/// Values come from a table at `samples_per_interval` times the sampling rate, at least 4 times the Nyquist rate of the
/// band, by a 24-point tapered sinc: within 1e-9 of the integral for a pulse of at most 1.
class BandLimitedPulse {
 public:
  /// @param half_band_hz   F; positive.
  /// @param sample_rate_hz of the recordings it will be sampled for: the table's step divides the sampling interval.
  /// @param kept_width_s   0: all of it.
  BandLimitedPulse(const Pulse& pulse, double half_band_hz, double sample_rate_hz, double kept_width_s);

  /// The pulse is 0 before this time after the leading edge of the hard-edged pulse (negative), [s].
  [[nodiscard]] double first_s() const { return first_s_; }
  /// ... and from this time on.
  [[nodiscard]] double last_s() const { return last_s_; }

  /// F, half of the band [Hz].
  [[nodiscard]] double half_band_hz() const { return half_band_hz_; }

  /// Value at `t_s` after the leading edge of the hard-edged pulse. A time closer than 1e-9 of a sampling interval to
  /// `first_s` or `last_s` counts as on it (decision 8).
  [[nodiscard]] std::complex<double> value(double t_s) const;

  /// Values at t_s + i/sample_rate for i = 0 ... out.size() - 1; the same numbers as `value`, faster.
  void values(double t_s, std::span<std::complex<double>> out) const;

 private:
  static constexpr int taps = 24;
  struct Taps;
  [[nodiscard]] Taps taps_at(double fraction) const;
  void fill_table(const Pulse& pulse, double half_band_hz);
  void filter_table(double half_band_hz);

  double half_band_hz_ = 0.0;
  double first_s_ = 0.0;
  double last_s_ = 0.0;
  double table_start_s_ = 0.0;
  double table_rate_hz_ = 1.0;
  std::ptrdiff_t samples_per_interval_ = 1;
  std::vector<std::complex<double>> table_;
};

}  // namespace sarsim::radar
