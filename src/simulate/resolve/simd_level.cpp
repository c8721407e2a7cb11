#include "simulate/resolve/simd_level.hpp"

#include <array>
#include <bit>
#include <cstdint>

#include <hwy/targets.h>

namespace sarsim::simulate {

namespace {

struct Level {
  std::int64_t target;
  std::string_view name;
};

// Highway knows several flavours of AVX-512; users know one.
constexpr std::array<Level, 7> levels{{{HWY_AVX3_DL, "avx512"},
                                       {HWY_AVX3, "avx512"},
                                       {HWY_AVX2, "avx2"},
                                       {HWY_SSE4, "sse4"},
                                       {HWY_SSSE3, "ssse3"},
                                       {HWY_NEON, "neon"},
                                       {HWY_SVE, "sve"}}};

std::string_view name_of_target(std::int64_t target) {
  for (const Level& level : levels)
    if (level.target == target) return level.name;
  return "scalar";
}

// Targets that were compiled and that the processor has; the better, the lower its bit.
std::int64_t usable_targets() { return hwy::SupportedTargets() & HWY_TARGETS; }

}  // namespace

std::string simd_level() {
  const std::int64_t targets = usable_targets();
  return std::string(name_of_target(targets & -targets));
}

std::vector<std::string> simd_levels() {
  std::vector<std::string> names;
  for (std::int64_t rest = usable_targets(); rest != 0; rest &= rest - 1) {
    const std::string name(name_of_target(rest & -rest));
    if (names.empty() || names.back() != name) names.push_back(name);
  }
  return names;
}

bool use_simd_level(std::string_view level) {
  for (std::int64_t rest = usable_targets(); rest != 0; rest &= rest - 1) {
    const std::int64_t target = rest & -rest;
    if (name_of_target(target) != level) continue;
    // Not DisableTargets: in Highway 1.0, the next look at SupportedTargets sets the dispatch back to the best target.
    hwy::SetSupportedTargetsForTest(usable_targets() & ~(target - 1));
    return true;
  }
  return false;
}

SimdLevelScope::SimdLevelScope(std::string_view level) : before_(hwy::SupportedTargets()) { use_simd_level(level); }

SimdLevelScope::~SimdLevelScope() { hwy::SetSupportedTargetsForTest(before_); }

}  // namespace sarsim::simulate
