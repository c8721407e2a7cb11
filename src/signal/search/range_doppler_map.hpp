#pragma once

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

#include "core/task/parallel.hpp"
#include "radar/path/path.hpp"
#include "signal/compress/range_compression.hpp"

namespace sarsim::signal {

/// How pulses are gathered into maps of range and Doppler.
struct CoherentInterval {
  std::size_t pulses = 0;       ///< Of an interval, at least 1.
  std::size_t step = 0;         ///< From the first pulse of one interval to that of the next; 0: the length of one.
  std::size_t frequencies = 0;  ///< Of a map, the rest filled with zeros; 0, or at least `pulses`: as many as pulses.
  WindowFunction window;        ///< Over the pulses, argument 0 at the first and 1 at the last; empty: none.
};

/// Weights of the pulses of an interval; their sum is 1.
/// @throw  std::invalid_argument where the weights of the window cancel
[[nodiscard]] std::vector<double> pulse_weights(const CoherentInterval& interval);

/// One coherent interval. Row k is the Doppler frequency first_doppler_hz + k doppler_step_hz, from -PRF/2 on;
/// approaching targets are positive. A target of constant speed in the middle of a cell keeps its amplitude: values are
/// the weighted mean of the pulses, turned.
struct RangeDopplerMap {
  std::size_t first_pulse = 0;
  double first_doppler_hz = 0.0;
  double doppler_step_hz = 0.0;
  std::size_t frequencies = 0;
  std::size_t samples = 0;
  std::vector<std::complex<float>> values;  ///< frequencies rows of samples.

  [[nodiscard]] double doppler_hz(std::size_t row) const {
    return first_doppler_hz + static_cast<double>(row) * doppler_step_hz;
  }
  /// Speed at which a target of that row recedes.
  [[nodiscard]] double speed_mps(std::size_t row, double wavelength_m) const {
    return radar::speed_of(doppler_hz(row), wavelength_m);
  }
};

/// Maps of all whole intervals of a train of pulses, sum over p of w x[p] exp(-2 pi j k p/K)/sum of w.
/// @param volts  pulses of `samples` each, one after the other
/// @throw        std::invalid_argument where the sizes or the options make no sense; Interrupted
[[nodiscard]] std::vector<RangeDopplerMap> range_doppler_maps(std::span<const std::complex<float>> volts,
                                                              std::size_t samples, double prf_hz,
                                                              const CoherentInterval& interval,
                                                              const core::WorkControl& control);

/// Power of each cell of a map, for detection.
[[nodiscard]] std::vector<float> power_of(const RangeDopplerMap& map);

}  // namespace sarsim::signal
