#pragma once

#include "random_scenes/function_maker.hpp"

namespace sarsim::test {

/// What the objects of a scene have in common, so that radars see targets.
struct Layout {
  double range_m = 0.0;   ///< From the radars to the origin, about which the targets stand.
  double spread_m = 0.0;  ///< How far from it.
  double sample_rate_hz = 0.0;
  double window_m = 0.0;    ///< Length of the slant range windows.
  double interval_s = 0.0;  ///< About that between pulses.
  double start_s = 0.0;     ///< Of what is recorded.
  double duration_s = 0.0;
  bool stepped = false;  ///< For range profiles.
  scene::Profile profile = scene::Profile::physical;
};

/// A radar `position_m` away from the targets' middle, with every alternative of every field.
[[nodiscard]] scene::Radar random_radar(Chance& chance, FunctionMaker& functions, const Layout& layout,
                                        const core::Vec3& position_m);

}  // namespace sarsim::test
