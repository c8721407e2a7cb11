#pragma once

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

namespace sarsim::signal {

/// Profiles that belong together: bursts first ... last, both included.
struct ProfileSet {
  std::size_t first = 0;
  std::size_t last = 0;

  [[nodiscard]] std::size_t count() const { return last - first + 1; }
};

/// The scans of an encounter. A scan is what was received while the target was illuminated, the encounter all profiles
/// while it was in sight, over a number of scans (thesis, nomenclature): runs of bursts whose gain is at least
/// `min_share` of the largest.
/// @param gain  of each burst: two-way power towards the target, in any unit; all 0: no scan
[[nodiscard]] std::vector<ProfileSet> scans_of(std::span<const double> gain, double min_share);

/// Root mean square of the magnitudes of some profiles, bin by bin: what integration without phases leaves of a set.
/// @param profiles  rows of `bins`
[[nodiscard]] std::vector<std::complex<double>> mean_profile(std::span<const std::complex<double>> profiles,
                                                             std::size_t bins);

/// Bins by which a profile is to be moved, towards larger ranges, to lie upon another one: the largest correlation of
/// their powers.
/// @throw  std::invalid_argument where they have not the same length
[[nodiscard]] std::ptrdiff_t shift_onto(std::span<const std::complex<double>> profile,
                                        std::span<const std::complex<double>> other);

}  // namespace sarsim::signal
