#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string_view>

#include "core/report/problem.hpp"
#include "core/task/parallel.hpp"
#include "core/task/progress.hpp"
#include "signal/sar/focus_options.hpp"
#include "signal/sar/sar_echoes.hpp"
#include "signal/sar/sar_image.hpp"

/// Focusing in the frequency domain: straight track, constant speed, evenly spaced pulses (docs/theory/focusing.md).
namespace sarsim::signal {

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
