#include "scene/ephemeris/read_ephemeris.hpp"

#include <array>
#include <cmath>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "scene/ephemeris/ephemeris_test_support.hpp"
#include "scene/ephemeris/sample_test_support.hpp"

namespace sarsim::scene {

namespace read_ephemeris_test {

using namespace ephemeris_test;

// The file of a reading without any problem.
EphemerisFile sound(std::string_view text, const std::string& satellite = {}) {
  EphemerisReading reading = read_ephemeris(text, "o.txt", {satellite});
  EXPECT_TRUE(reading.problems.empty()) << words_of(reading.problems);
  return reading.file;
}

core::Problem problem_in(std::string_view text, const std::string& satellite = {}) {
  return only_problem(read_ephemeris(text, "o.txt", {satellite}).problems);
}

// The only problem of the text with one piece replaced.
core::Problem problem_of(std::string_view text, std::string_view piece, std::string_view by) {
  return problem_in(replaced(text, piece, by));
}

const core::Vec3 first_position_m{1950200.216160, -4143460.384445, -5401629.615817};
const core::Vec3 first_velocity_mps{579.550068, -5889.842297, 4730.338429};

TEST(OrbitFormat, IsToldByTheFirstLines) {
  EXPECT_EQ(orbit_format_of(eof_text), OrbitFormat::eof);
  EXPECT_EQ(orbit_format_of(oem_text), OrbitFormat::oem);
  EXPECT_EQ(orbit_format_of(sp3_text), OrbitFormat::sp3);
  EXPECT_EQ(orbit_format_of(csv_text), OrbitFormat::csv);
  EXPECT_EQ(orbit_format_of(tle_text), OrbitFormat::tle);
  EXPECT_EQ(orbit_format_of(omm_kvn_text), OrbitFormat::omm_kvn);
  EXPECT_EQ(orbit_format_of(omm_xml_text), OrbitFormat::omm_xml);
  EXPECT_EQ(orbit_format_of(omm_csv_text), OrbitFormat::omm_csv);
  EXPECT_EQ(orbit_format_of(omm_json_text), OrbitFormat::omm_json);
  EXPECT_EQ(orbit_format_of(aem_text), OrbitFormat::aem);
  EXPECT_EQ(orbit_format_of("0 7e6 0 0\n"), OrbitFormat::csv);
  EXPECT_EQ(orbit_format_of(replaced(tle_text, "SENTINEL TEST", "TERRA X")), OrbitFormat::tle);
  EXPECT_EQ(orbit_format_of(replaced(tle_text, "SENTINEL TEST", "3CAT 2, X")), OrbitFormat::tle);
  EXPECT_EQ(orbit_format_of(tle_text.substr(tle_text.find('\n') + 1)), OrbitFormat::tle);
  EXPECT_EQ(orbit_format_of("\xEF\xBB\xBF" + std::string(eof_text)), OrbitFormat::eof);
  EXPECT_EQ(orbit_format_of("$PLATFORM P TRAJ\n"), OrbitFormat::unknown);
  EXPECT_EQ(orbit_format_of(""), OrbitFormat::unknown);
}

TEST(ReadEphemeris, ReadsASentinelOrbitFile) {
  const EphemerisFile file = sound(eof_text);
  EXPECT_EQ(file.object_name, "Sentinel-1A");
  EXPECT_EQ(file.frame, Frame::itrf);
  EXPECT_EQ(file.scale, radar::TimeScale::utc);
  EXPECT_EQ(file.form, TimeForm::civil);
  ASSERT_EQ(file.segments.size(), 1U);
  ASSERT_EQ(file.segments[0].states.size(), 2U);
  EXPECT_EQ(file.segments[0].states[0].time, (radar::CivilTime{2024, 4, 1, 22, 59, 42}));
  EXPECT_EQ(file.segments[0].states[0].position_m, first_position_m);
  EXPECT_EQ(file.segments[0].states[0].velocity_mps, first_velocity_mps);
  EXPECT_EQ(file.segments[0].states[1].time, (radar::CivilTime{2024, 4, 1, 22, 59, 52}));
}

TEST(ReadEphemeris, ReadsAnOemOfTwoSegments) {
  const EphemerisFile file = sound(oem_text);
  EXPECT_EQ(file.object_name, "SENTINEL-1A");
  EXPECT_EQ(file.frame, Frame::itrf);
  ASSERT_EQ(file.segments.size(), 2U);
  const EphemerisSegment& first = file.segments[0];
  ASSERT_EQ(first.states.size(), 2U);
  // Kilometres are scaled in decimals, so that the number is the one nearest to the text.
  EXPECT_EQ(first.states[0].position_m, (core::Vec3{1950200.216160, -4143460.384445, -5401629.615817}));
  EXPECT_EQ(first.states[0].velocity_mps, first_velocity_mps);
  EXPECT_EQ(first.usable.start, (radar::CivilTime{2024, 4, 1, 22, 59, 42}));
  EXPECT_EQ(first.usable.stop, (radar::CivilTime{2024, 4, 1, 22, 59, 52}));
  EXPECT_EQ(first.interpolation.method, InterpolationMethod::hermite);
  EXPECT_EQ(first.interpolation.degree, 7);
  const EphemerisSegment& second = file.segments[1];
  ASSERT_EQ(second.states.size(), 3U);
  EXPECT_EQ(second.states[2].time, (radar::CivilTime{2024, 4, 1, 23, 0, 12}));
  EXPECT_FALSE(second.usable.start);
  EXPECT_EQ(second.interpolation.method, InterpolationMethod::unsaid);
}

TEST(ReadEphemeris, ReadsEveryVersionFrameAndTimeSystemOfAnOem) {
  for (const char* version : {"1.0", "2.0", "3.0"})
    EXPECT_EQ(sound(replaced(oem_text, "2.0", version)).segments.size(), 2U);
  const std::string once(oem_text.substr(0, oem_text.find("COVARIANCE_START")));
  const std::array<std::pair<const char*, Frame>, 6> frames{{{"ITRF-97", Frame::itrf},
                                                             {"ITRF", Frame::itrf},
                                                             {"TEME", Frame::teme},
                                                             {"EME2000", Frame::eme2000},
                                                             {"GCRF", Frame::gcrf},
                                                             {"ICRF", Frame::gcrf}}};
  for (const auto& [word, frame] : frames) EXPECT_EQ(sound(replaced(once, "ITRF2014", word)).frame, frame) << word;
  for (const radar::TimeScale scale : {radar::TimeScale::utc, radar::TimeScale::tai, radar::TimeScale::gps,
                                       radar::TimeScale::tt, radar::TimeScale::ut1})
    EXPECT_EQ(sound(replaced(once, "= UTC", "= " + std::string(name_of(scale)))).scale, scale);
}

TEST(ReadEphemeris, ReadsOneSatelliteOfAnSp3File) {
  const EphemerisFile file = sound(sp3_text, "l51");
  EXPECT_EQ(file.frame, Frame::itrf);
  EXPECT_EQ(file.scale, radar::TimeScale::gps);
  ASSERT_EQ(file.segments.size(), 1U);
  const auto& states = file.segments[0].states;
  ASSERT_EQ(states.size(), 3U);
  EXPECT_EQ(states[0].time, (radar::CivilTime{2024, 4, 1, 22, 59, 42}));
  EXPECT_EQ(states[0].position_m, (core::Vec3{1950200.216, -4143460.384, -5401629.616}));
  EXPECT_EQ(states[0].velocity_mps, first_velocity_mps);
  EXPECT_EQ(states[1].velocity_mps, (core::Vec3{549.176492, -5844.051702, 4790.699309}));
  EXPECT_TRUE(states[2].velocity_mps);
  const auto epoch_of = [](std::string_view cells) {
    return sound(replaced(sp3_text, "1 23  0  2.00000000", cells), "L51").segments[0].states[2].time;
  };
  EXPECT_EQ(epoch_of("1 23  0  2.12345678"), (radar::CivilTime{2024, 4, 1, 23, 0, 2, 0.12345678}));
  EXPECT_EQ(epoch_of("01 23 00 02"), (radar::CivilTime{2024, 4, 1, 23, 0, 2}));
}

// Velocities are used of all states or of none: that the others are not is said.
TEST(ReadEphemeris, NamesStatesOfAnSp3FileWithoutAVelocity) {
  const std::string_view last = "VL51   5188.029160 -57982.611070  48510.601890 999999.999999\n";
  for (const char* const by : {"", "VL51      0.000000      0.000000      0.000000 999999.999999\n"}) {
    const EphemerisReading reading = read_ephemeris(replaced(sp3_text, last, by), "o.sp3", {"L51"});
    const core::Problem problem = only_problem(reading.problems);
    EXPECT_EQ(problem.severity, core::Severity::warning);
    EXPECT_EQ(problem.message, "states have no velocity: the velocities of the others are not used");
    EXPECT_EQ(problem.found, "1 of 3 states, the first at 2024-04-01T23:00:02");
    EXPECT_EQ(problem.place.line, 21U);
    EXPECT_FALSE(reading.file.segments.at(0).states.at(2).velocity_mps);
  }
}

TEST(ReadEphemeris, LeavesOutEpochsOfAnSp3FileWithoutAPosition) {
  const EphemerisReading reading = read_ephemeris(sp3_text, "o.sp3", {"G07"});
  const core::Problem problem = only_problem(reading.problems);
  EXPECT_EQ(problem.severity, core::Severity::warning);
  EXPECT_EQ(problem.found, "1 of 3");
  EXPECT_EQ(problem.place.line, 19U);
  ASSERT_EQ(reading.file.segments.size(), 1U);
  EXPECT_EQ(reading.file.segments[0].states.size(), 2U);
}

TEST(ReadEphemeris, ReadsTablesOfAllShapes) {
  const EphemerisFile file = sound(csv_text);
  EXPECT_EQ(file.form, TimeForm::since_epoch);
  ASSERT_EQ(file.segments.size(), 1U);
  ASSERT_EQ(file.segments[0].states.size(), 3U);
  EXPECT_EQ(file.segments[0].states[0].since_epoch_s, -10.0);
  EXPECT_EQ(file.segments[0].states[0].position_m, first_position_m);
  EXPECT_EQ(file.segments[0].states[0].velocity_mps, first_velocity_mps);

  const EphemerisFile civil = sound(
      "time (UTC); x (m); y (m); z (m)\r\n2024-04-01T00:00:00Z; 7e6; 0; 0\r\n"
      "2024-092T00:00:01; 7e6; 7000; 0");
  EXPECT_EQ(civil.form, TimeForm::civil);
  ASSERT_EQ(civil.segments[0].states.size(), 2U);
  EXPECT_EQ(civil.segments[0].states[1].time, (radar::CivilTime{2024, 4, 1, 0, 0, 1}));
  EXPECT_FALSE(civil.segments[0].states[1].velocity_mps);

  EXPECT_EQ(sound("0  7e6\t 0 0\n1 7e6 7e3 0\n").segments.size(), 1U);
  EXPECT_EQ(sound("0\t7e6\t0\t0\n").segments[0].states[0].position_m.x, 7e6);
}

TEST(ReadEphemeris, TakesLinesOfOtherSystems) {
  for (const std::string_view text : {eof_text, oem_text, sp3_text, csv_text}) {
    std::string other = "\xEF\xBB\xBF";
    if (text == sp3_text) other.clear();
    for (const char c : text) other += c == '\n' ? std::string("\r\n") : std::string(1, c);
    const EphemerisFile file = sound(other, text == sp3_text ? "L51" : "");
    const EphemerisFile same = sound(text, text == sp3_text ? "L51" : "");
    ASSERT_EQ(file.segments.size(), same.segments.size());
    ASSERT_EQ(file.segments[0].states.size(), same.segments[0].states.size());
    EXPECT_EQ(file.segments[0].states[1].position_m, same.segments[0].states[1].position_m);
  }
}

TEST(ReadEphemeris, SaysWhereAndWhatIsWrong) {
  const core::Problem problem = problem_of(oem_text, "-4202.130437922", "-4202,130437922");
  EXPECT_EQ(problem.place, (core::Place{"o.txt", 21, 38}));
  EXPECT_EQ(problem.message, "a position is not a finite number");
  EXPECT_EQ(problem.found, "-4202,130437922");
  EXPECT_EQ(problem.expected, "a finite number in km");
  EXPECT_EQ(problem.hint, "write a point, not a comma");
}

TEST(ReadEphemeris, ReportsAllProblemsOfAFileTogether) {
  std::string text = replaced(oem_text, "ITRF2014", "MARS_FIXED");
  text = replaced(text, "= UTC", "= TDB");
  text = replaced(text, "= EARTH", "= MARS");
  text = replaced(text, "1950.200216160", "nan");
  const core::Problems problems = read_ephemeris(text, "o.oem").problems;
  EXPECT_EQ(problems.size(), 4U) << words_of(problems);
}

TEST(ReadEphemeris, RefusesWrongMetadataOfAnOem) {
  const std::string once(oem_text.substr(0, oem_text.find("COVARIANCE_START")));
  core::Problem problem = problem_of(once, "CENTER_NAME = EARTH", "CENTER_NAME = MARS BARYCENTER");
  EXPECT_EQ(problem.message, "the centre of the orbit is not the Earth");
  EXPECT_EQ(problem.place, (core::Place{"o.txt", 9, 15}));
  problem = problem_of(once, "ITRF2014", "TOD");
  EXPECT_EQ(problem.message, "the frame is not known");
  EXPECT_NE(problem.expected.find("EME2000"), std::string::npos);
  problem = problem_of(once, "= UTC", "= TDB");
  EXPECT_EQ(problem.message, "the time system is not known");
  EXPECT_EQ(problem.expected, "one of UTC, TAI, GPS, TT, UT1");
  EXPECT_EQ(problem_of(once, "CENTER_NAME = EARTH\n", "").message, "CENTER_NAME is missing");
  EXPECT_EQ(problem_of(once, "REF_FRAME = ITRF2014\n", "").message, "REF_FRAME is missing");
  EXPECT_EQ(problem_of(once, "TIME_SYSTEM = UTC\n", "").message, "TIME_SYSTEM is missing");
  EXPECT_EQ(problem_of(once, "CENTER_NAME = EARTH\n", "CENTER_NAME = EARTH\nCENTER_NAME = EARTH\n").message,
            "the keyword appears twice in one block");
  EXPECT_EQ(problem_of(once, "INTERPOLATION_DEGREE = 7", "INTERPOLATION_DEGREE = 7.5").message,
            "the degree of interpolation is not a degree");
  EXPECT_EQ(problem_of(once, "VERS = 2.0", "VERS = 4.0").message, "this version of the message is not read");
  EXPECT_EQ(problem_of(replaced(once, "ITRF2014", "TEME"), "TIME_SYSTEM",
                       "REF_FRAME_EPOCH = 2024-01-01T00:00:00\nTIME_SYSTEM")
                .message,
            "TEME of a fixed epoch is not read");
}

// One message, and not one for each state.
TEST(ReadEphemeris, MetadataThatAreNotClosedAreOneMistake) {
  const core::Problem problem = problem_of(oem_text, "META_STOP\n", "");
  EXPECT_EQ(problem.message, "the block of metadata is not closed");
  EXPECT_EQ(problem.expected, "META_STOP before it");
  EXPECT_GT(problem.place.line, 1U);
}

TEST(ReadEphemeris, WarnsOfWordsThatItDoesNotKnow) {
  core::Problem problem = problem_of(oem_text, "INTERPOLATION = HERMITE", "INTERPOLATION = SPLINE");
  EXPECT_EQ(problem.severity, core::Severity::warning);
  EXPECT_EQ(problem.found, "SPLINE");
  problem = problem_of(oem_text, "INTERPOLATION = HERMITE", "INTERPOLATOIN = HERMITE");
  EXPECT_EQ(problem.severity, core::Severity::warning);
  EXPECT_EQ(problem.hint, "did you mean INTERPOLATION?");
}

TEST(ReadEphemeris, RefusesTimesThatDoNotAscend) {
  core::Problem problem = problem_of(oem_text, "22:59:52.0 1955", "22:59:42.0 1955");
  EXPECT_EQ(problem.message, "times must ascend and must not repeat") << core::to_string(problem);
}

TEST(ReadEphemeris, CountsRepeatedProblemsInsteadOfRepeatingThem) {
  std::string text = "0,7e6,0,0\n";
  for (int i = 0; i < 1000; ++i) text += "0,7e6,0,0\n";
  const core::Problem problem = problem_in(text);
  EXPECT_EQ(problem.message, "times must ascend and must not repeat");
  EXPECT_EQ(problem.count, 1000U);
  EXPECT_EQ(problem.place.line, 2U);
  EXPECT_EQ(problem.expected, "a time after 0 s");
}

TEST(ReadEphemeris, RefusesUsableRangesThatCannotBe) {
  core::Problem problem =
      problem_of(oem_text, "USEABLE_START_TIME = 2024-04-01T22:59:42", "USEABLE_START_TIME = 2024-04-01T22:59:41");
  EXPECT_EQ(problem.message, "the usable range begins where there are no states");
  EXPECT_EQ(problem.place.line, 6U);
  problem = problem_of(oem_text, "USEABLE_STOP_TIME = 2024-04-01T22:59:52", "USEABLE_STOP_TIME = 2024-04-01T22:59:53");
  EXPECT_EQ(problem.message, "the usable range ends where there are no states");
  // The second segment begins within the first one.
  std::string text = replaced(oem_text, "2024-092T22:59:52 1955", "2024-092T22:59:51 1955");
  EXPECT_EQ(problem_in(text).message, "two segments may be used at the same time");
}

TEST(ReadEphemeris, RefusesSegmentsOfDifferentFrames) {
  std::string text(oem_text);
  text.replace(text.rfind("ITRF2014"), 8, "GCRF");
  EXPECT_EQ(problem_in(text).message, "the segments have different frames or time systems");
}

TEST(ReadEphemeris, AsksWhichSatelliteIsMeant) {
  std::string text(oem_text);
  text.replace(text.rfind("SENTINEL-1A"), 11, "SENTINEL-1B");
  text.replace(text.rfind("2014-016A"), 9, "2016-025A");
  core::Problem problem = problem_in(text);
  EXPECT_EQ(problem.message, "the file holds 2 satellites, and none is selected");
  EXPECT_EQ(problem.expected, "one of SENTINEL-1A (2014-016A), SENTINEL-1B (2016-025A)");
  EXPECT_EQ(sound(text, "sentinel-1b").segments[0].states.size(), 3U);
  EXPECT_EQ(sound(text, "2014-016A").segments[0].states.size(), 2U);
  problem = problem_in(text, "SENTINEL-1C");
  EXPECT_EQ(problem.message, "the file does not hold the satellite that was chosen");
  EXPECT_EQ(problem.found, "SENTINEL-1C");
  EXPECT_EQ(problem_in(sp3_text).expected, "one of L51, G07");
  EXPECT_EQ(problem_in(sp3_text, "G08").hint, "did you mean G07?");
}

TEST(ReadEphemeris, RefusesPositionsThatNoOrbitHas) {
  core::Problem problem = problem_in("0,7000,0,0\n1,7000,7,0\n");
  EXPECT_EQ(problem.message, "a position is below the surface of the Earth");
  EXPECT_EQ(problem.hint, "are the numbers in another unit? m is expected here");
  EXPECT_EQ(problem.count, 2U);
  problem = problem_in(replaced(replaced(oem_text, "1950.200216160 -4143.460384445", "1950200.21 -4143460.38"),
                                "1955.843846035 -4202.130437922", "1955843.84 -4202130.43"));
  EXPECT_EQ(problem.message, "a position is more than 1e9 m from the Earth");
  EXPECT_EQ(problem.hint, "are the numbers in another unit? km is expected here");
  EXPECT_EQ(problem_in("0,0,0,6300000\n").found, "6.3e+06 m from its centre");
  EXPECT_TRUE(read_ephemeris("0,0,0,6356500\n", "o").problems.empty());
}

TEST(ReadEphemeris, WarnsOfVelocitiesThatDoNotFitThePositions) {
  const core::Problem problem = problem_in("0,7e6,0,0,0,7.5,0\n1,7e6,7500,0,0,7.5,0\n");
  EXPECT_EQ(problem.severity, core::Severity::warning);
  EXPECT_EQ(problem.message, "velocities do not fit the positions");
}

TEST(ReadEphemeris, RefusesNumbersThatAreNotFinite) {
  for (const char* number : {"nan", "inf", "-inf", "1e999", "", "7e6x"})
    EXPECT_FALSE(read_ephemeris("0,7e6,0,0\n1," + std::string(number) + ",0,0\n", "o").problems.empty()) << number;
}

TEST(ReadEphemeris, RefusesFilesWithoutStates) {
  EXPECT_EQ(problem_in("t,x,y,z\n").message, "the file holds no states");
  EXPECT_EQ(problem_in(oem_text.substr(0, oem_text.find("COMMENT states"))).message, "the file holds no states");
  EXPECT_EQ(problem_in("<Earth_Explorer_File><Ref_Frame>EARTH_FIXED</Ref_Frame></Earth_Explorer_File>").message,
            "the file holds no states");
  EXPECT_EQ(problem_in("").message, "the file is empty");
  EXPECT_EQ(problem_in(" \n\n").message, "the file is empty");
}

TEST(ReadEphemeris, RefusesFilesOfOtherFormats) {
  EXPECT_EQ(problem_in("$PLATFORM P TRAJ\n").message, "the format of the file is not known");
  EXPECT_EQ(problem_in(tle_text).message, "the file is a file of two-line elements, which cannot be used here");
  EXPECT_EQ(problem_in("<?xml version='1.0'?><oem id=\"CCSDS_OEM_VERS\"></oem>").message, "the file holds no states");
  EXPECT_EQ(problem_in("<?xml version='1.0'?><opm id=\"CCSDS_OPM_VERS\"></opm>").message,
            "the file is a CCSDS message of another kind or form, which cannot be used here");
  EXPECT_EQ(problem_in("CCSDS_OPM_VERS = 2.0\n").message,
            "the file is a CCSDS message of another kind or form, which cannot be used here");
  EXPECT_EQ(problem_in(std::string("t\0x", 3)).message, "the file is not a text of single bytes");
  EXPECT_EQ(problem_in("0,7e6,0,0\r1,7e6,0,0\r").message, "the lines end with carriage returns alone");
}

TEST(ReadEphemeris, RefusesDamagedSentinelFiles) {
  core::Problem problem = problem_of(eof_text, "<X unit=\"m\">1955843.846035</X>", "");
  EXPECT_EQ(problem.message, "X is missing in an OSV");
  EXPECT_EQ(problem.place.line, 29U);
  EXPECT_EQ(problem_of(eof_text, "unit=\"m/s\"", "unit=\"km/s\"").message, "VX has another unit than it should");
  EXPECT_EQ(problem_of(eof_text, "EARTH_FIXED", "EME2000").message, "the frame is not known");
  for (const char* const other : {"GPS", "TAI"})
    EXPECT_EQ(
        problem_of(eof_text, "<Mission>", fmt::format("<Time_Reference>{}</Time_Reference><Mission>", other)).message,
        "the times are not in UTC (Time_Reference)");
  EXPECT_EQ(words_of(read_ephemeris(replaced(eof_text, "<Mission>", "<Time_Reference>UTC</Time_Reference><Mission>"),
                                    "o.txt", {{}})
                         .problems),
            "");
  EXPECT_EQ(problem_of(eof_text, "count=\"2\"", "count=\"3\"").message,
            "the number of states is not the one that the list announces");
  EXPECT_EQ(problem_in(eof_text.substr(0, eof_text.size() / 2)).hint, "the file may be cut off");
  EXPECT_EQ(problem_of(eof_text, "Sentinel-1A", "&unknown;").message,
            "the name of the mission has an entity that is not known");
  EXPECT_EQ(problem_of(eof_text, "Sentinel-1A", "<![CDATA[x]]>").message, "declarations and CDATA are not read");
  EXPECT_EQ(problem_of(eof_text, "</OSV>", "</OSW>").message,
            "the element that ends here is not the one that was opened last");
  EXPECT_EQ(problem_of(eof_text, "NOMINAL", "DEGRADED").severity, core::Severity::warning);
  EXPECT_EQ(sound(replaced(eof_text, "Sentinel-1A", "A &amp; &#66;&#x43;")).object_name, "A & BC");
}

TEST(ReadEphemeris, RefusesDamagedSp3Files) {
  const auto problem_of_sp3 = [](std::string_view piece, std::string_view by) {
    return problem_in(replaced(sp3_text, piece, by), "L51");
  };
  EXPECT_EQ(problem_of_sp3("#cV", "#aV").message, "this version of SP3 is not read");
  EXPECT_EQ(problem_of_sp3("GPS", "GLO").message, "the time system is not known");
  EXPECT_EQ(problem_of_sp3("IGS14", "J2000").message, "the frame is not known");
  for (const char* cells :
       {"2024  4 31 23  0  2.00000000", "2024  4  1 24  0  2.00000000", "2024  4  1 23 60  2.00000000",
        "2024  4  1 23 59 61.00000000", "2024  4  1 23  0 -2.00000000", "2024  4  1 23  0 2.0000000Z",
        "2024  4  1 23  0  2.000e0000", "24    4  1 23  0  2.00000000"})
    EXPECT_EQ(problem_of_sp3("2024  4  1 23  0  2.00000000", cells).message, "the line is not an epoch") << cells;
  EXPECT_EQ(problem_of_sp3("PL51   1955.843846", "PL51   1955.8x3846").message, "a position is not a finite number");
  EXPECT_EQ(problem_of_sp3("EOF\n", "").severity, core::Severity::warning);
  EXPECT_EQ(problem_of_sp3("       3 ORBIT", "       4 ORBIT").severity, core::Severity::warning);
}

TEST(ReadEphemeris, RefusesTablesOfOtherColumns) {
  EXPECT_EQ(problem_in("t,x,y,z,v\n").message, "the table has a wrong number of columns");
  EXPECT_EQ(problem_in("t,x_km,y,z\n0,7000,0,0\n").found, "x_km");
  EXPECT_EQ(read_ephemeris("t,y,x,z\n0,7000,0,0\n", "o").problems.size(), 2U);
  EXPECT_EQ(problem_in("0,7e6,0,0\n1,7e6,0\n").message, "the line has another number of cells than those before");
  EXPECT_EQ(problem_in("2024-01-01T00:00:00,7e6,0,0\n1,7e6,0,0\n").message, "the time of a state is not a time");
}

TEST(ReadEphemeris, TakesALeapSecondInUtcOnly) {
  const std::string once(oem_text.substr(0, oem_text.find("COVARIANCE_START")));
  std::string text = replaced(once, "22:59:52.0", "23:59:60.0");
  text = replaced(text, "USEABLE_STOP_TIME = 2024-04-01T22:59:52\n", "");
  EXPECT_EQ(sound(text).segments[0].states[1].time.second, 60);
  EXPECT_EQ(problem_of(text, "= UTC", "= GPS").message,
            "the time of a state is in a leap second, which GPS does not have");
}

// Hour 24 and second 60.0 stand in files of laser ranging and of Swarm.
TEST(ReadEphemeris, ReadsEpochsAtTheEndOfADayAndOfAMinute) {
  const auto epoch_of = [](std::string_view cells) {
    return read_ephemeris(replaced(sp3_text, "2024  4  1 23  0  2.00000000", cells), "o.sp3", {"L51"})
        .file.segments.at(0)
        .states.at(2)
        .time;
  };
  EXPECT_EQ(epoch_of("2024  4  1 24  0  0.00000000"), (radar::CivilTime{2024, 4, 2}));
  EXPECT_EQ(epoch_of("2024 12 31 24  0  0.00000000"), (radar::CivilTime{2025, 1, 1}));
  EXPECT_EQ(epoch_of("2024  4  1 22 59 60.00000000"), (radar::CivilTime{2024, 4, 1, 23, 0, 0}));
  EXPECT_EQ(epoch_of("2024  4  1 23 59 60.25000000"), (radar::CivilTime{2024, 4, 2, 0, 0, 0, 0.25}));
  // A leap second stays one.
  const std::string utc =
      replaced(replaced(sp3_text, "cc GPS", "cc UTC"), "2024  4  1 23  0  2.00000000", "2024 12 31 23 59 60.00000000");
  EXPECT_EQ(read_ephemeris(utc, "o.sp3", {"L51"}).file.segments.at(0).states.at(2).time,
            (radar::CivilTime{2025, 1, 1}));
}

TEST(ReadEphemeris, TakesEarthFixedFramesOfLaserRanging) {
  for (const char* frame : {"ECF  ", "ITR20", "IGb14", "SLR08", "WGS84", "ecf  "})
    EXPECT_EQ(sound(replaced(sp3_text, "IGS14", frame), "L51").frame, Frame::itrf) << frame;
}

TEST(ReadEphemeris, NamesASatelliteWithoutRecords) {
  std::string text = replaced(sp3_text, "L51G07", "L52G07");
  EXPECT_EQ(problem_in(text, "L52").message, "the file has no records of satellite L52");
}

// The states of one motion, 10 s apart, in every format that has velocities.
struct OrbitTexts {
  std::string eof, oem, oem_xml, sp3, csv;
};

OrbitTexts texts_of(const radar::StateSamples& samples) {
  OrbitTexts texts;
  texts.eof = fmt::format("<Earth_Explorer_File><Ref_Frame>EARTH_FIXED</Ref_Frame><List_of_OSVs count=\"{}\">\n",
                          samples.time_s.size());
  texts.oem =
      "CCSDS_OEM_VERS = 2.0\nCREATION_DATE = 2024-04-02T00:00:00\nORIGINATOR = TEST\nMETA_START\nOBJECT_NAME = A\n"
      "OBJECT_ID = 1\nCENTER_NAME = EARTH\nREF_FRAME = ITRF\nTIME_SYSTEM = UTC\nSTART_TIME = 2024-04-01T00:00:00\n"
      "STOP_TIME = 2024-04-01T00:03:20\nMETA_STOP\n";
  texts.oem_xml =
      "<?xml version=\"1.0\"?>\n<oem id=\"CCSDS_OEM_VERS\" version=\"2.0\"><header><CREATION_DATE>2024-04-02T00:00:00"
      "</CREATION_DATE></header><body><segment><metadata><OBJECT_NAME>A</OBJECT_NAME><OBJECT_ID>1</OBJECT_ID>"
      "<CENTER_NAME>EARTH</CENTER_NAME><REF_FRAME>ITRF</REF_FRAME><TIME_SYSTEM>UTC</TIME_SYSTEM>"
      "<START_TIME>2024-04-01T00:00:00</START_TIME><STOP_TIME>2024-04-01T00:03:20</STOP_TIME></metadata><data>\n";
  texts.sp3 = fmt::format(
      "#cV2024  4  1  0  0  0.00000000 {:7} ORBIT IGS14 FIT  TST\n## 2308  86400.00000000    10.00000000 60401 0.0\n"
      "+    1   L51  0\n%c L  cc UTC ccc cccc cccc cccc cccc ccccc ccccc ccccc ccccc\n",
      samples.time_s.size());
  texts.csv = "t,x,y,z,vx,vy,vz\n";
  for (std::size_t i = 0; i < samples.time_s.size(); ++i) {
    const auto seconds = static_cast<int>(std::lround(samples.time_s[i]));
    const std::string time = fmt::format("2024-04-01T00:{:02}:{:02}", seconds / 60, seconds % 60);
    const core::Vec3 &p = samples.position_m[i], &v = samples.velocity_mps[i];
    texts.eof += fmt::format(
        "<OSV><TAI>TAI=2024-04-01T00:{:02}:{:02}</TAI><UTC>UTC={}</UTC><X>{:.6f}</X><Y>{:.6f}</Y><Z>{:.6f}</Z>"
        "<VX>{:.6f}</VX><VY>{:.6f}</VY><VZ>{:.6f}</VZ><Quality>NOMINAL</Quality></OSV>\n",
        (seconds + 37) / 60, (seconds + 37) % 60, time, p.x, p.y, p.z, v.x, v.y, v.z);
    texts.oem += fmt::format("{} {:.9f} {:.9f} {:.9f} {:.9f} {:.9f} {:.9f}\n", time, 1e-3 * p.x, 1e-3 * p.y, 1e-3 * p.z,
                             1e-3 * v.x, 1e-3 * v.y, 1e-3 * v.z);
    texts.oem_xml += fmt::format(
        "<stateVector><EPOCH>{}</EPOCH><X units=\"km\">{:.9f}</X><Y units=\"km\">{:.9f}</Y><Z>{:.9f}</Z>"
        "<X_DOT units=\"km/s\">{:.9f}</X_DOT><Y_DOT>{:.9f}</Y_DOT><Z_DOT>{:.9f}</Z_DOT></stateVector>\n",
        time, 1e-3 * p.x, 1e-3 * p.y, 1e-3 * p.z, 1e-3 * v.x, 1e-3 * v.y, 1e-3 * v.z);
    texts.sp3 += fmt::format("*  2024  4  1  0 {:2} {:11.8f}\nPL51{:14.6f}{:14.6f}{:14.6f}\n", seconds / 60,
                             static_cast<double>(seconds % 60), 1e-3 * p.x, 1e-3 * p.y, 1e-3 * p.z);
    texts.sp3 += fmt::format("VL51{:14.6f}{:14.6f}{:14.6f}\n", 10.0 * v.x, 10.0 * v.y, 10.0 * v.z);
    texts.csv += fmt::format("{},{:.6f},{:.6f},{:.6f},{:.6f},{:.6f},{:.6f}\n", seconds, p.x, p.y, p.z, v.x, v.y, v.z);
  }
  texts.eof += "</List_of_OSVs></Earth_Explorer_File>\n";
  texts.oem_xml += "</data></segment></body></oem>\n";
  texts.sp3 += "EOF\n";
  return texts;
}

radar::StateSamples low_orbit() {
  return sample_test::samples_of(sample_test::orbit({7078e3, 0.001, 1.71, 1.0, 2.0, 3.0}), 0.0, 10.0, 21, true);
}

TEST(ReadEphemeris, ReadsTheSameStatesFromEveryFormat) {
  const radar::StateSamples samples = low_orbit();
  const OrbitTexts texts = texts_of(samples);
  for (const std::string& text : {texts.eof, texts.oem, texts.oem_xml, texts.sp3, texts.csv}) {
    const EphemerisFile file = sound(text);
    ASSERT_EQ(file.segments.size(), 1U) << text.substr(0, 40);
    ASSERT_EQ(file.segments[0].states.size(), 21U);
    for (std::size_t i = 0; i < 21; ++i) {
      const EphemerisState& state = file.segments[0].states[i];
      EXPECT_LT(core::norm(state.position_m - samples.position_m[i]), 1e-3);
      EXPECT_LT(core::norm(*state.velocity_mps - samples.velocity_mps[i]), 1e-5);
    }
  }
  EXPECT_EQ(orbit_format_of(texts.oem_xml), OrbitFormat::oem_xml);
  EXPECT_EQ(problem_in(replaced(texts.oem_xml, "units=\"km/s\"", "units=\"m/s\"")).message,
            "X_DOT has another unit than it should");
  EXPECT_EQ(problem_in(replaced(texts.oem_xml, "<Y_DOT>", "<Y_DOTS>").replace(0, 0, "")).severity,
            core::Severity::error);
  EXPECT_EQ(problem_in(replaced(texts.oem_xml, "<Y_DOT", "<X units=\"km\">5</X><Y_DOT")).message,
            "X appears twice in one stateVector");
  EXPECT_EQ(problem_in(replaced(texts.oem_xml, "<REF_FRAME>ITRF</REF_FRAME>", "")).message, "REF_FRAME is missing");
}

TEST(ReadEphemeris, NamesTheStateThatContradictsItsNeighbours) {
  radar::StateSamples samples = low_orbit();
  samples.position_m[6].x += 1000.0;
  const OrbitTexts texts = texts_of(samples);
  for (const std::string& text : {texts.eof, texts.oem, texts.oem_xml, texts.sp3, texts.csv}) {
    const EphemerisReading reading = read_ephemeris(text, "o.txt");
    const core::Problem problem = only_problem(reading.problems);
    EXPECT_EQ(problem.severity, core::Severity::warning);
    EXPECT_EQ(problem.message, "a state does not fit those around it");
    EXPECT_EQ(problem.found.substr(0, 12), "1000 m off a") << problem.found;
    EXPECT_NE(problem.found.find(text == texts.csv ? "60 s" : "2024-04-01T00:01:00"), std::string::npos);
    EXPECT_GT(problem.place.line, 5U);
  }
}

TEST(ReadEphemeris, TellsVelocitiesOfAnotherUnit) {
  radar::StateSamples samples = low_orbit();
  for (core::Vec3& v : samples.velocity_mps) v = 1e-3 * v;
  const core::Problem problem = problem_in(texts_of(samples).csv);
  EXPECT_EQ(problem.message, "velocities do not fit the positions");
}

TEST(ReadEphemeris, NamesGapsWithTimeAndLength) {
  radar::StateSamples samples = low_orbit();
  const auto erase = [&](auto& list) { list.erase(list.begin() + 8, list.begin() + 10); };
  erase(samples.time_s), erase(samples.position_m), erase(samples.velocity_mps);
  const core::Problem problem = problem_in(texts_of(samples).oem);
  EXPECT_EQ(problem.message, "states are missing: the file has a gap");
  EXPECT_EQ(problem.found, "30 s behind 2024-04-01T00:01:10");
  EXPECT_EQ(problem.expected, "one every 10 s");
}

TEST(ReadEphemeris, ComparesWhatAHeadSaysWithTheStates) {
  const OrbitTexts texts = texts_of(low_orbit());
  core::Problem problem = problem_of(texts.oem, "START_TIME = 2024-04-01", "START_TIME = 2023-04-01");
  EXPECT_EQ(problem.message, "START_TIME is not the time of the first sample");
  EXPECT_EQ(problem.expected, "2024-04-01T00:00:00");
  problem = problem_of(texts.oem_xml, "<STOP_TIME>2024-04-01T00:03:20", "<STOP_TIME>2024-04-01T00:33:20");
  EXPECT_EQ(problem.message, "STOP_TIME is not the time of the last sample");
  problem = problem_of(texts.eof, "<Ref_Frame>", "<Validity_Start>UTC=2024-03-01T00:00:00</Validity_Start><Ref_Frame>");
  EXPECT_EQ(problem.message, "Validity_Start is not the time of the first sample");
  sound(replaced(texts.eof, "<Ref_Frame>", "<Validity_Start>UTC=2024-04-01T00:00:00</Validity_Start><Ref_Frame>"));
  problem = problem_of(texts.eof, "TAI=2024-04-01T00:00:57", "TAI=2024-04-01T00:00:58");
  EXPECT_EQ(problem.message, "TAI and UTC of a state are not the same moment");
  problem = problem_of(texts.sp3, "#cV2024  4  1  0", "#cV2024  4  1  3");
  EXPECT_EQ(problem.message, "the time of the first line is not the time of the first sample");
  problem = problem_of(texts.sp3, "   10.00000000 60401", "   30.00000000 60401");
  EXPECT_EQ(problem.message, "the interval of the second line is not that of the epochs");
}

TEST(ReadEphemeris, RefusesPositionsThatDoublesDoNotTellApart) {
  const auto told = [](const char* text) { return read_ephemeris(text, "o.csv", {"", true}).problems; };
  EXPECT_TRUE(told("0,1e10,0,0\n1,1e10,0,0\n").empty());
  EXPECT_EQ(only_problem(told("0,1e18,0,0\n1,1e18,0,0\n")).message, "a position is more than 1e11 m from the origin");
}

TEST(OrbitFormat, TellsTablesOfLatitudesFromOrbits) {
  EXPECT_EQ(what_is_no_orbit("time,Lat,Lon,alt\n0,47,8,1000\n", OrbitFormat::unknown),
            "columns of latitude and longitude, which are not read");
  EXPECT_EQ(what_is_no_orbit("a,b\n", OrbitFormat::unknown), "");
}

}  // namespace read_ephemeris_test

}  // namespace sarsim::scene
