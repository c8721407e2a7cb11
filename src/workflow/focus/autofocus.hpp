#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/task/parallel.hpp"
#include "signal/sar/focusing.hpp"
#include "workflow/focus/azimuth_ambiguities.hpp"

namespace sarsim::workflow {

/// What autofocus did to an image.
struct AutofocusFinding {
  double piece_m = 0.0;
  std::vector<double> along_m;    ///< Places of the antenna, from the image's azimuth 0.
  std::vector<double> phase_rad;  ///< That was taken out of the echoes received there.
  double rms_rad = 0.0;           ///< Of what was taken out of the image, without the lines that points keep.
  double entropy_before = 0.0;
  double entropy_after = 0.0;
  bool applied = false;  ///< Not where it failed: the image is then as it was.
  /// Standard deviation of pixel power over its mean: the larger, the sharper.
  double contrast_before = 0.0;
  double contrast_after = 0.0;
  /// Number of points by which the image was judged: targets that stand out of their surroundings, or other points if
  /// there are no targets.
  std::size_t points = 0;
  double point_gain_db = 0.0;        ///< Median gain of their peaks.
  double point_snr_before_db = 0.0;  ///< Median ratio of their peaks to the noise around them.
  double point_snr_after_db = 0.0;
  std::optional<double>
      point_level_db{};  ///< Median of their peaks afterwards, relative to the mean of their echoes; targets only.
};

/// Whether autofocus failed, in words: the image would lose sharpness or contrast, hardly gain any although much was
/// found, no point stands out, the points' peaks fall, their SNR does not grow as taking out such an error makes it
/// grow, or they stay far below what their echoes give. Empty where it did not. Noise alone gains some sharpness, but
/// no such peaks; points that smear gain SNR, but lose their peaks.
[[nodiscard]] std::string failure_of(const AutofocusFinding& finding);

/// The same as a warning that says what to try.
[[nodiscard]] core::Problems diagnose_autofocus(const AutofocusFinding& finding);

/// How it is to go to work.
struct AutofocusChoice {
  double piece_m = 0.0;          ///< Length of the pieces that are looked at one by one; 0: a tenth of the synthetic
                                 ///< aperture that the targets have, or of the flight where there are none, but sixteen
                                 ///< rows at least.
  std::size_t memory_bytes = 0;  ///< 0: no limit.
};

/// Throws core::InvalidRequest where an image with these axes is too short for the pieces, or the memory too small for
/// it.
/// @param echoes   their track and waveform
/// @param targets  from the line of the track (`targets_from_line`)
void expect_autofocus(const signal::FocusedImage& axes, const signal::EchoRows& echoes,
                      const std::vector<SarTarget>& targets, const AutofocusChoice& choice,
                      const signal::FocusOptions& options);

/// Phase gradient autofocus of a strip (signal/sar/autofocus.hpp), in memory, at the Doppler frequencies that the
/// targets have. The image, sharper where it was, and what was found. core::InvalidRequest as above.
[[nodiscard]] std::pair<signal::FocusedRows, AutofocusFinding> autofocused(
    const signal::FocusedRows& rows, const signal::EchoRows& echoes, const std::vector<SarTarget>& targets,
    const AutofocusChoice& choice, const signal::FocusOptions& options, const core::WorkControl& control);

/// Writes places and phases as CSV: along_m, phase_rad.
void write_phase(const AutofocusFinding& finding, const std::filesystem::path& path, bool replace);

}  // namespace sarsim::workflow
