#pragma once

#include <cstddef>
#include <vector>

#include "echo/sight.hpp"
#include "simulate/pulse_geometry.hpp"
#include "simulate/resolved.hpp"

namespace sarsim {

/// The scatterers of a scene as flat arrays, in runs that share a platform and a law; what SIMD geometry works on.
struct PointGroups {
  struct Run {
    std::uint32_t platform = 0;
    std::size_t first_target = 0;  ///< Of targets; a sheet's number for sheets.
    std::size_t count = 0;
    bool plain = true;  ///< In `points`; otherwise each target is looked at by itself.
    bool sheet = false;
    PointArrays points;
  };
  std::vector<Run> runs;
};

/// Groups the targets, in order, then the surfaces. Targets with random deviations or a user-defined curve are not
/// plain.
[[nodiscard]] PointGroups group_points(const ResolvedScene& scene);

/// All echoes of the current pulse of `geometry`, as `PulseGeometry::echoes` gives them, to rounding, but in SIMD where
/// the antenna allows it (isotropic, or sin(x)/x measured in the antenna's frame). Replaces `echoes`.
void fast_echoes(const PointGroups& groups, const ResolvedScene& scene, const ResolvedRadar& radar,
                 const PulseGeometry& geometry, EchoBatch& echoes);

}  // namespace sarsim
