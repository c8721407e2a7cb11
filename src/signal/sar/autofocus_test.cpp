#include "signal/sar/autofocus.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>
#include <stdexcept>

#include "core/maths/constants.hpp"
#include "core/maths/fft.hpp"
#include "signal/sar/autofocus.hpp"

namespace sarsim::signal {
namespace autofocus_test {

const core::WorkControl one{1, nullptr};

// A scene of points in noise-like clutter whose spectrum in azimuth fills `share` of the band about `middle`, both in
// parts of the sampling rate; each frequency turned by error(place), place from -1 to 1 over the aperture.
template <class Error>
FocusedImage spotlight(double share, double middle, const Error& error, std::size_t rows = 512,
                       std::size_t columns = 96) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  FocusedImage image;
  image.azimuth = {0.0, 0.7, rows};
  image.range = {9e3, 1.0, columns};
  image.carrier_hz = 5.3e9;
  image.light_speed_mps = core::exact_light_speed_mps;
  image.values.resize(rows * columns);
  const core::Fft fft(rows);
  std::vector<std::complex<double>> column(rows);
  for (std::size_t c = 0; c < columns; ++c) {
    for (auto& v : column) v = std::complex(0.02 * normal(random), 0.02 * normal(random));
    for (int k = 0; k < 3; ++k)
      column[static_cast<std::size_t>(uniform(random) * static_cast<double>(rows))] +=
          std::polar(0.3 + uniform(random) * uniform(random), 6.0 * uniform(random));
    fft.forward(column);
    for (std::size_t k = 0; k < rows; ++k) {
      const double cycles = static_cast<double>(k) / static_cast<double>(rows) - middle;
      const double place = 2.0 * (cycles - std::round(cycles)) / share;
      column[k] *= std::abs(place) > 1.0 ? 0.0 : std::polar(1.0 / static_cast<double>(rows), error(place));
    }
    fft.inverse(column);
    for (std::size_t r = 0; r < rows; ++r) image.values[r * columns + c] = std::complex<float>(column[r]);
  }
  return image;
}

const auto no_error = [](double) { return 0.0; };
// 10 rad of quadratic error, 3 rad of sine.
const auto usual_error = [](double x) { return 10.0 * x * x + 3.0 * std::sin(2.5 * core::pi * x + 0.3); };

// Root mean square of values, constant and straight line apart.
double without_line_rad(const std::vector<double>& left) {
  const auto n = static_cast<double>(left.size());
  double mean = 0.0, moment = 0.0, spread = 0.0, sum = 0.0;
  for (const double v : left) mean += v / n;
  for (std::size_t i = 0; i < left.size(); ++i) {
    const double x = static_cast<double>(i) - 0.5 * (n - 1.0);
    moment += x * (left[i] - mean);
    spread += x * x;
  }
  for (std::size_t i = 0; i < left.size(); ++i) {
    const double x = static_cast<double>(i) - 0.5 * (n - 1.0);
    sum += std::pow(left[i] - mean - moment / spread * x, 2.0);
  }
  return std::sqrt(sum / n);
}

// Root mean square of the error that is left at the frequencies found, constant and straight line apart.
template <class Error>
double residual_rad(const AutofocusResult& result, double share, double middle, const Error& error) {
  const double rate = 1.0 / 0.7;
  std::vector<double> left;
  for (std::size_t i = 0; i < result.phase_rad.size(); ++i) {
    const double place = 2.0 * (result.cycles_per_m[i] / rate - middle) / share;
    left.push_back(result.phase_rad[i] - error(place));
  }
  return without_line_rad(left);
}

TEST(Autofocus, BringsTenRadiansOfQuadraticAndThreeOfSineBelowATenth) {
  for (const double middle : {0.0, 0.37}) {
    const double share = 0.8;
    const FocusedImage sharp = spotlight(share, middle, no_error);
    const FocusedImage blurred = spotlight(share, middle, usual_error);
    const AutofocusResult result = autofocus(blurred, {}, one);
    const double residual = residual_rad(result, share, middle, usual_error);
    std::printf("residual %.4f rad after %zu rounds; entropy %.4f sharp, %.4f blurred, %.4f corrected\n", residual,
                result.round_rad.size(), image_entropy(sharp), image_entropy(blurred), image_entropy(result.image));
    EXPECT_LT(residual, 0.1);
    EXPECT_GT(image_entropy(blurred), 1.05 * image_entropy(sharp));
    EXPECT_NEAR(image_entropy(result.image), image_entropy(sharp), 0.005 * image_entropy(sharp));
    EXPECT_NEAR(static_cast<double>(result.phase_rad.size()), share * 512.0, 3.0);
    EXPECT_GT(result.round_rad.front(), 1.0);
    EXPECT_LT(result.round_rad.back(), 0.01);
  }
}

// Adds noise at all frequencies, beyond the aperture too.
FocusedImage with_noise(FocusedImage image, double sigma) {
  std::mt19937_64 random(11);
  std::normal_distribution<double> normal(0.0, sigma);
  for (auto& value : image.values) value += std::complex<float>(std::complex(normal(random), normal(random)));
  return image;
}

// Points have 1.2 of power in each frequency, noise 0.026.
TEST(Autofocus, KnowsAnApertureThatIsASmallPartOfTheSpectrumFromNoise) {
  const double share = 0.15;
  const AutofocusResult result = autofocus(with_noise(spotlight(share, 0.0, usual_error), 0.005), {}, one);
  EXPECT_NEAR(static_cast<double>(result.phase_rad.size()), share * 512.0, 4.0);
  EXPECT_LT(residual_rad(result, share, 0.0, usual_error), 0.1);
}

// Noise of 0.9 in each frequency: no power tells where the aperture ends, but the caller may know.
TEST(Autofocus, LooksAtNothingBeyondTheBandItIsTold) {
  const double share = 0.15;
  const FocusedImage noisy = with_noise(spotlight(share, 0.0, usual_error), 0.03);
  const AutofocusResult told = autofocus(noisy, {.band_per_m = share / 0.7}, one);
  EXPECT_LE(told.phase_rad.size(), 78u);
  EXPECT_LT(residual_rad(told, share, 0.0, usual_error), 0.5);
  EXPECT_GT(residual_rad(autofocus(noisy, {}, one), share, 0.0, usual_error), 1.0);
}

TEST(Autofocus, FillsTheWholeBandWhereTheSpectrumDoes) {
  const AutofocusResult result = autofocus(spotlight(1.0, 0.0, usual_error), {}, one);
  // The error jumps by 6 rad where the band's end meets its beginning; a few frequencies there stay behind.
  EXPECT_LT(residual_rad(result, 1.0, 0.0, usual_error), 0.15);
  EXPECT_EQ(result.phase_rad.size(), 512u);
}

// A straight line of phase would move all points.
TEST(Autofocus, LeavesPointsWhereTheyAre) {
  // Without a straight part over the aperture: x^3 - 3 x/5.
  const auto cubic = [](double x) { return 8.0 * x * x * x - 4.8 * x; };
  const FocusedImage sharp = spotlight(0.8, 0.0, no_error);
  const FocusedImage found = autofocus(spotlight(0.8, 0.0, cubic), {}, one).image;
  const std::size_t columns = sharp.range.count;
  for (std::size_t c = 0; c < columns; ++c) {
    const auto at = [&](const FocusedImage& image, std::size_t r) { return std::abs(image.values[r * columns + c]); };
    std::size_t top = 0;
    for (std::size_t r = 1; r < sharp.azimuth.count; ++r)
      if (at(sharp, r) > at(sharp, top)) top = r;
    EXPECT_NEAR(at(found, top), at(sharp, top), 0.1F * at(sharp, top)) << c;
  }
}

TEST(Autofocus, LeavesASharpImageAlone) {
  const FocusedImage sharp = spotlight(0.8, 0.0, no_error);
  const AutofocusResult result = autofocus(sharp, {}, one);
  EXPECT_LT(residual_rad(result, 0.8, 0.0, no_error), 0.02);
  EXPECT_NEAR(image_entropy(result.image), image_entropy(sharp), 1e-3 * image_entropy(sharp));
}

TEST(Autofocus, GivesTheSameBytesForAnyNumberOfThreads) {
  const FocusedImage blurred = spotlight(0.8, 0.0, usual_error, 128, 70);
  const AutofocusResult expected = autofocus(blurred, {}, one);
  for (const unsigned threads : {2u, 3u, 8u}) {
    const AutofocusResult got = autofocus(blurred, {}, {threads, nullptr});
    EXPECT_EQ(std::memcmp(got.image.values.data(), expected.image.values.data(),
                          got.image.values.size() * sizeof(got.image.values[0])),
              0);
    EXPECT_EQ(got.phase_rad, expected.phase_rad);
  }
}

TEST(Autofocus, MakesNothingOfNothing) {
  FocusedImage image;
  EXPECT_TRUE(autofocus(image, {}, one).phase_rad.empty());
  image.azimuth.count = 32;
  image.range.count = 4;
  image.values.assign(128, 0.0F);
  const AutofocusResult result = autofocus(image, {}, one);
  EXPECT_TRUE(result.phase_rad.empty());
  for (const auto& v : result.image.values) ASSERT_EQ(v, 0.0F);
  EXPECT_EQ(image_entropy(image), 0.0);
}

TEST(Autofocus, RefusesWhatContradictsItselfAndStopsWhenAsked) {
  FocusedImage image = spotlight(0.8, 0.0, no_error, 64, 8);
  core::StopFlag stop;
  stop.request();
  EXPECT_THROW((void)autofocus(image, {}, {1, &stop}), core::Interrupted);
  FocusedImage spoilt = image;
  spoilt.values.pop_back();
  EXPECT_THROW((void)autofocus(spoilt, {}, one), std::invalid_argument);
  EXPECT_THROW((void)autofocus_strip(spoilt, 30.0, {}, one), std::invalid_argument);
  EXPECT_THROW((void)autofocus_strip(image, 2.0, {}, one), std::invalid_argument);
  image.frame.plane = ImagePlane::ground_grid;
  EXPECT_THROW((void)autofocus_strip(image, 30.0, {}, one), std::invalid_argument);
}

TEST(ImageEntropy, IsTheLogarithmOfTheNumberOfEqualPixels) {
  FocusedImage image;
  image.values.assign(100, {});
  for (int i = 0; i < 10; ++i)
    image.values[static_cast<std::size_t>(7 * i)] = std::polar(3.0F, 0.1F * static_cast<float>(i));
  EXPECT_NEAR(image_entropy(image), std::log(10.0), 1e-6);
}

// A strip whose points are seen under `aperture_m` of the track, by a beam that looks `squint_rad` ahead, with an error
// that depends on the antenna's place. The points lie between two places along the track.
struct Points {
  double first_m = 0.0, last_m = 1200.0;
  int count = 16;  // to a column
  unsigned seed = 8;
};

template <class Error>
FocusedImage strip(double aperture_m, const Error& error, double squint_rad = 0.0, double column_m = 1.0,
                   const Points& points = {}) {
  std::mt19937_64 random(points.seed);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  FocusedImage image;
  image.azimuth = {0.0, 0.6, 2000};
  image.range = {10e3, column_m, 24};
  image.carrier_hz = 5.3e9;
  image.light_speed_mps = core::exact_light_speed_mps;
  image.values.resize(2000 * 24);
  const double wavelength_m = core::exact_light_speed_mps / 5.3e9;
  image.azimuth.spectrum_centre_per_m = 2.0 / wavelength_m * std::sin(squint_rad);
  std::vector<std::complex<double>> column(2000);
  for (std::size_t c = 0; c < 24; ++c) {
    std::ranges::fill(column, 0.0);
    const double range_m = image.range.at(static_cast<double>(c));
    for (int k = 0; k < points.count; ++k) {
      const double place_m = points.first_m + (k + uniform(random)) * (points.last_m - points.first_m) / points.count;
      const std::complex<double> strength = std::polar(0.5 + uniform(random), 6.0 * uniform(random));
      // The sum over the antenna's places of the phases that focusing leaves.
      constexpr int steps = 256;
      for (int i = 0; i < steps; ++i) {
        const double s_m = place_m - range_m * std::tan(squint_rad) + aperture_m * ((i + 0.5) / steps - 0.5);
        const double cycles_per_m = 2.0 / wavelength_m * (place_m - s_m) / std::hypot(place_m - s_m, range_m);
        const std::complex<double> turn = strength / static_cast<double>(steps) * std::polar(1.0, error(s_m));
        const double reach_m = 50.0;
        for (auto row = static_cast<long>((place_m - reach_m) / 0.6);
             row < static_cast<long>((place_m + reach_m) / 0.6); ++row)
          if (row >= 0 && row < 2000)
            column[static_cast<std::size_t>(row)] +=
                turn * std::polar(1.0, 2.0 * core::pi * cycles_per_m * (static_cast<double>(row) * 0.6 - place_m));
      }
    }
    for (std::size_t r = 0; r < 2000; ++r) image.values[r * 24 + c] = std::complex<float>(column[r]);
  }
  return image;
}

TEST(AutofocusOfAStrip, SharpensWhatAWaveringTrackBlurred) {
  const auto error = [](double s) { return 6.0 * std::sin(2.0 * core::pi * s / 700.0 + 0.5); };
  const FocusedImage sharp = strip(300.0, no_error);
  const FocusedImage blurred = strip(300.0, error);
  const StripmapAutofocusResult result = autofocus_strip(blurred, 120.0, {}, one);
  std::printf("strip: entropy %.4f sharp, %.4f blurred, %.4f corrected\n", image_entropy(sharp), image_entropy(blurred),
              image_entropy(result.image));
  EXPECT_GT(image_entropy(blurred), 1.05 * image_entropy(sharp));
  EXPECT_NEAR(image_entropy(result.image), image_entropy(sharp), 0.01 * image_entropy(sharp));
  std::vector<double> left;
  for (std::size_t i = 0; i < result.along_m.size(); ++i)
    if (result.along_m[i] > -50.0 && result.along_m[i] < 1250.0)
      left.push_back(result.phase_rad[i] - error(result.along_m[i]));
  EXPECT_LT(without_line_rad(left), 0.35);
}

// At 3 degrees the spectrum stands about 1.1 times the sampling rate, at 10 degrees 3.7 times; and a place of the
// antenna is seen 170 m farther along by the last column than by the first where columns are 40 m apart.
TEST(AutofocusOfAStrip, FollowsTheLineOfSightOfABeamThatSquints) {
  const auto error = [](double s) { return 6.0 * std::sin(2.0 * core::pi * s / 700.0 + 0.5); };
  for (const double degrees : {-3.0, 3.0, 10.0}) {
    const double squint_rad = degrees * core::pi / 180.0;
    const FocusedImage sharp = strip(300.0, no_error, squint_rad, 40.0);
    const FocusedImage blurred = strip(300.0, error, squint_rad, 40.0);
    const StripmapAutofocusResult result = autofocus_strip(blurred, 120.0, {}, one);
    std::printf("squint %.0f: entropy %.4f sharp, %.4f blurred, %.4f corrected\n", degrees, image_entropy(sharp),
                image_entropy(blurred), image_entropy(result.image));
    EXPECT_GT(image_entropy(blurred), 1.05 * image_entropy(sharp));
    EXPECT_NEAR(image_entropy(result.image), image_entropy(sharp), 0.01 * image_entropy(sharp)) << degrees;
    const double behind_m = (10e3 + 12.0 * 40.0) * std::tan(squint_rad);
    std::vector<double> left;
    for (std::size_t i = 0; i < result.along_m.size(); ++i)
      if (result.along_m[i] > -50.0 - behind_m && result.along_m[i] < 1250.0 - behind_m)
        left.push_back(result.phase_rad[i] - error(result.along_m[i]));
    ASSERT_GT(left.size(), 10u);
    // Of 4.2 rad; a piece of 120 m sees the mean of the error over its length, and lines of sight differ within it.
    EXPECT_LT(without_line_rad(left), 0.5) << degrees;
  }
}

// Where the brightest sample of a column is, between the rows, and how high.
struct Top {
  double row = 0.0, height = 0.0;
};

Top top_of(const FocusedImage& image, std::size_t column) {
  const auto at = [&](std::size_t row) { return std::abs(std::complex<double>(image.values[row * 24 + column])); };
  std::size_t top = 1;
  for (std::size_t row = 1; row + 1 < image.azimuth.count; ++row)
    if (at(row) > at(top)) top = row;
  const double before = at(top - 1), after = at(top + 1);
  const double share = 0.5 * (before - after) / (before - 2.0 * at(top) + after);
  return {static_cast<double>(top) + share, at(top) - 0.25 * (before - after) * share};
}

// Points of one stretch, all seen from the same part of the flight; the rest of the strip is empty, and its pieces say
// nothing true. What an error has of a straight line over the aperture moves points, and is left.
TEST(AutofocusOfAStrip, LeavesPointsWhereTheyAre) {
  std::mt19937_64 random(22);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  const double cell_m = core::exact_light_speed_mps / 5.3e9 * 10e3 / (2.0 * 300.0);
  double worst_cells = 0.0, lowest_db = 0.0;
  for (unsigned draw = 0; draw < 6; ++draw) {
    const double height_rad = 0.3 + 2.0 * uniform(random), period_m = 120.0 + 150.0 * uniform(random);
    const double begin_rad = 6.28 * uniform(random);
    const auto error = [&](double s) { return height_rad * std::sin(2.0 * core::pi * s / period_m + begin_rad); };
    const Points points{590.0, 610.0, 1, 100 + draw};
    const FocusedImage sharp = strip(300.0, no_error, 0.0, 1.0, points);
    const StripmapAutofocusResult result =
        autofocus_strip(strip(300.0, error, 0.0, 1.0, points), 30.0 + 30.0 * uniform(random), {}, one);
    double xy = 0.0, xx = 0.0;
    for (double s = -150.0; s <= 150.0; s += 1.0) {
      xy += s * error(600.0 + s);
      xx += s * s;
    }
    const double moved_m = xy / xx * core::exact_light_speed_mps / 5.3e9 * 10e3 / (4.0 * core::pi);
    std::vector<double> off_cells, gains_db;
    for (std::size_t column = 0; column < 24; ++column) {
      const Top then = top_of(sharp, column), now = top_of(result.image, column);
      off_cells.push_back(((now.row - then.row) * 0.6 - moved_m) / cell_m);
      gains_db.push_back(20.0 * std::log10(now.height / then.height));
    }
    std::ranges::sort(off_cells);
    std::ranges::sort(gains_db);
    std::printf("%.2f rad, %.0f m: moved by %.3f m, off by %.3f cells, %.2f dB\n", height_rad, period_m, moved_m,
                off_cells[12], gains_db[12]);
    worst_cells = std::max(worst_cells, std::abs(off_cells[12]));
    lowest_db = std::min(lowest_db, gains_db[12]);
  }
  EXPECT_LT(worst_cells, 0.1);
  EXPECT_GT(lowest_db, -1.0);
}

TEST(AutofocusOfAStrip, LeavesASharpStripAlone) {
  const FocusedImage sharp = strip(300.0, no_error);
  const StripmapAutofocusResult result = autofocus_strip(sharp, 120.0, {}, one);
  EXPECT_NEAR(image_entropy(result.image), image_entropy(sharp), 0.005 * image_entropy(sharp));
}

}  // namespace autofocus_test
}  // namespace sarsim::signal
