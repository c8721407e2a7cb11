#include "cli/command/measure_cuts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/maths/constants.hpp"

namespace sarsim::cli {
namespace measure_cuts_test {

// sinc(x/null_m), 32 values to a metre.
signal::ResponseCut sinc_cut(double null_m) {
  signal::ResponseCut cut{1.0 / 32.0, {}};
  for (int i = -1000; i <= 1000; ++i) {
    const double x = core::pi * i * cut.step_m / null_m;
    cut.values.push_back(5.0 * (i == 0 ? 1.0 : std::sin(x) / x));
  }
  return cut;
}

TEST(FigureOfCuts, ShowsDecibelsBelowThePeakAndWhatTheoryHas) {
  const signal::PointCuts cuts{sinc_cut(0.5), sinc_cut(2.0)};
  signal::PointResponse found;
  found.azimuth = {0.443, 0.5, -13.26, -10.0};
  found.range = {1.772, 2.0, -13.26, -10.0};
  const signal::ResponseFigures theory{0.44, 0.5, -13.3, -10.1};
  const picture::Figure figure = figure_of_cuts(cuts, found, theory, std::nullopt);
  ASSERT_EQ(figure.panels.size(), 2U);
  const picture::FigurePanel& azimuth = figure.panels[0];
  ASSERT_EQ(azimuth.curves.size(), 3U);
  const picture::FigureCurve& image = azimuth.curves[0];
  const auto peak = std::ranges::max_element(image.y) - image.y.begin();
  EXPECT_NEAR(image.y[static_cast<std::size_t>(peak)], 0.0, 1e-9);
  EXPECT_NEAR(image.x[static_cast<std::size_t>(peak)], 0.0, 1e-9);
  // As far as sidelobes are counted: ten null distances beyond the first.
  EXPECT_NEAR(image.x.back(), 5.5, 0.05);
  EXPECT_NEAR(azimuth.curves[1].y[0], -3.01, 0.01);
  EXPECT_NEAR(azimuth.curves[1].x[1] - azimuth.curves[1].x[0], 0.44, 1e-12);
  EXPECT_NEAR(azimuth.curves[2].y[0], -13.3, 1e-12);
  EXPECT_NE(azimuth.curves[1].role, image.role);
  EXPECT_NE(azimuth.curves[2].role, azimuth.curves[1].role);
  // Without theory there is the image alone.
  EXPECT_EQ(figure.panels[1].curves.size(), 1U);
}

}  // namespace measure_cuts_test
}  // namespace sarsim::cli
