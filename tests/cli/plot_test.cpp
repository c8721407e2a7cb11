#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>

#include "program.hpp"

namespace sarsim::test {
namespace plot_test {

std::string signature(const std::filesystem::path& path, std::size_t length) { return text_of(path).substr(0, length); }

// Width of a PNG, from its header.
unsigned png_width(const std::filesystem::path& path) {
  const std::string bytes = text_of(path);
  unsigned width = 0;
  for (std::size_t i = 16; i < 20; ++i) width = width << 8U | static_cast<unsigned char>(bytes.at(i));
  return width;
}

using Plot = CommandTest;

TEST_F(Plot, OfAScriptIsAPictureOfTheAskedSize) {
  write_scene({});
  const Finished done = sarsim({"plot", "scene.scr", "-o", "a.png", "--size", "400", "300", "--scale", "2"});
  EXPECT_EQ(done.status, 0) << done.err;
  EXPECT_EQ(signature(folder_ / "a.png", 4), "\x89PNG");
  EXPECT_EQ(png_width(folder_ / "a.png"), 800U);
}

TEST_F(Plot, IsWrittenAsSvgAndPdfToo) {
  write_scene({});
  EXPECT_EQ(sarsim({"plot", "scene.scr", "-o", "a.svg", "--size", "400", "300"}).status, 0);
  EXPECT_EQ(sarsim({"plot", "scene.scr", "-o", "a.pdf", "--size", "400", "300"}).status, 0);
  EXPECT_NE(text_of(folder_ / "a.svg").find("<svg"), std::string::npos);
  EXPECT_EQ(signature(folder_ / "a.pdf", 4), "%PDF");
}

TEST_F(Plot, OfAFileOfSamplesNeedsNoScript) {
  write_scene({});
  ASSERT_EQ(sarsim({"run", "scene.scr", "--format", "npy", "--quiet"}).status, 0);
  const Finished done = sarsim({"plot", "sim.npy", "-o", "b.png", "--show", "db"});
  EXPECT_EQ(done.status, 0) << done.err;
  EXPECT_EQ(signature(folder_ / "b.png", 4), "\x89PNG");
}

TEST_F(Plot, OfAPulseGivesItsValuesAsATable) {
  write_scene({});
  const Finished done = sarsim({"plot", "scene.scr", "--kind", "pulse", "-o", "c.png", "--csv", "c.csv"});
  EXPECT_EQ(done.status, 0) << done.err;
  const std::string table = text_of(folder_ / "c.csv");
  EXPECT_EQ(table.substr(0, table.find('\n')), "slant range [m],I [V],Q [V],magnitude [V],phase [deg]");
  EXPECT_GT(std::count(table.begin(), table.end(), '\n'), 10);
}

TEST_F(Plot, OfDopplerAgainstTimeGivesMeanAndWidthOfEachSpectrum) {
  write_scene({});
  const Finished done =
      sarsim({"plot", "scene.scr", "--kind", "doppler-time", "--interval", "2", "-o", "t.png", "--csv", "t.csv"});
  EXPECT_EQ(done.status, 0) << done.err;
  EXPECT_EQ(signature(folder_ / "t.png", 4), "\x89PNG");
  const std::string table = text_of(folder_ / "t.csv");
  EXPECT_EQ(table.substr(0, table.find('\n')), "Azimuth time [s],mean [Hz],width (r.m.s.) [Hz]");
  EXPECT_GE(std::count(table.begin(), table.end(), '\n'), 2);
  const Finished wrong = sarsim({"plot", "scene.scr", "--kind", "doppler", "--interval", "2", "-o", "u.png"});
  EXPECT_NE(wrong.status, 0);
  EXPECT_THAT(wrong.err, testing::HasSubstr("--interval means nothing for --kind doppler"));
  EXPECT_THAT(wrong.err, testing::HasSubstr("it is for doppler-time"));
}

TEST_F(Plot, DrawsMapsOfPathsAndFootprints) {
  write_scene({});
  const Finished track =
      sarsim({"plot", "scene.scr", "--kind", "track", "-o", "a.svg", "--csv", "a.csv", "--time", "0", "1"});
  EXPECT_EQ(track.status, 0) << track.err;
  EXPECT_NE(text_of(folder_ / "a.svg").find("<svg"), std::string::npos);
  const Finished footprint = sarsim({"plot", "scene.scr", "--kind", "footprint", "-o", "b.png"});
  EXPECT_NE(footprint.status, 0);  // The antenna is isotropic.
  EXPECT_THAT(footprint.err, testing::HasSubstr("isotropic and has no footprint"));
  const Finished other = sarsim({"plot", "scene.scr", "--kind", "track", "-o", "c.png", "--range", "0", "1"});
  EXPECT_THAT(other.err, testing::HasSubstr("--range means nothing for --kind track"));
}

TEST_F(Plot, DrawsACurveForEachValueAndEachInput) {
  SceneText scene;
  scene.noise_k = "0";
  write_scene(scene);
  const Finished varied = sarsim({"plot", "scene.scr", "--kind", "pulse", "--vary", "Target1.rcs=1,4", "--recorded",
                                  "--show", "magnitude", "--csv", "v.csv", "-o", "v.svg"});
  ASSERT_EQ(varied.status, 0) << varied.err;
  std::istringstream table(text_of(folder_ / "v.csv"));
  std::string line;
  std::getline(table, line);
  EXPECT_NE(line.find("Target1.rcs=1"), std::string::npos) << line;
  EXPECT_NE(line.find("Target1.rcs=4"), std::string::npos) << line;
  double largest = 0.0;
  while (std::getline(table, line)) {
    double range = 0.0, one = 0.0, four = 0.0;
    ASSERT_EQ(std::sscanf(line.c_str(), "%lf,%lf,%lf", &range, &one, &four), 3) << line;
    EXPECT_NEAR(four, 2.0 * one, 1e-5 * four + 1e-30);  // Amplitude goes with the root of the cross-section.
    largest = std::max(largest, one);
  }
  EXPECT_GT(largest, 0.0);
  ASSERT_EQ(sarsim({"run", "scene.scr", "--format", "hdf5", "--quiet"}).status, 0);
  const Finished with =
      sarsim({"plot", "scene.scr", "--kind", "pulse", "--with", "sim.h5", "--show", "real", "-o", "w.png"});
  EXPECT_EQ(with.status, 0) << with.err;
  EXPECT_EQ(signature(folder_ / "w.png", 4), "\x89PNG");
}

TEST_F(Plot, RefusesCurvesThatDoNotFitTogether) {
  write_scene({});
  const std::vector<std::string> pulse{"plot", "scene.scr", "--kind", "pulse", "-o", "a.png"};
  const auto refused = [&](std::vector<std::string> more, const std::string& words) {
    std::vector<std::string> all = pulse;
    all.insert(all.end(), more.begin(), more.end());
    const Finished done = sarsim(all);
    EXPECT_EQ(done.status, 2);
    EXPECT_NE(done.err.find(words), std::string::npos) << done.err;
  };
  refused({"--vary", "Target1.rcs=1..6"}, "6 curves in one picture cannot be told apart");
  refused({"--vary", "Target9.rcs=1,2"}, "Target9");
  refused({"--with", "none.h5"}, "none.h5");
  const Finished picture = sarsim({"plot", "scene.scr", "--vary", "Target1.rcs=1,2", "-o", "a.png"});
  EXPECT_NE(picture.err.find("--vary means nothing for --kind picture"), std::string::npos) << picture.err;
  write_text(folder_ / "precious.scr", text_of(folder_ / "scene.scr"));
  refused({"--with", "precious.scr", "--csv", "precious.scr", "--force"}, "precious.scr");
  EXPECT_EQ(text_of(folder_ / "precious.scr"), text_of(folder_ / "scene.scr"));
}

TEST_F(Plot, LeavesWhatStandsUnderTheName) {
  write_scene({});
  write_text(folder_ / "a.png", "mine");
  const Finished refused = sarsim({"plot", "scene.scr", "-o", "a.png"});
  EXPECT_EQ(refused.status, 2);
  EXPECT_EQ(text_of(folder_ / "a.png"), "mine");
  EXPECT_EQ(sarsim({"plot", "scene.scr", "-o", "a.png", "--force"}).status, 0);
  EXPECT_EQ(signature(folder_ / "a.png", 4), "\x89PNG");
}

TEST_F(Plot, IntoAFolderThatIsNotThereFailsInWordsAndLeavesNothing) {
  write_scene({});
  const Finished done = sarsim({"plot", "scene.scr", "-o", "none/a.png"});
  EXPECT_NE(done.status, 0);
  EXPECT_NE(done.err.find("none"), std::string::npos) << done.err;
}

// A limit of the system may not cut a picture off.
TEST_F(Plot, ThatCannotBeDrawnWholeIsNotThere) {
  const std::string scene = SARSIM_SOURCE_DIR "/examples/mti.scr";
  const auto words = [&](const char* out) {
    return std::vector<std::string>{"plot", scene, "--kind", "antenna", "-o", out};
  };
  ASSERT_EQ(sarsim(words("whole.svg")).status, 0);
  Start start;
  start.folder = folder_;
  const auto whole = static_cast<long>(std::filesystem::file_size(folder_ / "whole.svg"));
  for (const long limit : {whole - 2000, 5000L}) {
    start.largest_file_bytes = limit;
    Program limited(words("cut.svg"), start);
    const Finished done = limited.finish();
    EXPECT_EQ(done.status, 1) << done.err;
    EXPECT_NE(done.err.find("File too large"), std::string::npos) << done.err;
    EXPECT_EQ(entries("."), std::vector<std::string>{"whole.svg"});
  }
}

TEST_F(Plot, DrawsEveryKind) {
  write_scene({});
  for (const char* kind :
       {"picture", "pulse", "range", "profile", "doppler", "spectrum", "phase", "antenna", "sent", "function"}) {
    const Finished done =
        sarsim({"plot", "scene.scr", "--kind", kind, "-o", "kind.png", "--size", "300", "200", "--force"});
    EXPECT_EQ(done.status, 0) << kind << '\n' << done.err;
    EXPECT_EQ(signature(folder_ / "kind.png", 4), "\x89PNG") << kind;
  }
}

using PlotTable = CommandTest;

// A table without its heading: numbers by row.
std::vector<std::vector<double>> numbers_of(const std::string& table) {
  std::vector<std::vector<double>> rows;
  std::istringstream lines(table);
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line) && !line.empty()) {
    std::istringstream cells(line);
    std::string cell;
    rows.emplace_back();
    while (std::getline(cells, cell, ',')) rows.back().push_back(std::stod(cell));
  }
  return rows;
}

