#pragma once

#include "core/os/input_file.hpp"
#include "raster/format/text_scanner.hpp"
#include "raster/table/formats.hpp"

namespace sarsim::raster {

/// Which of ASCII, CSV and BRACKET a text looks like from its first line that is not blank: a bracket begins BRACKET,
/// a comma makes CSV, anything else is ASCII. None where the beginning holds bytes that no text has.
[[nodiscard]] TextStyle style_of_text(const core::InputFile& file);

/// A scanner where the samples of a text begin: behind a byte order mark and, in CSV, behind a header line.
[[nodiscard]] TextScanner scanner_at_samples(const core::InputFile& file, TextStyle style);

}  // namespace sarsim::raster
