#include "picture/figure/figure.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace sarsim::picture {
namespace figure_test {

Figure rich_figure() {
  Figure figure{"Raw return", "highest magnitude 41 pV", {}};
  FigurePanel& panel = figure.panels.emplace_back();
  panel.title = "Magnitude";
  panel.x = {"Slant range", "m", 9000.0, 11000.0, FigureAxis::Twin{"Delay", "s", 6.67e-9}};
  panel.y = {"Time", "s", 1.0, -1.0, {}};
  panel.image = FigureImage{2, 1, 9000.0, 11000.0, -1.0, 1.0, {{1, 2, 3}, {250, 251, 252}}};
  panel.colour_bar = FigureColourBar{"Magnitude", "V", 0.0, 1e-9, {{0, 0, 0}, {255, 255, 255}}};
  panel.curves.push_back({"I", Role::curve_2, true, {1.0, 2.0}, {-1.0, 5e300}});
  panel.marks.push_back({9500.0, 0.0, "peak"});
  figure.panels.emplace_back();
  return figure;
}

std::string reason_of(std::string_view bytes) {
  try {
    static_cast<void>(figure_from(bytes));
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(Figure, ComesBackFromItsBytesAsItWas) {
  EXPECT_EQ(figure_from(figure_bytes(rich_figure())), rich_figure());
  EXPECT_EQ(figure_from(figure_bytes({})), Figure());
}

TEST(Figure, CutShortAnywhereIsRefused) {
  const std::string bytes = figure_bytes(rich_figure());
  for (std::size_t length = 0; length < bytes.size(); ++length)
    EXPECT_NE(reason_of(std::string_view(bytes).substr(0, length)), "") << length;
}

TEST(Figure, WithBytesBehindItsEndIsRefused) {
  EXPECT_EQ(reason_of(figure_bytes(rich_figure()) + "x"), "the figure has bytes behind its end");
}

TEST(Figure, OfAnotherLayoutIsRefused) {
  std::string bytes = figure_bytes(rich_figure());
  bytes[14] = '2';
  EXPECT_EQ(reason_of(bytes), "these are not the bytes of a figure of this program");
}

TEST(Figure, ThatClaimsMoreThanThereIsTakesNoMemoryForIt) {
  std::string bytes = figure_bytes({});
  for (std::size_t i = bytes.size() - 8; i < bytes.size(); ++i) bytes[i] = '\x7f';  // panels
  EXPECT_EQ(reason_of(bytes), "the figure is cut short");
}

TEST(Figure, WhoseImageIsNotFilledIsRefused) {
  Figure figure = rich_figure();
  figure.panels[0].image->cells.pop_back();
  EXPECT_EQ(reason_of(figure_bytes(figure)), "the figure has an image whose cells do not fill it");
}

TEST(Figure, WhoseCurveHasMoreOfOneListIsRefused) {
  Figure figure = rich_figure();
  figure.panels[0].curves[0].y.pop_back();
  EXPECT_EQ(reason_of(figure_bytes(figure)), "the figure has a curve of unequal lists");
}

TEST(Figure, WithAColourBarOfOneColourIsRefused) {
  Figure figure = rich_figure();
  figure.panels[0].colour_bar->colours.pop_back();
  EXPECT_EQ(reason_of(figure_bytes(figure)), "the figure has a colour bar without colours");
}

}  // namespace figure_test
}  // namespace sarsim::picture
