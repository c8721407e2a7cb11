#pragma once

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

}  // namespace sarsim::simulate
