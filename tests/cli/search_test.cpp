#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstring>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>

#include <gmock/gmock.h>

#include "program.hpp"

namespace sarsim::test {
namespace search_test {

using testing::HasSubstr;
using testing::Not;

const std::string examples = SARSIM_SOURCE_DIR "/examples/";
constexpr double pi = 3.14159265358979323846;

using TableRow = std::map<std::string, std::string>;

std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields;
  std::istringstream in(line + ",");
  for (std::string field; std::getline(in, field, ',');) fields.push_back(field);
  return fields;
}

std::vector<TableRow> table_of(const std::filesystem::path& path) {
  std::ifstream in(path);
  std::string line;
  std::getline(in, line);
  const std::vector<std::string> names = fields_of(line);
  std::vector<TableRow> rows;
  while (std::getline(in, line)) {
    const std::vector<std::string> values = fields_of(line);
    EXPECT_EQ(values.size(), names.size()) << line;
    TableRow row;
    for (std::size_t i = 0; i < names.size() && i < values.size(); ++i) row[names[i]] = values[i];
    rows.push_back(row);
  }
  return rows;
}

std::vector<float> floats_of(const std::filesystem::path& path) {
  const std::string bytes = text_of(path);
  std::vector<float> values(bytes.size() / sizeof(float));
  std::memcpy(values.data(), bytes.data(), values.size() * sizeof(float));
  return values;
}

double header_number(const std::string& header, const std::string& name) {
  std::smatch match;
  EXPECT_TRUE(std::regex_search(header, match, std::regex(name + " = \\{?(-?[0-9.eE+-]+)"))) << name;
  return match.empty() ? std::nan("") : std::stod(match[1]);
}

class Search : public CommandTest {
 protected:
  [[nodiscard]] Finished doppler(std::vector<std::string> more) const {
    std::vector<std::string> words{"doppler", examples + "mti.scr", "--quiet"};
    words.insert(words.end(), more.begin(), more.end());
    return sarsim(words);
  }
  [[nodiscard]] Finished search(std::vector<std::string> more) const {
    std::vector<std::string> words{"search", examples + "search_radar.scr", "--quiet"};
    words.insert(words.end(), more.begin(), more.end());
    return sarsim(words);
  }
};

TEST_F(Search, CancellerLeavesTheCarAlone) {
  ASSERT_EQ(doppler({"--out", "all.img"}).status, 0);
  ASSERT_EQ(doppler({"--out", "moving.img", "--canceller", "two", "--window", "hamming"}).status, 0);
  const auto all = table_of(folder_ / "all-detections.csv");
  const auto moving = table_of(folder_ / "moving-detections.csv");
  EXPECT_GT(std::ranges::count(all, "1", [](const TableRow& row) { return row.at("target"); }), 0);
  ASSERT_EQ(moving.size(), 4U);
  for (const TableRow& row : moving) {
    EXPECT_EQ(row.at("target"), "2");
    // A cell is lambda PRF/128 = 0.94 m/s.
    EXPECT_NEAR(std::stod(row.at("speed_mps")), -15.0, 0.094);
    EXPECT_NEAR(std::stod(row.at("doppler_hz")), 1000.0, 6.25);
    EXPECT_NEAR(std::stod(row.at("range_m")), 5000.0, 3.0);
  }
}

TEST_F(Search, MapsHaveTheirAxesInTheHeaderAndTheCarInItsCell) {
  ASSERT_EQ(doppler({"--canceller", "two", "--out", "m.img"}).status, 0);
  const std::string header = text_of(folder_ / "m.hdr");
  const auto columns = static_cast<std::size_t>(header_number(header, "samples"));
  const auto rows = static_cast<std::size_t>(header_number(header, "lines"));
  EXPECT_EQ(rows, 256U);
  EXPECT_EQ(header_number(header, "doppler first hz"), -2000.0);
  EXPECT_EQ(header_number(header, "doppler step hz"), 62.5);
  EXPECT_NEAR(header_number(header, "speed first mps"), 30.0, 1e-3);
  const auto values = floats_of(folder_ / "m.img");
  ASSERT_EQ(values.size(), 2 * rows * columns);
  const double first_m = header_number(header, "range first m");
  const double step_m = header_number(header, "range step m");
  for (std::size_t map = 0; map < 4; ++map) {
    std::size_t best = 0;
    double most = 0.0;
    for (std::size_t i = map * 64 * columns; i < (map + 1) * 64 * columns; ++i) {
      const double power = std::hypot(values[2 * i], values[2 * i + 1]);
      if (power > most) {
        most = power;
        best = i;
      }
    }
    EXPECT_EQ(best / columns % 64, 48U);
    EXPECT_NEAR(first_m + static_cast<double>(best % columns) * step_m, 5000.0, step_m);
  }
}

TEST_F(Search, WorksOnRecordingsAsOnScripts) {
  ASSERT_EQ(sarsim({"run", examples + "mti.scr", "--quiet"}).status, 0);
  ASSERT_EQ(sarsim({"run", examples + "search_radar.scr", "--format", "npy", "--quiet"}).status, 0);
  ASSERT_EQ(sarsim({"doppler", "mti.h5", "--canceller", "two", "--quiet"}).status, 0);
  ASSERT_EQ(doppler({"--canceller", "two", "--out", "scene.img"}).status, 0);
  const auto of_data = table_of(folder_ / "mti-doppler-detections.csv");
  const auto of_scene = table_of(folder_ / "scene-detections.csv");
  ASSERT_GE(of_data.size(), 4U);
  const auto car = [](const std::vector<TableRow>& table) {
    return std::stod(
        std::ranges::find(table, "2", [](const TableRow& row) { return row.at("target"); })->at("speed_mps"));
  };
  // The file holds volts in float.
  EXPECT_NEAR(car(of_data), car(of_scene), 0.01);
  const Finished bare = sarsim({"search", "search_radar.npy", "--script", examples + "search_radar.scr", "--quiet"});
  EXPECT_EQ(bare.status, 0) << bare.err;
  EXPECT_GE(table_of(folder_ / "search_radar-ppi-detections.csv").size(), 4U);
}

TEST_F(Search, PicturesShowTargetsAtTheirBearingAndRange) {
  const Finished run = search({"--scan", "1", "--out", "p.img", "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(is_json(run.out, folder_));
  const std::string header = text_of(folder_ / "p.hdr");
  EXPECT_THAT(header, HasSubstr("data type = 4"));
  const auto columns = static_cast<std::size_t>(header_number(header, "samples"));
  const auto values = floats_of(folder_ / "p.img");
  const double pixel_m = header_number(header, "x step m");
  EXPECT_EQ(header_number(header, "y step m"), -pixel_m);
  const auto brightest_within = [&](double x_m, double y_m, double reach_m) {
    std::pair<double, double> place;
    float most = 0.0F;
    const double first_x = header_number(header, "x first m");
    const double first_y = header_number(header, "y first m");
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double x = first_x + static_cast<double>(i % columns) * pixel_m;
      const double y = first_y - static_cast<double>(i / columns) * pixel_m;
      if (std::hypot(x - x_m, y - y_m) > reach_m || values[i] <= most) continue;
      most = values[i];
      place = {x, y};
    }
    return place;
  };
  // A cell: 75 m in range; in azimuth the beam, 2 degrees. The aircraft is met 0.9 s after time 0.
  for (const auto& [x_m, y_m] : {std::pair(8000.0, 6000.0), std::pair(-9000.0 + 0.9 * 144.0, 12000.0 - 0.9 * 192.0)}) {
    const auto [x, y] = brightest_within(x_m, y_m, 1500.0);
    EXPECT_NEAR(std::hypot(x, y), std::hypot(x_m, y_m), 75.0);
    EXPECT_NEAR(std::atan2(x, y), std::atan2(x_m, y_m), 1.0 * pi / 180.0);
  }
}

TEST_F(Search, FindsBothTargetsInEachTurnWithinACell) {
  const Finished run = search({"--no-map", "--json", "--detections", "d.csv"});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_FALSE(std::filesystem::exists(folder_ / "search_radar-ppi.img"));
  // The strongest detection of each target in each turn.
  std::map<std::pair<std::string, int>, TableRow> best;
  for (const TableRow& row : table_of(folder_ / "d.csv")) {
    if (row.at("target").empty()) continue;
    TableRow& known = best[{row.at("target"), static_cast<int>(std::stod(row.at("time_s")))}];
    if (known.empty() || std::stod(known["magnitude_v"]) < std::stod(row.at("magnitude_v"))) known = row;
  }
  ASSERT_EQ(best.size(), 4U);
  for (auto& [key, row] : best) {
    const double time_s = std::stod(row["time_s"]);
    const bool ship = key.first == "1";
    const double x_m = ship ? 8000.0 : -9000.0 + 144.0 * time_s;
    const double y_m = ship ? 6000.0 : 12000.0 - 192.0 * time_s;
    EXPECT_NEAR(std::stod(row["range_m"]), std::hypot(x_m, y_m), 20.0) << key.first;
    const double bearing = std::fmod(std::atan2(x_m, y_m) * 180.0 / pi + 360.0, 360.0);
    EXPECT_NEAR(std::stod(row["azimuth_deg"]), bearing, 1.0) << key.first;
    EXPECT_NEAR(std::stod(row["x_m"]), x_m, 300.0);
    EXPECT_NEAR(std::stod(row["y_m"]), y_m, 300.0);
    // 240 m/s towards the radar are seen as 40; a cell of 5 pulses is 20 m/s wide.
    EXPECT_NEAR(std::stod(row["speed_mps"]), ship ? 0.0 : -40.0, 4.0) << key.first;
  }
  EXPECT_THAT(run.out, HasSubstr("exceed the unambiguous speed"));
  EXPECT_THAT(run.out, HasSubstr("\"intervals_found\""));
}

// The aircraft flies 240 m between two turns: the strongest detection may be of one, the strongest echo of the other.
TEST_F(Search, MeasuresRangesWhereTargetsAreWhenTheyAreFound) {
  for (const char* seed : {"1", "2", "3", "4"}) {
    const Finished run = sarsim(
        {"search", examples + "search_radar.scr", "--no-map", "--seed", seed, "--detections", "d.csv", "--force"});
    ASSERT_EQ(run.status, 0) << run.err;
    const std::regex pattern("range error ([+-][0-9.]+) m");
    const std::string text = run.out + run.err;
    std::size_t errors = 0;
    for (std::sregex_iterator i(text.begin(), text.end(), pattern), end; i != end; ++i, ++errors)
      EXPECT_LT(std::abs(std::stod((*i)[1])), 20.0) << "seed " << seed << ": " << i->str();
    EXPECT_EQ(errors, 2U);
  }
}

TEST_F(Search, MakesTheSameBytesForAnyNumberOfThreads) {
  for (const char* threads : {"1", "3"}) {
    const std::string name(threads);
    ASSERT_EQ(doppler({"--threads", threads, "--out", name + ".img", "--canceller", "three", "--step", "20"}).status,
              0);
    ASSERT_EQ(search({"--threads", threads, "--out", "ppi" + name + ".img", "--cfar", "os"}).status, 0);
  }
  for (const char* name : {".img", "-detections.csv"}) {
    EXPECT_EQ(text_of(folder_ / ("1" + std::string(name))), text_of(folder_ / ("3" + std::string(name))));
    EXPECT_EQ(text_of(folder_ / ("ppi1" + std::string(name))), text_of(folder_ / ("ppi3" + std::string(name))));
  }
}

TEST_F(Search, WritesEveryFormat) {
  for (const char* file : {"a.h5", "a.csv", "a.asc", "a.bin", "a.brk", "a.npy"}) {
    const Finished maps = doppler({"--out", std::string("d/") + file, "--force"});
    EXPECT_EQ(maps.status, 0) << file << maps.err;
    EXPECT_TRUE(std::filesystem::exists(folder_ / "d" / file)) << file;
    const Finished picture = search({"--out", std::string("p/") + file, "--force", "--cfar", "none", "--pixel", "200"});
    EXPECT_EQ(picture.status, 0) << file << picture.err;
    EXPECT_TRUE(std::filesystem::exists(folder_ / "p" / file)) << file;
  }
  EXPECT_TRUE(std::filesystem::exists(folder_ / "d/a.hdr"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "p/a-detections.csv"));
  const Finished info = sarsim({"info", "d/a.h5", "--json"});
  EXPECT_TRUE(is_json(info.out, folder_));
  EXPECT_THAT(info.out, testing::ContainsRegex("\"rows\": 256[,\n ]"));
}

TEST_F(Search, DetectsInTwoDimensionsAndByOrderedStatistics) {
  for (const auto& more : std::vector<std::vector<std::string>>{
           {"--cfar", "os", "--rank", "0.6"}, {"--train", "8:3", "--guard", "2:2"}, {"--pfa", "1e-4", "--all-cells"}}) {
    std::vector<std::string> words{"--out", "x.img", "--force"};
    words.insert(words.end(), more.begin(), more.end());
    ASSERT_EQ(doppler(words).status, 0) << more.front();
    const auto table = table_of(folder_ / "x-detections.csv");
    EXPECT_GE(std::ranges::count(table, "2", [](const TableRow& row) { return row.at("target"); }), 4) << more.front();
  }
}

TEST_F(Search, LeavesOutDopplerOfSinglePulses) {
  ASSERT_EQ(search({"--interval", "1", "--no-map", "--detections", "d.csv"}).status, 0);
  const auto table = table_of(folder_ / "d.csv");
  ASSERT_FALSE(table.empty());
  for (const TableRow& row : table) EXPECT_EQ(row.at("doppler_hz"), "");
}

TEST_F(Search, SaysBeforeItBeginsWhatWillSurprise) {
  const Finished cars = sarsim({"doppler", examples + "mti.scr", "--canceller", "two"});
  EXPECT_EQ(cars.status, 0);
  EXPECT_THAT(cars.err, HasSubstr("target 3 moves near a blind speed of the canceller"));
  EXPECT_THAT(cars.err, HasSubstr("target 2"));
  const Finished turning = sarsim({"search", examples + "search_radar.scr", "--interval", "30", "--no-map"});
  EXPECT_THAT(turning.err, HasSubstr("use intervals of at most 11 pulses"));
}

TEST_F(Search, KeepsFilesUnlessForced) {
  write_text(folder_ / "mti-doppler-detections.csv", "precious");
  EXPECT_EQ(doppler({}).status, 2);
  EXPECT_EQ(text_of(folder_ / "mti-doppler-detections.csv"), "precious");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "mti-doppler.img"));
  EXPECT_EQ(doppler({"--force"}).status, 0);
}