// Where the magnitude of a cut is largest.
double strongest_place(const std::vector<std::vector<double>>& rows) {
  return std::ranges::max_element(rows, {}, [](const std::vector<double>& row) { return row[3]; })->front();
}

// How wide the highest peak of a cut is where the magnitude is above 1/sqrt(2) of it.
double half_power_width(const std::vector<std::vector<double>>& rows) {
  const auto peak = std::ranges::max_element(rows, {}, [](const std::vector<double>& row) { return row[3]; });
  const double level = (*peak)[3] / std::sqrt(2.0);
  const auto below = [level](const std::vector<double>& row) { return row[3] < level; };
  const auto end = std::find_if(peak, rows.end(), below);
  const auto begin = std::find_if(std::make_reverse_iterator(peak), rows.rend(), below);
  return end->front() - begin->front();
}

std::string heading_of(const std::string& table) { return table.substr(0, table.find('\n')); }

TEST_F(PlotTable, IsWrittenWithoutAPictureWhereNoneIsWanted) {
  write_scene({});
  const Finished done = sarsim({"plot", "scene.scr", "--kind", "range", "--csv", "a.csv"});
  EXPECT_EQ(done.status, 0) << done.err;
  EXPECT_EQ(heading_of(text_of(folder_ / "a.csv")), "azimuth time [s],I [V],Q [V],magnitude [V],phase [deg]");
  EXPECT_EQ(numbers_of(text_of(folder_ / "a.csv")).size(), 20U);
  EXPECT_EQ(entries("."), (std::vector<std::string>{"a.csv", "scene.scr"}));
}

