#include <algorithm>
#include <filesystem>

#include <gmock/gmock.h>

#include "csv.hpp"
#include "program.hpp"

namespace sarsim::test {
namespace sweep_follow_test {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

// What is made of each recording of a sweep besides.
class SweepFollowUp : public CommandTest {
 protected:
  static std::string example(const char* name) {
    return text_of(fs::path(SARSIM_SOURCE_DIR) / "examples" / (std::string(name) + ".scr"));
  }
  // A short flight over two targets.
  void write_flight(const std::string& format = "NPY") {
    write_text(folder_ / "sar.scr",
               "$PLATFORM Earth STATIONARY 0 0 0 CONST 0 0 0 0 0 0 STDDEV 0 0 0 STDDEV 0 0 0\n"
               "$PLATFORM Plane TRAJECTORY LINEAR LINEAR LINEAR INLINE 1, 0 -10000\n2, -10 -2000, 10 2000\n1, 0 2000\n"
               "NOT_ALIGNED CONST 0 0 0 0 0 0 STDDEV 0 0 0 STDDEV 0 0 0\n"
               "$TARGET Earth 0 0 0 0 0 0 1 0 ISOTROPIC\n$TARGET Earth 30 12 0 0 0 0 1 0 ISOTROPIC\n"
               "$RADAR R Plane CHIRP 0.1 800 RECT CONSTANT 620 SINGLE 5.3 100 0 0\n"
               "  ISOTROPIC SAME FIXED 0 0 RECT NO_STC\n"
               "$SIMULATION R 10098 10298 -0.25 0.249 12 0.15 0 " +
                   format + " RAW flight" + (format == "NPY" ? ".npy" : ".bin") + " BEGIN 1 1\n");
  }
  std::vector<std::map<std::string, std::string>> sweep(std::vector<std::string> words) {
    words.insert(words.begin(), "sweep");
    const Finished end = sarsim(words);
    EXPECT_EQ(end.status, 0) << end.err;
    return read_csv(text_of(folder_ / "sweep.csv"));
  }
  void expect_refusal(std::vector<std::string> words, const std::string& message) {
    words.insert(words.begin(), {"sweep", "sar.scr", "--set", "seed=1,2"});
    const Finished end = sarsim(words);
    EXPECT_EQ(end.status, 2);
    EXPECT_THAT(end.err, HasSubstr(message));
    EXPECT_FALSE(fs::exists(folder_ / "sweep.csv"));
  }
};

double number(const std::map<std::string, std::string>& row, const char* column) { return std::stod(row.at(column)); }

TEST_F(SweepFollowUp, MeasuresWhatTheCommandsMeasure) {
  write_flight();
  const std::vector<std::string> words{"sar.scr", "--set",     "Target1.rcs=1,4", "--set",           "Target1.y=-5,5",
                                       "--focus", "--measure", "--with",          "--window hamming"};
  const auto rows = sweep(words);
  ASSERT_EQ(rows.size(), 4U);
  const std::string name = "flight_Target1.rcs=4_Target1.y=-5";
  ASSERT_TRUE(fs::exists(folder_ / (name + ".img")));
  const auto again = read_csv(sarsim({"measure", name + ".img", "--csv"}).out);
  ASSERT_EQ(again.size(), 2U);
  EXPECT_EQ(rows[2].at("found"), "2");
  for (const char* column : {"azimuth_error_m", "range_error_m", "amplitude_v", "phase_error_rad", "range_width_m"})
    EXPECT_NEAR(number(rows[2], ("target1_" + std::string(column)).c_str()), number(again[0], column),
                1e-9 * (1.0 + std::abs(number(again[0], column))))
        << column;
  // Of NPY files, in volts, and four times the cross-section.
  EXPECT_NEAR(number(rows[2], "target1_amplitude_v") / number(rows[0], "target1_amplitude_v"), 2.0, 0.01);
  EXPECT_NEAR(number(rows[0], "target1_amplitude_error_db"), 0.0, 0.1);
  EXPECT_THAT(text_of(folder_ / (name + ".hdr")), HasSubstr("settings = {--set Target1.rcs=4 --set Target1.y=-5}"));
  // Resumed, nothing is done again, until an image is missing.
  std::vector<std::string> resumed = words;
  resumed.insert(resumed.begin(), "sweep");
  resumed.insert(resumed.end(), {"--resume", "--force"});
  EXPECT_THAT(sarsim(resumed).err, HasSubstr("4 variations, 4 done before, 0 to run"));
  EXPECT_EQ(read_csv(text_of(folder_ / "sweep.csv")), rows);
  fs::remove(folder_ / (name + ".img"));
  EXPECT_THAT(sarsim(resumed).err, HasSubstr("4 variations, 3 done before, 1 to run"));
  EXPECT_TRUE(fs::exists(folder_ / (name + ".img")));
}

// What was recorded before, by a sweep without follow-ups or one that was ended among them, is not recorded again.
TEST_F(SweepFollowUp, IsMadeOfRecordingsThatAreThere) {
  write_flight();
  const std::vector<std::string> words{"sweep", "sar.scr", "--set", "seed=1,2"};
  ASSERT_EQ(sarsim(words).status, 0);
  const auto before = fs::last_write_time(folder_ / "flight_seed=2.npy");
  std::vector<std::string> more = words;
  more.insert(more.end(), {"--resume", "--focus", "--measure"});
  const Finished followed = sarsim(more);
  EXPECT_EQ(followed.status, 0) << followed.err;
  EXPECT_EQ(fs::last_write_time(folder_ / "flight_seed=2.npy"), before);
  EXPECT_EQ(read_csv(text_of(folder_ / "sweep.csv")).at(1).at("found"), "2");
  EXPECT_THAT(sarsim(more).err, HasSubstr("2 done before, 0 to run"));
  // An image without its line in the journal, as after a process was killed, is made again.
  const std::string journal = text_of(folder_ / "sweep.journal");
  write_text(folder_ / "sweep.journal", journal.substr(0, journal.rfind('\n', journal.rfind("focus-")) + 1));
  EXPECT_THAT(sarsim(more).err, HasSubstr("1 done before, 1 to run"));
  more.insert(more.end(), {"--with", "--window hamming"});
  EXPECT_THAT(sarsim(more).err, HasSubstr("2 variations, 2 to run"));
  EXPECT_EQ(fs::last_write_time(folder_ / "flight_seed=2.npy"), before);
}

// Counts of a converter whose LSB is found from the data are volts again.
TEST_F(SweepFollowUp, KnowsTheVoltsOfCounts) {
  write_flight("BINARY");
  const auto rows = sweep({"sar.scr", "--set", "seed=1,2", "--focus", "--measure"});
  EXPECT_NEAR(number(rows[0], "target1_amplitude_error_db"), 0.0, 0.1);
  EXPECT_LT(std::abs(number(rows[0], "target1_azimuth_error_m")), 0.3);
}

TEST_F(SweepFollowUp, LeavesNothingButTablesWhereNothingIsKept) {
  write_flight();
  const auto rows = sweep({"sar.scr", "--set", "seed=1,2", "--focus", "--measure", "--discard"});
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].at("target2_found"), "1");
  EXPECT_NEAR(number(rows[0], "target2_amplitude_error_db"), 0.0, 0.1);
  EXPECT_THAT(entries("."), ElementsAre("sar.scr", "sweep.csv", "sweep.journal", "sweep.json"));
}

