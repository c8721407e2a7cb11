#include "workflow/input/echo_words.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "simulate/plan/simulate_test_scene.hpp"

namespace sarsim::workflow {
namespace echo_words_test {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* left_out = "the echoes of surfaces, which interfere, are left out here";

std::string words_of(const scene::Scene& scene) {
  std::string text;
  for (const simulate::EchoSummary& summary : simulate::survey_report(scene).summaries)
    text += echo_text(scene, summary);
  return text;
}

scene::Surface plate() {
  scene::Surface surface;
  surface.platform = "Earth";
  surface.corner_m = {core::Vec3{1000.0, 0.0, 0.0}, core::Vec3{1000.0, 0.0, 3.0}, core::Vec3{1000.0, 3.0, 0.0}};
  return surface;
}

TEST(EchoText, SaysThatSurfacesAreLeftOut) {
  scene::Scene scene = simulate::one_target_scene();
  EXPECT_THAT(words_of(scene), HasSubstr("1 of 1 targets in the window\n    strongest echo"));
  scene.surfaces.push_back(plate());
  EXPECT_THAT(words_of(scene), HasSubstr(std::string("1 of 1 targets in the window\n    ") + left_out));
  EXPECT_THAT(words_of(scene), HasSubstr("strongest echo"));
  scene.targets.clear();
  EXPECT_THAT(words_of(scene), HasSubstr(std::string("): ") + left_out));
  EXPECT_THAT(words_of(scene), Not(HasSubstr("targets in the window")));
}

}  // namespace echo_words_test
}  // namespace sarsim::workflow
