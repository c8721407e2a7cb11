#include "radar/earth/geoid_grid.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "core/maths/constants.hpp"

namespace sarsim::radar {

namespace {

// Rounding of a place in steps of the finest grids; a place so far outside is inside.
constexpr double rounding_steps = 1e-9;
// Steps printed with few digits add up to a whole turn within this.
constexpr double snap_steps = 0.1;
double snap_deg(double step_deg) { return std::min(snap_steps * step_deg, 0.1); }

using Fault = std::optional<core::Problem>;

Fault fault_of_lattice(const GeoidLattice& lattice) {
  if (lattice.rows < 2 || lattice.columns < 2)
    return core::error("the grid of the geoid is too small")
        .found(fmt::format("{} rows, {} columns", lattice.rows, lattice.columns))
        .expected("at least 2 of each");
  for (const double value :
       {lattice.first_latitude_deg, lattice.latitude_step_deg, lattice.first_longitude_deg, lattice.longitude_step_deg})
    if (!(std::abs(value) <= 1e6))
      return core::error("the place of the grid is not known").found(fmt::format("{}", value)).expected("degrees");
  const double step_deg = std::abs(lattice.latitude_step_deg);
  if (!(step_deg > 0.0) || !(lattice.longitude_step_deg > 0.0))
    return core::error("the grid of the geoid has no step")
        .found(fmt::format("{} and {} deg", lattice.latitude_step_deg, lattice.longitude_step_deg))
        .expected("steps in latitude and longitude above 0");
  const double last_deg =
      lattice.first_latitude_deg + static_cast<double>(lattice.rows - 1) * lattice.latitude_step_deg;
  if (!(std::max(std::abs(lattice.first_latitude_deg), std::abs(last_deg)) <= 90.0 + snap_deg(step_deg)))
    return core::error("the rows of the grid reach beyond a pole")
        .found(fmt::format("{} to {} deg", lattice.first_latitude_deg, last_deg))
        .expected("within -90 and 90 deg")
        .hint("are the rows and the columns of the file in this order, and in degrees?");
  const double turn_deg = static_cast<double>(lattice.columns - 1) * lattice.longitude_step_deg;
  if (!(turn_deg <= 360.0 + snap_deg(lattice.longitude_step_deg)))
    return core::error("the columns of the grid go around the Earth more than once")
        .found(fmt::format("{} deg", turn_deg))
        .expected("at most 360 deg")
        .hint("correct the step or the number of columns");
  return std::nullopt;
}

std::size_t count_of(const GeoidValues& values) {
  if (const auto* const steps = std::get_if<GeoidSteps>(&values)) return steps->steps.size();
  return std::get<std::vector<float>>(values).size();
}

double value_at(const GeoidValues& values, std::size_t index) {
  if (const auto* const steps = std::get_if<GeoidSteps>(&values))
    return steps->offset_m + steps->scale_m * static_cast<double>(steps->steps[index]);
  return static_cast<double>(std::get<std::vector<float>>(values)[index]);
}

bool is_float(const GeoidValues& values) { return std::holds_alternative<std::vector<float>>(values); }

Fault fault_of_values(const GeoidLattice& lattice, const GeoidValues& values) {
  const std::size_t count = count_of(values);
  if (count / lattice.columns != lattice.rows || count % lattice.columns != 0)
    return core::error("the grid has another number of values than nodes")
        .found(fmt::format("{} values", count))
        .expected(fmt::format("{} rows of {}", lattice.rows, lattice.columns));
  for (std::size_t i = 0; i < count; ++i) {
    const double value_m = value_at(values, i);
    const bool missing = std::isnan(value_m) && is_float(values);
    if (missing || std::abs(value_m) <= largest_undulation_m) continue;
    return core::error(
               fmt::format("no geoid is so high (row {}, column {})", i / lattice.columns + 1, i % lattice.columns + 1))
        .found(fmt::format("{:.6g} m", value_m))
        .expected(fmt::format("at most {} m", largest_undulation_m))
        .hint("are these undulations in m, and is the mark of missing values the right one?");
  }
  return std::nullopt;
}

std::optional<double> between(std::optional<double> a, std::optional<double> b, double part) {
  if (part <= 0.0) return a;
  if (part >= 1.0) return b;
  if (!a || !b) return std::nullopt;
  return *a + part * (*b - *a);
}

}  // namespace

std::variant<GeoidGrid, core::Problem> GeoidGrid::from(const GeoidLattice& lattice, GeoidValues values) {
  if (Fault fault = fault_of_lattice(lattice)) return *std::move(fault);
  if (Fault fault = fault_of_values(lattice, values)) return *std::move(fault);
  GeoidGrid grid;
  grid.lattice_ = lattice;
  grid.values_ = std::move(values);
  for (const std::size_t different : {lattice.columns - 1, lattice.columns}) {
    const double turn_deg = static_cast<double>(different) * lattice.longitude_step_deg;
    if (std::abs(turn_deg - 360.0) > snap_deg(lattice.longitude_step_deg)) continue;
    grid.is_ring_ = true;
    grid.ring_columns_ = different;
    grid.lattice_.longitude_step_deg = 360.0 / static_cast<double>(different);
    break;
  }
  grid.rims_ = {grid.rim_of(0), grid.rim_of(lattice.rows - 1)};
  return grid;
}

GeoidGrid::Rim GeoidGrid::rim_of(std::size_t row) const {
  constexpr double farthest_steps = 0.6;
  const double latitude_deg = lattice_.first_latitude_deg + static_cast<double>(row) * lattice_.latitude_step_deg;
  const bool north = (lattice_.latitude_step_deg < 0.0) == (row == 0);
  const double to_pole_steps =
      ((north ? 90.0 - latitude_deg : 90.0 + latitude_deg)) / std::abs(lattice_.latitude_step_deg);
  if (!is_ring_ || to_pole_steps > farthest_steps) return {rounding_steps, std::nullopt};
  if (to_pole_steps <= snap_steps) return {snap_steps, std::nullopt};
  double sum_m = 0.0;
  for (std::size_t column = 0; column < ring_columns_; ++column) {
    const std::optional<double> value_m = node(row, column);
    if (!value_m) return {rounding_steps, std::nullopt};
    sum_m += *value_m;
  }
  return {to_pole_steps, sum_m / static_cast<double>(ring_columns_)};
}

std::optional<double> GeoidGrid::node(std::size_t row, std::size_t column) const {
  const double value_m = value_at(values_, row * lattice_.columns + column);
  return std::isnan(value_m) ? std::nullopt : std::optional<double>(value_m);
}

std::optional<double> GeoidGrid::along_row(std::size_t row, double column) const {
  const std::size_t last = is_ring_ ? ring_columns_ - 1 : lattice_.columns - 2;
  const std::size_t left = std::min(static_cast<std::size_t>(column), last);
  const std::size_t right = is_ring_ && left + 1 == ring_columns_ ? 0 : left + 1;
  return between(node(row, left), node(row, right), column - static_cast<double>(left));
}

// The place among the columns, from 0 on; nothing outside of them.
std::optional<double> GeoidGrid::column_of(double longitude_deg) const {
  const double turn_steps = is_ring_ ? static_cast<double>(ring_columns_) : 360.0 / lattice_.longitude_step_deg;
  double column = (longitude_deg - lattice_.first_longitude_deg) / lattice_.longitude_step_deg;
  column -= std::floor(column / turn_steps) * turn_steps;
  if (is_ring_) return column;
  if (column >= turn_steps - rounding_steps) column = 0.0;
  const auto last = static_cast<double>(lattice_.columns - 1);
  return column <= last + rounding_steps ? std::optional<double>(std::min(column, last)) : std::nullopt;
}

std::optional<double> GeoidGrid::beyond(std::size_t row, double distance_steps, double column) const {
  const Rim& rim = rims_[row == 0 ? 0 : 1];
  if (!(distance_steps <= rim.reach_steps + rounding_steps)) return std::nullopt;
  const std::optional<double> at_row = along_row(row, column);
  return rim.pole_undulation ? between(at_row, rim.pole_undulation, distance_steps / rim.reach_steps) : at_row;
}

std::optional<double> GeoidGrid::undulation_m(double latitude_rad, double longitude_rad) const {
  const double latitude_deg = latitude_rad / core::rad_per_deg;
  const double longitude_deg = longitude_rad / core::rad_per_deg;
  if (!(std::abs(latitude_deg) <= 90.0 + 1e-9) || !(std::abs(longitude_deg) <= 1e9)) return std::nullopt;
  const std::optional<double> column = column_of(longitude_deg);
  if (!column) return std::nullopt;
  const double row = (latitude_deg - lattice_.first_latitude_deg) / lattice_.latitude_step_deg;
  const auto last = static_cast<double>(lattice_.rows - 1);
  if (row < 0.0) return beyond(0, -row, *column);
  if (row > last) return beyond(lattice_.rows - 1, row - last, *column);
  const std::size_t below = std::min(static_cast<std::size_t>(row), lattice_.rows - 2);
  return between(along_row(below, *column), along_row(below + 1, *column), row - static_cast<double>(below));
}

}  // namespace sarsim::radar
