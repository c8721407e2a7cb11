#include "scene/ephemeris/write_motion.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/text/number_text.hpp"
#include "scene/ephemeris/ephemeris_test_support.hpp"
#include "scene/ephemeris/motion_test_support.hpp"
#include "scene/ephemeris/read_ephemeris.hpp"
#include "scene/script/data_file.hpp"

namespace sarsim::scene {

namespace write_motion_test {

using namespace motion_test;
using ephemeris_test::words_of;

EphemerisFile read_back(const std::string& text) {
  EphemerisReading reading = read_ephemeris(text, "m.txt");
  EXPECT_TRUE(reading.problems.empty()) << words_of(reading.problems);
  return reading.file;
}

bool holds(const std::string& text, std::string_view part) { return text.find(part) != std::string::npos; }

// The states that a file must hold, and how far the way out to the world and back in leads.
void expect_same(const EphemerisFile& file, const std::vector<MotionSample>& samples, const radar::EarthFrame& earth) {
  ASSERT_EQ(file.segments.size(), 1U);
  const std::vector<EphemerisState>& states = file.segments[0].states;
  ASSERT_EQ(states.size(), samples.size());
  for (std::size_t i = 0; i < states.size(); ++i) {
    EXPECT_EQ(states[i].position_m, earth.ecef_from_world(samples[i].position_m));
    ASSERT_TRUE(states[i].velocity_mps);
    EXPECT_EQ(*states[i].velocity_mps, earth.ecef_axes_from_world(samples[i].velocity_mps));
    EXPECT_LT(core::norm(earth.world_from_ecef(states[i].position_m) - samples[i].position_m), 1e-9);
  }
}

TEST(WriteMotion, GivesATableThatReadsBackBitForBit) {
  MotionFacts facts = facts_of_satellite();
  facts.object_name = "two\nlines\x1b";
  const std::vector<MotionSample> samples = orbit_samples(-1.0 / 3.0, 10.0 / 7.0, 50);
  const std::string text = sound(write_motion_csv(samples, facts));
  EXPECT_TRUE(
      text.starts_with("# Motion of two lines\\x1b, written by Sarsim\n"
                       "# Created 2025-03-14T12:00:00\n"
                       "# t: s after 2024-04-01T22:59:42.25Z\n"
                       "# Earth-fixed axes (ECEF, ITRF) from the centre of the Earth, m and m/s\n"
                       "# Interpolation HERMITE, degree 7\n"
                       "t,x,y,z,vx,vy,vz\n"
                       "-0.3333333333333333,"))
      << text.substr(0, 400);
  const EphemerisFile file = read_back(text);
  EXPECT_EQ(file.form, TimeForm::since_epoch);
  expect_same(file, samples, *facts.earth);
  for (std::size_t i = 0; i < samples.size(); ++i)
    EXPECT_EQ(file.segments[0].states[i].since_epoch_s, samples[i].time_s);
}

TEST(WriteMotion, WritesAFlatWorldAsItIs) {
  const std::vector<MotionSample> samples{{0.0, {1.0 / 3.0, -2e-7, 1e22}, {100.0, -0.0, 1e-300}}, {0.1, {}, {}}};
  MotionFacts facts;
  facts.interpolation = {};
  const std::string text = sound(write_motion_csv(samples, facts));
  EXPECT_TRUE(holds(text, "Axes of the world"));
  EXPECT_TRUE(holds(text, "# t: s after the epoch of the scene\n"));
  EXPECT_FALSE(holds(text, "Interpolation"));
  std::istringstream rows(text.substr(text.find("vz\n") + 3));
  std::vector<double> numbers;
  for (std::string cell, row; std::getline(rows, row);)
    for (std::istringstream cells(row); std::getline(cells, cell, ',');)
      numbers.push_back(core::parse_number(cell).value_or(std::nan("")));
  EXPECT_EQ(numbers, (std::vector<double>{0.0, 1.0 / 3.0, -2e-7, 1e22, 100.0, 0.0, 1e-300,  //
                                          0.1, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}));
}

TEST(WriteMotion, GivesAnOemOfTheStandard) {
  MotionFacts facts = facts_of_satellite();
  facts.epoch = utc("2024-04-01T22:59:42");
  facts.earth = radar::EarthFrame({{0.0, 0.0, 0.0}, 0.0});  // x east: ECEF y; y north: z; z up: x - a
  facts.interpolation = {InterpolationMethod::lagrange, 1};
  const std::vector<MotionSample> samples{{0.0, {10.0, 20.5, 1000.0}, {7000.25, 0.5, -1.0}},
                                          {0.1, {710.0, 20.5, 1000.0}, {7000.25, 0.5, -1.0}}};
  EXPECT_EQ(sound(write_motion_oem(samples, facts)),
            "CCSDS_OEM_VERS = 2.0\n"
            "COMMENT motion of one platform, Earth-fixed, km and km/s\n"
            "CREATION_DATE = 2025-03-14T12:00:00\n"
            "ORIGINATOR = SARSIM\n"
            "\n"
            "META_START\n"
            "OBJECT_NAME = SENTINEL LIKE\n"
            "OBJECT_ID = 2014-016A\n"
            "CENTER_NAME = EARTH\n"
            "REF_FRAME = ITRF\n"
            "TIME_SYSTEM = UTC\n"
            "START_TIME = 2024-04-01T22:59:42\n"
            "STOP_TIME = 2024-04-01T22:59:42.1\n"
            "INTERPOLATION = LAGRANGE\n"
            "INTERPOLATION_DEGREE = 1\n"
            "META_STOP\n"
            "2024-04-01T22:59:42 6379.137 0.01 0.0205 -0.001 7.00025 0.0005\n"
            "2024-04-01T22:59:42.1 6379.137 0.71 0.0205 -0.001 7.00025 0.0005\n");
}

TEST(WriteMotion, GivesAnOemThatReadsBackBitForBit) {
  const MotionFacts facts = facts_of_satellite();
  for (const double spacing_s : {10.0, 0.1, 1.0 / 1485.0, 100.0 / 3.0}) {
    const std::vector<MotionSample> samples = orbit_samples(-57.3, spacing_s, 200);
    const EphemerisFile file = read_back(sound(write_motion_oem(samples, facts)));
    EXPECT_EQ(file.object_name, "SENTINEL LIKE");
    EXPECT_EQ(file.frame, Frame::itrf);
    EXPECT_EQ(file.scale, radar::TimeScale::utc);
    EXPECT_EQ(file.segments.at(0).interpolation.method, InterpolationMethod::hermite);
    EXPECT_EQ(file.segments.at(0).interpolation.degree, 7);
    EXPECT_FALSE(file.segments.at(0).usable.start);
    expect_same(file, samples, *facts.earth);
    double worst_s = 0.0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const auto read = radar::instant_of(file.segments[0].states[i].time, radar::TimeScale::utc).instant;
      ASSERT_TRUE(read);
      worst_s = std::max(worst_s, std::abs(radar::seconds_between(*facts.epoch, *read) - samples[i].time_s));
    }
    EXPECT_LE(worst_s, spacing_s < 20.0 ? 6e-14 : 1e-12);
  }
}

TEST(WriteMotion, WritesShortTimesWhereTheyAreExact) {
  MotionFacts facts = facts_of_satellite();
  facts.epoch = utc("2024-04-01T22:59:42");
  const std::string text = sound(write_motion_oem(orbit_samples(0.0, 0.1, 30), facts));
  EXPECT_TRUE(holds(text, "\n2024-04-01T22:59:42.1 "));
  EXPECT_TRUE(holds(text, "\n2024-04-01T22:59:44 "));
  EXPECT_TRUE(holds(text, "\n2024-04-01T22:59:44.9 "));
}

TEST(WriteMotion, WritesTimesBeforeAndAfterALeapSecondOnly) {
  MotionFacts facts = facts_of_satellite();
  facts.epoch = utc("2016-12-31T23:59:50");
  EXPECT_EQ(refusal(write_motion_oem(orbit_samples(0.0, 1.0, 15), facts)), "a leap second lies among the samples");
  EXPECT_EQ(refusal(write_motion_oem(orbit_samples(0.0, 1.0, 11), facts)), "a leap second lies among the samples");
  EXPECT_EQ(refusal(write_motion_oem(orbit_samples(10.5, 1.0, 11), facts)), "a leap second lies among the samples");
  EXPECT_FALSE(sound(write_motion_oem(orbit_samples(0.0, 1.0, 10), facts)).empty());
  // The epoch is before the leap second, the samples behind it: 11 s later a clock shows 0 h.
  const std::string after = sound(write_motion_oem(orbit_samples(11.0, 1.0, 10), facts));
  EXPECT_TRUE(holds(after, "START_TIME = 2017-01-01T00:00:00\n"));
  EXPECT_FALSE(sound(write_motion_csv(orbit_samples(0.0, 1.0, 15), facts)).empty());
}

TEST(WriteMotion, RefusesSamplesThatCannotBe) {
  const MotionFacts facts = facts_of_satellite();
  const auto both = [&](const std::vector<MotionSample>& samples) {
    const std::string csv = refusal(write_motion_csv(samples, facts));
    EXPECT_EQ(refusal(write_motion_oem(samples, facts)), csv);
    return csv;
  };
  const auto changed = [](auto change) {
    std::vector<MotionSample> samples = orbit_samples(0.0, 1.0, 8);
    change(samples[3]);
    return samples;
  };
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(both({}), "there are no samples to write");
  EXPECT_EQ(both(changed([&](MotionSample& s) { s.time_s = nan; })), "the time of sample 4 is not finite");
  EXPECT_EQ(both(changed([](MotionSample& s) { s.time_s = 2.0; })), "the time of sample 4 does not ascend");
  EXPECT_EQ(both(changed([&](MotionSample& s) { s.position_m.y = nan; })),
            "the position or velocity at 3 s is not finite");
  EXPECT_EQ(both(changed([](MotionSample& s) { s.velocity_mps.z = std::numeric_limits<double>::infinity(); })),
            "the position or velocity at 3 s is not finite");
  EXPECT_EQ(both(changed([](MotionSample& s) {
              s.position_m = {0.0, 0.0, -1100.0};
            })),
            "the platform is below the ground at 3 s");
  EXPECT_EQ(both(changed([](MotionSample& s) {
              s.position_m = {2e9, 0.0, 0.0};
            })),
            "the platform is too far from the Earth at 3 s");
  EXPECT_EQ(refusal(write_motion_oem(changed([](MotionSample& s) { s.time_s = 2.0 + 4e-13; }), facts)),
            "samples 3 and 4 are too close for dates");
}

TEST(WriteMotion, RefusesAnOemWithoutWhatItNeeds) {
  const std::vector<MotionSample> samples = orbit_samples(0.0, 1.0, 8);
  const auto refused = [&](auto change) {
    MotionFacts facts = facts_of_satellite();
    change(facts);
    return refusal(write_motion_oem(samples, facts));
  };
  EXPECT_EQ(refused([](MotionFacts& f) { f.epoch.reset(); }), "the scene has no epoch, and this format has dates only");
  EXPECT_EQ(refused([](MotionFacts& f) { f.earth.reset(); }),
            "the scene does not lie on the Earth, and this format has positions from its centre only");
  EXPECT_EQ(refused([](MotionFacts& f) { f.created = "today"; }), "the creation date is not a time");
  EXPECT_EQ(refused([](MotionFacts& f) { f.created.clear(); }), "the creation date is not a time");
  EXPECT_EQ(refused([](MotionFacts& f) { f.epoch = radar::Instant{}; }), "a time is outside of the calendar");
  EXPECT_EQ(refused([](MotionFacts& f) { f.epoch = utc("9999-12-31T23:59:58"); }), "a time is outside of the calendar");
  for (const char* const name : {"", " A", "A ", "A\nB", "A\tB", "A [km]"})
    EXPECT_EQ(refused([&](MotionFacts& f) { f.object_name = name; }), "the name is not allowed in a CCSDS message");
  EXPECT_EQ(refused([](MotionFacts& f) { f.object_name = std::string(201, 'x'); }),
            "the name is not allowed in a CCSDS message");
  EXPECT_EQ(refused([](MotionFacts& f) { f.object_id.clear(); }), "the identifier is not allowed in a CCSDS message");
  EXPECT_EQ(refused([](MotionFacts& f) { f.interpolation.degree = 17; }),
            "there are too few samples for the interpolation");
  EXPECT_EQ(refused([](MotionFacts& f) {
              f.interpolation = {InterpolationMethod::lagrange, 8};
            }),
            "there are too few samples for the interpolation");
  EXPECT_EQ(refusal(write_motion_oem(orbit_samples(0.0, 1.0, 3), facts_of_satellite())),
            "there are too few samples for the interpolation");
  std::vector<MotionSample> far = samples;
  far.back().time_s = 1e12;
  EXPECT_EQ(refusal(write_motion_oem(far, facts_of_satellite())), "a time is too far from the epoch");
}

TEST(WriteMotion, KeepsNamesThatLookLikeOtherLines) {
  const std::vector<MotionSample> samples = orbit_samples(0.0, 1.0, 8);
  for (const char* const name : {"META_STOP", "COMMENT x", "A = B", "Fl\xC3\xBCgel 7", "[km] x"}) {
    MotionFacts facts = facts_of_satellite();
    facts.object_name = name;
    EXPECT_EQ(read_back(sound(write_motion_oem(samples, facts))).object_name, name);
  }
}

TEST(WriteMotion, GivesTheFunctionsOfADataFile) {
  const std::vector<MotionSample> samples = orbit_samples(-0.1, 1.0 / 3.0, 40);
  const auto functions = trajectory_functions(samples);
  EXPECT_EQ(functions[0].method, core::Interpolation::cubic);
  const std::string text = write_data_file(functions, function_blocks::trajectory);
  const DataFileReading reading = read_data_file(text, "p.dat", function_blocks::trajectory);
  EXPECT_TRUE(reading.problems.empty());
  ASSERT_EQ(reading.functions.size(), 3U);
  for (std::size_t part = 0; part < 3; ++part) {
    EXPECT_EQ(reading.functions[part], functions[part].knots);
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const core::Vec3& p = samples[i].position_m;
      EXPECT_EQ(reading.functions[part][i], (core::Knot{samples[i].time_s, std::array{p.x, p.y, p.z}[part]}));
    }
  }
}

}  // namespace write_motion_test

}  // namespace sarsim::scene
