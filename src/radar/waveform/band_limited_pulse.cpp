#include "radar/waveform/band_limited_pulse.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/maths/constants.hpp"
#include "core/report/expect.hpp"

namespace sarsim::radar {

namespace {

constexpr double filter_beta = 14.0;
constexpr double cut_fraction = 0.92;      // Fc/F
constexpr double half_length_band = 28.0;  // Th F
constexpr double interpolation_beta = 28.0;
constexpr double edge_tolerance = 1e-9;  // of a sampling interval (decision 8)

double semicircle_window(double z, double beta) {
  const double inside = (1.0 - z) * (1.0 + z);
  return inside <= 0.0 ? 0.0 : std::exp(beta * (std::sqrt(inside) - 1.0));
}

double sinc(double x) { return std::abs(x) < 1e-9 ? 1.0 : std::sin(core::pi * x) / (core::pi * x); }

// Gauss-Legendre nodes and weights on [-1, 1], 8 points (Abramowitz and Stegun, table 25.4).
constexpr std::array<std::array<double, 2>, 4> legendre{{{0.1834346424956498, 0.3626837833783620},
                                                         {0.5255324099163290, 0.3137066458778873},
                                                         {0.7966664774136267, 0.2223810344533745},
                                                         {0.9602898564975363, 0.1012285362903763}}};

struct Node {
  double t_s;
  std::complex<double> weighted;  // weight times pulse value
};

// Nodes for integrals of the pulse times functions of at most `highest_hz`; panels end where the pulse jumps.
std::vector<Node> quadrature_nodes(const Pulse& pulse, double highest_hz) {
  std::vector<double> edges = pulse.breaks_s();
  edges.insert(edges.begin(), 0.0);
  edges.push_back(pulse.width_s);
  std::vector<Node> nodes;
  for (std::size_t e = 0; e + 1 < edges.size(); ++e) {
    const double length = edges[e + 1] - edges[e];
    const auto panels = static_cast<std::size_t>(std::ceil(length * highest_hz)) + 1;
    const double half = 0.5 * length / static_cast<double>(panels);
    for (std::size_t p = 0; p < panels; ++p) {
      const double middle = edges[e] + half * (2.0 * static_cast<double>(p) + 1.0);
      for (const auto& [x, w] : legendre)
        for (const double sign : {-1.0, 1.0}) {
          const double t = middle + sign * x * half;
          nodes.push_back({t, w * half * pulse.value(t)});
        }
    }
  }
  std::ranges::sort(nodes, {}, &Node::t_s);
  return nodes;
}

}  // namespace

struct BandLimitedPulse::Taps {
  std::array<double, taps> weight;
};

BandLimitedPulse::BandLimitedPulse(const Pulse& pulse, double half_band_hz, double sample_rate_hz, double kept_width_s)
    : half_band_hz_(half_band_hz) {
  CORE_EXPECT(half_band_hz > 0.0);
  CORE_EXPECT(sample_rate_hz > 0.0);
  CORE_EXPECT(kept_width_s >= 0.0);
  samples_per_interval_ = static_cast<std::ptrdiff_t>(std::ceil(8.0 * half_band_hz / sample_rate_hz - 1e-9));
  samples_per_interval_ = std::max<std::ptrdiff_t>(samples_per_interval_, 1);
  table_rate_hz_ = sample_rate_hz * static_cast<double>(samples_per_interval_);
  const double reach = half_length_band / half_band_hz;
  first_s_ = -reach;
  last_s_ = pulse.width_s + reach;
  table_start_s_ = first_s_ - taps / table_rate_hz_;
  fill_table(pulse, half_band_hz);
  if (kept_width_s > 0.0) {
    first_s_ = std::max(first_s_, 0.5 * (pulse.width_s - kept_width_s));
    last_s_ = std::min(last_s_, 0.5 * (pulse.width_s + kept_width_s));
  }
}

void BandLimitedPulse::fill_table(const Pulse& pulse, double half_band_hz) {
  const double reach = half_length_band / half_band_hz;
  const double cut_hz = cut_fraction * half_band_hz;
  const std::vector<Node> nodes = quadrature_nodes(pulse, 0.5 * bandwidth_hz(pulse) + half_band_hz);
  const auto count = static_cast<std::size_t>(std::ceil((last_s_ - table_start_s_) * table_rate_hz_)) + taps + 1;
  table_.assign(count, 0.0);
  for (std::size_t i = 0; i < count; ++i) {
    const double t = table_start_s_ + static_cast<double>(i) / table_rate_hz_;
    const auto begin = std::ranges::lower_bound(nodes, t - reach, {}, &Node::t_s);
    std::complex<double> sum = 0.0;
    for (auto node = begin; node != nodes.end() && node->t_s < t + reach; ++node) {
      const double lag = t - node->t_s;
      sum += node->weighted * (2.0 * cut_hz * sinc(2.0 * cut_hz * lag) * semicircle_window(lag / reach, filter_beta));
    }
    table_[i] = sum;
  }
}

// Weights of the table entries around a position that lies `fraction` in [0, 1) after entry number taps/2 - 1.
BandLimitedPulse::Taps BandLimitedPulse::taps_at(double fraction) const {
  Taps result;
  double total = 0.0;
  for (int k = 0; k < taps; ++k) {
    const double z = fraction - (k - (taps / 2 - 1));
    result.weight[static_cast<std::size_t>(k)] = sinc(z) * semicircle_window(z / (taps / 2), interpolation_beta);
    total += result.weight[static_cast<std::size_t>(k)];
  }
  for (double& w : result.weight) w /= total;
  return result;
}

std::complex<double> BandLimitedPulse::value(double t_s) const {
  std::complex<double> one;
  values(t_s, {&one, 1});
  return one;
}

void BandLimitedPulse::values(double t_s, std::span<std::complex<double>> out) const {
  const double position = (t_s - table_start_s_) * table_rate_hz_;
  const double below = std::floor(position);
  const Taps weights = taps_at(position - below);
  const double interval_s = static_cast<double>(samples_per_interval_) / table_rate_hz_;
  const double tolerance_s = edge_tolerance * interval_s;
  auto entry = static_cast<std::ptrdiff_t>(below) - (taps / 2 - 1);
  for (std::size_t i = 0; i < out.size(); ++i, entry += samples_per_interval_) {
    const double t = t_s + static_cast<double>(i) * interval_s;
    const bool inside =
        t >= first_s_ - tolerance_s && t < last_s_ - tolerance_s && entry >= 0 && entry + taps <= std::ssize(table_);
    double re = 0.0;
    double im = 0.0;
    if (inside)
      for (std::ptrdiff_t k = 0; k < taps; ++k) {
        const std::complex<double>& sample = table_[static_cast<std::size_t>(entry + k)];
        const double w = weights.weight[static_cast<std::size_t>(k)];
        re += w * sample.real();
        im += w * sample.imag();
      }
    out[i] = {re, im};
  }
}

}  // namespace sarsim::radar