// The echo of 1000 ns fills 150 of the 500 m, from 1000 m on: the middle of the window, 1150 m, is its last sample.
TEST_F(PlotTable, ARangeThatNobodyNamedIsThatOfTheEchoes) {
  SceneText scene;
  scene.noise_k = "0";
  scene.target_m = 960.0;
  write_scene(scene);
  const auto largest = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"plot", "scene.scr", "--kind", "range", "--csv", "a.csv", "--force"});
    EXPECT_EQ(sarsim(more).status, 0);
    double value = 0.0;
    for (const auto& row : numbers_of(text_of(folder_ / "a.csv"))) value = std::max(value, row[3]);
    return value;
  };
  EXPECT_EQ(largest({"--at-range", "1150"}), 0.0);
  EXPECT_GT(largest({}), 0.0);
  EXPECT_NEAR(largest({}) / largest({"--at-range", "1030"}), 1.0, 1e-6);
}

TEST_F(PlotTable, OfTheRecordedSamplesIsWhatARunSaves) {
  write_scene({});
  ASSERT_EQ(sarsim({"run", "scene.scr", "--format", "hdf5", "--quiet"}).status, 0);
  ASSERT_EQ(sarsim({"plot", "scene.scr", "--kind", "pulse", "--recorded", "--csv", "script.csv"}).status, 0);
  const Finished done = sarsim({"plot", "sim.h5", "--kind", "pulse", "--csv", "file.csv"});
  ASSERT_EQ(done.status, 0) << done.err;
  const auto script = numbers_of(text_of(folder_ / "script.csv"));
  const auto file = numbers_of(text_of(folder_ / "file.csv"));
  EXPECT_EQ(heading_of(text_of(folder_ / "file.csv")), heading_of(text_of(folder_ / "script.csv")));
  ASSERT_EQ(script.size(), file.size());
  ASSERT_GT(script.size(), 10U);
  double largest = 0.0;
  for (const auto& row : script) largest = std::max(largest, row[3]);
  for (std::size_t i = 0; i < script.size(); ++i) {
    EXPECT_NEAR(script[i][0], file[i][0], 1e-6);
    EXPECT_NEAR(script[i][1], file[i][1], 1e-6 * largest);
    EXPECT_NEAR(script[i][2], file[i][2], 1e-6 * largest);
  }
}

