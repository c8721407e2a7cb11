#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

#include "core/report/problem.hpp"
#include "core/task/parallel.hpp"
#include "core/task/progress.hpp"
#include "signal/sar/image_area.hpp"
#include "signal/sar/image_spectrum.hpp"
#include "signal/sar/sar_echoes.hpp"
#include "signal/sar/sar_image.hpp"
#include "signal/sar/sar_window.hpp"

/// Focusing in the frequency domain: straight track, constant speed, evenly spaced pulses (docs/theory/focusing.md).
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

/// A focused image that need not be in memory.
struct FocusedRows : core::SampleRows<float> {
  FocusedImage image;  ///< Without values.
  bool on_disk = false;
};

/// The rows of an image in memory, which they keep there.
[[nodiscard]] FocusedRows rows_of(const std::shared_ptr<const FocusedImage>& image);

/// All rows of an image in memory.
[[nodiscard]] FocusedImage in_memory(const FocusedRows& rows);

inline constexpr const char* track_field = "track";

/// What prevents or limits focusing these echoes in the frequency domain, all at once: no speed, pulses that are not
/// evenly spaced (by more than 1 % of the interval), a band beyond the sampling rates, options out of range (errors); a
/// track that leaves the straight line by more than a sixteenth of the wavelength (a warning). Problems of the track's
/// shape have the field `track_field`.
[[nodiscard]] core::Problems problems_of_focusing(const EchoRows& echoes, const FocusOptions& options);

/// What prevents focusing them by back projection: of these the errors that concern neither the track's shape nor
/// the Fourier transforms, and rows of a single sample.
[[nodiscard]] core::Problems problems_of_focusing_in_time(const EchoRows& echoes, const FocusOptions& options);

/// The axes and the frame of the image that `focus_rows` makes, without values; also of tracks that it refuses, if only
/// they have two pulses and a speed.
[[nodiscard]] FocusedImage image_of(const EchoRows& echoes, const FocusOptions& options);

/// Focuses. Rows of the image are pulse positions, columns slant ranges of closest approach; phase and amplitude as
/// FocusedImage says. The same bytes for any number of threads and any limit of memory.
///
/// @throws std::invalid_argument  where `problems_of_focusing` finds an error
/// @throws Interrupted
[[nodiscard]] FocusedRows focus_rows(const EchoRows& echoes, const FocusOptions& options,
                                     const core::WorkControl& control, const core::ProgressReport& progress = {});

/// The same in memory.
[[nodiscard]] FocusedImage focus(const SarEchoes& echoes, const FocusOptions& options,
                                 const core::WorkControl& control = {});

/// Doppler centroid of the data, from the mean phase step between pulses (Madsen, IEEE Trans. AES-25, 1989), of all
/// that differ from `near_hz` by whole pulse repetition frequencies the nearest to it.
[[nodiscard]] double measured_doppler_centroid_hz(const EchoRows& echoes, double near_hz,
                                                  const core::WorkControl& control = {});

/// 2 V sin(squint)/wavelength: the Doppler frequency of a beam that looks `squint_rad` ahead of the plane across track.
[[nodiscard]] double doppler_centroid_hz(const SarWaveform& waveform, double speed_mps, double squint_rad);

}  // namespace sarsim::signal
