#include "workflow/input/simd_choice.hpp"

#include "core/report/invalid_request.hpp"
#include "simulate/resolve/simd_level.hpp"

namespace sarsim::workflow {

void choose_simd(const std::string& level) {
  if (level.empty() || simulate::use_simd_level(level)) return;
  std::string levels;
  for (const std::string& known : simulate::simd_levels()) levels += (levels.empty() ? "" : ", ") + known;
  throw core::InvalidRequest("--simd: this processor has no '" + level + "'", "choose among " + levels);
}

}  // namespace sarsim::workflow