TEST_F(PlotTable, OfARadarViewIsTheSameOfScriptAndFile) {
  SceneText scene;
  scene.noise_k = "0";
  write_scene(scene);
  ASSERT_EQ(sarsim({"run", "scene.scr", "--format", "hdf5", "--quiet"}).status, 0);
  for (const char* kind : {"profile", "doppler", "spectrum", "phase"}) {
    ASSERT_EQ(sarsim({"plot", "scene.scr", "--kind", kind, "--csv", "script.csv", "--force"}).status, 0);
    const Finished done = sarsim({"plot", "sim.h5", "--kind", kind, "--csv", "file.csv", "--force"});
    ASSERT_EQ(done.status, 0) << done.err;
    const auto script = numbers_of(text_of(folder_ / "script.csv"));
    const auto file = numbers_of(text_of(folder_ / "file.csv"));
    EXPECT_EQ(heading_of(text_of(folder_ / "file.csv")), heading_of(text_of(folder_ / "script.csv"))) << kind;
    ASSERT_EQ(script.size(), file.size()) << kind;
    ASSERT_GT(script.size(), 10U) << kind;
    double low = script[0][1];
    double high = low;
    for (const auto& row : script) low = std::min(low, row[1]), high = std::max(high, row[1]);
    // Far below the largest the 24 bits of the file show.
    for (std::size_t i = 0; i < script.size(); ++i) {
      const double tolerance = script[i][1] > high - 0.5 * (high - low) ? 1e-2 : 1.0;
      EXPECT_NEAR(script[i][1], file[i][1], tolerance * (high - low)) << kind;
    }
  }
}

TEST_F(PlotTable, TakesTimesAndRangesOfABareFileFromItsScript) {
  write_scene({});
  ASSERT_EQ(sarsim({"run", "scene.scr", "--quiet"}).status, 0);
  const Finished bare =
      sarsim({"plot", "sim.bin", "--columns", "100", "--bits", "8", "--kind", "phase", "--csv", "a.csv"});
  EXPECT_EQ(bare.status, 2);
  EXPECT_NE(bare.err.find("--script"), std::string::npos) << bare.err;
  const Finished done = sarsim({"plot", "sim.bin", "--script", "scene.scr", "--kind", "phase", "--csv", "a.csv"});
  EXPECT_EQ(done.status, 0) << done.err;
  EXPECT_EQ(heading_of(text_of(folder_ / "a.csv")), "Azimuth time [s],Unwrapped phase [deg]");
}

TEST_F(PlotTable, OfABareFileGoesByNumbersInCounts) {
  write_scene({});
  ASSERT_EQ(sarsim({"run", "scene.scr", "--format", "csv", "--quiet"}).status, 0);
  const Finished done = sarsim({"plot", "sim.csv", "--kind", "pulse", "--csv", "a.csv"});
  EXPECT_EQ(done.status, 0) << done.err;
  EXPECT_EQ(heading_of(text_of(folder_ / "a.csv")), "sample,I [counts],Q [counts],magnitude [counts],phase [deg]");
}

TEST_F(PlotTable, TakesAsManyPulsesAsAreWantedAboutATime) {
  write_scene({});
  ASSERT_EQ(
      sarsim({"plot", "scene.scr", "--kind", "phase", "--pulses", "5", "--at-time", "0", "--csv", "a.csv"}).status, 0);
  const auto first = numbers_of(text_of(folder_ / "a.csv"));
  ASSERT_EQ(first.size(), 5U);
  EXPECT_EQ(first[0][0], 0.0);
}

TEST_F(PlotTable, OfTheSamplingFrequencyThatIsAskedFor) {
  write_scene({});
  ASSERT_EQ(sarsim({"plot", "scene.scr", "--kind", "pulse", "--recorded", "--rate", "1e9", "--csv", "a.csv"}).status,
            0);
  const auto rows = numbers_of(text_of(folder_ / "a.csv"));
  ASSERT_GT(rows.size(), 2U);
  EXPECT_NEAR(rows[1][0] - rows[0][0], 0.149896, 1e-6);
}

TEST_F(PlotTable, OfRowsOfMillionsOfSamplesIsOfAllOfThem) {
  write_scene({});
  // 2 x 4e11 Hz x 500 m / c are 1.3 million samples.
  for (const bool recorded : {true, false}) {
    std::vector<std::string> words{"plot",       "scene.scr", "--kind", "range", "--pulses", "2",
                                   "--at-range", "1000.0123", "--rate", "4e11",  "--csv",    "a.csv",
                                   "--force",    "--time",    "0",      "0.002"};
    if (recorded) words.emplace_back("--recorded");
    const Finished done = sarsim(words);
    ASSERT_EQ(done.status, 0) << done.err;
    EXPECT_EQ(numbers_of(text_of(folder_ / "a.csv")).size(), 2U);
  }
  const Finished refused = sarsim({"plot", "scene.scr", "--kind", "spectrum", "--rate", "1e13", "--csv", "b.csv"});
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("is too long"), std::string::npos) << refused.err;
  EXPECT_NE(refused.err.find("--rate"), std::string::npos) << refused.err;
}

