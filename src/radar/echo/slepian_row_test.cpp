#include "radar/echo/slepian_row.hpp"

#include "radar/echo/doppler_terms.hpp"
#include "radar/echo/echo_test_support.hpp"
#include "radar/echo/spectral_kernel.hpp"
#include "radar/echo/spectral_settings.hpp"

namespace sarsim::radar {
namespace dense_row_test {

constexpr double carrier_hz = 2e9;
constexpr std::size_t very_many = 1'000'000'000;

double cycle_doppler(double samples) { return 1.0 / (carrier_hz * samples * test_interval_s); }

// A bend that turns the ends of a pulse by so much.
double bend_of(double rad, double samples) {
  return rad / (core::pi * carrier_hz * std::pow(0.5 * samples * test_interval_s, 2.0));
}

struct Parts {
  const EchoPulse* pulse;
  SampleGrid grid;
  SpectralSettings settings{1e-6};
  PulseBody body{*pulse, grid.interval_s, settings.edge_samples, settings.beta};
  core::BasicFft<float> fft{core::fast_fft_size(grid.count + static_cast<std::size_t>(body.last() - body.first()) + 8)};
  SlepianRow row{*pulse, body, grid, settings.share, stretch_room(*pulse, grid.interval_s), fft};
};

bool suits(const EchoPulse& pulse) {
  const SpectralSettings settings(1e-6);
  return SlepianRow::suits(pulse, PulseBody(pulse, test_interval_s, settings.edge_samples, settings.beta));
}

// The row as one of very many echoes, of which these come first.
ComplexRow dense_row(const EchoPulse& pulse, const SampleGrid& grid, const std::vector<EchoBatch>& parts,
                     double tolerance = 1e-6) {
  SpectralKernel kernel(pulse, grid, tolerance);
  kernel.begin(carrier_hz, very_many);
  for (const EchoBatch& part : parts) kernel.take(part);
  ComplexRow row(grid.count);
  kernel.finish(row);
  return row;
}

void expect_reference(const EchoPulse& pulse, const SampleGrid& grid, const EchoBatch& echoes) {
  const ComplexRow expected = reference_row(pulse, grid, carrier_hz, echoes);
  const double strength = strength_of(pulse, grid, echoes);
  for (const double tolerance : {1e-3, 1e-5, 1e-6})
    EXPECT_LT(relative_error(dense_row(pulse, grid, {echoes}, tolerance), expected, strength), tolerance)
        << pulse.pulse.width_s / test_interval_s << " samples";
}

TEST(SlepianRow, IsForPulsesThatGoOnSmoothlyBeyondTheirEnds) {
  EXPECT_TRUE(suits(test_pulse(Pulse::Kind::chirp, 100.0, 0.8)));
  EXPECT_TRUE(suits(test_pulse(Pulse::Kind::mono, 100.0)));
  EXPECT_FALSE(suits(band_limited_test_pulse(60.0, 0.9)));
  EXPECT_FALSE(suits(test_pulse(Pulse::Kind::chirp, 10.0, 0.8)));  // no body
  EXPECT_FALSE(suits(test_pulse(Pulse::Kind::code, 325.0)));
  EchoPulse ramps = test_pulse(Pulse::Kind::chirp, 190.0, 0.7);
  ramps.pulse.envelope = Pulse::Envelope::linear;
  ramps.pulse.rise_s = ramps.pulse.fall_s = 40.0 * test_interval_s;
  EXPECT_FALSE(suits(ramps));
}

TEST(SlepianRow, IsWorthItsTransformsFromAboutAnEchoASampleOn) {
  EXPECT_FALSE(SlepianRow::is_worth(700.0, 8, 1'000, 1));
  EXPECT_TRUE(SlepianRow::is_worth(900.0, 8, 1'000, 1));
  EXPECT_TRUE(SlepianRow::is_worth(100.0, 8, 1'000, 2));  // next to two grids
  EXPECT_FALSE(SlepianRow::is_worth(1e9, 8, 40'000, 1));  // for the memory of the sums
  EXPECT_FALSE(SlepianRow::is_worth(1e9, 9, 1'000, 1));   // eight functions are not enough
}

TEST(SlepianRow, TakesFewerTransformsForNarrowBandsAndLooseTolerances) {
  const auto transforms = [](double band, double half_doppler, double error) {
    const EchoPulse chirp = test_pulse(Pulse::Kind::chirp, 100.0, band);
    return SlepianRow::transforms_about(chirp, test_interval_s, carrier_hz, half_doppler, error);
  };
  EXPECT_EQ(transforms(0.9, 0.0, 1.25e-7), 8u);
  EXPECT_EQ(transforms(0.4, 0.0, 1.25e-7), 6u);
  EXPECT_EQ(transforms(0.9, 0.0, 1.25e-4), 5u);
  EXPECT_GT(transforms(0.9, cycle_doppler(100.0), 1.25e-7), 8u);
  const EchoPulse tone = test_pulse(Pulse::Kind::mono, 100.0);
  EXPECT_EQ(SlepianRow::transforms_about(tone, test_interval_s, carrier_hz, 0.0, 1e-7), 1u);
}

// The change of the sweep of long pulses enters to first order: what its square leaves grows with the square of D.
TEST(SlepianRow, KnowsForWhichSpansOfDopplerFunctionsAreEnough) {
  const SampleGrid grid = test_grid(300);
  const EchoPulse chirp = test_pulse(Pulse::Kind::chirp, 2000.0, 0.8);
  for (const auto& [half, enough] : {std::pair(2e-7, true), std::pair(4e-6, false)}) {
    Parts parts{&chirp, grid};
    const auto transforms = SlepianRow::transforms_about(chirp, test_interval_s, 1e8, half, parts.settings.share);
    EXPECT_EQ(transforms <= 8u, enough) << half;
    EXPECT_EQ(parts.row.prepare({1e8, {0.0, half}, {}}), enough) << half;
  }
}

TEST(SlepianRow, SharesASpanAsWideAsFunctionsFollow) {
  const EchoPulse chirp = test_pulse(Pulse::Kind::chirp, 2000.0, 0.8);
  const auto shared = [&](const DopplerSpan& span) {
    return SlepianRow::shared_span(chirp, test_interval_s, carrier_hz, span, 1.25e-7);
  };
  const double half = std::exp2(-26);  // 1.5e-8
  // Polynomials of degree 2 would not do beyond four times of it,
  EXPECT_EQ(shared({3.25 * half, half}), (DopplerSpan{4.0 * half, 4.0 * half}));
  EXPECT_EQ(shared({12.5 * half, 2.0 * half}), (DopplerSpan{12.0 * half, 4.0 * half}));
  EXPECT_EQ(shared({12.5 * half, 4.0 * half}), (DopplerSpan{12.5 * half, 4.0 * half}));
  // and do not here.
  EXPECT_EQ(shared({26.0 * half, 8.0 * half}), (DopplerSpan{32.0 * half, 16.0 * half}));
  // The ends would turn by more than 7e-4 rad.
  EXPECT_EQ(shared({26.0 * half, 16.0 * half}), (DopplerSpan{26.0 * half, 16.0 * half}));
  EXPECT_EQ(shared({half, 0.0}), (DopplerSpan{half, 0.0}));
  EXPECT_EQ(shared({0.0, std::exp2(-40)}), (DopplerSpan{0.0, std::exp2(-37)}));
  // Neighbours have it in common.
  for (const double middle : {-5.75, -4.0, -2.25})
    EXPECT_EQ(shared({middle * half, half}), (DopplerSpan{-4.0 * half, 4.0 * half})) << middle;
  // Whatever is in a span is in that which it shares.
  for (double middle = -9.0; middle < 9.0; middle += 0.25) {
    const DopplerSpan wide = shared({middle * half, half});
    EXPECT_LE(wide.middle - wide.half, (middle - 1.0) * half);
    EXPECT_GE(wide.middle + wide.half, (middle + 1.0) * half);
  }
}

// Where the wider span moves ends too far apart, that of the echoes serves.
TEST(SlepianRow, TakesTheSpanOfItsEchoesWhereItCannotShareOne) {
  const EchoPulse tone = test_pulse(Pulse::Kind::mono, 2000.4);
  const SampleGrid grid = test_grid(3000);
  const double low_hz = 1e5;
  const DopplerSpan span = span_covering(-2e-5, 2e-5);
  const DopplerSpan wide = SlepianRow::shared_span(tone, grid.interval_s, low_hz, span, 1.25e-7);
  ASSERT_NE(wide, span);
  Parts parts{&tone, grid};
  const DenseMotion refused{low_hz, wide, {}};
  EXPECT_FALSE(parts.row.is_refused(refused));
  EXPECT_FALSE(parts.row.prepare(refused));
  EXPECT_TRUE(parts.row.is_refused(refused));
  EXPECT_TRUE(parts.row.prepare({low_hz, span, {}}));
  EXPECT_FALSE(parts.row.is_refused({low_hz, span, {}}));

  SpectralKernel kernel(tone, grid, 1e-6);
  kernel.begin(low_hz, very_many);
  EchoBatch all;
  for (const unsigned seed : {1U, 2U}) {
    const EchoBatch part = random_echoes(100, grid, 2100.0, 1e-5 * core::exact_light_speed_mps, seed);
    kernel.take(part);
    for (std::size_t k = 0; k < part.size(); ++k) all.add(part.delay_s[k], part.amplitude_sqrt_w[k], part.doppler[k]);
  }
  ComplexRow row(grid.count);
  kernel.finish(row);
  EXPECT_LT(relative_error(row, reference_row(tone, grid, low_hz, all), strength_of(tone, grid, all)), 1e-6);
}

// A long recording meets ever new motions.
TEST(SlepianRow, ForgetsMotionsOfLongAgo) {
  const EchoPulse chirp = test_pulse(Pulse::Kind::chirp, 100.4, 0.8);
  Parts parts{&chirp, test_grid(300)};
  const auto refused = [](int k) { return DenseMotion{carrier_hz, {1e-6 * k, cycle_doppler(100.0)}, {}}; };
  for (int k = 0; k < 64; ++k) EXPECT_FALSE(parts.row.prepare(refused(k)));
  EXPECT_TRUE(parts.row.is_refused(refused(0)));
  EXPECT_FALSE(parts.row.prepare(refused(64)));
  EXPECT_FALSE(parts.row.is_refused(refused(0)));
  EXPECT_TRUE(parts.row.is_refused(refused(1)));
}

// Second derivatives of polynomials are as good as the change needs them, up to the largest that enters.
TEST(SlepianRow, FollowsChangesOfTheSweepOfLongPulses) {
  const SampleGrid grid = test_grid(2500);
  const EchoPulse chirp = test_pulse(Pulse::Kind::chirp, 2000.4, 0.8);
  for (const double half : {5e-8, 2e-7, 6e-7}) {
    Parts parts{&chirp, grid};
    EXPECT_TRUE(parts.row.prepare({carrier_hz, {0.0, half}, {}})) << half;
    expect_reference(chirp, grid, random_echoes(200, grid, 2100.0, 0.5 * half * core::exact_light_speed_mps));
  }
}

TEST(SlepianRow, FindsFunctionsThatKeepTheShare) {
  for (const double width : {100.0, 100.4, 100.02, 99.97}) {
    const EchoPulse chirp = test_pulse(Pulse::Kind::chirp, width, 0.8);
    Parts parts{&chirp, test_grid(300)};
    EXPECT_TRUE(parts.row.prepare({carrier_hz, {}, {}})) << width;
    const double half = 1e-2 * cycle_doppler(width);
    EXPECT_TRUE(parts.row.prepare({carrier_hz, {3.0 * half, half}, {}})) << width;
    const double bend = bend_of(1e-6, width);
    EXPECT_TRUE(parts.row.prepare({carrier_hz, {0.0, half}, {3.0 * bend, bend}})) << width;
  }
}

// Eight functions are not enough for these; the row is that of the reference all the same.
TEST(SlepianRow, LeavesWhatItCannotMakeToOthers) {
  const SampleGrid grid = test_grid(300);
  const EchoPulse broad = test_pulse(Pulse::Kind::chirp, 100.4, 1.1);
  Parts just{&broad, grid};
  EXPECT_TRUE(just.row.prepare({carrier_hz, {}, {}}));
  const EchoPulse wide = test_pulse(Pulse::Kind::chirp, 100.4, 1.4);
  Parts parts{&wide, grid};
  EXPECT_FALSE(parts.row.prepare({carrier_hz, {}, {}}));
  const double half = cycle_doppler(100.0);
  const EchoPulse chirp = test_pulse(Pulse::Kind::chirp, 100.4, 0.8);
  Parts fast{&chirp, grid};
  EXPECT_FALSE(fast.row.prepare({carrier_hz, {0.0, half}, {}}));
  // Ends that move by (D - middle)^3: 1e-9 of a sample, with a carrier so low that nothing else is against it.
  const EchoPulse tone = test_pulse(Pulse::Kind::mono, 2000.4);
  Parts slow{&tone, test_grid(3000)};
  EXPECT_TRUE(slow.row.prepare({1e5, {0.0, 2e-5}, {}}));
  EXPECT_FALSE(slow.row.prepare({1e5, {0.0, 1e-4}, {}}));
  expect_reference(wide, grid, random_echoes(300, grid, 120.0, 5.0));
  expect_reference(chirp, grid, random_echoes(300, grid, 120.0, 0.5 * half * core::exact_light_speed_mps));
}

TEST(SlepianRow, IsThatOfTheReferenceForAnyWidth) {
  const SampleGrid grid = test_grid(300);
  for (const double width : {100.0, 100.4, 100.02, 99.97, 100.5})
    for (const double speed_mps : {0.0, 5.0, 300.0})
      for (const auto kind : {Pulse::Kind::chirp, Pulse::Kind::mono})
        expect_reference(test_pulse(kind, width, kind == Pulse::Kind::chirp ? -0.9 : 0.0), grid,
                         random_echoes(300, grid, 120.0, speed_mps));
}

// Bins make the smaller bends, and would miss the tolerance without them.
TEST(SlepianRow, IsThatOfTheReferenceForBentEchoes) {
  const SampleGrid grid = test_grid(300);
  const double speed_mps = 5.0;
  for (const double width : {100.0, 100.4})
    for (const double rad : {0.5, 1e-5, 1e-7}) {
      const EchoPulse chirp = test_pulse(Pulse::Kind::chirp, width, 0.3);
      const double bend = bend_of(rad, width);
      const EchoBatch echoes = random_echoes(300, grid, 120.0, speed_mps, 5, bend);
      expect_reference(chirp, grid, echoes);
      Parts parts{&chirp, grid};
      const double most = 2.0 * speed_mps / core::exact_light_speed_mps;
      const bool usable = parts.row.prepare({carrier_hz, span_covering(-most, most), span_covering(-bend, bend)});
      EXPECT_EQ(usable, rad < 0.1);
    }
}

// Of a tone without Doppler the functions are nearly constant, and second derivatives of polynomials are rounding
// alone; with very little of it, functions that count for next to nothing are what bends come from.
TEST(SlepianRow, IsThatOfTheReferenceForBentTones) {
  const SampleGrid grid = test_grid(300);
  const EchoPulse tone = test_pulse(Pulse::Kind::mono, 100.4);
  for (const double speed_mps : {0.0, 0.01, 0.1, 1.0})
    for (const double rad : {1e-3, 1e-4, 1e-5, 1e-7})
      expect_reference(tone, grid, random_echoes(100, grid, 120.0, speed_mps, 5, bend_of(rad, 100.4)));
}

// The sums go around the circle of the transform.
TEST(SlepianRow, IsThatOfTheReferenceForRowsOfAnyLength) {
  for (std::size_t count = 250; count < 290; ++count) {
    const SampleGrid grid = test_grid(count);
    expect_reference(test_pulse(Pulse::Kind::chirp, 100.4, 0.8), grid, random_echoes(100, grid, 120.0, 0.0));
  }
}

TEST(SlepianRow, IsThatOfTheReferenceByTheRuleOfTheThesis) {
  const SampleGrid grid = test_grid(300);
  EchoPulse chirp = test_pulse(Pulse::Kind::chirp, 100.4, 0.9);
  chirp.doppler_rule = DopplerRule::thesis;
  for (const double speed_mps : {0.0, 5.0, 300.0})
    expect_reference(chirp, grid, random_echoes(300, grid, 120.0, speed_mps));
}

TEST(SlepianRow, IsTheSameAtEverySimdLevel) {
  const SampleGrid grid = test_grid(300);
  const EchoPulse chirp = test_pulse(Pulse::Kind::chirp, 100.4, 0.9);
  for (const double bend : {0.0, 1e-2})
    for (const double speed_mps : {0.0, 5.0}) {
      const EchoBatch echoes = random_echoes(301, grid, 120.0, speed_mps, 5, bend);
      const ComplexRow expected = reference_row(chirp, grid, carrier_hz, echoes);
      const double strength = strength_of(chirp, grid, echoes);
      at_every_simd_level(
          [&] { EXPECT_LT(relative_error(dense_row(chirp, grid, {echoes}), expected, strength), 5e-7); });
    }
}

// A wrong decision would be an error of a whole sample. Few echoes in a row: where many lie at one place, their
// rounding adds up.
TEST(SlepianRow, DecidesEndsExactlyOnSamplesLikeTheReference) {
  const SampleGrid grid = test_grid(300);
  for (const double width : {100.0, 100.3})
    for (const double speed_mps : {0.0, -3000.0, 3000.0})
      for (const double off : {0.0, -0.9e-9, 0.9e-9, 1e-12, -3e-4, 3e-4, -1e-3, 1e-3, 0.2997, 0.3003}) {
        EchoBatch echoes;
        for (const double share : {1.0, 0.9, 0.3})
          echoes.add(grid.first_s + (50.0 + off) * grid.interval_s, 1.0,
                     2.0 * share * speed_mps / core::exact_light_speed_mps);
        expect_reference(test_pulse(Pulse::Kind::chirp, width, 0.8), grid, echoes);
      }
}

// Of a pulse of whole samples motion moves either end over a sample, one way or the other.
TEST(SlepianRow, DecidesEndsThatMotionMovesOverASample) {
  const SampleGrid grid = test_grid(300);
  const EchoPulse chirp = test_pulse(Pulse::Kind::chirp, 100.0, 0.8);
  const double largest = 2e-7;
  const double ends_move = 50.0 * largest;  // samples
  Parts parts{&chirp, grid};
  ASSERT_TRUE(parts.row.prepare({carrier_hz, span_covering(-largest, largest), {}}));
  for (const double where : {-0.9, -0.6, -0.2, 0.2, 0.6, 0.9}) {
    EchoBatch echoes;
    for (const double share : {-1.0, -0.7, 0.0, 0.7, 1.0})
      echoes.add(grid.first_s + (50.0 + where * ends_move) * grid.interval_s, 1.0, share * largest);
    expect_reference(chirp, grid, echoes);
  }
}

// Ends move by D/(1 - D), not by D alone: here by 4e-7 of a sample more.
TEST(SlepianRow, DecidesEndsByTheSquareOfTheSpeedToo) {
  const EchoPulse tone = test_pulse(Pulse::Kind::mono, 2000.0);
  const SampleGrid grid = test_grid(2500);
  const double low_hz = 1e5;
  for (const double doppler : {-2e-5, 2e-5})
    for (int step = -5; step <= 5; ++step) {
      const double ends_move = 1000.0 * doppler / (1.0 - doppler);
      EchoBatch echoes;
      for (const double end : {-1.0, 1.0})
        echoes.add(grid.first_s + (50.0 + end * ends_move + 1e-7 * step) * grid.interval_s, 1.0, doppler);
      echoes.add(grid.first_s + 50.3 * grid.interval_s, 1.0, -doppler);
      SpectralKernel kernel(tone, grid, 1e-6);
      kernel.begin(low_hz, very_many);
      kernel.take(echoes);
      ComplexRow row(grid.count);
      kernel.finish(row);
      EXPECT_LT(relative_error(row, reference_row(tone, grid, low_hz, echoes), strength_of(tone, grid, echoes)), 1e-6)
          << doppler << ' ' << step;
    }
}

TEST(SlepianRow, TakesPartsOfAnyMotion) {
  const SampleGrid grid = test_grid(300);
  const EchoPulse chirp = test_pulse(Pulse::Kind::chirp, 100.4, 0.9);
  EchoBatch all;
  std::vector<EchoBatch> parts;
  unsigned seed = 1;
  for (const double speed_mps : {0.0, 1.0, 20.0, 0.5}) {
    parts.push_back(random_echoes(200, grid, 120.0, speed_mps, seed++));
    const EchoBatch& part = parts.back();
    for (std::size_t k = 0; k < part.size(); ++k) all.add(part.delay_s[k], part.amplitude_sqrt_w[k], part.doppler[k]);
  }
  const ComplexRow expected = reference_row(chirp, grid, carrier_hz, all);
  EXPECT_LT(relative_error(dense_row(chirp, grid, parts), expected, strength_of(chirp, grid, all)), 1e-6);
}

// Echoes at rest stand by the middle of the span that those before them need, too.
TEST(SlepianRow, TakesAPartAtRestBehindOneThatMoves) {
  const SampleGrid grid = test_grid(300);
  const EchoPulse chirp = test_pulse(Pulse::Kind::chirp, 100.4, 0.9);
  std::vector<EchoBatch> parts(2);
  EchoBatch all;
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> position(-100.0, 300.0), share(0.8, 1.0);
  for (std::size_t part = 0; part < 2; ++part)
    for (int k = 0; k < 200; ++k) {
      const double delay_s = grid.first_s + position(random) * grid.interval_s;
      const double doppler = part == 0 ? share(random) * 8e-10 : 0.0;
      parts[part].add(delay_s, 1.0, doppler);
      all.add(delay_s, 1.0, doppler);
    }
  const ComplexRow expected = reference_row(chirp, grid, carrier_hz, all);
  EXPECT_LT(relative_error(dense_row(chirp, grid, parts), expected, strength_of(chirp, grid, all)), 3e-7);
}

TEST(SlepianRow, TakesAPartWithoutBendsBehindOneThatHasThem) {
  const SampleGrid grid = test_grid(300);
  const EchoPulse chirp = test_pulse(Pulse::Kind::chirp, 100.4, 0.3);
  const double bend = bend_of(1e-5, 100.0);
  const EchoBatch bent = random_echoes(200, grid, 120.0, 5.0, 5, bend);
  const EchoBatch even = random_echoes(200, grid, 120.0, 5.0, 6);
  EchoBatch all = bent;
  for (std::size_t k = 0; k < even.size(); ++k)
    all.add(even.delay_s[k], even.amplitude_sqrt_w[k], PulseClock{even.doppler[k], 0.0});
  const ComplexRow expected = reference_row(chirp, grid, carrier_hz, all);
  EXPECT_LT(relative_error(dense_row(chirp, grid, {bent, even}), expected, strength_of(chirp, grid, all)), 1e-6);
}

// What a kernel did before leaves no trace, whatever bins it keeps.
TEST(SlepianRow, DoesNotDependOnRowsBefore) {
  const SampleGrid grid = test_grid(300);
  const EchoPulse chirp = test_pulse(Pulse::Kind::chirp, 100.4, 0.9);
  const EchoBatch echoes = random_echoes(200, grid, 120.0, 5.0);
  const ComplexRow expected = dense_row(chirp, grid, {echoes});
  SpectralKernel used(chirp, grid, 1e-6);
  for (const double speed_mps : {0.0, 7.0, 1000.0}) {
    used.begin(carrier_hz, very_many);
    used.take(random_echoes(100, grid, 120.0, speed_mps, 9));
  }
  used.begin(carrier_hz, very_many);
  used.take(echoes);
  ComplexRow row(grid.count);
  used.finish(row);
  EXPECT_EQ(row, expected);
}

// Echoes of 100.4 samples have 100 or 101: some samples are added beside the sums.
TEST(SlepianRow, PassesAFilterLikeTheRow) {
  const SampleGrid grid = test_grid(300);
  const std::vector<std::complex<double>> taps{{1.0, 0.5}, {-0.3, 0.2}, {0.1, -0.4}};
  std::vector<std::size_t> index;
  for (std::size_t i = 0; i + taps.size() <= grid.count; i += 2) index.push_back(i);
  const EchoBatch echoes = random_echoes(300, grid, 120.0, 0.0);
  for (const double width : {100.0, 100.4}) {
    const EchoPulse chirp = test_pulse(Pulse::Kind::chirp, width, 0.8);
    const ComplexRow row = reference_row(chirp, grid, carrier_hz, echoes);
    ComplexRow expected;
    for (const std::size_t i : index) {
      std::complex<double> sum;
      for (std::size_t k = 0; k < taps.size(); ++k) sum += taps[k] * row[i + k];
      expected.push_back(sum);
    }
    SpectralKernel kernel(chirp, grid, 1e-6, {taps, index});
    kernel.begin(carrier_hz, very_many);
    kernel.take(echoes);
    ComplexRow out(index.size());
    kernel.finish_filtered(out);
    EXPECT_LT(relative_error(out, expected, strength_of(chirp, grid, echoes)), 2e-6) << width;
  }
}

}  // namespace dense_row_test
}  // namespace sarsim::radar
