// Focusing of flights that are not straight: motion compensation, back-projection onto the ground, autofocus.

#include <cmath>
#include <cstdint>
#include <numbers>
#include <regex>
#include <sstream>
#include <stdexcept>

#include <gmock/gmock.h>

#include "program.hpp"

namespace sarsim::test {
namespace focus_motion_test {

using testing::Each;
using testing::HasSubstr;
using testing::Lt;
using testing::SizeIs;

const std::string strip = SARSIM_SOURCE_DIR "/examples/stripmap_motion.scr";

// Magnitudes of all numbers that follow a name in JSON.
std::vector<double> magnitudes_of(const std::string& json, const std::string& name) {
  std::vector<double> numbers;
  const std::regex pattern("\"" + name + "\": (-?[0-9.eE+-]+)");
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

constexpr double period_s = 2.5;

// The script of the example with a track that is straight but for `error_m` times a sine across it, 60 points strewn
// over the strip, and compressed echoes, which are whole at the window's end.
std::string script_with_error(double error_m) {
  std::string points;
  for (int i = 0; i <= 60; ++i) {
    const double time_s = -3.0 + 0.1 * i;
    points += std::to_string(time_s) + ", " +
              std::to_string(-8000.0 + error_m * std::sin(2.0 * std::numbers::pi / period_s * time_s + 0.5)) + "\n";
  }
  std::string targets;
  std::uint64_t draw = 12345;
  const auto share = [&draw] {
    draw = (draw * 1103515245U + 12345U) % 2147483648U;
    return static_cast<double>(draw) / 2147483648.0;
  };
  for (int i = 0; i < 60; ++i) {
    const std::string x = std::to_string(-330.0 + 11.0 * i + 8.0 * share());
    targets +=
        "$TARGET Earth\n" + x + ", " + std::to_string(-110.0 + 220.0 * share()) + ", 0\n0, 0, 0\n10, 0\nISOTROPIC\n";
  }
  std::string text = text_of(strip);
  const auto replace = [&text](const std::string& from, const std::string& to, const std::string& by) {
    const std::size_t begin = text.find(from);
    const std::size_t end = text.find(to, begin);
    if (begin == std::string::npos || end == std::string::npos) throw std::runtime_error("the example has no " + from);
    text.replace(begin, end - begin, by);
  };
  replace("25                                       ! points of x", "NOT_ALIGNED",
          "2\n-3, -450\n3, 450\n61\n" + points + "1\n0, 3000\n");
  replace("! The near row", "$RADAR", targets);
  replace("RAW ", "! processing", "MATCHED_FILTER ");
  return text;
}

// Root mean square of what phases along the track lack of those of the sine, but for a constant and a straight line,
// which move the image.
double residual_rad(const std::string& csv, double error_m) {
  // An antenna that is e nearer turns its echoes by +4 pi/lambda e cos(depression).
  const double scale = 4.0 * std::numbers::pi * 9.6e9 / 299792458.0 * error_m * 8000.0 / std::hypot(8000.0, 3000.0);
  std::vector<double> x, y;
  std::istringstream lines(csv.substr(csv.find('\n') + 1));
  char comma = 0;
  for (double along_m = 0.0, phase = 0.0; lines >> along_m >> comma >> phase;) {
    if (std::abs(along_m) > 300.0) continue;  // where points are
    x.push_back(along_m);
    y.push_back(phase - scale * std::sin(2.0 * std::numbers::pi / period_s * along_m / 150.0 + 0.5));
  }
  const double n = static_cast<double>(x.size());
  const double mean_x = mean_of(x);
  const double mean_y = mean_of(y);
  double xx = 0.0, xy = 0.0, rest = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    xx += (x[i] - mean_x) * (x[i] - mean_x);
    xy += (x[i] - mean_x) * (y[i] - mean_y);
  }
  for (std::size_t i = 0; i < x.size(); ++i) rest += std::pow(y[i] - mean_y - xy / xx * (x[i] - mean_x), 2.0) / n;
  return std::sqrt(rest);
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
  EXPECT_THAT(focus.err,
              HasSubstr("motion compensation of second order: the track deviates from the fitted line by up to"));
  EXPECT_THAT(focus.err, testing::Not(HasSubstr("deviates from the straight line")));
  const std::string found = sarsim({"measure", "image.img", "--json"}).out;
  // Nine points on each other's sidelobes, and the change of the delay over range and beam that is left over: a
  // hundredth of the cells of 0.9 m and 1.5 m.
  EXPECT_THAT(magnitudes_of(found, "azimuth_error_m"), testing::AllOf(SizeIs(9), Each(Lt(0.02))));
  EXPECT_THAT(magnitudes_of(found, "range_error_m"), testing::AllOf(SizeIs(9), Each(Lt(0.02))));
  EXPECT_THAT(magnitudes_of(found, "phase_error_rad"), Each(Lt(0.01)));
  EXPECT_THAT(magnitudes_of(found, "amplitude_error_db"), Each(Lt(0.1)));
}

TEST_F(FocusMotion, IsBlurredWithoutCompensationAndTurnedAtOtherRangesWithTheFirstOrder) {
  // The peaks that are left lie beside their places and are weaker by 6 dB; others are lost.
  const std::string blurred = measured({strip, "--motion-compensation", "none"}, "none.img");
  EXPECT_EQ(number_of(blurred, "found_targets"), 0.0);
  EXPECT_THAT(magnitudes_of(blurred, "amplitude_error_db"), Each(testing::Gt(5.0)));
  const auto errors = [&](const char* order) {
    return mean_of(magnitudes_of(measured({strip, "--motion-compensation", order}), "phase_error_rad"));
  };
  // 100 m nearer or farther the line of sight is 0.26 degrees steeper or flatter: 0.8 m across count 3.6 mm, 1.4 rad.
  EXPECT_GT(errors("first"), 0.1);
  EXPECT_LT(errors("second"), 0.01);
  const Finished plain = sarsim({"focus", strip, "--motion-compensation", "none", "--out", "plain.img"});
  EXPECT_THAT(plain.err, HasSubstr("deviates from the straight line"));
}

// The example with its beam turned forward and the ground 700 m farther on, where it meets the targets.
std::string script_that_looks_forward() {
  std::string text = text_of(strip);
  const auto replace = [&text](const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    if (at == std::string::npos) throw std::runtime_error("the example has no " + from);
    text.replace(at, from.size(), to);
  };
  const std::string blanks(34, ' ');
  replace("0, 0, 0" + blanks + "! (m) x, y, z of its origin", "700, 0, 0 ! its origin");
  replace("0      " + blanks + "! (deg) azimuth", "5 ! azimuth");
  replace("8344   ", "8373   ");
  replace("8744   ", "8773   ");
  return text;
}

TEST_F(FocusMotion, IsCompensatedAlongTheLookOfASquintedBeam) {
  write_text(folder_ / "forward.scr", script_that_looks_forward());
  const std::string found = measured({"forward.scr", "--algorithm", "omega-k"});
  // Out of the middle of the beam, a aside, (4 pi/lambda) e a sin(squint) is left of what the antenna strays: it moves
  // the image by up to e sin(squint). Compensated straight across the track it would move by 1.4 to 3 m.
  const double max_m = 0.93 * 700.0 / std::hypot(8000.0, 3000.0, 700.0);
  EXPECT_THAT(magnitudes_of(found, "azimuth_error_m"), testing::AllOf(SizeIs(9), Each(Lt(max_m))));
  EXPECT_THAT(magnitudes_of(found, "range_error_m"), testing::AllOf(SizeIs(9), Each(Lt(0.02))));
  EXPECT_THAT(magnitudes_of(found, "amplitude_error_db"), Each(Lt(0.1)));
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

TEST_F(FocusMotion, ByBackProjectionNeedsNoneOnTheGround) {
  const std::string found =
      measured({strip, "--algorithm", "back-projection", "--grid", "ground", "--doppler-bandwidth", "450"});
  EXPECT_THAT(magnitudes_of(found, "azimuth_error_m"), testing::AllOf(SizeIs(9), Each(Lt(0.01))));
  EXPECT_THAT(magnitudes_of(found, "range_error_m"), testing::AllOf(SizeIs(9), Each(Lt(0.01))));
  EXPECT_THAT(magnitudes_of(found, "phase_error_rad"), Each(Lt(0.01)));
  // The band is counted from the line, not from the antenna's own heading, which would make 1.8 dB of it.
  EXPECT_THAT(magnitudes_of(found, "amplitude_error_db"), Each(Lt(0.15)));
  EXPECT_THAT(text_of(folder_ / "image.hdr"), HasSubstr("image plane = {ground grid}"));
}

TEST_F(FocusMotion, OnTheGroundIsWiderByTheInclinationOfTheSight) {
  const std::string slant = measured({strip, "--algorithm", "back-projection", "--doppler-bandwidth", "450"});
  const std::string ground =
      measured({strip, "--algorithm", "back-projection", "--grid", "ground", "--doppler-bandwidth", "450"});
  // Of target 5, the fifth of four numbers each: theory and finding of azimuth and range.
  const double ratio = magnitudes_of(ground, "width_m").at(19) / magnitudes_of(slant, "width_m").at(19);
  EXPECT_NEAR(ratio, std::hypot(8000.0, 3000.0) / 8000.0, 0.01);
}

TEST_F(FocusMotion, ThatNavigationDoesNotKnowIsTakenOutByAutofocus) {
  constexpr double error_m = 0.012;  // 4.5 rad
  write_text(folder_ / "true.scr", script_with_error(error_m));
  write_text(folder_ / "told.scr", script_with_error(0.0));
  ASSERT_EQ(sarsim({"run", "true.scr", "--format", "npy", "--quiet"}).status, 0);
  const std::vector<std::string> told{"stripmap_motion.npy", "--script", "told.scr"};
  const double blurred_db = mean_of(magnitudes_of(measured(told, "image.img"), "amplitude_error_db"));
  const Finished focus = sarsim({"focus", "stripmap_motion.npy", "--script", "told.scr", "--autofocus",
                                 "--autofocus-phase", "phase.csv", "--out", "sharp.img", "--json"});
  ASSERT_EQ(focus.status, 0) << focus.err;
  const Finished measure = sarsim({"measure", "sharp.img", "--json"});
  EXPECT_GT(blurred_db, 3.0);
  EXPECT_LT(mean_of(magnitudes_of(measure.out, "amplitude_error_db")), 0.6);
  EXPECT_LT(number_of(focus.out, "entropy_after"), 0.9 * number_of(focus.out, "entropy_before"));
  EXPECT_THAT(focus.err, HasSubstr("autofocus removed"));
  EXPECT_THAT(focus.out, HasSubstr("\"applied\": true"));
  const std::string csv = text_of(folder_ / "phase.csv");
  EXPECT_THAT(csv, testing::StartsWith("along_m,phase_rad\n"));
  EXPECT_LT(residual_rad(csv, error_m), 0.4);
}

TEST_F(FocusMotion, LeavesAnImageAloneThatAutofocusWouldNotSharpen) {
  const std::string script = SARSIM_SOURCE_DIR "/examples/sar_r.scr";
  const Finished focus = sarsim({"focus", script, "--out", "a.img", "--autofocus", "--json"});
  ASSERT_EQ(focus.status, 0) << focus.err;
  ASSERT_EQ(sarsim({"focus", script, "--out", "b.img", "--quiet"}).status, 0);
  const bool applied = focus.out.find("\"applied\": true") != std::string::npos;
  if (applied) {
    EXPECT_LT(number_of(focus.out, "entropy_after"), number_of(focus.out, "entropy_before"));
  }
  EXPECT_EQ(text_of(folder_ / "a.img") == text_of(folder_ / "b.img"), !applied);
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
  refused({"--autofocus", "--autofocus-piece", "1e6"}, "autofocus cannot use sub-apertures of 1e+06 m");
  refused({"--autofocus", "--memory", "4M"}, "autofocus needs the whole image in memory");
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
  const Finished focus = sarsim({"focus", "odd.scr", "--quiet", "--algorithm", "omega-k"});
  EXPECT_EQ(focus.status, 2);
  EXPECT_THAT(focus.err, HasSubstr("the along-track pulse spacing changes by up to"));
  EXPECT_THAT(focus.err, HasSubstr("use --algorithm back-projection"));
  const Finished left_open = sarsim({"focus", "odd.scr", "--json", "--azimuth", "-20:20"});
  EXPECT_EQ(left_open.status, 0) << left_open.err;
  EXPECT_THAT(left_open.out, HasSubstr("\"algorithm\": \"back-projection\""));
  EXPECT_THAT(left_open.err, HasSubstr("back-projection instead of omega-k: the along-track pulse spacing changes by"));
}

// An aircraft that speeds up is at both ends of the flight farther than the line that fits it best: the compensated
// flight has its middle elsewhere.
TEST_F(FocusMotion, OfAnAircraftThatSpeedsUpShowsTargetsWhereTheyAre) {
  std::string points = "61\n";
  for (int i = 0; i <= 60; ++i) {
    const double time_s = -3.0 + 0.1 * i;
    points += std::to_string(time_s) + ", " + std::to_string(150.0 * time_s + 0.3 * time_s * time_s) + "\n";
  }
  std::string text = text_of(strip);
  const std::size_t begin = text.find("25                                       ! points of x");
  const std::size_t end = text.find("25                                       ! points of y");
  ASSERT_LT(begin, end);
  ASSERT_NE(end, std::string::npos);
  write_text(folder_ / "faster.scr", text.replace(begin, end - begin, points));
  const std::string found = measured({"faster.scr"});
  EXPECT_THAT(magnitudes_of(found, "azimuth_error_m"), testing::AllOf(SizeIs(9), Each(Lt(0.05))));
  EXPECT_THAT(magnitudes_of(found, "amplitude_error_db"), Each(Lt(0.2)));
  // All algorithms count from one place, and their areas mean the same.
  const std::vector<double> places = magnitudes_of(found, "azimuth_m");
  for (const char* algorithm : {"range-doppler", "back-projection"}) {
    const std::string part = measured({"faster.scr", "--algorithm", algorithm, "--azimuth", "-20:20"}, "part.img");
    const std::vector<double> others = magnitudes_of(part, "azimuth_m");
    EXPECT_NEAR(others.at(0), places.at(0), 1e-6) << algorithm;
    EXPECT_THAT(part, HasSubstr("\"outside_image\": true")) << algorithm;
    EXPECT_THAT(magnitudes_of(part, "azimuth_error_m"),
                testing::AllOf(testing::Not(testing::IsEmpty()), Each(Lt(0.05))))
        << algorithm;
  }
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
  // Measured it is that of the echoes as they came, which the flown sway moves.
  EXPECT_NEAR(centroid_hz("odd.scr", "measured"), centroid_hz("even.scr", "measured"), 20.0);
}

}  // namespace focus_motion_test
}  // namespace sarsim::test