TEST_F(PlotTable, OfAFocusedImageHasAzimuthAndRange) {
  const std::string scene = SARSIM_SOURCE_DIR "/examples/sar_r.scr";
  ASSERT_EQ(sarsim({"focus", scene, "--out", "r.img", "--quiet"}).status, 0);
  // One target stands at the origin, nearest to the aircraft at azimuth 0, sqrt(10000^2 + 2000^2) m away.
  const Finished done =
      sarsim({"plot", "r.img", "--kind", "pulse", "--at-azimuth", "0", "--range", "10190", "10205", "--csv", "a.csv"});
  ASSERT_EQ(done.status, 0) << done.err;
  EXPECT_EQ(heading_of(text_of(folder_ / "a.csv")), "slant range [m],I [V],Q [V],magnitude [V],phase [deg]");
  EXPECT_NEAR(strongest_place(numbers_of(text_of(folder_ / "a.csv"))), 10198.04, 0.07);
  // c/(2 x 100 MHz) times 0.886, to a sample of a sixteenth of a metre.
  EXPECT_NEAR(half_power_width(numbers_of(text_of(folder_ / "a.csv"))), 1.328, 0.065);
  const Finished column = sarsim(
      {"plot", "r.img", "--kind", "range", "--at-range", "10198.04", "--azimuth", "-30", "30", "--csv", "b.csv"});
  ASSERT_EQ(column.status, 0) << column.err;
  const auto rows = numbers_of(text_of(folder_ / "b.csv"));
  EXPECT_EQ(heading_of(text_of(folder_ / "b.csv")), "azimuth [m],I [V],Q [V],magnitude [V],phase [deg]");
  EXPECT_GE(rows.front()[0], -30.0);
  EXPECT_LE(rows.back()[0], 30.0);
  EXPECT_NEAR(strongest_place(rows), 0.0, 0.03);
  EXPECT_NEAR(half_power_width(rows), 0.65, 0.02);
  const Finished pixels = sarsim({"plot", "r.img", "--kind", "range", "--at-range", "10198.04", "--azimuth", "-30",
                                  "30", "--recorded", "--csv", "c.csv"});
  ASSERT_EQ(pixels.status, 0) << pixels.err;
  const auto coarse = numbers_of(text_of(folder_ / "c.csv"));
  ASSERT_EQ(rows.size(), (coarse.size() - 1) * 16 + 1);
  for (std::size_t i = 0; i < coarse.size(); ++i) {
    EXPECT_NEAR(rows[16 * i][0], coarse[i][0], 1e-9);
    EXPECT_NEAR(rows[16 * i][1], coarse[i][1], 1e-15);
  }
  // Rows are counted, not what lies between them.
  ASSERT_EQ(sarsim({"plot", "r.img", "--kind", "range", "--at-azimuth", "0", "--pulses", "5", "--csv", "d.csv"}).status,
            0);
  const auto five = numbers_of(text_of(folder_ / "d.csv"));
  ASSERT_EQ(five.size(), 4U * 16U + 1U);
  EXPECT_NEAR(five.back()[0] - five.front()[0], 4.0 * (coarse[1][0] - coarse[0][0]), 1e-6);
}

TEST_F(Plot, OfAFocusedImageShowsTheLargestSampleOfEachPixel) {
  ASSERT_EQ(sarsim({"focus", SARSIM_SOURCE_DIR "/examples/sar_r.scr", "--out", "r.img", "--quiet"}).status, 0);
  for (const auto& [option, picture] : {std::pair{"--peak", "asked.png"}, std::pair{"--dark", "dark.png"}})
    ASSERT_EQ(sarsim({"plot", "r.img", "--show", "db", option, "-o", picture}).status, 0);
  ASSERT_EQ(sarsim({"plot", "r.img", "--show", "db", "-o", "usual.png"}).status, 0);
  EXPECT_EQ(text_of(folder_ / "usual.png"), text_of(folder_ / "asked.png"));
  EXPECT_NE(text_of(folder_ / "usual.png"), text_of(folder_ / "dark.png"));
}

TEST_F(PlotTable, OfAFunctionFindsItByTheBeginningOfItsName) {
  const std::string scene = SARSIM_SOURCE_DIR "/examples/thesis_figure_4_12.scr";
  ASSERT_EQ(
      sarsim({"plot", scene, "--kind", "function", "--function", "mover:traj", "--compare", "--csv", "a.csv"}).status,
      0);
  EXPECT_EQ(heading_of(text_of(folder_ / "a.csv")), "Time [s],linear [m],cubic splines [m],low-pass filter [m]");
}

