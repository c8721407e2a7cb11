#include <cmath>
#include <csignal>

#include <gmock/gmock.h>

#include "program.hpp"
#include "report_numbers.hpp"

namespace sarsim::test {
namespace stepped_test {

using testing::HasSubstr;

// Two points that are equally strong, two weaker ones. The window has room for five samples, the last at 2519.96 m.
constexpr const char* truck = R"($PLATFORM Truck TRAJECTORY LINEAR LINEAR LINEAR INLINE
 2 -1 2502 1 2498
 1 0 0
 1 0 0
 NOT_ALIGNED CONST 0 0 30  0 0 5  STDDEV 0 0 0 STDDEV 0 0 0
$TARGET Truck  0 0 0  0 0 0 1 0 ISOTROPIC
$TARGET Truck  6 0 0  0 0 0 1 0 ISOTROPIC
$TARGET Truck -6 1.2 0  0 0 0 0.5 0 ISOTROPIC
$TARGET Truck  2 -2 0  0 0 0 0.25 0 ISOTROPIC
$RADAR X Earth MONO 200 RECT CONSTANT 20000 STEPPED 9 0.004 128 1
 1 30 30 2 400 ISOTROPIC SAME FIXED 0 90 HAMMING NO_STC
$SIMULATION X 2460 2540 -0.32 0.3199 12 0.01 0 HDF5 RAW sf.h5 CENTRE
)";

class Profiles : public CommandTest {
 protected:
  [[nodiscard]] Finished profiles(std::vector<std::string> more, const std::string& scene = "stepped_srp.scr") const {
    std::vector<std::string> words{"profiles", examples + scene};
    words.insert(words.end(), more.begin(), more.end());
    return sarsim(words);
  }
};

TEST_F(Profiles, OfTheFirstExampleShowItsFourTargets) {
  const Finished run = profiles({"--json", "--quiet"});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(is_json(run.out, folder_));
  EXPECT_EQ(numbers_of(run.out, "bursts").at(0), 3.0);
  EXPECT_NEAR(numbers_of(run.out, "resolution_m").at(0), 0.468, 0.001);
  EXPECT_NEAR(numbers_of(run.out, "unambiguous_range_m").at(0), 29.98, 0.01);
  ASSERT_EQ(numbers_of(run.out, "range_error_m").size(), 4U);
  EXPECT_LT(largest(numbers_of(run.out, "range_error_m")), 0.02);
  EXPECT_LT(largest(numbers_of(run.out, "amplitude_error_db")), 0.3);
  EXPECT_EQ(std::filesystem::file_size(folder_ / "stepped_srp-profiles.img"),
            3 * 8 * static_cast<std::uintmax_t>(numbers_of(run.out, "columns").at(0)));
  EXPECT_THAT(text_of(folder_ / "stepped_srp-profiles.hdr"), HasSubstr("range step m"));
}

TEST_F(Profiles, OfTheAircraftAreSharpOnceItsSpeedIsTakenOut) {
  const Finished plain = profiles({"--out", "plain.img"}, "stepped_aircraft.scr");
  ASSERT_EQ(plain.status, 0) << plain.err;
  EXPECT_THAT(plain.err, HasSubstr("targets move during a burst"));
  for (const char* velocity : {"scene", "estimated"}) {
    const Finished run =
        profiles({"--velocity", velocity, "--json", "--out", std::string(velocity) + ".img"}, "stepped_aircraft.scr");
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_THAT(run.err, testing::Not(HasSubstr("warning")));
    ASSERT_EQ(numbers_of(run.out, "first_burst").size(), 3U);
    for (const double speed : numbers_of(run.out, "from_s")) EXPECT_GT(speed, 0.0);
    // Pairs to the left and right of the fuselage share cells: what is alone is held to a tenth of a cell (0.94 m).
    ASSERT_GE(numbers_of(run.out, "range_error_m").size(), 8U) << velocity;
    EXPECT_LT(std::abs(numbers_of(run.out, "range_error_m").at(0)), 0.15) << velocity;
  }
}

TEST_F(Profiles, AreTheSameOfTheRecording) {
  ASSERT_EQ(sarsim({"run", examples + "turning_ship.scr", "--quiet"}).status, 0);
  const Finished data = sarsim({"profiles", "turning_ship.h5", "--velocity", "scene", "--json", "--quiet"});
  ASSERT_EQ(data.status, 0) << data.err;
  const Finished scene = profiles({"--velocity", "scene", "--json", "--quiet"}, "turning_ship.scr");
  ASSERT_EQ(scene.status, 2);  // The outputs have the same name.
  const Finished other =
      profiles({"--velocity", "scene", "--json", "--quiet", "--out", "other.img"}, "turning_ship.scr");
  ASSERT_EQ(other.status, 0) << other.err;
  const auto from_data = numbers_of(data.out, "range_error_m");
  const auto from_scene = numbers_of(other.out, "range_error_m");
  ASSERT_EQ(from_data.size(), from_scene.size());
  for (std::size_t i = 0; i < from_data.size(); ++i) EXPECT_NEAR(from_data[i], from_scene[i], 0.05);
}

// Of 80 m five samples are recorded, 15 m apart; with CENTRE the last sees half a pulse, 15 m, beyond itself.
TEST_F(Profiles, OfARecordingEndWithWhatItsLastSampleSees) {
  write_text(folder_ / "truck.scr", truck);
  ASSERT_EQ(sarsim({"run", "truck.scr", "--quiet"}).status, 0);
  const auto last_m = [](const Finished& run) {
    return numbers_of(run.out, "range_first_m").at(0) +
           (numbers_of(run.out, "columns").at(0) - 1.0) * numbers_of(run.out, "range_step_m").at(0);
  };
  const Finished data = sarsim({"profiles", "sf.h5", "--json"});
  ASSERT_EQ(data.status, 0) << data.err;
  EXPECT_NEAR(last_m(data), 2534.91, 0.04);
  EXPECT_THAT(data.err, HasSubstr("do not show all of the script's window"));
  EXPECT_THAT(data.err, HasSubstr("2460 m to 2534.948 m"));
  const Finished scene = sarsim({"profiles", "truck.scr", "--json", "--out", "scene.img"});
  ASSERT_EQ(scene.status, 0) << scene.err;
  EXPECT_NEAR(last_m(scene), 2539.96, 0.04);
  EXPECT_THAT(scene.err, testing::Not(HasSubstr("do not show")));
  const Finished beyond = sarsim({"profiles", "sf.h5", "--to", "2540", "--out", "beyond.img"});
  ASSERT_EQ(beyond.status, 0) << beyond.err;
  EXPECT_THAT(beyond.err, HasSubstr("the ranges go beyond those that were recorded"));
}

TEST_F(Profiles, AreReadFromFilesThatCarryNoScript) {
  ASSERT_EQ(sarsim({"run", examples + "turning_ship.scr", "--quiet", "--format", "npy"}).status, 0);
  const Finished none = sarsim({"profiles", "turning_ship.npy", "--velocity", "scene"});
  EXPECT_EQ(none.status, 2);
  EXPECT_THAT(none.err, HasSubstr("--script"));
  const Finished run = sarsim({"profiles", "turning_ship.npy", "--velocity", "scene", "--script",
                               examples + "turning_ship.scr", "--json", "--quiet"});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_GE(numbers_of(run.out, "range_error_m").size(), 8U);
}

TEST_F(Profiles, HaveTheSameBytesOnAnyNumberOfThreadsInEveryFormat) {
  for (const char* extension : {"img", "npy", "h5", "zarr", "csv", "asc", "bin", "brk"}) {
    const std::string one = std::string("one.") + extension, three = std::string("three.") + extension;
    ASSERT_EQ(profiles({"--out", one, "--threads", "1", "--quiet"}).status, 0) << extension;
    ASSERT_EQ(profiles({"--out", three, "--threads", "3", "--quiet"}).status, 0) << extension;
    EXPECT_EQ(text_of(folder_ / one), text_of(folder_ / three)) << extension;
    EXPECT_FALSE(text_of(folder_ / one).empty()) << extension;
  }
  const std::string csv = text_of(folder_ / "one.csv");
  EXPECT_EQ(csv.substr(0, csv.find('\n')), "range_m,burst_1_v,burst_2_v,burst_3_v");
}

TEST_F(Profiles, OfScansAndOfTheEncounterAreMeans) {
  ASSERT_EQ(profiles({"--velocity", "scene", "--group", "scans", "--out", "s.csv"}, "stepped_aircraft.scr").status, 0);
  const std::string scans = text_of(folder_ / "s.csv");
  EXPECT_EQ(scans.substr(0, scans.find('\n')), "range_m,scan_1_v,scan_2_v,scan_3_v");
  ASSERT_EQ(
      profiles({"--velocity", "scene", "--group", "encounter", "--align", "--out", "e.csv"}, "stepped_aircraft.scr")
          .status,
      0);
  const std::string encounter = text_of(folder_ / "e.csv");
  EXPECT_EQ(encounter.substr(0, encounter.find('\n')), "range_m,encounter_v");
}

TEST_F(Profiles, PrintATableOfTargetsAgainstTheProfile) {
  const Finished run = profiles({"--burst", "2", "--window", "taylor:35:5", "--from", "2995", "--to", "3015"});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("burst 2 at"));
  EXPECT_THAT(run.out, HasSubstr("expected m"));
  EXPECT_THAT(run.err, HasSubstr("resolution 0.4684 m"));
}

