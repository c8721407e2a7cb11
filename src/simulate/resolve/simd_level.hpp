#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace sarsim::simulate {

/// Instruction set that the fast kernels run on in this process: "avx512", "avx2", "sse4", "sse2", "neon" ...
[[nodiscard]] std::string simd_level();

/// Levels that this program and this processor have, best first.
[[nodiscard]] std::vector<std::string> simd_levels();

/// Restricts the fast kernels of this process to a level, for results that are the same bytes on different machines.
/// To be called before any kernel runs. False where the level is not to be had.
bool use_simd_level(std::string_view level);

/// Keeps the fast kernels of this process on a level while it lives, then sets back what was before; for comparing
/// levels. Nothing else may compute meanwhile.
class SimdLevelScope {
 public:
  /// @param level  one of `simd_levels`; another one changes nothing
  explicit SimdLevelScope(std::string_view level);
  SimdLevelScope(const SimdLevelScope&) = delete;
  SimdLevelScope& operator=(const SimdLevelScope&) = delete;
  ~SimdLevelScope();

 private:
  std::int64_t before_;
};

}  // namespace sarsim::simulate
