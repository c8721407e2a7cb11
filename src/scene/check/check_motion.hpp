#pragma once

#include <cstddef>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "scene/check/check_findings.hpp"
#include "scene/model/scene.hpp"

namespace sarsim::scene {

/// Checks the world itself: epoch, anchor, leap seconds.
void check_world(Findings& findings, const Scene& scene);

/// Most platforms of a chain in which each moves in the frame of the one before, or follows its path. A pose takes time
/// in proportion to them, and as many nested calls.
inline constexpr std::size_t longest_motion_chain = 64;

/// Leaders and parents of platforms, looked up once for all of them in time n log n: a scene may have thousands of
/// platforms mounted on each other.
class PlatformChains {
 public:
  /// @param scene  must outlive it
  explicit PlatformChains(const Scene& scene);

  /// The platform that a platform follows; `not_found` for none.
  [[nodiscard]] std::size_t leader(std::size_t platform) const { return leaders_.next[platform]; }
  /// Whether the chain of leaders, or of parents, of a platform is a loop.
  [[nodiscard]] bool leaders_loop(std::size_t platform) const { return leaders_.loops[platform] != 0; }
  [[nodiscard]] bool parents_loop(std::size_t platform) const { return parents_.loops[platform] != 0; }
  /// How many platforms carry this one, itself included, from the first that moves on: 0 at rest. Of leaders: how many
  /// follow each other up to this one. Of those on a circle no more than once round it.
  [[nodiscard]] std::size_t parent_level(std::size_t platform) const { return parents_.levels[platform]; }
  [[nodiscard]] std::size_t leader_level(std::size_t platform) const { return leaders_.levels[platform]; }
  /// How many platforms the longest chain through a platform has.
  [[nodiscard]] std::size_t longest_of_parents(std::size_t platform) const { return parents_.longest[platform]; }
  [[nodiscard]] std::size_t longest_of_leaders(std::size_t platform) const { return leaders_.longest[platform]; }
  /// Speed of the fastest target on a platform that turns, or on one that is mounted on it at rest.
  [[nodiscard]] double fastest_tip_mps(std::size_t platform, const core::Vec3& rate_rad_per_s) const;

 private:
  struct Links {
    std::vector<std::size_t> next;
    std::vector<char> loops;
    std::vector<std::size_t> levels;
    std::vector<std::size_t> longest;
  };

  void gather_targets();

  const Scene& scene_;
  Links leaders_;
  Links parents_;
  // By the exact names of the platforms.
  std::unordered_map<std::string_view, std::vector<std::size_t>> mounted_;
  std::unordered_map<std::string_view, std::vector<std::size_t>> targets_;
};

/// Checks what moves a platform beyond the script language: files, routes, leaders and parents, laws that need the
/// Earth. The findings must be about that platform.
void check_motion(Findings& findings, const Scene& scene, const PlatformChains& chains, std::size_t platform);

}  // namespace sarsim::scene
