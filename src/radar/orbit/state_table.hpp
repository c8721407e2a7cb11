#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <variant>
#include <vector>

#include "core/maths/vector.hpp"
#include "core/report/problem.hpp"
#include "radar/orbit/orbit_state.hpp"

namespace sarsim::radar {

/// States of a satellite at certain times, one frame for all. The rounding of coordinates is that of the result: at
/// 7e6 m from the origin of the frame it is 1e-9 m, at 8e5 m 1e-10 m.
struct StateSamples {
  std::vector<double> time_s;  ///< After a common time; ascending, spaced as they like.
  std::vector<core::Vec3> position_m;
  std::vector<core::Vec3> velocity_mps;  ///< Derivatives of the positions in the same frame; empty where unknown.
};

/// The polynomial through neighbouring states.
struct StateInterpolation {
  bool use_velocities = true;  ///< Hermite: positions and velocities; otherwise Lagrange: positions alone.
  std::size_t states = 4;      ///< 2 to 8 with velocities, 2 to 16 without.

  [[nodiscard]] std::size_t coefficients() const { return use_velocities ? 2 * states : states; }
};

/// Largest errors between states of a low orbit (7070 km) in Earth-fixed axes, with a state every
///
///                         10 s        30 s        60 s
///     cubic             2.6e-4 m     0.021 m      0.33 m
///     degree 7         rounding     rounding     4e-8 m
///     8 positions      rounding      2e-8 m      5e-6 m
///
/// Rounding is that of the coordinates: 2.3e-9 m at 7e6 m. The velocity of degree 7 is good to 2e-9 m/s in all of these
/// and the acceleration to 3e-10 m/s^2.
inline constexpr StateInterpolation hermite_cubic{true, 2};
inline constexpr StateInterpolation hermite_degree_7{true, 4};
inline constexpr StateInterpolation lagrange_8_points{false, 8};

/// A part of a table between two gaps.
struct TimeSpan {
  double first_s = 0.0;
  double last_s = 0.0;

  friend bool operator==(const TimeSpan&, const TimeSpan&) = default;
};

/// A motion through given states. Between two neighbouring states it is one polynomial, through these and the states
/// around them; near the ends of a span the polynomial is not centred, and its error is up to 3 times larger (degree 7)
/// or 20 times (8 positions). Position, velocity and acceleration are those of the polynomial. At states the position
/// is continuous; with velocities the velocity is too; the acceleration jumps by the error of the interpolation.
///
/// Nothing is continued beyond the first and the last state, nor into gaps. A call takes about 50 ns for even spacing,
/// and the logarithm of the number of states more for uneven spacing. Memory: 24 B for each coefficient and interval, 2
/// MB for a day of states every 10 s. Const members are safe to call from many threads.
class StateTable {
 public:
  /// Prepares the polynomials. Refuses lists of different lengths, numbers that are not finite, times that do not
  /// ascend, missing velocities, and tables without one span of enough states.
  /// @param largest_gap_s  neighbouring states further apart than this leave a gap between them
  [[nodiscard]] static std::variant<StateTable, core::Problem> from(
      const StateSamples& samples, StateInterpolation interpolation = hermite_degree_7,
      double largest_gap_s = std::numeric_limits<double>::infinity());

  /// The motion at a time; nothing outside `spans`.
  [[nodiscard]] std::optional<OrbitMotion> at(double time_s) const;

  /// The times that the table covers, ascending. Parts of too few states between gaps are not covered.
  [[nodiscard]] const std::vector<TimeSpan>& spans() const { return spans_; }
  /// True where one span covers all times from the first to the last.
  [[nodiscard]] bool covers(double first_s, double last_s) const;
  /// No acceleration of the polynomials exceeds this.
  [[nodiscard]] double acceleration_bound_mps2() const { return acceleration_bound_mps2_; }

 private:
  StateTable() = default;
  void add_span(const StateSamples& samples, std::size_t begin, std::size_t end);
  void add_interval(const StateSamples& samples, std::size_t left, std::size_t first);
  [[nodiscard]] std::size_t interval_of(double time_s) const;

  StateInterpolation interpolation_;
  std::vector<double> times_;
  std::vector<std::size_t> coefficients_from_;  // for each interval, its first in coefficients_; or none
  std::vector<core::Vec3> coefficients_;        // of powers of (t - left)/(right - left)
  std::vector<TimeSpan> spans_;
  double intervals_per_s_ = 0.0;
  double acceleration_bound_mps2_ = 0.0;
};

}  // namespace sarsim::radar
