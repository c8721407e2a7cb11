#include "core/maths/random.hpp"

#include <Random123/philox.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <thread>
#include <vector>

namespace sarsim::core {
namespace random_test {

constexpr RandomKind noise = RandomKind::receiver_noise;

// The generator underneath, against the answers published with it (Random123, kat_vectors).
TEST(Philox, GivesTheKnownAnswers) {
  using Counter = r123::Philox4x32::ctr_type;
  using Key = r123::Philox4x32::key_type;
  const Counter zeros = r123::Philox4x32()(Counter{{0, 0, 0, 0}}, Key{{0, 0}});
  EXPECT_EQ(zeros, (Counter{{0x6627e8d5U, 0xe169c58dU, 0xbc57ac4cU, 0x9b00dbd8U}}));
  const Counter ones = r123::Philox4x32()(Counter{{~0U, ~0U, ~0U, ~0U}}, Key{{~0U, ~0U}});
  EXPECT_EQ(ones, (Counter{{0x408f276dU, 0x41c83b0eU, 0xa20bc7c6U, 0x6d5451fdU}}));
}

TEST(RandomStream, GivesTheSameNumbersForTheSameKeyInAnyOrder) {
  const RandomStream a(1, noise, 7);
  const RandomStream b(1, noise, 7);
  for (std::int64_t i = 0; i < 100; ++i) EXPECT_EQ(a.normals(3, i), b.normals(3, i));
  for (std::int64_t i = 99; i >= 0; --i) EXPECT_EQ(a.normals(3, i), b.normals(3, i));
}

TEST(RandomStream, GivesTheSameNumbersOnEveryThread) {
  const RandomStream stream(1, noise, 0);
  std::vector<std::array<double, 2>> results(4);
  {
    std::vector<std::jthread> threads;
    threads.reserve(results.size());
    for (auto& result : results) threads.emplace_back([&result, stream] { result = stream.normals(-5, 12); });
  }
  for (const auto& result : results) EXPECT_EQ(result, stream.normals(-5, 12));
}

TEST(RandomStream, DiffersWithSeedKindObjectAndCounters) {
  std::set<std::array<double, 2>> seen;
  std::size_t count = 0;
  const auto draw = [&](std::uint64_t seed, RandomKind kind, std::uint64_t object, std::int64_t major,
                        std::int64_t minor) {
    seen.insert(RandomStream(seed, kind, object).normals(major, minor));
    ++count;
  };
  for (const std::uint64_t seed : {0ULL, 1ULL, 2ULL, 1ULL << 32, ~0ULL}) draw(seed, noise, 0, 0, 0);
  for (const RandomKind kind : {RandomKind::platform_position, RandomKind::platform_rotation,
                                RandomKind::position_envelope, RandomKind::rotation_envelope,
                                RandomKind::target_position, RandomKind::target_rcs, RandomKind::target_pointing})
    draw(1, kind, 0, 0, 0);
  for (const std::uint64_t object : {1ULL, 2ULL, 1ULL << 32, ~0ULL}) draw(1, noise, object, 0, 0);
  for (const std::int64_t counter :
       {std::int64_t{1}, std::int64_t{-1}, std::int64_t{1} << 31, std::int64_t{1} << 32, std::int64_t{1} << 62}) {
    draw(1, noise, 0, counter, 0);
    draw(1, noise, 0, 0, counter);
    draw(1, noise, 0, counter, counter);
  }
  EXPECT_EQ(seen.size(), count);
}

// A stream of kind k and object o must not be the stream of another pair, for any of the small numbers in use.
TEST(RandomStream, KeepsKindsAndObjectsApart) {
  std::set<std::array<double, 2>> seen;
  for (std::uint64_t seed = 0; seed < 20; ++seed)
    for (std::uint32_t kind = 1; kind <= 8; ++kind)
      for (std::uint64_t object = 0; object < 100; ++object)
        seen.insert(RandomStream(seed, static_cast<RandomKind>(kind), object).normals(0, 0));
  EXPECT_EQ(seen.size(), 20U * 8U * 100U);
}

// n draws of x^k have mean m_k and variance m_2k - m_k^2, with m_2 = 1, m_4 = 3, m_6 = 15, m_8 = 105.
TEST(RandomStream, HasTheMomentsOfANormalDistribution) {
  constexpr int pairs = 500'000;
  constexpr double n = 2.0 * pairs;
  const RandomStream stream(1, noise, 0);
  double sum[5] = {};
  for (int i = 0; i < pairs; ++i) {
    for (const double x : stream.normals(i / 1000, i % 1000)) {
      double power = 1.0;
      for (double& s : sum) s += power, power *= x;
    }
  }
  EXPECT_NEAR(sum[1] / n, 0.0, 5.0 * std::sqrt(1.0 / n));
  EXPECT_NEAR(sum[2] / n, 1.0, 5.0 * std::sqrt((3.0 - 1.0) / n));
  EXPECT_NEAR(sum[3] / n, 0.0, 5.0 * std::sqrt(15.0 / n));
  EXPECT_NEAR(sum[4] / n, 3.0, 5.0 * std::sqrt((105.0 - 9.0) / n));
}

// The product of two independent normal variates has mean 0 and variance 1.
TEST(RandomStream, HasNoCorrelationBetweenNeighbours) {
  constexpr int count = 250'000;
  const double gate = 5.0 * std::sqrt(static_cast<double>(count));
  const RandomStream stream(1, noise, 0);
  const RandomStream next_object(1, noise, 1);
  const RandomStream next_seed(2, noise, 0);
  double within = 0.0;
  double next_minor = 0.0;
  double next_major = 0.0;
  double object = 0.0;
  double seed = 0.0;
  for (int i = 0; i < count; ++i) {
    const auto [x, y] = stream.normals(0, i);
    within += x * y;
    next_minor += x * stream.normals(0, i + 1)[0];
    next_major += x * stream.normals(1, i)[0];
    object += x * next_object.normals(0, i)[0];
    seed += x * next_seed.normals(0, i)[0];
  }
  for (const double sum : {within, next_minor, next_major, object, seed}) EXPECT_LE(std::abs(sum), gate);
}

// Of 10^6 draws P(|x| > 3) = 0.0026998 expects 2699.8 with a deviation of 51.9.
TEST(RandomStream, HasTheTailsOfANormalDistribution) {
  const RandomStream stream(3, RandomKind::target_rcs, 5);
  int beyond = 0;
  for (std::int64_t i = 0; i < 500'000; ++i)
    for (const double x : stream.normals(i, 0)) beyond += std::abs(x) > 3.0 ? 1 : 0;
  EXPECT_NEAR(beyond, 2699.8, 5.0 * 51.9);
}

TEST(NameKey, IgnoresCaseAndTellsNamesApart) {
  EXPECT_EQ(name_key("Plane"), name_key("PLANE"));
  EXPECT_NE(name_key("Plane"), name_key("Plane2"));
  EXPECT_NE(name_key("ab"), name_key("ba"));
  // FNV-1a of nothing and of "a", as published.
  EXPECT_EQ(name_key(""), 0xcbf29ce484222325U);
  EXPECT_EQ(name_key("a"), 0xaf63dc4c8601ec8cU);
}

}  // namespace random_test
}  // namespace sarsim::core
