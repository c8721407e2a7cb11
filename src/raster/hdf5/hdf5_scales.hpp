#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "raster/hdf5/hdf5_library.hpp"

namespace sarsim::raster {

/// Gives the dimensions of datasets names and coordinates: dimension scales, as the HDF5 "Dimension Scale
/// Specification" has them and netCDF-4 reads them. The C library suffices for that; all is written when a file is
/// begun, so that its layout does not depend on what follows. Functions are false where the library fails.
class Hdf5Scales {
 public:
  /// Of the datasets in the root of a file, which has to outlive this.
  explicit Hdf5Scales(hid_t file) : file_(file) {}

  /// Makes a dataset of one dimension the coordinate of a dimension that has the dataset's name.
  [[nodiscard]] bool add(hid_t dataset, const std::string& name);
  /// Adds a dimension that has a name and a length only.
  [[nodiscard]] bool add_bare(const std::string& name, std::uint64_t length);
  /// Adds a dimension whose places are words.
  [[nodiscard]] bool add_words(const std::string& name, const std::vector<const char*>& words);
  /// Names the dimensions of a dataset after scales that were added, one for each.
  [[nodiscard]] bool attach(hid_t dataset, const std::string& name, const std::vector<std::string>& scales);
  /// Notes at each scale which datasets it was attached to; the last call.
  [[nodiscard]] bool finish();

 private:
  struct Use {
    hobj_ref_t dataset;
    std::int32_t dimension;
  };
  struct Scale {
    std::string name;
    hobj_ref_t place;
    std::vector<Use> uses;
  };

  [[nodiscard]] bool add_named(hid_t dataset, const std::string& name, const std::string& label);

  hid_t file_;
  std::vector<Scale> scales_;
};

}  // namespace sarsim::raster
