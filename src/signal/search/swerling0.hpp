#pragma once

#include <cstddef>

/// How often a target that does not fluctuate is detected at a constant rate of false alarms, in closed form.
///
/// The power of a cell that holds a steady target of ratio s to the noise is that of k + 1 exponential numbers, k being
/// Poisson of mean s (noncentral chi-squared; J. I. Marcum, IRE Trans. IT-6, 1960; D. A. Shnidman, IEEE Trans. IT-35,
/// 1989). The threshold is a sum of independent exponential numbers: for the mean of N cells, N of them, factor/N each;
/// for the statistic, by Renyi's representation, factor/(N - i) for i = 0 ... rank - 1. k + 1 exponential numbers
/// exceed an exponential threshold of mean m where a count of failures before a success of probability 1/(1 + m) is at
/// most k, and failures before several thresholds add up. So the probability is that of a sum of geometric numbers to
/// be at most a Poisson number of mean s, a sum of positive terms. It is the mean of Marcum's Q(sqrt(2 s), sqrt(2 T))
/// over the threshold T.
namespace sarsim::signal {

/// With the mean of `cells` cells, one square-law detected cell. Ratios beyond 50 dB count as 50 dB.
[[nodiscard]] double cell_averaging_steady_probability(std::size_t cells, double factor, double snr);

/// With the `rank`-th smallest of them.
[[nodiscard]] double ordered_statistic_steady_probability(std::size_t cells, std::size_t rank, double factor,
                                                          double snr);

}  // namespace sarsim::signal
