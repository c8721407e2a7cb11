#include "radar/motion/walker.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/maths/constants.hpp"
#include "core/text/number_text.hpp"

namespace sarsim::radar {

namespace {

// Lengths of bones as shares of the height.
constexpr double head_share = 0.130;
constexpr double half_shoulder_share = 0.259 / 2.0;
constexpr double trunk_share = 0.288;
constexpr double half_hip_share = 0.191 / 2.0;
constexpr double thigh_share = 0.245;
constexpr double shank_share = 0.246;
constexpr double foot_share = 0.143;
constexpr double ankle_height_share = 0.039;
constexpr double upper_arm_share = 0.188;
constexpr double forearm_share = 0.152;

constexpr double slow = 0.5;  // relative speeds at which the model's curves change
constexpr double fast = 1.3;

// How far a relative speed is from `fast` to 3; below 0 none.
double haste(double rv) { return std::max(0.0, (rv - fast) / 1.7); }

double sine_of_turns(double turns) { return std::sin(2.0 * core::pi * turns); }
double cosine_of_turns(double turns) { return std::cos(2.0 * core::pi * turns); }

// Amplitudes that grow with a parabola and stay from `slow` on.
double parabola(double rv, double factor) {
  const double v = std::min(rv, slow);
  return factor * v * (1.0 - v);
}

double share_of_support(double rv) { return 0.752 - 0.143 * std::sqrt(rv) / 1.346; }

GaitCurve hip_curve(double rv) {
  const double v = std::min(rv, slow), q = haste(rv);
  return GaitCurve({{-0.1 + 0.2 * q, 50.0 * v + 5.0 * q}, {0.5, -30.0 * v}, {0.9, 50.0 * v + 6.0 * q}});
}

GaitCurve knee_curve(double rv) {
  const double v = std::min(rv, slow), q = haste(rv);
  return GaitCurve({{0.17 - 0.05 * q, 3.0 + 22.0 * q},
                    {0.4, 3.0},
                    {0.75 - 0.05 * q, 140.0 * v - 5.0 * q},
                    {1.0 - 0.03 * q, 3.0 + 3.0 * q}});
}

GaitCurve ankle_curve(double rv) {
  const double v = std::min(rv, slow), q = haste(rv);
  return GaitCurve({{0.0, -3.0 + 5.0 * q},
                    {0.08, -30.0 * v - 3.0 + 4.0 * q},
                    {0.5 - 0.1 * q, 22.0 * v - 3.0 - 3.0 * q},
                    {share_of_support(rv), -34.0 * v - 3.0 - 8.0 * q},
                    {0.85, -3.0 + 5.0 * q}});
}

GaitCurve elbow_curve(double rv) {
  const double v = std::min(rv, slow), q = haste(rv);
  const double p = std::clamp((rv - slow) / (fast - slow), 0.0, 1.0);
  return GaitCurve({{0.05, 6.0 * v + 3.0 + 8.0 * p - 6.0 * q},
                    {0.5 + 0.01 * p + 0.04 * q, 34.0 * v + 3.0 + 24.0 * p + 26.0 * q},
                    {0.9 - 0.1 * q, 10.0 * v + 3.0 + 9.0 * p - 6.0 * q}});
}

GaitCurve thorax_curve(double rv) {
  return GaitCurve({{0.1, rv * 4.0 / 3.0}, {0.4, -rv * 4.5 / 3.0}, {0.6, -rv * 4.0 / 3.0}, {0.9, rv * 4.5 / 3.0}});
}

double shoulder_deg(double rv, double phase) {
  const double swing = 9.88 * rv;
  return 3.0 - 0.5 * swing - swing * cosine_of_turns(phase);
}

// Lowering of the pelvis on the side of the swinging leg: four half waves; positive: left side up.
double pelvis_roll_deg(double rv, double phase) {
  const double half = phase < 0.5 ? phase : phase - 0.5;
  const double fall =
      half < 0.15 ? 1.0 - cosine_of_turns(half * 10.0 / 3.0) : 1.0 + cosine_of_turns((half - 0.15) * 10.0 / 7.0);
  return (phase < 0.5 ? -1.66 : 1.66) * rv * fall;
}

// A vector of the x-z plane turned by an angle that lifts what points ahead and swings ahead what hangs.
core::Vec3 swung(double ahead, double up, double angle_deg) {
  const double s = std::sin(angle_deg * core::rad_per_deg), c = std::cos(angle_deg * core::rad_per_deg);
  return {ahead * c - up * s, 0.0, ahead * s + up * c};
}

// A vector to the left, turned counterclockwise about z and then rolled left side up.
core::Vec3 leftwards(double length, double yaw_deg, double roll_deg) {
  const double yaw = yaw_deg * core::rad_per_deg, roll = roll_deg * core::rad_per_deg;
  return {-length * std::sin(yaw) * std::cos(roll), length * std::cos(yaw) * std::cos(roll), length * std::sin(roll)};
}

core::Vec3& part_of(WalkerBody& body, BodyPart part) { return body[static_cast<std::size_t>(part)]; }

// The part on the left or on the right; the right one follows the left one.
core::Vec3& part_of(WalkerBody& body, BodyPart left_part, bool left) {
  return body[static_cast<std::size_t>(left_part) + (left ? 0 : 1)];
}

double fraction_of(double x) { return x - std::floor(x); }

}  // namespace

const char* name_of(BodyPart part) {
  constexpr std::array<const char*, body_part_count> names{
      "head",       "neck",       "left shoulder", "right shoulder", "left elbow", "right elbow",
      "left hand",  "right hand", "spine",         "left hip",       "right hip",  "left knee",
      "right knee", "left ankle", "right ankle",   "left toe",       "right toe"};
  return names[static_cast<std::size_t>(part)];
}

Gait gait_of(const Walker& walker) {
  Gait gait;
  gait.leg_m = (thigh_share + shank_share) * walker.height_m;
  gait.speed_mps = walker.relative_speed * gait.leg_m;
  gait.cycle_s = 1.346 / std::sqrt(walker.relative_speed);
  gait.support_s = 0.752 * gait.cycle_s - 0.143;
  return gait;
}

Walker walker_at(double height_m, double speed_mps) {
  return {height_m, speed_mps / ((thigh_share + shank_share) * height_m)};
}

std::string fault_of(const Walker& walker) {
  constexpr double smallest_m = 0.4, largest_m = 2.8;
  constexpr double fastest = 3.0;
  if (!(walker.height_m >= smallest_m && walker.height_m <= largest_m))
    return "a person is " + core::format_number(smallest_m) + " to " + core::format_number(largest_m) +
           " m tall, not " + core::format_number(walker.height_m) + " m";
  if (!(walker.relative_speed > 0.0)) return "the speed is not positive";
  if (walker.relative_speed <= fastest) return {};
  const WalkingBody body({walker.height_m, fastest});
  return fmt::format(
      "the speed of {:.3g} m/s is above 3 leg lengths per second: that is running; at most {:.3g} m/s for a height of "
      "{:.3g} m, with toes at up to {:.3g} m/s",
      gait_of(walker).speed_mps, body.gait().speed_mps, walker.height_m, body.fastest_mps());
}

WalkingBody::WalkingBody(const Walker& walker)
    : walker_(walker),
      gait_(gait_of(walker)),
      hip_(hip_curve(walker.relative_speed)),
      knee_(knee_curve(walker.relative_speed)),
      ankle_(ankle_curve(walker.relative_speed)),
      elbow_(elbow_curve(walker.relative_speed)),
      thorax_(thorax_curve(walker.relative_speed)) {
  constexpr int looks = 1000;
  double lowest = 0.0;
  for (int i = 0; i < looks; ++i) {
    WalkerBody body = at_phase(static_cast<double>(i) / looks);
    for (const BodyPart part : {BodyPart::left_toe, BodyPart::right_toe})
      lowest = std::min(lowest, part_of(body, part).z);
    for (const BodyPart part : {BodyPart::left_ankle, BodyPart::right_ankle})
      lowest = std::min(lowest, part_of(body, part).z - ankle_height_share * walker.height_m);
  }
  floor_m_ = -lowest;
}

WalkerBody WalkingBody::at(double time_s) const {
  WalkerBody body = cyclic(time_s);
  for (core::Vec3& part : body) part.x += gait_.speed_mps * time_s;
  return body;
}

double WalkingBody::fastest_mps() const {
  constexpr int looks = 1000;
  const double step_s = gait_.cycle_s / looks;
  double fastest_mps = 0.0;
  WalkerBody before = at(0.0);
  for (int i = 1; i <= looks; ++i) {
    const WalkerBody now = at(i * step_s);
    for (std::size_t part = 0; part < body_part_count; ++part)
      fastest_mps = std::max(fastest_mps, core::norm(now[part] - before[part]) / step_s);
    before = now;
  }
  return fastest_mps;
}

WalkerBody WalkingBody::cyclic(double time_s) const { return at_phase(fraction_of(time_s / gait_.cycle_s)); }

WalkerBody WalkingBody::at_phase(double phase) const {
  const double rv = walker_.relative_speed, h = walker_.height_m;
  const double ahead = -parabola(rv, 0.084) * sine_of_turns(2.0 * phase + 2.0 * (0.625 - share_of_support(rv)));
  const double aside = -parabola(rv, 0.128) * sine_of_turns(phase - 0.1);
  const double up = 0.015 * rv * (sine_of_turns(2.0 * phase - 0.35) - 1.0);
  const double lean_deg = parabola(rv, 8.0) * (sine_of_turns(2.0 * phase - 0.1) - 1.0);
  WalkerBody body;
  const core::Vec3 spine{ahead, aside, floor_m_ + up};
  const core::Vec3 neck = spine + swung(0.0, trunk_share * h, lean_deg);
  const core::Vec3 hip = leftwards(half_hip_share * h, 4.0 * rv * cosine_of_turns(phase), pelvis_roll_deg(rv, phase));
  const core::Vec3 shoulder = leftwards(half_shoulder_share * h, -thorax_.at(phase), 0.0);
  part_of(body, BodyPart::spine) = spine;
  part_of(body, BodyPart::neck) = neck;
  part_of(body, BodyPart::head) = neck + core::Vec3{0.0, 0.0, head_share * h};
  for (const bool left : {true, false}) {
    part_of(body, BodyPart::left_hip, left) = left ? spine + hip : spine - hip;
    part_of(body, BodyPart::left_shoulder, left) = left ? neck + shoulder : neck - shoulder;
    add_leg(body, fraction_of(left ? phase + 0.5 : phase), left);
    add_arm(body, fraction_of(left ? phase + 0.5 : phase), left);
  }
  return body;
}

void WalkingBody::add_leg(WalkerBody& body, double phase, bool left) const {
  const double h = walker_.height_m;
  const double thigh_deg = hip_.at(phase);
  const double shank_deg = thigh_deg - knee_.at(phase);
  const double foot_deg = shank_deg + ankle_.at(phase);
  const core::Vec3 knee = part_of(body, BodyPart::left_hip, left) + swung(0.0, -thigh_share * h, thigh_deg);
  const core::Vec3 ankle = knee + swung(0.0, -shank_share * h, shank_deg);
  part_of(body, BodyPart::left_knee, left) = knee;
  part_of(body, BodyPart::left_ankle, left) = ankle;
  part_of(body, BodyPart::left_toe, left) = ankle + swung(foot_share * h, -ankle_height_share * h, foot_deg);
}

void WalkingBody::add_arm(WalkerBody& body, double phase, bool left) const {
  const double h = walker_.height_m;
  const double upper_deg = shoulder_deg(walker_.relative_speed, phase);
  const core::Vec3 elbow = part_of(body, BodyPart::left_shoulder, left) + swung(0.0, -upper_arm_share * h, upper_deg);
  part_of(body, BodyPart::left_elbow, left) = elbow;
  part_of(body, BodyPart::left_hand, left) = elbow + swung(0.0, -forearm_share * h, upper_deg + elbow_.at(phase));
}

WalkerTracks sampled_cycle(const WalkingBody& body, int steps) {
  WalkerTracks tracks;
  for (auto& track : tracks)
    for (core::SampledFunction& function : track) function.method = core::Interpolation::cubic;
  for (int i = 0; i <= steps; ++i) {
    const double time = body.gait().cycle_s * i / steps;
    const WalkerBody parts = body.cyclic(i == steps ? 0.0 : time);
    for (std::size_t k = 0; k < body_part_count; ++k) {
      const double xyz[] = {parts[k].x, parts[k].y, parts[k].z};
      for (std::size_t axis = 0; axis < 3; ++axis) tracks[k][axis].knots.push_back({time, xyz[axis]});
    }
  }
  return tracks;
}

}  // namespace sarsim::radar
