#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <variant>

#include "core/report/problem.hpp"
#include "radar/earth/geoid_grid.hpp"

/// What the readers of geoids have in common.
namespace sarsim::radar::geoid {

/// A grid or why there is none.
using Reading = std::variant<GeoidGrid, core::Problem>;

/// A grid of a file; a fault of the grid gets the name of the file.
[[nodiscard]] inline Reading grid_of(const std::string& name, const GeoidLattice& lattice, GeoidValues values) {
  Reading reading = GeoidGrid::from(lattice, std::move(values));
  if (auto* const problem = std::get_if<core::Problem>(&reading)) problem->place = {name, 0, 0};
  return reading;
}

}  // namespace sarsim::radar::geoid
