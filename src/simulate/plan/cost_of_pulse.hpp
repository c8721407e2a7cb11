#pragma once

#include "radar/echo/reference_kernel.hpp"
#include "radar/echo/spectral_kernel.hpp"
#include "simulate/resolve/resolved.hpp"

namespace sarsim::simulate {

/// What the spectral engine needs for one pulse.
struct SpectralEstimate {
  radar::SpectralCost cost;
  bool in_bins = false;  ///< Echoes are summed in bins (radar::SlepianRow), instead of on a grid.
  double ns = 0.0;
};

/// What each engine needs to add up the echoes of one pulse: nanoseconds on one core of 2024 with AVX-512, good to a
/// factor of two (docs/developer/performance.md). Keeps references.
class PulseCost {
 public:
  /// @param grid       of the raw samples
  /// @param tolerance  promised relative error, which decides between single and double precision
  PulseCost(const ResolvedScene& scene, const Link& radar, const radar::EchoPulse& pulse, const radar::SampleGrid& grid,
            double tolerance);

  /// Scatterers of the scene, whether the radar sees them or not.
  [[nodiscard]] double echoes() const { return echoes_; }
  /// Samples of a pulse, or of the row where that is shorter.
  [[nodiscard]] double samples() const { return samples_; }

  /// Of the plain sum.
  [[nodiscard]] double reference_ns() const;
  /// Of the direct engine.
  [[nodiscard]] double direct_ns() const;
  /// Of the spectral engine, with what decides its cost.
  /// @param pulses  of the simulation; three of them are looked at for the span of Doppler
  [[nodiscard]] SpectralEstimate spectral(const radar::PulseRange& pulses) const;

 private:
  const ResolvedScene& scene_;
  const Link& radar_;
  const radar::EchoPulse& pulse_;
  const radar::SampleGrid& grid_;
  double tolerance_;
  double echoes_;
  double samples_;
};

}  // namespace sarsim::simulate
