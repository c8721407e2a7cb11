#pragma once

#include "radar/orbit/sgp4_elements.hpp"
#include "radar/orbit/sgp4_resonance.hpp"
#include "radar/orbit/sgp4_third_body.hpp"

namespace sarsim::radar {

/// What SGP4 adds for periods of 225 min and more: Sun, Moon and resonance (the part once called SDP4).
class Sgp4DeepSpace {
 public:
  /// @param days_since_1950  the epoch, see `days_since_1950`
  Sgp4DeepSpace(const Sgp4Elements& epoch, const Sgp4Rates& zonal, double days_since_1950);

  /// Adds the secular terms and the resonance, `time_min` after the epoch.
  void add_secular(double time_min, Sgp4Elements& mean) const;
  /// Adds the periodic terms of Sun and Moon. For inclinations below 0.2 rad by Lyddane's change of variables.
  void add_periodic(double time_min, Sgp4Elements& mean) const;

 private:
  ThirdBody sun_;
  ThirdBody moon_;
  double eccentricity_rate_ = 0.0;
  double inclination_rate_ = 0.0;
  Sgp4Rates rates_;
  Sgp4Resonance resonance_;
};

}  // namespace sarsim::radar
