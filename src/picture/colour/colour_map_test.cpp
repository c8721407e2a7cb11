#include "picture/colour/colour_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

namespace sarsim::picture {
namespace colour_map_test {

constexpr std::array sequential{ColourMap::ocean, ColourMap::ember, ColourMap::grey};
constexpr std::array diverging{ColourMap::balance, ColourMap::balance_dark};

double distance(const OkLab& p, const OkLab& q) { return std::hypot(p.lightness - q.lightness, p.a - q.a, p.b - q.b); }

double chroma(const OkLab& c) { return std::hypot(c.a, c.b); }

// What somebody without the green receptors sees (G. Machado, M. Oliveira, L. Fernandes, IEEE TVCG 15, 2009).
OkLab seen_by_deuteranope(raster::Rgb colour) {
  const auto linear = [](std::uint8_t byte) {
    const double x = byte / 255.0;
    return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
  };
  const auto byte = [](double x) {
    const double y = std::clamp(x, 0.0, 1.0);
    return static_cast<std::uint8_t>(
        std::lround(255.0 * (y <= 0.0031308 ? 12.92 * y : 1.055 * std::pow(y, 1.0 / 2.4) - 0.055)));
  };
  const double r = linear(colour.red);
  const double g = linear(colour.green);
  const double b = linear(colour.blue);
  return oklab_of({byte(0.367322 * r + 0.860646 * g - 0.227968 * b), byte(0.280085 * r + 0.672501 * g + 0.047413 * b),
                   byte(-0.011820 * r + 0.042940 * g + 0.968881 * b)});
}

// Longest over shortest distance between neighbours of `count` colours; rounding to 8 bits matters little to few.
double unevenness(const std::vector<OkLab>& colours) {
  double least = 10.0;
  double most = 0.0;
  for (std::size_t i = 1; i < colours.size(); ++i) {
    least = std::min(least, distance(colours[i - 1], colours[i]));
    most = std::max(most, distance(colours[i - 1], colours[i]));
  }
  return most / least;
}

std::vector<OkLab> colours_of(ColourMap map, std::size_t count) {
  std::vector<OkLab> colours;
  for (const raster::Rgb c : colour_table(map, {}, false, count)) colours.push_back(oklab_of(c));
  return colours;
}

TEST(OkLab, OfWhiteBlackAndRedIsThePublishedOne) {
  EXPECT_NEAR(oklab_of({255, 255, 255}).lightness, 1.0, 1e-6);
  EXPECT_NEAR(chroma(oklab_of({255, 255, 255})), 0.0, 1e-6);
  EXPECT_NEAR(oklab_of({0, 0, 0}).lightness, 0.0, 1e-9);
  const OkLab red = oklab_of({255, 0, 0});
  EXPECT_NEAR(red.lightness, 0.628, 5e-4);
  EXPECT_NEAR(red.a, 0.225, 5e-4);
  EXPECT_NEAR(red.b, 0.126, 5e-4);
}

TEST(OkLab, OfEveryFewthColourComesBack) {
  for (int r = 0; r < 256; r += 51)
    for (int g = 0; g < 256; g += 51)
      for (int b = 0; b < 256; b += 51) {
        const raster::Rgb colour{static_cast<std::uint8_t>(r), static_cast<std::uint8_t>(g),
                                 static_cast<std::uint8_t>(b)};
        EXPECT_EQ(rgb_of(oklab_of(colour)), colour);
        EXPECT_TRUE(is_displayable(oklab_of(colour)));
      }
  EXPECT_FALSE(is_displayable({0.5, 0.4, 0.0}));
}

TEST(ColourMap, OfOurOwnDesignStaysInsideWhatAScreenShows) {
  for (const ColourMapInfo& info : colour_maps()) {
    if (info.classic) continue;
    for (int i = 0; i <= 100; ++i) EXPECT_TRUE(is_displayable(colour_at(info.map, 0.01 * i))) << info.name << i;
  }
}

TEST(ColourMap, SequentialOnesGetLighterAllTheWay) {
  for (const ColourMap map : sequential) {
    const auto colours = colours_of(map, 256);
    EXPECT_GT(colours.back().lightness - colours.front().lightness, 0.7);
    for (int i = 1; i <= 200; ++i)
      EXPECT_GT(colour_at(map, 0.005 * i).lightness, colour_at(map, 0.005 * (i - 1)).lightness);
    for (std::size_t i = 4; i < 256; ++i) EXPECT_GT(colours[i].lightness, colours[i - 4].lightness) << i;
  }
}

TEST(ColourMap, StepsLookEquallyLargeEverywhere) {
  for (const ColourMapInfo& info : colour_maps()) {
    if (info.classic) continue;
    std::vector<OkLab> exact;
    // An odd number, so that a diverging map's centre, where the path turns, is one of the colours.
    for (int i = 0; i <= 256; ++i) exact.push_back(colour_at(info.map, i / 256.0));
    EXPECT_LT(unevenness(exact), 1.05) << info.name;
    EXPECT_LT(unevenness(colours_of(info.map, 17)), 1.25) << info.name;  // with rounding to 8 bits
  }
}

TEST(ColourMap, DivergingOnesAreSymmetricInLightnessAboutANeutralCentre) {
  for (const ColourMap map : diverging) {
    EXPECT_LT(chroma(colour_at(map, 0.5)), 1e-6);
    for (int i = 0; i <= 50; ++i) {
      const OkLab low = colour_at(map, 0.01 * i);
      const OkLab high = colour_at(map, 1.0 - 0.01 * i);
      EXPECT_NEAR(low.lightness, high.lightness, 1e-9);
      EXPECT_NEAR(chroma(low), chroma(high), 1e-9);
    }
    for (int i = 1; i <= 50; ++i) {
      const double towards = colour_at(map, 0.01 * i).lightness - colour_at(map, 0.01 * (i - 1)).lightness;
      EXPECT_GT(map == ColourMap::balance ? towards : -towards, 0.0);
    }
    EXPECT_GT(colour_at(map, 0.0).a, 0.05);   // red below,
    EXPECT_LT(colour_at(map, 1.0).b, -0.05);  // blue above, as in the thesis
  }
  EXPECT_GT(colour_at(ColourMap::balance, 0.5).lightness, 0.9);
  EXPECT_LT(colour_at(ColourMap::balance_dark, 0.5).lightness, 0.2);
}

TEST(ColourMap, EndsOfTheCyclicOneMeet) {
  EXPECT_LT(distance(colour_at(ColourMap::cycle, 0.0), colour_at(ColourMap::cycle, 1.0)), 1e-9);
  const auto colours = colours_of(ColourMap::cycle, 64);
  const double step = distance(colours[20], colours[21]);
  EXPECT_NEAR(distance(colours.front(), colours.back()), step, 0.2 * step);
}

TEST(ColourMap, DeuteranopesSeeTheSameOrder) {
  for (const ColourMap map : sequential) {
    const auto table = colour_table(map, {}, false, 33);
    for (std::size_t i = 1; i < table.size(); ++i)
      EXPECT_GT(seen_by_deuteranope(table[i]).lightness, seen_by_deuteranope(table[i - 1]).lightness) << i;
  }
  for (const ColourMap map : diverging) {
    const auto table = colour_table(map, {}, false, 33);
    for (std::size_t i = 0; i < 12; ++i)
      EXPECT_GT(distance(seen_by_deuteranope(table[i]), seen_by_deuteranope(table[32 - i])), 0.1) << i;
  }
}

TEST(ColourMap, DeuteranopesTellThePhasesOfTheCyclicOneApart) {
  const auto table = colour_table(ColourMap::cycle, {}, false, 16);
  for (std::size_t i = 0; i < 16; ++i)
    for (std::size_t k = 0; k < i; ++k)
      EXPECT_GT(distance(seen_by_deuteranope(table[i]), seen_by_deuteranope(table[k])), 0.04) << i << " " << k;
}

TEST(ColourMap, InvertedRunsFromTheLastToTheFirst) {
  for (const ColourMapInfo& info : colour_maps()) {
    auto table = colour_table(info.map);
    EXPECT_EQ(table.size(), info.classic ? 236U : 256U);
    std::ranges::reverse(table);
    EXPECT_EQ(colour_table(info.map, {}, true), table);
  }
}

TEST(ColourMap, NamesAreUnique) {
  for (const ColourMapInfo& a : colour_maps()) {
    EXPECT_EQ(&info_of(a.map), &a);
    for (const ColourMapInfo& b : colour_maps()) EXPECT_EQ(a.name == b.name, a.map == b.map);
  }
}

TEST(ColourMap, OfOneLevelIsRefused) {
  EXPECT_THROW((void)colour_table(ColourMap::ocean, {}, false, 1), std::invalid_argument);
}

// n = 1/(4.92e-5 127^2 + 0.2) = 1.00649, m = 0.01271 127^2 + 50 = 255.0: nearly the identity.
TEST(ClassicPalette, GreyAtTheMiddleOfTheSlidersIsNearlyProportional) {
  const auto table = colour_table(ColourMap::classic_grey);
  EXPECT_EQ(table[0], (raster::Rgb{0, 0, 0}));
  EXPECT_EQ(table[118].red, 127);  // 255.0 (1/2)^1.00649 = 126.9
  EXPECT_EQ(table[235].red, 254);  // 255.0 (235/236)^1.00649 = 253.9
}

TEST(ClassicPalette, GreyFollowsItsSliders) {
  // B = 0: n = 5; C = 255: m = 876.5; S = 255: + 128. i = 118: 876.5/32 + 128 = 155.4.
  EXPECT_EQ(colour_table(ColourMap::classic_grey, {0.0, 255.0, 255.0})[118].green, 155);
  // B = 255: n = 0.2943; C = 0: m = 50; S = 127. i = 118: 50 (1/2)^0.2943 = 40.8.
  EXPECT_EQ(colour_table(ColourMap::classic_grey, {255.0, 0.0, 127.0})[118].green, 41);
  EXPECT_EQ(colour_table(ColourMap::classic_grey, {127.0, 127.0, 0.0})[10].green, 0);
}

TEST(ClassicPalette, RedBlueIsBlackInTheMiddleRedBelowAndBlueAbove) {
  const auto table = colour_table(ColourMap::classic_red_blue);
  EXPECT_EQ(table[118], (raster::Rgb{0, 0, 0}));
  EXPECT_EQ(table[0], (raster::Rgb{255, 0, 0}));
  EXPECT_EQ(table[59], (raster::Rgb{127, 0, 0}));
  EXPECT_EQ(table[177], (raster::Rgb{0, 0, 127}));
  EXPECT_EQ(table[235].blue, 253);  // 255.0 (234/236)^1.00649 = 252.8
}

TEST(ClassicPalette, RainbowRunsFromRedThroughGreenToBlue) {
  const auto table = colour_table(ColourMap::classic_rainbow);
  // S = L = 127/256: parts from 127 (1 - S) = 63.8 to 127 (1 + S) = 189.3.
  EXPECT_EQ(table[0], (raster::Rgb{189, 64, 64}));
  EXPECT_EQ(table[118].green, 189);  // hue 0.324 of a turn
  EXPECT_EQ(table[235].blue, 189);   // hue 0.645
  EXPECT_EQ(table[118].blue, 64);
}

TEST(ClassicPalette, CustomHasOneHueFromBlackToWhite) {
  const auto table = colour_table(ColourMap::classic_custom, {0.0, 127.0, 256.0});
  EXPECT_EQ(table[0], (raster::Rgb{0, 0, 0}));
  EXPECT_EQ(table[118], (raster::Rgb{255, 0, 0}));
  EXPECT_EQ(table[177], (raster::Rgb{255, 128, 128}));
}

}  // namespace colour_map_test
}  // namespace sarsim::picture
