#pragma once

#include <cstddef>
#include <cstdint>

#include "radar/waveform/schedule.hpp"
#include "scene/model/recording.hpp"
#include "simulate/resolve/link.hpp"

namespace sarsim::simulate {

/// Which pulses are simulated, and which of them make which row.
struct Timing {
  radar::PulseRange pulses;         ///< All pulses of the window.
  std::int64_t row_pulses = 1;      ///< Of a row: those of a burst for synthetic range profiles.
  std::int64_t first_row_at = 0;    ///< Number of the first row among all rows of so many pulses, counted from pulse 0.
  std::int64_t dropped_pulses = 0;  ///< Pulses of incomplete bursts at either end.
  std::size_t rows = 0;

  /// First (or only) pulse of a product row.
  [[nodiscard]] std::int64_t first_pulse_of_row(std::size_t row) const {
    return (first_row_at + static_cast<std::int64_t>(row)) * row_pulses;
  }
  /// Row that a pulse belongs to, beyond the ends for pulses outside.
  [[nodiscard]] std::int64_t row_of(std::int64_t pulse) const {
    return radar::floor_divide(pulse, row_pulses) - first_row_at;
  }
};

/// The pulses of a recording's window; whole bursts alone make rows of synthetic range profiles.
[[nodiscard]] Timing timing_of(const Link& link, const scene::Simulation& simulation);

}  // namespace sarsim::simulate
