#include "radar/echo/pulse_pieces.hpp"

#include "radar/echo/echo_test_support.hpp"

namespace sarsim::radar {
namespace pulse_pieces_test {

Pulse user_pulse(double samples, const core::Interpolator& in_phase, const core::Interpolator& quadrature) {
  Pulse pulse = test_pulse(Pulse::Kind::user, samples).pulse;
  pulse.in_phase = in_phase;
  pulse.quadrature = quadrature;
  return pulse;
}

core::Interpolator wiggle(core::Interpolation method, int knots, core::LowPassRule rule = core::LowPassRule::first_knot,
                          double bunched = 0.0) {
  core::SampledFunction f;
  f.method = method;
  for (int i = 0; i < knots; ++i) {
    const double x = static_cast<double>(i) / (knots - 1);
    f.knots.push_back({x + bunched * x * (1.0 - x), std::sin(40.0 * x * x) + 0.3 * (i % 3)});
  }
  return core::Interpolator(f, rule);
}

// Largest difference to the pulse at random times, over its largest magnitude; sharp places apart.
double worst_error(const PulsePieces& pieces, const Pulse& pulse) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> position(0.0, pieces.width());
  double worst = 0.0;
  for (int i = 0; i < 20'000; ++i) {
    const double p = position(random);
    const std::size_t piece = pieces.piece_at(p);
    if (pieces.is_in_doubt(piece, p)) continue;
    worst = std::max(worst, std::abs(pieces.value(piece, p) - pulse.value(p * test_interval_s)));
  }
  return worst / pieces.largest();
}

TEST(PulsePieces, AreTheCurvesOfEveryInterpolation) {
  for (const int knots : {2, 3, 10, 50}) {
    const core::Interpolator linear = wiggle(core::Interpolation::linear, knots);
    for (const core::Interpolator& other :
         {linear, wiggle(core::Interpolation::cubic, knots + 1), wiggle(core::Interpolation::low_pass, knots),
          wiggle(core::Interpolation::low_pass, knots, core::LowPassRule::origin),
          wiggle(core::Interpolation::low_pass, knots, core::LowPassRule::first_knot, 0.7),
          wiggle(core::Interpolation::low_pass, knots, core::LowPassRule::origin, -0.7)}) {
      const Pulse pulse = user_pulse(77.7, linear, other);
      const PulsePieces pieces(pulse, test_interval_s);
      EXPECT_LT(worst_error(pieces, pulse), 2e-12) << knots;
      EXPECT_LT(pieces.size(), 60u * static_cast<std::size_t>(knots));
    }
  }
}

TEST(PulsePieces, OfLinearCurvesEndAtTheKnots) {
  const core::Interpolator i({core::Interpolation::linear, {{0.0, 1.0}, {0.25, 2.0}, {1.0, 0.0}}});
  const core::Interpolator q({core::Interpolation::linear, {{0.0, 1.0}, {0.5, 2.0}, {1.0, 0.0}}});
  const Pulse pulse = user_pulse(100.0, i, q);
  const PulsePieces pieces(pulse, test_interval_s);
  ASSERT_EQ(pieces.size(), 3u);
  for (const auto& [k, border] :
       std::vector<std::pair<std::size_t, double>>{{0, 0.0}, {1, 25.0}, {2, 50.0}, {3, 100.0}}) {
    EXPECT_NEAR(pieces.border(k), border, 1e-12);
    EXPECT_FALSE(pieces.is_sharp(k));
  }
}

TEST(PulsePieces, OfARampedChirpAreTheRampsWithoutTheSweep) {
  Pulse pulse = test_pulse(Pulse::Kind::chirp, 50.0, 0.7).pulse;
  pulse.envelope = Pulse::Envelope::linear;
  pulse.rise_s = pulse.fall_s = 10.0 * test_interval_s;
  const PulsePieces pieces(pulse, test_interval_s);
  EXPECT_FALSE(pieces.is_complex());
  ASSERT_EQ(pieces.size(), 3u);
  for (const auto& [p, gain] : std::vector<std::pair<double, double>>{{0.0, 0.0}, {4.0, 0.4}, {20.0, 1.0}, {47.0, 0.3}})
    EXPECT_NEAR(std::abs(pieces.value(pieces.piece_at(p), p) - gain), 0.0, 1e-13) << p;
}

TEST(PulsePieces, OfOverlappingRampsMeetBelowOne) {
  Pulse pulse = test_pulse(Pulse::Kind::mono, 60.0).pulse;
  pulse.envelope = Pulse::Envelope::linear;
  pulse.rise_s = 60.0 * test_interval_s;
  pulse.fall_s = 30.0 * test_interval_s;
  const PulsePieces pieces(pulse, test_interval_s);
  EXPECT_NEAR(pieces.border(pieces.piece_at(40.0 + 1e-9)), 40.0, 1e-12);
  EXPECT_NEAR(pieces.largest(), 2.0 / 3.0, 0.01);
}

// 21 terms of a bare sinc, counted from 0: 0.5, 1.5 ... steps.
TEST(PulsePieces, OfTheClassicLowPassRuleAreSharpBetweenGridPoints) {
  const core::Interpolator curve = wiggle(core::Interpolation::low_pass, 41, core::LowPassRule::origin);
  const Pulse pulse = user_pulse(80.0, curve, core::Interpolator());
  const PulsePieces pieces(pulse, test_interval_s);
  int sharp = 0;
  for (std::size_t k = 1; k < pieces.size(); ++k)
    if (pieces.is_sharp(k)) {
      ++sharp;
      const double steps = pieces.border(k) / 2.0;
      EXPECT_NEAR(steps - std::floor(steps), 0.5, 1e-9);
      EXPECT_TRUE(pieces.is_in_doubt(k, pieces.border(k)));
      EXPECT_TRUE(pieces.is_in_doubt(k - 1, pieces.border(k) - 1e-10));
      EXPECT_FALSE(pieces.is_in_doubt(k, pieces.border(k) + 1e-7));
    }
  // Within 10.5 steps of both ends all grid points are among the terms; a jump by a grid point of 0 is none.
  EXPECT_GT(sharp, 20);
}

TEST(PulsePieces, LeaveStepsBetweenKnotsThatAlmostCoincideToThePulse) {
  const core::Interpolator i({core::Interpolation::linear, {{0.0, 1.0}, {0.5, 1.0}, {0.5 + 1e-13, -1.0}, {1.0, -1.0}}});
  const Pulse pulse = user_pulse(10.0, i, core::Interpolator());
  const PulsePieces pieces(pulse, test_interval_s);
  ASSERT_EQ(pieces.size(), 3u);
  EXPECT_TRUE(pieces.is_only_exact(1));
  EXPECT_TRUE(pieces.is_sharp(1));
  EXPECT_TRUE(pieces.is_sharp(2));
  EXPECT_FALSE(pieces.is_only_exact(0));
}

TEST(PulsePieces, AreFoundByPositionWithinARangeOfPieces) {
  const core::Interpolator i = wiggle(core::Interpolation::linear, 31);
  const Pulse pulse = user_pulse(30.0, i, i);
  const PulsePieces pieces(pulse, test_interval_s);
  ASSERT_EQ(pieces.size(), 30u);
  EXPECT_EQ(pieces.piece_at(-1.0), 0u);
  EXPECT_EQ(pieces.piece_at(99.0), 29u);
  for (std::size_t k = 0; k < 30; ++k) {
    const double middle = static_cast<double>(k) + 0.5;
    EXPECT_EQ(pieces.piece_at(middle), k);
    EXPECT_EQ(pieces.piece_at(middle, k, k + 1), k);
    EXPECT_EQ(pieces.piece_at(middle, k > 3 ? k - 3 : 0, std::min<std::size_t>(k + 3, 30)), k);
  }
  EXPECT_EQ(pieces.piece_at(20.5, 3, 7), 6u);
  EXPECT_EQ(pieces.piece_at(0.5, 3, 20), 3u);
}

TEST(PulsePieces, OfAPulseWithoutKnotsAreZero) {
  const Pulse pulse = user_pulse(10.0, core::Interpolator(), core::Interpolator());
  const PulsePieces pieces(pulse, test_interval_s);
  EXPECT_EQ(pieces.largest(), 0.0);
  EXPECT_EQ(pieces.value(0, 3.0), 0.0);
}

}  // namespace pulse_pieces_test
}  // namespace sarsim::radar
