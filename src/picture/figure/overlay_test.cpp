#include "picture/figure/overlay.hpp"

#include <gmock/gmock.h>

#include <set>

namespace sarsim::picture {
namespace overlay_test {

Figure figure_of(double first_y, double last_y, std::vector<double> y) {
  FigurePanel panel;
  panel.title = "At 0 s";
  panel.x = {"Slant range", "m", 0.0, 10.0, {}};
  panel.y = {"Level", "dB", first_y, last_y, {}};
  panel.curves = {{"", Role::curve, false, {0.0, 10.0}, std::move(y)}};
  return {"", "highest 3 V", {panel}};
}

TEST(Overlaid, HasEveryCurveWithItsNameAndAColourOfItsOwn) {
  const std::vector<OverlaidFigure> figures{{"RECT", figure_of(-60.0, 0.0, {-60.0, 0.0})},
                                            {"HAMMING", figure_of(-80.0, -5.0, {-80.0, -5.0})}};
  const auto both = overlaid(figures);
  ASSERT_TRUE(both);
  ASSERT_EQ(both->panels.size(), 1U);
  const FigurePanel& panel = both->panels[0];
  ASSERT_EQ(panel.curves.size(), 2U);
  EXPECT_EQ(panel.curves[0].name, "RECT");
  EXPECT_EQ(panel.curves[1].name, "HAMMING");
  EXPECT_NE(panel.curves[0].role, panel.curves[1].role);
  EXPECT_EQ(panel.curves[1].y, (std::vector<double>{-80.0, -5.0}));
  EXPECT_EQ(panel.y.first, -80.0);
  EXPECT_EQ(panel.y.last, 0.0);
  EXPECT_EQ(panel.title, "At 0 s");
  EXPECT_EQ(both->note, "");
}

TEST(Overlaid, KeepsTheDirectionOfAnAxis) {
  Figure first = figure_of(0.0, 1.0, {0.0, 1.0});
  first.panels[0].x = {"Slant range", "m", 10.0, 0.0, {}};
  Figure second = figure_of(0.0, 1.0, {0.0, 1.0});
  second.panels[0].x = {"Slant range", "m", 5.0, 20.0, {}};
  const std::vector<OverlaidFigure> figures{{"a", first}, {"b", second}};
  const auto both = overlaid(figures);
  ASSERT_TRUE(both);
  EXPECT_EQ(both->panels[0].x.first, 20.0);
  EXPECT_EQ(both->panels[0].x.last, 0.0);
}

TEST(Overlaid, IsNothingWhereFiguresShowDifferentThings) {
  const Figure plain = figure_of(0.0, 1.0, {0.0, 1.0});
  Figure volts = plain;
  volts.panels[0].y.unit = "V";
  Figure image = plain;
  image.panels[0].image.emplace();
  Figure bars = plain;
  bars.panels[0].curves[0].bars = true;
  Figure two = plain;
  two.panels.push_back(plain.panels[0]);
  for (const Figure& other : {volts, image, bars, two}) {
    const std::vector<OverlaidFigure> figures{{"a", plain}, {"b", other}};
    EXPECT_FALSE(overlaid(figures));
  }
  const std::vector<OverlaidFigure> many(max_overlaid_curves + 1, {"a", plain});
  EXPECT_FALSE(overlaid(many));
  EXPECT_TRUE(overlaid(std::span(many).first(max_overlaid_curves)));
}

}  // namespace overlay_test
}  // namespace sarsim::picture
