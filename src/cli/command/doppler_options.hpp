#pragma once

#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "workflow/search/pulse_request.hpp"

namespace sarsim::cli {

/// Pulses that a canceller of resting echoes takes the difference of.
enum class Canceller { none, two, three };
/// How the threshold of detections is found: from the mean or from a rank of the cells around; or nothing is detected.
enum class Detector { cell_averaging, ordered_statistic, none };

/// What the commands that work on pulses take alike.
struct SearchArguments {
  workflow::RecordingArguments input;
  std::string output;
  std::string detections;
  std::optional<std::int64_t> interval;
  std::optional<std::int64_t> step;
  std::optional<std::int64_t> frequencies;
  std::string window;
  std::optional<Canceller> canceller;
  std::optional<Detector> detector;
  std::string guard;
  std::string train;
  std::optional<double> false_alarm;
  std::optional<double> rank;
  std::optional<std::int64_t> threads;
  bool all_cells = false;
  bool no_map = false;
  bool force = false;
  bool json = false;
  bool quiet = false;
};

/// Adds the input and all options that they share.
/// @param output       what --out writes, for the help
/// @param usual_pulses of an interval, for the help
void add_search_arguments(CLI::App& app, SearchArguments& arguments, const std::string& output,
                          const std::string& usual_pulses);

/// What the arguments ask for; throws core::Refused with every mistake where one cannot be read.
[[nodiscard]] workflow::PulseRequest pulse_request(const SearchArguments& arguments);

}  // namespace sarsim::cli
