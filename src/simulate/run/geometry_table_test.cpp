#include "simulate/run/geometry_table.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/maths/constants.hpp"
#include "core/text/number_text.hpp"

namespace sarsim::simulate {
namespace geometry_table_test {

// Thesis A.3: two targets 8 m apart on a platform that leaves 300 m at 50 m/s, seen from the origin at 0.5 GHz, 1 kHz.
scene::Scene moving_scene(double speed_mps = 50.0) {
  scene::Platform moving;
  moving.name = "Moving";
  moving.path = scene::Platform::Path::trajectory;
  moving.trajectory_m.part[0].knots = {{0.0, 300.0}, {1.0, 300.0 + speed_mps}};
  moving.trajectory_m.part[1].knots = {{0.0, 0.0}};
  moving.trajectory_m.part[2].knots = {{0.0, 0.0}};
  scene::Scene scene;
  scene.platforms = {scene::Platform{}, moving};
  for (const double x_m : {0.0, 8.0}) {
    scene::Target target;
    target.platform = "Moving";
    target.position_m = {x_m, 0.0, 0.0};
    scene.targets.push_back(target);
  }
  scene::Radar radar;
  radar.prf_hz = 1000.0;
  radar.carrier_hz = 0.5e9;
  scene.radars = {radar};
  return scene;
}

scene::GeometryTable table_of(int columns, double end_s = 0.0085) {
  scene::GeometryTable table;
  table.radar = "Radar1";
  table.time_end_s = end_s;
  table.columns = columns;
  return table;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::vector<std::string> text_lines(const scene::Scene& scene, const scene::GeometryTable& table) {
  std::string text;
  write_geometry_text(scene, table, [&](std::string_view piece) { text += piece; });
  return lines_of(text);
}

std::vector<std::vector<std::string>> csv_rows(const scene::Scene& scene, const scene::GeometryTable& table) {
  std::string text;
  write_geometry_csv(scene, table, [&](std::string_view piece) { text += piece; });
  std::vector<std::vector<std::string>> rows;
  for (const std::string& line : lines_of(text)) {
    std::istringstream stream(line);
    auto& row = rows.emplace_back();
    for (std::string field; std::getline(stream, field, ',');) row.push_back(field);
  }
  return rows;
}

std::size_t column(const std::vector<std::string>& header, const std::string& name) {
  for (std::size_t i = 0; i < header.size(); ++i)
    if (header[i] == name) return i;
  ADD_FAILURE() << "no column " << name;
  return 0;
}

constexpr double c = core::exact_light_speed_mps;

TEST(GeometryTable, HasFourHeaderLinesAndOneLinePerPulse) {
  const auto lines = text_lines(moving_scene(), table_of(227));
  ASSERT_EQ(lines.size(), 4U + 9U);
  EXPECT_EQ(lines[4].substr(0, 10), "        0 ");
  EXPECT_EQ(lines[12].substr(0, 10), "        8 ");
}

TEST(GeometryTable, EveryColumnHasItsWidthInHeadingsAndLines) {
  const struct {
    int bit;
    std::size_t width;
  } groups[] = {{0, 0},
                {1, 13},
                {2, 13},
                {4, 2 * 33},
                {8, 2 * 33},
                {16, 2 * 33},
                {32, 2 * 18},
                {64, 2 * 18},
                {128, 2 * 18},
                {255, 26 + 6 * 33 + 6 * 18},
                {227, 26 + 4 * 18 + 2 * 18}};
  for (const auto& group : groups) {
    const auto lines = text_lines(moving_scene(), table_of(group.bit));
    ASSERT_EQ(lines.size(), 13U);
    for (const std::string& line : lines)
      EXPECT_EQ(line.size(), 10 + group.width) << "mask " << group.bit << ": " << line;
  }
}

TEST(GeometryTable, RulesStandOverTheirColumns) {
  const auto lines = text_lines(moving_scene(), table_of(geometry_time | geometry_delay));
  EXPECT_EQ(lines[3], "--------- ------------ ----------------- ----------------- ");
}

TEST(GeometryTable, HeadingsNamePlatformsTargetsAndUnits) {
  const auto lines = text_lines(moving_scene(), table_of(255));
  EXPECT_NE(lines[1].find("(Earth)"), std::string::npos);
  EXPECT_LT(lines[1].find("(Earth)"), lines[1].find("(Moving)"));
  EXPECT_LT(lines[1].find("Target 1"), lines[1].find("Target 2"));
  for (const char* unit : {"(s)", "(GHz)", "X (m)", "Y (m/s)", "Z (deg)", "(V)", "(m/s)"})
    EXPECT_NE(lines[2].find(unit), std::string::npos) << unit;
}

TEST(GeometryTable, LongPlatformNamesKeepTheWidths) {
  scene::Scene scene = moving_scene();
  scene.platforms[1].name = "A name that is much longer than the column";
  for (scene::Target& target : scene.targets) target.platform = scene.platforms[1].name;
  for (const std::string& line : text_lines(scene, table_of(4))) EXPECT_EQ(line.size(), 10U + 2U * 33U);
}

// A terminal gets no orders from them; other programs get them as they are, as CSV.
TEST(GeometryTable, ControlCharactersOfNamesAreEscapedInTextAlone) {
  scene::Scene scene = moving_scene();
  scene.platforms[1].name = "M\u009bA\u202eB\x7f";
  for (scene::Target& target : scene.targets) target.platform = scene.platforms[1].name;
  const std::string heading = text_lines(scene, table_of(geometry_position)).at(1);
  EXPECT_NE(heading.find("(M\\u009bA\\u202eB\\x7f)"), std::string::npos) << heading;
  EXPECT_EQ(csv_rows(scene, table_of(geometry_position)).at(0).at(12), scene.platforms[1].name + " x_m");
}

TEST(GeometryTable, NumbersAreRightJustifiedWithEightDigits) {
  const auto lines = text_lines(moving_scene(), table_of(geometry_time | geometry_frequency));
  EXPECT_EQ(lines[5], "        1        0.001          0.5 ");
}

TEST(GeometryTable, ExponentsAreUpperCase) {
  const auto lines = text_lines(moving_scene(), table_of(geometry_delay));
  EXPECT_NE(lines[4].find("E-06"), std::string::npos) << lines[4];
  EXPECT_EQ(lines[4].find('e'), std::string::npos) << lines[4];
}

TEST(GeometryTable, CommaSeparatesLinesButNotHeadings) {
  scene::GeometryTable table = table_of(geometry_time);
  table.separator = scene::GeometryTable::Separator::comma;
  const auto lines = text_lines(moving_scene(), table);
  EXPECT_EQ(lines[3].find(','), std::string::npos);
  EXPECT_EQ(lines[5], "        1,       0.001,");
}

TEST(GeometryTable, TargetsOutsideTheWindowKeepTheirColumnsAsNan) {
  scene::GeometryTable table = table_of(geometry_delay | geometry_amplitude | geometry_speed);
  table.range_end_m = 304.0;  // The second target stands at 308 m.
  const auto lines = text_lines(moving_scene(), table);
  const std::string nan = "              nan ";
  EXPECT_EQ(lines[4].substr(10 + 3 * 18), nan + nan + nan);
  EXPECT_EQ(lines[4].substr(10, 3 * 18).find("nan"), std::string::npos);
}

TEST(GeometryTable, DelayFollowsTheClosedFormForRecession) {
  const auto lines = text_lines(moving_scene(), table_of(geometry_delay | geometry_speed));
  for (int pulse = 0; pulse < 9; ++pulse) {
    std::istringstream line(lines[static_cast<std::size_t>(4 + pulse)]);
    double number = 0.0, delay_s = 0.0, speed_mps = 0.0;
    line >> number >> delay_s >> speed_mps;
    const double expected_s = 2.0 * (300.0 + 0.05 * pulse) / (c - 50.0);
    EXPECT_NEAR(delay_s, expected_s, 1e-11 * expected_s);  // 12 digits are written.
    EXPECT_NEAR(speed_mps, 50.0, 1e-9);
  }
}

TEST(GeometryTable, ApproachHasANegativeSpeed) {
  const auto rows = csv_rows(moving_scene(-50.0), table_of(0));
  const std::size_t delay = column(rows[0], "target 1 delay_s");
  const std::size_t speed = column(rows[0], "target 1 radial_speed_mps");
  EXPECT_NEAR(*core::parse_number(rows[3][speed]), -50.0, 1e-12);
  const double expected_s = 2.0 * (300.0 - 0.1) / (c + 50.0);
  EXPECT_NEAR(*core::parse_number(rows[3][delay]), expected_s, 1e-15 * expected_s * 8);
}

TEST(GeometryTable, PhaseStepOfTheMovingTargetIsThatOfThesisA3) {
  const auto rows = csv_rows(moving_scene(), table_of(0));
  const std::size_t delay = column(rows[0], "target 1 delay_s");
  const double step_s = *core::parse_number(rows[2][delay]) - *core::parse_number(rows[1][delay]);
  // -2 pi (2 d/lambda) with d = 0.05 m and lambda = c/0.5 GHz; the thesis prints -1.0472 with c = 3e8.
  EXPECT_NEAR(-2.0 * core::pi * 0.5e9 * step_s, -1.04792, 5e-6);
}

TEST(GeometryTable, CsvHoldsPlatformsTargetsAndExactNumbers) {
  const auto rows = csv_rows(moving_scene(), table_of(0));
  ASSERT_EQ(rows.size(), 10U);
  ASSERT_EQ(rows[0].size(), 3U + 2U * 9U + 2U * 4U);
  for (const auto& row : rows) EXPECT_EQ(row.size(), rows[0].size());
  EXPECT_EQ(rows[4][column(rows[0], "pulse")], "3");
  EXPECT_EQ(*core::parse_number(rows[4][column(rows[0], "time_s")]), 3.0 / 1000.0);
  EXPECT_EQ(*core::parse_number(rows[4][column(rows[0], "carrier_hz")]), 0.5e9);
  EXPECT_NEAR(*core::parse_number(rows[4][column(rows[0], "Moving x_m")]), 300.15, 1e-12 * 300.0);
  EXPECT_EQ(*core::parse_number(rows[4][column(rows[0], "Moving vx_mps")]), 50.0);
  EXPECT_EQ(rows[4][column(rows[0], "Moving vy_mps")], "0");
  EXPECT_NEAR(*core::parse_number(rows[4][column(rows[0], "target 2 distance_m")]), 308.15, 1e-12 * 308.0);
}

TEST(GeometryTable, AmplitudeFollowsTheRadarEquation) {
  const auto rows = csv_rows(moving_scene(), table_of(0));
  const double wavelength_m = c / 0.5e9;
  // sqrt(P lambda^2 sigma/((4 pi)^3 d^4)) with 1 kW and 1 m^2, both ways as long as where the pulse meets the target.
  const double met_m = 308.0 / (1.0 - 50.0 / c);
  const double expected_v = std::sqrt(1000.0 / std::pow(4.0 * core::pi, 3.0)) * wavelength_m / (met_m * met_m);
  EXPECT_NEAR(*core::parse_number(rows[1][column(rows[0], "target 2 amplitude_v")]), expected_v, 1e-12 * expected_v);
}

TEST(GeometryTable, CsvIgnoresWindowAndMask) {
  scene::GeometryTable table = table_of(0);
  table.range_start_m = 1000.0;
  for (const auto& row : csv_rows(moving_scene(), table))
    for (const std::string& field : row) EXPECT_NE(field, "nan");
}

TEST(GeometryTable, RotationIsInDegreesAndGrowsWithItsRate) {
  scene::Scene scene = moving_scene();
  scene.platforms[0].rotation[1] = core::Angle::from_deg(12.5);
  scene.platforms[0].rotation_rate[2] = core::Angle::from_deg(1000.0);
  const auto rows = csv_rows(scene, table_of(0));
  EXPECT_NEAR(*core::parse_number(rows[3][column(rows[0], "Earth ry_deg")]), 12.5, 1e-12);
  EXPECT_NEAR(*core::parse_number(rows[3][column(rows[0], "Earth rz_deg")]), 2.0, 1e-12);
}

TEST(GeometryTable, PlatformsThatCarryNothingAreShownMoving) {
  scene::Scene scene = moving_scene();
  scene.targets.clear();
  const auto rows = csv_rows(scene, table_of(0));
  EXPECT_NEAR(*core::parse_number(rows[9][column(rows[0], "Moving x_m")]), 300.4, 1e-10);
}

TEST(GeometryTable, NamesWithCommasAreQuotedInCsv) {
  scene::Scene scene = moving_scene();
  scene.targets.clear();
  scene.platforms[1].name = "a,\"b\"";
  std::string text;
  write_geometry_csv(scene, table_of(0), [&](std::string_view piece) { text += piece; });
  EXPECT_NE(text.find(",\"a,\"\"b\"\" x_m\","), std::string::npos) << text.substr(0, 300);
}

TEST(GeometryTable, WindowWithoutPulsesGivesNoText) {
  scene::GeometryTable table = table_of(227);
  table.time_start_s = 0.0001;
  table.time_end_s = 0.0002;
  EXPECT_TRUE(text_lines(moving_scene(), table).empty());
}

// A line has a column for each target, of which there may be millions.
TEST(GeometryTable, StopsWithinALine) {
  scene::Scene scene = moving_scene();
  scene.targets.resize(50'000, scene.targets.front());
  const auto pieces_until_stop = [&](const auto& write_table) {
    core::StopFlag stop;
    std::size_t bytes = 0;
    const auto write = [&](std::string_view piece) {
      bytes += piece.size();
      stop.request();
    };
    EXPECT_THROW(write_table(write, &stop), core::Interrupted);
    return bytes;
  };
  // The header alone of the CSV has 4 MB, a line of the other 3 MB.
  EXPECT_LT(pieces_until_stop([&](const auto& write, const core::StopFlag* stop) {
              write_geometry_csv(scene, table_of(255), write, stop);
            }),
            1'000'000U);
  EXPECT_LT(pieces_until_stop([&](const auto& write, const core::StopFlag* stop) {
              write_geometry_text(scene, table_of(255), write, stop);
            }),
            1'000'000U);
}

TEST(GeometryTable, StopsWhenAsked) {
  core::StopFlag stop;
  stop.request();
  const auto ignore = [](std::string_view) {};
  EXPECT_THROW(write_geometry_text(moving_scene(), table_of(1), ignore, &stop), core::Interrupted);
  EXPECT_THROW(write_geometry_csv(moving_scene(), table_of(1), ignore, &stop), core::Interrupted);
}

TEST(GeometryTable, UnknownRadarIsRefused) {
  scene::GeometryTable table = table_of(1);
  table.radar = "Nobody";
  EXPECT_THROW(write_geometry_text(moving_scene(), table, [](std::string_view) {}), std::invalid_argument);
}

// The moving scene at 60 deg north and 10 deg east, 100 m up, at midnight.
scene::Scene scene_on_earth() {
  scene::Scene scene = moving_scene();
  scene.world.frame = scene::World::Frame::earth;
  scene.world.epoch = "2020-07-28T23:59:59.9985Z";
  scene.world.latitude = core::Angle::from_deg(60.0);
  scene.world.longitude = core::Angle::from_deg(10.0);
  scene.world.height_m = 100.0;
  return scene;
}

TEST(GeometryTable, CsvHasPlacesOnTheEarthBehindPositions) {
  const auto rows = csv_rows(scene_on_earth(), table_of(227));
  const std::size_t x = column(rows[0], "Moving x_m");
  const std::size_t latitude = column(rows[0], "Moving latitude_deg");
  ASSERT_EQ(latitude, x + 3);
  ASSERT_EQ(column(rows[0], "Moving longitude_deg"), latitude + 1);
  ASSERT_EQ(column(rows[0], "Moving height_m"), latitude + 2);
  EXPECT_EQ(column(rows[0], "Moving vx_mps"), latitude + 3);
  const auto number = [&](std::size_t row, std::size_t at) { return core::parse_number(rows[row].at(at)).value(); };
  // 300 m east along the tangent: d/((N + h) cos lat) of longitude, and d^2/2N of height, with N = 6394209.2 m.
  const double radius_m = 6'378'137.0 / std::sqrt(1.0 - 0.00669437999014 * 0.75) + 100.0;
  EXPECT_NEAR(number(1, latitude + 1), 10.0 + core::deg_per_rad * std::atan(300.0 / (radius_m * 0.5)), 1e-9);
  EXPECT_NEAR(number(1, latitude + 2), 100.0 + 300.0 * 300.0 / (2.0 * radius_m), 1e-4);
  EXPECT_NEAR(number(1, latitude), 60.0, 1e-6);
  EXPECT_NEAR(number(1, column(rows[0], "Earth latitude_deg")), 60.0, 1e-13);
  for (const auto& row : rows) EXPECT_EQ(row.size(), rows[0].size());
}

TEST(GeometryTable, CsvHasDatesWhereThereIsAnEpoch) {
  const auto rows = csv_rows(scene_on_earth(), table_of(227));
  ASSERT_EQ(column(rows[0], "utc"), 2U);
  EXPECT_EQ(rows[1][2], "2020-07-28T23:59:59.9985Z");
  EXPECT_EQ(rows[3][2], "2020-07-29T00:00:00.0005Z");
  scene::Scene flat = moving_scene();
  const auto plain = csv_rows(flat, table_of(227));
  flat.world.epoch = "2020-07-28T23:59:59.9985Z";
  const auto dated = csv_rows(flat, table_of(227));
  EXPECT_EQ(dated[0].size(), plain[0].size() + 1);
  for (const std::string& name : plain[0]) EXPECT_EQ(name.find("latitude"), std::string::npos);
}

// Where pulse and carrier come by different paths there is a delay of each.
TEST(GeometryTable, CsvHasTheDelayOfThePhaseThroughAnIonosphere) {
  scene::Scene scene = moving_scene(0.0);
  scene.platforms.push_back({});
  scene.platforms.back().name = "Satellite";
  scene.platforms.back().position_m = {308.0, 0.0, 700e3};
  scene.radars[0].platform = "Satellite";
  const auto vacuum = csv_rows(scene, table_of(0));
  EXPECT_EQ(std::ranges::count(vacuum[0], "target 2 phase_delay_s"), 0);
  scene.atmosphere.tec_units = 10.0;
  const auto rows = csv_rows(scene, table_of(0));
  ASSERT_EQ(rows.size(), vacuum.size());
  EXPECT_EQ(rows[0].size(), vacuum[0].size() + 2);
  const std::size_t delay = column(rows[0], "target 2 delay_s");
  EXPECT_EQ(rows[0][delay + 1], "target 2 phase_delay_s");
  const double excess_s = 2.0 * 40.3e17 / (0.5e9 * 0.5e9) / c;
  const double vacuum_s = std::stod(vacuum[1][column(vacuum[0], "target 2 delay_s")]);
  EXPECT_NEAR(std::stod(rows[1][delay]), vacuum_s + excess_s, 1e-6 * excess_s);
  EXPECT_NEAR(std::stod(rows[1][delay + 1]), vacuum_s - excess_s, 1e-6 * excess_s);
}

}  // namespace geometry_table_test
}  // namespace sarsim::simulate
