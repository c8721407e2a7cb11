#include "core/maths/window_labels.hpp"

#include <gtest/gtest.h>

namespace sarsim::core {

TEST(WindowWord, IsOneForAllSpellings) {
  for (const char* const word : {"hann", "HANNING", "von-Hann"}) EXPECT_EQ(window_word(word), "hann");
  for (const char* const word : {"none", "rect", "rectwin", "uniform", "BOXCAR"})
    EXPECT_EQ(window_word(word), "rectangular");
  for (const char* const word : {"triangular", "triang", "Bartlett"}) EXPECT_EQ(window_word(word), "bartlett");
  EXPECT_EQ(window_word("taylorwin"), "taylor");
  EXPECT_EQ(window_word("chebwin"), "chebwin");
  EXPECT_EQ(window_word(""), "");
}

}  // namespace sarsim::core
