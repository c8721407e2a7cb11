#include "radar/echo/pulse_body.hpp"

#include "core/maths/fft.hpp"
#include "core/maths/window.hpp"
#include "radar/echo/echo_test_support.hpp"

namespace sarsim::radar {
namespace pulse_body_test {

constexpr std::size_t edge_samples = 8;
constexpr double beta_1e6 = 17.28;  // ln(32/1e-6): of a promise of 1e-6

PulseBody body_of(const EchoPulse& pulse, std::size_t k = edge_samples, double beta = beta_1e6) {
  return {pulse, test_interval_s, k, beta};
}

EchoPulse with_ramps(EchoPulse pulse, double rise_samples, double fall_samples) {
  pulse.pulse.envelope = Pulse::Envelope::linear;
  pulse.pulse.rise_s = rise_samples * test_interval_s;
  pulse.pulse.fall_s = fall_samples * test_interval_s;
  return pulse;
}

EchoPulse with_curve(EchoPulse pulse) {
  pulse.pulse.envelope = Pulse::Envelope::user;
  pulse.pulse.envelope_gain = core::Interpolator({core::Interpolation::cubic, {{0.0, 0.3}, {0.4, 1.0}, {1.0, 0.5}}});
  return pulse;
}

// What is added directly at the edges: the share of each region that the body leaves out.
double edge_share(const PulseBody& body, double t, double width) {
  double share = 0.0;
  for (const PulseBody::Edge& edge : body.edges()) {
    const double x = (t - edge.start) / width;
    if (x >= 0.0 && x < 1.0) share += 1.0 - body.step(edge.rising ? x : 1.0 - x);
  }
  return share;
}

TEST(PulseBody, AndItsEdgesAreThePulseAtAnyTime) {
  std::mt19937 random(6);
  for (const EchoPulse& pulse :
       {test_pulse(Pulse::Kind::chirp, 100.3, 0.8), test_pulse(Pulse::Kind::mono, 17.0),
        test_pulse(Pulse::Kind::code, 300.0), with_ramps(test_pulse(Pulse::Kind::mono, 200.0), 30.0, 50.5)}) {
    const PulseBody body = body_of(pulse);
    ASSERT_TRUE(body.has_body());
    std::uniform_real_distribution<double> time(0.0, body.last());
    for (int i = 0; i < 2000; ++i) {
      const double t = time(random);
      EXPECT_NEAR(body.body_share(t) + edge_share(body, t, edge_samples), 1.0, 1e-15) << t;
      EXPECT_EQ(body.value(t), pulse.pulse.value(t * test_interval_s));
    }
    EXPECT_EQ(body.body_share(-1e-9), 0.0);
    EXPECT_EQ(body.body_share(body.last() + 1e-9), 0.0);
  }
}

TEST(PulseBody, HasNoShareAtAHardEdgeAndAllAwayFromIt) {
  const EchoPulse pulse = test_pulse(Pulse::Kind::chirp, 100.0, 0.8);
  const PulseBody body = body_of(pulse);
  EXPECT_EQ(body.first(), 0.0);
  EXPECT_DOUBLE_EQ(body.last(), 100.0);
  EXPECT_EQ(body.body_share(0.0), 0.0);
  EXPECT_LT(body.body_share(body.last() - 1e-12), 1e-15);
  for (const double t : {8.0, 50.0, 91.9999}) EXPECT_EQ(body.body_share(t), 1.0) << t;
  for (double t = 0.1; t < 8.0; t += 0.37) {  // rises, and falls as its mirror image
    EXPECT_GT(body.body_share(t), body.body_share(t - 0.1));
    EXPECT_NEAR(body.body_share(t), body.body_share(100.0 - t), 1e-12);
  }
}

// The integral of Kaiser's window by the trapezium rule, which converges fast for it.
TEST(PulseBody, StepIsTheIntegralOfKaisersWindow) {
  const EchoPulse pulse = test_pulse(Pulse::Kind::mono, 100.0);
  const PulseBody body = body_of(pulse);
  const auto integral = [](double to) {
    constexpr int steps = 20000;
    double sum = 0.0;
    for (int i = 0; i <= steps; ++i)
      sum += (i == 0 || i == steps ? 0.5 : 1.0) * core::kaiser_window(2.0 * to * i / steps - 1.0, beta_1e6);
    return sum * to / steps;
  };
  for (const double x : {0.01, 0.2, 0.33333, 0.5, 0.7654321, 0.99})
    EXPECT_NEAR(body.step(x), integral(x) / integral(1.0), 1e-8 * x + 1e-12) << x;
  EXPECT_EQ(body.step(-0.1), 0.0);
  EXPECT_EQ(body.step(1.1), 1.0);
}

TEST(PulseBody, OfABarkerCodeHasTwoEdgesPerChip) {
  const EchoPulse pulse = test_pulse(Pulse::Kind::code, 260.0);  // 13 chips of 20
  const PulseBody body = body_of(pulse);
  ASSERT_EQ(body.edges().size(), 26u);
  for (std::size_t chip = 0; chip < 13; ++chip) {
    EXPECT_TRUE(body.edges()[2 * chip].rising);
    EXPECT_NEAR(body.edges()[2 * chip].start, 20.0 * static_cast<double>(chip), 1e-10);
    EXPECT_FALSE(body.edges()[2 * chip + 1].rising);
    EXPECT_NEAR(body.edges()[2 * chip + 1].start, 20.0 * static_cast<double>(chip) + 12.0, 1e-10);
  }
}

TEST(PulseBody, HasEdgesAtTheKinksOfAnEnvelope) {
  const EchoPulse ramps = with_ramps(test_pulse(Pulse::Kind::chirp, 200.0, 0.5), 40.0, 50.0);
  const PulseBody body = body_of(ramps);
  std::vector<double> starts;
  for (const PulseBody::Edge& edge : body.edges()) starts.push_back(edge.start);
  const std::vector<double> expected{0.0, 32.0, 40.0, 142.0, 150.0, 192.0};
  ASSERT_EQ(starts.size(), expected.size());
  for (std::size_t i = 0; i < starts.size(); ++i) EXPECT_NEAR(starts[i], expected[i], 1e-10);
  const EchoPulse curve = with_curve(test_pulse(Pulse::Kind::mono, 100.0));
  EXPECT_EQ(body_of(curve).edges().size(), 4u);
}

TEST(PulseBody, IsMissingWhereEdgesLeaveNoRoom) {
  EXPECT_FALSE(body_of(test_pulse(Pulse::Kind::mono, 15.9)).has_body());
  EXPECT_TRUE(body_of(test_pulse(Pulse::Kind::mono, 16.1)).has_body());
  EXPECT_FALSE(body_of(test_pulse(Pulse::Kind::code, 200.0)).has_body());  // chips of 15.4 samples
  EXPECT_TRUE(body_of(test_pulse(Pulse::Kind::code, 210.0)).has_body());
  EXPECT_FALSE(body_of(with_ramps(test_pulse(Pulse::Kind::mono, 200.0), 10.0, 50.0)).has_body());
}

TEST(PulseBody, OfABandLimitedPulseIsAllOfItUnlessItIsCut) {
  const EchoPulse smooth = band_limited_test_pulse(60.0, 0.8);
  const PulseBody whole = body_of(smooth);
  EXPECT_TRUE(whole.edges().empty());
  EXPECT_TRUE(whole.has_body());
  EXPECT_LT(whole.first(), 0.0);
  for (const double t : {whole.first(), 0.0, 33.3, whole.last() - 1e-9}) EXPECT_EQ(whole.body_share(t), 1.0);
  EchoPulse cut = smooth;
  cut.band_limited.emplace(cut.pulse, 0.5 / test_interval_s, 1.0 / test_interval_s, 70.0 * test_interval_s);
  const PulseBody kept = body_of(cut);
  ASSERT_EQ(kept.edges().size(), 2u);
  EXPECT_NEAR(kept.first(), -5.0, 1e-9);
  EXPECT_NEAR(kept.edges()[1].start, 65.0 - 8.0, 1e-9);
  EXPECT_EQ(kept.body_share(kept.last()), 0.0);
}

TEST(PulseBody, DopplerPhaseIsThatOfTheCarrierAndTheSweepFromTheMiddleOn) {
  const EchoPulse pulse = test_pulse(Pulse::Kind::chirp, 100.0, 0.8);
  const PulseBody body = body_of(pulse);
  EXPECT_NEAR(body.doppler_turns(50.0, 3e9), 0.0, 1e-9);
  // u = 10 samples = 0.1 us: 300 cycles of carrier and 8e13 Hz/s u^2/2 = 0.4.
  EXPECT_NEAR(body.doppler_turns(60.0, 3e9), 300.4, 1e-9);
  EXPECT_NEAR(body.doppler_turns(40.0, 3e9), -299.6, 1e-9);
}

// Energy of the body's spectrum beyond half_band() over the pulse's, from samples 16 times as dense.
double energy_beyond(const PulseBody& body) {
  constexpr int dense = 16;
  const auto first = static_cast<std::ptrdiff_t>(std::ceil(body.first() * dense));
  const auto last = static_cast<std::ptrdiff_t>(std::floor(body.last() * dense));
  const std::size_t size = core::good_fft_size(static_cast<std::size_t>(2 * (last - first)));
  std::vector<std::complex<double>> x(size);
  for (std::ptrdiff_t i = first; i <= last; ++i) {
    const double t = static_cast<double>(i) / dense;
    x[static_cast<std::size_t>(i - first)] = body.body_share(t) == 0.0 ? 0.0 : body.body_share(t) * body.value(t);
  }
  core::Fft(size).forward(x);
  double beyond = 0.0, all = 0.0;
  for (std::size_t k = 0; k < size; ++k) {
    const auto bin = static_cast<double>(k);
    const auto bins = static_cast<double>(size);
    const double cycles = dense * std::min(bin, bins - bin) / bins;
    all += std::norm(x[k]);
    if (cycles > body.half_band()) beyond += std::norm(x[k]);
  }
  return std::sqrt(beyond / all);
}

// A user-defined pulse that is nearly all constant, with a weak ripple as fast as its knots.
EchoPulse rippled() {
  EchoPulse pulse = test_pulse(Pulse::Kind::user, 600.0);
  core::SampledFunction f{core::Interpolation::cubic, {}};
  for (int i = 0; i <= 20; ++i) f.knots.push_back({i / 20.0, 1.0 + (i % 2 == 0 ? 0.04 : -0.04)});
  pulse.pulse.in_phase = core::Interpolator(f);
  pulse.pulse.quadrature =
      core::Interpolator(core::SampledFunction{core::Interpolation::linear, {{0.0, 0.0}, {1.0, 0.2}}});
  return pulse;
}

TEST(PulseBody, SpectrumIsNegligibleBeyondItsBand) {
  const EchoPulse pulses[] = {test_pulse(Pulse::Kind::mono, 50.0),
                              test_pulse(Pulse::Kind::chirp, 100.0, 0.9),
                              test_pulse(Pulse::Kind::chirp, 400.0, -1.3),
                              test_pulse(Pulse::Kind::code, 390.0),
                              with_ramps(test_pulse(Pulse::Kind::chirp, 200.0, 0.5), 40.0, 50.0),
                              with_curve(test_pulse(Pulse::Kind::chirp, 150.0, 0.7)),
                              rippled(),
                              band_limited_test_pulse(60.0, 1.0)};
  for (const double tolerance : {1e-3, 1e-6, 1e-9})
    for (const EchoPulse& pulse : pulses) {
      const PulseBody body(pulse, test_interval_s, tolerance < 1e-6 ? 12 : 8, std::log(32.0 / tolerance));
      ASSERT_TRUE(body.has_body());
      EXPECT_LT(energy_beyond(body), tolerance) << static_cast<int>(pulse.pulse.kind) << ' ' << tolerance;
    }
}

}  // namespace pulse_body_test
}  // namespace sarsim::radar
