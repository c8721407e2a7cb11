#include "signal/measure/response.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/maths/constants.hpp"
#include "core/report/expect.hpp"

namespace sarsim::signal {
namespace response_test {

struct Row {
  const char* window;
  double width;
  double null;
  double pslr_db;
  double islr_db;
};

class WindowTable : public testing::TestWithParam<Row> {};

// Figures of an even spectrum under each window: numerical integration to four digits (the rectangular row and that of
// Taylor, 35 dB, nbar 5, also in closed form or by design).
INSTANTIATE_TEST_SUITE_P(
    Windows, WindowTable,
    testing::Values(Row{"rectangular", 0.886, 1.000, -13.26, -10.11}, Row{"kaiser:1.6", 0.958, 1.125, -16.69, -14.02},
                    Row{"kaiser:2.5", 1.042, 1.281, -20.94, -18.80}, Row{"taylor:30:4", 1.125, 1.516, -30.29, -24.10},
                    Row{"taylor:35:5", 1.187, 1.672, -35.19, -28.28}, Row{"hamming", 1.303, 2.000, -42.70, -35.30},
                    Row{"hann", 1.441, 2.000, -31.50, -32.90}));

TEST_P(WindowTable, IsWhatTheFiguresOfAnEvenSpectrumAre) {
  const ResponseFigures figures = theoretical_figures(window_from_text(GetParam().window).value());
  EXPECT_NEAR(figures.width, GetParam().width, 0.001);
  EXPECT_NEAR(figures.null, GetParam().null, 0.01);
  EXPECT_NEAR(figures.pslr_db, GetParam().pslr_db, 0.05);
  EXPECT_NEAR(figures.islr_db, GetParam().islr_db, 0.15);
}

TEST(TheoreticalFigures, OfAChirpFollowItsTimeBandwidthProduct) {
  for (const auto& [product, width, pslr_db] :
       {std::tuple{25.0, 0.8800, -13.81}, std::tuple{50.0, 0.8831, -13.52}, std::tuple{100.0, 0.8845, -13.39},
        std::tuple{1000.0, 0.8858, -13.27}}) {
    const ResponseFigures figures = theoretical_figures({}, product);
    EXPECT_NEAR(figures.width, width, 0.0002) << product;
    EXPECT_NEAR(figures.pslr_db, pslr_db, 0.01) << product;
  }
}

TEST(TheoreticalFigures, OfACoarselySampledChirpKnowWhatFoldsBack) {
  EXPECT_GT(theoretical_figures({}, 80.0, 1.5).width, theoretical_figures({}, 80.0).width + 0.002);
  EXPECT_NEAR(theoretical_figures({}, 80.0, 16.0).width, theoretical_figures({}, 80.0).width, 0.0005);
}

// 64 samples of each cell of 1e9 cells would take a terabyte: the figures are those of an even spectrum.
TEST(TheoreticalFigures, OfAnyChirpFitIntoMemory) {
  const ResponseFigures even = theoretical_figures({});
  for (const double time_bandwidth : {3e4, 1e6, 1e9})
    for (const double sampling : {1.25, 2.4e6}) {
      const ResponseFigures chirp = theoretical_figures({}, time_bandwidth, sampling);
      EXPECT_NEAR(chirp.width, even.width, 2e-3) << time_bandwidth << ", " << sampling;
      EXPECT_NEAR(chirp.pslr_db, even.pslr_db, 0.05) << time_bandwidth << ", " << sampling;
    }
}

TEST(FiguresOf, IsNothingForAResponseWithoutMinima) {
  EXPECT_FALSE(figures_of(std::vector<std::complex<double>>{0.1, 0.5, 1.0, 0.5, 0.1}, 2));
  EXPECT_FALSE(figures_of(std::vector<std::complex<double>>{0.1, 0.0, 0.5, 1.0, 0.5}, 3));
}

TEST(FiguresOf, CountsSidelobesOnBothSides) {
  // Powers: 1 in the middle, half of it at 1, nulls at 2, a lobe of 0.01 on the left and of 0.04 on the right.
  const double half = std::sqrt(0.5);
  const std::vector<std::complex<double>> response{0.0, 0.1, 0.0, half, 1.0, half, 0.0, 0.2, 0.0};
  const auto figures = figures_of(response, 4);
  ASSERT_TRUE(figures);
  EXPECT_NEAR(figures->width, 2.0, 1e-9);
  EXPECT_EQ(figures->null, 2.0);
  EXPECT_NEAR(figures->pslr_db, 10.0 * std::log10(0.04), 1e-9);
  EXPECT_NEAR(figures->islr_db, 10.0 * std::log10(0.05 / 2.0), 1e-9);
}

TEST(SarWindow, ReadsItsOwnText) {
  for (const char* text : {"rectangular", "hamming", "hann", "bartlett", "blackman", "kaiser:2.5", "kaiser:0",
                           "taylor:35:5", "taylor:22.5:3"}) {
    const auto window = window_from_text(text);
    ASSERT_TRUE(window) << text;
    EXPECT_EQ(to_string(*window), text);
  }
  EXPECT_EQ(window_from_text("Kaiser"), (SarWindow{.kind = SarWindow::Kind::kaiser}));
  EXPECT_EQ(window_from_text("TAYLOR"), (SarWindow{.kind = SarWindow::Kind::taylor}));
}

TEST(SarWindow, RefusesOtherTexts) {
  for (const char* text : {"", "hammings", "hann:3", "kaiser:-1", "kaiser:x", "kaiser:21", "taylor:30", "taylor:5:4",
                           "taylor:30:0", "taylor:30:31", "taylor:30:4:1"})
    EXPECT_FALSE(window_from_text(text)) << text;
}

TEST(SarWindow, IsEvenAndVanishesOutsideTheBand) {
  for (const char* text :
       {"rectangular", "hamming", "hann", "hanning", "kaiser", "taylor", "bartlett", "blackman", "none"}) {
    const auto weight = weight_of(window_from_text(text).value());
    EXPECT_EQ(weight(0.5001), 0.0) << text;
    EXPECT_NEAR(weight(-0.31), weight(0.31), 1e-12) << text;
    EXPECT_GT(weight(0.0), weight(0.49) - 1e-12) << text;
  }
}

TEST(SarWindow, KnowsItsMean) {
  EXPECT_NEAR(mean_weight(window_from_text("hamming").value()), 0.54, 1e-9);
  EXPECT_NEAR(mean_weight(window_from_text("hann").value()), 0.5, 1e-9);
  EXPECT_NEAR(mean_weight(window_from_text("taylor").value()), 1.0, 1e-9);
  EXPECT_NEAR(mean_weight(window_from_text("bartlett").value()), 0.5, 1e-9);
  EXPECT_NEAR(mean_weight(window_from_text("blackman").value()), 0.42, 1e-9);
}

TEST(TheoreticalFigures, TakeWeightsOfTheMatchedFilterLikeThoseOverTheBand) {
  const auto even = [](double) { return 1.0; };
  const ResponseFigures plain = theoretical_figures({}, 200.0, 2.0);
  const ResponseFigures same = theoretical_figures({}, 200.0, 2.0, even);
  EXPECT_NEAR(same.width, plain.width, 0.003 * plain.width);
  EXPECT_NEAR(same.pslr_db, plain.pslr_db, 0.1);
  const auto hamming = [](double x) { return 0.54 - 0.46 * std::cos(2.0 * core::pi * x); };
  const ResponseFigures tapered = theoretical_figures({}, 200.0, 2.0, hamming);
  EXPECT_NEAR(tapered.width, 1.303, 0.02);
  EXPECT_LT(tapered.pslr_db, -35.0);
}

TEST(Response, ExpectsAPeakWithinTheResponse) {
  if (!core::checks_expectations()) GTEST_SKIP() << "this build does not check expectations";
  const std::vector<std::complex<double>> response(5, 1.0);
  EXPECT_THROW(static_cast<void>(figures_of(response, 5)), core::BrokenExpectation);
}

}  // namespace response_test
}  // namespace sarsim::signal
