#include "workflow/record/scene_plan.hpp"

#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/report/invalid_request.hpp"
#include "simulate/plan/flight_test_scene.hpp"
#include "workflow/record/record.hpp"

namespace sarsim::workflow {
namespace scene_plan_test {

namespace fs = std::filesystem;

SceneInput flight_input() {
  SceneInput input;
  input.scene = simulate::flight_scene();
  input.scene.simulations = {simulate::flight_recording(1e-9, scene::FileFormat::npy)};
  input.scene.simulations.front().file = "sim.npy";
  input.sources = {"scene.toml"};
  return input;
}

std::string bytes_of_file(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

class ScenePlanTest : public testing::Test {
 protected:
  ScenePlanTest() { fs::create_directories(folder_); }
  ~ScenePlanTest() override { fs::remove_all(folder_); }

  fs::path folder_ = fs::temp_directory_path() /
                     (std::string("scene-plan-") + testing::UnitTest::GetInstance()->current_test_info()->name());
};

TEST_F(ScenePlanTest, RowsInMemoryAreThoseOfTheFileOfARun) {
  const ScenePlan planned = plan_of_scene(flight_input(), 0, {});
  std::vector<std::complex<float>> samples(planned.plan.acquisition.timing.rows *
                                           planned.plan.acquisition.reception.columns);
  for (std::size_t first = 0; first < planned.plan.acquisition.timing.rows; first += 3) {
    const std::size_t count = std::min<std::size_t>(3, planned.plan.acquisition.timing.rows - first);
    record_rows(planned, {first, count},
                std::span(samples).subspan(first * planned.plan.acquisition.reception.columns,
                                           count * planned.plan.acquisition.reception.columns),
                2, {});
  }
  RecordRequest request;
  request.scene = flight_input().scene;
  request.folder = folder_ / "run";
  static_cast<void>(record(request, {}));
  const std::string made = bytes_of_file(folder_ / "run" / "sim.npy");
  const std::size_t bytes = samples.size() * sizeof samples[0];
  ASSERT_GT(made.size(), bytes);
  EXPECT_EQ(std::memcmp(made.data() + made.size() - bytes, samples.data(), bytes), 0);
  static_cast<void>(record_file(planned, folder_ / "own.npy", {}, {}, 1, {}));
  EXPECT_EQ(bytes_of_file(folder_ / "own.npy"), made);
}

TEST_F(ScenePlanTest, AFileIsOfTheFormatThatIsAskedForAndReplacesNothingUnasked) {
  const ScenePlan planned = plan_of_scene(flight_input(), 0, {});
  static_cast<void>(record_file(planned, folder_ / "a.dat", scene::FileFormat::csv, {}, 1, {}));
  EXPECT_THAT(bytes_of_file(folder_ / "a.dat"), testing::ContainsRegex("^[0-9]+,[0-9]+,"));
  try {
    static_cast<void>(record_file(planned, folder_ / "a.dat", {}, {}, 1, {}));
    FAIL() << "it was replaced";
  } catch (const core::InvalidRequest& refused) {
    ASSERT_EQ(refused.problems.size(), 1U);
    EXPECT_EQ(refused.problems.front().message, "the file exists already");
    EXPECT_THAT(refused.problems.front().hint, testing::Not(testing::HasSubstr("--")));
  }
  static_cast<void>(record_file(planned, folder_ / "a.dat", {}, {.replace = true}, 1, {}));
  EXPECT_THAT(bytes_of_file(folder_ / "a.dat"), testing::HasSubstr("NUMPY"));
}

TEST_F(ScenePlanTest, MistakesOfOtherRecordingsDoNotMatter) {
  SceneInput input = flight_input();
  input.scene.simulations.push_back(input.scene.simulations.front());
  input.scene.simulations.back().bits = 99;
  EXPECT_GT(plan_of_scene(input, 0, {}).plan.acquisition.timing.rows, 0U);
  EXPECT_THROW(static_cast<void>(plan_of_scene(input, 1, {})), core::InvalidRequest);
  EXPECT_THROW(static_cast<void>(plan_of_scene(input, 2, {})), core::InvalidRequest);
}

TEST(SceneText, IsReadAsItsFileWouldBeAndCheckedAgainWithItsPlaces) {
  const std::string text =
      "format = \"sarsim 2\"\n[[platform]]\nname = \"A\"\n[[radar]]\nname = \"R\"\nplatform = \"A\"\n";
  SceneInput input = read_scene_text(text, "some/where.toml", {}, CheckLevel::reading);
  EXPECT_TRUE(input.problems.empty());
  EXPECT_EQ(input.language, scene::Language::format_2);
  EXPECT_EQ(input.sources.front(), fs::path("some/where.toml"));
  EXPECT_TRUE(set_field_value(input, "R.power", "2 kW").empty());
  EXPECT_EQ(field_value(input, "R.power"), "2 kW");
  EXPECT_THROW(static_cast<void>(set_field_value(input, "R.power", "much")), core::InvalidRequest);
  EXPECT_EQ(field_value(input, "R.power"), "2 kW");
  EXPECT_THROW(static_cast<void>(field_value(input, "R.powr")), core::InvalidRequest);
  static_cast<void>(set_field_value(input, "R.platform", "B"));
  const SceneInput again = check_again(input, CheckLevel::values);
  ASSERT_TRUE(core::has_errors(again.problems));
  EXPECT_EQ(again.problems.front().place, (core::Place{"some/where.toml", 6, 12}));
}

}  // namespace scene_plan_test
}  // namespace sarsim::workflow
