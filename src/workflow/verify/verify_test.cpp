#include "workflow/verify/verify.hpp"

#include <unistd.h>

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "core/report/invalid_request.hpp"

namespace sarsim::workflow::verify {
namespace verify_test {

namespace fs = std::filesystem;

TEST(VerifyWorkflow, RefusesToReplaceAPageBeforeItMeasures) {
  const fs::path page = fs::path(testing::TempDir()) / ("sarsim-verify-" + std::to_string(getpid()) + ".html");
  std::ofstream(page) << "mine";
  EXPECT_THROW((void)verify_program({true, page.string(), false}, {}), core::InvalidRequest);
  EXPECT_EQ(fs::file_size(page), 4U);
  fs::remove(page);
}

TEST(VerifyWorkflow, StopsWhereItIsAskedToAndLeavesNoPage) {
  const fs::path page = fs::path(testing::TempDir()) / ("sarsim-verify-stop-" + std::to_string(getpid()) + ".html");
  core::StopFlag stop;
  stop.request();
  core::Observer observer;
  observer.stop = &stop;
  EXPECT_THROW((void)verify_program({true, page.string(), false}, observer), core::Interrupted);
  EXPECT_FALSE(fs::exists(page));
}

}  // namespace verify_test
}  // namespace sarsim::workflow::verify
