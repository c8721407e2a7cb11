#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include "raster/hdf5/hdf5_library.hpp"
#include "raster/table/cf_attributes.hpp"

namespace sarsim::raster {

/// Indices of the real and the imaginary member of a compound of two: r and i (h5py, xarray), real and imag (MATLAB),
/// re and im, Re and Im, Real and Imag, real and imaginary. Nothing for another type, and if they differ in kind or are
/// not numbers.
[[nodiscard]] std::optional<std::array<unsigned, 2>> complex_members(hid_t type);

/// What the numbers of a dataset are, or both numbers of its pairs.
[[nodiscard]] NumberKind kind_of_numbers(hid_t type);

/// How the numbers of a dataset are handed over: as they are stored, since the library converts numbers one by one,
/// twenty times slower than it copies them. What is rare (wide integers, floats of other machines) comes as double.
class Hdf5Numbers {
 public:
  /// @param type  of a dataset: numbers, or pairs of them, see `complex_members`
  explicit Hdf5Numbers(hid_t type);

  /// The type to ask for; pairs have the real part first.
  [[nodiscard]] hid_t type() const { return type_.get(); }
  /// Whether the bytes in the file are those that are handed over.
  [[nodiscard]] bool as_stored() const { return as_stored_; }
  /// Size of one number (half a pair).
  [[nodiscard]] std::size_t bytes() const { return bytes_; }

  /// Converts what has been read, one number for each of `to`. Numbers beyond float are infinite.
  void convert(std::span<const std::byte> read, std::span<double> to) const { to_double_(read.data(), to); }
  void convert(std::span<const std::byte> read, std::span<float> to) const { to_float_(read.data(), to); }

 private:
  Hdf5Handle type_;
  std::size_t bytes_ = 0;
  bool as_stored_ = false;
  void (*to_double_)(const std::byte* read, std::span<double> to) = nullptr;
  void (*to_float_)(const std::byte* read, std::span<float> to) = nullptr;
};

}  // namespace sarsim::raster
