#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/task/observer.hpp"
#include "workflow/image/in_memory_image.hpp"
#include "workflow/input/recording_input.hpp"
#include "workflow/stepped/isar_scene.hpp"

namespace sarsim::workflow {

/// What is asked of `isar`.
struct IsarRequest {
  RecordingArguments input;
  std::filesystem::path output{};       ///< Empty: named after the input; several images get numbers.
  IsarOptions options{};                ///< `platform` is found by its name; autofocus goes with Motion::estimated.
  std::string platform{};               ///< Of the target; empty: the one with the strongest targets.
  std::optional<std::size_t> bursts{};  ///< Of an image; nothing: all.
  std::size_t step = 0;                 ///< Bursts from one image to the next; 0: those of an image.
  bool magnitude = false;               ///< Also ENVI images of magnitudes.
  bool replace = false;                 ///< Replace files that exist.
  bool keep = false;                    ///< Images that no name is given for are kept, not written.
  unsigned threads = 0;                 ///< 0: one for each core; never changes a byte.
};

/// An image that was written or kept.
struct WrittenIsarImage {
  std::filesystem::path file;   ///< As it is, or would be, named.
  std::size_t first_burst = 0;  ///< Of the recording, from 0.
  std::size_t bursts = 0;
  IsarImage image;                      ///< Without values, which the file holds.
  std::optional<InMemoryImage> kept{};  ///< Where it was not written.
};

/// Images that were made of a turning target.
struct IsarReport {
  std::string source;                          ///< The input, as it was named.
  std::size_t simulation = 0;                  ///< Position in the script's list.
  std::string algorithm;                       ///< "isar-range-doppler" or "isar-back-projection".
  std::vector<std::filesystem::path> files{};  ///< That were written.
  std::vector<WrittenIsarImage> images{};
  core::Problems problems{};  ///< Warnings and notes, ranked.
  double seconds = 0.0;       ///< That the work took.
};

/// What `isar` says before it makes images of `count` bursts each, and what keeps it from that (errors).
/// @param firsts   first burst of each image
/// @param options  with the platform of the target
/// @throw Interrupted
[[nodiscard]] core::Problems diagnose_isar(const SteppedRows& rows, const std::vector<std::size_t>& firsts,
                                           std::size_t count, const IsarOptions& options,
                                           const core::WorkControl& control = {});

/// Images of a turning target, in cross-range and range (docs/theory/stepped-frequency.md). Throws core::InvalidRequest
/// with what keeps it from being done, before anything is written; Interrupted; failures of files as the sinks tell
/// them.
[[nodiscard]] IsarReport isar(const IsarRequest& request, const core::Observer& observer = {});

}  // namespace sarsim::workflow
