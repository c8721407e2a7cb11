#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/task/observer.hpp"
#include "signal/sar/sar_window.hpp"
#include "workflow/image/in_memory_image.hpp"
#include "workflow/input/recording_input.hpp"
#include "workflow/stepped/profile_series.hpp"
#include "workflow/stepped/velocity_choice.hpp"

namespace sarsim::workflow {

/// What becomes a profile: each burst, each scan or the whole encounter.
enum class ProfileGrouping { bursts, scans, encounter };

/// The word for it: "bursts", "scans" or "encounter".
[[nodiscard]] const char* word_of(ProfileGrouping grouping);

/// What is asked of `profiles`.
struct ProfilesRequest {
  RecordingArguments input;
  std::filesystem::path output{};  ///< Empty: named after the input.
  ProfileGrouping set = ProfileGrouping::bursts;
  VelocityChoice velocity{};
  double fastest_mps = 500.0;                 ///< Estimated speeds are searched from minus this to this.
  std::optional<signal::SarWindow> window{};  ///< Over the band; nothing: the script's.
  std::optional<double> from_m{};             ///< Ranges; nothing: `shown_ranges`.
  std::optional<double> to_m{};
  std::size_t oversampling = 4;        ///< Bins for each resolution cell.
  double illumination_db = 6.0;        ///< Bursts within so many dB of the strongest, two-way, belong to a scan.
  std::optional<std::size_t> burst{};  ///< From 0: held against the scene; nothing: the middle of the strongest scan.
  bool align = false;                  ///< Show targets where they are in the middle of their scan; means always do.
  bool replace = false;                ///< Replace files that exist.
  bool keep = false;                   ///< Profiles that no name is given for are kept, not written.
  unsigned threads = 0;                ///< 0: one for each core; never changes a byte.
};

/// Profiles that were made, and the targets of the scene in one of them.
struct ProfilesReport {
  std::string source;          ///< The input, as it was named.
  std::size_t simulation = 0;  ///< Position in the script's list.
  std::filesystem::path output{};
  std::vector<std::filesystem::path> files{};  ///< That were written.
  std::optional<InMemoryImage> kept{};         ///< What was not.
  ProfileGrouping set = ProfileGrouping::bursts;
  SeriesOptions::Velocity velocity = SeriesOptions::Velocity::none;
  std::size_t bursts = 0;                    ///< Whole ones of the recording.
  ProfileSeries series;                      ///< Of the illuminated bursts, one by one.
  std::size_t held_row = 0;                  ///< Of the series: which is held against the scene.
  std::vector<HeldTarget> targets{};         ///< The scene's, in that profile.
  std::vector<signal::ProfilePeak> peaks{};  ///< The highest of that profile.
  core::Problems problems{};                 ///< Warnings and notes, ranked.
  double seconds = 0.0;                      ///< That the work took.
};

/// What `profiles` says of the bursts before it works, for a choice of the speed that is compensated.
[[nodiscard]] core::Problems diagnose_profiles(const SteppedRows& rows, const VelocityChoice& velocity);

/// Range profiles of a stepped carrier (docs/theory/stepped-frequency.md), written in the format of the output's
/// extension. Throws core::InvalidRequest with what keeps it from being done, before anything is written; Interrupted;
/// failures of files as the sinks tell them.
[[nodiscard]] ProfilesReport profiles(const ProfilesRequest& request, const core::Observer& observer = {});

}  // namespace sarsim::workflow