TEST_F(SweepFollowUp, SearchesAndMakesProfiles) {
  write_text(folder_ / "search.scr", example("search_radar"));
  const auto found =
      sweep({"search.scr", "1", "--set", "Target1.rcs=1E-6,100", "--search", "--with", "--no-map", "--discard"});
  ASSERT_EQ(found.size(), 2U);
  EXPECT_GT(number(found[1], "target1_probability"), number(found[0], "target1_probability"));
  EXPECT_THAT(entries("."), ElementsAre("search.scr", "sweep.csv", "sweep.journal", "sweep.json"));
  write_text(folder_ / "steps.scr", example("stepped_aircraft"));
  const auto profiles = sweep(
      {"steps.scr", "1", "--set", "seed=1,2", "--profiles", "--discard", "--force", "--with", "--velocity scene"});
  EXPECT_LT(std::abs(number(profiles[0], "target1_range_error_m")), 0.5);
  EXPECT_GT(number(profiles[0], "profiles"), 0.0);
}

TEST_F(SweepFollowUp, AVariationThatCannotBeFocusedFailsAlone) {
  write_flight();
  const Finished end =
      sarsim({"sweep", "sar.scr", "--set", "Plane.path=TRAJECTORY,STATIONARY", "--focus", "--discard"});
  EXPECT_EQ(end.status, 2);
  const auto rows = read_csv(text_of(folder_ / "sweep.csv"));
  EXPECT_EQ(rows.at(0).at("status"), "done");
  EXPECT_EQ(rows.at(1).at("status"), "failed");
}

TEST_F(SweepFollowUp, RefusesOptionsBeforeAnythingRuns) {
  write_flight();
  expect_refusal({"--measure"}, "add --focus");
  expect_refusal({"--with", "--window hann"}, "add one of them");
  expect_refusal({"--focus", "--search"}, "--focus and --search cannot be made of one sweep");
  expect_refusal({"--focus", "--with", "--widnow hann"}, "did you mean '--window'?");
  expect_refusal({"--focus", "--with", "--window square"}, "square");
  expect_refusal({"--focus", "--with", "--out x.img"}, "the sweep decides --out");
  expect_refusal({"--focus", "--with", "--seed 3"}, "the sweep decides --seed");
  expect_refusal({"--focus", "--discard", "--with", "--targets nofile"}, "the sweep decides --targets");
  expect_refusal({"--focus", "--dry-run", "--commands"}, "--commands prints the recordings alone");
  write_text(folder_ / "flight_seed=2.hdr", "mine");
  expect_refusal({"--focus"}, "flight_seed=2.hdr");
  EXPECT_EQ(text_of(folder_ / "flight_seed=2.hdr"), "mine");
  std::filesystem::remove(folder_ / "flight_seed=2.hdr");
  std::filesystem::create_symlink("flight_seed=2.img", folder_ / "flight_seed=2.hdr");
  expect_refusal({"--focus", "--force"}, "a link has the name of a file that the sweep makes");
}

}  // namespace sweep_follow_test
}  // namespace sarsim::test
