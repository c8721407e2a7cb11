#include "signal/search/detection_peaks.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/maths/constants.hpp"
#include "core/maths/window.hpp"

namespace sarsim::signal {
namespace detection_peaks_test {

std::vector<CfarDetection> all_cells_of(std::span<const float> power, std::size_t columns, float above) {
  std::vector<CfarDetection> found;
  for (std::size_t i = 0; i < power.size(); ++i)
    if (power[i] > above) found.push_back({i / columns, i % columns, static_cast<double>(power[i]), 1.0, 1.0, 1});
  return found;
}

std::vector<std::pair<std::size_t, std::size_t>> places(const std::vector<CfarDetection>& found) {
  std::vector<std::pair<std::size_t, std::size_t>> list;
  for (const CfarDetection& d : found) list.emplace_back(d.row, d.column);
  return list;
}

using Places = std::vector<std::pair<std::size_t, std::size_t>>;

TEST(DetectionPeaks, KeepOneCellOfEachResponse) {
  std::vector<float> map(8 * 10, 0.0F);
  map[3 * 10 + 4] = 9.0F;
  map[3 * 10 + 5] = 7.0F;
  map[2 * 10 + 3] = 8.0F;
  map[6 * 10 + 9] = 5.0F;
  EXPECT_EQ(places(peaks_of(all_cells_of(map, 10, 1.0F), map, 10)), (Places{{3, 4}, {6, 9}}));
}

TEST(DetectionPeaks, TakeTheFirstDopplerRowForANeighbourOfTheLast) {
  std::vector<float> map(8 * 9, 0.0F);
  map[0 * 9 + 2] = 6.0F;
  map[7 * 9 + 2] = 5.0F;
  map[7 * 9 + 0] = 4.0F;
  map[0 * 9 + 6] = 5.0F;
  map[7 * 9 + 7] = 6.0F;
  EXPECT_EQ(places(peaks_of(all_cells_of(map, 9, 1.0F), map, 9)), (Places{{0, 2}, {7, 0}, {7, 7}}));
}

TEST(DetectionPeaks, KeepTheFirstOfEqualNeighbours) {
  const std::vector<float> map{1.0F, 3.0F, 3.0F, 3.0F, 1.0F, 3.0F};
  EXPECT_EQ(places(peaks_of(all_cells_of(map, 6, 2.0F), map, 6)), (Places{{0, 1}, {0, 5}}));
}

TEST(PeakFrequency, IsThatOfAToneWhateverItsWindow) {
  for (const double frequency : {-0.31, 0.0, 0.1234})
    for (const bool windowed : {false, true}) {
      std::vector<std::complex<double>> values;
      for (int p = 0; p < 32; ++p)
        values.push_back(
            std::polar(windowed ? core::hamming_window(p / 31.0) : 1.0, 0.7 + 2.0 * core::pi * frequency * p));
      EXPECT_NEAR(peak_frequency(values, std::round(frequency * 32.0) / 32.0, 0.6 / 32.0), frequency, 1e-6);
    }
}

TEST(PeakPlace, IsThatOfABandLimitedResponse) {
  for (const double band : {0.5, 0.8})
    for (const double place : {20.0, 20.3, 20.5, 19.75}) {
      std::vector<std::complex<float>> line;
      for (int n = 0; n < 41; ++n) {
        const double x = core::pi * band * (n - place);
        line.push_back(std::complex<float>((x == 0.0 ? 1.0 : std::sin(x) / x) * std::polar(1.0, 0.4)));
      }
      EXPECT_NEAR(peak_place(line, static_cast<std::size_t>(std::lround(place))), place, 0.01) << band;
    }
}

TEST(PeakPlace, StaysWithinTheLine) {
  const std::vector<std::complex<float>> line{5.0F, 1.0F, 0.0F, 0.0F, 1.0F, 5.0F};
  EXPECT_GE(peak_place(line, 0), 0.0);
  EXPECT_LE(peak_place(line, 5), 5.0);
  EXPECT_EQ(peak_place(std::vector<std::complex<float>>{3.0F}, 0), 0.0);
}

}  // namespace detection_peaks_test
}  // namespace sarsim::signal
