#include "core/os/isolated.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <thread>

#include "raster/format/open_raster.hpp"
#include "support/folders.hpp"

namespace sarsim::raster {
namespace trial_test {

TEST(Trial, TellsSurvivalFromCrashAndHang) {
  EXPECT_EQ(core::run_isolated([] { return std::string(); }, 5).result, core::IsolatedResult::passed);
  EXPECT_EQ(core::run_isolated([]() -> std::string { throw std::runtime_error("an answer"); }, 5).result,
            core::IsolatedResult::passed);
  EXPECT_EQ(core::run_isolated([]() -> std::string { std::abort(); }, 5).result, core::IsolatedResult::crashed);
  volatile bool never = false;
  EXPECT_EQ(core::run_isolated(
                [&] {
                  while (!never) {
                  }
                  return std::string();
                },
                1)
                .result,
            core::IsolatedResult::too_much_work);
}

// The terminal sends Ctrl-C to the child as well.
TEST(Trial, ARequestToEndIsNoCrash) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const auto before = std::signal(signal, SIG_DFL);
    const core::IsolatedReport report = core::run_isolated(
        [signal] {
          std::raise(signal);
          return std::string("survived");
        },
        5);
    std::signal(signal, before);
    EXPECT_EQ(report.result, core::IsolatedResult::stopped) << signal;
  }
}

// The child would work on for 5 s of processor time.
TEST(Trial, EndsWhenWhoeverBeganItNoLongerWantsIt) {
  volatile bool never = false;
  int questions = 0;
  const core::IsolatedReport report = core::run_isolated(
      [&] {
        while (!never) {
        }
        return std::string();
      },
      5, nullptr, [&questions] { return ++questions == 2; });
  EXPECT_EQ(report.result, core::IsolatedResult::stopped);
  EXPECT_EQ(questions, 2);
}

TEST(Trial, WhatIsIgnoredStaysIgnored) {
  const auto before = std::signal(SIGHUP, SIG_IGN);
  const core::IsolatedReport report = core::run_isolated(
      [] {
        std::raise(SIGHUP);
        return std::string("survived");
      },
      5);
  std::signal(SIGHUP, before);
  EXPECT_EQ(report.result, core::IsolatedResult::passed);
  EXPECT_EQ(report.text, "survived");
}

TEST(Trial, BringsBackTheTextAndNothingElse) {
  int value = 1;
  const core::IsolatedReport report = core::run_isolated(
      [&] {
        value = 2;
        return std::string(50'000, 'x') + '\0' + "end";
      },
      5);
  EXPECT_EQ(report.text, std::string(50'000, 'x') + '\0' + "end");
  EXPECT_EQ(value, 1);
}

// A busy machine or a slow disk says nothing of a file.
TEST(Trial, CountsNoTimeThatIsWaited) {
  const core::IsolatedReport report = core::run_isolated(
      [] {
        std::this_thread::sleep_for(std::chrono::milliseconds(2500));
        return std::string("survived");
      },
      1);
  EXPECT_EQ(report.result, core::IsolatedResult::passed);
  EXPECT_EQ(report.text, "survived");
}

// An input that fuzzing found: H5Fopen of libhdf5 1.10.8 reads beyond its memory and dies.
TEST(Trial, AFileThatCrashesTheHdf5LibraryIsRefusedInWords) {
  const auto path = test::source_folder() / "fuzz/corpus/hdf5_samples/crashes_libhdf5_1_10.h5";
  ASSERT_TRUE(std::filesystem::exists(path));
  const OpenedRaster opened = open_raster(Integrity::whole, path);
  EXPECT_FALSE(opened.raster);
  ASSERT_FALSE(opened.problems.empty());
  EXPECT_EQ(opened.problems.front().severity, core::Severity::error);
}

// Another: the library asks for 17 GB because a header says so.
TEST(Trial, AFileThatClaimsSeventeenGigabytesIsRefusedWithoutThem) {
  const auto path = test::source_folder() / "fuzz/corpus/hdf5_samples/claims_17_gigabytes.h5";
  ASSERT_TRUE(std::filesystem::exists(path));
  const OpenedRaster opened = open_raster(Integrity::whole, path);
  EXPECT_FALSE(opened.raster);
  EXPECT_FALSE(opened.problems.empty());
}

}  // namespace trial_test
}  // namespace sarsim::raster
