#pragma once

#include <complex>
#include <cstddef>
#include <filesystem>
#include <span>

#include "core/task/parallel.hpp"
#include "core/task/progress.hpp"
#include "raster/format/sinks.hpp"
#include "raster/table/raster.hpp"

namespace sarsim::raster {

/// How a selection of an image is stored.
struct ImageExport {
  SinkOptions sink;
  int bits = 0;  ///< Of the counts; 0: those of the source, otherwise 16.
  double lsb_v =
      0.0;  ///< Volts of a count; 0: that of the source, otherwise of counts 1 and of volts the largest one/C.
};

/// Refuses volts that are finite, but beyond the single precision (3.4e38) that files of samples hold them in: they
/// would become infinite. What is infinite or not a number already passes.
/// @param volts      whole rows of `columns` samples
/// @param first_row  of the file, for the words
/// @throws core::InvalidRequest
void expect_single_precision(std::span<const std::complex<double>> volts, std::size_t first_row, std::size_t columns);

/// Writes a window of an image as a file of samples in any of the formats of docs/formats/samples.md, some MB at a
/// time.
///
/// Counts stay counts where the format holds counts, clipped where they do not fit, and 0 for what is not a number;
/// volts become counts, and counts volts, by the LSB. Real values, magnitudes, powers and the luminance of colours are
/// stored as they are, with Q 0. Numbers pass through float: counts above 2^24 are rounded. Times, carriers, ranges and
/// the sampling rate are those of the samples that are taken; what the source does not say the file does not say
/// either.
///
/// The file appears when it is complete. Returns what `RunReport` says of it. Throws what reading and the sink throw,
/// std::out_of_range for a window that is not inside or empty, core::InvalidRequest for volts that single precision
/// does not hold where the options do not say `doubles`, Interrupted.
RunReport export_window(const Raster& source, const ImageWindow& window, const std::filesystem::path& path,
                        const ImageExport& options, const core::WorkControl& control = {},
                        const core::ProgressReport& progress = {});

}  // namespace sarsim::raster