TEST_F(Profiles, SayWhichTargetsShareAPeak) {
  write_text(folder_ / "truck.scr", truck);
  const Finished apart = sarsim({"profiles", "truck.scr", "--out", "a.img"});
  ASSERT_EQ(apart.status, 0) << apart.err;
  EXPECT_THAT(apart.out, testing::Not(HasSubstr("of another")));
  // The cell is c/(2 N df) = 0.293 m.
  const Finished close =
      sarsim({"profiles", "truck.scr", "--out", "b.img", "--set", "Target4.x=6m", "--set", "Target4.y=0.05m"});
  EXPECT_THAT(close.out, HasSubstr("2 of 4 targets lie within a resolution cell (0.2928 m) of another (*)"));
  EXPECT_THAT(close.out, HasSubstr("\n     4* "));
}

TEST_F(Profiles, SayWhatIsWrongWithTheirArguments) {
  const auto refused = [&](const std::vector<std::string>& words, const char* text) {
    const Finished run = profiles(words);
    EXPECT_EQ(run.status, 2) << text;
    EXPECT_THAT(run.err, HasSubstr(text));
  };
  refused({"--window", "hammond"}, "'hammond' is not a valid window");
  refused({"--velocity", "fast"}, "--velocity: invalid 'fast'");
  refused({"--velocity", "1e9"}, "--velocity: invalid '1e9'");
  refused({"--fastest", "-3"}, "--fastest");
  refused({"--align"}, "--align moves profiles by the speed");
  refused({"--burst", "9"}, "burst 9 is not illuminated");
  refused({"--from", "3020", "--to", "3000"}, "is empty");
  refused({"--from", "0", "--to", "1e9"}, "cannot be held");
  refused({"--simulation", "7"}, "no recording 7");
  refused({"--script", "other.scr"}, "--script is for files of samples");
  refused({"--illumination", "-1"}, "--illumination");
  refused({"--group", "sweeps"}, "scans");
  EXPECT_EQ(sarsim({"profiles", "missing.h5"}).status, 2);
  EXPECT_EQ(sarsim({"profiles", "missing.scr"}).status, 2);
  EXPECT_TRUE(entries(".").empty());
}

