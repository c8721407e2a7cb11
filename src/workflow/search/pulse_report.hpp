#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/report/problem.hpp"
#include "workflow/image/in_memory_image.hpp"
#include "workflow/search/search_targets.hpp"

namespace sarsim::workflow {

/// What `doppler` and `search` found alike.
struct PulseReport {
  std::string source;                          ///< The input, as it was named.
  std::size_t simulation = 0;                  ///< Position in the script's list.
  std::vector<std::filesystem::path> files{};  ///< That were written: the image with its header, the table.
  std::filesystem::path table{};               ///< Of detections, where there are any to look for.
  std::optional<InMemoryImage> kept{};         ///< The image, where it was not written.
  std::string kept_table{};                    ///< Of detections, where it was not written, as its file would be.
  SearchOptions options;
  std::size_t intervals = 0;
  std::size_t reference_cells = 0;  ///< Of a cell in the middle of a map; 0 without a detector.
  double independent_cells = 0.0;   ///< That those are worth.
  std::size_t detections = 0;
  double expected_false_alarms = 0.0;     ///< Cells above their thresholds in noise alone.
  std::vector<TargetFinding> findings{};  ///< The first targets of the script and what became of them.
  core::Problems problems{};              ///< Warnings and notes, ranked.
  double seconds = 0.0;                   ///< That the work took.

  /// Whether there is more than a pulse in an interval.
  [[nodiscard]] bool doppler() const { return options.pulses > 1; }
};

}  // namespace sarsim::workflow
