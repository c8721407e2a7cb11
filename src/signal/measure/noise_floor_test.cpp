#include "signal/measure/noise_floor.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/maths/constants.hpp"
#include "core/maths/fft.hpp"

namespace sarsim::signal {
namespace noise_floor_test {

constexpr std::size_t side = 256;
constexpr std::size_t finer = 8;  // samples to a resolution cell

// Periodic noise of power 2 with a spectrum that is even over 1/8 of the band in each direction.
FocusedImage noise_image(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  const std::size_t band = side / finer;
  std::vector<std::complex<double>> values(side * side);
  for (std::size_t r = 0; r < band; ++r)
    for (std::size_t c = 0; c < band; ++c)
      values[r * side + c] = {normal(random) / static_cast<double>(band), normal(random) / static_cast<double>(band)};
  const core::Fft fft(side);
  std::vector<std::complex<double>> line(side);
  for (std::size_t r = 0; r < side; ++r) fft.inverse(std::span(values).subspan(r * side, side));
  for (std::size_t c = 0; c < side; ++c) {
    for (std::size_t r = 0; r < side; ++r) line[r] = values[r * side + c];
    fft.inverse(line);
    for (std::size_t r = 0; r < side; ++r) values[r * side + c] = line[r];
  }
  FocusedImage image;
  image.azimuth = {0.0, 1.0 / finer, side};
  image.range = {1000.0, 1.0 / finer, side};
  image.values.assign(values.begin(), values.end());
  return image;
}

// Searches of 4 by 6 cells of the noise, 5 x 4 of them in a field with half a cell and more between, 150 fields.
TEST(PeakFalseAlarm, IsTheShareOfSearchesInNoiseThatFindSomething) {
  constexpr int fields = 150;
  std::vector<double> largest;
  for (int f = 0; f < fields; ++f) {
    const FocusedImage image = noise_image(static_cast<std::uint64_t>(f));
    for (std::size_t r = 0; r + 32 < side; r += 48)
      for (std::size_t c = 0; c + 48 < side; c += 64) {
        double peak = 0.0;
        for (std::size_t i = 0; i <= 32; ++i)
          for (std::size_t k = 0; k <= 48; ++k)
            peak = std::max(peak, static_cast<double>(std::norm(image.values[(r + i) * side + c + k])));
        largest.push_back(peak / 2.0);
      }
  }
  const auto searches = static_cast<double>(largest.size());
  for (const double p : {0.05, 0.02, 0.01}) {
    const double threshold = peak_threshold(p, 4.0, 6.0);
    EXPECT_NEAR(peak_false_alarm(threshold, 4.0, 6.0), p, 1e-9);
    const auto above = static_cast<double>(std::ranges::count_if(largest, [&](double x) { return x > threshold; }));
    EXPECT_NEAR(above / searches, p, 0.05 * p + 5.0 * std::sqrt(p / searches)) << p;
  }
}

TEST(PeakFalseAlarm, OfAPlaceWithoutExtentIsThatOfOneSample) {
  EXPECT_NEAR(peak_false_alarm(5.0, 0.0, 0.0), std::exp(-5.0), 1e-15);
  EXPECT_EQ(peak_false_alarm(0.1, 3.0, 3.0), 1.0);
}

TEST(NoisePowerNear, IsThatOfTheNoiseWithAndWithoutPoints) {
  FocusedImage image = noise_image(4);
  // 1,000 cells, of which a quartile tells the mean to 5 %.
  EXPECT_NEAR(noise_power_near(image, reader_of(image), {16.0, 1016.0}, 16.0, 16.0), 2.0, 5.0 * 0.05 * 2.0);
  const double before = noise_power_near(image, reader_of(image), {16.0, 1016.0}, 8.0, 8.0);
  for (std::size_t r = 120; r < 136; ++r)
    for (std::size_t c = 120; c < 136; ++c) image.values[r * side + c] += 1000.0F;
  EXPECT_NEAR(noise_power_near(image, reader_of(image), {16.0, 1016.0}, 8.0, 8.0) / before, 1.0, 0.1);
}

TEST(NoisePowerNear, CountsNoZerosAndNothingOutside) {
  FocusedImage image = noise_image(5);
  const double full = noise_power_near(image, reader_of(image), {8.0, 1016.0}, 8.0, 16.0);
  std::fill(image.values.begin() + side * side / 2, image.values.end(), 0.0F);
  EXPECT_NEAR(noise_power_near(image, reader_of(image), {16.0, 1016.0}, 16.0, 16.0) / full, 1.0, 0.2);
  EXPECT_EQ(noise_power_near(image, reader_of(image), {28.0, 1016.0}, 3.0, 3.0), 0.0);
  EXPECT_EQ(noise_power_near(image, reader_of(image), {500.0, 1016.0}, 3.0, 3.0), 0.0);
}

}  // namespace noise_floor_test
}  // namespace sarsim::signal
