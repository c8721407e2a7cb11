#include "signal/search/swerling0.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/report/expect.hpp"

namespace sarsim::signal {

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

// A Poisson number whose mean is at least this is in practice never below a number k.
double mean_beyond(double k) { return k + 12.0 * std::sqrt(k) + 60.0; }

// What a sum of geometric numbers exceeds in less than exp(-40) of all cases: Chernoff's bound half way, in logarithms,
// to where the generating function ends.
double largest_sum(const std::vector<double>& success) {
  const double most = 1.0 - std::ranges::min(success);
  if (!(most > 0.0)) return 0.0;
  const double log_turn = -0.5 * std::log(most);
  double sum = 40.0;
  for (const double p : success) sum += std::log(p) - std::log1p(-(1.0 - p) * std::exp(log_turn));
  return sum / log_turn;
}

Poisson signal_of(const std::vector<double>& success, double snr) {
  return Poisson(std::min({snr, largest_snr, mean_beyond(largest_sum(success))}));
}

// Probability that failures, of which there are 0, 1 ... with these probabilities, are at most a Poisson number.
double steady_probability(const std::vector<double>& failures, const Poisson& signal) {
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
  CORE_EXPECT(cells > 0);
  CORE_EXPECT(factor >= 0.0);
  CORE_EXPECT(snr >= 0.0);
  const double mean = factor / static_cast<double>(cells);
  const Poisson signal = signal_of(std::vector<double>(cells, 1.0 / (1.0 + mean)), snr);
  // Before so many equal successes: a negative binomial distribution, each from the one before.
  std::vector<double> failures(signal.first + signal.share.size(), 0.0);
  failures[0] = std::exp(-static_cast<double>(cells) * std::log1p(mean));
  for (std::size_t k = 1; k < failures.size(); ++k)
    failures[k] = failures[k - 1] * mean / (1.0 + mean) * static_cast<double>(cells + k - 1) / static_cast<double>(k);
  return steady_probability(failures, signal);
}

double ordered_statistic_steady_probability(std::size_t cells, std::size_t rank, double factor, double snr) {
  CORE_EXPECT(rank >= 1 && rank <= cells);
  CORE_EXPECT(factor >= 0.0);
  CORE_EXPECT(snr >= 0.0);
  std::vector<double> success;
  for (std::size_t i = 0; i < rank; ++i) success.push_back(1.0 / (1.0 + factor / static_cast<double>(cells - i)));
  const Poisson signal = signal_of(success, snr);
  std::vector<double> failures(signal.first + signal.share.size(), 0.0);
  failures[0] = 1.0;
  for (const double p : success) {
    double before = 0.0;
    for (double& f : failures) f = before = p * f + (1.0 - p) * before;
  }
  return steady_probability(failures, signal);
}

}  // namespace sarsim::signal
