#pragma once

namespace sarsim::signal {

/// The factor on the noise at which a probability of false alarm, which falls from 1 towards 0, has fallen to a value:
/// doubling finds an upper end, halving the factor, to a relative `accuracy`.
/// @param log_probability  ln P of a factor of at least 0
template <class LogProbability>
[[nodiscard]] double factor_where(const LogProbability& log_probability, double log_false_alarm, double accuracy) {
  double high = 1.0;
  while (log_probability(high) > log_false_alarm && high < 1e300) high *= 2.0;
  double low = 0.0;
  for (int i = 0; i < 200 && high - low > accuracy * high; ++i) {
    const double middle = 0.5 * (low + high);
    (log_probability(middle) > log_false_alarm ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace sarsim::signal
