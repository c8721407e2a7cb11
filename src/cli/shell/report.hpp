#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/report/problem.hpp"
#include "core/text/counted.hpp"
#include "core/text/json.hpp"
#include "core/text/problem_json.hpp"
#include "scene/model/scene.hpp"
#include "simulate/plan/sink.hpp"

namespace sarsim::cli {

/// What a finished recording turned out to be.
struct RecordingReport {
  std::string file;  ///< Empty where nothing was written.
  scene::Simulation simulation;
  scene::RunOptions options;
  std::string engine;
  std::string engine_reason;  ///< Why this engine.
  simulate::RunReport run;
  std::optional<double> bytes;  ///< Of the file; none where nothing was written.
  double seconds = 0.0;         ///< With the estimate of the LSB.
  bool counts = false;          ///< The file holds counts of the converter, not volts.
  core::Problems warnings;
};

/// What a finished geometry table turned out to be.
struct TableReport {
  std::string file;
  std::string radar;
  double bytes = 0.0;
  double seconds = 0.0;
};

/// The summary that the original program gave after a run: size, time, largest magnitude in mV and the share of the
/// converter's range that it used, best LSB in mV, shares of saturated and zero samples. Several lines.
[[nodiscard]] std::string report_text(const RecordingReport& report);

/// The same as one JSON object.
void write_json(core::JsonWriter& json, const RecordingReport& report);
void write_json(core::JsonWriter& json, const TableReport& report);

using core::counted;
using core::write_json;

/// A number with so many decimals, never "-0.0".
[[nodiscard]] std::string decimals(double value, int digits);

/// Words of the command line and of JSON for choices of the scene.
[[nodiscard]] std::string format_word(scene::FileFormat format);
[[nodiscard]] std::string profile_word(scene::Profile profile);
[[nodiscard]] std::string pulse_word(scene::PulseDefinition pulse);
[[nodiscard]] std::string processing_word(scene::Processing processing);

}  // namespace sarsim::cli
