#pragma once

#include <complex>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/report/problem.hpp"
#include "raster/table/array_attributes.hpp"

namespace sarsim::raster {

/// What a `.zarray` of Zarr version 2 says of an array that is not compressed, last index fastest.
struct ZarrArray {
  std::string type;                          ///< As NumPy writes it: "<c8".
  std::vector<std::uint64_t> shape;          ///< At most 2^62 numbers; none for a single one.
  std::vector<std::uint64_t> chunks;         ///< At least 1 along each dimension.
  char separator = '.';                      ///< Between the numbers of a chunk in the name of its file.
  std::optional<std::complex<double>> fill;  ///< What stands for chunks that are nowhere, where it says so.
};

/// Understands the text of a `.zarray`. A problem, without a place, for what is no JSON or no such array: of another
/// version, compressed, filtered, in Fortran order.
[[nodiscard]] std::variant<ZarrArray, core::Problem> parse_zarr_array(std::string_view text);

/// The attributes of a `.zattrs` that are texts or numbers, as texts, and the names of the others; a problem, without a
/// place, for what is no JSON object, and for keys that are there twice.
/// @param lists  also up to 16 numbers, and `_ARRAY_DIMENSIONS`, separated by commas
[[nodiscard]] std::variant<ArrayAttributes, core::Problem> parse_zarr_attributes(std::string_view text,
                                                                                 bool lists = false);

/// Reads a `.zarray`; a problem with its place where it is missing, or longer than 1 MiB.
[[nodiscard]] std::variant<ZarrArray, core::Problem> read_zarr_array(const std::filesystem::path& file);
/// Reads a `.zattrs`, of at most 1 GiB; no attributes where it is missing.
[[nodiscard]] std::variant<ArrayAttributes, core::Problem> read_zarr_attributes(const std::filesystem::path& file,
                                                                                bool lists = false);
/// Compares what `.zmetadata` of a store, which other programs read in place of the files themselves, says of some of
/// them with these: "samples/.zarray". A file without its entry, and an entry without its file, contradict each other
/// too. Nothing where all agree, or where there is no `.zmetadata`.
/// @param names  of the samples first; other arrays of which `.zmetadata` says nothing at all are passed over
[[nodiscard]] std::optional<core::Problem> contradiction_of_zarr(const std::filesystem::path& store,
                                                                 const std::vector<std::filesystem::path>& names);

}  // namespace sarsim::raster
