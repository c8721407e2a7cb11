#include "workflow/input/scene_input.hpp"

#include <gtest/gtest.h>

#include <string>

#include <fmt/format.h>

#include "workflow/convert/convert_scene.hpp"

namespace sarsim::workflow {
namespace scene_input_test {
namespace {

std::string said(const std::string& text, const std::string& name = "scene.toml",
                 const SceneOverrides& overrides = {}) {
  std::string all;
  for (const core::Problem& problem : read_scene_text(text, name, overrides, CheckLevel::echoes).problems)
    all += core::to_string(problem) + "\n";
  return all;
}

std::size_t count(const std::string& text, std::string_view word) {
  std::size_t found = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++found;
  return found;
}

// 10 kHz: 14.99 km are unambiguous.
std::string scene_with_target_at(double range_m, const std::string& more = "") {
  return fmt::format(R"(format = "sarsim 2"
[[target]]
position = [0, {:.0f}, 0]
[[radar]]
name = "R"
pulse = "1 us"
repetition = "10 kHz"
carrier = "1 GHz"
{}
[[recording]]
radar = "R"
file = "r.h5"
format = "hdf5"
range = ["4 km", "25 km"]
time = ["0 s", "0 s"]
sample_rate = "24 MHz"
)",
                     range_m, more);
}

// The window alone where no target is late; targets, and what rows hold of them, where some are.
TEST(SceneInput, TellsOnceOfRangesBeyondTheUnambiguous) {
  const std::string window = said(scene_with_target_at(12e3));
  EXPECT_EQ(count(window, "the slant range window reaches beyond the unambiguous range"), 1U) << window;
  EXPECT_EQ(count(window, "unambiguous"), 1U) << window;
  const std::string late = said(scene_with_target_at(20e3));
  EXPECT_EQ(count(late, "unambiguous"), 1U) << late;
  EXPECT_EQ(
      count(
          late,
          "echoes of 1 of 1 targets arrive after the next pulse has left: rows also contain range-ambiguous echoes of"),
      1U)
      << late;
  EXPECT_EQ(count(late, "real receiver"), 0U) << late;
}

constexpr const char* lopsided =
    R"(antenna = { type = "points", azimuth = { points = [[0, 0]] }, elevation = { points = [[-90, -40], [-2, -3], [0, -6], [90, -40]] } })";

// Of a script of 1998 always, of format 2 where the profile is that of 1998.
TEST(SceneInput, TellsOfProfilesThatReadTablesDifferently) {
  std::string text = scene_with_target_at(10e3, lopsided);
  const std::string level = "[0, 10000, 0]";
  text.replace(text.find(level), level.size(), "[0, 10000, -2000]");
  constexpr std::string_view words =
      "the profiles classic and physical read the antenna's cuts differently: 1 of 1 target";
  EXPECT_EQ(count(said(text), words), 0U);
  SceneOverrides classic;
  classic.profile = scene::Profile::classic;
  EXPECT_EQ(count(said(text, "scene.toml", classic), words), 1U);
  const std::string script =
      scene_text(read_scene_text(text, "scene.toml", {}, CheckLevel::values), scene::Language::script);
  EXPECT_EQ(count(said(script, "scene.scr"), words), 1U) << script;
  EXPECT_EQ(count(said(script, "scene.scr", classic), "warning: " + std::string(words)), 1U);
}

}  // namespace
}  // namespace scene_input_test
}  // namespace sarsim::workflow
