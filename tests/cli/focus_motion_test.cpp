// Focusing of flights that are not straight: motion compensation, back-projection onto the ground, autofocus.

#include <cmath>
#include <regex>

#include <gmock/gmock.h>

#include "program.hpp"

namespace sarsim::test {
namespace {

using testing::Each;
using testing::HasSubstr;
using testing::Lt;
using testing::SizeIs;

const std::string strip = SARSIM_SOURCE_DIR "/examples/stripmap_motion.scr";

// Magnitudes of all numbers that follow a name in JSON.
std::vector<double> magnitudes_of(const std::string& json, const std::string& name) {
  std::vector<double> numbers;
  const std::regex pattern("\"" + name + "\": (-?[0-9.e+-]+)");
  for (std::sregex_iterator i(json.begin(), json.end(), pattern), end; i != end; ++i)
    numbers.push_back(std::abs(std::stod((*i)[1])));
  return numbers;
}

double number_of(const std::string& json, const std::string& name) { return magnitudes_of(json, name).at(0); }

double mean_of(const std::vector<double>& numbers) {
  double sum = 0.0;
  for (const double number : numbers) sum += number / static_cast<double>(numbers.size());
  return sum;
}

// The script of the example with the y of its track replaced: -8000 m and `error_m` times a sine of 2.5 s.
std::string script_with_error(double error_m) {
  std::string text = text_of(strip);
  std::string points;
  for (int i = 0; i <= 60; ++i) {
    const double time_s = -3.0 + 0.1 * i;
    points += std::to_string(time_s) + ", " + std::to_string(-8000.0 + error_m * std::sin(2.513 * time_s + 0.5)) + "\n";
  }
  const std::size_t y = text.find("25                                       ! points of y");
  const std::size_t z = text.find("25                                       ! points of z");
  EXPECT_NE(y, std::string::npos);
  EXPECT_NE(z, std::string::npos);
  // Height and speed without errors, too.
  const std::size_t rest = text.find("NOT_ALIGNED", z);
  text.replace(y, rest - y, "61\n" + points + "1\n0, 3000\n");
  const std::size_t x = text.find("25                                       ! points of x");
  text.replace(x, text.find("61\n", x) - x, "2\n-3, -450\n3, 450\n");
  return text;
}

class FocusMotion : public CommandTest {
 protected:
  // Focuses, and measures the image.
  [[nodiscard]] std::string measured(std::vector<std::string> words, const std::string& image = "image.img") const {
    words.insert(words.begin(), "focus");
    for (const char* word : {"--out", image.c_str(), "--force", "--quiet"}) words.emplace_back(word);
    const Finished focus = sarsim(words);
    EXPECT_EQ(focus.status, 0) << focus.err;
    const Finished measure = sarsim({"measure", image, "--json"});
    EXPECT_EQ(measure.status, 0) << measure.err;
    return measure.out;
  }
};

TEST_F(FocusMotion, IsCompensatedToTheSecondOrderWithoutBeingAsked) {
  const Finished focus = sarsim({"focus", strip, "--out", "image.img", "--json"});
  ASSERT_EQ(focus.status, 0) << focus.err;
  EXPECT_THAT(focus.out, HasSubstr("\"motion_compensation\": \"second\""));
  EXPECT_THAT(focus.err, HasSubstr("motion compensation of second order: the antenna strays by up to"));
  EXPECT_THAT(focus.err, testing::Not(HasSubstr("leaves the straight line")));
  const std::string found = sarsim({"measure", "image.img", "--json"}).out;
  // Nine points on each other's sidelobes, and the change of the delay over range and beam that is left over: a
  // hundredth of the cells of 0.9 m and 1.5 m.
  EXPECT_THAT(magnitudes_of(found, "azimuth_error_m"), testing::AllOf(SizeIs(9), Each(Lt(0.02))));
  EXPECT_THAT(magnitudes_of(found, "range_error_m"), testing::AllOf(SizeIs(9), Each(Lt(0.02))));
  EXPECT_THAT(magnitudes_of(found, "phase_error_rad"), Each(Lt(0.2)));
  EXPECT_THAT(magnitudes_of(found, "amplitude_error_db"), Each(Lt(0.1)));
}

TEST_F(FocusMotion, IsBlurredWithoutCompensationAndAtOtherRangesWithTheFirstOrder) {
  const auto losses = [&](const char* order) {
    return magnitudes_of(measured({strip, "--motion-compensation", order}), "amplitude_error_db");
  };
  EXPECT_GT(mean_of(losses("none")), 10.0);
  const double first = mean_of(losses("first"));
  const double second = mean_of(losses("second"));
  EXPECT_LT(first, 3.0);
  EXPECT_GT(first, 3.0 * second);
  const Finished plain = sarsim({"focus", strip, "--motion-compensation", "none", "--out", "plain.img"});
  EXPECT_THAT(plain.err, HasSubstr("leaves the straight line"));
}

TEST_F(FocusMotion, OfStraightFlightsIsNotCompensated) {
  const Finished focus =
      sarsim({"focus", SARSIM_SOURCE_DIR "/examples/sar_r.scr", "--out", "image.img", "--json", "--quiet"});
  EXPECT_THAT(focus.out, HasSubstr("\"motion_compensation\": \"none\""));
}

TEST_F(FocusMotion, GivesTheSameBytesInLittleMemoryAndOnAnyNumberOfThreads) {
  const auto image = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"focus", strip, "--out", "i.img", "--force", "--quiet", "--autofocus"});
    EXPECT_EQ(sarsim(more).status, 0);
    return text_of(folder_ / "i.img");
  };
  const std::string one = image({"--threads", "1"});
  EXPECT_FALSE(one.empty());
  EXPECT_EQ(image({"--threads", "3"}), one);
  const auto plain = [&](const std::string& memory) {
    EXPECT_EQ(sarsim({"focus", strip, "--out", "m.img", "--force", "--quiet", "--memory", memory}).status, 0);
    return text_of(folder_ / "m.img");
  };
  EXPECT_EQ(plain("4M"), plain("1G"));
}

