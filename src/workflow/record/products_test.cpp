#include "workflow/record/products.hpp"

#include <gtest/gtest.h>

#include "core/report/invalid_request.hpp"

namespace sarsim::workflow {
namespace products_test {

scene::Scene three_products() {
  scene::Scene scene;
  scene.simulations.resize(2);
  scene.simulations[0].file = "first.asc";
  scene.simulations[1].file = "c:\\old\\second.asc";
  scene.geometries.resize(1);
  scene.geometries[0].file = "table.txt";
  return scene;
}

std::vector<ProductJob> chosen(const std::vector<std::string>& words) {
  const scene::Scene scene = three_products();
  return chosen_products(scene, output_names(scene, {}), words);
}

TEST(Products, NoWordsChooseEverything) {
  const auto jobs = chosen({});
  ASSERT_EQ(jobs.size(), 3U);
  EXPECT_FALSE(jobs[1].table);
  EXPECT_TRUE(jobs[2].table);
  EXPECT_EQ(jobs[2].path, "table.txt");
}

TEST(Products, NumbersCountSimulationsFromOne) {
  const auto jobs = chosen({"2"});
  ASSERT_EQ(jobs.size(), 1U);
  EXPECT_EQ(jobs[0].path, "second.asc");
}

TEST(Products, NamesChooseWithOrWithoutFolderAndCase) {
  for (const char* word : {"second.asc", "SECOND.ASC", "c:\\old\\second.asc"}) {
    const auto jobs = chosen({word});
    ASSERT_EQ(jobs.size(), 1U) << word;
    EXPECT_EQ(jobs[0].index, 1U) << word;
  }
  EXPECT_TRUE(chosen({"table.txt"}).at(0).table);
}

TEST(Products, KeepTheOrderOfTheScriptAndComeOnce) {
  const auto jobs = chosen({"table.txt", "2", "first.asc", "1"});
  ASSERT_EQ(jobs.size(), 3U);
  EXPECT_EQ(jobs[0].path, "first.asc");
}

TEST(Products, WordsThatChooseNothingAreRefusedWithTheNearestName) {
  try {
    (void)chosen({"frist.asc"});
    FAIL() << "accepted";
  } catch (const core::InvalidRequest& error) {
    ASSERT_EQ(error.problems.size(), 1U);
    EXPECT_EQ(error.problems[0].hint, "did you mean 'first.asc'?");
  }
  for (const char* word : {"0", "3", "-1", "nothing like it"})
    EXPECT_THROW((void)chosen({word}), core::InvalidRequest) << word;
}

}  // namespace products_test
}  // namespace sarsim::workflow
