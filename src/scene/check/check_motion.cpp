#include "scene/check/check_motion.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "radar/earth/earth_frame.hpp"
#include "scene/check/check_values.hpp"
#include "scene/model/orbit.hpp"
#include "scene/model/read_path.hpp"
#include "scene/model/route.hpp"
#include "scene/model/scene_index.hpp"
#include "scene/model/world_frame.hpp"

namespace sarsim::scene {

namespace {

// Nothing flies lower; the lowest land is 430 m below the sea.
constexpr double lowest_height_m = -500.0;

core::Vec3 turning_rate(const Platform& platform) {
  const auto& rate = platform.rotation_rate;
  return {rate[0].rad(), rate[1].rad(), rate[2].rad()};
}

// The platform that each one names; `not_found` for none.
std::vector<std::size_t> links_of(const Scene& scene, SceneIndex& names, std::string Platform::*name) {
  std::vector<std::size_t> next;
  next.reserve(scene.platforms.size());
  for (const Platform& platform : scene.platforms)
    next.push_back((platform.*name).empty() ? not_found : names.platform(platform.*name));
  return next;
}

// Which of them lie on a circle: each link is followed once.
std::vector<char> loops_of(const std::vector<std::size_t>& next) {
  constexpr std::size_t nobody = not_found;
  std::vector<char> loops(next.size(), 0);
  std::vector<std::size_t> met_by(next.size(), nobody);
  for (std::size_t start = 0; start < next.size(); ++start) {
    std::size_t at = start;
    while (at != not_found && met_by[at] == nobody) {
      met_by[at] = start;
      at = next[at];
    }
    if (at == not_found || met_by[at] != start) continue;
    for (std::size_t on = at; loops[on] == 0; on = next[on]) loops[on] = 1;
  }
  return loops;
}

// Whether it may move in the frame of its parent.
bool moves(const Platform& platform) {
  const bool turns = platform.rotation_kind != Platform::Rotation::constant ||
                     core::norm(turning_rate(platform)) != 0.0 ||
                     std::ranges::any_of(platform.rotation_stddev, [](core::Angle a) { return a.rad() != 0.0; }) ||
                     platform.rotation_error != Platform::MotionError::gaussian;
  const bool travels = platform.path != Platform::Path::stationary || core::norm(platform.position_stddev_m) != 0.0 ||
                       platform.position_error != Platform::MotionError::gaussian;
  return turns || travels || !platform.oscillations.empty() || platform.waves != Platform::Waves::none;
}

// The place of each platform in its chain: one more than that of the next one, from the first that counts on. Links are
// followed once, and without recursion, because a chain may be of any length.
template <class Counts>
std::vector<std::size_t> levels_of(const std::vector<std::size_t>& next, const Counts& counts) {
  constexpr std::size_t open = not_found;
  std::vector<std::size_t> levels(next.size(), open);
  std::vector<std::size_t> chain;
  for (std::size_t start = 0; start < next.size(); ++start) {
    std::size_t at = start;
    for (; at != not_found && levels[at] == open; at = next[at]) {
      levels[at] = 0;  // ends a circle
      chain.push_back(at);
    }
    std::size_t level = at == not_found ? 0 : levels[at];
    for (; !chain.empty(); chain.pop_back()) {
      if (level > 0 || counts(chain.back())) ++level;
      levels[chain.back()] = level;
    }
  }
  return levels;
}

// The highest level among those that lead to a platform, itself included.
std::vector<std::size_t> highest_levels(const std::vector<std::size_t>& next, const std::vector<std::size_t>& levels) {
  std::vector<std::size_t> order(next.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, std::ranges::greater(), [&](std::size_t at) { return levels[at]; });
  std::vector<std::size_t> highest = levels;
  for (const std::size_t at : order)
    if (next[at] != not_found) highest[next[at]] = std::max(highest[next[at]], highest[at]);
  return highest;
}

void check_epoch(Findings& findings, const Scene& scene) {
  const radar::InstantReading epoch = epoch_of(scene.world);
  if (!epoch.failure.empty())
    return findings.error("epoch", {.id = "epoch.not-a-time",
                                    .message = "the epoch is not a time",
                                    .found = scene.world.epoch,
                                    .expected = "UTC as 2024-04-01T22:59:42Z",
                                    .hint = epoch.failure});
  if (!epoch.instant) return;
  const radar::TimeSpan needed = needed_times(scene);
  const radar::Instant first = radar::later(*epoch.instant, std::min(needed.first_s, 0.0));
  const radar::Instant last = radar::later(*epoch.instant, std::max(needed.last_s, 0.0));
  if (radar::leap_second_between(first, last))
    findings.error("epoch", {.id = "epoch.leap-second",
                             .message = "a leap second lies within the times of the scene",
                             .found = fmt::format("{} to {}", radar::format_instant(first, radar::TimeScale::utc, 3),
                                                  radar::format_instant(last, radar::TimeScale::utc, 3)),
                             .expected = "recordings before or behind it",
                             .hint = "UTC counts no even seconds there."});
}

void check_anchor(Findings& findings, const World& world) {
  constexpr double pole_deg = 89.999;
  if (world.frame == World::Frame::earth && std::abs(world.latitude.deg()) > pole_deg)
    findings.warning(Consequence::surprise, "latitude",
                     {.id = "anchor.at-pole",
                      .message = "the anchor is at a pole, where east and north follow from its longitude",
                      .found = value_text(world.latitude.deg(), "deg"),
                      .expected = "a latitude within +-89.999 deg",
                      .hint = "Move the anchor into the scene."});
}

Finding needs_earth(std::string_view what) {
  return {.id = "world.needs-earth",
          .message = fmt::format("{} needs the Earth, but the world is flat", what),
          .expected = "[world] with frame = \"earth\" and an anchor"};
}

void check_laws(Findings& findings, const World& world, const Platform& platform) {
  const bool flat = world.frame == World::Frame::flat;
  const bool computed = platform.path == Platform::Path::orbit || platform.path == Platform::Path::state;
  if (flat && computed) findings.error("path", needs_earth("an orbit"));
  if (flat && platform.rotation_kind == Platform::Rotation::zero_doppler)
    findings.error("rotation_kind", needs_earth("zero-Doppler steering"));
  if (flat && platform.rotation_kind == Platform::Rotation::nadir)
    findings.error("rotation_kind", needs_earth("pointing to the nadir"));
  const bool follows = platform.rotation_kind == Platform::Rotation::coordinated ||
                       platform.rotation_kind == Platform::Rotation::zero_doppler;
  if (follows && platform.path == Platform::Path::stationary)
    findings.error("rotation_kind", {.id = "attitude.no-path",
                                     .message = "the attitude follows a path, but the platform stays where it is",
                                     .expected = "a platform that moves, or a fixed rotation"});
  const bool in_parent = !platform.parent.empty() && platform.parent != "Earth";
  if (in_parent && is_orbit(platform.path))
    findings.error("parent", {.id = "orbit.with-parent",
                              .message = "an orbit is a path in the world, not in the frame of a parent",
                              .found = platform.parent,
                              .expected = "no parent"});
}

void check_files(Findings& findings, const Platform& platform) {
  const auto missing = [&](std::string_view field, std::string_view what, std::string_view example) {
    findings.error(field, {.id = "motion-file.none",
                           .message = fmt::format("the {} has no file", what),
                           .expected = fmt::format("file = \"{}\"", example)});
  };
  if (platform.path == Platform::Path::ephemeris && platform.ephemeris_file.empty())
    missing("ephemeris_file", "path", "S1A.EOF");
  if (platform.rotation_kind == Platform::Rotation::quaternions && platform.attitude_file.empty())
    missing("attitude_file", "attitude", "S1A.aem");
  const auto not_read = [&](std::string_view field, const std::string& file) {
    findings.error(field,
                   {.id = "motion-file.unread", .message = "the motion of the platform is not read", .found = file});
  };
  const bool from_file = platform.path == Platform::Path::ephemeris;
  const bool named = !from_file || !platform.ephemeris_file.empty();
  if (is_orbit(platform.path) && named && !platform.read_path)
    not_read(from_file ? "ephemeris_file" : "path", from_file ? platform.ephemeris_file : std::string());
  if (platform.rotation_kind == Platform::Rotation::quaternions && !platform.attitude_file.empty() &&
      !platform.read_attitude)
    not_read("attitude_file", platform.attitude_file);
}

// What a leg needs to be flown, and is 0; empty where nothing.
std::string_view lack_of(const Leg& leg) {
  switch (leg.kind) {
    case Leg::Kind::turn: return leg.angle.deg() == 0.0 ? "an angle" : "";
    case Leg::Kind::climb:
      return leg.duration_s == 0.0 ? "a duration" : leg.rate_mps == 0.0 ? "a rate" : std::string_view();
    case Leg::Kind::climb_to: return leg.rate_mps == 0.0 ? "a rate" : "";
    case Leg::Kind::hold:
    case Leg::Kind::circle: return leg.duration_s == 0.0 ? "a duration" : "";
    case Leg::Kind::straight: return leg.duration_s == 0.0 && leg.length_m == 0.0 ? "a length or a duration" : "";
    case Leg::Kind::turn_to: break;
  }
  const bool tight = leg.bank.deg() != 0.0 || leg.radius_m != 0.0;
  return tight ? "" : "a bank or a radius";
}

// The field of one of a list.
std::string entry_of(std::string_view list, std::size_t entry) { return fmt::format("{}[{}]", list, entry); }

// Whether all legs say what they need to be flown.
bool check_legs(Findings& findings, const Platform& platform) {
  bool sound = true;
  if (platform.legs.empty())
    findings.error("legs", {.id = "legs.none",
                            .message = "the path has no legs",
                            .expected = "legs = [{ leg = \"straight\", length = \"10 km\" }, ...]"});
  for (std::size_t i = 0; i < platform.legs.size(); ++i) {
    const std::string_view lack = lack_of(platform.legs[i]);
    if (lack.empty()) continue;
    findings.error(entry_of("legs", i), {.id = "legs.missing-value",
                                         .message = fmt::format("leg {}: {} is missing, or 0", i + 1, lack),
                                         .expected = fmt::format("{} that is not 0", lack)});
    sound = false;
  }
  return sound && !platform.legs.empty();
}

void warn_slow_climb(Findings& findings, const Platform& platform, const radar::SlowClimb& slow) {
  const Leg& leg = platform.legs[slow.leg];
  findings.warning(
      Consequence::surprise, entry_of("legs", slow.leg),
      {.id = "legs.too-short",
       .message = fmt::format("leg {} is too short to reach its rate of climb with that rounding", slow.leg + 1),
       .found = fmt::format("{} at most", value_text(slow.reached_mps, "m/s")),
       .expected = value_text(std::abs(leg.rate_mps), "m/s"),
       .hint = fmt::format("A rounding of {} or more reaches it.", value_text(slow.needed_rounding_mps2, "m/s2"))});
}

void check_route(Findings& findings, const Platform& platform) {
  const bool legs = platform.path == Platform::Path::legs;
  if (!legs && platform.path != Platform::Path::waypoints) return;
  if (platform.speed_mps == 0.0)
    return findings.error(
        "speed_mps", {.id = "path.no-speed", .message = "the path has no speed", .expected = "speed = \"100 m/s\""});
  if (legs && !check_legs(findings, platform)) return;
  const radar::PathResult made = route_of(platform);
  const std::string list = legs ? "legs" : "waypoints";
  if (!made.fault.empty())
    return findings.error(made.at ? entry_of(list, *made.at) : list, {.id = "path.impossible", .message = made.fault});
  for (const radar::SlowClimb& slow : made.slow_climbs) warn_slow_climb(findings, platform, slow);
  constexpr double noticed_step_mps = 1e-3;  // A change of the Doppler frequency of 0.07 Hz at 3 cm.
  if (made.path.largest_step_mps() > noticed_step_mps)
    findings.warning(Consequence::false_signal, list,
                     {.id = "path.velocity-steps",
                      .message = "the velocity of the path steps",
                      .found = fmt::format("by up to {}", value_text(made.path.largest_step_mps(), "m/s")),
                      .expected = "a path that is rounded off",
                      .hint = legs ? "Give climbs a rounding." : "Give an acceleration, or points of one height."});
}

void report_loop(Findings& findings, std::string_view field, const std::string& name) {
  findings.error(field, {.id = "platforms.loop",
                         .message = fmt::format("the {}s of the platform come back to itself", field),
                         .found = name,
                         .expected = "another platform"});
}

// Told once for a chain: of the first platform beyond the limit.
void check_chain(Findings& findings, std::string_view field, std::size_t level, std::size_t longest) {
  if (level != longest_motion_chain + 1) return;
  findings.error(field,
                 {.id = "platforms.long-chain",
                  .message = fmt::format("the chain of {}s is too long", field),
                  .found = fmt::format("platform {} of a chain of {}", level, longest),
                  .expected = fmt::format("up to {} platforms that {}", longest_motion_chain,
                                          field == "parent" ? "move, each on the one before" : "follow each other"),
                  .hint = field == "parent" ? "Mount the platform on one nearer to the world."
                                            : "Follow one nearer to the first."});
}

void check_leader(Findings& findings, const Scene& scene, const PlatformChains& chains, std::size_t index) {
  const Platform& platform = scene.platforms[index];
  if (platform.path != Platform::Path::relative) return;
  if (platform.leader.empty())
    return findings.error("leader", {.id = "leader.none",
                                     .message = "a relative path has no leader",
                                     .expected = "leader = the name of a platform"});
  if (chains.leaders_loop(index)) report_loop(findings, "leader", platform.leader);
  check_chain(findings, "leader", chains.leader_level(index), chains.longest_of_leaders(index));
  const std::size_t leader = chains.leader(index);
  const auto parent_of = [](const Platform& of) { return of.parent == "Earth" ? std::string() : of.parent; };
  if (leader == not_found || parent_of(scene.platforms[leader]) == parent_of(platform)) return;
  const std::string parent = parent_of(scene.platforms[leader]);
  findings.warning(
      Consequence::surprise, "leader",
      {.id = "leader.other-parent",
       .message = "the platform has another parent than its leader, whose path it follows in the frame of its own",
       .found = parent.empty() ? "a leader in the world" : fmt::format("a leader mounted on {}", parent),
       .expected = "one parent for both",
       .hint = parent.empty() ? "Remove the parent." : fmt::format("Write parent = \"{}\".", parent)});
}

// A rate in turns a minute that was taken for something else shows in the speed of the tips.
void check_tips(Findings& findings, const PlatformChains& chains, const Platform& platform, std::size_t index) {
  constexpr double fastest_mps = 1000.0;
  const core::Vec3 rate_rad_per_s = turning_rate(platform);
  if (core::norm(rate_rad_per_s) == 0.0) return;
  const double tip_mps = chains.fastest_tip_mps(index, rate_rad_per_s);
  if (!(tip_mps > fastest_mps)) return;
  findings.warning(Consequence::surprise, "rotation_rate",
                   {.id = "rotation.too-fast",
                    .message = "the rotation rate of a target exceeds that of any rotor or wheel",
                    .found = fmt::format("{:.6g} m/s", tip_mps),
                    .expected = fmt::format("up to {:g} m/s", fastest_mps),
                    .hint = "300 turns a minute are 1800 deg/s."});
}

void check_height(Findings& findings, const Scene& scene, const Platform& platform) {
  if (!platform.read_path || scene.world.frame != World::Frame::earth) return;
  const radar::EarthFrame earth(anchor_of(scene.world));
  const radar::TimeSpan times = needed_times(scene);
  constexpr double looks = 200.0;
  for (double look = 0.0; look <= looks; look += 1.0) {
    const double time_s = times.first_s + look / looks * (times.last_s - times.first_s);
    const auto motion = platform.read_path->states->at(time_s);
    if (!motion) continue;
    const double height_m = earth.geodetic_of(motion->position_m).height_m;
    if (height_m >= lowest_height_m) continue;
    return findings.error("path", {.id = "path.through-earth",
                                   .message = "the path goes through the Earth",
                                   .found = fmt::format("{} at {}", value_text(height_m, "m"), value_text(time_s, "s")),
                                   .expected = "a height above the ellipsoid",
                                   .hint = "Positions of files are in km or m as their formats say."});
  }
}

}  // namespace

void check_world(Findings& findings, const Scene& scene) {
  check_values(findings, scene.world);
  check_epoch(findings, scene);
  check_anchor(findings, scene.world);
  if (scene.world.frame == World::Frame::earth && scene.options.profile == Profile::classic)
    findings.error("frame", {.id = "classic.no-earth",
                             .message = "the classic profile knows no Earth",
                             .found = "frame earth",
                             .expected = "the physical profile, or a flat world"});
}

PlatformChains::PlatformChains(const Scene& scene) : scene_(scene) {
  SceneIndex names(scene);
  leaders_ = {links_of(scene, names, &Platform::leader), {}, {}, {}};
  for (std::size_t i = 0; i < leaders_.next.size(); ++i)
    if (scene.platforms[i].path != Platform::Path::relative) leaders_.next[i] = not_found;
  leaders_.loops = loops_of(leaders_.next);
  leaders_.levels = levels_of(leaders_.next, [](std::size_t) { return true; });
  leaders_.longest = highest_levels(leaders_.next, leaders_.levels);
  parents_ = {links_of(scene, names, &Platform::parent), {}, {}, {}};
  parents_.loops = loops_of(parents_.next);
  parents_.levels = levels_of(parents_.next, [&](std::size_t i) { return moves(scene.platforms[i]); });
  parents_.longest = highest_levels(parents_.next, parents_.levels);
  const auto turns = [](const Platform& platform) { return core::norm(turning_rate(platform)) != 0.0; };
  if (std::ranges::any_of(scene.platforms, turns)) gather_targets();
}

void PlatformChains::gather_targets() {
  for (std::size_t i = 0; i < scene_.platforms.size(); ++i) {
    const Platform& platform = scene_.platforms[i];
    targets_.try_emplace(platform.name);
    if (!platform.parent.empty() && platform.path == Platform::Path::stationary) mounted_[platform.parent].push_back(i);
  }
  for (std::size_t i = 0; i < scene_.targets.size(); ++i)
    if (const auto carrier = targets_.find(*scene_.targets[i].platform); carrier != targets_.end())
      carrier->second.push_back(i);
}

double PlatformChains::fastest_tip_mps(std::size_t platform, const core::Vec3& rate_rad_per_s) const {
  double fastest_mps = 0.0;
  const auto look_at = [&](const std::string& carrier, const core::Vec3& mount_m) {
    const auto carried = targets_.find(carrier);
    if (carried == targets_.end()) return;
    for (const std::size_t target : carried->second)
      fastest_mps =
          std::max(fastest_mps, core::norm(core::cross(rate_rad_per_s, mount_m + scene_.targets[target].position_m)));
  };
  const std::string& name = scene_.platforms[platform].name;
  look_at(name, {});
  if (const auto mounted = mounted_.find(name); mounted != mounted_.end())
    for (const std::size_t other : mounted->second)
      if (scene_.platforms[other].name != name)
        look_at(scene_.platforms[other].name, scene_.platforms[other].position_m);
  return fastest_mps;
}

void check_motion(Findings& findings, const Scene& scene, const PlatformChains& chains, std::size_t index) {
  const Platform& platform = scene.platforms[index];
  check_laws(findings, scene.world, platform);
  // Without a sound epoch, which is said, nothing is read.
  if (epoch_of(scene.world).failure.empty()) check_files(findings, platform);
  check_route(findings, platform);
  check_leader(findings, scene, chains, index);
  if (chains.parents_loop(index)) report_loop(findings, "parent", platform.parent);
  check_chain(findings, "parent", chains.parent_level(index), chains.longest_of_parents(index));
  check_height(findings, scene, platform);
  check_tips(findings, chains, platform, index);
}

}  // namespace sarsim::scene
