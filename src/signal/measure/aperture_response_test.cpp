#include "signal/measure/aperture_response.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <random>
#include <vector>

#include "core/maths/constants.hpp"

namespace sarsim::signal {
namespace aperture_response_test {

struct Draw {
  ApertureBand band;
  double first_rad = 0.0, last_rad = 0.0;
};

Draw draw_of(std::mt19937& random) {
  const auto between = [&random](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const double carrier_per_m = std::exp(between(std::log(0.5), std::log(100.0)));
  const double squint_rad = between(0.0, 55.0) * core::pi / 180.0;
  const double half_rad = between(0.2, 15.0) * core::pi / 180.0;
  return {{carrier_per_m, carrier_per_m * std::exp(between(std::log(0.001), std::log(0.5)))},
          squint_rad - half_rad,
          squint_rad + half_rad};
}

// The same by its definition: every look and every wave number of an even band, on a fine line.
std::optional<ResponseFigures> by_definition(const std::vector<ApertureLook>& looks, const ApertureBand& band,
                                             double step_m, int half) {
  constexpr int frequencies = 48;
  std::vector<std::complex<double>> line(static_cast<std::size_t>(2 * half + 1));
  for (const ApertureLook& look : looks)
    for (int f = 0; f < frequencies; ++f) {
      const double per_m = band.carrier_per_m + ((f + 0.5) / frequencies - 0.5) * band.band_per_m;
      // A carrier that all have in common turns no magnitude; it is taken out so that the sum stays exact.
      const double turns = per_m * look.slope * step_m;
      std::complex<double> term = std::polar(look.weight, -2.0 * core::pi * turns * half);
      const std::complex<double> turn = std::polar(1.0, 2.0 * core::pi * turns);
      for (std::complex<double>& value : line) {
        value += term;
        term *= turn;
      }
    }
  auto figures = figures_of(line, static_cast<std::size_t>(half));
  if (!figures) return std::nullopt;
  figures->width *= step_m;
  figures->null *= step_m;
  return figures;
}

// Looks in groups of a five-hundredth of the aperture and a pulse interpolated by straight lines between 64 values a
// cell: a thousandth of the peak at the last side lobes that count.
TEST(ApertureFigures, AreThoseOfTheSumOverThePolarAnnulus) {
  std::mt19937 random(20261129);
  const SampledResponse pulse = theoretical_response({}, 0.0, 0.0, {}, BeyondSampling::folded);
  int compared = 0;
  for (int n = 0; n < 10; ++n) {
    const Draw draw = draw_of(random);
    const double middle_rad = 0.5 * (draw.first_rad + draw.last_rad);
    constexpr int count = 151;
    for (const bool across : {false, true}) {
      std::vector<ApertureLook> looks;
      double low = INFINITY, high = -INFINITY;
      for (int i = 0; i < count; ++i) {
        // Places evenly along the line, a beam that tapers.
        const double share = static_cast<double>(i) / (count - 1);
        const double along = std::tan(draw.first_rad) + share * (std::tan(draw.last_rad) - std::tan(draw.first_rad));
        const double angle_rad = std::atan(along) - middle_rad;
        const double slope = across ? std::sin(angle_rad) : std::cos(angle_rad);
        looks.push_back({slope, 1.0 - 0.5 * std::abs(2.0 * share - 1.0)});
        for (const double side : {-0.5, 0.5}) {
          low = std::min(low, (draw.band.carrier_per_m + side * draw.band.band_per_m) * slope);
          high = std::max(high, (draw.band.carrier_per_m + side * draw.band.band_per_m) * slope);
        }
      }
      const auto found = aperture_figures(looks, draw.band, pulse);
      const auto expected = by_definition(looks, draw.band, 1.0 / (48.0 * (high - low)), 1200);
      ASSERT_EQ(found.has_value(), expected.has_value()) << n;
      if (!found) continue;
      ++compared;
      EXPECT_NEAR(found->width, expected->width, 0.002 * expected->width) << n;
      // In amplitude, of the peak.
      EXPECT_NEAR(std::pow(10.0, found->pslr_db / 20.0), std::pow(10.0, expected->pslr_db / 20.0), 0.002) << n;
      EXPECT_NEAR(found->islr_db, expected->islr_db, 0.1) << n;
    }
  }
  EXPECT_GT(compared, 15);
}

TEST(ApertureFigures, OfANarrowApertureAreThoseOfItsBand) {
  const SampledResponse pulse = theoretical_response({}, 80.0, 1.5, {}, BeyondSampling::folded);
  const ResponseFigures figures = theoretical_figures({}, 80.0, 1.5);
  const auto found = aperture_figures(std::vector<ApertureLook>{{1.0, 2.0}}, {64.0, 0.3}, pulse);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->width, figures.width / 0.3, 1e-3 * figures.width / 0.3);
  EXPECT_NEAR(found->pslr_db, figures.pslr_db, 0.02);
  EXPECT_NEAR(found->islr_db, figures.islr_db, 0.05);
}

TEST(ApertureFigures, AreNoneWithoutASupport) {
  const SampledResponse pulse = theoretical_response({}, 0.0, 0.0, {}, BeyondSampling::folded);
  EXPECT_FALSE(aperture_figures({}, {64.0, 0.3}, pulse));
  EXPECT_FALSE(aperture_figures(std::vector<ApertureLook>{{0.0, 1.0}}, {64.0, 0.3}, pulse));
}

}  // namespace aperture_response_test
}  // namespace sarsim::signal
