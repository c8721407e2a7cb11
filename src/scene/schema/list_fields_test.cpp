#include "scene/schema/list_fields.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

namespace sarsim::scene {
namespace {

const Field& list_of(std::string_view id) {
  const std::vector<Field>& fields = fields_of(ObjectKind::platform);
  return *std::ranges::find(fields, id, &Field::id);
}

AnyObject platform_on(const std::string& path) {
  AnyObject platform = Platform{};
  EXPECT_EQ(set_field(platform, "path", path), "");
  return platform;
}

const Platform& of(const AnyObject& object) { return std::get<Platform>(object); }

TEST(ListFields, BeginARouteThatCanBeFlown) {
  AnyObject still = Platform{};
  std::get<Platform>(still).position_m = {100.0, 200.0, 300.0};
  ASSERT_EQ(set_field(still, "path", "Waypoints"), "");
  ASSERT_EQ(of(still).waypoints.size(), 2u);
  EXPECT_EQ(of(still).waypoints[0].position_m, (core::Vec3{100.0, 200.0, 300.0}));
  EXPECT_EQ(of(still).waypoints[1].position_m, (core::Vec3{100.0, 1200.0, 300.0}));
  EXPECT_GT(of(still).speed_mps, 0.0);

  const AnyObject legs = platform_on("Legs");
  ASSERT_EQ(of(legs).legs.size(), 1u);
  EXPECT_EQ(of(legs).legs[0].length_m, 1000.0);
  EXPECT_GT(of(legs).speed_mps, 0.0);
}

TEST(ListFields, ShowWhatAnEntryHasAndNothingElse) {
  AnyObject platform = platform_on("Legs");
  const Field& legs = list_of("legs");
  EXPECT_EQ(entry_text(platform, legs, 0, "kind"), "Straight");
  EXPECT_EQ(entry_text(platform, legs, 0, "length_m"), "1 km");
  EXPECT_EQ(entry_text(platform, legs, 0, "bank"), std::nullopt);
  ASSERT_EQ(set_entry(platform, legs, 0, "kind", "Turn"), "");
  ASSERT_EQ(set_entry(platform, legs, 0, "bank", "30 deg"), "");
  EXPECT_EQ(entry_text(platform, legs, 0, "length_m"), std::nullopt);
  EXPECT_EQ(entry_text(platform, legs, 0, "bank"), "30 deg");
  EXPECT_EQ(of(platform).legs[0].length_m, 0.0) << "what means nothing is not kept";
}

TEST(ListFields, RefuseWhatAFieldDoesNotTake) {
  AnyObject platform = platform_on("Waypoints");
  const AnyObject before = platform;
  EXPECT_NE(set_entry(platform, list_of("waypoints"), 1, "speed_mps", "fast"), "");
  EXPECT_NE(set_entry(platform, list_of("waypoints"), 1, "speed_mps", "-3 m/s"), "");
  EXPECT_EQ(platform, before);
}

TEST(ListFields, PutNewWaypointsWhereTheWayGoes) {
  AnyObject platform = platform_on("Waypoints");
  const Field& list = list_of("waypoints");
  ASSERT_EQ(set_entry(platform, list, 1, "position_m.x", "3 km"), "");
  ASSERT_EQ(set_entry(platform, list, 1, "position_m.y", "0"), "");
  add_entry(platform, list, 2);
  add_entry(platform, list, 1);
  add_entry(platform, list, 0);
  const std::vector<double> expected{-1500.0, 0.0, 1500.0, 3000.0, 6000.0};
  std::vector<double> x;
  for (const Waypoint& point : of(platform).waypoints) x.push_back(point.position_m.x);
  EXPECT_EQ(x, expected);
}

TEST(ListFields, MoveAndRemoveEntries) {
  AnyObject platform = Platform{};
  const Field& list = list_of("oscillations");
  for (const char* const frequency : {"1 Hz", "2 Hz", "3 Hz"}) {
    add_entry(platform, list, entry_count(platform, list));
    ASSERT_EQ(set_entry(platform, list, entry_count(platform, list) - 1, "frequency_hz", frequency), "");
  }
  const auto frequencies = [&] {
    std::vector<double> hz;
    for (const Oscillation& one : of(platform).oscillations) hz.push_back(one.frequency_hz);
    return hz;
  };
  move_entry(platform, list, 0, 2);
  EXPECT_EQ(frequencies(), (std::vector<double>{2.0, 3.0, 1.0}));
  move_entry(platform, list, 2, 1);
  EXPECT_EQ(frequencies(), (std::vector<double>{2.0, 1.0, 3.0}));
  remove_entry(platform, list, 1);
  EXPECT_EQ(frequencies(), (std::vector<double>{2.0, 3.0}));
}

TEST(ListFields, AreThoseOfTheObject) {
  AnyObject target = Target{};
  EXPECT_THROW(static_cast<void>(entry_count(target, list_of("legs"))), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(entry_fields(list_of("name"))), std::invalid_argument);
  AnyObject platform = platform_on("Legs");
  EXPECT_THROW(remove_entry(platform, list_of("legs"), 1), std::out_of_range);
  EXPECT_THROW(add_entry(platform, list_of("legs"), 2), std::out_of_range);
  EXPECT_THROW(move_entry(platform, list_of("legs"), 0, 1), std::out_of_range);
}

}  // namespace
}  // namespace sarsim::scene
