#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "scene/ephemeris/element_choice.hpp"
#include "scene/ephemeris/ephemeris_test_support.hpp"
#include "scene/ephemeris/read_ephemeris.hpp"

namespace sarsim::scene {

namespace read_mean_elements_test {

using namespace ephemeris_test;

MeanElementsFile sound(std::string_view text, const std::string& satellite = {}) {
  MeanElementsReading reading = read_mean_elements(text, "o.txt", {satellite});
  EXPECT_TRUE(reading.problems.empty()) << words_of(reading.problems);
  return reading.file;
}

core::Problem problem_in(std::string_view text, const std::string& satellite = {}) {
  return only_problem(read_mean_elements(text, "o.txt", {satellite}).problems);
}

core::Problem problem_of(std::string_view text, std::string_view piece, std::string_view by,
                         const std::string& satellite = {}) {
  return problem_in(replaced(text, piece, by), satellite);
}

// A line of a TLE with the checksum that belongs to it.
std::string with_checksum(std::string line) {
  int sum = 0;
  for (const char c : line.substr(0, 68)) sum += c >= '0' && c <= '9' ? c - '0' : c == '-' ? 1 : 0;
  line[68] = static_cast<char>('0' + sum % 10);
  return line;
}

// The first set of the sample with some columns (from 1) of one of its lines replaced, checksum included.
std::string tle_with(std::size_t line, std::size_t column, std::string_view by) {
  const std::size_t first = tle_text.find('\n') + 1;
  std::string lines[2] = {std::string(tle_text.substr(first, 69)), std::string(tle_text.substr(first + 70, 69))};
  lines[line - 1].replace(column - 1, by.size(), by);
  return with_checksum(lines[0]) + "\n" + with_checksum(lines[1]) + "\n";
}

constexpr double degree = std::numbers::pi / 180.0;
// A conversion rounds twice; the sine of nothing is taken here.
constexpr double tiny = 1e-15;

void expect_sample(const MeanElementsFile& file) {
  ASSERT_EQ(file.sets.size(), 1U);
  const ElementSet& set = file.sets[0];
  EXPECT_EQ(set.object_name, "SENTINEL TEST");
  EXPECT_EQ(set.object_id, "2014-016A");
  EXPECT_EQ(set.catalogue_number, 39634);
  EXPECT_EQ(set.epoch, (radar::CivilTime{2024, 4, 1, 12, 0, 0}));
  EXPECT_NEAR(set.elements.mean_motion_rad_per_s, 14.59198062 * 2.0 * std::numbers::pi / 86400.0, 1e-18);
  EXPECT_EQ(set.elements.eccentricity, 0.000134);
  EXPECT_NEAR(set.elements.inclination_rad, 98.1817 * degree, tiny);
  EXPECT_NEAR(set.elements.ascending_node_rad, 100.25 * degree, tiny);
  EXPECT_NEAR(set.elements.perigee_rad, 85.1 * degree, tiny);
  EXPECT_NEAR(set.elements.mean_anomaly_rad, 275.035 * degree, tiny);
  EXPECT_EQ(set.elements.drag_per_earth_radius, 3.621e-5);
  EXPECT_EQ(set.mean_motion_dot_rev_per_day2, 1.25e-6);
  EXPECT_EQ(set.mean_motion_ddot_rev_per_day3, 0.0);
  EXPECT_EQ(set.element_set, 999);
  EXPECT_EQ(set.revolution, 52231);
}

TEST(ReadMeanElements, ReadsTheSameFromEveryFormat) {
  expect_sample(sound(tle_text, "39634"));
  expect_sample(sound(tle_text, "sentinel test"));
  expect_sample(sound(omm_kvn_text));
  expect_sample(sound(omm_xml_text));
  expect_sample(sound(omm_csv_text, "39634"));
  expect_sample(sound(omm_json_text));
}

TEST(ReadMeanElements, ReadsTheOtherSatelliteOfAFile) {
  for (const MeanElementsFile& file : {sound(tle_text, "100001"), sound(omm_csv_text, "100001")}) {
    ASSERT_EQ(file.sets.size(), 1U);
    EXPECT_EQ(file.sets[0].catalogue_number, 100001);
    EXPECT_EQ(file.sets[0].object_id, "2024-001B");
    EXPECT_EQ(file.sets[0].epoch, (radar::CivilTime{2024, 1, 1, 0, 0, 0, 0.000864}));
    EXPECT_EQ(file.sets[0].elements.eccentricity, 0.7411);
    EXPECT_EQ(file.sets[0].mean_motion_dot_rev_per_day2, -8.4e-7);
  }
  EXPECT_EQ(sound(tle_text, "high one").sets[0].mean_motion_ddot_rev_per_day3, -0.12345e-6);
  EXPECT_EQ(sound(omm_csv_text, "100001").sets[0].object_name, "HIGH, \"ONE\"");
}

TEST(ReadMeanElements, KeepsAHistoryOfOneSatellite) {
  const std::string twice = tle_with(1, 21, "090") + tle_with(1, 21, "091");
  const MeanElementsFile file = sound(twice);
  ASSERT_EQ(file.sets.size(), 2U);
  EXPECT_LT(file.sets[0].epoch, file.sets[1].epoch);
  EXPECT_EQ(sound(std::string(omm_kvn_text) + std::string(omm_kvn_text)).sets.size(), 2U);
}

TEST(ReadMeanElements, TellsOfOtherElementsAtTheSameEpoch) {
  const std::string other = tle_with(2, 44, "285.0350");
  const MeanElementsFile file = sound(tle_with(1, 21, "092") + tle_with(2, 44, "275.0350") + other);
  ASSERT_EQ(file.sets.size(), 3U);
  const auto problem = problem_of_other_sets(file.sets, file.sets[1]);
  ASSERT_TRUE(problem);
  EXPECT_NE(problem->message.find("2 sets of the epoch 2024-04-01T12:00:00"), std::string::npos) << problem->message;
  EXPECT_EQ(problem->found, "mean anomaly 275.035 and 285.035 deg");
  EXPECT_FALSE(problem_of_other_sets(sound(std::string(omm_kvn_text) + std::string(omm_kvn_text)).sets,
                                     sound(omm_kvn_text).sets[0]));
}

// 14.59198062 rev/day is an axis of 7073.5 km.
TEST(ReadMeanElements, ComparesTheAxisWithTheMeanMotion) {
  const auto with_axis = [](const std::string& axis) {
    return read_mean_elements(
               replaced(omm_json_text, "\"ECCENTRICITY\"", "\"SEMI_MAJOR_AXIS\":" + axis + ",\"ECCENTRICITY\""),
               "o.txt", {{}})
        .problems;
  };
  EXPECT_TRUE(with_axis("7073.5").empty()) << words_of(with_axis("7073.5"));
  const core::Problem problem = only_problem(with_axis("9000"));
  EXPECT_EQ(problem.severity, core::Severity::warning);
  EXPECT_EQ(problem.message, "SEMI_MAJOR_AXIS is not that of MEAN_MOTION, which counts");
  EXPECT_NE(problem.expected.find("707"), std::string::npos) << problem.expected;
}

TEST(ReadMeanElements, RefusesAnEmptyFrameOfJson) {
  EXPECT_EQ(problem_of(omm_json_text, "\"ECCENTRICITY\"", "\"REF_FRAME\":\"\",\"ECCENTRICITY\"").message,
            "REF_FRAME has no value");
}

TEST(ReadMeanElements, ReadsNumbersOfTheCatalogueWithLetters) {
  const auto number = [](std::string_view cell) {
    const std::string text = tle_with(1, 3, cell);
    const std::string second = tle_with(2, 3, cell);
    return sound(text.substr(0, 70) + second.substr(70)).sets.at(0).catalogue_number;
  };
  EXPECT_EQ(number("00005"), 5);
  EXPECT_EQ(number("    5"), 5);
  EXPECT_EQ(number("H9999"), 179999);
  EXPECT_EQ(number("J0000"), 180000);
  EXPECT_EQ(number("P0000"), 230000);
  EXPECT_EQ(number("Z9999"), 339999);
  for (const char* cell : {"I0000", "O0000", "a0000", "0000A", "A 000", "AB000"}) {
    const std::string text = tle_with(1, 3, cell).substr(0, 70) + tle_with(2, 3, cell).substr(70);
    EXPECT_EQ(problem_in(text).message, "the catalogue number is not what it should be") << cell;
  }
}

TEST(ReadMeanElements, ReadsSignedAndEmptyDragTerms) {
  const auto drag = [](std::string_view cell) {
    return sound(tle_with(1, 54, cell)).sets.at(0).elements.drag_per_earth_radius;
  };
  EXPECT_EQ(drag("-13525-3"), -0.13525e-3);
  EXPECT_EQ(drag("+13525+1"), 0.13525e1);
  EXPECT_EQ(drag("        "), 0.0);
  EXPECT_EQ(drag(" 00000-0"), 0.0);
}

TEST(ReadMeanElements, TakesTitlesAndEndsOfLinesOfAllKinds) {
  const std::string lines = tle_with(1, 1, "1");
  const std::string first = lines.substr(0, 69);
  const std::string second = lines.substr(70, 69);
  EXPECT_EQ(sound(lines).sets.at(0).object_name, "");
  EXPECT_EQ(sound("0 VANGUARD 1  \r\n\r\n" + first + "\r\n \n" + second + "   ").sets.at(0).object_name, "VANGUARD 1");
}

TEST(ReadMeanElements, ReadsYearsFrom1957To2056) {
  EXPECT_EQ(sound(tle_with(1, 19, "57")).sets.at(0).epoch.year, 1957);
  EXPECT_EQ(sound(tle_with(1, 19, "99")).sets.at(0).epoch.year, 1999);
  EXPECT_EQ(sound(tle_with(1, 19, "00")).sets.at(0).epoch.year, 2000);
  EXPECT_EQ(sound(tle_with(1, 19, "56")).sets.at(0).epoch.year, 2056);
  EXPECT_EQ(sound(tle_with(1, 19, "57277.81150463")).sets.at(0).epoch,
            (radar::CivilTime{1957, 10, 4, 19, 28, 34, 0.000032}));
  EXPECT_EQ(sound(replaced(omm_kvn_text, "2024-04-01T12:00:00.000000", "1957-10-04T19:28:34")).sets.at(0).epoch,
            (radar::CivilTime{1957, 10, 4, 19, 28, 34}));
  EXPECT_EQ(sound(tle_with(1, 21, "366.99999999")).sets.at(0).epoch,
            (radar::CivilTime{2024, 12, 31, 23, 59, 59, 0.999136}));
}

TEST(ReadMeanElements, AsksWhichSatelliteIsMeant) {
  EXPECT_EQ(problem_in(tle_text).expected, "one of SENTINEL TEST (39634), HIGH ONE (100001)");
  EXPECT_EQ(problem_in(omm_csv_text).message, "the file holds 2 satellites, and none is selected");
  EXPECT_EQ(problem_in(tle_text, "SENTINEL TASTE").hint, "did you mean SENTINEL TEST?");
  EXPECT_EQ(problem_of(tle_text, "HIGH ONE", "SENTINEL TEST", "SENTINEL TEST").message,
            "2 satellites have the name that was chosen");
}

TEST(ReadMeanElements, RefusesDamagedLines) {
  core::Problem problem = problem_of(tle_text, "98.1817", "98.1818", "39634");
  EXPECT_EQ(problem.message, "the checksum of the line is wrong");
  EXPECT_EQ(problem.place, (core::Place{"o.txt", 3, 69}));
  EXPECT_EQ(problem.expected, "2");
  EXPECT_EQ(problem_of(tle_text, "36210-4 0  9992", "36210-4 0  999", "39634").message, "the line is too short");
  EXPECT_EQ(problem_in(tle_with(1, 3, "39635")).message, "the two lines belong to different satellites");
  for (const char* epoch : {"24367", "23366", "24000", "2x", "24092,5"})
    EXPECT_EQ(problem_in(tle_with(1, 19, epoch)).message, "the epoch is not what it should be") << epoch;
  EXPECT_EQ(problem_in(tle_with(1, 34, "-1.0000002")).message,
            "the first derivative of the mean motion is not what it should be");
  EXPECT_EQ(problem_in(tle_with(1, 45, " 0000000")).message,
            "the second derivative of the mean motion is not what it should be");
  EXPECT_EQ(problem_in(tle_with(1, 63, "4")).message, "the type of the elements is not what it should be");
  for (const char* drag : {" 36x10-4", "136210-4"})
    EXPECT_EQ(problem_in(tle_with(1, 54, drag)).message, "B* is not what it should be") << drag;
  EXPECT_EQ(problem_in(tle_with(2, 9, "198.1817")).message, "the inclination is not what it should be");
  EXPECT_EQ(problem_in(tle_with(2, 18, "-48.7242")).message, "the ascending node is not what it should be");
  for (const char* eccentricity : {"00 1340", "185966."})
    EXPECT_EQ(problem_in(tle_with(2, 27, eccentricity)).message, "the eccentricity is not what it should be");
  EXPECT_EQ(problem_in(tle_with(2, 35, "331.7x64")).message, "the argument of the perigee is not what it should be");
  EXPECT_EQ(problem_in(tle_with(2, 44, "361.3264")).message, "the mean anomaly is not what it should be");
  for (const char* motion : {"90", " 0.00000000"})
    EXPECT_EQ(problem_in(tle_with(2, 53, motion)).message, "the mean motion is not what it should be");
  const std::string both = tle_with(1, 1, "1");
  EXPECT_EQ(problem_in(both.substr(0, 70)).message, "the second line of a set is missing");
  EXPECT_EQ(problem_in(both + both.substr(70)).message, "a second line without a first one");
}

TEST(ReadMeanElements, RefusesDamagedMessages) {
  EXPECT_EQ(problem_of(omm_kvn_text, "= TEME", "= EME2000").message, "REF_FRAME is not what SGP4 needs");
  EXPECT_EQ(problem_of(omm_kvn_text, "= UTC", "= TAI").message, "TIME_SYSTEM is not what SGP4 needs");
  EXPECT_EQ(problem_of(omm_kvn_text, "= EARTH", "= MOON").message, "CENTER_NAME is not what SGP4 needs");
  EXPECT_EQ(problem_of(omm_kvn_text, "= SGP4", "= DSST").message, "MEAN_ELEMENT_THEORY is not what SGP4 needs");
  EXPECT_EQ(problem_of(omm_kvn_text, "EPHEMERIS_TYPE = 0", "EPHEMERIS_TYPE = 4").message,
            "EPHEMERIS_TYPE is not what SGP4 needs");
  EXPECT_EQ(problem_of(omm_kvn_text, "[deg]", "[rad]").message, "INCLINATION has another unit than it should");
  EXPECT_EQ(problem_of(omm_kvn_text, "ECCENTRICITY = 0.0001340", "ECCENTRICITY = 1.2").message,
            "ECCENTRICITY is out of range");
  EXPECT_EQ(problem_of(omm_kvn_text, "MEAN_ANOMALY = 275.0350 [deg]\n", "").message, "MEAN_ANOMALY is missing");
  EXPECT_EQ(problem_of(omm_kvn_text, "MEAN_MOTION = 14.59198062 [rev/day]", "SEMI_MAJOR_AXIS = 7070 [km]").message,
            "SGP4 needs a mean motion, not an axis");
  EXPECT_EQ(problem_of(omm_kvn_text, "04-01T12:00:00.000000", "04-31T12:00:00.000000").message, "EPOCH is not a time");
  EXPECT_EQ(problem_of(omm_xml_text, "&#84;", "&t;").message, "an entity is not known");
  EXPECT_EQ(problem_of(omm_xml_text, "275.0350", "x").place.line, 12U);
  EXPECT_EQ(problem_of(omm_csv_text, ",.125E-5,0\n", ",.125E-5\n", "39634").message,
            "the line has another number of cells than the first one");
  EXPECT_EQ(problem_of(omm_json_text, "0.000134,", "0.000134").message, "the object is not closed");
  EXPECT_EQ(problem_of(omm_json_text, "null}\n]", "null}\n").hint, "the file may be cut off");
  EXPECT_EQ(problem_of(omm_json_text, "\"EPOCH\": \"2024-04-01T12:00:00.000000\",", "").message, "EPOCH is missing");
  EXPECT_EQ(problem_in("[{\"X\": \"MEAN_MOTION\"}]").message, "the file holds no elements");
  EXPECT_EQ(problem_in(oem_text).message, "the file is a CCSDS OEM, which cannot be used here");
}

TEST(ReadMeanElements, SaysThatDaysCountFromOne) {
  EXPECT_EQ(problem_in(tle_with(1, 19, "24000")).expected,
            "a day from 001 to 366: days count from 1, noon of January 1 is 001.5");
}

TEST(ReadMeanElements, NamesProseAboveTheLines) {
  const std::string text =
      "This file has the elements of today, and more.\nThey are from a catalogue.\n" + std::string(tle_text);
  EXPECT_EQ(orbit_format_of(text), OrbitFormat::tle);
  const core::Problem problem = problem_in(text, "39634");
  EXPECT_EQ(problem.message, "the file has the lines of two-line elements, but this one is none of them");
  EXPECT_EQ(problem.place.line, 1U);
}

TEST(ReadMeanElements, RefusesKeywordsWithoutAValue) {
  EXPECT_EQ(problem_of(omm_kvn_text, "REF_FRAME = TEME", "REF_FRAME =").message, "REF_FRAME has no value");
  EXPECT_EQ(problem_of(omm_xml_text, "<REF_FRAME>TEME</REF_FRAME>", "<REF_FRAME></REF_FRAME>").message,
            "REF_FRAME has no value");
  EXPECT_EQ(problem_of(omm_xml_text, "<REF_FRAME>TEME</REF_FRAME>", "<REF_FRAME/>").message, "REF_FRAME has no value");
}

}  // namespace read_mean_elements_test

}  // namespace sarsim::scene
