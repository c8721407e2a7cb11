#include "radar/echo/shape_table.hpp"

#include "radar/echo/echo_test_support.hpp"

namespace sarsim::radar {
namespace shape_table_test {

EchoPulse ramped(double samples, double rise, double fall) {
  EchoPulse pulse = test_pulse(Pulse::Kind::mono, samples);
  pulse.pulse.envelope = Pulse::Envelope::linear;
  pulse.pulse.rise_s = rise * test_interval_s;
  pulse.pulse.fall_s = fall * test_interval_s;
  return pulse;
}

EchoBatch one_echo(double delay_s, const PulseClock& clock = {}) {
  EchoBatch echoes;
  echoes.add(delay_s, 1.0, clock);
  return echoes;
}

// Values of the samples of one echo as the kernels read them: table, then patches.
template <class T>
std::vector<std::complex<double>> values(const ShapeTable& table, const ShapePlace& place) {
  constexpr std::size_t block = ShapeTable::cells_per_block;
  const std::size_t first = place.cell / block * block;
  std::vector<T> re(place.cell + place.count - first), im(re.size());
  for (std::size_t i = 0; i < re.size(); ++i) {
    const auto* c = table.coefficients<T>(place.part, first + i);
    double x = 0.0;
    double y = 0.0;
    for (std::size_t d = table.degree() + 1; d-- > 0;) {
      const double at = place.y + place.y_step * (static_cast<double>(first + i) - static_cast<double>(place.cell));
      x = x * at + static_cast<double>(c[d].value[i % block]);
      if (table.is_complex()) y = y * at + static_cast<double>(c[table.degree() + 1 + d].value[i % block]);
    }
    re[i] = static_cast<T>(x);
    im[i] = static_cast<T>(y);
  }
  table.patch(place, first, re.data(), im.data());
  std::vector<std::complex<double>> result;
  for (std::size_t i = place.cell - first; i < re.size(); ++i)
    result.emplace_back(static_cast<double>(re[i]), static_cast<double>(im[i]));
  return result;
}

void expect_samples_of_the_reference(const EchoPulse& pulse, double promise, bool single_precision) {
  const SampleGrid grid = test_grid(60);
  const ShapeTable table(pulse, grid, single_precision);
  ASSERT_TRUE(table.is_usable());
  std::mt19937 random(2);
  std::uniform_real_distribution<double> position(-40.0, 70.0);
  for (int i = 0; i < 300; ++i) {
    const double delay_s = grid.first_s + (i % 3 == 0 ? std::round(position(random)) : position(random)) * 1e-8;
    // Stretched by half a sample and more over the pulse, every other time.
    const PulseClock clock{i % 2 == 0 ? 0.0 : 0.02, i % 4 == 3 ? 1e4 : 0.0};
    const SampleSpan on = touched_samples(pulse, grid, delay_s, clock);
    if (on.begin >= on.end) continue;
    const ComplexRow expected = reference_row(pulse, grid, 0.0, one_echo(delay_s, clock));
    for (std::size_t first = on.begin; first < on.end;) {
      const ShapePlace place = table.place({first, on.end}, delay_s, clock);
      ASSERT_GT(place.count, 0u);
      const auto got = single_precision ? values<float>(table, place) : values<double>(table, place);
      for (std::size_t n = first; n < first + place.count; ++n)
        ASSERT_LT(std::abs(got[n - first] - expected[n]), promise) << n << ' ' << delay_s << ' ' << single_precision;
      first += place.count;
    }
  }
}

// Times of 20 us are rounded to 3e-21 s, 3e-13 intervals, at slopes of up to 3 per interval.
TEST(ShapeTable, HasTheSamplesOfAnEcho) {
  EchoPulse user = test_pulse(Pulse::Kind::user, 33.3);
  user.pulse.in_phase = core::Interpolator({core::Interpolation::cubic, {{0.0, 0.3}, {0.4, 1.0}, {1.0, -0.5}}});
  user.pulse.quadrature =
      core::Interpolator({core::Interpolation::linear, {{0.0, 1.0}, {0.45, -1.0}, {0.55, 1.0}, {1.0, 0.0}}});
  EchoPulse cut = test_pulse(Pulse::Kind::chirp, 30.0, 0.7);
  cut.lead_s = 15e-8;
  cut.band_limited.emplace(cut.pulse, 0.5e8, 1e8, 17.3e-8);
  for (const EchoPulse& pulse : {ramped(40.5, 7.3, 8.0), user, band_limited_test_pulse(20.0, 0.6), cut}) {
    expect_samples_of_the_reference(pulse, 2.5e-7, true);
    expect_samples_of_the_reference(pulse, 1e-11, false);
  }
}

TEST(ShapeTable, OfRampsIsLinearAndReal) {
  const ShapeTable table(ramped(40.0, 10.0, 10.0), test_grid(60), true);
  EXPECT_FALSE(table.is_complex());
  EXPECT_EQ(table.degree(), 1u);
  EXPECT_EQ(table.parts(), 1u);
}

TEST(ShapeTable, OfABandLimitedPulseHasFewTerms) {
  const EchoPulse pulse = band_limited_test_pulse(100.0, 0.8);
  EXPECT_LE(ShapeTable(pulse, test_grid(60), true).degree(), 7u);
  EXPECT_LE(ShapeTable(pulse, test_grid(60), false).degree(), 11u);
}

TEST(ShapeTable, OfAnOverwideBandHasMoreParts) {
  EchoPulse pulse = test_pulse(Pulse::Kind::mono, 20.0);
  pulse.band_limited.emplace(pulse.pulse, 4e8, 1e8, 0.0);
  EXPECT_GT(ShapeTable(pulse, test_grid(60), true).parts(), 4u);
}

TEST(ShapeTable, KnowsALongFlatTop) {
  const EchoPulse pulse = ramped(3000.5, 100.3, 200.0);
  const ShapeTable table(pulse, test_grid(60), true);
  const ShapeTable::Constant& flat = table.constant();
  EXPECT_NEAR(flat.gain, 1.0, 1e-13);
  EXPECT_EQ(flat.end - flat.begin, 2800u - 101u);
  const std::size_t cell_of_the_edge = table.place({0, 1}, test_grid(60).first_s, {}).cell;
  EXPECT_EQ(flat.begin - cell_of_the_edge, 101u);
  EXPECT_EQ(ShapeTable(ramped(300.0, 10.0, 20.0), test_grid(60), true).constant().end, 0u);
}

TEST(ShapeTable, TakesNoMoreThan32Megabytes) {
  EXPECT_TRUE(ShapeTable(ramped(300'000.0, 10.0, 10.0), test_grid(60), false).is_usable());
  EXPECT_FALSE(ShapeTable(ramped(500'000.0, 10.0, 10.0), test_grid(60), false).is_usable());
}

}  // namespace shape_table_test
}  // namespace sarsim::radar
