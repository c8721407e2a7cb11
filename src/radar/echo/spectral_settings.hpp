#pragma once

#include <cmath>
#include <cstddef>

namespace sarsim::radar {

/// How an error budget is divided and what follows from it.
struct SpectralSettings {
  /// Of the eight, to what is left of motion: the others do not need all.
  static constexpr double motion_shares = 3.0;

  bool single_precision;
  double share;              ///< Error allowed to each source
  std::size_t edge_samples;  ///< K.
  double beta;               ///< Of the Kaiser step

  /// Error allowed to Doppler terms.
  [[nodiscard]] double motion_share() const { return motion_shares * share; }

  explicit SpectralSettings(double tolerance)
      : single_precision(tolerance >= 9.9e-7),
        share(tolerance / 8.0),
        edge_samples(single_precision ? 8 : 12),
        beta(std::log(4.0 / share)) {}
};

}  // namespace sarsim::radar
