#include "picture/colour/theme.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "core/maths/vector.hpp"

namespace sarsim::picture {
namespace theme_test {

double linear(std::uint8_t channel) {
  const double value = channel / 255.0;
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

// CIE L*a*b* of linear sRGB.
core::Vec3 lab(const core::Vec3& rgb) {
  const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116.0; };
  const double x = f((0.4124 * rgb.x + 0.3576 * rgb.y + 0.1805 * rgb.z) / 0.9505);
  const double y = f(0.2126 * rgb.x + 0.7152 * rgb.y + 0.0722 * rgb.z);
  const double z = f((0.0193 * rgb.x + 0.1192 * rgb.y + 0.9505 * rgb.z) / 1.089);
  return {116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)};
}

// What people without red or without green cones see of a colour (Machado, Oliveira and Fernandes 2009, severity 1).
const std::array<core::Mat3, 3> eyes{
    core::Mat3{},
    core::Mat3{{core::Vec3{0.152286, 1.052583, -0.204868}, core::Vec3{0.114503, 0.786281, 0.099216},
                core::Vec3{-0.003882, -0.048116, 1.051998}}},
    core::Mat3{{core::Vec3{0.367322, 0.860646, -0.227968}, core::Vec3{0.280085, 0.672501, 0.047413},
                core::Vec3{-0.011820, 0.042940, 0.968881}}}};

double difference(raster::Rgb a, raster::Rgb b, const core::Mat3& eye) {
  const auto seen = [&](raster::Rgb c) {
    const core::Vec3 v = eye * core::Vec3{linear(c.red), linear(c.green), linear(c.blue)};
    return lab({std::clamp(v.x, 0.0, 1.0), std::clamp(v.y, 0.0, 1.0), std::clamp(v.z, 0.0, 1.0)});
  };
  return core::norm(seen(a) - seen(b));
}

TEST(Theme, ContrastOfBlackAndWhiteIs21) {
  EXPECT_NEAR(contrast({0, 0, 0}, {255, 255, 255}), 21.0, 1e-12);
  EXPECT_NEAR(contrast({255, 255, 255}, {0, 0, 0}), 21.0, 1e-12);
  EXPECT_DOUBLE_EQ(contrast({9, 99, 199}, {9, 99, 199}), 1.0);
  // Grey of relative luminance ((118/255 + 0.055)/1.055)^2.4 against white.
  EXPECT_NEAR(contrast({118, 118, 118}, {255, 255, 255}), 1.05 / (std::pow((118.0 / 255 + 0.055) / 1.055, 2.4) + 0.05),
              1e-12);
}

TEST(Theme, MarksAreReadableOnTheOtherGroundsToo) {
  for (const bool dark : {false, true})
    for (const Role ground : {Role::sky, Role::globe})
      for (const Role role : {Role::text, Role::x_axis, Role::y_axis, Role::z_axis, Role::target, Role::radar,
                              Role::beam, Role::platform, Role::selected, Role::hovered})
        EXPECT_GE(contrast(colour(role, dark), colour(ground, dark)), 3.5) << static_cast<int>(role) << dark;
}

TEST(Theme, TonesOfTracksAreReadableAndChangeSteadily) {
  for (const bool dark : {false, true})
    for (int i = 0; i <= 20; ++i) {
      EXPECT_GE(contrast(track_colour(i / 20.0, dark), colour(Role::background, dark)), 3.0) << i << dark;
      if (i > 0) {
        EXPECT_GT(difference(track_colour(i / 20.0, dark), track_colour((i - 1) / 20.0, dark), eyes[0]), 1.0) << i;
      }
    }
}

TEST(Theme, EveryRoleIsReadableOnBothBackgrounds) {
  for (const bool dark : {false, true}) {
    const raster::Rgb background = colour(Role::background, dark);
    for (int i = 1; i < static_cast<int>(Role::count); ++i) {
      const Role role = static_cast<Role>(i);
      if (role == Role::sky || role == Role::globe) continue;
      const double least = role == Role::solid || role == Role::track ? 3.0
                           : role == Role::faint                      ? 1.5
                           : role == Role::surface                    ? 1.2
                                                                      : 4.5;
      EXPECT_GE(contrast(colour(role, dark), background), least) << "role " << i << (dark ? " dark" : " light");
    }
  }
}

TEST(Theme, SurfacesOfEveryShadeStandOutFromTheGroundAndGrowBrighterWithIt) {
  for (const bool dark : {false, true}) {
    for (int shade = 0; shade <= 255; ++shade) {
      const raster::Rgb fill = surface_fill(static_cast<std::uint8_t>(shade), dark);
      EXPECT_GE(contrast(fill, colour(Role::background, dark)), 1.2) << shade;
      EXPECT_GE(fill.red, surface_fill(static_cast<std::uint8_t>(std::max(shade - 1, 0)), dark).red) << shade;
    }
    EXPECT_GT(surface_fill(255, dark).red, surface_fill(0, dark).red + 100);
  }
}

TEST(Theme, FaintIsFainterThanText) {
  for (const bool dark : {false, true}) {
    const raster::Rgb background = colour(Role::background, dark);
    EXPECT_LT(contrast(colour(Role::faint, dark), background), contrast(colour(Role::text, dark), background) / 3.0);
  }
}

// A difference of 20 in L*a*b* is seen at a glance; 2.3 is just noticeable.
TEST(Theme, ColoursThatAreToldApartStayApartForColourBlindEyes) {
  const std::vector<std::vector<Role>> groups{{Role::x_axis, Role::y_axis, Role::z_axis},
                                              {Role::curve, Role::curve_2, Role::curve_3, Role::curve_4, Role::curve_5},
                                              {Role::target, Role::selected, Role::radar}};
  for (const bool dark : {false, true})
    for (const core::Mat3& eye : eyes)
      for (const auto& group : groups)
        for (std::size_t i = 0; i < group.size(); ++i)
          for (std::size_t j = 0; j < i; ++j)
            EXPECT_GT(difference(colour(group[i], dark), colour(group[j], dark), eye), 20.0)
                << "roles " << static_cast<int>(group[i]) << " and " << static_cast<int>(group[j])
                << (dark ? " dark" : " light");
}

TEST(Theme, AxesAreRedGreenAndBlue) {
  for (const bool dark : {false, true}) {
    const raster::Rgb x = colour(Role::x_axis, dark);
    const raster::Rgb y = colour(Role::y_axis, dark);
    const raster::Rgb z = colour(Role::z_axis, dark);
    EXPECT_GT(x.red, std::max(x.green, x.blue));
    EXPECT_GT(y.green, std::max(y.red, y.blue));
    EXPECT_GT(z.blue, std::max(z.red, z.green));
  }
}

}  // namespace theme_test
}  // namespace sarsim::picture
