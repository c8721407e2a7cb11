#include "picture/image/selection_statistics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/maths/constants.hpp"

namespace sarsim::picture {

namespace {

constexpr std::size_t samples_per_step = std::size_t{1} << 18;
constexpr std::size_t half_bins = 1024;
constexpr double lowest_decibels = -900.0;  // Of the smallest float that is not 0.
constexpr double highest_decibels = 800.0;  // Above the largest.
constexpr std::size_t decibel_bins = 17000;

// Number, mean and sum of squared differences from it.
struct Moments {
  double count = 0.0;
  double mean = 0.0;
  double squares = 0.0;
  double minimum = std::numeric_limits<double>::infinity();
  double maximum = -std::numeric_limits<double>::infinity();

  static Moments of(const std::vector<double>& values) {
    Moments result;
    if (values.empty()) return result;
    result.count = static_cast<double>(values.size());
    for (const double value : values) {
      result.mean += value;
      result.minimum = std::min(result.minimum, value);
      result.maximum = std::max(result.maximum, value);
    }
    result.mean /= result.count;
    for (const double value : values) result.squares += (value - result.mean) * (value - result.mean);
    return result;
  }
  void add(const Moments& other) {
    if (other.count == 0.0) return;
    const double both = count + other.count;
    const double difference = other.mean - mean;
    squares += other.squares + difference * difference * count * other.count / both;
    mean += difference * other.count / both;
    count = both;
    minimum = std::min(minimum, other.minimum);
    maximum = std::max(maximum, other.maximum);
  }
};

// Counts values without knowing their range beforehand: it is a power of two and is doubled when a value does not fit,
// two bins becoming one.
class GrowingHistogram {
 public:
  explicit GrowingHistogram(bool two_sided) : two_sided_(two_sided), bins_(2 * half_bins) {}

  void add(const std::vector<double>& values, double largest_magnitude) {
    grow_to(exponent_for(largest_magnitude));
    const double scale = std::ldexp(static_cast<double>(bins_.size()), two_sided_ ? -exponent_ - 1 : -exponent_);
    const double origin = two_sided_ ? static_cast<double>(half_bins) : 0.0;
    for (const double value : values) {
      const double place = std::floor(value * scale + origin);
      ++bins_[static_cast<std::size_t>(std::clamp(place, 0.0, static_cast<double>(bins_.size() - 1)))];
    }
    any_ = any_ || !values.empty();
  }
  void add(const GrowingHistogram& other) {
    if (!other.any_) return;
    GrowingHistogram wider = other;
    grow_to(other.exponent_);
    wider.grow_to(exponent_);
    for (std::size_t i = 0; i < bins_.size(); ++i) bins_[i] += wider.bins_[i];
    any_ = true;
  }
  [[nodiscard]] Histogram result() const {
    const double high = std::ldexp(1.0, exponent_);
    return {two_sided_ ? -high : 0.0, high, bins_};
  }

 private:
  static constexpr int min_exponent = -160;  // Below the smallest float.

  // The power of two above a magnitude.
  static int exponent_for(double magnitude) {
    if (!(magnitude > 0.0)) return min_exponent;
    return std::max(std::ilogb(magnitude) + 1, min_exponent);
  }
  void grow_to(int exponent) {
    for (; exponent_ < exponent; ++exponent_) halve();
  }
  void halve() {
    if (!any_) return;
    std::vector<std::uint64_t> halved(bins_.size());
    const std::size_t origin = two_sided_ ? half_bins : 0;
    for (std::size_t i = 0; i < bins_.size(); ++i) {
      const std::size_t target = i >= origin ? origin + (i - origin) / 2 : origin - 1 - (origin - 1 - i) / 2;
      halved[target] += bins_[i];
    }
    bins_ = std::move(halved);
  }

  bool two_sided_;
  bool any_ = false;
  int exponent_ = min_exponent;
  std::vector<std::uint64_t> bins_;
};

void add_fixed(std::vector<std::uint64_t>& bins, double low, double high, const std::vector<double>& values) {
  const double scale = static_cast<double>(bins.size()) / (high - low);
  for (const double value : values)
    ++bins[static_cast<std::size_t>(std::clamp((value - low) * scale, 0.0, static_cast<double>(bins.size() - 1)))];
}

void add_bins(std::vector<std::uint64_t>& bins, const std::vector<std::uint64_t>& other) {
  for (std::size_t i = 0; i < bins.size(); ++i) bins[i] += other[i];
}

// What is known of a part of the selection.
struct Part {
  std::uint64_t samples = 0;
  std::uint64_t not_finite = 0;
  std::uint64_t zeros = 0;
  std::array<Moments, sample_quantities> moments;
  GrowingHistogram real{true};
  GrowingHistogram imaginary{true};
  GrowingHistogram magnitude{false};
  std::vector<std::uint64_t> decibels = std::vector<std::uint64_t>(decibel_bins);
  std::vector<std::uint64_t> phase = std::vector<std::uint64_t>(2 * half_bins);

