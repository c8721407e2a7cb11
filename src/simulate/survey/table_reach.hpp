#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "simulate/survey/survey_echoes.hpp"
#include "simulate/survey/target_visibility.hpp"

namespace sarsim::simulate {

/// Tables of a radar and of its scatterers.
struct AngleTables {
  std::size_t count = 0;
  /// How far a direction is beyond one table after the other, deg; 0 where it is covered.
  /// @param offset         from the beam's axis
  /// @param incidence_rad  of a scatterer with a reflectivity by points; nothing for others
  /// @param curve          of that scatterer: index into `ResolvedScene::gain_curves`
  std::function<void(const radar::BeamOffset& offset, std::optional<double> incidence_rad, std::uint32_t curve,
                     std::span<double> beyond_deg)>
      beyond;
};

/// A point of a surface as the beam passes it.
struct SurfaceSight {
  std::size_t surface = 0;
  TargetVisibility sight;
};

/// What of a scene reaches farthest beyond tables.
struct TableReach {
  std::vector<TargetVisibility> targets;  ///< Of targets and of points of clouds, besides those that were examined.
  std::vector<SurfaceSight> surfaces;     ///< Several of each surface that reaches beyond any.
};

/// Looks for what is seen at angles beyond tables: among all targets and points of clouds in the window, up to 20 000
/// of them evenly chosen, at three pulses; among the outermost and some other points of surfaces at nine. Those
/// farthest beyond each table, up to 64 in all, are followed as `VisibilitySurvey` does. Points between, at pulses
/// between, may reach a little farther. Takes some milliseconds.
/// @param examined  targets whose sights are known, ascending
[[nodiscard]] TableReach reach_beyond_tables(const Acquisition& acquisition, const EchoSurvey& survey,
                                             const std::vector<std::size_t>& examined, const AngleTables& tables,
                                             const core::WorkControl& control);

}  // namespace sarsim::simulate