TEST_F(Profiles, RefuseWhatDoesNotStep) {
  const Finished run = profiles({}, "sar_r.scr");
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.err, HasSubstr("at least two frequency steps"));
  ASSERT_EQ(sarsim({"run", examples + "stepped_srp.scr", "--format", "hdf5", "--quiet"}).status, 0);
  const Finished made = sarsim({"profiles", "stepped_srp.h5"});
  EXPECT_EQ(made.status, 2);
  EXPECT_THAT(made.err, HasSubstr("range profiles already"));
}

TEST_F(Profiles, KeepFilesUnlessForced) {
  write_text(folder_ / "stepped_srp-profiles.hdr", "precious");
  EXPECT_EQ(profiles({}).status, 2);
  EXPECT_EQ(text_of(folder_ / "stepped_srp-profiles.hdr"), "precious");
  EXPECT_EQ(profiles({"--force"}).status, 0);
}

class Isar : public CommandTest {
 protected:
  [[nodiscard]] Finished isar(std::vector<std::string> more) const {
    std::vector<std::string> words{"isar", examples + "turning_ship.scr"};
    words.insert(words.end(), more.begin(), more.end());
    return sarsim(words);
  }
};

TEST_F(Isar, PutsThePointsOfTheShipWithinAFractionOfACell) {
  const Finished run = isar({"--json", "--window", "taylor:35:5"});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(is_json(run.out, folder_));
  EXPECT_THAT(run.err, testing::Not(HasSubstr("warning")));
  ASSERT_EQ(numbers_of(run.out, "cross_range_error_m").size(), 10U);
  EXPECT_LT(largest(numbers_of(run.out, "cross_range_error_m")), 0.1);
  EXPECT_LT(largest(numbers_of(run.out, "range_error_m")), 0.15);
  EXPECT_LT(largest(numbers_of(run.out, "amplitude_error_db")), 1.5);
  EXPECT_EQ(std::filesystem::file_size(folder_ / "turning_ship-isar.img"),
            8 * static_cast<std::uintmax_t>(numbers_of(run.out, "rows").at(0) * numbers_of(run.out, "columns").at(0)));
}