TEST_F(FocusMotion, ByBackProjectionNeedsNoneOnSlantAndGroundGrids) {
  for (const char* grid : {"slant", "ground"}) {
    const std::string found = measured({strip, "--algorithm", "back-projection", "--grid", grid});
    EXPECT_THAT(magnitudes_of(found, "azimuth_error_m"), testing::AllOf(SizeIs(9), Each(Lt(0.02)))) << grid;
    EXPECT_THAT(magnitudes_of(found, "range_error_m"), testing::AllOf(SizeIs(9), Each(Lt(0.02)))) << grid;
    EXPECT_THAT(magnitudes_of(found, "phase_error_rad"), Each(Lt(0.05))) << grid;
    EXPECT_THAT(magnitudes_of(found, "amplitude_error_db"), Each(Lt(0.1))) << grid;
  }
  EXPECT_THAT(text_of(folder_ / "image.hdr"), HasSubstr("image plane = {ground grid}"));
}

TEST_F(FocusMotion, OnTheGroundIsWiderByTheInclinationOfTheSight) {
  const std::string slant = measured({strip, "--algorithm", "back-projection"});
  const std::string ground = measured({strip, "--algorithm", "back-projection", "--grid", "ground"});
  // Of target 5, the fifth of four numbers each: theory and finding of azimuth and range.
  const double ratio = magnitudes_of(ground, "width_m").at(19) / magnitudes_of(slant, "width_m").at(19);
  EXPECT_NEAR(ratio, std::hypot(8000.0, 3000.0) / 8000.0, 0.01);
}

TEST_F(FocusMotion, ThatNavigationDoesNotKnowIsTakenOutByAutofocus) {
  constexpr double error_m = 0.012;
  write_text(folder_ / "true.scr", script_with_error(error_m));
  write_text(folder_ / "told.scr", script_with_error(0.0));
  ASSERT_EQ(sarsim({"run", "true.scr", "--format", "npy", "--out", "data.npy", "--quiet"}).status, 0);
  const std::vector<std::string> told{"data.npy", "--script", "told.scr"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), told.begin(), told.end());
    return more;
  };
  const double blurred = mean_of(magnitudes_of(measured(with({})), "amplitude_error_db"));
  const Finished focus = sarsim({"focus", "data.npy", "--script", "told.scr", "--autofocus", "--autofocus-phase",
                                 "phase.csv", "--out", "sharp.img", "--json"});
  ASSERT_EQ(focus.status, 0) << focus.err;
  const Finished measure = sarsim({"measure", "sharp.img", "--json"});
  const double sharp = mean_of(magnitudes_of(measure.out, "amplitude_error_db"));
  EXPECT_GT(blurred, 2.0);
  EXPECT_LT(sharp, 0.3);
  EXPECT_LT(number_of(focus.out, "entropy_after"), number_of(focus.out, "entropy_before"));
  // An antenna that is e nearer turns its echoes by +4 pi/lambda e cos(20.56 deg); the rms of a sine, but for the
  // straight line that autofocus cannot see.
  const double expected_rad =
      4.0 * 3.14159265 * 9.6e9 / 299792458.0 * error_m * std::cos(20.56 / 57.29578) / std::sqrt(2.0);
  EXPECT_NEAR(number_of(focus.out, "rms_rad"), expected_rad, 0.2 * expected_rad);
  EXPECT_THAT(text_of(folder_ / "phase.csv"), testing::StartsWith("along_m,phase_rad\n"));
}

