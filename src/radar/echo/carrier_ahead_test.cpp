// Echoes whose carrier is ahead of their delay, as those through an ionosphere: every kernel against the closed form.

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "radar/echo/direct_kernel.hpp"
#include "radar/echo/echo_test_support.hpp"
#include "radar/echo/spectral_kernel.hpp"
#include "radar/echo/strengths.hpp"

namespace sarsim::radar {
namespace carrier_ahead_test {

constexpr double c = core::exact_light_speed_mps;

// One echo as physics has it: the pulse comes by the group path, the carrier's phase is that of the phase path.
struct Echo {
  double group_s = 0.0;
  double phase_s = 0.0;
  double amplitude = 0.0;
  PulseClock clock;
};

struct Case {
  double carrier_hz = 0.0;
  std::vector<Echo> echoes;

  [[nodiscard]] EchoBatch batch() const {
    EchoBatch batch;
    for (const Echo& echo : echoes) {
      if (echo.clock.dilation_rate == 0.0)
        batch.add(echo.group_s, echo.amplitude, echo.clock.doppler);
      else
        batch.add(echo.group_s, echo.amplitude, echo.clock);
      batch.ahead_turns.push_back(carrier_hz * (echo.group_s - echo.phase_s));
    }
    return batch;
  }
};

enum class Flight { at_rest, even, bent };

// Carriers of 0.4 to 10 GHz and 0.1 to 100 TECU, by 40.3 TEC/f^2 on each way.
Case random_case(std::mt19937_64& random, const SampleGrid& grid, int count, Flight flight) {
  std::uniform_real_distribution<double> unit(-1.0, 1.0), share(0.0, 1.0);
  Case drawn;
  drawn.carrier_hz = 0.4e9 * std::pow(25.0, share(random));
  for (int k = 0; k < count; ++k) {
    const double tec_per_m2 = 1e15 * std::pow(1e3, share(random));
    const double late_s = 2.0 * 40.3 * tec_per_m2 / (c * drawn.carrier_hz * drawn.carrier_hz);
    const double position = (static_cast<double>(grid.count) + 60.0) * share(random) - 60.0;
    Echo echo;
    echo.group_s = grid.first_s + position * grid.interval_s;
    echo.phase_s = echo.group_s - 2.0 * late_s;
    echo.amplitude = unit(random);
    if (flight != Flight::at_rest) echo.clock.doppler = 2.0 * 5000.0 / c * unit(random);
    if (flight == Flight::bent) echo.clock.dilation_rate = 30.0 * unit(random);
    drawn.echoes.push_back(echo);
  }
  return drawn;
}

// A p(e + Tp/2) exp(-j 2 pi f tau_phase) exp(-j 2 pi f (D u + a u^2/2)).
ComplexRow closed_form(const EchoPulse& pulse, const SampleGrid& grid, const Case& wanted) {
  ComplexRow row(grid.count);
  const double width_s = pulse.pulse.width_s;
  for (const Echo& echo : wanted.echoes)
    for (std::size_t i = 0; i < grid.count; ++i) {
      const double u = grid.time_s(i) - echo.group_s + pulse.lead_s - 0.5 * width_s;
      const double late = (echo.clock.doppler + 0.5 * echo.clock.dilation_rate * u) * u;
      const double e = u - late;
      std::complex<double> value;
      if (pulse.band_limited)
        value = e + 0.5 * width_s < pulse.band_limited->first_s() || e + 0.5 * width_s >= pulse.band_limited->last_s()
                    ? 0.0
                    : pulse.band_limited->value(e + 0.5 * width_s);
      else if (e >= -0.5 * width_s && e < 0.5 * width_s)
        value = std::polar(1.0, core::pi * pulse.pulse.sweep_hz / width_s * e * e);
      const double turns = std::remainder(wanted.carrier_hz * echo.phase_s, 1.0) + wanted.carrier_hz * late;
      row[i] += echo.amplitude * value * std::polar(1.0, -2.0 * core::pi * turns);
    }
  return row;
}

struct Kind {
  std::string name;
  EchoPulse pulse;
};

std::vector<Kind> kinds() {
  EchoPulse chirp = test_pulse(Pulse::Kind::chirp, 100.3, 0.8);
  chirp.lead_s = 0.5 * chirp.pulse.width_s;
  return {{"hard chirp", chirp},
          {"band-limited chirp", band_limited_test_pulse(60.0, 0.8)},
          {"tone", test_pulse(Pulse::Kind::mono, 80.4)}};
}

using MakeRow = std::function<ComplexRow(const EchoPulse&, const SampleGrid&, double carrier_hz, const EchoBatch&)>;

template <class Kernel>
MakeRow rows_of(double tolerance) {
  return [tolerance](const EchoPulse& pulse, const SampleGrid& grid, double carrier_hz, const EchoBatch& echoes) {
    Kernel kernel(pulse, grid, tolerance);
    return row_of(kernel, grid, carrier_hz, echoes);
  };
}

void expect_closed_form(const MakeRow& make, int count, Flight flight, double max_error) {
  std::mt19937_64 random(7);
  const SampleGrid grid = test_grid(300);
  for (const Kind& kind : kinds())
    for (int draw = 0; draw < 20; ++draw) {
      const Case wanted = random_case(random, grid, count, flight);
      const EchoBatch batch = wanted.batch();
      const double strength = strength_of(kind.pulse, grid, batch);
      if (strength == 0.0) continue;
      EXPECT_LT(relative_error(make(kind.pulse, grid, wanted.carrier_hz, batch), closed_form(kind.pulse, grid, wanted),
                               strength),
                max_error)
          << kind.name << " " << wanted.carrier_hz;
    }
}

class CarrierAhead : public testing::TestWithParam<Flight> {};

INSTANTIATE_TEST_SUITE_P(Flights, CarrierAhead, testing::Values(Flight::at_rest, Flight::even, Flight::bent));

TEST_P(CarrierAhead, OfTheReferenceIsTheClosedForm) { expect_closed_form(reference_row, 5, GetParam(), 1e-8); }

TEST_P(CarrierAhead, OfTheDirectKernelIsTheClosedForm) {
  expect_closed_form(rows_of<DirectKernel>(1e-6), 5, GetParam(), 1e-6);
  expect_closed_form(rows_of<DirectKernel>(1e-9), 5, GetParam(), 1e-8);
}

TEST_P(CarrierAhead, OfTheSpectralKernelIsTheClosedForm) {
  expect_closed_form(rows_of<SpectralKernel>(1e-6), 5, GetParam(), 1e-6);
  expect_closed_form(rows_of<SpectralKernel>(1e-9), 5, GetParam(), 1e-8);
}

// So many echoes that hard-edged pulses are summed by the samples they begin at.
TEST_P(CarrierAhead, OfRowsOfManyEchoesIsTheClosedForm) {
  expect_closed_form(rows_of<SpectralKernel>(1e-6), 600, GetParam(), 1e-6);
}

// Whole vectors and what is left of them, on every instruction set.
TEST(CarrierAheadStrengths, AreTurnedByWhatTheCarrierIsAhead) {
  at_every_simd_level([] {
    for (const int count : {1, 7, 64, 101}) {
      EchoBatch echoes = random_echoes(count, test_grid(1000), 90.0, 500.0);
      const RowFrame frame{9.65e9, 20e-6, test_interval_s, -100.0, 1000.0};
      Strengths<double> plain, ahead;
      gather_strengths(echoes, frame, plain);
      for (int k = 0; k < count; ++k) echoes.ahead_turns.push_back(0.37 * k - 20.0);
      gather_strengths(echoes, frame, ahead);
      ASSERT_EQ(ahead.strength.size(), static_cast<std::size_t>(count));
      for (std::size_t k = 0; k < ahead.strength.size(); ++k) {
        const std::complex<double> turned = plain.strength[k] * std::polar(1.0, 2.0 * core::pi * echoes.ahead_turns[k]);
        EXPECT_LT(std::abs(ahead.strength[k] - turned), 1e-8) << k;
        EXPECT_EQ(ahead.position[k], plain.position[k]);
      }
    }
  });
}

// Zeros are as good as none, to the last bit.
TEST(CarrierAheadStrengths, OfZerosAreThoseWithoutTheColumn) {
  const SampleGrid grid = test_grid(300);
  for (const Kind& kind : kinds()) {
    EchoBatch echoes = random_echoes(40, grid, 60.0, 100.0);
    for (const MakeRow& make : {MakeRow(reference_row), rows_of<DirectKernel>(1e-6), rows_of<DirectKernel>(1e-9),
                                rows_of<SpectralKernel>(1e-6), rows_of<SpectralKernel>(1e-9)}) {
      echoes.ahead_turns.clear();
      const ComplexRow without = make(kind.pulse, grid, 5.4e9, echoes);
      echoes.ahead_turns.resize(echoes.size());
      EXPECT_EQ(make(kind.pulse, grid, 5.4e9, echoes), without) << kind.name;
    }
  }
}

}  // namespace carrier_ahead_test
}  // namespace sarsim::radar
