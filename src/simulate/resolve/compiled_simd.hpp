#pragma once

#include <string>
#include <vector>

namespace sarsim::simulate {

/// Instruction sets that the fast kernels were compiled for, best first, under the names of `simd_levels`, whatever
/// this processor has.
[[nodiscard]] std::vector<std::string> compiled_simd_levels();

/// Version of the Highway library that they were compiled with, such as "1.0.3".
[[nodiscard]] std::string simd_library_version();

}  // namespace sarsim::simulate