TEST_F(FocusMotion, SaysWhatDoesNotGoTogether) {
  const auto refused = [&](std::vector<std::string> words, const char* text) {
    words.insert(words.begin(), {"focus", strip, "--quiet"});
    const Finished run = sarsim(words);
    EXPECT_EQ(run.status, 2) << text;
    EXPECT_THAT(run.err, HasSubstr(text));
  };
  refused({"--grid", "ground"}, "add --algorithm back-projection");
  refused({"--start-stop"}, "--start-stop is for back-projection");
  refused({"--algorithm", "back-projection", "--motion-compensation", "first"}, "needs no motion compensation");
  refused({"--algorithm", "back-projection", "--grid", "ground", "--autofocus"}, "needs an image of slant range");
  refused({"--algorithm", "back-projection", "--grid", "ground", "--height", "-9000"},
          "give the ground another --height");
  refused({"--autofocus-piece", "10"}, "add --autofocus");
  refused({"--autofocus", "--autofocus-piece", "0"}, "--autofocus-piece must be above 0");
  refused({"--autofocus", "--autofocus-piece", "1e6"}, "autofocus cannot work on pieces of 1e+06 m");
  refused({"--autofocus", "--memory", "4M"}, "autofocus holds the image in memory");
  refused({"--motion-compensation", "third"}, "none, first, second");
}

// Intervals of 2, 1.8 and 2.2 ms one after the other.
std::string script_of_odd_times() {
  std::string text = text_of(strip);
  const std::string even = "CONSTANT                                 ! regular pulses\n500 ";
  const std::size_t at = text.find(even);
  EXPECT_NE(at, std::string::npos);
  return text.replace(at, even.size() - 4, "OTHER\nLINEAR\nINLINE\n3\n0, 0.002\n1, 0.0018\n2, 0.0022\n! ");
}

TEST_F(FocusMotion, OfPulsesAtOddTimesIsLeftToBackProjection) {
  write_text(folder_ / "odd.scr", script_of_odd_times());
  const Finished focus = sarsim({"focus", "odd.scr", "--quiet"});
  EXPECT_EQ(focus.status, 2);
  EXPECT_THAT(focus.err, HasSubstr("the distance between pulses changes by up to"));
  EXPECT_THAT(focus.err, HasSubstr("use --algorithm back-projection"));
  EXPECT_EQ(sarsim({"focus", "odd.scr", "--quiet", "--algorithm", "back-projection"}).status, 0);
}

TEST_F(FocusMotion, OfPulsesAtOddTimesKeepsItsDopplerCentroid) {
  // The last part of the flight alone: all targets are left behind.
  const auto late = [](std::string text) {
    const std::string start = "-2.7                                     ! (s) slow time, start";
    const std::size_t at = text.find(start);
    EXPECT_NE(at, std::string::npos);
    return text.replace(at, 4, "1.2");
  };
  write_text(folder_ / "even.scr", late(text_of(strip)));
  write_text(folder_ / "odd.scr", late(script_of_odd_times()));
  const auto centroid_hz = [&](const char* script, const char* kind) {
    const Finished focus = sarsim({"focus", script, "--quiet", "--json", "--force", "--algorithm", "back-projection",
                                   "--doppler-centroid", kind});
    EXPECT_EQ(focus.status, 0) << focus.err;
    return number_of(focus.out, "doppler_centroid_hz");
  };
  const double even_hz = centroid_hz("even.scr", "geometry");
  EXPECT_GT(even_hz, 30.0);
  EXPECT_NEAR(centroid_hz("odd.scr", "geometry"), even_hz, 1.0);
  EXPECT_NEAR(centroid_hz("odd.scr", "measured"), even_hz, 20.0);
}

}  // namespace
}  // namespace sarsim::test
