#pragma once

#include <gtest/gtest.h>

#include <cstdint>

#include <hwy/targets.h>

namespace sarsim::radar {

/// Runs `f` on every instruction set that this program and this processor have.
template <class F>
void at_every_simd_level(const F& f) {
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    SCOPED_TRACE(hwy::TargetName(target));
    hwy::SetSupportedTargetsForTest(target);
    f();
  }
  hwy::SetSupportedTargetsForTest(0);
}

}  // namespace sarsim::radar
