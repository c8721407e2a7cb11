#include "picture/colour/display_quantity.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "core/maths/constants.hpp"

namespace sarsim::picture {

std::string_view title_of(DisplayQuantity quantity) {
  switch (quantity) {
    case DisplayQuantity::real: return "Real";
    case DisplayQuantity::imaginary: return "Imaginary";
    case DisplayQuantity::magnitude: return "Magnitude";
    case DisplayQuantity::phase: return "Phase";
    case DisplayQuantity::decibels: break;
  }
  return "dB power";
}

std::string_view axis_title_of(DisplayQuantity quantity) {
  return quantity == DisplayQuantity::decibels ? "Power" : title_of(quantity);
}

std::string_view unit_of(DisplayQuantity quantity) {
  if (quantity == DisplayQuantity::phase) return "deg";
  return quantity == DisplayQuantity::decibels ? "dB" : "V";
}

ColourMapKind kind_for(DisplayQuantity quantity) {
  switch (quantity) {
    case DisplayQuantity::real:
    case DisplayQuantity::imaginary: return ColourMapKind::diverging;
    case DisplayQuantity::phase: return ColourMapKind::cyclic;
    case DisplayQuantity::magnitude:
    case DisplayQuantity::decibels: break;
  }
  return ColourMapKind::sequential;
}

double value_of(DisplayQuantity quantity, std::complex<double> sample, double reference_v) {
  switch (quantity) {
    case DisplayQuantity::real: return sample.real();
    case DisplayQuantity::imaginary: return sample.imag();
    case DisplayQuantity::magnitude: return std::abs(sample);
    case DisplayQuantity::phase: return std::arg(sample) * core::deg_per_rad;
    case DisplayQuantity::decibels: break;
  }
  const double magnitude = std::abs(sample);
  if (std::isnan(magnitude)) return magnitude;
  return std::max(lowest_db, 20.0 * std::log10(magnitude / reference_v));
}

SampleStatistics statistics_of(std::span<const std::complex<double>> samples) {
  SampleStatistics s;
  double min_power = std::numeric_limits<double>::infinity();
  double max_power = 0.0;
  for (const std::complex<double>& v : samples) {
    const double power = std::norm(v);
    if (!std::isfinite(power)) continue;
    if (s.count++ == 0) {
      s.lowest_real_v = s.highest_real_v = v.real();
      s.lowest_imaginary_v = s.highest_imaginary_v = v.imag();
    }
    min_power = std::min(min_power, power);
    max_power = std::max(max_power, power);
    s.lowest_real_v = std::min(s.lowest_real_v, v.real());
    s.highest_real_v = std::max(s.highest_real_v, v.real());
    s.lowest_imaginary_v = std::min(s.lowest_imaginary_v, v.imag());
    s.highest_imaginary_v = std::max(s.highest_imaginary_v, v.imag());
  }
  s.largest_v = s.percentile_v = std::sqrt(max_power);
  s.smallest_v = s.count > 0 ? std::sqrt(min_power) : 0.0;
  return s;
}

SampleStatistics together(const SampleStatistics& a, const SampleStatistics& b) {
  if (a.count == 0) return b;
  if (b.count == 0) return a;
  SampleStatistics s;
  s.count = a.count + b.count;
  s.largest_v = s.percentile_v = std::max(a.largest_v, b.largest_v);
  s.smallest_v = std::min(a.smallest_v, b.smallest_v);
  s.lowest_real_v = std::min(a.lowest_real_v, b.lowest_real_v);
  s.highest_real_v = std::max(a.highest_real_v, b.highest_real_v);
  s.lowest_imaginary_v = std::min(a.lowest_imaginary_v, b.lowest_imaginary_v);
  s.highest_imaginary_v = std::max(a.highest_imaginary_v, b.highest_imaginary_v);
  return s;
}

double magnitude_percentile(std::size_t rows,
                            const std::function<std::span<const std::complex<double>>(std::size_t)>& row,
                            double percentile) {
  constexpr std::size_t most = 65536;
  const std::size_t columns = rows == 0 ? 0 : row(0).size();
  const std::size_t stride = rows * columns / most + 1;
  std::vector<double> powers;
  for (std::size_t i = 0; i < rows * columns; i += stride) {
    const double power = std::norm(row(i / columns)[i % columns]);
    if (std::isfinite(power)) powers.push_back(power);
  }
  if (powers.empty()) return 0.0;
  const double share = std::clamp(percentile / 100.0, 0.0, 1.0);
  const auto place =
      powers.begin() + static_cast<std::ptrdiff_t>(std::llround(share * static_cast<double>(powers.size() - 1)));
  std::ranges::nth_element(powers, place);
  return std::sqrt(*place);
}

double reference_v(const Decibels& decibels, const SampleStatistics& statistics) {
  const double volts = decibels.reference == Decibels::Reference::maximum ? statistics.largest_v : decibels.reference_v;
  return volts > 0.0 && std::isfinite(volts) ? volts : 1.0;
}

namespace {

ColourLimits extremes(DisplayQuantity quantity, const Decibels& decibels, const SampleStatistics& s) {
  const auto in_db = [&](double v) { return value_of(DisplayQuantity::decibels, v, reference_v(decibels, s)); };
  switch (quantity) {
    case DisplayQuantity::real: return {s.lowest_real_v, s.highest_real_v};
    case DisplayQuantity::imaginary: return {s.lowest_imaginary_v, s.highest_imaginary_v};
    case DisplayQuantity::decibels:
      return {std::max(in_db(s.smallest_v), in_db(s.largest_v) - 200.0), in_db(s.largest_v)};
    case DisplayQuantity::magnitude:
    case DisplayQuantity::phase: break;
  }
  return {s.smallest_v, s.largest_v};
}

ColourLimits automatic(DisplayQuantity quantity, const Decibels& decibels, const SampleStatistics& s) {
  if (quantity == DisplayQuantity::magnitude) return {0.0, s.percentile_v};
  if (quantity != DisplayQuantity::decibels) return {-s.percentile_v, s.percentile_v};
  const double high =
      s.percentile_v > 0.0 ? value_of(DisplayQuantity::decibels, s.percentile_v, reference_v(decibels, s)) : 0.0;
  return {high - std::max(decibels.range_db, 1.0), high};
}

// Limits that can be told apart, in order.
ColourLimits sound(ColourLimits limits) {
  if (!std::isfinite(limits.low) || !std::isfinite(limits.high)) return {};
  if (limits.low > limits.high) std::swap(limits.low, limits.high);
  if (limits.low < limits.high) return limits;
  const double apart = limits.low == 0.0 ? 1.0 : 0.01 * std::abs(limits.low);
  return {limits.low - apart, limits.low + apart};
}

}  // namespace

ColourLimits colour_limits(DisplayQuantity quantity, const LimitRule& rule, const Decibels& decibels,
                           const SampleStatistics& statistics) {
  if (quantity == DisplayQuantity::phase) return {-180.0, 180.0};
  switch (rule.kind) {
    case LimitRule::Kind::manual: return sound({rule.low, rule.high});
    case LimitRule::Kind::extremes: return sound(extremes(quantity, decibels, statistics));
    case LimitRule::Kind::automatic: break;
  }
  return sound(automatic(quantity, decibels, statistics));
}

std::size_t colour_index(double value, const ColourLimits& limits, std::size_t levels, bool cyclic) {
  const double share = (value - limits.low) / (limits.high - limits.low);
  const auto count = static_cast<double>(levels);
  if (cyclic && std::isfinite(share)) {
    const double level = std::floor((share - std::floor(share)) * count);
    return static_cast<std::size_t>(std::min(level, count - 1.0));
  }
  if (!(share > 0.0)) return 0;
  return static_cast<std::size_t>(std::min(std::floor(share * count), count - 1.0));
}

}  // namespace sarsim::picture