TEST_F(PlotTable, OfAPictureWhoseRowsHaveNoTimesGoesByTheirNumbers) {
  const std::string scene = SARSIM_SOURCE_DIR "/examples/search_radar.scr";
  ASSERT_EQ(sarsim({"search", scene, "--out", "ppi.h5", "--quiet"}).status, 0);
  for (const char* kind : {"phase", "doppler"}) {
    const Finished done = sarsim({"plot", "ppi.h5", "--kind", kind, "--csv", "a.csv"});
    EXPECT_EQ(done.status, 2) << kind;
    EXPECT_NE(done.err.find("lacks the times"), std::string::npos) << done.err;
  }
  EXPECT_EQ(sarsim({"plot", "ppi.h5", "--kind", "range", "--time", "0", "1", "--csv", "a.csv"}).status, 2);
  const Finished done = sarsim({"plot", "ppi.h5", "--kind", "range", "--csv", "b.csv"});
  ASSERT_EQ(done.status, 0) << done.err;
  const std::string table = text_of(folder_ / "b.csv");
  EXPECT_EQ(heading_of(table), "pulse,I [V],Q [V],magnitude [V],phase [deg]");
  EXPECT_EQ(table.find("nan"), std::string::npos);
  EXPECT_EQ(numbers_of(table).at(3)[0], 3.0);
}

using PlotArguments = CommandTest;

TEST_F(PlotArguments, ThatNameNothingToWriteAreRefused) {
  write_scene({});
  const Finished done = sarsim({"plot", "scene.scr"});
  EXPECT_EQ(done.status, 2);
  EXPECT_NE(done.err.find("-o"), std::string::npos) << done.err;
}

TEST_F(PlotArguments, NamingAFunctionThatIsNotThereSayWhichAre) {
  const std::string scene = SARSIM_SOURCE_DIR "/examples/thesis_figure_4_12.scr";
  const Finished done = sarsim({"plot", scene, "--kind", "function", "--function", "Mover:rotation", "--csv", "a.csv"});
  EXPECT_EQ(done.status, 2);
  EXPECT_NE(done.err.find("Mover:trajectory_m"), std::string::npos) << done.err;
  const Finished none =
      sarsim({"plot", SARSIM_SOURCE_DIR "/examples/thesis_a2.scr", "--kind", "function", "--csv", "a.csv"});
  EXPECT_EQ(none.status, 2);
  EXPECT_NE(none.err.find("no user-defined function"), std::string::npos) << none.err;
}

TEST_F(PlotArguments, WantingWhatAKindDoesNotShowAreRefused) {
  write_scene({});
  for (const auto& [kind, show] : {std::pair{"profile", "phase"}, std::pair{"doppler", "real"},
                                   std::pair{"phase", "db"}, std::pair{"antenna", "imaginary"}}) {
    const Finished done = sarsim({"plot", "scene.scr", "--kind", kind, "--show", show, "--csv", "a.csv"});
    EXPECT_EQ(done.status, 2) << kind;
    EXPECT_NE(done.err.find("--show"), std::string::npos) << done.err;
  }
}

TEST_F(PlotArguments, ThatWouldBeIgnoredAreRefusedAllAtOnce) {
  write_scene({});
  const Finished done =
      sarsim({"plot", "scene.scr", "--kind", "pulse", "--angles", "0", "1", "--padding", "2", "--csv", "a.csv"});
  EXPECT_EQ(done.status, 2);
  EXPECT_NE(done.err.find("--angles means nothing for --kind pulse"), std::string::npos) << done.err;
  EXPECT_NE(done.err.find("it is for antenna"), std::string::npos) << done.err;
  EXPECT_NE(done.err.find("--padding"), std::string::npos) << done.err;
  EXPECT_EQ(sarsim({"plot", "scene.scr", "--simulation", "1", "--radar", "Radar1", "--csv", "a.csv"}).status, 2);
}

TEST_F(PlotArguments, ThatContradictEachOtherAreRefused) {
  write_scene({});
  const auto plot = [&](std::vector<std::string> words) {
    words.insert(words.begin(), {"plot", "scene.scr", "--csv", "a.csv", "--force"});
    return sarsim(words);
  };
  const auto refused = [&](std::vector<std::string> words, const char* text) {
    const Finished done = plot(std::move(words));
    EXPECT_EQ(done.status, 2) << text;
    EXPECT_NE(done.err.find(text), std::string::npos) << done.err;
  };
  refused({"--screen", "--rate", "1e8"}, "--screen and --rate request different samples");
  refused({"--kind", "pulse", "--screen", "--recorded"}, "--screen and --recorded request different samples");
  refused({"--span", "40"}, "--span is a number of decibels");
  refused({"--kind", "pulse", "--show", "real", "--span", "40"}, "add --show db");
  refused({"--kind", "phase", "--span", "40"}, "--span means nothing for --kind phase");
  refused({"--kind", "sent", "--show", "db"}, "--show means nothing for --kind sent");
  for (const char* kind : {"profile", "spectrum", "sent"}) EXPECT_EQ(plot({"--kind", kind, "--span", "40"}).status, 0);
  for (const char* kind : {"pulse", "antenna"})
    EXPECT_EQ(plot({"--kind", kind, "--show", "db", "--span", "40"}).status, 0);
}

