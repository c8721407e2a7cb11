#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "core/report/problem.hpp"

namespace sarsim::radar {

/// Where the nodes of a grid lie: rows by latitude, columns by longitude, evenly spaced. In degrees, as files give
/// them, because steps are round numbers there.
struct GeoidLattice {
  double first_latitude_deg = 0.0;   ///< Of row 0.
  double latitude_step_deg = 0.0;    ///< From one row to the next; negative where row 0 is the northern one.
  double first_longitude_deg = 0.0;  ///< Of column 0, east of Greenwich; any turn.
  double longitude_step_deg = 0.0;   ///< From one column to the next one in the east; above 0.
  std::size_t rows = 0;
  std::size_t columns = 0;

  friend constexpr bool operator==(const GeoidLattice&, const GeoidLattice&) = default;
};

/// Undulations as whole numbers: offset + scale * step.
struct GeoidSteps {
  double offset_m = 0.0;
  double scale_m = 0.0;
  std::vector<std::uint16_t> steps;
};

/// Values at the nodes, row by row, in 2 or 4 bytes each. In m; a NaN is a node without a value.
using GeoidValues = std::variant<GeoidSteps, std::vector<float>>;

/// No undulation is larger, m; on the Earth they are within -107 and 86 m.
inline constexpr double largest_undulation_m = 1000.0;

/// The height of the geoid, which is the mean level of the sea, above the WGS-84 ellipsoid. A height above the sea plus
/// the undulation is the height that `Geodetic` holds.
///
/// Between four nodes it is bilinear in latitude and longitude. That differs from the model behind the grid by up to
/// 1.2 m (EGM96 every 15'), 0.14 m (EGM96 every 5'), 0.48 m (EGM2008 every 5') and 0.025 m (every 1'), says
/// GeographicLib's manual of GeoidEval. Const members are safe to call from many threads.
class GeoidGrid {
 public:
  /// Checks and keeps a grid. Columns that go around the Earth, whether the last repeats the first or not, close to a
  /// ring: the step is then corrected to a whole fraction of 360 deg. Refuses fewer than 2 rows or columns, latitudes
  /// beyond a pole, more than 360 deg, another number of values than nodes, and values above `largest_undulation_m`.
  [[nodiscard]] static std::variant<GeoidGrid, core::Problem> from(const GeoidLattice& lattice, GeoidValues values);

  /// The undulation at a place, m; the longitude may be in any turn. Nothing outside of a regional grid, where a node
  /// that counts has no value, and for what is no latitude. In a ring whose last rows lie half a step from the poles
  /// (values of cells), the pole has the mean of the row, and the undulation is linear up to it.
  [[nodiscard]] std::optional<double> undulation_m(double latitude_rad, double longitude_rad) const;

  [[nodiscard]] const GeoidLattice& lattice() const { return lattice_; }
  /// Whether the columns go around the Earth.
  [[nodiscard]] bool is_ring() const { return is_ring_; }

 private:
  // What lies beyond the first and the last row.
  struct Rim {
    double reach_steps = 0.0;               // so far the grid answers
    std::optional<double> pole_undulation;  // at that distance; none where the row itself is the pole
  };

  GeoidGrid() = default;
  [[nodiscard]] Rim rim_of(std::size_t row) const;
  [[nodiscard]] std::optional<double> node(std::size_t row, std::size_t column) const;
  [[nodiscard]] std::optional<double> along_row(std::size_t row, double column) const;
  [[nodiscard]] std::optional<double> beyond(std::size_t row, double distance_steps, double column) const;
  [[nodiscard]] std::optional<double> column_of(double longitude_deg) const;

  GeoidLattice lattice_;
  GeoidValues values_;
  std::size_t ring_columns_ = 0;  // different ones of a ring
  bool is_ring_ = false;
  std::array<Rim, 2> rims_{};  // of the first and the last row
};

}  // namespace sarsim::radar
