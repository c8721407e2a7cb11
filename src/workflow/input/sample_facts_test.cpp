#include "workflow/input/sample_facts.hpp"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "core/report/invalid_request.hpp"

namespace sarsim::workflow {
namespace sample_facts_test {

namespace fs = std::filesystem;

// A file of two rows of counts.
class FactsOfSamples : public testing::Test {
 protected:
  FactsOfSamples() { std::ofstream(file_) << "1 -2\n3 0\n\n0 0\n-7 5\n\n"; }
  ~FactsOfSamples() override { fs::remove(file_); }

  fs::path file_ = fs::temp_directory_path() / (std::string("sample-facts-") +
                                                testing::UnitTest::GetInstance()->current_test_info()->name() + ".asc");
};

TEST_F(FactsOfSamples, AreItsShapeAndThoseOfAllItsSamples) {
  SampleArguments said;
  said.bits = 8;
  said.lsb_v = 0.5;
  const SampleFacts facts = facts_of_samples(file_.string(), said, true, {});
  EXPECT_EQ(facts.file->rows(), 2U);
  EXPECT_EQ(facts.file->columns(), 2U);
  EXPECT_EQ(facts.file->info().bits, 8);
  EXPECT_EQ(facts.file->info().lsb_v, 0.5);
  EXPECT_FALSE(facts.file->axes());
  EXPECT_EQ(facts.rows, 2U);
  ASSERT_TRUE(facts.statistics);
  EXPECT_EQ(facts.statistics->samples, 4U);
  EXPECT_EQ(facts.statistics->zeros, 1U);
  EXPECT_EQ(facts.statistics->lowest, -7.0);
  EXPECT_EQ(facts.statistics->highest, 5.0);
  EXPECT_EQ(facts.statistics->largest_row, 1U);
}

TEST_F(FactsOfSamples, HaveNoStatisticsUnlessAskedFor) {
  const SampleFacts facts = facts_of_samples(file_.string(), {}, false, {});
  EXPECT_EQ(facts.rows, 2U);
  EXPECT_FALSE(facts.rows_estimated);
  EXPECT_FALSE(facts.statistics);
}

TEST_F(FactsOfSamples, EstimateTheRowsOfALongTextByItsBeginning) {
  constexpr std::size_t rows = 60'000;
  {
    std::string row;
    for (int i = 0; i < 100; ++i) row += "12 -7\n";
    std::ofstream file(file_);
    for (std::size_t i = 0; i < rows; ++i) file << row << "\n";
  }
  const SampleFacts facts = facts_of_samples(file_.string(), {}, false, {});
  EXPECT_EQ(facts.file->columns(), 100U);
  EXPECT_NEAR(static_cast<double>(facts.rows), static_cast<double>(rows), facts.rows_estimated ? 0.02 * rows : 0.0);
  const SampleFacts counted = facts_of_samples(file_.string(), {}, true, {});
  EXPECT_EQ(counted.rows, rows);
  EXPECT_FALSE(counted.rows_estimated);
}

TEST_F(FactsOfSamples, EndWhereTheyAreStoppedOrRefused) {
  core::StopFlag stop;
  stop.request();
  core::Observer observer;
  observer.stop = &stop;
  EXPECT_THROW(static_cast<void>(facts_of_samples(file_.string(), {}, true, observer)), core::Interrupted);
  SampleArguments said;
  said.lsb_v = -1.0;
  EXPECT_THROW(static_cast<void>(facts_of_samples(file_.string(), said, false, {})), core::InvalidRequest);
  EXPECT_THROW(static_cast<void>(facts_of_samples(file_.string() + ".none", {}, false, {})), core::InvalidRequest);
}

}  // namespace sample_facts_test
}  // namespace sarsim::workflow
