#pragma once

#include <complex>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "signal/sar/sar_window.hpp"

namespace sarsim::signal {

/// Figures of a response along a line, in the unit of its samples' spacing.
struct ResponseFigures {
  double width = 0.0;    ///< Between the points 3.01 dB (half the power) below the peak.
  double null = 0.0;     ///< Mean distance of the first minimum on either side from the peak.
  double pslr_db = 0.0;  ///< Largest sidelobe, relative to the peak.
  /// Energy beyond the first nulls, up to ten null distances further on each side, relative to that between them.
  double islr_db = 0.0;
};

/// Width of the response of an even spectrum between its half powers, in units of the inverse bandwidth: the w at which
/// sin(pi w/2)/(pi w/2) is 1/sqrt(2).
inline constexpr double even_response_width = 0.8858929413789;

/// Null distances beyond the first nulls, on each side, that the integrated sidelobes are counted over.
inline constexpr double islr_null_widths = 10.0;

/// Measures a finely sampled response (32 samples or more to its width).
/// @param peak  index of the largest sample
/// @return nothing where the samples do not reach beyond a first minimum on either side
[[nodiscard]] std::optional<ResponseFigures> figures_of(std::span<const std::complex<double>> response,
                                                        std::size_t peak);

/// A response at evenly spaced positions.
struct SampledResponse {
  std::vector<std::complex<double>> values;
  std::size_t peak = 0;
  double per_lag = 1.0;  ///< Values to the inverse bandwidth.
};

/// What becomes of a chirp's spectrum beyond half the sampling rate.
enum class BeyondSampling {
  folded,  ///< It aliases, in phase with the rest: for echoes that peak at a sample.
  lost,    ///< It averages to 0: over an aperture in which the echo migrates through samples.
};

/// The response whose figures `theoretical_figures` gives, with 64 values or more to the inverse bandwidth. For a
/// chirp without window and filter the peak is 1, less what is lost; for an even spectrum the scale has no meaning.
[[nodiscard]] SampledResponse theoretical_response(const SarWindow& window, double time_bandwidth, double sampling,
                                                   const std::function<double(double)>& filter, BeyondSampling beyond);

/// The figures that a response has in theory, in units of the inverse bandwidth.
/// @param time_bandwidth  of the chirp whose matched filter it is, with a rectangular envelope; 0: an even spectrum
/// @param window          over the band, the rest of which it sets to 0 unless it is rectangular
/// @param sampling        sampling rate over bandwidth: what of a chirp's spectrum lies beyond half of it folds back.
///                        0: fine sampling
/// @param filter          weights of the chirp's matched filter against the fraction of the pulse, besides the window
[[nodiscard]] ResponseFigures theoretical_figures(const SarWindow& window, double time_bandwidth = 0.0,
                                                  double sampling = 0.0,
                                                  const std::function<double(double)>& filter = {});

}  // namespace sarsim::signal
