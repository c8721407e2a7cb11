// Tabulated curves, looked up on every instruction set, against the functions that they stand for.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "radar/echo/curve_tables_test.cpp"
#include <hwy/foreach_target.h>  // includes this file once per instruction set

#include "radar/echo/simd_curves-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace sarsim::radar::HWY_NAMESPACE {

// `count` is a multiple of every vector's length; each angle has its own table.
void curve_values(const CurveTables& tables, const std::int64_t* table, const double* angle, double* out,
                  std::size_t count) {
  const hn::ScalableTag<double> d;
  for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
    HWY_ALIGN double first[hn::MaxLanes(d)];
    for (std::size_t l = 0; l < hn::Lanes(d); ++l)
      first[l] = static_cast<double>(table[i + l]) * static_cast<double>(tables.cells);
    hn::StoreU(curve_value(d, tables, hn::Load(d, first), hn::LoadU(d, angle + i)), d, out + i);
  }
}

}  // namespace sarsim::radar::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include "radar/echo/echo_test_support.hpp"

namespace sarsim::radar {

HWY_EXPORT(curve_values);

namespace {

constexpr std::array methods{core::Interpolation::linear, core::Interpolation::cubic, core::Interpolation::low_pass};
constexpr std::array rules{core::LowPassRule::first_knot, core::LowPassRule::origin};

core::Interpolator through(core::Interpolation method, std::vector<core::Knot> knots,
                           core::LowPassRule rule = core::LowPassRule::first_knot) {
  return core::Interpolator(core::SampledFunction{method, std::move(knots)}, rule);
}

CurveTables tables_of(const std::vector<core::Interpolator>& curves, double tolerance_db) {
  std::vector<const core::Interpolator*> pointers;
  pointers.reserve(curves.size());
  for (const core::Interpolator& curve : curves) pointers.push_back(&curve);
  return tabulate(pointers, tolerance_db);
}

// Uneven knots over `from` to `to` degrees.
std::vector<core::Knot> random_knots(unsigned seed, std::size_t count, double from, double to, double lowest_db) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(from, to), gain(lowest_db, 0.0);
  std::vector<core::Knot> knots;
  for (std::size_t i = 0; i < count; ++i) knots.push_back({place(random), gain(random)});
  std::ranges::sort(knots, {}, &core::Knot::x);
  return knots;
}

// Angles at random, at both ends, and at knots and next to them.
std::vector<double> angles_for(const std::vector<core::Interpolator>& curves) {
  std::vector<double> angles{0.0, 180.0, 90.0, 45.0, 5e-324, 1e-9};
  for (const core::Interpolator& curve : curves)
    for (const core::Knot& knot : curve.knots())
      for (const double x : {knot.x, knot.x - 1e-7, knot.x + 1e-7})
        if (x >= 0.0 && x <= 180.0) angles.push_back(x);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> angle(0.0, 180.0);
  while (angles.size() < 4000 || angles.size() % 16 != 0) angles.push_back(angle(random));
  return angles;
}

// The largest error of each curve, where `slope_db` per degree times the rounding of an angle is forgiven.
void expect_tabulated(const std::vector<core::Interpolator>& curves, double tolerance_db, double slope_db = 1e3) {
  const CurveTables tables = tables_of(curves, tolerance_db);
  ASSERT_TRUE(tables.sound);
  ASSERT_EQ(tables.number.size(), curves.size());
  const std::vector<double> angles = angles_for(curves);
  std::vector<std::int64_t> number(angles.size());
  std::vector<double> out(angles.size());
  at_every_simd_level([&] {
    for (std::size_t shift = 0; shift < curves.size(); ++shift) {
      const auto curve_of = [&](std::size_t i) { return (i + shift) % curves.size(); };
      for (std::size_t i = 0; i < angles.size(); ++i) number[i] = tables.number[curve_of(i)];
      HWY_DYNAMIC_DISPATCH(curve_values)(tables, number.data(), angles.data(), out.data(), angles.size());
      for (std::size_t i = 0; i < angles.size(); ++i) {
        const double expected = curves[curve_of(i)].value(angles[i]);
        ASSERT_NEAR(out[i], expected, tolerance_db + 1e-12 * std::abs(expected) + slope_db * 2e-13)
            << curve_of(i) << " at " << angles[i];
      }
    }
  });
}

TEST(CurveTables, OfLinesAndSplinesAreExactAtTheirKnotsAndBetween) {
  for (const core::Interpolation method : {core::Interpolation::linear, core::Interpolation::cubic})
    for (const std::size_t count : {2U, 3U, 4U, 17U, 181U}) {
      std::vector<core::Knot> even;
      for (std::size_t i = 0; i < count; ++i)
        even.push_back({180.0 * static_cast<double>(i) / static_cast<double>(count - 1),
                        -40.0 * std::abs(std::sin(static_cast<double>(i)))});
      expect_tabulated({through(method, even)}, 1e-12);
      expect_tabulated({through(method, random_knots(5, count, 0.0, 180.0, -300.0))}, 1e-12, 1e7);
    }
}

TEST(CurveTables, ContinueBeyondTheKnotsAsTheCurvesDo) {
  for (const core::LowPassRule rule : rules)
    for (const core::Interpolation method : methods)
      for (const auto& [from, to] : {std::pair{20.0, 50.0}, std::pair{-30.0, 60.0}, std::pair{100.0, 400.0},
                                     std::pair{-90.0, -10.0}, std::pair{200.0, 300.0}})
        expect_tabulated({through(method, random_knots(6, 7, from, to, -30.0), rule)}, 1e-7);
}

TEST(CurveTables, OfLowPassCurvesKeepTheToleranceThatIsAskedFor) {
  std::vector<core::Knot> even;
  for (int i = 0; i <= 36; ++i) even.push_back({5.0 * i, i % 4 == 0 ? -60.0 : -3.0 * (i % 5)});
  for (const core::LowPassRule rule : rules)
    for (const double tolerance_db : {1e-2, 1e-6, 1e-10}) {
      expect_tabulated({through(core::Interpolation::low_pass, even, rule)}, tolerance_db);
      expect_tabulated({through(core::Interpolation::low_pass, random_knots(7, 23, 0.0, 180.0, -20.0), rule)},
                       tolerance_db);
    }
}

// The bare sinc drops a term and takes another halfway between grid points: a jump, which no polynomial may smear.
TEST(CurveTables, JumpWhereAClassicLowPassCurveDoes) {
  std::vector<core::Knot> knots;
  knots.reserve(30);
  for (int i = 0; i < 30; ++i) knots.push_back({0.7 * i, -30.0 - i % 7});
  const core::Interpolator curve = through(core::Interpolation::low_pass, knots, core::LowPassRule::origin);
  const CurveTables tables = tables_of({curve}, 1e-8);
  std::vector<double> angles;
  for (int k = 0; k < 40; ++k)
    for (const double beside : {-1e-12, 1e-12}) angles.push_back((k + 0.5) * 0.7 + beside);
  std::vector<double> out(angles.size());
  const std::vector<std::int64_t> number(angles.size(), 0);
  double largest_jump = 0.0;
  at_every_simd_level([&] {
    HWY_DYNAMIC_DISPATCH(curve_values)(tables, number.data(), angles.data(), out.data(), angles.size());
    for (std::size_t i = 0; i < angles.size(); ++i) ASSERT_NEAR(out[i], curve.value(angles[i]), 1e-7) << angles[i];
    for (std::size_t i = 0; i < angles.size(); i += 2) largest_jump = std::max(largest_jump, out[i + 1] - out[i]);
  });
  EXPECT_GT(largest_jump, 0.5);
}

TEST(CurveTables, OfNoKnotsAreZeroAndOfOneKnotConstant) {
  for (const core::Interpolation method : methods)
    expect_tabulated({through(method, {}), through(method, {{30.0, -7.5}}), through(method, {{-5.0, 3.0}})}, 1e-12,
                     0.0);
}

TEST(CurveTables, HoldCurvesOfEverySortSideBySide) {
  std::vector<core::Interpolator> curves;
  for (unsigned i = 0; i < 12; ++i)
    curves.push_back(through(methods[i % 3], random_knots(i, 2 + 3 * i, 0.0, 180.0, -50.0), rules[i % 2]));
  curves.emplace_back();
  expect_tabulated(curves, 1e-7, 1e6);
}

// 300 dB over a thousandth of a degree, and a hundred knots within a hundredth.
TEST(CurveTables, MeetSteepStepsAndCrowdsOfKnots) {
  std::vector<core::Knot> crowd{{0.0, 0.0}};
  for (int i = 0; i < 100; ++i) crowd.push_back({60.0 + 1e-4 * i, i % 2 == 0 ? -1.0 : -2.0});
  crowd.push_back({180.0, -300.0});
  for (const core::Interpolation method : {core::Interpolation::linear, core::Interpolation::cubic})
    expect_tabulated({through(method, {{0.0, 0.0}, {10.0, 0.0}, {10.001, -300.0}, {180.0, -300.0}}),
                      through(method, crowd), through(method, {{0.0, 0.0}, {90.0, -1e9}})},
                     1e-12, 1e6);
}

// A knot that is a millionth of a degree off its grid point: fifth powers of so narrow a piece would lose all digits if
// they were about the middle of the cell that the piece begins.
TEST(CurveTables, KeepTheDigitsOfNarrowPieces) {
  std::vector<core::Knot> knots;
  for (int i = 0; i <= 36; ++i) knots.push_back({5.0 * i + (i == 9 ? 1e-6 : 0.0), -3.0 * (i % 5)});
  for (const core::LowPassRule rule : rules)
    expect_tabulated({through(core::Interpolation::low_pass, knots, rule)}, 1e-7);
}

TEST(CurveTables, TakeAnglesThatRoundingPutsOutsideTheirRange) {
  const std::vector<core::Interpolator> curves{through(core::Interpolation::linear, {{0.0, 0.0}, {180.0, -18.0}})};
  const CurveTables tables = tables_of(curves, 1e-9);
  const std::vector<double> angles{-1e-14, 180.00000000000003, 181.0, -0.0, std::nan(""), 180.0, 0.0, 1e300};
  const double expected[] = {0.0, -18.0, -18.0, 0.0, 0.0, -18.0, 0.0, -18.0};
  std::vector<double> out(8);
  const std::vector<std::int64_t> number(8, 0);
  at_every_simd_level([&] {
    HWY_DYNAMIC_DISPATCH(curve_values)(tables, number.data(), angles.data(), out.data(), 8);
    for (std::size_t i = 0; i < 8; ++i) EXPECT_NEAR(out[i], expected[i], 1e-13) << i;
  });
}

TEST(CurveTables, AreSharedByEqualCurvesOnly) {
  const std::vector<core::Knot> bent{{0.0, 0.0}, {10.0, -3.0}, {20.0, -3.0}, {90.0, -30.0}, {180.0, -30.0}};
  const std::vector<core::Knot> straight{{20.0, 0.0}, {30.0, -1.0}, {40.0, -2.0}};
  std::vector<core::Interpolator> curves;
  for (int i = 0; i < 3; ++i)
    for (const auto& knots : {bent, straight})
      for (const core::Interpolation method : methods)
        for (const core::LowPassRule rule : rules) curves.push_back(through(method, knots, rule));
  const CurveTables tables = tables_of(curves, 1e-6);
  // Of each: lines, spline and two low-pass curves; the spline through points of a straight line is that line.
  EXPECT_LE(tables.count, 8u);
  EXPECT_GE(tables.count, 7u);
  for (std::size_t i = 0; i < curves.size(); ++i) EXPECT_EQ(tables.number[i], tables.number[i % 12]);
  expect_tabulated(curves, 1e-6);
}

// Cuts of all sorts in one set: mirrored, all the way round, with a gap, with a step behind, constant.
TEST(CurveTables, TellOneSideOfACutFromTheOther) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> start(-200.0, -20.0), size(20.0, 359.0);
  for (int draw = 0; draw < 12; ++draw)
    for (const core::Interpolation method : methods) {
      const double from = start(random);
      std::vector<core::AngleFunction> cuts;
      const auto add = [&](std::vector<core::Knot> knots, core::AngleRule rule) {
        cuts.emplace_back(core::SampledFunction{method, std::move(knots)}, core::InterpolationRules{}, rule);
      };
      const auto seed = static_cast<unsigned>(draw);
      add(random_knots(seed, 9, 0.0, 150.0, -30.0), core::AngleRule::azimuth);
      add(random_knots(seed + 50, 7, from, from + size(random), -30.0), core::AngleRule::azimuth);
      add(random_knots(seed + 100, 7, -90.0, 90.0, -30.0), core::AngleRule::elevation);
      add({{-180.0, -9.0}, {3.0, 0.0}, {180.0, -4.0}}, core::AngleRule::azimuth);
      add({{4.0, -3.0}}, core::AngleRule::elevation);
      std::vector<core::Knot> round;
      for (int i = 0; i < 36; ++i) round.push_back({from + 10.0 * i, -1.0 * (i % 7)});
      add(round, core::AngleRule::azimuth);
      std::vector<const core::AngleFunction*> pointers;
      for (const core::AngleFunction& cut : cuts) pointers.push_back(&cut);
      const CurveTables tables = tabulate(pointers, 1e-7);
      ASSERT_TRUE(tables.sound);
      ASSERT_EQ(tables.first_deg, -180.0);
      std::vector<double> angles{-90.0, 90.0, 0.0, -0.0, 1e-9, -1e-9, 179.999, -179.999};
      std::uniform_real_distribution<double> angle(-180.0, 180.0);
      while (angles.size() < 800) angles.push_back(angle(random));
      std::vector<double> out(angles.size());
      at_every_simd_level([&] {
        for (std::size_t k = 0; k < cuts.size(); ++k) {
          const std::vector<std::int64_t> number(angles.size(), tables.number[k]);
          HWY_DYNAMIC_DISPATCH(curve_values)(tables, number.data(), angles.data(), out.data(), angles.size());
          // The rounding of an angle counted from -180 degrees is 3e-14; knots at random are as steep as 1e5 dB/deg.
          for (std::size_t i = 0; i < angles.size(); ++i)
            ASSERT_NEAR(out[i], cuts[k].value(angles[i]), 2e-7) << k << " at " << angles[i];
        }
      });
    }
}

TEST(CurveTables, OfEvenCutsAreThoseOfMagnitudes) {
  const core::AngleFunction cut({core::Interpolation::cubic, {{0.0, 0.0}, {9.0, -3.0}, {90.0, -30.0}}}, {},
                                core::AngleRule::azimuth);
  const CurveTables tables = tabulate(std::array{&cut}, 1e-9);
  const CurveTables same = tabulate(std::array{&cut.function()}, 1e-9);
  EXPECT_EQ(tables.first_deg, 0.0);
  EXPECT_EQ(tables.records, same.records);
}

TEST(CurveTables, AreNotSoundWhereACurveIsNotFinite) {
  EXPECT_FALSE(tables_of({through(core::Interpolation::linear, {{0.0, 1e308}, {1e-3, -1e308}})}, 1e-6).sound);
  EXPECT_TRUE(tables_of({through(core::Interpolation::linear, {{0.0, 0.0}, {90.0, -1e30}})}, 1e-6).sound);
  EXPECT_TRUE(tables_of({}, 1e-6).sound);
}

}  // namespace
}  // namespace sarsim::radar

#endif
