#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "scene/ephemeris/ephemeris_test_support.hpp"
#include "scene/ephemeris/read_ephemeris.hpp"

namespace sarsim::scene {

namespace read_attitude_test {

using namespace ephemeris_test;

AttitudeFile sound(std::string_view text) {
  AttitudeReading reading = read_attitude(text, "a.aem");
  EXPECT_TRUE(reading.problems.empty()) << words_of(reading.problems);
  return reading.file;
}

core::Problem problem_of(std::string_view piece, std::string_view by) {
  return only_problem(read_attitude(replaced(aem_text, piece, by), "a.aem").problems);
}

const std::vector<AttitudeState>& states_of(const AttitudeFile& file) { return file.segments.at(0).states; }

// The sample with both keywords left out and another version.
std::string second_version() {
  std::string text = replaced(aem_text, "ATTITUDE_DIR = A2B\n", "");
  text = replaced(text, "QUATERNION_TYPE = LAST\n", "");
  return replaced(text, "AEM_VERS = 1.0", "AEM_VERS = 2.0");
}

TEST(ReadAttitude, ReadsQuaternionsOfBothVersions) {
  for (const std::string& text : {std::string(aem_text), second_version()}) {
    const AttitudeFile file = sound(text);
    EXPECT_EQ(file.object_name, "SENTINEL-1A");
    EXPECT_EQ(file.body_frame, "SC_BODY_1");
    EXPECT_EQ(file.reference, Frame::eme2000);
    EXPECT_EQ(file.scale, radar::TimeScale::utc);
    ASSERT_EQ(states_of(file).size(), 3U);
    EXPECT_EQ(states_of(file)[1].time, (radar::CivilTime{2024, 4, 1, 22, 59, 52}));
    EXPECT_EQ(file.segments[0].interpolation.method, InterpolationMethod::linear);
    EXPECT_EQ(file.segments[0].interpolation.degree, 1);
  }
}

TEST(ReadAttitude, MetadataThatAreNotClosedAreOneMistake) {
  EXPECT_EQ(problem_of("META_STOP\n", "").message, "the block of metadata is not closed");
}

TEST(ReadAttitude, GivesNeighboursOfOneSignAndLengthOne) {
  const AttitudeFile file = sound(aem_text);
  EXPECT_EQ(states_of(file)[0].body_from_reference, states_of(file)[1].body_from_reference);
  for (const AttitudeState& state : states_of(file)) {
    const Quaternion& q = state.body_from_reference;
    EXPECT_NEAR(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z, 1.0, 1e-15);
  }
}

TEST(ReadAttitude, TurnsAxesAsTheFormatSays) {
  // B is A turned by 90 degrees about z: the x axis of A lies along -y of B.
  const core::Mat3 body_from_reference = turned_from_first(states_of(sound(aem_text))[0].body_from_reference);
  const core::Vec3 x = body_from_reference * core::Vec3{1.0, 0.0, 0.0};
  EXPECT_NEAR(x.x, 0.0, 1e-8);
  EXPECT_NEAR(x.y, -1.0, 1e-8);
  EXPECT_NEAR(x.z, 0.0, 1e-8);
}

TEST(ReadAttitude, KnowsDirectionsAndOrders) {
  const Quaternion q = states_of(sound(aem_text))[0].body_from_reference;
  const auto third = [](const std::string& text) { return states_of(sound(text))[2].body_from_reference; };
  const Quaternion forward = third(std::string(aem_text));
  EXPECT_GT(q.z, 0.7);
  EXPECT_NEAR(forward.x, 0.1, 1e-8);
  EXPECT_NEAR(forward.w, 0.92736185, 1e-8);
  const Quaternion back = third(replaced(aem_text, "= A2B", "= B2A"));
  EXPECT_EQ(back, (Quaternion{forward.w, -forward.x, -forward.y, -forward.z}));
  std::string swapped = replaced(aem_text, "REF_FRAME_A = EME2000", "REF_FRAME_A = SC_BODY_1");
  swapped = replaced(swapped, "REF_FRAME_B = SC_BODY_1", "REF_FRAME_B = EME2000");
  EXPECT_EQ(third(swapped), back);
  const Quaternion first = third(replaced(aem_text, "= LAST", "= FIRST"));
  EXPECT_NEAR(first.w, 0.1, 1e-8);
  EXPECT_NEAR(first.x, 0.2, 1e-8);
  EXPECT_NEAR(first.z, 0.92736185, 1e-8);
}

TEST(ReadAttitude, PassesOverRates) {
  std::string text = replaced(aem_text, "ATTITUDE_TYPE = QUATERNION\n", "ATTITUDE_TYPE = QUATERNION/RATE\n");
  text = replaced(text, "0.70710678 0.70710678\n", "0.70710678 0.70710678 1 2 3\n");
  text = replaced(text, "-0.70710678 -0.70710678\n", "-0.70710678 -0.70710678 1 2 3\n");
  text = replaced(text, "0.92736185\n", "0.92736185 1 2 3\n");
  EXPECT_EQ(states_of(sound(text)).size(), 3U);
}

TEST(ReadAttitude, RefusesWhatItDoesNotUnderstand) {
  EXPECT_EQ(problem_of("ATTITUDE_DIR = A2B\n", "").message, "ATTITUDE_DIR is missing");
  EXPECT_EQ(problem_of("QUATERNION_TYPE = LAST\n", "").message, "QUATERNION_TYPE is missing");
  EXPECT_EQ(problem_of("= A2B", "= AB").message, "ATTITUDE_DIR is not known");
  EXPECT_EQ(problem_of("= LAST", "= MIDDLE").message, "QUATERNION_TYPE is not known");
  EXPECT_EQ(problem_of("= QUATERNION\n", "= EULER_ANGLE\n").message, "this type of attitude is not read");
  EXPECT_EQ(problem_of("= EME2000", "= LVLH").message, "the frame is not known");
  EXPECT_EQ(problem_of("= SC_BODY_1", "= INSTRUMENT_A").message,
            "one of the two frames must be the body of the satellite, and one not");
  EXPECT_EQ(problem_of("= UTC", "= TDB").message, "the time system is not known");
  EXPECT_EQ(problem_of("= EARTH", "= MARS").message, "the centre of the orbit is not the Earth");
  EXPECT_EQ(problem_of("ATTITUDE_DIR", "NEW_CONVENTION = 1\nATTITUDE_DIR").message, "the keyword is not known here");
  EXPECT_EQ(problem_of("AEM_VERS = 1.0", "AEM_VERS = 3.0").message, "this version of the message is not read");
  const std::string second = replaced(second_version(), "TIME_SYSTEM", "QUATERNION_TYPE = FIRST\nTIME_SYSTEM");
  EXPECT_EQ(only_problem(read_attitude(second, "a.aem").problems).found, "QUATERNION_TYPE = FIRST");
}

TEST(ReadAttitude, RefusesDamagedFiles) {
  core::Problem problem = problem_of("0 0 0.70710678 0.70710678", "0 0 0.80710678 0.70710678");
  EXPECT_EQ(problem.message, "a quaternion does not have the length 1");
  EXPECT_EQ(problem.place, (core::Place{"a.aem", 20, 21}));
  EXPECT_EQ(problem_of("22:59:52 0 0", "22:59:42 0 0").message, "times must ascend and must not repeat");
  EXPECT_EQ(problem_of("0.1 0.2 0.3", "0.1 0.2").message, "the line is not an attitude");
  EXPECT_EQ(problem_of("0.1 0.2 0.3", "0.1 nan 0.3").message, "a part of a quaternion is not a finite number");
  EXPECT_EQ(problem_of("DATA_STOP\n", "").message, "the file ends within a block");
  EXPECT_EQ(problem_of("STOP_TIME = 2024-04-01T23:00:02", "USEABLE_STOP_TIME = 2024-04-01T23:00:03").message,
            "the usable range ends where there are no states");
  const std::string text(aem_text.substr(0, aem_text.find("2024-04-01T22:59:42 0")));
  EXPECT_EQ(only_problem(read_attitude(text + "DATA_STOP\n", "a").problems).message, "the file holds no attitudes");
  EXPECT_EQ(only_problem(read_attitude(eof_text, "a").problems).message,
            "the file is a Sentinel-1 orbit file, which cannot be used here");
}

}  // namespace read_attitude_test

}  // namespace sarsim::scene
