#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/os/raw_file.hpp"
#include "raster/format/encoder.hpp"
#include "raster/table/row_places.hpp"
#include "raster/table/sink.hpp"

namespace sarsim::raster {

/// How recordings of a format are written. The first four suffice where a file is a beginning and its rows, one after
/// the other; the others are those of files that are made in another way.
struct FormatWriter {
  /// The bytes of a block.
  std::vector<std::byte> (*encode)(const Encoding& encoding, const Block& block) = nullptr;
  /// Bytes of a component (I or Q); null for text.
  std::size_t (*component_bytes)(const Encoding& encoding) = nullptr;
  /// What stands before the first row; null where nothing does.
  std::string (*preamble)(const Product& product, const Encoding& encoding, bool header) = nullptr;
  /// Bytes of the whole file: exact, or an estimate.
  double (*expected_bytes)(const Product& product, const Encoding& encoding, bool header) = nullptr;

  /// Begins the file; null where it is a stream.
  std::unique_ptr<Sink> (*make_sink)(const std::filesystem::path& path, const Product& product,
                                     const Encoding& encoding, bool replace) = nullptr;
  /// Where its rows stand; null where that follows from the first four.
  RowPlaces (*row_places)(const std::filesystem::path& scratch, const Product& product,
                          const Encoding& encoding) = nullptr;
  /// Writes all but the samples; null where that is the preamble.
  void (*write_frame)(core::RawFile& file, const std::filesystem::path& scratch, const Product& product,
                      const Encoding& encoding, const RunReport& report) = nullptr;
  /// Of folders, in place of the former: completes one whose pieces hold all rows.
  void (*complete_folder)(const std::filesystem::path& folder, const Product& product, const Encoding& encoding,
                          const RunReport& report) = nullptr;
};

extern const FormatWriter ascii_writer;
extern const FormatWriter binary_writer;
extern const FormatWriter bracket_writer;
extern const FormatWriter csv_writer;
extern const FormatWriter hdf5_file_writer;
extern const FormatWriter npy_writer;
extern const FormatWriter sigmf_writer;
extern const FormatWriter zarr_writer;

/// Bytes of a component (I or Q) in the formats of fixed size: BINARY ceil(bits/8); HDF5 and NPY 4 (float32 or int32)
/// or, for counts of more than 31 bits, 8. Zero for text.
[[nodiscard]] std::size_t component_bytes(const Encoding& encoding);

/// The bytes of a block as docs/formats/samples.md lays them out. Text: about 300 MB/s or more on one core. Throws
/// std::invalid_argument where the block's spans have not the size that its shape asks for, and std::out_of_range for
/// a count outside the converter's range. May run on many threads at once.
[[nodiscard]] std::vector<std::byte> encode_rows(const Encoding& encoding, const Block& block);

}  // namespace sarsim::raster
