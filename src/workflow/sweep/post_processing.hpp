#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "core/task/observer.hpp"
#include "workflow/input/recording_input.hpp"

namespace sarsim::workflow {

/// What is made of each recording of a sweep besides.
struct PostProcessing {
  /// The command that makes it.
  enum class Kind { none, focus, search, profiles };
  Kind kind = Kind::none;
  bool measure = false;  ///< The image of `focus`.
  std::string words{};   ///< Options of the command of that kind, as in a line: "--window hamming".

  [[nodiscard]] explicit operator bool() const { return kind != Kind::none; }
};

/// A word that stands for a follow-up and no other: "focus-1a2b3c4d".
[[nodiscard]] std::string mark_of(const PostProcessing& post_processing);

/// The files named by the options of a follow-up, which it reads besides the recording.
[[nodiscard]] std::vector<std::filesystem::path> files_read_by(const PostProcessing& post_processing);

/// The command of that kind: "focus".
[[nodiscard]] const char* word_of(PostProcessing::Kind kind);

/// A number that came of a recording, as a column of the table of the sweep.
struct SweepFigure {
  std::string name;  ///< Letters, digits and '_': "target1_range_error_m".
  double value = 0.0;

  friend bool operator==(const SweepFigure&, const SweepFigure&) = default;
};

/// A recording that is followed up: a file and its script, or a script that is simulated.
struct FollowedRecording {
  RecordingArguments input;
  std::filesystem::path stem;  ///< Of the files to write, with their folder, without an extension.
  unsigned threads = 1;
  std::size_t sharers = 1;  ///< Works that run beside each other and share the memory.
  bool replace = false;     ///< Files that exist.
};

/// Figures and what was remarked on.
struct PostProcessed {
  std::vector<SweepFigure> figures;
  core::Problems remarks;
};

/// Refuses words that the command does not take, and options that the sweep decides.
void validate(const PostProcessing& post_processing);

/// The files that a recording leads to.
[[nodiscard]] std::vector<std::filesystem::path> files_of(const PostProcessing& post_processing,
                                                          const std::filesystem::path& stem);

/// Of more targets there are figures of all together alone.
inline constexpr std::size_t max_followed_targets = 20;

/// Focuses, searches or makes profiles; throws as `focus`, `measure`, `search` and `profiles` do. Figures of targets
/// that were not found are not numbers.
[[nodiscard]] PostProcessed follow(const PostProcessing& post_processing, const FollowedRecording& recording,
                                   const core::StopFlag* stop);

}  // namespace sarsim::workflow
