#pragma once

#include <algorithm>
#include <optional>

#include "scene/model/scene.hpp"

namespace sarsim::scene {

/// Lowest and highest carrier that a radar sends, Hz.
struct CarrierSpan {
  double lowest_hz = 0.0;
  double highest_hz = 0.0;
};

/// The carriers of a radar whose values may be wrong; nothing for an empty list.
[[nodiscard]] inline std::optional<CarrierSpan> carrier_span(const Radar& radar) {
  switch (radar.carrier) {
    case Radar::Carrier::single: break;
    case Radar::Carrier::stepped: {
      const double last_hz = radar.carrier_hz + radar.carrier_step_hz * (radar.carrier_steps - 1);
      return CarrierSpan{std::min(radar.carrier_hz, last_hz), std::max(radar.carrier_hz, last_hz)};
    }
    case Radar::Carrier::user: {
      const auto& knots = radar.carrier_list_hz.part[0].knots;
      if (knots.empty()) return std::nullopt;
      const auto [lowest, highest] = std::ranges::minmax(knots, {}, &core::Knot::y);
      return CarrierSpan{lowest.y, highest.y};
    }
  }
  return CarrierSpan{radar.carrier_hz, radar.carrier_hz};
}

}  // namespace sarsim::scene