  void add(const Part& other) {
    samples += other.samples;
    not_finite += other.not_finite;
    zeros += other.zeros;
    for (std::size_t i = 0; i < moments.size(); ++i) moments[i].add(other.moments[i]);
    real.add(other.real);
    imaginary.add(other.imaginary);
    magnitude.add(other.magnitude);
    add_bins(decibels, other.decibels);
    add_bins(phase, other.phase);
  }
};

double largest_of(const Moments& moments) { return std::max(std::abs(moments.minimum), std::abs(moments.maximum)); }

Part part_of(const std::vector<std::complex<float>>& samples) {
  Part part;
  part.samples = samples.size();
  std::array<std::vector<double>, sample_quantities> values;
  for (auto& list : values) list.reserve(samples.size());
  for (const std::complex<float>& sample : samples) {
    const auto i = static_cast<double>(sample.real());
    const auto q = static_cast<double>(sample.imag());
    if (!std::isfinite(i) || !std::isfinite(q)) {
      ++part.not_finite;
      continue;
    }
    const double magnitude = std::sqrt(i * i + q * q);
    values[0].push_back(i);
    values[1].push_back(q);
    values[2].push_back(magnitude);
    if (magnitude == 0.0) {
      ++part.zeros;
      continue;
    }
    values[3].push_back(20.0 * std::log10(magnitude));
    values[4].push_back(std::atan2(q, i));
  }
  for (std::size_t k = 0; k < values.size(); ++k) part.moments[k] = Moments::of(values[k]);
  if (!values[0].empty()) {
    part.real.add(values[0], largest_of(part.moments[0]));
    part.imaginary.add(values[1], largest_of(part.moments[1]));
    part.magnitude.add(values[2], largest_of(part.moments[2]));
  }
  add_fixed(part.decibels, lowest_decibels, highest_decibels, values[3]);
  add_fixed(part.phase, -core::pi, core::pi, values[4]);
  return part;
}

QuantityStatistics figures_of(const Moments& moments, Histogram histogram) {
  QuantityStatistics result;
  result.histogram = std::move(histogram);
  if (moments.count == 0.0) return result;
  result.count = static_cast<std::uint64_t>(moments.count);
  result.minimum = moments.minimum;
  result.maximum = moments.maximum;
  result.mean = moments.mean;
  const double variance = moments.squares / moments.count;
  result.deviation = std::sqrt(variance);
  result.rms = std::sqrt(variance + moments.mean * moments.mean);
  return result;
}

SelectionStatistics statistics_of(const Part& part) {
  SelectionStatistics result;
  result.samples = part.samples;
  result.not_finite = part.not_finite;
  result.zeros = part.zeros;
  result.of = {figures_of(part.moments[0], part.real.result()), figures_of(part.moments[1], part.imaginary.result()),
               figures_of(part.moments[2], part.magnitude.result()),
               figures_of(part.moments[3], {lowest_decibels, highest_decibels, part.decibels}),
               figures_of(part.moments[4], {-core::pi, core::pi, part.phase})};
  return result;
}

// A window cut into parts that are read at once: whole rows, or pieces of long ones.
struct Parts {
  raster::ImageWindow window;
  std::size_t cols = 1;
  std::size_t rows = 1;
  std::size_t across = 0;
  std::size_t down = 0;

  explicit Parts(const raster::ImageWindow& whole) : window(whole) {
    if (whole.samples() == 0) return;
    cols = std::min(whole.cols, samples_per_step);
    rows = std::max<std::size_t>(1, samples_per_step / cols);
    across = (whole.cols - 1) / cols + 1;
    down = (whole.rows - 1) / rows + 1;
  }
  [[nodiscard]] std::size_t count() const { return across * down; }
  [[nodiscard]] raster::ImageWindow part(std::size_t index) const {
    const std::size_t i = index / across * rows;
    const std::size_t k = index % across * cols;
    return {window.row0 + i * window.row_step,
            std::min(rows, window.rows - i),
            window.col0 + k * window.col_step,
            std::min(cols, window.cols - k),
            window.row_step,
            window.col_step};
  }
};

}  // namespace

std::string_view name_of(SampleQuantity quantity) {
  switch (quantity) {
    case SampleQuantity::real: return "real";
    case SampleQuantity::imaginary: return "imaginary";
    case SampleQuantity::magnitude: return "magnitude";
    case SampleQuantity::decibels: return "dB";
    case SampleQuantity::phase: break;
  }
  return "phase";
}

double Histogram::percentile(double part) const {
  std::uint64_t all = 0;
  for (const std::uint64_t bin : bins) all += bin;
  if (all == 0) return low;
  const double wanted = std::clamp(part, 0.0, 1.0) * static_cast<double>(all);
  double below = 0.0;
  std::size_t last = 0;
  for (std::size_t i = 0; i < bins.size(); ++i) {
    if (bins[i] == 0) continue;
    last = i;
    const auto here = static_cast<double>(bins[i]);
    if (below + here >= wanted) return low + (static_cast<double>(i) + (wanted - below) / here) * bin_width();
    below += here;
  }
  return low + static_cast<double>(last + 1) * bin_width();
}

QuantityStatistics::Limits QuantityStatistics::limits(double part) const {
  return {std::clamp(histogram.percentile(part), minimum, maximum),
          std::clamp(histogram.percentile(1.0 - part), minimum, maximum)};
}

SelectionStatistics measure_selection(const raster::Raster& plane, const raster::ImageWindow& window,
                                      const core::WorkControl& control, const core::ProgressReport& progress) {
  const Parts parts(window);
  Part sum;
  core::ordered_parallel<Part>(
      parts.count(), control.threads,
      [&] {
        return [&, samples = std::vector<std::complex<float>>()](std::size_t index) mutable {
          const raster::ImageWindow part = parts.part(index);
          samples.resize(part.samples());
          plane.read_window(part, samples);
          return part_of(samples);
        };
      },
      [&](std::size_t index, const Part& part) {
        sum.add(part);
        if (progress) progress({index + 1, parts.count(), 0});
      },
      control.stop);
  return statistics_of(sum);
}

}  // namespace sarsim::picture
