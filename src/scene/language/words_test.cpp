#include "scene/language/words.hpp"

#include <gtest/gtest.h>

namespace sarsim::scene {

TEST(WordsOfFormat2, ReplaceThoseOfTheLanguageOf1998) {
  EXPECT_EQ(in_format_2("add a $SIMULATION or a $GEOMETRY"), "add a [[recording]] or a [[geometry]]");
  EXPECT_EQ(in_format_2("Set CUBIC_ENDS NOT_A_KNOT in $OPTIONS."), "Set cubic_ends = \"not-a-knot\" in [options].");
  EXPECT_EQ(in_format_2("PULSE BAND_LIMITED in $OPTIONS"), "pulse = \"band-limited\" in [options]");
  EXPECT_EQ(in_format_2("AMBIGUOUS_ECHOES STRONG or ALL in $OPTIONS adds them"),
            "ambiguous_echoes = \"strong\" or \"all\" in [options] adds them");
  EXPECT_EQ(in_format_2("no word of either"), "no word of either");
}

TEST(WordsOfFormat2, WhatWasFoundStaysAsItIs) {
  core::Problems problems{core::error("$RADAR").found("$RADAR").expected("$RADAR").hint("$RADAR")};
  say_in_format_2(problems);
  EXPECT_EQ(problems[0].message, "[[radar]]");
  EXPECT_EQ(problems[0].found, "$RADAR");
}

}  // namespace sarsim::scene
