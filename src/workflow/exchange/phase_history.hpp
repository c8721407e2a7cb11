#pragma once

#include <complex>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/maths/fft.hpp"
#include "radar/echo/direct_kernel.hpp"
#include "workflow/exchange/collection.hpp"

namespace sarsim::workflow {

/// The frequencies of a phase history: sample k of a vector stands at its carrier + (first_bin + k) step_hz.
struct FrequencyGrid {
  std::size_t transform = 0;   ///< Length of the transform of a row.
  std::int64_t first_bin = 0;  ///< Below 0 but for bands of a single sample.
  std::size_t samples = 0;
  double step_hz = 0.0;
};

/// All frequencies within half the pulse's bandwidth of the carrier. The transform holds a row and a pulse, so that
/// nothing overlaps, and its step is at most 1/(1.2 times the swath).
[[nodiscard]] FrequencyGrid frequency_grid(const simulate::Acquisition& acquisition);

/// From when to when echoes may arrive so that all of their pulse is within the recorded window: first and last light
/// time, s; the first is the greater one where the window is shorter than the pulse.
struct DelaySpan {
  double first_s = 0.0;
  double last_s = 0.0;
};
[[nodiscard]] DelaySpan whole_echoes(const simulate::Acquisition& acquisition);

/// What the pulses of a collection have between them.
struct CollectionExtent {
  double first_tx_s = 0.0, last_tx_s = 0.0;     ///< Send times, from the start of the file.
  double min_delay_s = 0.0, max_delay_s = 0.0;  ///< Light times to the reference point and back.
  double min_carrier_hz = 0.0, max_carrier_hz = 0.0;
};
/// Looks at the geometry of all pulses.
[[nodiscard]] CollectionExtent extent_of(const Collection& collection, const core::WorkControl& control);

/// The samples of a phase history and the swath in which echoes are there as a whole in all vectors.
struct HistoryShape {
  FrequencyGrid grid;
  double toa1_s = 0.0;  ///< Times of arrival after that of the reference point,
  double toa2_s = 0.0;  ///< not above `toa1_s` where no echo is whole in all of them.
};
[[nodiscard]] HistoryShape history_shape(const Collection& collection, const CollectionExtent& extent);

/// Makes the phase history of a recording in FX, pulse by pulse; each thread has its own.
///
/// The spectrum of a row is divided by that of the echo of a virtual target at the reference point, of amplitude 1, as
/// the same receiver would have recorded it:
///
///     S(f + m fs/L) = FFT(row)[m]/FFT(row of the reference point)[m] = sum over targets of A exp(-2 pi j (f + m fs/L)
///     dt)
///
/// dt the light time to the target less that to the reference point; so all that both have in common cancels: pulse and
/// band limit, pulse position, filters, carrier phase, stretch. A in sqrt W.
class PhaseHistory {
 public:
  /// Keeps a reference.
  PhaseHistory(const Collection& collection, const HistoryShape& shape);

  /// The vector of a row, with band, times of arrival and first frequency; amplitude 1. No samples are read.
  [[nodiscard]] raster::PhaseVector vector_of(std::size_t row);
  /// The same with its samples.
  /// @param[out] samples  as many as the grid has
  raster::PhaseVector make(std::size_t row, std::span<std::complex<double>> samples);
  /// Magnitudes of the spectrum by which a row is divided: the smallest within the band over the largest.
  [[nodiscard]] double weakest_share(std::size_t row);

 private:
  [[nodiscard]] raster::PhaseVector with_band(const CollectedPulse& pulse) const;
  void transform_reference(const CollectedPulse& pulse);
  [[nodiscard]] std::size_t bin_of(std::size_t sample) const;

  const Collection* collection_;
  HistoryShape shape_;
  FrequencyGrid grid_;
  CollectionGeometry geometry_;
  core::Fft fft_;
  std::int64_t before_ = 0;  // samples of the reference's row before the one at its delay
  radar::SampleGrid reference_grid_;
  radar::DirectKernel kernel_;
  radar::EchoBatch echo_;
  std::vector<std::complex<double>> echo_row_;
  std::vector<std::complex<double>> reference_;  // its spectrum
  std::vector<std::complex<double>> row_;
};

}  // namespace sarsim::workflow
