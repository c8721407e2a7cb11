#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>

#include "core/os/raw_file.hpp"
#include "raster/table/row_places.hpp"
#include "raster/table/sink.hpp"

namespace sarsim::raster {

/// How a recording is to be stored.
struct SinkOptions {
  scene::FileFormat format = scene::FileFormat::binary;
  bool replace = false;  ///< Replace an existing file.
  bool counts = false;  ///< Integer counts rather than volts in HDF5, NPY and Zarr; text and BINARY always hold counts.
  bool header = false;  ///< A header line in CSV.
  bool doubles = false;  ///< Volts of HDF5, NPY and Zarr in double precision.
};

/// A sink that makes the file `path` of a product (docs/formats/samples.md). The file appears under its name with
/// `finish`; destroyed before, it leaves nothing. Memory does not grow with the number of rows. The same product and
/// the same blocks give the same bytes.
///
/// Rows must be appended in order, all of them before `finish`; anything else is a std::logic_error. Throws
/// std::invalid_argument for bits outside 1 to 64, std::system_error where the file cannot be made (see OutputFile),
/// std::runtime_error where the HDF5 library refuses.
[[nodiscard]] std::unique_ptr<Sink> make_sink(const std::filesystem::path& path, const Product& product,
                                              const SinkOptions& options);

/// Bytes that the finished file will have: exact for BINARY and NPY, an estimate for text (from the digits of counts
/// spread evenly over the range) and HDF5.
[[nodiscard]] double expected_bytes(const Product& product, const SinkOptions& options);

/// Bytes of an output that is there, all of its files together; 0 where there is none.
[[nodiscard]] std::uint64_t stored_bytes(const std::filesystem::path& path);

/// A sink that encodes like the file's and throws the bytes away, for measuring. Same rules for the order of rows.
[[nodiscard]] std::unique_ptr<Sink> make_discarding_sink(const Product& product, const SinkOptions& options);

/// Where each row of a product stands in its file; nothing for text, whose rows have no size of their own.
/// @param scratch  name of a file that may be made for a moment; HDF5 only
[[nodiscard]] std::optional<RowPlaces> row_places(const std::filesystem::path& scratch, const Product& product,
                                                  const SinkOptions& options);

/// Rows of a piece of its file, without looking for their places; 1 where it is of one piece.
[[nodiscard]] std::size_t piece_rows(const Product& product, const SinkOptions& options);

/// Completes a file whose rows somebody has written at their places: writes what stands before and behind them. The
/// bytes are then those that `make_sink` gives.
/// @param scratch  name of a file that is made for a moment; HDF5 only
void write_frame(core::RawFile& file, const std::filesystem::path& scratch, const Product& product,
                 const SinkOptions& options, const RunReport& report);

/// The same of a folder whose pieces hold all rows.
void complete_folder(const std::filesystem::path& folder, const Product& product, const SinkOptions& options,
                     const RunReport& report);

}  // namespace sarsim::raster
