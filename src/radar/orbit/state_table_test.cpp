#include "radar/orbit/state_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "radar/orbit/orbit_test_support.hpp"

namespace sarsim::radar {
namespace state_table_test {

using core::Vec3;

// An orbit under J2 in Earth-fixed axes from a state of Sentinel-1A, by Runge and Kutta's method of fourth order with
// steps of 0.1 s: its own error is 1e-13 m a step and 1e-10 m in all. Positions are relative to the first one, and sums
// are compensated: rounding is that of a track of `length_s`.
class J2Orbit {
 public:
  explicit J2Orbit(int length_s) {
    Vec3 r{};
    Vec3 v = start.velocity_mps;
    Vec3 lost_r{}, lost_v{};
    for (int i = 0; i <= 10 * length_s; ++i) {
      states_.push_back({r, v});
      const auto [dr, dv] = step(r, v);
      add(r, lost_r, dr);
      add(v, lost_v, dv);
    }
  }
  [[nodiscard]] const OrbitState& at(int tenths) const { return states_[static_cast<std::size_t>(tenths)]; }
  [[nodiscard]] Vec3 acceleration(int tenths) const {
    return acceleration(at(tenths).position_m, at(tenths).velocity_mps);
  }
  // Every `step_s` seconds, with the origin at `origin` from the first state.
  [[nodiscard]] StateSamples samples(int step_s, const Vec3& origin = {}) const {
    StateSamples samples;
    for (int i = 0; i < static_cast<int>(states_.size()); i += 10 * step_s) {
      samples.time_s.push_back(0.1 * i);
      samples.position_m.push_back(at(i).position_m - origin);
      samples.velocity_mps.push_back(at(i).velocity_mps);
    }
    return samples;
  }

 private:
  static Vec3 acceleration(const Vec3& r, const Vec3& v) {
    return orbit_test::j2_acceleration(start.position_m + r, v);
  }
  static void add(Vec3& sum, Vec3& lost, const Vec3& term) {
    const Vec3 whole = term - lost;
    const Vec3 next = sum + whole;
    lost = (next - sum) - whole;
    sum = next;
  }
  static OrbitState step(const Vec3& r, const Vec3& v) {
    constexpr double h = 0.1;
    const Vec3 a1 = acceleration(r, v);
    const Vec3 v2 = v + (0.5 * h) * a1;
    const Vec3 a2 = acceleration(r + (0.5 * h) * v, v2);
    const Vec3 v3 = v + (0.5 * h) * a2;
    const Vec3 a3 = acceleration(r + (0.5 * h) * v2, v3);
    const Vec3 v4 = v + h * a3;
    const Vec3 a4 = acceleration(r + h * v3, v4);
    return {(h / 6.0) * (v + 2.0 * v2 + 2.0 * v3 + v4), (h / 6.0) * (a1 + 2.0 * a2 + 2.0 * a3 + a4)};
  }

