#include "workflow/sweep/random_values.hpp"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>

#include "core/text/number_text.hpp"
#include "scene/schema/field_names.hpp"

namespace sarsim::workflow {
namespace random_values_test {

using testing::HasSubstr;

const scene::Field& field_called(const char* name) {
  scene::Scene scene;
  scene.radars.resize(1);
  scene.targets.resize(1);
  scene.simulations.resize(1);
  return *scene::find_named_field(scene, name, "0").field;
}

std::vector<double> draws(const char* law, std::size_t count, std::uint64_t seed = 1, const char* key = "a") {
  std::vector<double> values;
  const scene::ValueList list = draw_values(law, field_called("Target1.rcs"), count, seed, key);
  EXPECT_EQ(list.failure, "");
  for (const std::string& text : list.texts)
    values.push_back(scene::read_quantity(text, scene::Quantity::area).value.value());
  return values;
}

double mean_of(const std::vector<double>& values, int power = 1) {
  double sum = 0.0;
  for (const double value : values) sum += std::pow(value, power);
  return sum / static_cast<double>(values.size());
}

// The mean of n draws lies within 5 standard deviations of it, sigma/sqrt(n), and so does their variance,
// sigma^2 sqrt(2/n) of normal ones.
TEST(RandomValues, FollowTheirLaws) {
  constexpr std::size_t n = 20000;
  const double five = 5.0 / std::sqrt(static_cast<double>(n));
  const std::vector<double> normal = draws("normal(3, 0.2)", n);
  EXPECT_NEAR(mean_of(normal), 3.0, 0.2 * five);
  EXPECT_NEAR(mean_of(normal, 2) - std::pow(mean_of(normal), 2), 0.04, 0.04 * std::sqrt(2.0) * five);
  const std::vector<double> uniform = draws("uniform(2, 5)", n);
  EXPECT_NEAR(mean_of(uniform), 3.5, std::sqrt(9.0 / 12.0) * five);
  EXPECT_NEAR(mean_of(uniform, 2), (125.0 - 8.0) / 9.0, std::sqrt(43.4) * five);  // Variance of the square: 43.4.
  EXPECT_GE(*std::ranges::min_element(uniform), 2.0);
  EXPECT_LE(*std::ranges::max_element(uniform), 5.0);
  const std::vector<double> exponential = draws("exponential(2)", n);
  EXPECT_NEAR(mean_of(exponential), 2.0, 2.0 * five);
  EXPECT_NEAR(mean_of(exponential, 2), 8.0, 4.0 * std::sqrt(20.0) * five);
  EXPECT_GT(*std::ranges::min_element(exponential), 0.0);
}

TEST(RandomValues, DependOnSeedFieldAndNumberAlone) {
  const std::vector<double> few = draws("normal(3, 0.2)", 3);
  std::vector<double> many = draws("normal(3, 0.2)", 30);
  many.resize(3);
  EXPECT_EQ(many, few);
  EXPECT_NE(draws("normal(3, 0.2)", 3, 2), few);
  EXPECT_NE(draws("normal(3, 0.2)", 3, 1, "b"), few);
  EXPECT_EQ(draws("normal(4, 0)", 2), (std::vector<double>{4.0, 4.0}));
}

TEST(RandomValues, AreInTheUnitsOfTheirNumbers) {
  const auto texts = [](const char* law, const char* field) {
    return draw_values(law, field_called(field), 1, 1, "a");
  };
  EXPECT_THAT(texts("normal(5, 0.1GHz)", "Radar1.bandwidth").texts.front(), testing::EndsWith("GHz"));
  EXPECT_THAT(texts("normal(10dBsm, 2dBsm)", "Target1.rcs").texts.front(), testing::EndsWith("dBsm"));
  const double mixed_hz =
      core::parse_number(texts("uniform(1MHz, 1.001e6Hz)", "Radar1.bandwidth").texts.front()).value();
  EXPECT_GE(mixed_hz, 1e6);
  EXPECT_LE(mixed_hz, 1.001e6);
  for (int i = 0; i < 20; ++i) {
    const std::string bits =
        draw_values("uniform(1, 16)", field_called("Simulation1.bits"), 20, 1, "a").texts[static_cast<std::size_t>(i)];
    EXPECT_TRUE(core::parse_integer(bits)) << bits;
  }
}

TEST(RandomValues, AreRefusedInWords) {
  const auto failure = [](const char* law, const char* field = "Target1.rcs") {
    return draw_values(law, field_called(field), 2, 1, "a").failure;
  };
  EXPECT_TRUE(is_random(" normal (1,2)"));
  for (const char* text : {"normal", "Hamming", "1", "normall(1,2)", "(1)"}) EXPECT_FALSE(is_random(text)) << text;
  for (const char* text : {"normal(1)", "normal(1,2", "normal()", "uniform(1,2,3)", "exponential(1,2)"})
    EXPECT_THAT(failure(text), HasSubstr("expected ")) << text;
  EXPECT_THAT(failure("normal(1, x)"), HasSubstr("'x'"));
  EXPECT_THAT(draw_values("normal(1e308, 1e308)", field_called("Target1.rcs"), 100, 1, "a").failure,
              HasSubstr("too large"));
  EXPECT_THAT(failure("normal(1, -2)"), HasSubstr("is negative"));
  EXPECT_THAT(failure("uniform(2, 1)"), HasSubstr("above the highest"));
  EXPECT_THAT(failure("uniform(10dBsm, 12m2)"), HasSubstr("decibels"));
  EXPECT_THAT(failure("normal(1, 2)", "Radar1.window"), HasSubstr("not a number"));
}

}  // namespace random_values_test
}  // namespace sarsim::workflow
