#include "workflow/record/known_machine.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "simulate/run/measure_machine.hpp"

namespace sarsim::workflow {
namespace known_machine_test {

namespace fs = std::filesystem;

class KnownMachine : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(::testing::TempDir()) /
              (std::string("sarsim_speed_") + ::testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  void write(const std::string& text) const {
    fs::create_directories(folder_);
    std::ofstream(machine_file(folder_)) << text;
  }

  fs::path folder_;
};

const simulate::MachineSpeed slow{2.0, 3.5, 0.75, 10.0, 1.25, 0.5};

TEST_F(KnownMachine, SpeedSurvivesItsText) {
  EXPECT_EQ(machine_speed_from(text_of(slow)), slow);
  EXPECT_EQ(machine_speed_from(text_of({})), simulate::MachineSpeed{});
}

TEST_F(KnownMachine, StrangeTextsAreRefused) {
  const std::string good = text_of(slow);
  for (std::size_t length = 0; length < good.size(); ++length)
    EXPECT_FALSE(machine_speed_from(std::string_view(good).substr(0, length))) << length;
  for (const char* number : {"nan", "inf", "-1", "0", "1e9", "fast", ""}) {
    std::string bad = good;
    bad.replace(bad.find("3.5"), 3, number);
    EXPECT_FALSE(machine_speed_from(bad)) << number;
  }
}

TEST_F(KnownMachine, IsMeasuredOnceAndKept) {
  const simulate::MachineSpeed first = known_machine(folder_, nullptr);
  EXPECT_TRUE(fs::exists(machine_file(folder_)));
  const simulate::MachineSpeed kept = known_machine(folder_, nullptr);
  EXPECT_EQ(text_of(kept), text_of(first));
  write(text_of(slow));
  EXPECT_EQ(known_machine(folder_, nullptr), slow);
}

TEST_F(KnownMachine, IsMeasuredAgainWhereTheFileIsDamaged) {
  for (const std::string& text : {std::string("nonsense"), std::string(100'000, 'x'), std::string()}) {
    write(text);
    const simulate::MachineSpeed measured = known_machine(folder_, nullptr);
    EXPECT_GT(measured.spectral, 0.0);
    EXPECT_EQ(text_of(known_machine(folder_, nullptr)), text_of(measured));
  }
}

TEST_F(KnownMachine, NeedsNoFolderThatCanBeWritten) {
  const simulate::MachineSpeed speed = known_machine("/proc/none", nullptr);
  EXPECT_GT(speed.samples, 0.0);
  EXPECT_FALSE(fs::exists("/proc/none"));
}

}  // namespace known_machine_test
}  // namespace sarsim::workflow