TEST_F(PlotArguments, ThatAreNoFiniteNumbersAreRefused) {
  write_scene({});
  for (const char* option : {"--time", "--range", "--azimuth", "--limits", "--angles"})
    for (const auto& [first, last] :
         {std::pair{"nan", "nan"}, std::pair{"nan", "5200"}, std::pair{"inf", "1"}, std::pair{"0", "1e999"}}) {
      const Finished done = sarsim({"plot", "scene.scr", option, first, last, "--csv", "a.csv"});
      EXPECT_EQ(done.status, 2) << option << ' ' << first;
      EXPECT_NE(done.err.find(std::string(option) + ": '"), std::string::npos) << done.err;
      EXPECT_NE(done.err.find("is not a number"), std::string::npos) << done.err;
    }
  EXPECT_EQ(sarsim({"plot", "scene.scr", "--range", "950", "1.05e3", "--csv", "a.csv"}).status, 0);
}

TEST_F(PlotArguments, WantingAnglesBeyondATurnAreRefused) {
  write_scene({});
  for (const auto& [first, last] : {std::pair{"-1e308", "1e308"}, std::pair{"-361", "0"}, std::pair{"0", "360.5"}}) {
    const Finished done = sarsim({"plot", "scene.scr", "--kind", "antenna", "--angles", first, last, "--csv", "a.csv"});
    EXPECT_EQ(done.status, 2);
    EXPECT_NE(done.err.find("-360 to 360 deg"), std::string::npos) << done.err;
  }
  EXPECT_EQ(sarsim({"plot", "scene.scr", "--kind", "antenna", "--angles", "-360", "360", "--csv", "a.csv"}).status, 0);
}

TEST_F(PlotArguments, ForEchoesAreRefusedWhereNoneAreShown) {
  write_scene({});
  for (const char* kind : {"antenna", "sent", "function"}) {
    const Finished done = sarsim({"plot",     "scene.scr", "--kind", kind,          "--range", "1",      "2",
                                  "--time",   "3",         "4",      "--rate",      "5",       "--data", "compressed",
                                  "--screen", "--seed",    "1",      "--tolerance", "1e-3",    "--csv",  "a.csv"});
    EXPECT_EQ(done.status, 2) << kind;
    for (const char* option : {"--range", "--time", "--rate", "--data", "--screen", "--seed", "--tolerance"})
      EXPECT_NE(done.err.find(std::string(option) + " means nothing for --kind " + kind), std::string::npos)
          << done.err;
  }
  const Finished done = sarsim({"plot", "scene.scr", "--kind", "function", "--radar", "Radar1", "--csv", "a.csv"});
  EXPECT_NE(done.err.find("--radar means nothing for --kind function"), std::string::npos) << done.err;
  EXPECT_EQ(sarsim({"plot", "scene.scr", "--kind", "sent", "--radar", "Radar1", "--csv", "a.csv"}).status, 0);
}

TEST_F(PlotArguments, WantingAPlaceThatIsNotSeenSayWhatIs) {
  write_scene({});
  const Finished range = sarsim({"plot", "scene.scr", "--kind", "range", "--at-range", "5000", "--csv", "a.csv"});
  EXPECT_EQ(range.status, 2);
  EXPECT_NE(range.err.find("from 900 to"), std::string::npos) << range.err;
  const Finished time = sarsim({"plot", "scene.scr", "--kind", "pulse", "--at-time", "-1", "--csv", "a.csv"});
  EXPECT_EQ(time.status, 2);
  EXPECT_NE(time.err.find("Azimuth time -1 s"), std::string::npos) << time.err;
}

TEST_F(PlotArguments, WantingAnAntennaOfAFileAreRefused) {
  write_scene({});
  ASSERT_EQ(sarsim({"run", "scene.scr", "--format", "npy", "--quiet"}).status, 0);
  const Finished done = sarsim({"plot", "sim.npy", "--kind", "antenna", "--csv", "a.csv"});
  EXPECT_EQ(done.status, 2);
  EXPECT_NE(done.err.find(".scr"), std::string::npos) << done.err;
}

TEST_F(PlotArguments, MixingUpTimeAndAzimuthAreRefused) {
  write_scene({});
  EXPECT_EQ(sarsim({"plot", "scene.scr", "--azimuth", "0", "1", "--csv", "a.csv"}).status, 2);
  ASSERT_EQ(sarsim({"run", "scene.scr", "--format", "hdf5", "--quiet"}).status, 0);
  const Finished azimuth = sarsim({"plot", "sim.h5", "--kind", "range", "--azimuth", "0", "1", "--csv", "a.csv"});
  EXPECT_EQ(azimuth.status, 2);
  EXPECT_NE(azimuth.err.find("focused image"), std::string::npos) << azimuth.err;
  const Finished nothing = sarsim({"plot", "sim.h5", "--kind", "range", "--time", "50", "60", "--csv", "a.csv"});
  EXPECT_EQ(nothing.status, 2);
  EXPECT_NE(nothing.err.find("nothing between"), std::string::npos) << nothing.err;
}

