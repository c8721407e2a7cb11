#include "signal/row/row_kernels.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "signal/row/raw_samples.hpp"
#include "signal/row/sinc_row.hpp"
#include "signal/row/smooth_row.hpp"

namespace sarsim::signal {
namespace row_kernels_test {

using Row = std::vector<std::complex<float>>;

Row some_row(std::size_t count) {
  Row row(count);
  for (std::size_t k = 0; k < count; ++k)
    row[k] = {static_cast<float>(std::sin(1.3 * static_cast<double>(k) + 0.2)),
              static_cast<float>(std::cos(0.7 * static_cast<double>(k)))};
  return row;
}

TEST(RowKernels, TurnEachSampleByItsOwnAngleWhateverTheLength) {
  for (const std::size_t count : {1U, 7U, 16U, 33U, 257U}) {
    Row row = some_row(count);
    std::vector<float> turns(count);
    for (std::size_t k = 0; k < count; ++k) turns[k] = 0.0371F * static_cast<float>(k) - 3.0F;
    const Row before = row;
    turn_row(row, turns);
    for (std::size_t k = 0; k < count; ++k) {
      const auto exact =
          std::complex<double>(before[k]) * std::polar(1.0, 2.0 * std::numbers::pi * static_cast<double>(turns[k]));
      EXPECT_NEAR(std::abs(std::complex<double>(row[k]) - exact), 0.0, 6e-7) << count << " " << k;
    }
  }
}

TEST(RowKernels, MultiplyAndScaleSampleBySample) {
  Row row = some_row(53);
  const Row before = row;
  const Row factors(before.rbegin(), before.rend());
  multiply_row(row, factors);
  std::vector<float> weights(row.size());
  for (std::size_t k = 0; k < weights.size(); ++k) weights[k] = 0.1F * static_cast<float>(k);
  scale_row(row, weights, 0.5F);
  for (std::size_t k = 0; k < row.size(); ++k)
    EXPECT_NEAR(std::abs(row[k] - 0.5F * weights[k] * before[k] * factors[k]), 0.0F, 1e-6F);
}

TEST(RowKernels, WeighAColumnWithinTheDirectionsThatAreSeen) {
  constexpr std::size_t count = 101;
  Row column(count, {1.0F, 0.0F});
  std::vector<float> sine(count), weight(count, 2.0F);
  const std::vector<float> turns(count, 0.25F);
  for (std::size_t k = 0; k < count; ++k) sine[k] = -0.5F + 0.01F * static_cast<float>(k);
  weigh_column(
      column, turns,
      {.sine = sine, .weight = weight, .low = -0.4F, .high = 0.3F, .low_edge = 0.1F, .high_edge = 0.2F, .scale = 3.0F});
  for (std::size_t k = 0; k < count; ++k) {
    const double at = static_cast<double>(sine[k]);
    const double part = std::clamp(std::min((at + 0.4) / 0.1, (0.3 - at) / 0.2), 0.0, 1.0);
    const double share = 0.5 - 0.5 * std::cos(std::numbers::pi * part);
    EXPECT_NEAR(column[k].imag(), 6.0 * share, 6e-6) << sine[k];
    EXPECT_NEAR(column[k].real(), 0.0, 3e-6) << sine[k];
  }
}

TEST(RowKernels, TransposeAnyShape) {
  for (const std::size_t rows : {1U, 3U, 4U, 9U})
    for (const std::size_t columns : {1U, 4U, 6U, 17U}) {
      const Row from = some_row(rows * (columns + 3));
      Row to(columns * (rows + 2));
      transpose(from.data(), columns + 3, rows, columns, to.data(), rows + 2);
      for (std::size_t r = 0; r < rows; ++r)
        for (std::size_t c = 0; c < columns; ++c) EXPECT_EQ(to[c * (rows + 2) + r], from[r * (columns + 3) + c]);
    }
}

TEST(SmoothRow, GivesTurnsOfALargePhaseWithoutWholeOnes) {
  // The phase of a chirp: a million turns at its middle, half a turn for each sample at its ends.
  constexpr std::size_t count = 1000;
  const auto turns_of = [](double k) { return 1e6 + 0.3 + 5e-4 * (k - 500.0) * (k - 500.0); };
  std::vector<float> turns(count);
  sample_turns(knots_of(count, turns_of), turns_of, turns);
  for (std::size_t k = 0; k < count; ++k) {
    const double left = static_cast<double>(turns[k]) - turns_of(static_cast<double>(k));
    EXPECT_NEAR(left - std::round(left), 0.0, 3e-6) << k;
  }
}

TEST(SmoothRow, EvaluatesWhatIsNotSmoothSampleBySample) {
  // A corner, as where a square root begins, and a wave shorter than a piece.
  constexpr std::size_t count = 300;
  for (const double cycles : {0.0, 0.05}) {
    const auto turns_of = [&](double k) {
      return std::sqrt(std::max(k - 100.0, 0.0)) + std::sin(2.0 * std::numbers::pi * cycles * k);
    };
    std::vector<float> turns(count);
    sample_turns(knots_of(count, turns_of), turns_of, turns);
    for (std::size_t k = 0; k < count; ++k) {
      const double left = static_cast<double>(turns[k]) - turns_of(static_cast<double>(k));
      EXPECT_NEAR(left - std::round(left), 0.0, 3e-6) << cycles << " " << k;
    }
  }
}

TEST(SmoothRow, SplitsPlacesIntoSamplesAndSteps) {
  constexpr std::size_t count = 5000;
  const auto place_of = [](double k) { return -7.3 + 0.99 * k + 1e-6 * k * k; };
  std::vector<std::int32_t> whole(count), step(count);
  sample_places(place_of, 2048, {whole, step});
  for (std::size_t k = 0; k < count; ++k) {
    EXPECT_GE(step[k], 0);
    EXPECT_LE(step[k], 2048);
    EXPECT_NEAR(whole[k] + step[k] / 2048.0, place_of(static_cast<double>(k)), 0.5 / 2048 + 2e-5) << k;
  }
}

TEST(SincRow, InterpolatesAsTheTableOfOneValueDoes) {
  constexpr std::size_t count = 60;
  const Row samples = some_row(count);
  Row padded(count + 2 * SincRow::margin);
  std::ranges::copy(samples, padded.begin() + SincRow::margin);
  const core::SincTable table(0.7);
  const SincRow rows(0.7);
  std::vector<std::int32_t> whole, step;
  std::vector<float> factors;
  for (int k = -12; k < 75; ++k) {
    whole.push_back(k);
    step.push_back((k + 12) * 23);
    factors.push_back(0.5F);
  }
  Row out(whole.size());
  rows.interpolate(padded, whole, step, factors, -8, static_cast<std::ptrdiff_t>(count) + 8, out);
  for (std::size_t k = 0; k < out.size(); ++k) {
    const double place = whole[k] + step[k] / 2048.0;
    EXPECT_NEAR(std::abs(out[k] - 0.5F * table.value(samples, place)), 0.0F, 2e-6F) << place;
  }
}

}  // namespace row_kernels_test
}  // namespace sarsim::signal
