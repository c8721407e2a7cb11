#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "core/task/observer.hpp"
#include "workflow/input/input_list.hpp"
#include "workflow/search/detection_table.hpp"
#include "workflow/search/pulse_input.hpp"
#include "workflow/search/pulse_report.hpp"
#include "workflow/search/pulse_request.hpp"

namespace sarsim::workflow {

/// What `doppler` and `search` do alike: they open the pulses, check before they begin, work through the intervals,
/// write the table of detections and report.
class PulsePipeline {
 public:
  /// Keeps references.
  /// @param suffix  of the usual name of the image: "-doppler" for "scene-doppler.img"
  PulsePipeline(const PulseRequest& request, const core::Observer& observer, std::string suffix);

  /// Opens the input and decides the options; throws core::InvalidRequest with all problems. Warnings are remarked on.
  /// @param usual_pulses  of an interval
  /// @param more_bytes    that are held besides the intervals
  void open(const std::function<std::size_t(const simulate::Acquisition&)>& usual_pulses,
            const std::function<double(const PulseRows&)>& more_bytes);

  [[nodiscard]] const PulseInput& input() const { return input_; }
  [[nodiscard]] const PulseRows& rows() const { return input_.rows; }
  [[nodiscard]] const simulate::Acquisition& acquisition() const { return *input_.rows.acquisition; }
  [[nodiscard]] const SearchOptions& options() const { return options_; }
  [[nodiscard]] std::size_t intervals() const { return interval_count(options_, rows().pulses()); }
  /// Where the image goes: as asked for, or named after the input.
  [[nodiscard]] std::filesystem::path output() const;
  /// Whether the image is kept, not written.
  [[nodiscard]] bool keeps_image() const { return request_.keep && request_.output.empty(); }
  /// Whether there is more than a pulse in an interval.
  [[nodiscard]] bool doppler() const { return options_.pulses > 1; }

  /// Where a detection lies on the ground.
  using Placing = std::function<GroundPlace(const SearchInterval&, const SearchDetection&)>;

  /// All intervals with their detections, which go into the table and are held against the targets.
  void detect(const Placing& place, const std::function<void(const SearchInterval&)>& consume);
  /// The same without detections, for what must be known beforehand.
  void look_through(const std::string& stage, const std::function<void(const SearchInterval&)>& consume);

  /// What was found, once `detect` has returned.
  [[nodiscard]] PulseReport report() const;

  /// Fields of an image's header that say what was worked on.
  [[nodiscard]] std::vector<std::pair<std::string, std::string>> origin_fields() const;

 private:
  [[nodiscard]] std::filesystem::path table() const;
  [[nodiscard]] bool keeps_table() const { return request_.keep && request_.table.empty(); }
  [[nodiscard]] std::vector<std::filesystem::path> files() const;
  void expect_free_files(const InputList& sources) const;
  void find_problems(double more_bytes);
  void each(const std::string& stage, const SearchOptions& options,
            const std::function<void(const SearchInterval&)>& consume);

  const PulseRequest& request_;
  const core::Observer& observer_;
  std::string suffix_;
  core::WorkControl control_;
  double begin_s_;
  PulseInput input_;
  SearchOptions options_;
  std::vector<TargetFinding> findings_;
  std::size_t detections_ = 0;
  std::string kept_table_;
};

}  // namespace sarsim::workflow
