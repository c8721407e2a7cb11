// Reading must take processor time linear in the text: generous bounds that a quadratic step would break by far.

#include <gtest/gtest.h>

#include <functional>

#include "scene/script/reader.hpp"
#include "support/processor_time.hpp"

namespace sarsim::scene {

namespace speed_test {

// About ten times what an optimised build takes on one slow core; sanitizers and debug builds stay within it too.
constexpr double allowed_seconds_for_20_mb = 20.0;
constexpr std::size_t text_bytes = 20'000'000;

double seconds_of(const std::function<void()>& work) {
  const sarsim::test::ProcessorTime time;
  work();
  return time.seconds();
}

TEST(ReadingSpeed, IsLinearInTheNumberOfTargets) {
  std::string text;
  std::size_t count = 0;
  for (; text.size() < text_bytes; ++count)
    text += "$TARGET Earth " + std::to_string(count) + ".25 -17.5 0.001 0 0 0 1 0 ISOTROPIC ! t\n";
  ScriptReading reading;
  EXPECT_LT(seconds_of([&] { reading = read_script(text, "t.scr", {}); }), allowed_seconds_for_20_mb);
  EXPECT_TRUE(reading.problems.empty());
  EXPECT_EQ(reading.scene.targets.size(), count);
  EXPECT_EQ(reading.places.find({"target", count - 1, "rcs_m2"}).line, count);
}

TEST(ReadingSpeed, IsLinearInThePointsOfAFunction) {
  std::string points;
  std::size_t count = 0;
  for (; points.size() < text_bytes; ++count) points += std::to_string(count) + ".5 -1234.5678\n";
  const std::string text = std::to_string(count) + "\n" + points;
  DataFileReading reading;
  EXPECT_LT(seconds_of([&] { reading = read_data_file(text, "p.dat", function_blocks::target_gain); }),
            allowed_seconds_for_20_mb);
  EXPECT_TRUE(reading.problems.empty());
  EXPECT_EQ(reading.functions[0].size(), count);
}

TEST(ReadingSpeed, IsLinearInNonsense) {
  std::string nonsense = "$TARGET E 0 0 0 0 0 0 1 0 ISO ";
  while (nonsense.size() < text_bytes) nonsense += "x1 \"y ! z\n";
  ScriptReading reading;
  EXPECT_LT(seconds_of([&] { reading = read_script(nonsense, "t.scr", {}); }), allowed_seconds_for_20_mb);
  EXPECT_LE(reading.problems.size(), 2010U);
}

}  // namespace speed_test
}  // namespace sarsim::scene
