#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "core/os/input_file.hpp"
#include "core/task/parallel.hpp"
#include "radar/echo/view_geometry.hpp"
#include "scene/model/scene.hpp"

/// The readers of tables of points, one for each format (docs/formats/point-tables.md).
namespace sarsim::workflow {

/// Why a table cannot be read, in the words of a problem.
struct TableFault {
  std::string message;
  std::string found;
  std::string expected;
  std::string hint;
};

/// A table as it stands in a file: positions [m] and, in place of the roots, cross-sections [m2].
struct PointTable {
  radar::PointArrays arrays;
  double rcs_m2 = 1.0;  ///< Of points without one of their own.
  scene::World world;   ///< Where latitudes and longitudes lie; of the cloud, as the next.
  std::string platform = "Earth";
  bool geodetic = false;         ///< The table has latitudes; the arrays have been laid in the world.
  bool own_rcs = false;          ///< Cross-sections are there; else `arrays.root_rcs_m` holds zeros.
  std::string row_word = "row";  ///< What people count its points in: a text has lines.
  std::size_t first_row = 1;     ///< Number of the first point's row.
};

/// Room for so many points, and that many zeros.
void resize(radar::PointArrays& arrays, std::size_t points, const core::WorkControl& control);

/// What is wrong with a value of a table. @param column  from 1
[[nodiscard]] TableFault fault_of_cell(std::string_view row_word, std::uint64_t row, std::size_t column, double value);

/// A phase that is not 0, which no echo can have yet.
[[nodiscard]] TableFault fault_of_phase(std::string_view row_word, std::uint64_t row, double value);

/// Reads an NPY file: an array of N rows with 3 to 5 columns (x, y, z, cross-section, phase), float32 or float64, in
/// either order of dimensions.
[[nodiscard]] std::optional<TableFault> read_npy_points(const core::InputFile& file, PointTable& table,
                                                        const core::WorkControl& control);

/// Reads the dataset `/points` of an HDF5 file: as an NPY array, whole numbers too.
[[nodiscard]] std::optional<TableFault> read_hdf5_points(const core::InputFile& file, PointTable& table,
                                                         const core::WorkControl& control);

/// Reads lines of text as `scene::import_targets` does, in pieces on several threads.
[[nodiscard]] std::optional<TableFault> read_text_points(const core::InputFile& file, PointTable& table,
                                                         const core::WorkControl& control);

}  // namespace sarsim::workflow
