#pragma once

#include <cstddef>

#include "simulate/plan/pulse_geometry.hpp"

namespace sarsim::simulate {

/// Calls `body(view)` with echoes of the current pulse: targets, then points of surfaces that face the radar; of more
/// than `most` of them, some that are evenly chosen.
template <class Body>
void each_sampled_view(const ResolvedScene& scene, const PulseGeometry& geometry, std::size_t most, const Body& body) {
  std::size_t all = scene.scatterers.size();
  for (const ScattererSheet& sheet : scene.sheets) all += sheet.points_m.size();
  const std::size_t step = all / most + 1;
  const radar::Pointing pointing = geometry.pointing();
  std::size_t next = 0;
  for (; next < scene.scatterers.size(); next += step) body(geometry.view(next, pointing));
  next -= scene.scatterers.size();
  for (std::size_t i = 0; i < scene.sheets.size(); ++i) {
    const std::size_t points = scene.sheets[i].points_m.size();
    for (; next < points; next += step)
      if (const auto view = geometry.sheet_view(i, next, pointing)) body(*view);
    next -= points;
  }
}

}  // namespace sarsim::simulate
