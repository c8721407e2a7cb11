#pragma once

#include <complex>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "core/maths/fft.hpp"

namespace sarsim::signal {

/// The waveform of a burst, the set of all pulses that make one synthetic range profile (thesis, nomenclature), and how
/// its echoes are recorded. With one step a burst is a train of pulses on one carrier.
struct SteppedWaveform {
  double first_carrier_hz = 0.0;
  double carrier_step_hz = 0.0;     ///< Negative for carriers that step down.
  std::size_t steps = 1;            ///< S
  std::size_t pulses_per_step = 1;  ///< p; a burst has S p pulses.
  std::vector<std::size_t> order;   ///< Step of each of the S positions in a burst, if carriers hop; empty: in turn.
  double pulse_width_s = 0.0;
  double sweep_rate_hz_per_s = 0.0;  ///< K of chirps, else 0.
  /// Of modulated pulses: the band about its carrier that each pulse contributes. 0: one sample for each pulse.
  double subband_hz = 0.0;
  double sample_rate_hz = 0.0;
  double first_sample_s = 0.0;  ///< Of a row, after its pulse was sent.
  std::size_t samples = 0;      ///< Of a row.
  /// One sample for each pulse: a target with the delay tau is in the samples from tau + seen_from_s to tau +
  /// seen_to_s.
  double seen_from_s = 0.0;
  double seen_to_s = 0.0;
  /// Modulated pulses: the compressed echo of a resting target of amplitude 1; element response_zero is its peak.
  std::vector<std::complex<double>> response;
  std::size_t response_zero = 0;
  /// Modulated pulses: what compresses a raw row, y[i] = sum over k of filter[k] x[i + k]; empty: rows are compressed.
  std::vector<std::complex<double>> filter;
  double light_speed_mps = 0.0;

  [[nodiscard]] std::size_t burst_pulses() const { return steps * pulses_per_step; }
  [[nodiscard]] std::size_t step_of(std::size_t pulse) const {
    return order.empty() ? pulse / pulses_per_step : order[pulse / pulses_per_step];
  }
  [[nodiscard]] double carrier_hz(std::size_t step) const {
    return first_carrier_hz + static_cast<double>(step) * carrier_step_hz;
  }
};

/// What is taken out of a pulse's echoes so that a moving target seems to rest.
struct PulseMotion {
  double delay_s = 0.0;    ///< By how much its delay is longer than at the time it is to be seen at.
  double speed_mps = 0.0;  ///< Positive receding.
};

/// The delays of the targets whose echoes a row holds.
struct SeenDelays {
  double first_s = 0.0;
  double last_s = 0.0;
};

/// The band that the pulses of a burst cover together, as evenly spaced frequencies ("cells"), and how the echoes of
/// each pulse lie in it (docs/theory/stepped-frequency.md).
///
/// One sample for each pulse: a cell for each step, at its carrier, for each range gate. Modulated pulses: the spectra
/// Y of the compressed rows, whole echoes and not cut to the row again, referred to delay 0 and placed at their
/// carriers, where a resting target of amplitude a has Y(nu) = a X(nu - f) exp(-2 pi j nu tau), X the spectrum of the
/// compressed pulse; where sub-bands overlap, the joined value is the sum of all Y over the sum of all X. Either way
/// the joined cells of that target are a exp(-2 pi j nu tau). Const members are safe to call from many threads.
class SteppedBand {
 public:
  /// @throw std::invalid_argument for a waveform without steps, samples or rates, or a response that is missing
  explicit SteppedBand(SteppedWaveform waveform);

  [[nodiscard]] const SteppedWaveform& waveform() const { return waveform_; }
  [[nodiscard]] std::size_t gates() const { return gates_; }
  [[nodiscard]] std::size_t cells() const { return cells_; }
  [[nodiscard]] double cell_hz() const { return cell_hz_; }
  [[nodiscard]] double frequency_hz(std::size_t cell) const { return first_hz_ + static_cast<double>(cell) * cell_hz_; }
  /// Middle of the band; the phase of a target is its turn over the path at this frequency.
  [[nodiscard]] double centre_hz() const { return first_hz_ + 0.5 * static_cast<double>(cells_ - 1) * cell_hz_; }
  /// B = cells times cell_hz: the resolution is c/(2 B).
  [[nodiscard]] double band_hz() const { return static_cast<double>(cells_) * cell_hz_; }
  /// Whether any pulse reaches a cell; not so between sub-bands that are narrower than the step.
  [[nodiscard]] bool filled(std::size_t cell) const { return share_.empty() || share_[cell] != std::complex<double>(); }
  /// Share of the cells that no pulse reaches.
  [[nodiscard]] double gap_share() const;

  /// The gate that shows a delay best: the sample in the middle of its echo, as far as that is recorded. `gates()`
  /// where no sample holds it; of modulated pulses, where less than half of the echo is recorded.
  [[nodiscard]] std::size_t gate_of(double delay_s) const;
  /// The first and the last delay that `gate_of` finds a gate for, seconds; those between them have one too, unless
  /// gates are farther apart than the pulse is long. Of rows shorter than half an echo the last is before the first.
  [[nodiscard]] SeenDelays seen_delays() const;

  [[nodiscard]] std::size_t values_per_pulse() const { return gates_ * pulse_cells_; }
  [[nodiscard]] std::size_t values_per_burst() const { return values_per_pulse() * waveform_.burst_pulses(); }

  /// A row as the cells of its pulse: raw, or compressed where the waveform has no filter.
  /// @param pulse    of the burst, from 0
  /// @param row      waveform().samples values
  /// @param[out] out values_per_pulse() values, gate by gate
  void place(std::size_t pulse, std::span<const std::complex<double>> row, std::span<std::complex<double>> out) const;

  /// The cells of a burst, joined, each pulse's motion taken out: a turn by exp(+2 pi j nu delay) and, for chirps, what
  /// the Doppler shift fd = -2 v f/c moves and turns their compressed echoes by (fd/K earlier, -pi fd^2/K).
  /// @param values   values_per_burst() values, as `place` makes them
  /// @param motion   one for each pulse of the burst; empty: none
  /// @param[out] out gates() * cells() values, gate by gate
  void join(std::span<const std::complex<double>> values, std::span<const PulseMotion> motion,
            std::span<std::complex<double>> out) const;

  [[nodiscard]] std::size_t first_cell(std::size_t pulse) const { return first_cell_[step_of(pulse)]; }
  [[nodiscard]] std::size_t pulse_cells() const { return pulse_cells_; }
  /// What a value of a pulse weighs in its joined cell.
  [[nodiscard]] std::complex<double> weight(std::size_t cell) const;

 private:
  [[nodiscard]] std::size_t step_of(std::size_t pulse) const { return waveform_.step_of(pulse); }
  void lay_out_samples();
  void lay_out_subbands();
  void add_filter(double first_hz);
  void transform(std::span<const std::complex<double>> row, double first_s, double first_hz,
                 std::span<std::complex<double>> out) const;

  SteppedWaveform waveform_;
  std::size_t gates_ = 1;
  std::size_t cells_ = 0;
  std::size_t pulse_cells_ = 1;
  double first_hz_ = 0.0;
  double cell_hz_ = 0.0;
  std::vector<std::size_t> first_cell_;       // of each step
  std::vector<std::complex<double>> share_;   // 1/(sum of X) of each cell, 0 where there is none; empty: 1
  std::vector<std::complex<double>> filter_;  // of each step, its spectrum at the step's cells; empty: 1
  std::shared_ptr<const core::Fft> fft_;
};

}  // namespace sarsim::signal
