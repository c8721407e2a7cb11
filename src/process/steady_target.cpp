#include "process/steady_target.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace sarsim {

namespace {

constexpr double largest_snr = 1e5;

// Poisson probabilities of the numbers first, first + 1 ... that matter, by ratios from the likeliest on.
struct Poisson {
  explicit Poisson(double mean) {
    const double reach = 12.0 * std::sqrt(mean) + 60.0;
    first = static_cast<std::size_t>(std::max(0.0, std::floor(mean - reach)));
    const auto last = static_cast<std::size_t>(mean + reach);
    const std::size_t mode = static_cast<std::size_t>(mean) - first;
    share.assign(last - first + 1, 0.0);
    share[mode] = 1.0;
    for (std::size_t i = mode; i + 1 < share.size(); ++i)
      share[i + 1] = share[i] * mean / static_cast<double>(first + i + 1);
    for (std::size_t i = mode; i > 0; --i) share[i - 1] = share[i] * static_cast<double>(first + i) / mean;
    double sum = 0.0;
    for (const double s : share) sum += s;
    for (double& s : share) s /= sum;
  }
  std::size_t first = 0;
  std::vector<double> share;
};

// Probability that a sum of geometric numbers, the failures before successes of these probabilities, is at most a
// Poisson number.
double steady_probability(const std::vector<double>& success, double snr) {
  const Poisson signal(std::min(snr, largest_snr));
  std::vector<double> failures(signal.first + signal.share.size(), 0.0);
  failures[0] = 1.0;
  for (const double p : success) {
    double before = 0.0;
    for (double& f : failures) f = before = p * f + (1.0 - p) * before;
  }
  double at_most = 0.0;
  double probability = 0.0;
  for (std::size_t k = 0; k < failures.size(); ++k) {
    at_most += failures[k];
    if (k >= signal.first) probability += signal.share[k - signal.first] * at_most;
  }
  return probability;
}

}  // namespace

double cell_averaging_steady_probability(std::size_t cells, double factor, double snr) {
  const std::vector<double> success(cells, 1.0 / (1.0 + factor / static_cast<double>(cells)));
  return steady_probability(success, snr);
}

double ordered_statistic_steady_probability(std::size_t cells, std::size_t rank, double factor, double snr) {
  std::vector<double> success;
  for (std::size_t i = 0; i < rank; ++i) success.push_back(1.0 / (1.0 + factor / static_cast<double>(cells - i)));
  return steady_probability(success, snr);
}

}  // namespace sarsim
