#include "scene/model/shared.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <thread>
#include <variant>
#include <vector>

#include "scene/model/object.hpp"
#include "scene/model/scene.hpp"
#include "scene/schema/field_table.hpp"

namespace sarsim::scene {
namespace shared_test {

using Number = Shared<int>;

std::string begin() { return "begin"; }
using Text = Shared<std::string, begin>;

TEST(Shared, IsTheInitialValueAndTakesNoMemoryForIt) {
  EXPECT_EQ(*Number(), 0);
  EXPECT_EQ(*Text(), "begin");
  EXPECT_EQ(&*Text(), &*Text());
  EXPECT_EQ(sizeof(Text), sizeof(void*));
}

TEST(Shared, IsSharedByCopiesUntilOneIsChanged) {
  Text first = "text";
  Text second = first;
  EXPECT_EQ(&*first, &*second);
  const std::string* const before = &*second;
  first.edit() += " changed";
  EXPECT_EQ(*first, "text changed");
  EXPECT_EQ(*second, "text");
  EXPECT_EQ(&second.edit(), before);  // nobody else has it any more
}

TEST(Shared, ChangesTheInitialValueForItselfAlone) {
  Text first;
  first.edit() = "other";
  EXPECT_EQ(*first, "other");
  EXPECT_EQ(*Text(), "begin");
}

TEST(Shared, IsEqualWhereTheValueIs) {
  EXPECT_EQ(Text("one"), Text("one"));
  EXPECT_NE(Text("one"), Text("two"));
  EXPECT_EQ(Text("begin"), Text());
}

TEST(Shared, KeepsItsValueWhereItIsAssignedToItselfOrMoved) {
  Text text = "text";
  Text& same = text;
  text = same;
  EXPECT_EQ(*text, "text");
  const Text moved = std::move(text);
  EXPECT_EQ(*moved, "text");
}

TEST(Shared, TakesWhatAnotherHasWhereThatIsEqual) {
  const Text one = "one";
  Text other = "one";
  other.share(one);
  EXPECT_EQ(&*other, &*one);
  Text third = "third";
  third.share(one);
  EXPECT_EQ(*third, "third");
  Text initial = "begin";
  initial.share(one);
  EXPECT_EQ(&*initial, &*Text());
}

TEST(Shared, IsCopiedAndChangedByManyThreads) {
  const Text common = "common";
  std::vector<std::thread> threads;
  std::vector<std::string> results(4);
  for (std::size_t t = 0; t < results.size(); ++t)
    threads.emplace_back([&, t] {
      for (int i = 0; i < 10'000; ++i) {
        Text own = common;
        const Text second = own;
        own.edit() += std::to_string(t);
        results[t] = *own + *second;
      }
    });
  for (std::thread& thread : threads) thread.join();
  for (std::size_t t = 0; t < results.size(); ++t) EXPECT_EQ(results[t], "common" + std::to_string(t) + "common");
  EXPECT_EQ(*common, "common");
}

// The goal of 64 bytes for each of millions of targets leaves 16 for the places of its fields in the script.
TEST(Targets, AreSmall) { EXPECT_LE(sizeof(Target), 48U); }

TEST(Targets, ShareWhatTheyHaveInCommon) {
  Target first;
  first.platform = "a name of more than fifteen letters";
  first.traits.edit().reflectivity = Target::Reflectivity::directional;
  Target second = first;
  second.platform = std::string(*first.platform);
  second.traits.edit().rcs_stddev_m2 = 0.0;
  EXPECT_NE(&*second.traits, &*first.traits);
  share_equal(second, first);
  EXPECT_EQ(&*second.platform, &*first.platform);
  EXPECT_EQ(&*second.traits, &*first.traits);
}

TEST(Targets, DoNotShareWhereAZeroHasAnotherSign) {
  Target first;
  first.traits.edit().azimuth = core::Angle::from_deg(0.0);
  first.traits.edit().elevation = core::Angle::from_deg(1.0);
  Target second = first;
  second.traits.edit().azimuth = core::Angle::from_deg(-0.0);
  EXPECT_EQ(second, first);
  share_equal(second, first);
  EXPECT_TRUE(std::signbit(second.traits->azimuth.deg()));
  Target third = first;
  third.traits.edit().gain_db.part[0].knots = {{0.0, 1.0}};
  Target fourth = first;
  fourth.traits.edit().gain_db.part[0].knots = {{-0.0, 1.0}};
  share_equal(fourth, third);
  EXPECT_TRUE(std::signbit(fourth.traits->gain_db.part[0].knots[0].x));
}

// Whoever gives targets a further number has to name it in `identical`.
TEST(Targets, KeepTheSignOfEveryNumber) {
  std::size_t numbers = 0;
  for (const FieldOf<Target>& field : table_of<Target>().fields()) {
    Target first, second;
    first.traits.edit().gain_db.file = second.traits.edit().gain_db.file = "not as at first";
    if (std::holds_alternative<core::Vec3>(field.get(first))) {
      field.put(first, core::Vec3{});
      field.put(second, core::Vec3{0.0, 0.0, -0.0});
      share_equal(second, first);
      EXPECT_TRUE(std::signbit(std::get<core::Vec3>(field.get(second)).z)) << field.spec.id;
    } else if (std::holds_alternative<double>(field.get(first))) {
      field.put(first, 0.0);
      field.put(second, -0.0);
      share_equal(second, first);
      EXPECT_TRUE(std::signbit(std::get<double>(field.get(second)))) << field.spec.id;
    } else {
      continue;
    }
    ++numbers;
  }
  EXPECT_EQ(numbers, 8U);
}

}  // namespace shared_test
}  // namespace sarsim::scene
