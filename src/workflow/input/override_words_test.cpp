#include "workflow/input/override_words.hpp"

#include <gmock/gmock.h>

#include "core/report/invalid_request.hpp"

namespace sarsim::workflow::override_words_test {

TEST(OverrideWords, LeadBackToTheSameOverrides) {
  SceneOverrides overrides;
  EXPECT_EQ(words_of_overrides(overrides), "");
  overrides.profile = scene::Profile::classic;
  overrides.pulse = scene::PulseDefinition::ideal;
  overrides.tolerance = 1e-7;
  overrides.seed = UINT64_MAX;
  overrides.targets = {"a b.csv", "Ship=c.csv"};
  overrides.settings = {"Radar1.bandwidth=10MHz", "Platform1.name=it's \"here\"", "Target1.x=-3 km"};
  const std::string line = words_of_overrides(overrides);
  EXPECT_THAT(line, testing::StartsWith("--profile classic --pulse ideal --tolerance 1E-07 --seed "));
  const SceneOverrides read = overrides_from_words(line);
  EXPECT_EQ(read.profile, overrides.profile);
  EXPECT_EQ(read.pulse, overrides.pulse);
  EXPECT_EQ(read.tolerance, overrides.tolerance);
  EXPECT_EQ(read.seed, overrides.seed);
  EXPECT_EQ(read.settings, overrides.settings);
  EXPECT_EQ(read.targets, overrides.targets);
}

TEST(OverrideWords, AreNothingElse) {
  for (const char* line : {"--out x", "--seed -1", "--pulse square", "--set", "'"})
    EXPECT_THROW(static_cast<void>(overrides_from_words(line)), core::InvalidRequest) << line;
}

}  // namespace sarsim::workflow::override_words_test
