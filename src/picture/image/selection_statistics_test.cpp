#include "picture/image/selection_statistics.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

#include "core/maths/constants.hpp"
#include "raster/table/computed_raster.hpp"

namespace sarsim::picture {
namespace selection_statistics_test {

raster::ComputedRaster plane_of(std::vector<std::complex<float>> samples, std::size_t columns) {
  const std::size_t rows = samples.size() / columns;
  return {
      rows, columns,
      [samples = std::move(samples), columns](const raster::ImageWindow& window, std::span<std::complex<float>> out) {
        for (std::size_t i = 0; i < window.rows; ++i)
          for (std::size_t k = 0; k < window.cols; ++k)
            out[i * window.cols + k] =
                samples[(window.row0 + i * window.row_step) * columns + window.col0 + k * window.col_step];
      }};
}

SelectionStatistics measure(const std::vector<std::complex<float>>& samples, std::size_t columns) {
  return measure_selection(plane_of(samples, columns), {0, samples.size() / columns, 0, columns});
}

std::vector<std::complex<float>> noise(std::size_t count, float mean, float deviation) {
  std::mt19937 random(9);
  std::normal_distribution<float> normal(0.0F, deviation);
  std::vector<std::complex<float>> samples(count);
  for (auto& sample : samples) sample = {mean + normal(random), normal(random)};
  return samples;
}

// Figures by definition, in long double.
struct Figures {
  long double mean = 0.0L;
  long double rms = 0.0L;
  long double deviation = 0.0L;
};
Figures figures(const std::vector<double>& values) {
  Figures result;
  const auto count = static_cast<long double>(values.size());
  for (const double value : values) result.mean += static_cast<long double>(value) / count;
  for (const double value : values) {
    const auto v = static_cast<long double>(value);
    result.rms += v * v / count;
    result.deviation += (v - result.mean) * (v - result.mean) / count;
  }
  result.rms = std::sqrt(result.rms);
  result.deviation = std::sqrt(result.deviation);
  return result;
}

TEST(SelectionStatistics, AreThoseOfTheDefinitionForEveryQuantity) {
  const auto samples = noise(700 * 900, 0.4F, 1.5F);
  const SelectionStatistics found = measure(samples, 900);
  EXPECT_EQ(found.samples, samples.size());
  std::array<std::vector<double>, sample_quantities> values;
  for (const auto& sample : samples) {
    const std::complex<double> z(sample);
    values[0].push_back(z.real());
    values[1].push_back(z.imag());
    values[2].push_back(std::abs(z));
    values[3].push_back(20.0 * std::log10(std::abs(z)));
    values[4].push_back(std::arg(z));
  }
  for (std::size_t k = 0; k < sample_quantities; ++k) {
    const QuantityStatistics& of = found.of[k];
    const Figures expected = figures(values[k]);
    EXPECT_EQ(of.count, samples.size());
    EXPECT_NEAR(of.mean, static_cast<double>(expected.mean), 1e-9) << k;
    EXPECT_NEAR(of.rms, static_cast<double>(expected.rms), 1e-9) << k;
    EXPECT_NEAR(of.deviation, static_cast<double>(expected.deviation), 1e-9) << k;
    EXPECT_NEAR(of.minimum, *std::ranges::min_element(values[k]), 1e-12) << k;
    EXPECT_NEAR(of.maximum, *std::ranges::max_element(values[k]), 1e-12) << k;
    std::ranges::sort(values[k]);
    for (const double part : {0.01, 0.25, 0.5, 0.99}) {
      const double exact = values[k][static_cast<std::size_t>(part * static_cast<double>(values[k].size()))];
      EXPECT_NEAR(of.histogram.percentile(part), exact, of.histogram.bin_width()) << k << ", " << part;
    }
    const auto& bins = of.histogram.bins;
    EXPECT_EQ(std::accumulate(bins.begin(), bins.end(), std::uint64_t{0}), samples.size());
    EXPECT_LE(of.histogram.low, of.minimum);
    EXPECT_GE(of.histogram.high, of.maximum);
  }
}

TEST(SelectionStatistics, KeepTheDigitsOfASmallDeviationOfLargeValues) {
  const auto samples = noise(600 * 1000, 1e6F, 3.0F);
  std::vector<double> real;
  for (const auto& sample : samples) real.push_back(static_cast<double>(sample.real()));
  const SelectionStatistics found = measure(samples, 1000);
  const Figures expected = figures(real);
  EXPECT_NEAR(found[SampleQuantity::real].deviation / static_cast<double>(expected.deviation), 1.0, 1e-9);
}

TEST(SelectionStatistics, HistogramGrowsWithTheValuesAndLosesNone) {
  // Parts of very different size, so that the range grows between them: the first is all zeros.
  std::vector<std::complex<float>> samples(3 << 18);
  for (std::size_t i = 1 << 18; i < samples.size(); ++i)
    samples[i] = {i < (2U << 18U) ? 1e-6F : -1e5F, i % 2 == 0 ? 1e-6F : 3.0F};
  const SelectionStatistics found = measure(samples, 1 << 10);
  const Histogram& real = found[SampleQuantity::real].histogram;
  EXPECT_EQ(std::accumulate(real.bins.begin(), real.bins.end(), std::uint64_t{0}), samples.size());
  EXPECT_EQ(real.high, 131072.0);
  EXPECT_EQ(real.low, -131072.0);
  EXPECT_NEAR(real.percentile(0.2), -1e5, real.bin_width());
  EXPECT_NEAR(real.percentile(0.9), 0.0, real.bin_width());
  EXPECT_EQ(found.zeros, 1U << 18U);
  EXPECT_EQ(found[SampleQuantity::decibels].count, samples.size() - (1U << 18U));
}

TEST(SelectionStatistics, ValuesStayInTheirBinsWhenTheHistogramGrows) {
  auto samples = noise(2 << 18, 0.0F, 0.3F);
  samples.back() = {100.0F, -900.0F};
  const SelectionStatistics found = measure(samples, 1 << 10);
  for (const SampleQuantity quantity : {SampleQuantity::real, SampleQuantity::imaginary, SampleQuantity::magnitude}) {
    const Histogram& histogram = found[quantity].histogram;
    std::vector<std::uint64_t> expected(histogram.bins.size());
    for (const auto& sample : samples) {
      const std::complex<double> z(sample);
      const double value = quantity == SampleQuantity::real ? z.real()
                           : quantity == SampleQuantity::imaginary
                               ? z.imag()
                               : std::sqrt(z.real() * z.real() + z.imag() * z.imag());
      ++expected[static_cast<std::size_t>(std::floor((value - histogram.low) / histogram.bin_width()))];
    }
    EXPECT_EQ(histogram.bins, expected) << name_of(quantity);
  }
}

TEST(SelectionStatistics, LeaveOutWhatIsNotFinite) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  const SelectionStatistics found = measure({{1, 2}, {nan, 0}, {0, infinity}, {-3, 4}}, 2);
  EXPECT_EQ(found.not_finite, 2U);
  EXPECT_EQ(found[SampleQuantity::magnitude].count, 2U);
  EXPECT_EQ(found[SampleQuantity::magnitude].maximum, 5.0);
  EXPECT_EQ(found[SampleQuantity::real].mean, -1.0);
}

TEST(SelectionStatistics, OfNothingOrZerosAreZero) {
  const SelectionStatistics none = measure_selection(plane_of({{1, 1}}, 1), {0, 0, 0, 0});
  EXPECT_EQ(none.samples, 0U);
  EXPECT_EQ(none[SampleQuantity::real].maximum, 0.0);
  const SelectionStatistics zeros = measure({{0, 0}, {0, 0}}, 2);
  EXPECT_EQ(zeros.zeros, 2U);
  EXPECT_EQ(zeros[SampleQuantity::decibels].count, 0U);
  EXPECT_EQ(zeros[SampleQuantity::decibels].mean, 0.0);
  EXPECT_EQ(zeros[SampleQuantity::magnitude].rms, 0.0);
  EXPECT_NEAR(zeros[SampleQuantity::magnitude].limits(0.02).high, 0.0, 1e-30);
}

TEST(SelectionStatistics, ExtremeFloatsHavePlaces) {
  const float least = std::numeric_limits<float>::denorm_min();
  const float most = std::numeric_limits<float>::max();
  const SelectionStatistics found = measure({{least, -least}, {most, -most}}, 2);
  EXPECT_EQ(found[SampleQuantity::imaginary].minimum, -static_cast<double>(most));
  for (const QuantityStatistics& of : found.of) {
    EXPECT_GE(of.minimum, of.histogram.low);
    EXPECT_LE(of.maximum, of.histogram.high);
  }
}

TEST(SelectionStatistics, LimitsLeaveOutTheEnds) {
  std::vector<std::complex<float>> samples;
  for (int i = 0; i < 1000; ++i) samples.emplace_back(static_cast<float>(i), 0.0F);
  samples.emplace_back(1e6F, 0.0F);
  const auto limits = measure(samples, 1001)[SampleQuantity::magnitude].limits(0.01);
  EXPECT_LT(limits.high, 2000.0);
  EXPECT_GE(limits.low, 0.0);
}

TEST(SelectionStatistics, AreTheSameForAnyNumberOfThreadsAndStepsAreKept) {
  const auto samples = noise(900 * 1200, 0.1F, 2.0F);
  const raster::ComputedRaster plane = plane_of(samples, 1200);
  const raster::ImageWindow window{3, 400, 5, 500, 2, 2};
  const SelectionStatistics one = measure_selection(plane, window, {1, nullptr});
  const SelectionStatistics three = measure_selection(plane, window, {3, nullptr});
  EXPECT_EQ(one.samples, 200000U);
  double sum = 0.0;
  for (std::size_t i = 0; i < 400; ++i)
    for (std::size_t k = 0; k < 500; ++k) sum += static_cast<double>(samples[(3 + 2 * i) * 1200 + 5 + 2 * k].real());
  EXPECT_NEAR(one[SampleQuantity::real].mean, sum / 200000.0, 1e-12);
  for (std::size_t k = 0; k < sample_quantities; ++k) {
    EXPECT_EQ(one.of[k].mean, three.of[k].mean);
    EXPECT_EQ(one.of[k].deviation, three.of[k].deviation);
    EXPECT_EQ(one.of[k].histogram.bins, three.of[k].histogram.bins);
  }
}

TEST(SelectionStatistics, ReportProgressAndStop) {
  const raster::ComputedRaster plane = plane_of(noise(1 << 20, 0.0F, 1.0F), 1 << 10);
  std::vector<std::size_t> done;
  (void)measure_selection(plane, {0, 1 << 10, 0, 1 << 10}, {}, [&](const core::Progress& progress) {
    done.push_back(progress.done * 100 / progress.total);
  });
  EXPECT_THAT(done, testing::ElementsAre(25, 50, 75, 100));
  core::StopFlag stop;
  stop.request();
  EXPECT_THROW((void)measure_selection(plane, {0, 1 << 10, 0, 1 << 10}, {1, &stop}), core::Interrupted);
}

}  // namespace selection_statistics_test
}  // namespace sarsim::picture
