#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/report/problem.hpp"
#include "simulate/plan/pulse_geometry.hpp"
#include "simulate/run/geometry_table.hpp"

namespace sarsim::gui {

/// What of a geometry table is to be computed: its `columns` and the targets that are looked at.
struct GeometryChoice {
  scene::GeometryTable table;
  bool distance = false;             ///< The one-way distance of each target besides the columns of the table.
  std::vector<std::size_t> targets;  ///< In the scene's order; those that the scene does not have are left out.

  friend bool operator==(const GeometryChoice&, const GeometryChoice&) = default;
};

/// One column of the table on screen. Values are in SI units, angles in degrees; `scale` and `unit` are for showing.
struct GeometryHeading {
  std::string quantity;  ///< "Position X".
  std::string owner;     ///< Platform or target; empty for columns of the pulse.
  std::string unit;
  double scale = 1.0;  ///< Shown values are the numbers over this.
  int digits = 10;     ///< Significant ones that are shown.
};

/// The rows of a geometry table, one for each pulse, computed where they are asked for. One thread at a time.
class GeometryRows {
 public:
  /// The scene must have passed `check` with the table in it; throws std::invalid_argument where not.
  GeometryRows(const scene::Scene& scene, GeometryChoice choice);
  GeometryRows(const GeometryRows&) = delete;
  GeometryRows& operator=(const GeometryRows&) = delete;

  /// The pulse number first.
  [[nodiscard]] const std::vector<GeometryHeading>& headings() const { return headings_; }
  [[nodiscard]] const radar::PulseRange& pulses() const { return range_; }
  [[nodiscard]] std::int64_t count() const { return range_.count(); }

  /// Values of some rows, row by row, in the order of the headings. Columns of a target are NaN where its range c tau/2
  /// lies outside the slant range window.
  [[nodiscard]] std::vector<double> values(std::int64_t first_row, std::int64_t rows);

 private:
  void add_headings(const scene::Scene& scene);
  void add_row(std::vector<double>& values) const;
  void add_target(std::size_t target, std::vector<double>& values) const;
  [[nodiscard]] bool has(simulate::GeometryColumn column) const { return (choice_.table.columns & column) != 0; }

  GeometryChoice choice_;
  simulate::ResolvedScene resolved_;
  simulate::Link radar_;
  simulate::PulseGeometry geometry_;
  radar::PulseRange range_;
  std::size_t platforms_ = 0;
  std::vector<GeometryHeading> headings_;
};

/// What stands in the way of a table of a scene, whatever its other recordings are like; empty where nothing does.
[[nodiscard]] core::Problems geometry_errors(const scene::Scene& scene, const scene::GeometryTable& table);

/// Numbers from 1 as people type them, "1-20, 35", as ascending indices from 0 below `count`; what is not understood is
/// said in `failure`.
struct NumberChoice {
  std::vector<std::size_t> indices;
  std::string failure;
};
[[nodiscard]] NumberChoice read_numbers(std::string_view text, std::size_t count);

}  // namespace sarsim::gui