TEST_F(Search, SaysWhatIsWrongWithItsArguments) {
  const auto refused = [&](const std::vector<std::string>& words, const char* text, bool picture = false) {
    const Finished run = picture ? search(words) : doppler(words);
    EXPECT_EQ(run.status, 2) << text << run.err;
    EXPECT_THAT(run.err, HasSubstr(text));
    EXPECT_THAT(entries("."), testing::IsEmpty());
  };
  refused({"--window", "hammond"}, "--window: invalid; found 'hammond'");
  refused({"--train", "many"}, "--train: invalid cell counts; found 'many'");
  refused({"--guard", "2:-1"}, "--guard: invalid cell counts");
  refused({"--pfa", "2"}, "--pfa");
  refused({"--rank", "1.5", "--cfar", "os"}, "--rank");
  refused({"--rank", "0.5"}, "--rank is for the ordered statistic");
  refused({"--train", "0", "--guard", "3"}, "found '--train 0 --guard 3 in a map of");
  refused({"--cfar", "none", "--pfa", "0.1"}, "--pfa means nothing with --cfar none");
  refused({"--cfar", "none", "--train", "5", "--detections", "d.csv"}, "--detections means nothing with --cfar none");
  refused({"--no-map", "--pixel", "20"}, "--pixel is for the picture", true);
  refused({"--interval", "300"}, "more pulses than the recording");
  refused({"--frequencies", "8"}, "fewer Doppler frequencies");
  refused({"--canceller", "four"}, "none, two, three");
  refused({"--cfar", "none", "--no-map"}, "leaves nothing to do");
  refused({"--pixel", "1e-300"}, "e+", true);
  refused({"--out", "a.csv", "--detections", "a.csv"}, "the name of two outputs");
  refused({"--out", "a.csv", "--detections", "./a.csv"}, "the name of two outputs");
  refused({"--out", "a.hdr"}, "'a.hdr' is the name of two outputs");
  refused({"--simulation", "7"}, "no recording 7");
  refused({"--script", "other.scr"}, "--script is for files of samples");
  refused({"--pixel", "0"}, "--pixel 0: must be above 0", true);
  refused({"--pixel", "0.01"}, "too large", true);
  refused({"--extent", "-5"}, "--extent", true);
  refused({"--scan", "3"}, "fewer turns are recorded", true);
  refused({"--height", "50000"}, "the ground is beyond the recorded ranges", true);
  EXPECT_EQ(sarsim({"doppler", "missing.h5"}).status, 2);
  const Finished profiles = sarsim({"doppler", examples + "stepped_srp.scr"});
  EXPECT_EQ(profiles.status, 2);
  EXPECT_THAT(profiles.err, HasSubstr("synthetic range profiles hold no pulses"));
}