TEST_F(Isar, FindsThePathOfTheShipInTheEchoes) {
  const Finished run = isar({"--json", "--motion", "estimated", "--fastest", "40"});
  ASSERT_EQ(run.status, 0) << run.err;
  ASSERT_GE(numbers_of(run.out, "cross_range_error_m").size(), 8U);
  EXPECT_LT(largest(numbers_of(run.out, "cross_range_error_m")), 0.6);
  EXPECT_LT(largest(numbers_of(run.out, "range_error_m")), 0.5);
}

// The strongest peak may be either of two points that are equally strong.
TEST_F(Isar, LaysTargetsThatAreEquallyStrongUponTheirOwnPeaks) {
  write_text(folder_ / "truck.scr", truck);
  const Finished run = sarsim({"isar", "truck.scr", "--motion", "estimated", "--json", "--quiet"});
  ASSERT_EQ(run.status, 0) << run.err;
  // All four are found: the report has no error of one that is not.
  ASSERT_EQ(numbers_of(run.out, "cross_range_error_m").size(), 4U);
  EXPECT_LT(largest(numbers_of(run.out, "cross_range_error_m")), 0.1);
  EXPECT_LT(largest(numbers_of(run.out, "range_error_m")), 0.1);
  EXPECT_LT(largest(numbers_of(run.out, "amplitude_error_db")), 1.5);
}

TEST_F(Isar, MakesSeriesOfImagesAndTheSameBytesOnAnyNumberOfThreads) {
  ASSERT_EQ(isar({"--bursts", "60", "--step", "30", "--out", "a.npy", "--threads", "1", "--quiet"}).status, 0);
  ASSERT_EQ(isar({"--bursts", "60", "--step", "30", "--out", "b.npy", "--threads", "3", "--quiet"}).status, 0);
  for (const char* number : {"-1", "-2", "-3"}) {
    const std::string name = std::string(number) + ".npy";
    EXPECT_EQ(text_of(folder_ / ("a" + name)), text_of(folder_ / ("b" + name))) << number;
    EXPECT_FALSE(text_of(folder_ / ("a" + name)).empty()) << number;
  }
  EXPECT_FALSE(std::filesystem::exists(folder_ / "a-4.npy"));
}

TEST_F(Isar, BackProjectsAndWritesMagnitudes) {
  const Finished run = isar({"--algorithm", "back-projection", "--bursts", "30", "--magnitude", "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(std::filesystem::exists(folder_ / "turning_ship-isar-1-magnitude.img"));
  EXPECT_LT(std::abs(numbers_of(run.out, "cross_range_error_m").at(0)), 0.5);
}

TEST_F(Isar, SaysWhatIsWrongWithItsArguments) {
  const auto refused = [&](const std::vector<std::string>& words, const char* text) {
    const Finished run = isar(words);
    EXPECT_EQ(run.status, 2) << text;
    EXPECT_THAT(run.err, HasSubstr(text));
  };
  refused({"--window", "hammond"}, "'hammond' is not a valid window");
  refused({"--platform", "Shop"}, "did you mean 'Ship'?");
  refused({"--platform", "Earth"}, "carries the radar itself");
  refused({"--turn-rate", "0"}, "without rotation");
  refused({"--algorithm", "back-projection", "--motion", "estimated"}, "back-projection needs the path");
  refused({"--bursts", "5000"}, "bursts");
  refused({"--cross-range", "1e9"}, "cannot be made this large");
  refused({"--fastest", "0"}, "--fastest");
  refused({"--out", "a.h5", "--magnitude"}, "--magnitude makes ENVI images");
  refused({"--algorithm", "magic"}, "range-doppler");
  EXPECT_EQ(sarsim({"isar", "missing.h5"}).status, 2);
  EXPECT_TRUE(entries(".").empty());
}

TEST_F(Isar, IsInterruptedWithoutLeavingAnything) {
  Program program({"isar", examples + "turning_ship.scr", "--algorithm", "back-projection", "--oversampling", "6"},
                  {folder_, "", 0});
  ASSERT_TRUE(program.wait_for("0 %", 60.0)) << program.err();
  program.send(SIGINT);
  EXPECT_EQ(program.finish().status, 130);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "turning_ship-isar.img"));
}

}  // namespace stepped_test
}  // namespace sarsim::test
