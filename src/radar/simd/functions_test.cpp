// The vector functions of the geometry, on every instruction set, against the standard library and
// core/maths/random.hpp.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "radar/simd/functions_test.cpp"
#include <hwy/foreach_target.h>  // includes this file once per instruction set

#include <cstdint>

#include "radar/simd/angle-inl.hpp"
#include "radar/simd/normals-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace sarsim::radar::HWY_NAMESPACE {

// `count` is a multiple of every vector's length.
template <class F>
void for_each_vector(std::size_t count, const F& f) {
  const hn::ScalableTag<double> d;
  for (std::size_t i = 0; i < count; i += hn::Lanes(d)) f(d, i);
}

void angles(const double* opposite, const double* adjacent, double* out, std::size_t count) {
  for_each_vector(count, [&](auto d, std::size_t i) {
    hn::StoreU(angle_between(d, hn::LoadU(d, opposite + i), hn::LoadU(d, adjacent + i)), d, out + i);
  });
}

void wrapped(const double* radians, double* out, std::size_t count) {
  for_each_vector(
      count, [&](auto d, std::size_t i) { hn::StoreU(wrapped_degrees(d, hn::LoadU(d, radians + i)), d, out + i); });
}

void amplitudes(const double* decibels, double* out, std::size_t count) {
  for_each_vector(count, [&](auto d, std::size_t i) {
    hn::StoreU(amplitude_of_decibels(d, hn::LoadU(d, decibels + i)), d, out + i);
  });
}

void normals(const std::uint64_t* keys, std::int64_t major, std::int64_t minor, double* first, double* second,
             std::size_t count) {
  for_each_vector(count, [&](auto d, std::size_t i) {
    const hn::RebindToUnsigned<decltype(d)> du;
    auto a = hn::Zero(d);
    auto b = hn::Zero(d);
    normal_pair(d, hn::LoadU(du, keys + i), major, minor, a, b);
    hn::StoreU(a, d, first + i);
    hn::StoreU(b, d, second + i);
  });
}

}  // namespace sarsim::radar::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "core/maths/constants.hpp"
#include "core/maths/random.hpp"
#include "radar/simd/simd_test_support.hpp"

namespace sarsim::radar {

HWY_EXPORT(angles);
HWY_EXPORT(wrapped);
HWY_EXPORT(amplitudes);
HWY_EXPORT(normals);

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t many = 4096;

TEST(AngleBetween, IsTheArcTangentWithinFourUnitsInTheLastPlace) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> turn(0.0, core::pi), magnitude(-12.0, 12.0);
  std::vector<double> y(many), x(many), out(many);
  for (std::size_t i = 0; i < many; ++i) {
    const double size = std::pow(10.0, magnitude(random));
    const double angle = i % 2 == 0 ? turn(random) : std::pow(10.0, -std::abs(magnitude(random)));
    y[i] = size * std::sin(angle);
    x[i] = size * (i % 4 == 3 ? -1.0 : 1.0) * std::cos(angle);
  }
  at_every_simd_level([&] {
    HWY_DYNAMIC_DISPATCH(angles)(y.data(), x.data(), out.data(), many);
    for (std::size_t i = 0; i < many; ++i) {
      const double expected = std::atan2(y[i], x[i]);
      ASSERT_NEAR(out[i], expected, 4.0 * epsilon * expected) << y[i] << ' ' << x[i];
    }
  });
}

TEST(AngleBetween, IsExactAlongTheAxesAndNothingForTheNullVector) {
  const std::vector<double> y{0, 0, 1, 1, 0, 1, 1, 5}, x{1, -1, 0, -0.0, 0, 1, -1, 1e-300};
  std::vector<double> out(8);
  at_every_simd_level([&] {
    HWY_DYNAMIC_DISPATCH(angles)(y.data(), x.data(), out.data(), 8);
    const double expected[] = {0.0, core::pi,     core::pi / 2,     core::pi / 2,
                               0.0, core::pi / 4, 3 * core::pi / 4, core::pi / 2};
    for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(out[i], expected[i]) << i;
  });
}

TEST(WrappedDegrees, AreTheRemainderOfWholeTurns) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> angle(-40.0, 40.0);
  std::vector<double> in(many), out(many);
  for (double& x : in) x = angle(random);
  in[0] = core::pi, in[1] = -core::pi, in[2] = 0.0, in[3] = 2.0 * core::pi;
  at_every_simd_level([&] {
    HWY_DYNAMIC_DISPATCH(wrapped)(in.data(), out.data(), many);
    // Without fused multiplication the product of turns, up to 40 rad, is rounded.
    for (std::size_t i = 0; i < many; ++i) {
      const double expected = std::remainder(in[i], 2.0 * core::pi) * 180.0 / core::pi;
      ASSERT_NEAR(std::remainder(out[i] - expected, 360.0), 0.0, 40.0 * epsilon * 180.0 / core::pi) << in[i];
      ASSERT_LE(std::abs(out[i]), 180.0 + 1e-12);
    }
    EXPECT_NEAR(std::abs(out[0]), 180.0, 1e-13);
    EXPECT_EQ(out[2], 0.0);
  });
}

TEST(AmplitudeOfDecibels, IsTheTwentiethPowerOfTen) {
  std::vector<double> in(many), out(many);
  for (std::size_t i = 0; i < many; ++i) in[i] = -6000.0 + 12000.0 * static_cast<double>(i) / many;
  in[0] = 0.0, in[1] = -1e300, in[2] = 1e300, in[3] = 6200.0, in[4] = -10000.0, in[5] = 20.0;
  at_every_simd_level([&] {
    HWY_DYNAMIC_DISPATCH(amplitudes)(in.data(), out.data(), many);
    for (std::size_t i = 6; i < many; ++i) {
      const double expected = std::pow(10.0, in[i] / 20.0);
      ASSERT_NEAR(out[i], expected, expected * epsilon * (4.0 + std::abs(in[i] * 0.23))) << in[i];
    }
    EXPECT_EQ(out[0], 1.0);
    EXPECT_EQ(out[1], 0.0);
    EXPECT_EQ(out[2], infinity);
    EXPECT_EQ(out[3], infinity);
    EXPECT_EQ(out[4], 0.0);
    EXPECT_NEAR(out[5], 10.0, 20.0 * epsilon);
  });
}

TEST(NormalPair, IsWhatTheStreamOfEveryLaneGives) {
  std::vector<core::RandomStream> streams;
  std::vector<std::uint64_t> keys;
  for (const core::RandomKind kind :
       {core::RandomKind::target_position, core::RandomKind::target_rcs, core::RandomKind::target_pointing})
    for (std::uint64_t object = 0; object < 1024; ++object) {
      streams.emplace_back(object % 5 == 4 ? ~object : 17, kind, object);
      keys.push_back(streams.back().key());
    }
  std::vector<double> first(keys.size()), second(keys.size());
  const std::int64_t counters[][2] = {{0, 0}, {1, 0}, {0, 1}, {-1, 7}, {std::int64_t{1} << 40, -5}, {123456789, 1}};
  at_every_simd_level([&] {
    for (const auto& [major, minor] : counters) {
      HWY_DYNAMIC_DISPATCH(normals)(keys.data(), major, minor, first.data(), second.data(), keys.size());
      for (std::size_t i = 0; i < keys.size(); ++i) {
        const auto [a, b] = streams[i].normals(major, minor);
        ASSERT_NEAR(first[i], a, 2e-14) << i;
        ASSERT_NEAR(second[i], b, 2e-14) << i;
      }
    }
  });
}

}  // namespace
}  // namespace sarsim::radar

#endif
