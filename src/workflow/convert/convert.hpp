#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/report/problem.hpp"
#include "core/task/observer.hpp"
#include "radar/earth/earth_frame.hpp"
#include "radar/receiver/converter.hpp"
#include "workflow/input/sample_input.hpp"

namespace sarsim::workflow {

/// Which file of samples becomes which.
struct ConvertRequest {
  std::string input;
  std::shared_ptr<const raster::Raster> held{};  ///< In place of the file `input`, which is then only a name.
  std::string output;
  SampleArguments sample;                  ///< What is said of an input that does not describe itself.
  std::optional<std::int64_t> simulation;  ///< The one of `sample.script` that wrote the input, from 1.
  std::optional<scene::FileFormat> to;     ///< Otherwise what the extension of the output says.
  std::optional<radar::Anchor> anchor;     ///< Of a flat world, for SICD: where its origin is on the Earth.
  bool counts = false;                     ///< Converter counts instead of volts, where a format has both.
  bool header = false;                     ///< A header line in CSV.
  bool force = false;                      ///< Replace the output where it exists.
};

/// What was made.
struct ConvertReport {
  std::vector<std::filesystem::path> files;  ///< The new file and, for images, its header.
  std::size_t rows = 0;
  std::size_t columns = 0;
  bool counts = false;           ///< The new file holds counts; otherwise volts.
  radar::ConversionTally tally;  ///< Of the converter that the samples went through, where counts were made.
  core::Problems remarks;        ///< Notes of what was left behind and warnings of what was clipped or is no number.
};

/// Copies a file of samples into another format: volts become counts, counts volts, as the new format wants them. An
/// image keeps its header as far as the new format has place for it. Rows pass in blocks, so memory stays bounded.
/// @param observer  hears warnings about the input before anything is written
/// @throws core::InvalidRequest with all problems where the input cannot be read, something that the change needs is
/// not known, the output may not be written, or volts are too large for the single precision of the new file
/// @throws core::Interrupted when stopped; nothing is left behind
[[nodiscard]] ConvertReport convert(const ConvertRequest& request, const core::Observer& observer);

}  // namespace sarsim::workflow