TEST_F(Search, RefusesASecondTurnOfABeamThatStandsStill) {
  std::string text = text_of(examples + "search_radar.scr");
  const std::size_t rotating = text.find("ROTATING");
  ASSERT_NE(rotating, std::string::npos);
  text.replace(rotating, 8, "FIXED");
  write_text(folder_ / "still.scr", text);
  const Finished second = sarsim({"search", "still.scr", "--scan", "2", "--out", "p.img"});
  EXPECT_EQ(second.status, 2);
  EXPECT_THAT(second.err, HasSubstr("fewer turns are recorded"));
  EXPECT_THAT(entries("."), testing::ElementsAre("still.scr"));
  EXPECT_EQ(sarsim({"search", "still.scr", "--scan", "1", "--out", "p.img"}).status, 0);
}

TEST_F(Search, EndsOnControlCWithoutLeavingAnything) {
  std::string text = text_of(examples + "search_radar.scr");
  text.replace(text.find("1.9995 "), 7, "150.0  ");
  write_text(folder_ / "long.scr", text);
  Start start;
  start.folder = folder_;
  Program program({"search", "long.scr"}, start);
  ASSERT_TRUE(program.wait_for("long-ppi.img: 10 %", 100.0)) << program.err();
  program.send(SIGINT);
  EXPECT_EQ(program.finish().status, 130);
  EXPECT_THAT(entries("."), testing::ElementsAre("long.scr"));
}

}  // namespace search_test
}  // namespace sarsim::test