  static constexpr OrbitState start = orbit_test::published_orbit_states[0].earth_fixed;
  std::vector<OrbitState> states_;
};

const J2Orbit& orbit() {
  static const J2Orbit orbit(900);
  return orbit;
}

StateTable table_of(const StateSamples& samples, StateInterpolation interpolation = hermite_degree_7,
                    double largest_gap_s = std::numeric_limits<double>::infinity()) {
  return std::get<StateTable>(StateTable::from(samples, interpolation, largest_gap_s));
}

struct Errors {
  double position_m = 0.0;
  double velocity_mps = 0.0;
  double acceleration_mps2 = 0.0;
};

// Largest errors where the polynomials are centred: `margin` states from the ends.
Errors errors(int step_s, StateInterpolation interpolation, const Vec3& origin = {}, int margin = 3) {
  const StateTable table = table_of(orbit().samples(step_s, origin), interpolation);
  Errors worst;
  for (int i = 10 * margin * step_s; i <= 9000 - 10 * margin * step_s; ++i) {
    const auto motion = table.at(0.1 * i);
    if (!motion) {
      ADD_FAILURE() << "nothing at " << 0.1 * i;
      continue;
    }
    worst.position_m = std::max(worst.position_m, core::norm(motion->position_m + origin - orbit().at(i).position_m));
    worst.velocity_mps = std::max(worst.velocity_mps, core::norm(motion->velocity_mps - orbit().at(i).velocity_mps));
    worst.acceleration_mps2 =
        std::max(worst.acceleration_mps2, core::norm(motion->acceleration_mps2 - orbit().acceleration(i)));
  }
  return worst;
}

// What the header promises.
TEST(StateTable, KeepsTheErrorsOfItsTable) {
  constexpr double rounding_m = 2.3e-9;
  EXPECT_LT(errors(10, hermite_cubic).position_m, 2.6e-4);
  EXPECT_LT(errors(30, hermite_cubic).position_m, 0.021);
  EXPECT_LT(errors(60, hermite_cubic).position_m, 0.33);
  EXPECT_LT(errors(10, hermite_degree_7).position_m, rounding_m);
  EXPECT_LT(errors(30, hermite_degree_7).position_m, rounding_m);
  EXPECT_LT(errors(60, hermite_degree_7).position_m, 4e-8);
  EXPECT_LT(errors(10, lagrange_8_points).position_m, rounding_m);
  EXPECT_LT(errors(30, lagrange_8_points).position_m, 2e-8);
  EXPECT_LT(errors(60, lagrange_8_points).position_m, 5e-6);
  for (const int step_s : {10, 30, 60}) {
    const Errors degree_7 = errors(step_s, hermite_degree_7);
    EXPECT_LT(degree_7.velocity_mps, 2e-9) << step_s;
    EXPECT_LT(degree_7.acceleration_mps2, 3e-10) << step_s;
  }
}

// A cubic through positions and velocities is off by h^4/384 times the fourth derivative; a table that did not use
// the velocities would not be.
TEST(StateTable, HasTheErrorOfTheory) {
  const double n = 7500.0 / 7.07e6;  // rad/s; the fourth derivative of a circle is n^4 r
  const double theory = std::pow(10.0 * n, 4.0) / 384.0 * 7.07e6;
  EXPECT_NEAR(errors(10, hermite_cubic).position_m / theory, 1.0, 0.15);
}

TEST(StateTable, IsOffByLittleMoreNearItsEnds) {
  EXPECT_LT(errors(60, hermite_degree_7, {}, 0).position_m, 4.0 * errors(60, hermite_degree_7).position_m);
  EXPECT_LT(errors(60, lagrange_8_points, {}, 0).position_m, 20.0 * errors(60, lagrange_8_points).position_m);
}

// Coordinates as far from the origin as those of an Earth-fixed frame.
TEST(StateTable, KeepsNanometresFarFromTheOrigin) {
  const Vec3 from_earth_centre = -orbit_test::published_orbit_states[0].earth_fixed.position_m;
  EXPECT_LT(errors(10, hermite_degree_7, from_earth_centre).position_m, 2.3e-9);
}

// Near the origin the rounding is that of the differences of neighbours: the reason for coordinates of a local frame.
TEST(StateTable, RoundsAsLittleAsItsCoordinatesDo) {
  const StateTable table = table_of(orbit().samples(10));
  double worst = 0.0;
  for (int i = 0; i <= 1000; ++i)
    worst = std::max(worst, core::norm(table.at(0.1 * i)->position_m - orbit().at(i).position_m));
  EXPECT_LT(worst, 3e-10);  // 7.5e5 m away: 1.2e-10 m for each coordinate
}

TEST(StateTable, TakesUnevenTimes) {
  const StateSamples all = orbit().samples(1);
  for (const StateInterpolation interpolation : {hermite_degree_7, lagrange_8_points}) {
    StateSamples some;
    for (std::size_t i = 0; i < all.time_s.size(); i += 1 + (i * i) % 17) {
      some.time_s.push_back(all.time_s[i]);
      some.position_m.push_back(all.position_m[i]);
      some.velocity_mps.push_back(all.velocity_mps[i]);
    }
    const StateTable table = table_of(some, interpolation);
    const int last = static_cast<int>(std::lround(10.0 * some.time_s.back()));
    double worst = 0.0;
    for (int i = 0; i <= last; ++i)
      worst = std::max(worst, core::norm(table.at(0.1 * i)->position_m - orbit().at(i).position_m));
    EXPECT_LT(worst, interpolation.use_velocities ? 3e-9 : 1e-8);
  }
}

// Both are the one polynomial of degree 3 that all of its points lie on.
TEST(StateTable, ReproducesPolynomials) {
  const auto motion_of = [](double t) {
    return OrbitMotion{{1.0 + t * (2.0 - t * (0.5 - 0.01 * t)), 7.0, t},
                       {2.0 - t * (1.0 - 0.03 * t), 0.0, 1.0},
                       {-1.0 + 0.06 * t, 0.0, 0.0}};
  };
  StateSamples samples;
  for (const double t : {-3.0, -2.5, 0.0, 1.0, 4.0, 7.0, 10.0, 11.0, 13.0}) {
    samples.time_s.push_back(t);
    samples.position_m.push_back(motion_of(t).position_m);
    samples.velocity_mps.push_back(motion_of(t).velocity_mps);
  }
  for (const StateInterpolation interpolation :
       {hermite_cubic, StateInterpolation{true, 3}, hermite_degree_7, StateInterpolation{true, 8},
        StateInterpolation{false, 4}, StateInterpolation{false, 5}, StateInterpolation{false, 9}}) {
    const StateTable table = table_of(samples, interpolation);
    for (double t = -3.0; t <= 13.0; t += 0.0625) {
      const OrbitMotion expected = motion_of(t);
      const auto found = table.at(t);
      ASSERT_TRUE(found.has_value());
      EXPECT_LT(core::norm(found->position_m - expected.position_m), 1e-10) << interpolation.states << " " << t;
      EXPECT_LT(core::norm(found->velocity_mps - expected.velocity_mps), 1e-9) << interpolation.states << " " << t;
      EXPECT_LT(core::norm(found->acceleration_mps2 - expected.acceleration_mps2), 1e-8)
          << interpolation.states << " " << t;
    }
    EXPECT_GE(table.acceleration_bound_mps2(), 1.18);  // at -3 s
    EXPECT_LT(table.acceleration_bound_mps2(), 2.0);
  }
}

TEST(StateTable, GivesTheStatesThemselvesBack) {
  const StateSamples samples = orbit().samples(30);
  const StateTable table = table_of(samples);
  for (std::size_t i = 0; i < samples.time_s.size(); ++i) {
    const auto motion = table.at(samples.time_s[i]);
    ASSERT_TRUE(motion.has_value());
    EXPECT_LT(core::norm(motion->position_m - samples.position_m[i]), i + 1 < samples.time_s.size() ? 1e-300 : 2e-9);
    EXPECT_LT(core::norm(motion->velocity_mps - samples.velocity_mps[i]), 1e-11);
  }
}

TEST(StateTable, ContinuesNothingBeyondItsEnds) {
  const StateTable table = table_of(orbit().samples(10));
  EXPECT_TRUE(table.at(0.0).has_value());
  EXPECT_TRUE(table.at(900.0).has_value());
  EXPECT_FALSE(table.at(-1e-9).has_value());
  EXPECT_FALSE(table.at(900.0001).has_value());
  EXPECT_FALSE(table.at(std::numeric_limits<double>::quiet_NaN()).has_value());
  EXPECT_TRUE(table.covers(0.0, 900.0));
  EXPECT_FALSE(table.covers(-1.0, 900.0));
  EXPECT_FALSE(table.covers(0.0, 901.0));
}

TEST(StateTable, LeavesGapsOpen) {
  StateSamples samples = orbit().samples(10);
  const auto remove = [&](std::size_t first, std::size_t count) {
    const auto erase = [&](auto& list) {
      const auto begin = list.begin() + static_cast<std::ptrdiff_t>(first);
      list.erase(begin, begin + static_cast<std::ptrdiff_t>(count));
    };
    erase(samples.time_s);
    erase(samples.position_m);
    erase(samples.velocity_mps);
  };
  remove(60, 5);  // 590 s to 650 s
  remove(24, 4);  // 230 s to 280 s; then 3 states at 280, 290 and 300 s
  remove(27, 6);  // 300 s to 370 s
  const StateTable table = table_of(samples, hermite_degree_7, 10.5);
  const std::vector<TimeSpan> expected{{0.0, 230.0}, {370.0, 590.0}, {650.0, 900.0}};
  EXPECT_EQ(table.spans(), expected);
  for (double t = 0.0; t <= 900.0; t += 0.5) {
    const bool inside =
        std::ranges::any_of(expected, [&](auto& span) { return t >= span.first_s && t <= span.last_s; });
    EXPECT_EQ(table.at(t).has_value(), inside) << t;
    EXPECT_EQ(table.covers(t, t), inside) << t;
    if (inside) {
      EXPECT_LT(core::norm(table.at(t)->position_m - orbit().at(static_cast<int>(10.0 * t)).position_m), 3e-9) << t;
    }
  }
  EXPECT_FALSE(table.covers(100.0, 400.0));
  // The same states without a limit have no gap.
  EXPECT_EQ(table_of(samples).spans(), (std::vector<TimeSpan>{{0.0, 900.0}}));
}

TEST(StateTable, TakesTheLargestGapAsIs) {
  StateSamples samples = orbit().samples(10);
  samples.time_s.erase(samples.time_s.begin() + 45);
  samples.position_m.erase(samples.position_m.begin() + 45);
  samples.velocity_mps.erase(samples.velocity_mps.begin() + 45);
  EXPECT_EQ(table_of(samples, hermite_degree_7, 19.9).spans().size(), 2U);
  EXPECT_EQ(table_of(samples, hermite_degree_7, 20.0).spans().size(), 1U);
}

TEST(StateTable, RefusesWhatIsNoTable) {
  const StateSamples good = orbit().samples(100);
  const auto message_of = [](const StateSamples& samples, StateInterpolation interpolation = hermite_degree_7) {
    const auto table = StateTable::from(samples, interpolation);
    return std::holds_alternative<core::Problem>(table) ? std::get<core::Problem>(table).message : "none";
  };
  EXPECT_EQ(message_of(good), "none");
  StateSamples bad = good;
  bad.position_m.pop_back();
  EXPECT_EQ(message_of(bad), "positions and times differ in number");
  bad = good;
  bad.velocity_mps.pop_back();
  EXPECT_EQ(message_of(bad), "velocities and times differ in number");
  bad.velocity_mps.clear();
  EXPECT_EQ(message_of(bad), "the states have no velocities");
  EXPECT_EQ(message_of(bad, lagrange_8_points), "none");
  bad = good;
  bad.time_s[4] = bad.time_s[3];
  EXPECT_EQ(message_of(bad), "the time of state 5 does not ascend");
  bad = good;
  bad.velocity_mps[2].y = std::numeric_limits<double>::infinity();
  EXPECT_EQ(message_of(bad), "state 3 is not finite");
  bad = good;
  bad.time_s[0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(message_of(bad), "state 1 is not finite");
  EXPECT_EQ(message_of({}), "there are too few states to interpolate");
  EXPECT_EQ(message_of(good, StateInterpolation{false, 11}), "there are too few states to interpolate");
}

}  // namespace state_table_test
}  // namespace sarsim::radar