TEST_F(PlotArguments, WantingTheTableOfAPictureOfAFileAreRefused) {
  write_scene({});
  ASSERT_EQ(sarsim({"run", "scene.scr", "--format", "npy", "--quiet"}).status, 0);
  const Finished done = sarsim({"plot", "sim.npy", "--csv", "a.csv"});
  EXPECT_EQ(done.status, 2);
  EXPECT_NE(done.err.find("sarsim convert"), std::string::npos) << done.err;
}

TEST_F(PlotArguments, OfAnotherKindOfPictureAreRefused) {
  write_scene({});
  const Finished done = sarsim({"plot", "scene.scr", "-o", "a.gif"});
  EXPECT_EQ(done.status, 2);
  EXPECT_NE(done.err.find(".png, .svg or .pdf"), std::string::npos) << done.err;
}

TEST_F(PlotArguments, NamingASimulationThatIsNotThereAreRefused) {
  write_scene({});
  const Finished done = sarsim({"plot", "scene.scr", "--simulation", "9", "-o", "a.png"});
  EXPECT_EQ(done.status, 2);
  EXPECT_NE(done.err.find("no recording 9"), std::string::npos) << done.err;
}

TEST_F(PlotArguments, NamingAFileThatIsNotThereAreRefused) {
  EXPECT_NE(sarsim({"plot", "nothing.npy", "-o", "a.png"}).status, 0);
}

TEST_F(Plot, OfTheSceneIsOnePictureOrMany) {
  write_scene({});
  const Finished one = sarsim({"plot", "scene.scr", "--kind", "scene", "--size", "320", "240", "-o", "a.png"});
  EXPECT_EQ(one.status, 0) << one.err;
  EXPECT_EQ(png_width(folder_ / "a.png"), 320U);
  const std::string from_start = text_of(folder_ / "a.png");
  for (const std::vector<std::string>& view : {std::vector<std::string>{"--view", "top"},
                                               {"--view", "beam"},
                                               {"--look", "10", "45"},
                                               {"--perspective"},
                                               {"--dark"}}) {
    std::vector<std::string> words{"plot", "scene.scr", "--kind", "scene", "--size",
                                   "320",  "240",       "-o",     "b.png", "--force"};
    words.insert(words.end(), view.begin(), view.end());
    const Finished other = sarsim(words);
    EXPECT_EQ(other.status, 0) << view[0] << other.err;
    EXPECT_NE(text_of(folder_ / "b.png"), from_start) << view[0];
  }
  const std::vector<std::string> film{"plot", "scene.scr", "--kind", "scene", "--frames", "3",  "--size",
                                      "320",  "240",       "--time", "0",     "1",        "-o", "film.png"};
  EXPECT_EQ(sarsim(film).status, 0);
  for (const char* name : {"film-0001.png", "film-0002.png", "film-0003.png"})
    EXPECT_EQ(png_width(folder_ / name), 320U) << name;
  EXPECT_FALSE(std::filesystem::exists(folder_ / "film.png"));
  const Finished again = sarsim(film);
  EXPECT_EQ(again.status, 2);
  EXPECT_NE(again.err.find("film-0001.png"), std::string::npos) << again.err;
}

TEST_F(PlotArguments, OfASceneThatContradictOrMeanNothingAreRefused) {
  write_scene({});
  ASSERT_EQ(sarsim({"run", "scene.scr", "--format", "npy", "--quiet"}).status, 0);
  const auto refused = [&](std::vector<std::string> more, const std::string& message) {
    more.insert(more.begin(), {"plot", "scene.scr", "-o", "a.png"});
    const Finished done = sarsim(more);
    EXPECT_EQ(done.status, 2) << message;
    EXPECT_NE(done.err.find(message), std::string::npos) << done.err;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "a.png"));
  };
  const std::string kind = "--kind";
  refused({kind, "scene", "--time", "0", "1"}, "--frames");
  refused({kind, "scene", "--at-time", "0", "--frames", "2"}, "--at-time and --frames");
  refused({kind, "scene", "--view", "top", "--look", "1", "2"}, "--view and --look");
  refused({kind, "scene", "--look", "1", "91"}, "91 deg");
  refused({kind, "scene", "--follow", "Nobody"}, "no platform 'Nobody'");
  refused({kind, "scene", "--radar", "Nobody"}, "Nobody");
  refused({kind, "scene", "--title", "A"}, "--title");
  refused({kind, "scene", "--show", "db"}, "--show means nothing for --kind scene");
  refused({kind, "pulse", "--frames", "2"}, "--frames means nothing for --kind pulse");
  const Finished file = sarsim({"plot", "sim.npy", "--kind", "scene", "-o", "a.png"});
  EXPECT_EQ(file.status, 2);
  EXPECT_NE(file.err.find("is no scene"), std::string::npos) << file.err;
}

}  // namespace plot_test
}  // namespace sarsim::test
