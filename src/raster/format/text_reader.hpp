#pragma once

#include "core/os/input_file.hpp"
#include "raster/format/sample_reader.hpp"
#include "raster/format/text_scanner.hpp"

namespace sarsim::raster {

/// Which of ASCII, CSV and BRACKET a text looks like from its first line that is not blank: a bracket begins BRACKET,
/// a comma makes CSV, anything else is ASCII. Nothing where the beginning holds bytes that no text has.
[[nodiscard]] std::optional<scene::FileFormat> detect_text_format(const core::InputFile& file);

/// A scanner where the samples of a text begin: behind a byte order mark and, in CSV, behind a header line.
[[nodiscard]] TextScanner scanner_at_samples(const core::InputFile& file, scene::FileFormat format);

/// Opens a text of samples (docs/formats/samples.md). Reads it through once to check every number and every row, and
/// remembers where rows begin (at most a sixteenth of the file's size). Malformed text stops at the first place, rows
/// of different lengths are listed, ten at most.
[[nodiscard]] OpenedReader open_text(core::InputFile file, scene::FileFormat format, const SampleFileHints& hints);

}  // namespace sarsim::raster
