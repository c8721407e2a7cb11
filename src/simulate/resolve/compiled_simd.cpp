#include "simulate/resolve/compiled_simd.hpp"

#include <cctype>
#include <cstdint>
#include <string_view>

#include <fmt/format.h>
#include <hwy/highway.h>

namespace sarsim::simulate {

namespace {

// Highway's AVX3 is what users know as AVX-512; what stands for a processor without SIMD is scalar here.
std::string user_name(std::string_view target) {
  if (target.starts_with("AVX3")) return "avx512";
  if (target.starts_with("EMU") || target == "SCALAR") return "scalar";
  std::string name(target.substr(0, target.find('_')));
  for (char& letter : name) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return name;
}

}  // namespace

std::vector<std::string> compiled_simd_levels() {
  std::vector<std::string> names;
  for (std::int64_t rest = HWY_TARGETS; rest != 0; rest &= rest - 1) {  // The better, the lower its bit.
    const std::string name = user_name(hwy::TargetName(rest & -rest));
    if (names.empty() || names.back() != name) names.push_back(name);
  }
  return names;
}

std::string simd_library_version() { return fmt::format("{}.{}.{}", HWY_MAJOR, HWY_MINOR, HWY_PATCH); }

}  // namespace sarsim::simulate
