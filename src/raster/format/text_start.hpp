#pragma once

#include <optional>

#include "core/os/input_file.hpp"
#include "core/report/problem.hpp"
#include "raster/format/text_scanner.hpp"
#include "raster/table/formats.hpp"

namespace sarsim::raster {

/// Which of ASCII, CSV and BRACKET a text looks like from its first line that is not blank: a bracket begins BRACKET,
/// a comma makes CSV, anything else is ASCII. None where the beginning holds bytes that no text has.
[[nodiscard]] TextStyle style_of_text(const core::InputFile& file);

/// A scanner where the samples of a text begin: behind a byte order mark and, in CSV, behind a header line.
[[nodiscard]] TextScanner scanner_at_samples(const core::InputFile& file, TextStyle style);

/// What is wrong with the names in the header line of CSV: columns are I and Q in turn, and names that say that Q comes
/// first, or all I first, are those of other columns. Nothing where there is no such line, or its names are others.
[[nodiscard]] std::optional<core::Problem> problem_of_heading(const core::InputFile& file);

}  // namespace sarsim::raster
