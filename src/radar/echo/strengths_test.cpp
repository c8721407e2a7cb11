#include "radar/echo/strengths.hpp"

#include <algorithm>
#include <limits>

#include "radar/echo/echo_test_support.hpp"

namespace sarsim::radar {
namespace strengths_test {

constexpr double epsilon = std::numeric_limits<double>::epsilon();
template <class Real>
constexpr double rounding_of = static_cast<double>(std::numeric_limits<Real>::epsilon());

RowFrame frame_of(double carrier_hz) { return {carrier_hz, 20e-6, 1e-8, -100.0, 1000.0}; }

template <class Real>
class GatherStrengths : public testing::Test {};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(GatherStrengths, Precisions);

// 20 million wavelengths and an eighth: the echo lags by 40 million cycles and a quarter.
TYPED_TEST(GatherStrengths, KeepsThePhaseOfATargetTwentyMillionWavelengthsAway) {
  at_every_simd_level([] {
    constexpr double carrier_hz = 1e10;
    EchoBatch echoes;
    echoes.add((40e6 + 0.25) / carrier_hz, 3.0, 0.0);
    RowFrame frame = frame_of(carrier_hz);
    frame.origin_s = echoes.delay_s[0] - 17e-8;
    Strengths<TypeParam> out;
    gather_strengths(echoes, frame, out);
    ASSERT_EQ(out.strength.size(), 1u);
    const double bound = 3.0 * (2.0 * core::pi * 4e7 * 2.0 * epsilon + rounding_of<TypeParam>);
    EXPECT_LT(std::abs(std::complex<double>(out.strength[0]) - std::complex(0.0, -3.0)), bound);
    EXPECT_NEAR(out.position[0], 17.0, 4e-3 / 1e-8 * 3.0 * epsilon);
    EXPECT_FALSE(out.motion.moving());
  });
}

TYPED_TEST(GatherStrengths, AgreesWithTheFormulaForAnyNumberOfEchoes) {
  at_every_simd_level([] {
    for (int count = 0; count <= 17; ++count) {
      const EchoBatch echoes = random_echoes(count, test_grid(1000), 90.0, 500.0, static_cast<unsigned>(count));
      Strengths<TypeParam> out;
      gather_strengths(echoes, frame_of(3e9), out);
      ASSERT_EQ(out.position.size(), static_cast<std::size_t>(count));
      ASSERT_EQ(out.strength.size(), out.position.size());
      ASSERT_EQ(out.doppler.size(), out.position.size());
      EXPECT_EQ(out.motion.moving(), count > 0);
      for (std::size_t k = 0; k < out.position.size(); ++k) {
        const long double cycles = 3e9L * echoes.delay_s[k];
        const auto angle = static_cast<double>(-2.0L * std::numbers::pi_v<long double> * (cycles - std::round(cycles)));
        const std::complex<double> expected = echoes.amplitude_sqrt_w[k] * std::polar(1.0, angle);
        EXPECT_LT(std::abs(std::complex<double>(out.strength[k]) - expected),
                  2.0 * core::pi * 9e4 * epsilon + rounding_of<TypeParam>);
        // A delay of 30 us in steps of 10 ns: 3000 and a few roundings.
        EXPECT_NEAR(out.position[k], (echoes.delay_s[k] - 20e-6) / 1e-8, 3000.0 * 4.0 * epsilon);
        EXPECT_EQ(out.doppler[k], echoes.doppler[k]);
      }
    }
  });
}

// Echo k has amplitude k + 1, so that it is known again; echoes a tenth of a sample apart.
TYPED_TEST(GatherStrengths, OfTheSameSamplesAreTakenFromDistantPartsInTurn) {
  at_every_simd_level([] {
    constexpr std::size_t count = 5003;
    EchoBatch echoes;
    for (std::size_t k = 0; k < count; ++k)
      echoes.add(20e-6 + 1e-9 * static_cast<double>(k), static_cast<double>(k + 1), 1e-9 * static_cast<double>(k));
    Strengths<TypeParam> out;
    gather_strengths(echoes, frame_of(1e9), out);
    part_neighbours(out);
    ASSERT_EQ(out.position.size(), count);
    std::vector<bool> met(count, false);
    std::size_t far = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const auto k = static_cast<std::size_t>(std::lround(std::abs(out.strength[i]))) - 1;
      ASSERT_LT(k, count);
      met[k] = true;
      EXPECT_NEAR(out.position[i], 0.1 * static_cast<double>(k), 1e-6);
      EXPECT_EQ(out.doppler[i], echoes.doppler[k]);
      if (i > 0 && std::abs(out.position[i] - out.position[i - 1]) > 8.0) ++far;
    }
    EXPECT_TRUE(std::ranges::all_of(met, [](bool m) { return m; }));
    EXPECT_GT(far, count * 9 / 10);
  });
}

TYPED_TEST(GatherStrengths, DropsEchoesThatDoNotTouchTheRowAndKeepsTheOrder) {
  at_every_simd_level([] {
    EchoBatch echoes;
    for (int k = 0; k < 50; ++k) {
      echoes.add(20e-6 + (10.0 * k + 0.5) * 1e-8, k, 0.0);
      echoes.add(20e-6 - (100.5 + k) * 1e-8, -1.0, 77.0);   // ends before the row
      echoes.add(20e-6 + (1000.5 + k) * 1e-8, -1.0, -3.0);  // begins behind it
    }
    Strengths<TypeParam> out;
    gather_strengths(echoes, frame_of(0.0), out);
    ASSERT_EQ(out.position.size(), 50u);
    for (std::size_t k = 0; k < 50; ++k) EXPECT_EQ(out.strength[k], std::complex<TypeParam>(static_cast<TypeParam>(k)));
    EXPECT_FALSE(out.motion.moving());  // what moves is outside
  });
}

TYPED_TEST(GatherStrengths, MovesWhereOneOfTheEchoesMoves) {
  EchoBatch echoes;
  for (int k = 0; k < 9; ++k) echoes.add(20e-6 + 1e-8 * k, 1.0, k == 8 ? -1e-3 : 0.0);
  Strengths<TypeParam> out;
  gather_strengths(echoes, frame_of(1e9), out);
  EXPECT_TRUE(out.motion.moving());
  gather_strengths(EchoBatch{}, frame_of(1e9), out);
  EXPECT_FALSE(out.motion.moving());
  EXPECT_TRUE(out.position.empty());
}

// Chebyshev interpolation is exact for polynomials of D below the number of terms, D's own span included.
TYPED_TEST(GatherStrengths, WeightsInterpolatePolynomialsOfTheDoppler) {
  at_every_simd_level([] {
    for (const std::size_t terms : {1u, 2u, 3u, 5u, 12u, 24u}) {
      const DopplerSpan span{3e-6, 2e-6};
      Strengths<TypeParam> echoes;
      for (int k = 0; k < 37; ++k) {
        echoes.position.push_back(k);
        echoes.strength.push_back({TypeParam(1 + k), TypeParam(-2)});
        echoes.doppler.push_back(span.middle + span.half * std::cos(0.7 * k));
      }
      std::vector<std::complex<TypeParam>> weighted(terms * 37);
      weigh_strengths<TypeParam>(echoes.strength, echoes.doppler, span, terms, weighted);
      for (std::size_t power = 0; power < terms; ++power)
        for (std::size_t k = 0; k < 37; ++k) {
          std::complex<double> sum = 0.0;
          for (std::size_t r = 0; r < terms; ++r)
            sum += std::complex<double>(weighted[r * 37 + k]) *
                   std::pow(doppler_node(r, terms), static_cast<double>(power));
          const double x = (echoes.doppler[k] - span.middle) / span.half;
          const std::complex<double> expected =
              std::complex<double>(echoes.strength[k]) * std::pow(x, static_cast<double>(power));
          // The sum of the weights' magnitudes (Lebesgue's constant) is below 3 for up to 24 nodes; x, rounded once
          // or twice, has a slope of up to the power.
          EXPECT_LT(std::abs(sum - expected), 3.0 * 40.0 * static_cast<double>(4 + 2 * terms) *
                                                  static_cast<double>(std::numeric_limits<TypeParam>::epsilon()))
              << terms << ' ' << power;
        }
    }
  });
}

}  // namespace strengths_test
}  // namespace sarsim::radar
