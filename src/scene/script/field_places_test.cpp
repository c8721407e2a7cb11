#include "scene/script/field_places.hpp"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace sarsim::scene {
namespace field_places_test {

TEST(FieldPlaces, FindTheFieldThenItsObjectThenNothing) {
  FieldPlaces places;
  places.add({"radar", 3, ""}, {"a.scr", 10, 1});
  places.add({"radar", 3, "prf_hz"}, {"a.scr", 12, 5});
  EXPECT_EQ(places.find({"radar", 3, "prf_hz"}), (core::Place{"a.scr", 12, 5}));
  EXPECT_EQ(places.find({"radar", 3, "power_w"}), (core::Place{"a.scr", 10, 1}));
  EXPECT_EQ(places.find({"radar", 2, "prf_hz"}), core::Place{});
  EXPECT_EQ(places.find({"target", 3, "prf_hz"}), core::Place{});
}

TEST(FieldPlaces, FindTheWholeMemberForAPartOfIt) {
  FieldPlaces places;
  places.add({"platform", 0, ""}, {"a.scr", 1, 1});
  places.add({"platform", 0, "trajectory_m"}, {"a.scr", 2, 1});
  EXPECT_EQ(places.find({"platform", 0, "trajectory_m.part[2]"}).line, 2U);
  EXPECT_EQ(places.find({"platform", 0, "trajectory_m[1]"}).line, 2U);
}

TEST(FieldPlaces, KeepTheFirstPlaceOfAField) {
  FieldPlaces places;
  places.add({"surface", 0, "corner_m"}, {"a.scr", 2, 1});
  places.add({"surface", 0, "corner_m"}, {"a.scr", 3, 1});
  EXPECT_EQ(places.find({"surface", 0, "corner_m"}).line, 2U);
}

TEST(FieldPlaces, KeepApartFilesAndTakeObjectsInAnyOrder) {
  FieldPlaces places;
  for (const std::size_t index : {5U, 1U, 3U, 1U})
    places.add({"target", index, "rcs_m2"}, {"file" + std::to_string(index), index, 7});
  for (const std::size_t index : {1U, 3U, 5U})
    EXPECT_EQ(places.find({"target", index, "rcs_m2"}), (core::Place{"file" + std::to_string(index), index, 7}));
}

TEST(FieldPlaces, FindWhatIsFarApart) {
  FieldPlaces places;
  std::size_t line = 1;
  for (std::size_t i = 0; i < 1000; ++i) {
    places.add({"target", 7 * i, ""}, {"a.scr", line, 1});
    places.add({"target", 7 * i, "position_m"}, {"a.scr", line + 1, 130});
    places.add({"target", 7 * i, "rcs_m2"}, {"a.scr", line + 1, 70'000});
    line += i % 10 == 0 ? 100'000 : 2;
  }
  line = 1;
  for (std::size_t i = 0; i < 1000; ++i) {
    EXPECT_EQ(places.find({"target", 7 * i, "power_w"}), (core::Place{"a.scr", line, 1}));
    EXPECT_EQ(places.find({"target", 7 * i, "position_m"}), (core::Place{"a.scr", line + 1, 130}));
    EXPECT_EQ(places.find({"target", 7 * i, "rcs_m2"}), (core::Place{"a.scr", line + 1, 70'000}));
    EXPECT_EQ(places.find({"target", 7 * i + 1, "rcs_m2"}), core::Place{});
    line += i % 10 == 0 ? 100'000 : 2;
  }
}

TEST(FieldPlaces, FindFieldsThatComeInAnyOrderOrAreLeftOut) {
  const std::vector<std::string> fields{"", "platform", "position_m", "rcs_m2", "gain_db"};
  std::minstd_rand random(7);
  FieldPlaces places;
  std::map<std::pair<std::size_t, std::string>, core::Place> noted;
  std::size_t line = 1;
  for (std::size_t object = 0; object < 2000; object += 1 + random() % 40 / 39)
    for (std::size_t n = random() % 9; n > 0; --n) {
      const std::string& field = fields[random() % fields.size()];
      line += random() % 70;
      const core::Place place{random() % 300 == 0 ? "b.scr" : "a.scr", line, 1 + random() % 200};
      places.add({"target", object, field}, place);
      noted.try_emplace({object, field}, place);
    }
  ASSERT_GT(noted.size(), 4000U);
  for (const auto& [subject, place] : noted)
    EXPECT_EQ(places.find({"target", subject.first, subject.second}), place) << subject.first << subject.second;
}

TEST(FieldPlaces, TakeTwoBytesWhereFieldsComeInTheSameOrder) {
  FieldPlaces places;
  constexpr std::size_t objects = 10'000;
  for (std::size_t i = 0; i < objects; ++i) {
    std::size_t column = 1;
    for (const char* field : {"", "platform", "position_m", "position_stddev_m", "rcs_m2", "reflectivity"})
      places.add({"target", i, field}, {"a.scr", 1 + i, column++});
  }
  EXPECT_LE(places.bytes(), 15 * objects);
}

TEST(FieldPlaces, OfManyPiecesAreThoseOfTheWhole) {
  FieldPlaces whole;
  FieldPlaces joined;
  for (std::size_t piece = 0; piece < 5; ++piece) {
    FieldPlaces part;
    for (std::size_t i = 0; i < 100; ++i)
      for (const char* field : {"", "position_m", "rcs_m2"}) {
        const core::Place place{"a.scr", 1 + 100 * piece + i, 1 + std::string_view(field).size()};
        part.add({"target", i, field}, place);
        whole.add({"target", 100 * piece + i, field}, place);
      }
    joined.append(part, [piece](std::string_view) { return 100 * piece; });
  }
  EXPECT_EQ(joined, whole);
  EXPECT_EQ(joined.find({"target", 477, "rcs_m2"}), (core::Place{"a.scr", 478, 7}));
}

TEST(FieldPlaces, ForgetColumnsBeyondAMillionButNotTheLine) {
  FieldPlaces places;
  places.add({"target", 0, "rcs_m2"}, {"a.scr", 1, 5'000'000});
  EXPECT_EQ(places.find({"target", 0, "rcs_m2"}), (core::Place{"a.scr", 1, 0}));
}

TEST(FieldPlaces, OfLaterObjectsAreCountedFromThoseBefore) {
  FieldPlaces whole;
  FieldPlaces first;
  FieldPlaces later;
  const auto add = [&](FieldPlaces& part, std::size_t before, const std::string& kind, std::size_t index,
                       const std::string& field, const core::Place& place) {
    part.add({kind, index, field}, place);
    whole.add({kind, before + index, field}, place);
  };
  add(first, 0, "target", 0, "", {"a.scr", 1, 1});
  add(first, 0, "target", 0, "rcs_m2", {"a.scr", 1, 9});
  add(first, 0, "radar", 0, "prf_hz", {"a.scr", 2, 1});
  add(later, 1, "radar", 0, "prf_hz", {"a.scr", 3, 1});
  add(later, 1, "radar", 1, "power_w", {"b.scr", 4, 5'000'000});
  add(later, 1, "target", 0, "rcs_m2", {"a.scr", 5, 1});
  first.append(
      later, [](std::string_view) { return 1U; }, 0.5);
  EXPECT_EQ(first.find({"target", 1, "rcs_m2"}), (core::Place{"a.scr", 5, 1}));
  EXPECT_EQ(first.find({"radar", 2, "power_w"}), (core::Place{"b.scr", 4, 0}));
  EXPECT_EQ(first.find({"target", 0, "rcs_m2"}), (core::Place{"a.scr", 1, 9}));
  EXPECT_EQ(first, whole);
  first.add({"target", 2, "rcs_m2"}, {"a.scr", 6, 1});
  EXPECT_FALSE(first == whole);
}

}  // namespace field_places_test
}  // namespace sarsim::scene
