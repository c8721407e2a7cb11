#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/maths/sampled_function.hpp"
#include "core/report/problem.hpp"
#include "scene/schema/function_block.hpp"
#include "scene/script/named_columns.hpp"

/// Data files of functions that are tables: rows of x and the values at x (docs/formats/script.md, "Data files").
namespace sarsim::scene {

/// The points of a data file: one list for each function of the block.
struct DataFileReading {
  std::vector<std::vector<core::Knot>> functions;
  core::Problems problems;
  bool deferred = false;  ///< The file is HDF5: its table is read later, by code with that library; no points yet.
};

/// Whether bytes are those of an HDF5 file. Its table is the dataset /points, which only the HDF5 library can read.
[[nodiscard]] bool is_hdf5(std::string_view bytes);

/// Reads a NumPy array of one or two dimensions as a table; nothing if the bytes are not such an array.
[[nodiscard]] std::optional<DataFileReading> read_npy_table(std::string_view bytes, const std::string& file_name,
                                                            const FunctionBlock& block);

/// Reads rows of text: cells separated by tabs, semicolons, commas or blanks, optionally below a line of names, which
/// may have units in brackets. Nothing for a text that is not such a table: without a line of names, rows of other
/// numbers of columns, fewer than two rows, or any error.
/// @param certainly  the file cannot be a data file of another kind: errors in its rows are then reported
[[nodiscard]] std::optional<DataFileReading> read_text_table(std::string_view text, const std::string& file_name,
                                                             const FunctionBlock& block, bool certainly);

/// The functions of a block from a table, row by row: x and a value for each; of lists the values alone, or pulse
/// number and value; of an antenna also two columns, the angle and a gain that both cuts have; of a pulse also I and Q
/// alone, evenly spaced from its beginning to its end, or two columns the first of which ascends from 0 to 1: x and I.
/// @param rows  whole ones; not empty
[[nodiscard]] DataFileReading functions_of_table(const std::vector<double>& numbers, std::size_t columns,
                                                 const std::string& file_name, const FunctionBlock& block);

}  // namespace sarsim::scene
