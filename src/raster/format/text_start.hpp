#pragma once

#include <optional>
#include <string>

#include "core/os/input_file.hpp"
#include "raster/format/text_scanner.hpp"
#include "raster/table/formats.hpp"

namespace sarsim::raster {

/// Which of ASCII, CSV and BRACKET a text looks like from its first line that is not blank: a bracket begins BRACKET,
/// a comma makes CSV, anything else is ASCII. None where the beginning holds bytes that no text has.
[[nodiscard]] TextStyle style_of_text(const core::InputFile& file);

/// A scanner where the samples of a text begin: behind a byte order mark and, in CSV, behind a header line.
[[nodiscard]] TextScanner scanner_at_samples(const core::InputFile& file, TextStyle style);

/// The header line of CSV, which `scanner_at_samples` skips: a first line that begins with a letter or '#' and none of
/// whose fields is a number, a word for a missing one ("NA"), or a number in quotes. Nothing where there is none.
[[nodiscard]] std::optional<std::string> line_of_names(const core::InputFile& file);

}  // namespace sarsim::raster
