#include "scene/edit/function_model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include <fmt/format.h>

#include "core/maths/interpolator.hpp"
#include "scene/schema/fields.hpp"
#include "scene/schema/function_table.hpp"
#include "scene/script/data_file.hpp"
#include "scene/script/random_scene_test_support.hpp"
#include "support/processor_time.hpp"

namespace sarsim::scene {

namespace function_model_test {

// All fields of kind `function`, with an object that has them.
std::vector<std::pair<AnyObject, std::string>> all_functions() {
  std::vector<std::pair<AnyObject, std::string>> functions;
  for (const AnyObject& object : {AnyObject(Platform{}), AnyObject(Target{}), AnyObject(Radar{})})
    for (const Field& field : fields_of(kind_of(object)))
      if (field.kind == FieldKind::function) functions.emplace_back(object, field.id);
  return functions;
}

std::string printed(const core::Problems& problems) {
  std::string text;
  for (const core::Problem& problem : problems) text += core::to_string(problem) + "\n";
  return text;
}

bool ascends(const core::SampledFunction& function) {
  return std::ranges::adjacent_find(function.knots, std::ranges::greater_equal{}, &core::Knot::x) ==
         function.knots.end();
}

TEST(FunctionModel, EveryFunctionFieldOfEveryObjectIsKnown) {
  const auto functions = all_functions();
  EXPECT_EQ(functions.size(), 14U);
  for (const auto& [object, field] : functions) {
    const FunctionInfo info = function_info(object, field);
    EXPECT_FALSE(info.title.empty()) << field;
    EXPECT_EQ(info.parts.size(), function_of(object, field).parts.size()) << field;
    EXPECT_LT(info.x_range[0], info.x_range[1]) << field;
    EXPECT_LE(info.x_limits[0], info.x_range[0]) << field;
    EXPECT_GE(info.x_limits[1], info.x_range[1]) << field;
    for (const FunctionInfo::Part& part : info.parts) {
      EXPECT_FALSE(part.name.empty()) << field;
      EXPECT_LT(part.y_range[0], part.y_range[1]) << field;
    }
  }
}

TEST(FunctionModel, WhatIsKnownOfAFunctionIsWhatTheDialogSays) {
  Platform ship;
  ship.name = "Ship";
  const FunctionInfo info = function_info(ship, "trajectory_m");
  EXPECT_EQ(info.title, "Trajectory of Ship");
  ASSERT_EQ(info.parts.size(), 3U);
  EXPECT_EQ(info.parts[1].name, "Position Y");
  EXPECT_EQ(info.parts[1].y_unit, "m");
  EXPECT_EQ(info.x_name, "Time");
  EXPECT_EQ(info.x_unit, "s");
  EXPECT_FALSE(info.per_pulse);
  EXPECT_TRUE(function_info(Radar{}, "pri_s").per_pulse);
  EXPECT_TRUE(function_info(Radar{}, "carrier_list_hz").per_pulse);
  EXPECT_EQ(function_info(Radar{}, "carrier_list_hz").parts[0].y_unit, "Hz");
}

TEST(FunctionModel, AFieldThatIsNoFunctionIsAProgrammersMistake) {
  AnyObject radar = Radar{};
  EXPECT_THROW(static_cast<void>(function_info(radar, "prf_hz")), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(function_of(Surface{}, "gain_db")), std::invalid_argument);
  EXPECT_THROW(set_function(radar, "pulse_iq", FunctionDraft{{core::SampledFunction{}}, ""}), std::invalid_argument);
}

TEST(FunctionModel, AFunctionThatIsSetIsTheOneThatIsGotAndNoOther) {
  for (const auto& [before, field] : all_functions()) {
    AnyObject object = before;
    FunctionDraft draft = function_of(object, field);
    for (std::size_t i = 0; i < draft.parts.size(); ++i)
      draft.parts[i] = {core::Interpolation::cubic, {{0.0, static_cast<double>(i) + 1.0}, {0.5, 2.0}}};
    draft.file = "data.dat";
    set_function(object, field, draft);
    EXPECT_TRUE(function_of(object, field) == draft) << field;
    for (const auto& [other, other_field] : all_functions())
      if (kind_of(other) == kind_of(object) && other_field != field) {
        EXPECT_TRUE(function_of(object, other_field) == function_of(other, other_field)) << field << other_field;
      }
    set_function(object, field, function_of(before, field));
    EXPECT_TRUE(object == before) << field;
  }
}

TEST(FunctionModel, AKnotIsInsertedHalfway) {
  core::SampledFunction f{core::Interpolation::linear, {{0.0, 0.0}, {2.0, 10.0}}};
  EXPECT_EQ(insert_knot(f, 0), 1U);
  EXPECT_EQ(f.knots[1], (core::Knot{1.0, 5.0}));
  EXPECT_EQ(insert_knot(f, 2), 3U);
  EXPECT_EQ(f.knots[3], (core::Knot{3.0, 10.0}));
  EXPECT_EQ(insert_knot(f, 99), 4U);
  core::SampledFunction empty;
  EXPECT_EQ(insert_knot(empty, 5), 0U);
  EXPECT_EQ(empty.knots, (std::vector<core::Knot>{{0.0, 0.0}}));
}

TEST(FunctionModel, NothingIsInsertedWhereThereIsNoNumberBetween) {
  core::SampledFunction f{core::Interpolation::linear, {{1.0, 0.0}, {std::nextafter(1.0, 2.0), 1.0}}};
  insert_knot(f, 0);
  EXPECT_EQ(f.knots.size(), 2U);
}

TEST(FunctionModel, TheLastKnotStays) {
  core::SampledFunction f{core::Interpolation::linear, {{0.0, 0.0}, {2.0, 10.0}}};
  remove_knot(f, 7);
  EXPECT_EQ(f.knots.size(), 2U);
  remove_knot(f, 0);
  remove_knot(f, 0);
  EXPECT_EQ(f.knots, (std::vector<core::Knot>{{2.0, 10.0}}));
}

TEST(FunctionModel, AKnotIsMovedBetweenItsNeighboursAndWithinTheLimits) {
  const FunctionInfo info = function_info(Radar{}, "window_gain");  // x from 0 to 1
  core::SampledFunction f{core::Interpolation::linear, {{0.0, 0.0}, {0.5, 1.0}, {1.0, 0.0}}};
  EXPECT_EQ(move_knot(f, 1, {0.7, 3.0}, info), 1U);
  EXPECT_EQ(f.knots[1], (core::Knot{0.7, 3.0}));
  move_knot(f, 1, {5.0, 1.0}, info);
  EXPECT_EQ(f.knots[1].x, 0.99);
  move_knot(f, 1, {-5.0, 1.0}, info);
  EXPECT_EQ(f.knots[1].x, 0.01);
  move_knot(f, 2, {5.0, 1.0}, info);
  EXPECT_EQ(f.knots[2].x, 1.0);
  move_knot(f, 0, {-5.0, 1.0}, info);
  EXPECT_EQ(f.knots[0].x, 0.0);
}

TEST(FunctionModel, OfAFunctionOfThePulseNumberOnlyTheValueMovesAndStaysAboveZero) {
  const FunctionInfo info = function_info(Radar{}, "pri_s");
  core::SampledFunction f{core::Interpolation::linear, {{0.0, 1e-3}, {1.0, 2e-3}}};
  move_knot(f, 1, {7.0, -1.0}, info);
  EXPECT_EQ(f.knots[1].x, 1.0);
  EXPECT_GT(f.knots[1].y, 0.0);
}

TEST(FunctionModel, AnyEditingKeepsKnotsAscendingAndOneOfThem) {
  std::mt19937_64 engine(3);
  const auto any = [&] { return std::ldexp(static_cast<double>(engine() >> 11), -53) * 4.0 - 2.0; };
  for (const auto& [object, field] : all_functions()) {
    const FunctionInfo info = function_info(object, field);
    if (info.per_pulse) continue;
    core::SampledFunction f;
    insert_knot(f, 0);
    for (int step = 0; step < 3000; ++step) {
      const std::size_t at = engine() % f.knots.size();
      const double width = info.x_range[1] - info.x_range[0];
      const int what = static_cast<int>(engine() % 5);
      if (what == 0 && f.knots.size() < 30) insert_knot(f, at);
      if (what == 1) remove_knot(f, at);
      if (what > 1) {
        EXPECT_EQ(move_knot(f, at, {width * any(), 1e3 * any()}, info), at);
        EXPECT_GE(f.knots[at].y, info.y_limits[0]);
      }
      ASSERT_FALSE(f.knots.empty());
      ASSERT_TRUE(ascends(f)) << field;
    }
  }
}

TEST(FunctionModel, DraggedValuesAreRoundedToAHundredthOfTheDecade) {
  EXPECT_EQ(rounded_to_range(0.123456, 1.0), 0.12);
  EXPECT_EQ(rounded_to_range(123.456, 1000.0), 120.0);
  EXPECT_EQ(rounded_to_range(123.456, 900.0), 123.0);
  EXPECT_EQ(rounded_to_range(-0.3000000001, 1.0), -0.3);
  EXPECT_EQ(rounded_to_range(3.4567e-7, 1e-6), 3.5e-7);
  EXPECT_EQ(rounded_to_range(5.0, 0.0), 5.0);
  EXPECT_EQ(rounded_to_range(5.5, std::numeric_limits<double>::infinity()), 5.5);
}

TEST(FunctionModel, TheCurveIsThatOfTheSimulation) {
  const core::SampledFunction f{core::Interpolation::linear, {{0.0, 0.0}, {1.0, 2.0}, {3.0, -1.0}}};
  for (const core::Interpolation method :
       {core::Interpolation::linear, core::Interpolation::cubic, core::Interpolation::low_pass}) {
    const core::Interpolator direct({method, f.knots});
    const auto points = curve_points(f, FunctionRole::trajectory, method, -1.0, 4.0, 51);
    ASSERT_EQ(points.size(), 51U);
    EXPECT_EQ(points.front().x, -1.0);
    EXPECT_EQ(points.back().x, 4.0);
    for (const core::Knot& point : points) EXPECT_EQ(point.y, direct.value(point.x));
  }
}

TEST(FunctionModel, ACurveIsDrawnWhateverTheKnots) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const core::SampledFunction bad{core::Interpolation::cubic,
                                  {{3.0, 1.0}, {1.0, 2.0}, {1.0, 5.0}, {nan, 1.0}, {2.0, nan}}};
  for (const core::Interpolation method :
       {core::Interpolation::linear, core::Interpolation::cubic, core::Interpolation::low_pass})
    for (const core::Knot& point : curve_points(bad, FunctionRole::trajectory, method, 0.0, 4.0, 9))
      EXPECT_TRUE(std::isfinite(point.y));
  EXPECT_TRUE(curve_points({}, FunctionRole::stc, core::Interpolation::cubic, 0.0, 1.0, 0).empty());
  EXPECT_EQ(curve_points({}, FunctionRole::stc, core::Interpolation::cubic, 0.0, 1.0, 3)[1].y, 0.0);
}

FunctionReading read_text(const AnyObject& object, std::string_view field, std::string_view text,
                          const std::string& name) {
  return read_function_file(object, field,
                            read_data_file(text, name, function_tables::function_kind(object, field).block), name);
}

TEST(FunctionModel, AFileThatIsWrittenIsReadBackExactly) {
  test::RandomScenes random(5);
  for (const auto& [object, field] : all_functions()) {
    FunctionDraft draft = function_of(object, field);
    const bool positive = function_info(object, field).per_pulse;
    for (core::SampledFunction& part : draft.parts)
      for (int i = 0; i < 20; ++i) {
        const double y = random.number();
        part.knots.push_back({i + 0.1, positive ? std::abs(y) + 1e-6 : y});
      }
    const std::string text = function_file_text(object, field, draft);
    EXPECT_TRUE(text.starts_with("! Data of: ")) << text.substr(0, 50);
    const FunctionReading reading = read_text(object, field, text, "saved.dat");
    EXPECT_EQ(printed(reading.problems), "") << field;
    draft.file = "saved.dat";
    EXPECT_TRUE(reading.draft == draft) << field;
  }
}

TEST(FunctionModel, ABadFileIsExplainedAndLeavesTheFunctionAsItWas) {
  Platform platform;
  platform.trajectory_m.part[0] = {core::Interpolation::cubic, {{0.0, 5.0}}};
  for (const char* text : {"", "two", "2 0 0 1", "1 0 0 1 0 0", "2 1 0 0 0 1 0 0 1 0 0", "$PLATFORM Earth"}) {
    const FunctionReading reading = read_text(platform, "trajectory_m", text, "bad.dat");
    EXPECT_TRUE(core::has_errors(reading.problems)) << text;
    EXPECT_EQ(reading.problems.front().place.file, "bad.dat");
    EXPECT_TRUE(reading.draft == function_of(platform, "trajectory_m")) << text;
  }
}

TEST(FunctionModel, InterpolationStaysThatOfTheObjectWhenAFileIsRead) {
  Radar radar;
  radar.window_gain.part[0].method = core::Interpolation::low_pass;
  const FunctionReading reading = read_text(radar, "window_gain", "2  0 0  1 1", "w.dat");
  EXPECT_EQ(reading.draft.parts[0].method, core::Interpolation::low_pass);
  EXPECT_EQ(reading.draft.file, "w.dat");
}

TEST(FunctionModel, CsvGivesXAndAColumnForEachPart) {
  const FunctionReading reading =
      import_function_csv(Platform{}, "trajectory_m", "t [ms],x [km],y,z\n1000,1,2,3\n0,4 m,5,\n", "track.csv");
  EXPECT_EQ(printed(reading.problems), "");
  EXPECT_EQ(reading.draft.parts[0].knots, (std::vector<core::Knot>{{0.0, 4.0}, {1.0, 1000.0}}));
  EXPECT_EQ(reading.draft.parts[1].knots, (std::vector<core::Knot>{{0.0, 5.0}, {1.0, 2.0}}));
  EXPECT_EQ(reading.draft.parts[2].knots, (std::vector<core::Knot>{{1.0, 3.0}}));
  EXPECT_EQ(reading.draft.file, "");
}

TEST(FunctionModel, CsvColumnsAreThoseOfTheirNames) {
  const FunctionReading reading =
      import_function_csv(Platform{}, "trajectory_m", "y,t_ms,z,x [km]\n2,1000,3,1\n", "track.csv");
  EXPECT_EQ(printed(reading.problems), "");
  EXPECT_EQ(reading.draft.parts[0].knots, (std::vector<core::Knot>{{1.0, 1000.0}}));
  EXPECT_EQ(reading.draft.parts[1].knots, (std::vector<core::Knot>{{1.0, 2.0}}));
  EXPECT_EQ(reading.draft.parts[2].knots, (std::vector<core::Knot>{{1.0, 3.0}}));
  EXPECT_NE(printed(import_function_csv(Platform{}, "trajectory_m", "t,lat,lon,h\n0,1,2,3\n", "t.csv").problems)
                .find("the name of column 2 is not that of position x"),
            std::string::npos);
}

TEST(FunctionModel, AListMayBeAColumnOfValuesAlone) {
  const FunctionReading reading = import_function_csv(Radar{}, "carrier_list_hz", "f [GHz]\n9.5\n9.6\n", "f.csv");
  EXPECT_EQ(printed(reading.problems), "");
  EXPECT_EQ(reading.draft.parts[0].knots, (std::vector<core::Knot>{{0.0, 9.5e9}, {1.0, 9.6e9}}));
  const FunctionReading numbered = import_function_csv(Radar{}, "pri_s", "0;1 ms\n1;2 ms\n", "p.csv");
  EXPECT_EQ(printed(numbered.problems), "");
  EXPECT_EQ(numbered.draft.parts[0].knots, (std::vector<core::Knot>{{0.0, 1e-3}, {1.0, 2e-3}}));
}

struct BadCsv {
  const char* text;
  const char* says;
  std::size_t line;
};

TEST(FunctionModel, BadCsvIsExplainedWithItsLineAndLeavesTheFunctionAsItWas) {
  const BadCsv table[] = {{"", "holds no numbers", 0},
                          {"x,y\n", "has no points", 0},
                          {"0,1\n1,two\n", "'two'", 2},
                          {"0,1\n1,2,3\n", "3 columns where 2 are expected", 2},
                          {"0,1\n0,2\n", "two points at the same", 0},
                          {"0,1\n,2\n", "is missing", 2},
                          {"0,1\n3\n", "the line has no value", 2},
                          {"0,1e19\n", "too large", 1},
                          {"0;1,5\n", "the decimal mark is the point: 1.5", 1},
                          {"R [kg],g\n0,1\n", "the unit of column Range is not known", 1}};
  Radar radar;
  radar.stc_gain.part[0].knots = {{0.0, 7.0}};
  for (const BadCsv& bad : table) {
    const FunctionReading reading = import_function_csv(radar, "stc_gain", bad.text, "bad.csv");
    EXPECT_TRUE(core::has_errors(reading.problems)) << bad.text;
    EXPECT_NE(printed(reading.problems).find(bad.says), std::string::npos) << printed(reading.problems);
    EXPECT_EQ(reading.problems.front().place.file, "bad.csv");
    EXPECT_EQ(reading.problems.front().place.line, bad.line) << bad.text;
    EXPECT_TRUE(reading.draft == function_of(radar, "stc_gain")) << bad.text;
  }
  EXPECT_NE(printed(import_function_csv(radar, "pri_s", "0,-1\n", "p.csv").problems).find("not above zero"),
            std::string::npos);
}

TEST(FunctionModel, TenThousandLinesOfCsvTakeNoTimeToSpeakOf) {
  std::string text;
  for (int i = 0; i < 10000; ++i) text += fmt::format("{}.5,{},{},{}\n", i, i, 2 * i, 3 * i);
  const sarsim::test::ProcessorTime time;
  const FunctionReading reading = import_function_csv(Platform{}, "trajectory_m", text, "t.csv");
  const double taken_s = time.seconds();
  EXPECT_EQ(reading.draft.parts[2].knots.size(), 10000U);
  EXPECT_LT(taken_s, 1.0);  // some 20 ms
}

}  // namespace function_model_test

}  // namespace sarsim::scene
