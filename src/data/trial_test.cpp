#include "data/trial.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <stdexcept>

#include "data/sample_file.hpp"

namespace sarsim {
namespace {

TEST(Trial, TellsSurvivalFromCrashAndHang) {
  EXPECT_EQ(run_trial([] {}, 5), TrialResult::passed);
  EXPECT_EQ(run_trial([] { throw std::runtime_error("an answer"); }, 5), TrialResult::passed);
  EXPECT_EQ(run_trial([] { std::abort(); }, 5), TrialResult::crashed);
  volatile bool never = false;
  EXPECT_EQ(run_trial(
                [&] {
                  while (!never) {
                  }
                },
                1),
            TrialResult::timed_out);
}

TEST(Trial, LeavesThisProcessAsItWas) {
  int value = 1;
  EXPECT_EQ(run_trial([&] { value = 2; }, 5), TrialResult::passed);
  EXPECT_EQ(value, 1);
}

// An input that fuzzing found: H5Fopen of libhdf5 1.10.8 reads beyond its memory and dies.
TEST(Trial, AFileThatCrashesTheHdf5LibraryIsRefusedInWords) {
  const auto path =
      std::filesystem::path(__FILE__).parent_path() / "../../fuzz/corpus/hdf5_samples/crashes_libhdf5_1_10.h5";
  ASSERT_TRUE(std::filesystem::exists(path));
  const OpenedSampleFile opened = SampleFile::open(path);
  EXPECT_FALSE(opened.file.has_value());
  ASSERT_FALSE(opened.problems.empty());
  EXPECT_EQ(opened.problems.front().severity, Severity::error);
}

}  // namespace
}  // namespace sarsim
