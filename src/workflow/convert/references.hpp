#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/task/observer.hpp"
#include "workflow/input/sample_input.hpp"

namespace sarsim::workflow {

/// Which file is referred to, and where the references go.
struct ReferencesRequest {
  std::string input;
  std::string output;
  SampleArguments sample;  ///< What is said of an input that does not describe itself.
  bool force = false;      ///< Replace the output where it exists.
};

/// How an array is cut: whole leading indices in each piece.
struct ArrayCut {
  std::uint64_t rows = 1;   ///< Leading indices of a piece.
  std::uint64_t whole = 1;  ///< Pieces that are full.
  std::uint64_t rest = 0;   ///< Leading indices of the last piece, which is not; 0 where all are full.
};

/// Cuts so many rows into equal pieces of about a megabyte, of arrays beyond gigabytes of up to 64: as many rows in
/// each as divide their number. Where no such number does, pieces are a sixteenth of that, and the last one is left
/// shorter. At most 70 000 pieces of what is smaller than 256 GiB.
[[nodiscard]] ArrayCut cut_of_array(std::uint64_t rows, std::uint64_t row_bytes);

/// Writes references to the arrays of a file as JSON (version 1 of the reference file system of fsspec, as kerchunk
/// makes them; docs/formats/references.md): with it, readers of Zarr version 2 see the file as an array of pieces,
/// without its library and without a copy. HDF5, NPY, BINARY and ENVI; the file may be of any size and stays as it is.
/// @param observer  hears warnings about the input
/// @throws core::InvalidRequest where the input cannot be read, its numbers do not stand in the file as they are, or
/// the output may not be written
void write_references(const ReferencesRequest& request, const core::Observer& observer);

}  // namespace sarsim::workflow
