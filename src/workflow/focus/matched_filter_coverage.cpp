#include "workflow/focus/matched_filter_coverage.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace sarsim::workflow {

namespace {

// Of the filter that compresses: weights of its taps in the sum over an echo and in that over white noise, both 1 in
// all.
struct TapWeights {
  std::vector<double> echo;
  std::vector<double> noise;
};

TapWeights tap_weights(const simulate::Acquisition& acquisition, const signal::WindowFunction& weight) {
  const double rate_hz = 1.0 / acquisition.reception.raw_grid.interval_s;
  const radar::BandLimitedPulse* band_limited =
      acquisition.reception.pulse.band_limited ? &*acquisition.reception.pulse.band_limited : nullptr;
  const auto plain = signal::matched_filter(
      acquisition.link.pulse, band_limited, [](double) { return 1.0; }, rate_hz);
  TapWeights weights;
  for (std::size_t k = 0; k < plain.taps.size(); ++k) {
    const double w = weight(static_cast<double>(k) / (acquisition.link.pulse.width_s * rate_hz));
    const double power = std::norm(plain.taps[k]);
    weights.echo.push_back(w * power);
    weights.noise.push_back(w * w * power);
  }
  for (std::vector<double>* list : {&weights.echo, &weights.noise}) {
    const double sum = std::accumulate(list->begin(), list->end(), 0.0);
    if (sum != 0.0)
      for (double& w : *list) w /= sum;
  }
  return weights;
}

// For each raw sample the sum of the weights of those taps that meet samples of the row. Exactly 1 where all do.
std::vector<double> recorded_sums(const std::vector<double>& weights, std::size_t samples) {
  std::vector<double> sums(samples, 1.0);
  double sum = 0.0;
  for (std::size_t k = 0; k + 1 < weights.size() && k < samples; ++k) {
    sum += weights[k];
    sums[samples - 1 - k] = sum;
  }
  return sums;
}

// For each raw sample i the sum of weights[k] factors[i + k].
std::vector<double> correlated(const std::vector<double>& weights, const std::vector<double>& factors) {
  signal::CompressionFilter filter;
  filter.taps.assign(weights.begin(), weights.end());
  std::vector<std::size_t> index(factors.size());
  std::iota(index.begin(), index.end(), std::size_t{0});
  const signal::RangeCompressor compressor(std::move(filter), factors.size(), std::move(index));
  const std::vector<std::complex<double>> raw(factors.begin(), factors.end());
  std::vector<std::complex<double>> out(factors.size());
  std::vector<std::complex<double>> scratch(compressor.scratch_size());
  compressor.compress(raw, out, scratch);
  std::vector<double> sums(factors.size());
  for (std::size_t i = 0; i < sums.size(); ++i) sums[i] = out[i].real();
  return sums;
}

// By straight lines; beyond the ends as at them.
double value_at(const std::vector<double>& table, double index) {
  const double inside = std::clamp(index, 0.0, static_cast<double>(table.size() - 1));
  const auto left = std::min(static_cast<std::size_t>(inside), table.size() - 1);
  const std::size_t right = std::min(left + 1, table.size() - 1);
  const double part = inside - static_cast<double>(left);
  return table[left] + part * (table[right] - table[left]);
}

}  // namespace

MatchedFilterCoverage::MatchedFilterCoverage(const simulate::Acquisition& acquisition, std::size_t columns,
                                             const signal::WindowFunction& weight)
    : first_delay_s_(acquisition.reception.raw_grid.first_s + acquisition.reception.pulse.lead_s),
      interval_s_(acquisition.reception.raw_grid.interval_s) {
  const std::size_t last =
      acquisition.reception.compressor ? acquisition.reception.compressor->output_index().at(columns - 1) : columns - 1;
  last_index_ = static_cast<double>(last);
  const TapWeights weights = tap_weights(acquisition, weight);
  last_whole_ = std::min(last_index_, static_cast<double>(acquisition.reception.raw_grid.count) -
                                          static_cast<double>(weights.echo.size()));
  share_ = recorded_sums(weights.echo, acquisition.reception.raw_grid.count);
  if (acquisition.reception.stc_gain.empty()) {
    noise_ = recorded_sums(weights.noise, acquisition.reception.raw_grid.count);
    return;
  }
  gain_ = correlated(weights.echo, acquisition.reception.stc_gain);
  for (std::size_t i = 0; i < gain_.size(); ++i)
    if (share_[i] > 0.0) gain_[i] /= share_[i];
  std::vector<double> squares = acquisition.reception.stc_gain;
  for (double& g : squares) g *= g;
  noise_ = correlated(weights.noise, squares);
}

double MatchedFilterCoverage::gain(double delay_s) const {
  return gain_.empty() ? 1.0 : value_at(gain_, index_of(delay_s));
}

double MatchedFilterCoverage::share(double delay_s) const {
  const double index = index_of(delay_s);
  if (!(index >= -0.5 && index <= last_index_ + 0.5)) return 0.0;
  return held(delay_s);
}

double MatchedFilterCoverage::held(double delay_s) const { return value_at(share_, index_of(delay_s)); }

double MatchedFilterCoverage::last_whole_s() const { return first_delay_s_ + last_whole_ * interval_s_; }

double MatchedFilterCoverage::noise(double delay_s) const { return value_at(noise_, index_of(delay_s)); }

}  // namespace sarsim::workflow
