#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

#include "core/report/problem.hpp"
#include "workflow/input/recording_input.hpp"
#include "workflow/search/search_intervals.hpp"

namespace sarsim::workflow {

/// Cells of a map to either side of one.
struct CellReach {
  std::size_t columns = 0;  ///< In range.
  std::size_t rows = 0;     ///< In Doppler.
};

/// "16" or "8:2": cells of range and, behind a colon, of Doppler, 0 to 100000 each; nothing for another text.
[[nodiscard]] std::optional<CellReach> cells_from_text(const std::string& text);

/// What `doppler` and `search` are asked for alike.
struct PulseRequest {
  RecordingArguments input;
  std::filesystem::path output{};       ///< The image; empty: named after the input.
  std::filesystem::path table{};        ///< Of detections; empty: named after the image, with "-detections.csv".
  std::optional<std::size_t> pulses{};  ///< Of a coherent interval; nothing: each workflow's own number.
  std::size_t step = 0;                 ///< Pulses from one interval to the next; 0: the length of one.
  std::size_t frequencies = 0;          ///< Doppler rows of a map; 0: as many as pulses.
  std::size_t canceller = 0;            ///< Order: 1 for two pulses, 2 for three; 0 for none.
  signal::SarWindow window{};           ///< Over the pulses.
  bool detect = true;                   ///< Look for what stands out of the noise.
  signal::CfarOptions::Kind detector = signal::CfarOptions::Kind::cell_averaging;
  std::optional<CellReach> guard{};     ///< Cells that do not count as noise; nothing: 2 range cells, at least 2.
  std::optional<CellReach> train{};     ///< Cells beyond those that do; nothing: 16 of range.
  std::optional<double> false_alarm{};  ///< Probability for a cell, 1e-15 to 0.5; nothing: 1e-6.
  std::optional<double> rank{};         ///< Share of the ordered cells, above 0, at most 1; nothing: 0.75.
  bool all_cells = false;               ///< Report every cell above its threshold, not only peaks.
  bool image = true;                    ///< Write the image, not only detections.
  bool replace = false;                 ///< Replace files that exist.
  bool keep = false;                    ///< What no name is given for is kept, not written.
  unsigned threads = 0;                 ///< 0: one for each core; never changes a byte.
};

/// What is wrong with the options themselves, whatever they are used on: numbers out of range, and what says how to
/// detect where nothing is detected.
[[nodiscard]] core::Problems problems_of_request(const PulseRequest& request);

/// The options of the work on some pulses; throws core::InvalidRequest with `problems_of_request`.
/// @param usual_pulses  of an interval, where none are given
[[nodiscard]] SearchOptions search_options(const PulseRequest& request, const simulate::Acquisition& acquisition,
                                           std::size_t usual_pulses);

}  // namespace sarsim::workflow
