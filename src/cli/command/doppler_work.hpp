#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "cli/command/doppler_options.hpp"
#include "cli/command/doppler_report.hpp"
#include "cli/shell/context.hpp"
#include "core/text/json.hpp"

namespace sarsim::cli {

/// What `sarsim doppler` and `sarsim search` do alike: they open the pulses, check before they begin, work through the
/// intervals, write the table of detections and report.
class PulseWork {
 public:
  /// @param suffix  of the usual name of the image: "-doppler" for "scene-doppler.img"
  PulseWork(const SearchArguments& arguments, Streams& streams, std::string suffix);

  /// Opens the input and decides the options; throws core::Refused with all problems. Warnings are printed.
  /// @param usual_pulses  of an interval
  /// @param more_bytes    that the command holds besides the intervals
  void open(const std::function<std::size_t(const simulate::Plan&)>& usual_pulses,
            const std::function<double(const workflow::PulseRows&)>& more_bytes);

  [[nodiscard]] const workflow::PulseInput& input() const { return input_; }
  [[nodiscard]] const workflow::PulseRows& rows() const { return input_.rows; }
  [[nodiscard]] const simulate::Plan& plan() const { return *input_.rows.plan; }
  [[nodiscard]] const workflow::SearchOptions& options() const { return options_; }
  [[nodiscard]] std::size_t intervals() const { return workflow::interval_count(options_, rows().pulses()); }
  /// Where the image goes: as asked for, or named after the input.
  [[nodiscard]] std::filesystem::path output() const;
  /// Whether there is more than a pulse in an interval.
  [[nodiscard]] bool doppler() const { return options_.pulses > 1; }

  /// Where a detection lies on the ground.
  using Placing = std::function<GroundPlace(const workflow::SearchInterval&, const workflow::SearchDetection&)>;

  /// All intervals with their detections, which go into the table and are held against the targets.
  void detect(const Placing& place, const std::function<void(const workflow::SearchInterval&)>& consume);
  /// The same without detections, for what must be known beforehand.
  void look_through(const std::string& label, const std::function<void(const workflow::SearchInterval&)>& consume);

  /// Summary, targets and, where asked for, JSON. Throws like `write_out`.
  /// @param image  what the command says about its image: a sentence, and members of the JSON object
  void report(const std::string& image, const std::function<void(core::JsonWriter&)>& members);

  /// Fields of an image's header that say what was worked on.
  [[nodiscard]] std::vector<std::pair<std::string, std::string>> origin_fields() const;

 private:
  [[nodiscard]] std::filesystem::path table() const;
  [[nodiscard]] std::vector<std::filesystem::path> files() const;
  void expect_free_outputs(const std::vector<std::filesystem::path>& sources) const;
  void find_problems(double more_bytes);
  void each(const std::string& label, const workflow::SearchOptions& options,
            const std::function<void(const workflow::SearchInterval&)>& consume);
  [[nodiscard]] double expected_false_alarms() const;
  void write_report(const std::function<void(core::JsonWriter&)>& members);

  const SearchArguments& arguments_;
  Streams& streams_;
  std::string suffix_;
  core::WorkControl control_;
  double begin_s_;
  workflow::PulseInput input_;
  workflow::SearchOptions options_;
  std::vector<workflow::TargetFinding> findings_;
  std::size_t detections_ = 0;
};

}  // namespace sarsim::cli
