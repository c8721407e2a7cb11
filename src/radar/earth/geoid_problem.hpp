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

/// An error in a file; line 0 where it has no lines.
[[nodiscard]] inline core::Problem file_problem(const std::string& name, std::size_t line, std::string message,
                                                std::string found, std::string expected, std::string hint = {}) {
  core::Problem problem = core::problem_of(core::Severity::error, std::move(message), std::move(found),
                                           std::move(expected), std::move(hint));
  problem.place = {name, line, 0};
  return problem;
}

/// A grid of a file; a fault of the grid gets the name of the file.
[[nodiscard]] inline Reading grid_of(const std::string& name, const GeoidLattice& lattice, GeoidValues values) {
  Reading reading = GeoidGrid::from(lattice, std::move(values));
  if (auto* const problem = std::get_if<core::Problem>(&reading)) problem->place = {name, 0, 0};
  return reading;
}

}  // namespace sarsim::radar::geoid
