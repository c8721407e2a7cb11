#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>

#include "signal/sar/image_area.hpp"
#include "signal/sar/image_spectrum.hpp"
#include "signal/sar/sar_window.hpp"

namespace sarsim::signal {

enum class FocusMethod {
  range_doppler,  ///< Interpolates in range; secondary range compression as at the middle of the swath.
  chirp_scaling,  ///< Multiplies and Fourier transforms only.
  omega_k,        ///< Exact for every aperture and squint: Stolt's interpolation.
};

/// How echoes are focused in the frequency domain.
struct FocusOptions {
  FocusMethod method = FocusMethod::omega_k;
  SarWindow range_window{};    ///< Over the pulse's band, the rest of which it sets to 0 unless it is rectangular.
  SarWindow azimuth_window{};  ///< Over the band that is kept, or, where all of it is, over the pulses.
  double doppler_centroid_hz = 0.0;         ///< True one: not modulo the pulse repetition frequency.
  double doppler_bandwidth_hz = 0.0;        ///< Kept about the centroid; 0: all.
  std::optional<ImageSpectrum> spectrum{};  ///< That the image must hold: if the samples of the recording are too far
                                            ///< apart for it, those of the image are closer. Nothing: unknown.
  std::optional<AxisInterval>
      azimuth_area{};                        ///< Rows to make; also beyond what the record's middle sees. Nothing: all.
  std::optional<AxisInterval> range_area{};  ///< Columns to make; also beyond what the beam's middle sees, as
                                             ///< `range_reach`. Nothing: all.
  /// Places that the image holds besides those that it has in any case, as far as echoes of them can be recorded; in
  /// range not by chirp scaling, whose columns are the samples. Areas cut what is beyond them. Nothing: none.
  std::optional<AxisInterval> azimuth_reach{}, range_reach{};
  std::size_t memory_bytes = 0;            ///< For the matrix that is worked on; beyond it goes to disk. 0: no limit.
  std::filesystem::path scratch_folder{};  ///< Where; empty: the system's for temporary files.
};

}  // namespace sarsim::signal
