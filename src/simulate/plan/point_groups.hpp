#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/task/stop.hpp"
#include "radar/echo/view_geometry.hpp"
#include "simulate/plan/pulse_geometry.hpp"
#include "simulate/resolve/resolved.hpp"

namespace sarsim::simulate {

/// The scatterers of a scene as flat arrays that share a platform, a law and the kinds of random deviations, and the
/// antennas of a radar; what SIMD geometry works on.
struct PointGroups {
  /// Points of one platform and one law.
  struct Group {
    std::uint32_t platform = 0;
    std::shared_ptr<const radar::PointArrays> points;  ///< Those of a cloud itself, where nothing has to be added.
    std::size_t first = 0;                             ///< Points of the groups before.
  };
  std::vector<Group> groups;
  radar::CurveTables reflectivity;
  radar::AntennaView antenna;
  std::size_t count = 0;  ///< Points of all groups.

  /// Whether all user-defined curves are finite; otherwise `fast_echoes` looks at every target by itself.
  [[nodiscard]] bool sound() const { return reflectivity.sound && antenna.curves.sound; }
};

/// Groups the targets and the points of the surfaces: groups in the order of their first points, the points of a group
/// in the order of the scene, targets before clouds before surfaces; an isotropic cloud without random deviations is a
/// group by itself, which shares the cloud's arrays. User-defined curves are tabulated so that all of them together
/// put an error of less than an eighth of the scene's tolerance on any amplitude, relative to that amplitude.
/// @param stop  asked now and then; a requested stop throws Interrupted
[[nodiscard]] PointGroups group_points(const ResolvedScene& scene, const Link& radar,
                                       const core::StopFlag* stop = nullptr);

/// Points whose echoes are worked on at a time: what they take stays in the caches, and no memory grows with the scene.
inline constexpr std::size_t points_at_once = 32768;

/// The echoes of a run of points, counted through the groups, of the current pulse of `geometry`, in SIMD. Replaces
/// `echoes`; allocates nothing once these have had their size.
/// @return whether all are certain to be possible; where not, `PulseGeometry::echoes` has the word
[[nodiscard]] bool certain_echoes(const PointGroups& groups, const PulseGeometry& geometry, const radar::PointSpan& run,
                                  radar::EchoBatch& echoes);

/// All echoes of the current pulse of `geometry` in SIMD, as `PulseGeometry::echoes` gives them, but group by group,
/// and with amplitude 0 where that leaves out the back of a surface. Delays and speeds agree to rounding, amplitudes to
/// rounding and the tolerance of the curves. Replaces `echoes`; allocates nothing once these have had their size.
/// Throws the ImpossibleEcho that `PulseGeometry::echoes` throws.
void fast_echoes(const PointGroups& groups, const PulseGeometry& geometry, radar::EchoBatch& echoes);

}  // namespace sarsim::simulate
