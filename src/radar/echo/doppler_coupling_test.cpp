#include "radar/echo/doppler_coupling.hpp"

#include <cmath>
#include <complex>
#include <limits>

#include <gtest/gtest.h>

#include "radar/echo/doppler_terms.hpp"
#include "radar/echo/echo_test_support.hpp"

namespace sarsim::radar {
namespace doppler_coupling_test {

constexpr double carrier_hz = 5.3e9;
constexpr double interval_s = 1.0 / 120e6;

// 100 MHz sampled at 120 MHz.
EchoPulse chirp(double samples) {
  EchoPulse pulse = test_pulse(Pulse::Kind::chirp, samples, 1.0);
  pulse.pulse.width_s = samples * interval_s;
  pulse.pulse.sweep_hz = 100e6;
  return pulse;
}

PulseBody body_of(const EchoPulse& pulse) { return {pulse, interval_s, 8, std::log(4.0 / 1.25e-7)}; }

// What is missed between Chebyshev nodes of D, root mean square over that of the body, for echoes that are taken where
// the coupling takes them.
double missed(const PulseBody& body, const DopplerCoupling& coupling, double half, std::size_t terms, double x) {
  double power = 0.0, error = 0.0;
  for (double t = body.first() - 2.0; t < body.last() + 2.0; t += 0.25) {
    const auto at = [&](double d) { return body.echo(t + coupling.shift_s * d / interval_s, {d, 0.0}, carrier_hz); };
    std::complex<double> sum;
    for (std::size_t r = 0; r < terms; ++r) {
      double weight = 1.0;
      for (std::size_t s = 0; s < terms; ++s)
        if (s != r) weight *= (x - doppler_node(s, terms)) / (doppler_node(r, terms) - doppler_node(s, terms));
      sum += weight * at(half * doppler_node(r, terms));
    }
    power += std::norm(at(half * x));
    error += std::norm(sum - at(half * x));
  }
  return std::sqrt(error / power);
}

TEST(DopplerCoupling, ShiftsAChirpByItsCarrierOverItsRate) {
  const EchoPulse pulse = chirp(1000.0);
  const PulseBody body = body_of(pulse);
  const DopplerCoupling coupling = coupling_of(pulse, body, interval_s, carrier_hz);
  EXPECT_DOUBLE_EQ(coupling.shift_s, carrier_hz / (100e6 / (1000.0 * interval_s)));
  // Half the carrier's phase over the pulse is 138 000 rad for a unit of D; a hundredth of that is left.
  EXPECT_LT(coupling.change, 0.02 * no_coupling(body, carrier_hz).change);
}

// Steps of a quarter of a sample through 1e25 samples would not even move.
TEST(DopplerCoupling, OfAPulseBeyondAllBoundsIsFoundAtOnce) {
  const EchoPulse pulse = chirp(1e25);
  EXPECT_EQ(coupling_of(pulse, body_of(pulse), interval_s, carrier_hz).shift_s, 0.0);
}

TEST(DopplerCoupling, IsNoneWithoutASweep) {
  EchoPulse pulse = test_pulse(Pulse::Kind::mono, 200.0);
  pulse.pulse.width_s = 200.0 * interval_s;
  const DopplerCoupling coupling = coupling_of(pulse, body_of(pulse), interval_s, carrier_hz);
  EXPECT_EQ(coupling.shift_s, 0.0);
  EXPECT_EQ(coupling.change, largest_doppler_rad(body_of(pulse), carrier_hz));
}

TEST(DopplerCoupling, BoundsWhatItsTermsMiss) {
  for (const double samples : {400.0, 1000.0, 4000.0}) {
    const EchoPulse pulse = chirp(samples);
    const PulseBody body = body_of(pulse);
    const DopplerCoupling coupling = coupling_of(pulse, body, interval_s, carrier_hz);
    for (const double half : {3e-8, 1.2e-7, 5e-7})
      for (std::size_t terms = 1; terms <= 3; ++terms)
        for (const double x : {-1.0, -0.4, 0.0, 0.7, 1.0})
          EXPECT_LE(missed(body, coupling, half, terms, x), 1.01 * coupling.remainder(terms, half) + 1e-11)
              << samples << ' ' << half << ' ' << terms << ' ' << x;
  }
}

TEST(DopplerCoupling, KnowsTheWidestSpanOfItsTerms) {
  const EchoPulse pulse = chirp(1000.0);
  const PulseBody body = body_of(pulse);
  for (const DopplerCoupling& coupling :
       {coupling_of(pulse, body, interval_s, carrier_hz), no_coupling(body, carrier_hz)})
    for (const double error : {1e-9, 1e-6, 1e-3})
      for (std::size_t terms = 1; terms <= 5; ++terms)
        EXPECT_NEAR(coupling.remainder(terms, coupling.widest(terms, 1.0, error)), error, 1e-9 * error) << terms;
  // A shift of a sample comes first.
  const DopplerCoupling coupled = coupling_of(pulse, body, interval_s, carrier_hz);
  EXPECT_DOUBLE_EQ(coupled.widest(20, interval_s, 1e-3), interval_s / coupled.shift_s);
  const DopplerCoupling nothing_changes{};
  EXPECT_EQ(nothing_changes.widest(1, interval_s, 1e-6), std::numeric_limits<double>::infinity());
  EXPECT_EQ(nothing_changes.widest(2, interval_s, 1e-6), std::numeric_limits<double>::infinity());
}

// An aircraft looks at targets within 2.3 degrees: two terms, three without the shift.
TEST(DopplerCoupling, OfAnAircraftTakesTwoTerms) {
  const EchoPulse pulse = chirp(1000.0);
  const PulseBody body = body_of(pulse);
  const DopplerCoupling coupling = coupling_of(pulse, body, interval_s, carrier_hz);
  EXPECT_EQ(coupling.terms_for(6e-8, 1.25e-7), 2U);
  EXPECT_EQ(no_coupling(body, carrier_hz).terms_for(6e-8, 1.25e-7), 3U);
  EXPECT_EQ(best_coupling(coupling, body, carrier_hz, 6e-8, interval_s, 1.25e-7).shift_s, coupling.shift_s);
  // Ten samples would move the ends too far.
  EXPECT_EQ(best_coupling(coupling, body, carrier_hz, 2e-4, interval_s, 1.25e-7).shift_s, 0.0);
}

}  // namespace doppler_coupling_test
}  // namespace sarsim::radar
