#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "scene/ephemeris/ephemeris_test_support.hpp"
#include "scene/ephemeris/motion_test_support.hpp"
#include "scene/ephemeris/read_ephemeris.hpp"
#include "scene/ephemeris/write_motion.hpp"

namespace sarsim::scene {

namespace write_attitude_test {

using namespace motion_test;
using ephemeris_test::words_of;

double largest_difference(const core::Mat3& a, const core::Mat3& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < 3; ++i) largest = std::max(largest, core::norm(a.row[i] - b.row[i]));
  return largest;
}

Quaternion unit(double w, double x, double y, double z) {
  const double length = std::sqrt(w * w + x * x + y * y + z * z);
  return {w / length, x / length, y / length, z / length};
}

// A platform that tumbles: half turns about all axes among them.
AttitudeSample tumbling(double time_s) {
  const Quaternion q = unit(std::cos(0.7 * time_s), std::sin(0.31 * time_s), std::cos(1.3 * time_s), std::sin(time_s));
  return {time_s, turned_from_first(q)};
}

std::vector<AttitudeSample> tumbling_samples(std::size_t count) {
  std::vector<AttitudeSample> samples;
  for (std::size_t i = 0; i < count; ++i) samples.push_back(tumbling(0.1 * static_cast<double>(i)));
  return samples;
}

AttitudeFile read_back(const std::string& text) {
  AttitudeReading reading = read_attitude(text, "m.aem");
  EXPECT_TRUE(reading.problems.empty()) << words_of(reading.problems);
  return reading.file;
}

TEST(QuaternionOf, IsTheReverseOfTurnedFromFirst) {
  const double s = std::sqrt(0.5);
  for (const Quaternion& q : {Quaternion{1, 0, 0, 0},
                              {0, 1, 0, 0},
                              {0, 0, 1, 0},
                              {0, 0, 0, 1},
                              {s, s, 0, 0},
                              {s, 0, -s, 0},
                              {0, s, 0, -s},
                              {0.5, 0.5, -0.5, 0.5},
                              unit(1e-9, 1, 2, 3),
                              unit(1, 1e-9, -1e-9, 2e-9)}) {
    const Quaternion found = quaternion_of(turned_from_first(q));
    EXPECT_GE(found.w, 0.0);
    const double sign = q.w * found.w + q.x * found.x + q.y * found.y + q.z * found.z < 0.0 ? -1.0 : 1.0;
    EXPECT_NEAR(found.w, sign * q.w, 3e-16);
    EXPECT_NEAR(found.x, sign * q.x, 3e-16);
    EXPECT_NEAR(found.y, sign * q.y, 3e-16);
    EXPECT_NEAR(found.z, sign * q.z, 3e-16);
  }
  double worst = 0.0;
  for (int i = 0; i < 2000; ++i) {
    const core::Mat3 rotation = tumbling(0.01 * i).world_from_platform;
    worst = std::max(worst, largest_difference(turned_from_first(quaternion_of(rotation)), rotation));
  }
  EXPECT_LT(worst, 2e-15);
}

TEST(WriteAttitude, GivesAnAemOfTheStandard) {
  MotionFacts facts = facts_of_satellite();
  facts.epoch = utc("2024-04-01T22:59:42");
  facts.earth = radar::EarthFrame({{0.0, 0.0, 0.0}, 0.0});
  // World x, y, z are ECEF y, z, x: a turn of 120 deg about (1, 1, 1). The platform has the world's axes.
  const std::vector<AttitudeSample> samples{{0.0, {}}, {0.5, {}}};
  const std::string text = sound(write_attitude_aem(samples, facts, {InterpolationMethod::linear, 1}));
  EXPECT_EQ(text.substr(0, text.find("DATA_START")),
            "CCSDS_AEM_VERS = 1.0\n"
            "COMMENT attitude of one platform over the Earth-fixed axes\n"
            "CREATION_DATE = 2025-03-14T12:00:00\n"
            "ORIGINATOR = SARSIM\n"
            "\n"
            "META_START\n"
            "OBJECT_NAME = SENTINEL LIKE\n"
            "OBJECT_ID = 2014-016A\n"
            "CENTER_NAME = EARTH\n"
            "REF_FRAME_A = ITRF\n"
            "REF_FRAME_B = SC_BODY_1\n"
            "ATTITUDE_DIR = A2B\n"
            "TIME_SYSTEM = UTC\n"
            "START_TIME = 2024-04-01T22:59:42\n"
            "STOP_TIME = 2024-04-01T22:59:42.5\n"
            "ATTITUDE_TYPE = QUATERNION\n"
            "QUATERNION_TYPE = LAST\n"
            "INTERPOLATION_METHOD = LINEAR\n"
            "INTERPOLATION_DEGREE = 1\n"
            "META_STOP\n");
  const AttitudeFile file = read_back(text);
  ASSERT_EQ(file.segments.size(), 1U);
  EXPECT_EQ(file.segments[0].interpolation.method, InterpolationMethod::linear);
  const core::Vec3 along_y = turned_from_first(file.segments[0].states[0].body_from_reference) * core::Vec3{0, 1, 0};
  EXPECT_LT(core::norm(along_y - core::Vec3{1, 0, 0}), 1e-15);
}

TEST(WriteAttitude, ReadsBackToTheRounding) {
  const MotionFacts facts = facts_of_satellite();
  const std::vector<AttitudeSample> samples = tumbling_samples(300);
  const AttitudeFile file = read_back(sound(write_attitude_aem(samples, facts)));
  EXPECT_EQ(file.object_name, "SENTINEL LIKE");
  EXPECT_EQ(file.body_frame, "SC_BODY_1");
  EXPECT_EQ(file.reference, Frame::itrf);
  EXPECT_EQ(file.segments.at(0).interpolation.method, InterpolationMethod::unsaid);
  ASSERT_EQ(file.segments[0].states.size(), samples.size());
  double worst = 0.0;
  double worst_s = 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const AttitudeState& state = file.segments[0].states[i];
    const auto read = radar::instant_of(state.time, radar::TimeScale::utc).instant;
    ASSERT_TRUE(read);
    worst_s = std::max(worst_s, std::abs(radar::seconds_between(*facts.epoch, *read) - samples[i].time_s));
    // The platform's axes in the world, by way of the file.
    const core::Mat3 itrf_from_body = core::transposed(turned_from_first(state.body_from_reference));
    for (const core::Vec3& axis : {core::Vec3{1, 0, 0}, core::Vec3{0, 1, 0}, core::Vec3{0, 0, 1}}) {
      const core::Vec3 found = facts.earth->world_axes_from_ecef(itrf_from_body * axis);
      worst = std::max(worst, core::norm(found - samples[i].world_from_platform * axis));
    }
  }
  EXPECT_LT(worst, 2e-15);
  EXPECT_LT(worst_s, 1e-14);
}

