#include <optional>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "core/report/problem.hpp"
#include "raster/format/load_hdf5.hpp"
#include "workflow/input/cloud_table.hpp"

namespace sarsim::workflow {

std::optional<TableFault> read_hdf5_points(const core::InputFile& file, PointTable& table,
                                           const core::WorkControl& control) {
  std::uint64_t columns = 0;
  std::optional<TableFault> phase;
  raster::NumberTableTaker taker;
  taker.stop = control.stop;
  taker.begin = [&](std::uint64_t rows, std::uint64_t wide) -> std::optional<core::Problem> {
    if (wide < 3 || wide > 5)
      return core::error("the dataset /points is not a table of points")
          .found(fmt::format("({}, {})", rows, wide))
          .expected("N rows and 3 or 4 columns: x, y, z and cross-section");
    columns = wide;
    table.own_rcs = columns > 3;
    resize(table.arrays, static_cast<std::size_t>(rows), control);
    return std::nullopt;
  };
  taker.take = [&](std::uint64_t first, std::span<const double> numbers) {
    auto at = static_cast<std::size_t>(first);
    for (std::size_t i = 0; i < numbers.size(); i += columns, ++at) {
      table.arrays.x_m[at] = numbers[i];
      table.arrays.y_m[at] = numbers[i + 1];
      table.arrays.z_m[at] = numbers[i + 2];
      if (columns > 3) table.arrays.root_rcs_m[at] = numbers[i + 3];
      if (columns > 4 && numbers[i + 4] != 0.0 && !phase) phase = fault_of_phase("row", at + 1, numbers[i + 4]);
    }
  };
  if (const auto problem = raster::hdf5_module(file.path()).read_points(file.path(), file.size(), taker))
    return TableFault{problem->message, problem->found, problem->expected, problem->hint};
  return phase;
}

}  // namespace sarsim::workflow
