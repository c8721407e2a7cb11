// Focusing of flights that climb, squint, speed up or end early, each a script made to measure.

#include <cmath>
#include <functional>
#include <numbers>
#include <sstream>

#include <gmock/gmock.h>

#include "program.hpp"
#include "report_numbers.hpp"

namespace sarsim::test {
namespace focus_geometry_test {

using testing::Each;
using testing::HasSubstr;
using testing::SizeIs;

struct Point {
  double x_m = 0.0;
  double y_m = 0.0;
};

// A flight along x at 150 m/s, 8 km beside the points and 3 km above them, at 9.6 GHz with 100 MHz: cells of 1.33 m.
struct Flight {
  std::vector<Point> points = {{}};
  double first_range_m = 8444.0;
  double last_range_m = 8644.0;
  double half_s = 1.0;
  double prf_hz = 500.0;
  double beam_deg = 1.2;
  double squint_deg = 0.0;
  double climb_mps = 0.0;
  double acceleration_mps2 = 0.0;
  const char* processing = "RAW";
  std::function<double(double)> along_m = [](double) { return 0.0; };  // besides even speed
  std::function<double(double)> aside_m = [](double) { return 0.0; };
};

template <class... Parts>
std::string joined(const Parts&... parts) {
  std::ostringstream out;
  out.precision(12);
  (out << ... << parts);
  return out.str();
}

std::string script_of(const Flight& flight) {
  const auto track = [&](const std::function<double(double)>& place_m) {
    constexpr double step_s = 0.05;
    const int half = static_cast<int>(std::ceil(flight.half_s / step_s)) + 4;
    std::string text = joined(2 * half + 1, "\n");
    for (int i = -half; i <= half; ++i) text += joined(step_s * i, ", ", place_m(step_s * i), "\n");
    return text;
  };
  const std::string still = "CONST\n0, 0, 0\n0, 0, 0\nSTDDEV\n0, 0, 0\nSTDDEV\n0, 0, 0\n";
  std::string text = "$PLATFORM Earth\nSTATIONARY\n0, 0, 0\n" + still;
  text += "$PLATFORM Plane\nTRAJECTORY\nCUBIC\nCUBIC\nCUBIC\nINLINE\n";
  text += track([&](double t) { return 150.0 * t + 0.5 * flight.acceleration_mps2 * t * t + flight.along_m(t); });
  text += track([&](double t) { return -8000.0 + flight.aside_m(t); });
  text += track([&](double t) { return 3000.0 + flight.climb_mps * t; });
  text += "NOT_ALIGNED\n" + still;
  for (const Point& point : flight.points)
    text += joined("$TARGET Earth\n", point.x_m, ", ", point.y_m, ", 0\n0, 0, 0\n10, 0\nISOTROPIC\n");
  text += joined("$RADAR\nRadar1\nPlane\nCHIRP\n0.1\n2000\nRECT\nCONSTANT\n", flight.prf_hz,
                 "\nSINGLE\n9.6\n1\n0\n0\nSINX\n10\n", flight.beam_deg, "\nSAME\nFIXED\n-20.56\n", flight.squint_deg,
                 "\nRECT\nNO_STC\n");
  text += joined("$SIMULATION\nRadar1\n", flight.first_range_m, "\n", flight.last_range_m, "\n", -flight.half_s, "\n",
                 flight.half_s, "\n8\n0.15\n0\nNPY\n", flight.processing, "\necho.npy\nBEGIN\n1\n1\n");
  return text;
}

// Points ahead, under a squint angle counted on the ground, in a window 200 m long.
Flight squinted(double degrees) {
  const double ahead_m = 8000.0 * std::tan(degrees * std::numbers::pi / 180.0);
  const double range_m = std::hypot(8000.0, 3000.0, ahead_m);
  Flight flight;
  flight.points = {{ahead_m, -30.0}, {ahead_m + 40.0, 30.0}};
  flight.squint_deg = degrees;
  flight.beam_deg = 0.6;
  flight.first_range_m = range_m - 100.0;
  flight.last_range_m = range_m + 100.0;
  return flight;
}

class FocusGeometry : public CommandTest {
 protected:
  // Focuses a script or a recording, and measures the image.
  [[nodiscard]] std::string measured(std::vector<std::string> words) const {
    words.insert(words.begin(), "focus");
    for (const char* word : {"--out", "image.img", "--force", "--quiet"}) words.emplace_back(word);
    const Finished focus = sarsim(words);
    EXPECT_EQ(focus.status, 0) << focus.err;
    const Finished measure = sarsim({"measure", "image.img", "--json"});
    EXPECT_EQ(measure.status, 0) << measure.err;
    return measure.out;
  }
  void write(const Flight& flight, const std::string& name = "scene.scr") const {
    write_text(folder_ / name, script_of(flight));
  }
  void expect_refused(std::vector<std::string> words, const std::string& what, const std::string& hint) const {
    words.insert(words.begin(), {"focus", "scene.scr", "--quiet", "--out", "image.img"});
    const Finished run = sarsim(words);
    EXPECT_EQ(run.status, 2) << run.err;
    EXPECT_THAT(run.err, HasSubstr(what));
    EXPECT_THAT(run.err, HasSubstr(hint));
    EXPECT_FALSE(std::filesystem::exists(folder_ / "image.img"));
  }
};

const auto small = [](double most) { return testing::AllOf(testing::Gt(-most), testing::Lt(most)); };

// Ratio of what was found to theory; `axis` 0: azimuth, 1: range.
std::vector<double> width_ratios(const std::string& json, std::size_t axis) {
  const std::vector<double> widths = numbers_of(json, "width_m");  // of each target theory and finding, two axes each
  std::vector<double> ratios;
  for (std::size_t i = 0; i + 3 < widths.size(); i += 4) ratios.push_back(widths[i + 2 + axis] / widths[i + axis]);
  return ratios;
}

TEST_F(FocusGeometry, OfAClimbingFlightIsWholeOnTheGround) {
  // Seen across a climb of 1 in 5 from 3000 m, the ground lies 600 m ahead.
  Flight flight;
  flight.climb_mps = 30.0;
  flight.points = {{480.0, -20.0}, {700.0, 20.0}};
  flight.beam_deg = 30.0;
  flight.squint_deg = 4.0;
  write(flight);
  const std::string found =
      measured({"scene.scr", "--algorithm", "back-projection", "--grid", "ground", "--doppler-bandwidth", "100"});
  EXPECT_THAT(numbers_of(found, "azimuth_error_m"), testing::AllOf(SizeIs(2), Each(small(0.02))));
  EXPECT_THAT(numbers_of(found, "range_error_m"), testing::AllOf(SizeIs(2), Each(small(0.02))));
  EXPECT_THAT(numbers_of(found, "amplitude_error_db"), Each(small(0.1)));
  EXPECT_THAT(numbers_of(found, "phase_error_rad"), Each(small(0.02)));
  EXPECT_THAT(width_ratios(found, 0), Each(testing::DoubleNear(1.0, 0.01)));
}

TEST_F(FocusGeometry, UnderSquintIsAsSharpOnTheGroundAsByTheory) {
  write(squinted(20.0));
  const std::string found =
      measured({"scene.scr", "--algorithm", "back-projection", "--grid", "ground", "--doppler-bandwidth", "100"});
  EXPECT_THAT(numbers_of(found, "range_error_m"), testing::AllOf(SizeIs(2), Each(small(0.02))));
  EXPECT_THAT(numbers_of(found, "amplitude_error_db"), Each(small(0.1)));
  EXPECT_THAT(width_ratios(found, 1), Each(testing::DoubleNear(1.0, 0.01)));
}

TEST_F(FocusGeometry, UnderSquintIsMeasuredAcrossTheLineOfSight) {
  // On which the response under 18.6 degrees' squint is cos 18.6 = 0.948 as wide as along the track. Theory cuts the
  // band between whole pulses.
  write(squinted(20.0));
  const std::string found = measured({"scene.scr", "--doppler-bandwidth", "100"});
  EXPECT_THAT(width_ratios(found, 0), testing::AllOf(SizeIs(2), Each(testing::DoubleNear(1.0, 0.015))));
  // The Doppler frequency changes by the cube of that cosine more slowly: 0.7 dB more pulses in the band.
  EXPECT_THAT(numbers_of(found, "amplitude_error_db"), Each(small(0.2)));
}

TEST_F(FocusGeometry, ByBackProjectionSamplesWhatSidelobesOfTheAntennaSee) {
  // Half a row of 0.3 m beside a sample, where rows that alias lose most: 0.9 dB at 500 pulses a second.
  Flight flight;
  flight.points = {{0.15, 0.0}};
  flight.half_s = 2.7;
  flight.first_range_m = 8514.0;
  flight.last_range_m = 8590.0;
  write(flight);
  const std::string found = measured({"scene.scr", "--algorithm", "back-projection"});
  EXPECT_THAT(numbers_of(found, "amplitude_error_db"), testing::AllOf(SizeIs(1), Each(small(0.05))));
  EXPECT_THAT(width_ratios(found, 0), Each(testing::DoubleNear(1.0, 0.01)));
}

TEST_F(FocusGeometry, ByBackProjectionHasTheAmplitudeOfThePulsesThatWereFlown) {
  // 150 Hz take 0.89 s, of which the outer points have 0.65 s and 0.45 s.
  Flight flight;
  flight.points = {{-120.0, 0.0}, {0.0, 0.0}, {150.0, 0.0}};
  flight.beam_deg = 6.0;
  write(flight);
  const auto errors_db = [&](const char* algorithm) {
    return numbers_of(measured({"scene.scr", "--algorithm", algorithm, "--doppler-bandwidth", "150"}),
                      "amplitude_error_db");
  };
  EXPECT_THAT(errors_db("back-projection"), testing::AllOf(SizeIs(3), Each(small(0.05))));
  EXPECT_THAT(errors_db("omega-k"), testing::AllOf(SizeIs(3), Each(small(0.1))));
}

TEST_F(FocusGeometry, OfAFlightThatSpeedsUpHasTheAmplitudeOfEvenPulsesAlongTheLine) {
  // From 130 to 170 m/s: pulse by pulse the mean would favour slow parts by up to 1.2 dB.
  Flight flight;
  flight.points = {{-100.0, 0.0}, {100.0, 0.0}};
  flight.acceleration_mps2 = 20.0;
  write(flight);
  const std::string found = measured({"scene.scr"});
  EXPECT_THAT(numbers_of(found, "amplitude_error_db"), testing::AllOf(SizeIs(2), Each(small(0.1))));
}

TEST_F(FocusGeometry, CompensatesMotionAboutTheDopplerCentroidThatItIsToldOrMeasures) {
  Flight flight;
  const double ahead_m = 8000.0 * std::tan(1.0 * std::numbers::pi / 180.0);
  flight.points = {{ahead_m - 60.0, 0.0}, {ahead_m + 60.0, 0.0}};
  flight.beam_deg = 0.6;
  flight.half_s = 1.5;
  flight.squint_deg = 1.0;
  flight.processing = "MATCHED_FILTER";
  flight.along_m = [](double t) { return 3.0 * std::sin(2.0 * std::numbers::pi * t / 1.5); };
  flight.aside_m = [](double t) { return 0.8 * std::sin(2.0 * std::numbers::pi * t / 1.9); };
  write(flight, "true.scr");
  ASSERT_EQ(sarsim({"run", "true.scr", "--quiet"}).status, 0);
  const double known_db = numbers_of(measured({"true.scr"}), "amplitude_error_db").at(0);
  // Who believes that the beam looks straight aside takes out the motion of another place.
  flight.squint_deg = 0.0;
  write(flight, "told.scr");
  // 2 V/lambda sin a, the angle to the points' mean.
  const double centroid_hz = 300.0 * 9.6e9 / 299792458.0 * ahead_m / std::hypot(8000.0, 3000.0, ahead_m);
  const auto peaks = [&](const std::string& centroid) {
    return numbers_of(measured({"echo.npy", "--script", "told.scr", "--doppler-centroid", centroid}), "amplitude_v");
  };
  const std::vector<double> sharp = numbers_of(measured({"echo.npy", "--script", "true.scr"}), "amplitude_v");
  EXPECT_LT(std::abs(known_db), 0.3);
  ASSERT_EQ(sharp.size(), 4u);
  for (const std::string& centroid : {joined(centroid_hz), std::string("measured")}) {
    const std::vector<double> found = peaks(centroid);
    ASSERT_EQ(found.size(), 4u) << centroid;
    for (const std::size_t i : {1u, 3u}) EXPECT_NEAR(found[i] / sharp[i], 1.0, 0.03) << centroid;
  }
}

Flight strayed() {
  Flight flight;
  flight.half_s = 0.5;
  flight.aside_m = [](double t) { return 0.8 * std::sin(6.0 * t); };
  return flight;
}

TEST_F(FocusGeometry, SaysAtOnceWhatCannotBe) {
  write(strayed());
  expect_refused({"--height", "-1e5"}, "the ground is beyond all ranges of the recording",
                 "give the ground another --height");
  const auto expect_early = [&](std::vector<std::string> words, const std::string& what) {
    words.insert(words.begin(), {"focus", "scene.scr", "--out", "image.img"});
    const Finished run = sarsim(words);
    EXPECT_EQ(run.status, 2) << run.err;
    EXPECT_THAT(run.err, HasSubstr(what));
    EXPECT_THAT(run.err, testing::Not(HasSubstr("image.img"))) << "work began";
  };
  expect_early({"--doppler-centroid", "nonsense"}, "--doppler-centroid: invalid 'nonsense'");
  expect_early({"--doppler-bandwidth", "9999"}, "the processed Doppler bandwidth exceeds the PRF");
  expect_early({"--autofocus", "--autofocus-piece", "1e6"}, "autofocus cannot use sub-apertures of 1e+06 m");
  expect_early({"--autofocus", "--memory", "1M"}, "but --memory allows 1.05 MB");
}

TEST_F(FocusGeometry, MakesTheFolderOfThePhasesOrSaysThatItCannot) {
  write(strayed());
  const Finished run = sarsim({"focus", "scene.scr", "--quiet", "--autofocus", "--autofocus-phase", "new/deep/p.csv"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(std::filesystem::exists(folder_ / "new/deep/p.csv"));
  expect_refused({"--autofocus", "--autofocus-phase", "scene.scr/p.csv"}, "'scene.scr' is not a folder",
                 "give the output another name");
}

TEST_F(FocusGeometry, NeverReplacesTheScriptThatARecordingIsReadWith) {
  Flight flight = strayed();
  flight.processing = "MATCHED_FILTER";
  write(flight);
  const std::string script = text_of(folder_ / "scene.scr");
  ASSERT_EQ(sarsim({"run", "scene.scr", "--quiet"}).status, 0);
  for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
           {"--out", "scene.scr"}, {"--out", "image.img", "--autofocus", "--autofocus-phase", "./scene.scr"}}) {
    std::vector<std::string> all{"focus", "echo.npy", "--script", "scene.scr", "--force", "--quiet"};
    all.insert(all.end(), words.begin(), words.end());
    const Finished run = sarsim(all);
    EXPECT_EQ(run.status, 2);
    EXPECT_THAT(run.err, HasSubstr("the output would replace the file that it is made from"));
    EXPECT_EQ(text_of(folder_ / "scene.scr"), script);
  }
}

TEST_F(FocusGeometry, SaysThatTheAntennaTurnsBack) {
  Flight flight;
  flight.along_m = [](double t) { return -100.0 * t - 100.0 * t * t; };
  write(flight);
  expect_refused({"--algorithm", "omega-k"}, "the antenna reverses along its track", "use --algorithm back-projection");
  const Finished left_open = sarsim({"focus", "scene.scr", "--out", "image.img", "--json"});
  EXPECT_EQ(left_open.status, 0) << left_open.err;
  EXPECT_THAT(left_open.out, HasSubstr("\"algorithm\": \"back-projection\""));
  EXPECT_THAT(left_open.err,
              HasSubstr("back-projection instead of omega-k: the antenna flies around the scene, not along a line"));
}

TEST_F(FocusGeometry, OfAFewPulsesOrRowsIsLeftWithoutAutofocus) {
  Flight flight;
  flight.half_s = 0.01;
  write(flight);
  expect_refused({"--autofocus"}, "autofocus needs an image of 16 rows or more; this one has",
                 "do without --autofocus");
}

TEST_F(FocusGeometry, OfAShortApertureHasPiecesOfSixteenRows) {
  // A tenth of 30 m is less than sixteen rows of 0.3 m.
  Flight flight;
  flight.half_s = 0.1;
  flight.beam_deg = 10.0;
  write(flight);
  const Finished run = sarsim(
      {"focus", "scene.scr", "--out", "image.img", "--autofocus", "--json", "--quiet", "--doppler-bandwidth", "400"});
  EXPECT_EQ(run.status, 0) << run.err;
}

TEST_F(FocusGeometry, OfAVerticalFlightHasNoGroundGrid) {
  Flight flight;
  flight.half_s = 0.2;
  flight.climb_mps = 50.0;
  flight.along_m = [](double t) { return -150.0 * t; };
  write(flight);
  const std::vector<std::string> words{"focus",  "scene.scr", "--quiet",  "--algorithm", "back-projection",
                                       "--grid", "ground",    "--height", "10"};
  const Finished run = sarsim(words);
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.err, HasSubstr("the antenna flies vertically"));
  EXPECT_THAT(run.err, testing::Not(HasSubstr("--height")));
}

}  // namespace focus_geometry_test
}  // namespace sarsim::test
