#pragma once

#include <filesystem>
#include <string>

#include "raster/format/sinks.hpp"
#include "raster/parts/journal.hpp"
#include "raster/table/sink.hpp"

namespace sarsim::raster {

/// What is needed to make a recording's file from its rows without the scene: for parts that are joined elsewhere. Of a
/// recording that is made here everything is known.
struct StoredProduct {
  Product product;
  SinkOptions options;
  bool estimate_lsb = false;  ///< The rows are volts until the largest of all of them is known.
  std::string engine_reason;
  Identity identity{};  ///< Of the run that it describes, as its journals have it.
};

/// Writes it to a file, all or nothing. The axes are only stored for HDF5, the one format that holds them.
void store_product(const std::filesystem::path& path, const StoredProduct& stored);

/// Reads it back.
/// @throws core::InvalidRequest where it is missing, damaged, larger than any or no regular file; std::system_error
/// where the
///         file cannot be read
[[nodiscard]] StoredProduct load_product(const std::filesystem::path& path);

}  // namespace sarsim::raster
