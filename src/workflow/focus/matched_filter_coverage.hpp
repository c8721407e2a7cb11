#pragma once

#include <cstddef>
#include <vector>

#include "simulate/plan/acquisition.hpp"

namespace sarsim::workflow {

/// What the receiver's gain over time (STC) and the ends of a recording make of compressed echoes: factors to the
/// amplitude of an echo of constant gain that is recorded whole. With the weights w of the compressing filter over the
/// samples k of the pulse p, at the raw sample i where the echo begins, g the gain: sum over the recorded k of
/// w |p|^2 g[i + k], over the sum of w |p|^2 over all of them.
class MatchedFilterCoverage {
 public:
  /// @param columns  compressed samples that are used, from the first one on: at most as many as the acquisition has;
  /// of a plan
  ///                 of raw data those up to the row's end can be compressed, the last ones in part
  /// @param weight   over the pulse, the fraction of its width from 0 to 1
  MatchedFilterCoverage(const simulate::Acquisition& acquisition, std::size_t columns,
                        const signal::WindowFunction& weight);

  /// Mean of the gain over what is recorded of an echo; 1 without STC. Beyond the ends as at them.
  [[nodiscard]] double gain(double delay_s) const;
  /// What is recorded of an echo, 0 to 1: 1 but for those that a raw row ends with; 0 outside its columns.
  [[nodiscard]] double share(double delay_s) const;
  /// The same wherever the echo begins: those, too, whose peak their Doppler frequency moves into the columns.
  [[nodiscard]] double held(double delay_s) const;
  /// Where echoes begin that are the last to be recorded whole, or the last column's, whichever is earlier.
  [[nodiscard]] double last_whole_s() const;
  /// Power of white noise there, over that of noise without STC under the whole filter.
  [[nodiscard]] double noise(double delay_s) const;

 private:
  [[nodiscard]] double index_of(double delay_s) const { return (delay_s - first_delay_s_) / interval_s_; }

  double first_delay_s_;  // of the echo that begins with the first raw sample
  double interval_s_;
  double last_index_;        // raw sample that the last column begins at
  double last_whole_ = 0.0;  // raw sample
  std::vector<double> share_;
  std::vector<double> gain_;  // empty: 1
  std::vector<double> noise_;
};

}  // namespace sarsim::workflow
