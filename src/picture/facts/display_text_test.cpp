#include "picture/facts/display_text.hpp"

#include <gtest/gtest.h>

#include "scene/schema/quantity.hpp"

namespace sarsim::picture {
namespace {

TEST(DisplayText, UnitsHaveTheirSigns) {
  EXPECT_EQ(display_text("5 us"), "5 µs");
  EXPECT_EQ(display_text("3 m2"), "3 m²");
  EXPECT_EQ(display_text("-2.5 cm2"), "-2.5 cm²");
  EXPECT_EQ(display_text("9.81 m/s2"), "9.81 m/s²");
  EXPECT_EQ(display_text("1 us to 2.5 us"), "1 µs to 2.5 µs");
  EXPECT_EQ(display_text("1E-06"), "1e-6");
  EXPECT_EQ(display_text("2.5E+12 Hz"), "2.5e12 Hz");
  EXPECT_EQ(display_text("1.5e0"), "1.5e0");
}

TEST(DisplayText, OtherTextStays) {
  for (const char* text :
       {"", "-", "Mast 1 us", "sim 5 m2.bin", "3 m", "10 users", "5 m2a", "12 km", "1 m2/s", "0E", "3 E5x", "m2", "us"})
    EXPECT_EQ(display_text(text), text);
}

TEST(DisplayText, ReadOutsHaveTheSignOfMinus) {
  EXPECT_EQ(read_out_text("-500 ms to 1.499 s"), "−500 ms to 1.499 s");
  EXPECT_EQ(read_out_text("-3 us"), "−3 µs");
  EXPECT_EQ(read_out_text("1E-06"), "1e−6");
  EXPECT_EQ(read_out_text("+/- 14.13 m/s"), "± 14.13 m/s");
  EXPECT_EQ(read_out_text("2026-05-01"), "2026-05-01");
}

// A field takes back what it shows.
TEST(DisplayText, WhatIsShownIsUnderstood) {
  struct Case {
    double value;
    scene::Quantity quantity;
  };
  for (const Case& c : {Case{5e-6, scene::Quantity::time}, Case{3.0, scene::Quantity::area},
                        Case{-2.5e-7, scene::Quantity::length}, Case{1e-6, scene::Quantity::number},
                        Case{9.81, scene::Quantity::acceleration}, Case{2.5e-6, scene::Quantity::voltage}}) {
    const std::string plain = scene::quantity_text(c.value, c.quantity);
    const auto of_display = scene::read_quantity(display_text(plain), c.quantity);
    const auto of_read_out = scene::read_quantity(read_out_text(plain), c.quantity);
    ASSERT_TRUE(of_display.value && of_read_out.value) << plain;
    EXPECT_EQ(*of_display.value, c.value) << plain;
    EXPECT_EQ(*of_read_out.value, c.value) << plain;
  }
}

}  // namespace
}  // namespace sarsim::picture
