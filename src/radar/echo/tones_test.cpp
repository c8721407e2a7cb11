#include "radar/echo/tones.hpp"

#include <limits>

#include "radar/echo/echo_test_support.hpp"

namespace sarsim::radar {
namespace tones_test {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

// The formula of the header in long double.
std::complex<double> formula(const Tone& tone, std::size_t n) {
  const long double m = static_cast<long double>(n) - tone.centre;
  const long double turns = tone.alpha + m * (tone.beta + m * static_cast<long double>(tone.gamma));
  const long double angle = 2.0L * std::numbers::pi_v<long double> * (turns - std::round(turns));
  return {static_cast<double>(tone.amplitude * std::cos(angle)), static_cast<double>(tone.amplitude * std::sin(angle))};
}

SplitRow empty_row(std::size_t count) {
  SplitRow row;
  row.re.assign(count + SplitRow::padding, 0.0);
  row.im.assign(count + SplitRow::padding, 0.0);
  return row;
}

// The promise: 3e-7 or, with the rounding of the exponent's `turns`, 1e-14, or 1e-11 for a strong bend.
double promise(const Tone& tone, double largest_m, bool single) {
  if (single) return 3e-7;
  const auto length = static_cast<double>(tone.end - tone.begin);
  const double turns = std::abs(tone.alpha) + largest_m * (std::abs(tone.beta) + largest_m * std::abs(tone.gamma));
  return (std::abs(tone.gamma) * length > 1e-5 ? 1e-11 : 1e-14) + 2.0 * core::pi * 3.0 * epsilon * turns;
}

void expect_tone(const Tone& tone, std::size_t count, bool single) {
  SplitRow row = empty_row(count);
  ToneScratch scratch;
  add_tones({&tone, 1}, single, row, scratch);
  for (std::size_t n = 0; n < count; ++n) {
    const std::complex<double> got(row.re[n], row.im[n]);
    if (n < tone.begin || n >= tone.end)
      ASSERT_EQ(got, 0.0) << n;
    else
      ASSERT_LT(std::abs(got - formula(tone, n)),
                promise(tone, static_cast<double>(count), single) * std::abs(tone.amplitude))
          << n << " of [" << tone.begin << ", " << tone.end << ") " << single;
  }
}

TEST(AddTones, OfOneSampleIsAnAccurateCosineAndSine) {
  at_every_simd_level([] {
    for (int k = -4096; k <= 4096; ++k) {
      const Tone tone{5, 6, 5.0, k / 4096.0 * 0.5, 0.0, 0.0, 1.0};
      SplitRow row = empty_row(9);
      ToneScratch scratch;
      add_tones({&tone, 1}, true, row, scratch);
      // k/8192 is exact in float; polynomial 4e-8 and two products.
      ASSERT_LT(std::abs(std::complex(row.re[5], row.im[5]) - formula(tone, 5)), 1.6e-7) << k;
      row = empty_row(9);
      add_tones({&tone, 1}, false, row, scratch);
      ASSERT_LT(std::abs(std::complex(row.re[5], row.im[5]) - formula(tone, 5)), 4.0 * epsilon) << k;
    }
  });
}

TEST(AddTones, FillsSpansOfAnyLengthAndNothingElse) {
  at_every_simd_level([] {
    for (std::size_t length = 1; length <= 70; ++length)
      for (const std::size_t begin : {0u, 1u, 13u, 30u}) {
        const Tone tone{begin, begin + length, 50.0, 0.3, 0.0437, 1e-8, -1.7};
        expect_tone(tone, 100, true);
        expect_tone(tone, 100, false);
      }
  });
}

TEST(AddTones, ReachesBothEndsOfTheRow) {
  at_every_simd_level([] {
    for (const std::size_t count : {1u, 2u, 7u, 8u, 31u, 32u, 33u, 1000u}) {
      const Tone tone{0, count, 3.0, -0.2, -0.31, 0.0, 2.0};
      expect_tone(tone, count, true);
      expect_tone(tone, count, false);
    }
  });
}

TEST(AddTones, KeepsItsPromiseForRandomTones) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  at_every_simd_level([&] {
    for (int round = 0; round < 100; ++round) {
      const auto begin = static_cast<std::size_t>(500.0 + 499.0 * unit(random));
      const auto length = static_cast<std::size_t>(251.0 + 250.0 * unit(random));
      const Tone tone{begin,
                      begin + length,
                      750.0,
                      5.0 * unit(random),
                      0.5 * unit(random),
                      1e-5 * unit(random) / static_cast<double>(length),
                      unit(random)};
      expect_tone(tone, 1500, true);
      expect_tone(tone, 1500, false);
    }
  });
}

// |gamma| length = 1e-4: a chirp as wide as the sampling rate at 30 km/s. Beyond, every vector has its own step.
TEST(AddTones, FollowsAnyBend) {
  at_every_simd_level([] {
    for (const double bend : {-1e-4, -1e-6, 1e-9, 1e-5, 1e-4, 6e-4, -2e-3, 0.3})
      for (const std::size_t length : {100u, 2000u}) {
        const Tone tone{40, 40 + length, 1050.0, 0.1, 0.0123, bend / static_cast<double>(length), 1.0};
        expect_tone(tone, 2100, true);
        expect_tone(tone, 2100, false);
      }
  });
}

TEST(AddTones, AddsManyTonesToWhatIsThere) {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  std::vector<Tone> tones;
  for (int k = 0; k < 3 * 64 + 1; ++k) {
    const auto begin = static_cast<std::size_t>(150.0 + 150.0 * unit(random));
    tones.push_back(
        {begin, begin + 1 + static_cast<std::size_t>(k), 250.0, unit(random), 0.4 * unit(random), 0.0, 1.0});
  }
  at_every_simd_level([&] {
    for (const bool single : {true, false}) {
      SplitRow row = empty_row(500);
      for (double& x : row.re) x = 1000.0;
      for (double& x : row.im) x = -7.0;
      ToneScratch scratch;
      add_tones(tones, single, row, scratch);
      for (std::size_t n = 0; n < 500; ++n) {
        std::complex<double> sum(1000.0, -7.0);
        double on = 0.0;
        for (const Tone& tone : tones)
          if (n >= tone.begin && n < tone.end) sum += formula(tone, n), on += 1.0;
        // A float sum of 64 tones is rounded 64 times, half a unit of at most 64 each.
        const double bound = single ? on * (3e-7 + 64.0 * 6e-8) : on * 2e-13 + 200.0 * 1000.0 * epsilon;
        ASSERT_LE(std::abs(std::complex(row.re[n], row.im[n]) - sum), bound) << n << single;
      }
    }
  });
}

TEST(AddTones, KeepsNothingInItsScratchForTheNextRow) {
  const Tone tone{0, 60, 30.0, 0.1, 0.2, 0.0, 1.0};
  ToneScratch used;
  SplitRow small = empty_row(60);
  add_tones({&tone, 1}, true, small, used);
  add_tones({&tone, 1}, false, small, used);
  for (const bool single : {true, false})
    for (const std::size_t count : {60u, 300u}) {
      const Tone other{2, count, 30.0, 0.3, 0.01, 1e-9, 0.5};
      SplitRow again = empty_row(count), fresh = empty_row(count);
      ToneScratch unused;
      add_tones({&other, 1}, single, again, used);
      add_tones({&other, 1}, single, fresh, unused);
      EXPECT_EQ(again.re, fresh.re);
      EXPECT_EQ(again.im, fresh.im);
    }
}

TEST(AddTones, OfNoTonesLeavesTheRowAlone) {
  SplitRow row = empty_row(10);
  row.re[3] = 4.0;
  const SplitRow before = row;
  ToneScratch scratch;
  for (const bool single : {true, false}) add_tones({}, single, row, scratch);
  EXPECT_EQ(row.re, before.re);
  EXPECT_EQ(row.im, before.im);
}

}  // namespace tones_test
}  // namespace sarsim::radar
