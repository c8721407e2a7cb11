#include "radar/waveform/band_limited_pulse.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/maths/constants.hpp"
#include "core/maths/fft.hpp"
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

// Adds nodes for integrals from a to b of the pulse times `gain` and functions of at most `highest_hz`. The pulse is
// smooth in between.
template <class Gain>
void add_nodes(const Pulse& pulse, double a_s, double b_s, double highest_hz, const Gain& gain,
               std::vector<Node>& nodes) {
  const auto panels = static_cast<std::size_t>(std::ceil((b_s - a_s) * highest_hz)) + 1;
  const double half = 0.5 * (b_s - a_s) / static_cast<double>(panels);
  for (std::size_t p = 0; p < panels; ++p) {
    const double middle = a_s + half * (2.0 * static_cast<double>(p) + 1.0);
    for (const auto& [x, w] : legendre)
      for (const double sign : {-1.0, 1.0}) {
        const double t = middle + sign * x * half;
        nodes.push_back({t, w * half * gain(t) * pulse.value(t)});
      }
  }
}

// Rises from 0 at 0 to 1 at 1, smooth to 1e-13; with 1 - x it adds up to 1. Over a time T its spectrum ends at 18/T.
double rise(double x) {
  constexpr double steepness = 5.2;
  if (x <= 0.0) return 0.0;
  if (x >= 1.0) return 1.0;
  return 0.5 * std::erfc(steepness * (1.0 - 2.0 * x));
}
constexpr double rise_band = 3.0;     // length of a rise times F
constexpr double rise_highest = 6.0;  // F: where its spectrum has ended

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

// The integral of pulse and filter as a convolution of grids. Inside a smooth piece of the pulse, faded in and out, the
// sum over the points of the grid is the integral. What the fading leaves at the ends of the piece are quadrature nodes
// between the points: each is spread over the points around it by the weights that interpolate the filter.
void BandLimitedPulse::fill_table(const Pulse& pulse, double half_band_hz) {
  const auto count = static_cast<std::size_t>(std::ceil((last_s_ - table_start_s_) * table_rate_hz_)) + taps + 1;
  table_.assign(core::good_fft_size(count), 0.0);
  const double rise_s = rise_band / half_band_hz;
  const double highest_hz = 0.5 * bandwidth_hz(pulse) + half_band_hz;
  const double faded_hz = highest_hz + rise_highest * half_band_hz;
  std::vector<double> edges = pulse.breaks_s();
  edges.insert(edges.begin(), 0.0);
  edges.push_back(pulse.width_s);
  std::vector<Node> nodes;
  for (std::size_t e = 0; e + 1 < edges.size(); ++e) {
    const double a_s = edges[e];
    const double b_s = edges[e + 1];
    if (b_s - a_s < 2.0 * rise_s || faded_hz > table_rate_hz_) {
      add_nodes(
          pulse, a_s, b_s, highest_hz, [](double) { return 1.0; }, nodes);
      continue;
    }
    add_nodes(
        pulse, a_s, a_s + rise_s, faded_hz, [&](double t) { return rise(1.0 - (t - a_s) / rise_s); }, nodes);
    add_nodes(
        pulse, b_s - rise_s, b_s, faded_hz, [&](double t) { return rise(1.0 - (b_s - t) / rise_s); }, nodes);
    const auto first = static_cast<std::size_t>(std::ceil((a_s - table_start_s_) * table_rate_hz_));
    const auto last = static_cast<std::size_t>(std::floor((b_s - table_start_s_) * table_rate_hz_));
    for (std::size_t k = first; k <= last; ++k) {
      const double t = table_start_s_ + static_cast<double>(k) / table_rate_hz_;
      const double gain = rise((t - a_s) / rise_s) * rise((b_s - t) / rise_s);
      if (gain > 0.0) table_[k] += gain / table_rate_hz_ * pulse.value(t);
    }
  }
  for (const Node& node : nodes) {
    const double position = (node.t_s - table_start_s_) * table_rate_hz_;
    const double below = std::floor(position);
    const Taps weights = taps_at(position - below);
    const std::size_t first = static_cast<std::size_t>(below) - (taps / 2 - 1);
    for (std::size_t k = 0; k < taps; ++k) table_[first + k] += weights.weight[k] * node.weighted;
  }
  filter_table(half_band_hz);
  table_.resize(count);
}

// Convolves the table with the filter, which fits between the first and the last entry that are not 0 and the ends.
void BandLimitedPulse::filter_table(double half_band_hz) {
  const double reach = half_length_band / half_band_hz;
  const double cut_hz = cut_fraction * half_band_hz;
  const double ends_at = reach * table_rate_hz_;
  const auto half = static_cast<std::size_t>(ends_at);
  // The filter stops at a step, some way after its last point: the sum is corrected to second order (Gregory).
  const double beyond = ends_at - static_cast<double>(half);
  const double slope = 0.5 * beyond * beyond - 1.0 / 12.0;
  const double weight_last = 0.5 + beyond + slope;
  const double weight_before = 1.0 - slope;
  std::vector<std::complex<double>> filter(table_.size());
  for (std::size_t j = 0; j <= half; ++j) {
    const double lag_s = static_cast<double>(j) / table_rate_hz_;
    const double window = std::max(semicircle_window(lag_s / reach, filter_beta), std::exp(-filter_beta));
    double value = 2.0 * cut_hz * sinc(2.0 * cut_hz * lag_s) * window / static_cast<double>(table_.size());
    if (j + 1 == half) value *= weight_before;
    if (j == half) value *= weight_last;
    filter[j] = value;
    if (j > 0) filter[filter.size() - j] = value;
  }
  const core::Fft fft(table_.size());
  fft.forward(filter);
  fft.forward(table_);
  for (std::size_t i = 0; i < table_.size(); ++i) table_[i] *= filter[i];
  fft.inverse(table_);
}

// Weights of the table entries around a position that lies `fraction` in [0, 1) after entry number taps/2 - 1.
BandLimitedPulse::Taps BandLimitedPulse::taps_at(double fraction) const {
  Taps result;
  double total = 0.0;
  // All sines are that of the nearest entry, with their signs in turn.
  const int nearest = fraction <= 0.5 ? taps / 2 - 1 : taps / 2;
  const double sine = std::sin(core::pi * (fraction <= 0.5 ? fraction : fraction - 1.0)) / core::pi;
  for (int k = 0; k < taps; ++k) {
    const double z = fraction - (k - (taps / 2 - 1));
    const double sinc_z = std::abs(z) < 1e-9 ? 1.0 : ((k - nearest) % 2 == 0 ? sine : -sine) / z;
    const double weight = sinc_z * semicircle_window(z / (taps / 2), interpolation_beta);
    result.weight[static_cast<std::size_t>(k)] = weight;
    total += weight;
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