TEST(WriteAttitude, GivesNeighboursOfOneSign) {
  const std::string text = sound(write_attitude_aem(tumbling_samples(300), facts_of_satellite()));
  std::istringstream lines(text.substr(text.find("DATA_START\n") + 11));
  std::array<double, 4> before{};
  std::string stamp;
  for (int i = 0; i < 300; ++i) {
    std::array<double, 4> q{};
    lines >> stamp >> q[0] >> q[1] >> q[2] >> q[3];
    ASSERT_TRUE(lines);
    const double product = std::inner_product(q.begin(), q.end(), before.begin(), 0.0);
    EXPECT_GT(product, i == 0 ? -1.0 : 0.9) << i;
    before = q;
  }
}

TEST(WriteAttitude, RefusesWhatCannotBe) {
  const std::vector<AttitudeSample> samples = tumbling_samples(5);
  const auto refused = [&](auto change) {
    MotionFacts facts = facts_of_satellite();
    std::vector<AttitudeSample> changed = samples;
    change(facts, changed);
    return refusal(write_attitude_aem(changed, facts));
  };
  using Facts = MotionFacts;
  using Samples = std::vector<AttitudeSample>;
  EXPECT_EQ(refused([](Facts&, Samples& s) { s.clear(); }), "there are no samples to write");
  EXPECT_EQ(refused([](Facts&, Samples& s) { s[1].time_s = 0.0; }), "the time of sample 2 does not ascend");
  EXPECT_EQ(refused([](Facts&, Samples& s) { s[1].time_s = 1e-13; }), "samples 1 and 2 are too close for dates");
  EXPECT_EQ(refused([](Facts&, Samples& s) { s[2].world_from_platform.row[1] = {}; }),
            "the attitude at 0.2 s is not a rotation");
  EXPECT_EQ(refused([](Facts&, Samples& s) { s[2].world_from_platform.row[1].x = std::nan(""); }),
            "the attitude at 0.2 s is not a rotation");
  EXPECT_EQ(refused([](Facts&, Samples& s) { s[2].world_from_platform = -1.0 * s[2].world_from_platform; }),
            "the attitude at 0.2 s is not a rotation");
  EXPECT_EQ(refused([](Facts& f, Samples&) { f.epoch.reset(); }),
            "the scene has no epoch, and this format has dates only");
  EXPECT_EQ(refused([](Facts& f, Samples&) { f.earth.reset(); }),
            "the scene does not lie on the Earth, and this format has positions from its centre only");
  EXPECT_EQ(refused([](Facts& f, Samples&) { f.epoch = utc("2016-12-31T23:59:59.9"); }),
            "a leap second lies among the samples");
  EXPECT_EQ(refused([](Facts& f, Samples&) { f.object_name = "A\nB"; }), "the name is not allowed in a CCSDS message");
}

}  // namespace write_attitude_test

}  // namespace sarsim::scene
