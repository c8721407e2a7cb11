#include <cmath>

#include <gmock/gmock.h>

#include "program.hpp"
#include "report_numbers.hpp"

namespace sarsim::test {
namespace focus_test {

using testing::HasSubstr;

class Focus : public CommandTest {
 protected:
  [[nodiscard]] Finished focused(std::vector<std::string> more) const {
    std::vector<std::string> words{"focus", examples + "sar_r.scr", "--quiet"};
    words.insert(words.end(), more.begin(), more.end());
    return sarsim(words);
  }
};

TEST_F(Focus, FindsAllPointsOfTheLetterByEveryAlgorithm) {
  for (const char* algorithm : {"range-doppler", "chirp-scaling", "omega-k", "back-projection"}) {
    const std::string image = std::string(algorithm) + ".img";
    const Finished focus = focused({"--algorithm", algorithm, "--out", image});
    ASSERT_EQ(focus.status, 0) << focus.err;
    const Finished measure = sarsim({"measure", image, "--json"});
    ASSERT_EQ(measure.status, 0) << measure.err;
    ASSERT_EQ(numbers_of(measure.out, "azimuth_error_m").size(), 24U) << algorithm;
    // Each response stands on the sidelobes of 23 others: hundredths of a cell (0.72 m and 1.5 m).
    EXPECT_LT(largest(numbers_of(measure.out, "azimuth_error_m")), 0.02) << algorithm;
    EXPECT_LT(largest(numbers_of(measure.out, "range_error_m")), 0.02) << algorithm;
    EXPECT_LT(largest(numbers_of(measure.out, "phase_error_rad")), 0.05) << algorithm;
    EXPECT_LT(largest(numbers_of(measure.out, "amplitude_error_db")), 0.3) << algorithm;
  }
}

TEST_F(Focus, WarnsOfTheGhostsOfTheExampleOf1998AndNotOfThoseThatThereAreNot) {
  const Finished old = sarsim({"focus", examples + "sar_r_1998.scr"});
  EXPECT_EQ(old.status, 0);
  EXPECT_THAT(old.err, HasSubstr("echoes of 23 of 24 targets"));
  EXPECT_THAT(old.err, HasSubstr("azimuth ambiguities"));
  const Finished good = sarsim({"focus", examples + "sar_r.scr"});
  EXPECT_EQ(good.status, 0);
  EXPECT_THAT(good.err, testing::Not(HasSubstr("azimuth ambiguities")));
}

TEST_F(Focus, MakesTheSameImageOfTheRecording) {
  ASSERT_EQ(sarsim({"run", examples + "sar_r.scr", "--quiet"}).status, 0);
  const Finished data = sarsim({"focus", "sar_r.h5", "--out", "data.npy", "--quiet"});
  ASSERT_EQ(data.status, 0) << data.err;
  const Finished measure = sarsim({"measure", "data.npy"});
  ASSERT_EQ(measure.status, 0) << measure.err;
  ASSERT_EQ(focused({"--out", "scene.npy"}).status, 0);
  // The file holds volts in float: the images agree to that, and so to the digits shown.
  const std::string from_scene = sarsim({"measure", "scene.npy"}).out;
  EXPECT_EQ(measure.out.substr(measure.out.find('\n')), from_scene.substr(from_scene.find('\n')));
}

TEST_F(Focus, MakesTheSameBytesInLittleMemoryAndOnAnyNumberOfThreads) {
  ASSERT_EQ(focused({"--out", "one.img", "--threads", "1"}).status, 0);
  const Finished disk = focused({"--out", "disk.img", "--threads", "3", "--memory", "2M", "--json"});
  ASSERT_EQ(disk.status, 0) << disk.err;
  EXPECT_THAT(disk.out, HasSubstr("\"on_disk\": true"));
  EXPECT_EQ(text_of(folder_ / "one.img"), text_of(folder_ / "disk.img"));
}

TEST_F(Focus, WritesEveryFormatAndMagnitudes) {
  ASSERT_EQ(focused({"--magnitude"}).status, 0);
  EXPECT_EQ(std::filesystem::file_size(folder_ / "sar_r.img"),
            2 * std::filesystem::file_size(folder_ / "sar_r-magnitude.img"));
  EXPECT_THAT(text_of(folder_ / "sar_r.hdr"), HasSubstr("data type = 6"));
  EXPECT_THAT(text_of(folder_ / "sar_r-magnitude.hdr"), HasSubstr("data type = 4"));
  for (const char* file : {"a.h5", "a.csv", "a.asc", "a.bin", "a.brk"}) {
    EXPECT_EQ(focused({"--out", file}).status, 0) << file;
    EXPECT_TRUE(std::filesystem::exists(folder_ / file)) << file;
  }
  // Counts of 16 bits, of which the largest magnitude is the largest, but for rounding.
  EXPECT_NEAR(numbers_of(sarsim({"info", "a.asc", "--json", "--statistics"}).out, "largest_magnitude").at(0), 32767.0,
              1.0);
  EXPECT_EQ(focused({"--out", "b.h5", "--magnitude"}).status, 2);
  EXPECT_EQ(sarsim({"measure", "sar_r-magnitude.img"}).status, 2);
}

TEST_F(Focus, LowersSidelobesByItsWindows) {
  ASSERT_EQ(focused({"--window", "taylor:35:5"}).status, 0);
  const Finished measure = sarsim({"measure", "sar_r.img", "--json"});
  const std::vector<double> pslr = numbers_of(measure.out, "pslr_db");
  ASSERT_EQ(pslr.size(), 96U);
  // 35 dB, and what the sidelobes of 23 neighbours add.
  for (const double db : pslr) EXPECT_LT(db, -27.0);
}

TEST_F(Focus, KeepsFilesUnlessForced) {
  write_text(folder_ / "sar_r.hdr", "precious");
  EXPECT_EQ(focused({}).status, 2);
  EXPECT_EQ(text_of(folder_ / "sar_r.hdr"), "precious");
  EXPECT_EQ(focused({"--force"}).status, 0);
}

TEST_F(Focus, SaysWhatIsWrongWithItsArguments) {
  const auto refused = [&](const std::vector<std::string>& words, const char* text) {
    const Finished run = focused(words);
    EXPECT_EQ(run.status, 2) << text;
    EXPECT_THAT(run.err, HasSubstr(text));
  };
  refused({"--window", "hammond"}, "'hammond' is not a valid window");
  refused({"--memory", "much"}, "--memory: 'much' is not a valid size");
  refused({"--doppler-centroid", "left"}, "--doppler-centroid: invalid 'left'");
  refused({"--doppler-bandwidth", "1000"}, "Doppler bandwidth");
  refused({"--simulation", "7"}, "no recording 7");
  refused({"--script", "other.scr"}, "--script is for files of samples");
  refused({"--algorithm", "magic"}, "omega-k");
  refused({"--algorithm", "back-projection", "--memory", "1M"}, "back projection holds echoes and image in memory");
  EXPECT_EQ(sarsim({"focus", "missing.h5"}).status, 2);
  EXPECT_EQ(sarsim({"measure", "missing.img"}).status, 2);
}

TEST_F(Focus, RefusesAreasThatAreTooLargeAtOnce) {
  for (const std::string algorithm : {"omega-k", "back-projection"})
    for (const std::string area : {"1e300:1e301", "-1e18:1e18"}) {
      const Finished refused = focused({"--algorithm", algorithm, "--azimuth", area, "--out", "o.npy"});
      EXPECT_EQ(refused.status, 2) << algorithm << " " << area;
      EXPECT_THAT(refused.err, HasSubstr("too long in azimuth, or too far from the record"));
      EXPECT_THAT(refused.err, HasSubstr("samples with the record"));
    }
  const Finished far = focused({"--algorithm", "back-projection", "--range", "1e300:1e301", "--out", "o.npy"});
  EXPECT_EQ(far.status, 2) << far.err;
  EXPECT_THAT(far.err, HasSubstr("--range reaches too far from the recorded ranges"));
}

// Beyond the 10.5 km of range, near enough to be quick.
TEST_F(Focus, WarnsOfAnAreaThatTheRecordSeesNothingOf) {
  const Finished far = sarsim({"focus", examples + "sar_r.scr", "--azimuth", "15000:15001", "--out", "o.npy"});
  EXPECT_EQ(far.status, 0) << far.err;
  EXPECT_THAT(far.err, HasSubstr("is outside everything recorded"));
  EXPECT_THAT(far.err, HasSubstr("found '15000 to 15001 m'"));
}

TEST_F(Focus, RefusesWhatIsNoSyntheticAperture) {
  const Finished run = sarsim({"focus", examples + "thesis_a2.scr"});
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.err, HasSubstr("the antenna does not move"));
}

TEST_F(Focus, TakesTheCentroidFromTheDataOrAsGiven) {
  const Finished measured = focused({"--doppler-centroid", "measured", "--json", "--out", "m.img"});
  ASSERT_EQ(measured.status, 0) << measured.err;
  EXPECT_NEAR(numbers_of(measured.out, "doppler_centroid_hz").at(0), 16.4, 3.0);
  const Finished given = focused({"--doppler-centroid", "-12.5", "--json", "--out", "g.img"});
  ASSERT_EQ(given.status, 0) << given.err;
  EXPECT_EQ(numbers_of(given.out, "doppler_centroid_hz").at(0), -12.5);
}

}  // namespace focus_test
}  // namespace sarsim::test
