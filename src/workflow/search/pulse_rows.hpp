#pragma once

#include <complex>
#include <cstddef>
#include <memory>
#include <vector>

#include "core/task/sample_rows.hpp"
#include "simulate/plan/acquisition.hpp"
#include "workflow/focus/sar_rows.hpp"

namespace sarsim::workflow {

/// Compressed pulses of a simulation, a row for each, computed or read when they are asked for: what a pulse-Doppler or
/// a search radar begins with.
struct PulseRows : core::SampleRows<float> {
  std::shared_ptr<const simulate::Acquisition> acquisition;
  std::vector<double> range_m;  ///< One way, of each sample.
  double peak_gain = 1.0;       ///< Height of a compressed echo of amplitude 1.
  double noise_w = 0.0;         ///< Mean square magnitude of the receiver's noise in a sample, without STC.
  /// Of complex samples 0, 1 ... apart (signal/search/cfar_calibration.hpp).
  std::vector<std::complex<double>> noise_correlation{1.0};

  [[nodiscard]] std::size_t pulses() const { return rows; }
  [[nodiscard]] std::size_t samples() const { return columns; }
  /// Number of a pulse in the radar's schedule.
  [[nodiscard]] std::int64_t number(std::size_t pulse) const {
    return acquisition->timing.pulses.first + static_cast<std::int64_t>(pulse);
  }
};

/// The simulation as it has to be planned for `pulse_rows_of_scene`: compressed.
[[nodiscard]] scene::Simulation compressed_simulation(const scene::Simulation& simulation);

/// Pulses of a scene: those that a run with a matched filter would record, window, profile and all.
/// @param acquisition  of a simulation made by `compressed_simulation`
[[nodiscard]] PulseRows pulse_rows_of_scene(const std::shared_ptr<const simulate::Acquisition>& acquisition);

/// Pulses of a recording : compressed ones as they are, raw ones through the matched filter of the
/// physical profile with the radar's window (docs/theory/compression.md).
/// @param recorded  rows like those that the acquisition makes
/// @throw  std::invalid_argument for synthetic range profiles
[[nodiscard]] PulseRows pulse_rows_of_recording(const std::shared_ptr<const simulate::Acquisition>& acquisition,
                                                core::SampleRows<double> recorded);

}  // namespace sarsim::workflow
