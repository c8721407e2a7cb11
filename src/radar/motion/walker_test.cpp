#include "radar/motion/walker.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>

#include "core/maths/interpolator.hpp"

namespace sarsim::radar {
namespace walker_test {

const core::Vec3& part(const WalkerBody& body, BodyPart p) { return body[static_cast<std::size_t>(p)]; }

constexpr double speeds[] = {0.1, 0.3, 0.5, 1.0, 1.3, 2.0, 3.0};

// Calls `look` with a body and its parts at 200 times of a cycle.
template <class Look>
void each_moment(double relative_speed, const Look& look) {
  const WalkingBody body({1.8, relative_speed});
  for (int i = 0; i < 200; ++i) look(body, body.gait().cycle_s * i / 200.0);
}

TEST(Gait, HasTheNumbersOfTheModel) {
  const Gait gait = gait_of({1.8, 1.0});
  EXPECT_NEAR(gait.speed_mps, 0.8838, 1e-12);
  EXPECT_NEAR(gait.cycle_s, 1.346, 1e-12);
  EXPECT_NEAR(gait.support_s, 0.8692, 5e-5);
  EXPECT_NEAR(walker_at(1.8, 0.8838).relative_speed, 1.0, 1e-12);
}

TEST(WalkingBody, IsCyclic) {
  for (const double rv : speeds)
    each_moment(rv, [](const WalkingBody& body, double t) {
      const WalkerBody now = body.cyclic(t), next = body.cyclic(t + body.gait().cycle_s);
      for (std::size_t k = 0; k < body_part_count; ++k) EXPECT_LT(core::norm(next[k] - now[k]), 1e-10);
    });
}

TEST(WalkingBody, AdvancesByItsSpeed) {
  for (const double rv : speeds) {
    const WalkingBody body({1.8, rv});
    const double time = 10.0 * body.gait().cycle_s;
    const WalkerBody start = body.at(0.2), end = body.at(0.2 + time);
    for (std::size_t k = 0; k < body_part_count; ++k) {
      EXPECT_NEAR((end[k].x - start[k].x) / time, body.gait().speed_mps, 1e-10);
      EXPECT_NEAR(end[k].y, start[k].y, 1e-10);
    }
  }
}

TEST(WalkingBody, KeepsItsFeetOnOrAboveTheGround) {
  for (const double rv : speeds) {
    double lowest = std::numeric_limits<double>::infinity(), highest = 0.0;
    each_moment(rv, [&](const WalkingBody& body, double t) {
      const WalkerBody now = body.at(t);
      for (const BodyPart p : {BodyPart::left_toe, BodyPart::right_toe, BodyPart::left_ankle, BodyPart::right_ankle}) {
        lowest = std::min(lowest, part(now, p).z);
        highest = std::max(highest, part(now, p).z);
      }
    });
    EXPECT_GT(lowest, -0.001) << rv;
    EXPECT_LT(lowest, 0.05) << rv;
    EXPECT_LT(highest, 0.8) << rv;
  }
}

// In the middle of the support (0.15 to 0.5 of the cycle for the right foot) the ankle slides by a few centimetres.
TEST(WalkingBody, NearlyStandsOnItsSupportingFoot) {
  const WalkingBody body({1.8, 1.0});
  double first = std::numeric_limits<double>::infinity(), last = -first;
  for (double phase = 0.1; phase <= 0.5; phase += 0.01) {
    const double x = part(body.at(phase * body.gait().cycle_s), BodyPart::right_ankle).x;
    first = std::min(first, x);
    last = std::max(last, x);
  }
  EXPECT_LT(last - first, 0.10);
}

TEST(WalkingBody, KeepsTheLengthsOfItsBones) {
  const auto length = [](const WalkerBody& b, BodyPart p, BodyPart q) { return core::norm(part(b, p) - part(b, q)); };
  for (const double rv : speeds)
    each_moment(rv, [&](const WalkingBody& body, double t) {
      const WalkerBody b = body.at(t);
      EXPECT_NEAR(length(b, BodyPart::left_hip, BodyPart::left_knee), 0.245 * 1.8, 1e-12);
      EXPECT_NEAR(length(b, BodyPart::right_knee, BodyPart::right_ankle), 0.246 * 1.8, 1e-12);
      EXPECT_NEAR(length(b, BodyPart::left_shoulder, BodyPart::left_elbow), 0.188 * 1.8, 1e-12);
      EXPECT_NEAR(length(b, BodyPart::right_elbow, BodyPart::right_hand), 0.152 * 1.8, 1e-12);
      EXPECT_NEAR(length(b, BodyPart::spine, BodyPart::neck), 0.288 * 1.8, 1e-12);
      EXPECT_NEAR(length(b, BodyPart::left_hip, BodyPart::right_hip), 0.191 * 1.8, 1e-12);
      EXPECT_NEAR(length(b, BodyPart::left_shoulder, BodyPart::right_shoulder), 0.259 * 1.8, 1e-12);
    });
}

TEST(WalkingBody, IsItsOwnMirrorImageHalfACycleLater) {
  for (const double rv : speeds)
    each_moment(rv, [](const WalkingBody& body, double t) {
      const WalkerBody now = body.cyclic(t), later = body.cyclic(t + 0.5 * body.gait().cycle_s);
      for (const auto& [left, right] :
           {std::pair{BodyPart::left_toe, BodyPart::right_toe}, std::pair{BodyPart::left_knee, BodyPart::right_knee}}) {
        EXPECT_NEAR(part(now, left).x, part(later, right).x, 1e-10);
        EXPECT_NEAR(part(now, left).y, -part(later, right).y, 1e-10);
        EXPECT_NEAR(part(now, left).z, part(later, right).z, 1e-10);
      }
    });
}

TEST(WalkingBody, SwingsArmsAgainstLegs) {
  const WalkerBody strike = WalkingBody({1.8, 1.0}).at(0.0);
  EXPECT_GT(part(strike, BodyPart::right_ankle).x, part(strike, BodyPart::left_ankle).x + 0.4);
  EXPECT_LT(part(strike, BodyPart::right_hand).x, part(strike, BodyPart::left_hand).x - 0.1);
  EXPECT_GT(part(strike, BodyPart::right_hip).x, part(strike, BodyPart::left_hip).x);
  EXPECT_GT(part(strike, BodyPart::left_shoulder).x, part(strike, BodyPart::right_shoulder).x);
  EXPECT_GT(part(strike, BodyPart::left_hip).y, part(strike, BodyPart::right_hip).y);
  EXPECT_NEAR(part(strike, BodyPart::head).z, 1.74, 0.06);
}

// Toes are the fastest: two to four times the mean speed, as measured micro-Doppler shows.
TEST(WalkingBody, MovesItsToesFastest) {
  const WalkingBody body({1.8, 1.0});
  double toe = 0.0, spine = 0.0;
  constexpr double h = 1e-4;
  for (double t = 0.0; t < body.gait().cycle_s; t += 0.005) {
    const WalkerBody now = body.at(t), then = body.at(t + h);
    toe = std::max(toe, (part(then, BodyPart::right_toe).x - part(now, BodyPart::right_toe).x) / h);
    spine = std::max(spine, (part(then, BodyPart::spine).x - part(now, BodyPart::spine).x) / h);
  }
  EXPECT_GT(toe, 2.5 * 0.8838);
  EXPECT_LT(toe, 6.0 * 0.8838);
  EXPECT_LT(spine, 1.5 * 0.8838);
}

double largest_change_m(const WalkingBody& a, const WalkingBody& b) {
  double largest = 0.0;
  for (double phase = 0.0; phase < 1.0; phase += 0.01) {
    const WalkerBody p = a.cyclic(phase * a.gait().cycle_s), q = b.cyclic(phase * b.gait().cycle_s);
    for (std::size_t k = 0; k < body_part_count; ++k) largest = std::max(largest, core::norm(p[k] - q[k]));
  }
  return largest;
}

// The model's three ranges of speed meet at 0.5 and 1.3. At 1.3 one point of the hip's curve becomes two, between which
// the curve is no longer level: that moves the knee by up to 1.5 cm.
TEST(WalkingBody, ChangesGraduallyWithItsSpeed) {
  EXPECT_LT(largest_change_m(WalkingBody({1.8, 0.5 - 1e-7}), WalkingBody({1.8, 0.5 + 1e-7})), 1e-5);
  EXPECT_LT(largest_change_m(WalkingBody({1.8, 1.3 - 1e-7}), WalkingBody({1.8, 1.3 + 1e-7})), 0.015);
}

TEST(SampledCycle, IsTheBody) {
  const WalkingBody body({1.8, 1.0});
  const WalkerTracks tracks = sampled_cycle(body, 200);
  for (std::size_t k = 0; k < body_part_count; ++k)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto& knots = tracks[k][axis].knots;
      ASSERT_EQ(knots.size(), 201U);
      EXPECT_EQ(knots.front().y, knots.back().y);
      const core::Interpolator f(tracks[k][axis]);
      for (int i = 0; i < 1000; ++i) {
        const double t = body.gait().cycle_s * (i + 0.5) / 1000.0;
        const core::Vec3 p = body.cyclic(t)[k];
        EXPECT_NEAR(f.value(t), axis == 0 ? p.x : (axis == 1 ? p.y : p.z), 1.5e-4);
      }
    }
}

TEST(Walker, SaysWhatIsWrong) {
  EXPECT_EQ(fault_of(Walker{1.8, 1.0}), "");
  EXPECT_EQ(fault_of(Walker{0.0, 1.0}), "a person is 0.4 to 2.8 m tall, not 0 m");
  EXPECT_EQ(fault_of(Walker{180.0, 1.0}), "a person is 0.4 to 2.8 m tall, not 180 m");
  EXPECT_EQ(fault_of(Walker{2.8, 3.0}), "");
  EXPECT_EQ(fault_of(Walker{1.8, 0.0}), "the speed is not positive");
  const double toes_mps = WalkingBody(Walker{1.8, 3.0}).fastest_mps();
  EXPECT_GT(toes_mps, 2.5 * 3.0 * 0.491 * 1.8);
  EXPECT_LT(toes_mps, 6.0 * 3.0 * 0.491 * 1.8);
  EXPECT_EQ(
      fault_of(Walker{1.8, 3.1}),
      fmt::format("the speed of 2.74 m/s is above 3 leg lengths per second: that is running; at most 2.65 m/s for "
                  "a height of 1.8 m, with toes at up to {:.3g} m/s",
                  toes_mps));
  EXPECT_EQ(fault_of(Walker{1.8, std::numeric_limits<double>::quiet_NaN()}), "the speed is not positive");
}

TEST(BodyPart, HasItsOwnName) {
  std::set<std::string> names;
  for (std::size_t k = 0; k < body_part_count; ++k) names.insert(name_of(static_cast<BodyPart>(k)));
  EXPECT_EQ(names.size(), body_part_count);
  EXPECT_STREQ(name_of(BodyPart::left_knee), "left knee");
}

}  // namespace walker_test
}  // namespace sarsim::radar
