#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "core/os/temporary_files.hpp"
#include "raster/format/encoder.hpp"
#include "raster/format/number_table.hpp"
#include "raster/format/open_raster.hpp"
#include "raster/table/product_attributes.hpp"
#include "raster/table/row_places.hpp"
#include "raster/table/sink.hpp"
#include "raster/table/stored_array.hpp"

namespace sarsim::raster {

/// What needs the HDF5 library. It is a module of its own, `sarsim_hdf5.so`, because loading that library and the
/// thirty others that it needs takes longer than many a run, and most runs have no use for it.
struct Hdf5Module {
  /// Makes the list of temporary files that of the program, see core::use_temporary_names.
  void (*use_temporary_names)(core::TemporaryNames& list);
  /// Opens a file of so many bytes for reading, see open_hdf5.
  OpenedRaster (*open)(const std::filesystem::path& path, std::uint64_t file_bytes, const RasterHints& hints,
                       const core::StopFlag* stop);
  /// Begins a file, see Hdf5Sink. The words are those of `scene::option_words`, which the module has not.
  std::unique_ptr<Sink> (*make_sink)(const std::filesystem::path& path, const Product& product,
                                     const FileAttributes& option_words, const Encoding& encoding, bool replace);
  /// Where the samples of such a file stand. `scratch` names a file that is begun and thrown away.
  RowPlaces (*row_places)(const std::filesystem::path& scratch, const Product& product,
                          const FileAttributes& option_words, const Encoding& encoding);
  /// Makes a whole file but for its samples, which are left as a hole.
  void (*write_frame)(const std::filesystem::path& path, const Product& product, const FileAttributes& option_words,
                      const Encoding& encoding, const RunReport& report);
  /// Where its arrays stand, see hdf5_arrays.
  StoredArrays (*arrays)(const std::filesystem::path& path, std::uint64_t file_bytes, const std::string& dataset);
  /// Reads a table of points, see read_hdf5_points.
  std::optional<core::Problem> (*read_points)(const std::filesystem::path& path, std::uint64_t file_bytes,
                                              const NumberTableTaker& taker);
};

/// The module, which the first call loads and which then stays. May be called from many threads at once.
/// @param wanted_for  the file to be read or written, for the message
/// @throws std::runtime_error where the module, or a library that it needs, cannot be loaded
[[nodiscard]] const Hdf5Module& hdf5_module(const std::filesystem::path& wanted_for);

}  // namespace sarsim::raster
