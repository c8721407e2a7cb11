#include "core/report/retryable.hpp"

#include <cerrno>
#include <future>

#include <gtest/gtest.h>

namespace sarsim::core {
namespace for_now_test {

std::error_code code(int error) { return {error, std::generic_category()}; }

TEST(MayPass, IsSoOfWhatIsRefusedForNow) {
  const RetryableError busy("somebody else has it", "wait");
  EXPECT_TRUE(is_retryable(busy));
  EXPECT_EQ(busy.problems.at(0).hint, "wait");
  EXPECT_FALSE(is_retryable(InvalidRequest("a mistake")));
  EXPECT_TRUE(is_retryable(RetryableError(Problems()))) << "of a process whose leader says why";
}

TEST(MayPass, IsSoOfFailuresThatNobodyHasToMend) {
  for (const int error : {EAGAIN, EBUSY, ETXTBSY, ENFILE, ENOLCK, ESTALE, ETIMEDOUT, EHOSTDOWN, EHOSTUNREACH})
    EXPECT_TRUE(is_retryable(code(error))) << code(error).message();
  for (const int error : {0, ENOSPC, EDQUOT, EFBIG, EACCES, EPERM, EROFS, ENOENT, EEXIST, EIO, ENOMEM, EMFILE})
    EXPECT_FALSE(is_retryable(code(error))) << code(error).message();
  EXPECT_TRUE(is_retryable(std::error_code(EBUSY, std::system_category())));
  EXPECT_FALSE(is_retryable(std::make_error_code(std::future_errc::no_state))) << "another kind of number";
}

}  // namespace for_now_test
}  // namespace sarsim::core
