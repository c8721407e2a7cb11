#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/schema/function_block.hpp"
#include "scene/schema/quantity.hpp"
#include "scene/script/data_file.hpp"

/// Data files of functions that are tables: rows of x and the values at x (docs/formats/script.md, "Data files").
namespace sarsim::scene {

/// What the numbers of an axis measure; in tables they count in its base unit, where a heading names no other.
[[nodiscard]] Quantity quantity_of(const FunctionAxis& axis);

/// Whether bytes are those of an HDF5 file, whose dataset /points is a table that the library of that format reads.
[[nodiscard]] bool is_hdf5(std::string_view bytes);

/// Reads an array of NumPy, of one or two dimensions, as a table; nothing where the bytes are no such array.
[[nodiscard]] std::optional<DataFileReading> read_npy_table(std::string_view bytes, const std::string& file_name,
                                                            const FunctionBlock& block);

/// Reads rows of text: cells parted by tabs, semicolons, commas or blanks, below a line of names or without one, which
/// may have units in brackets. Nothing for what is no such table: without a line of names, rows of other columns, fewer
/// than two of them, or with something wrong.
/// @param certainly  the file is no data file of another kind: then what is wrong with its rows is told
[[nodiscard]] std::optional<DataFileReading> read_text_table(std::string_view text, const std::string& file_name,
                                                             const FunctionBlock& block, bool certainly);

/// The functions of a block from a table, row by row: x and a value for each; of lists the values alone, or pulse
/// number and value; of an antenna also two columns, the angle and a gain that both cuts have; of a pulse also I and Q
/// alone, evenly spaced from its beginning to its end, or two columns the first of which ascends from 0 to 1: x and I.
/// @param rows  whole ones; not empty
[[nodiscard]] DataFileReading functions_of_table(const std::vector<double>& numbers, std::size_t columns,
                                                 const std::string& file_name, const FunctionBlock& block);

}  // namespace sarsim::scene
