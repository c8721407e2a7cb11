#include "radar/receiver/converter.hpp"

#include <algorithm>
#include <cmath>

#include "core/report/expect.hpp"

namespace sarsim::radar {

namespace {

std::int64_t to_count(double value) {
  constexpr double largest = 0x1p63;
  if (value >= largest) return INT64_MAX;
  return static_cast<std::int64_t>(value);
}

// -C, or the number next to it towards 0 that a double holds: rounded the other way it would be a count too many.
double lowest_count(int bits) {
  constexpr int exact_bits = 54;
  const double full_scale = full_scale_count(bits);
  return -(bits > exact_bits ? std::nextafter(full_scale, 0.0) : full_scale);
}

// Nearest whole number, halves upwards. Not floor(x + 1/2): that sum is itself rounded, which costs a count just below
// 1/2 and at the odd counts from 2^52 on.
double rounded_half_up(double value) {
  const double below = std::floor(value);
  return value - below < 0.5 ? below : below + 1.0;
}

bool is_clipped(double value, double clipped) { return !std::isnan(value) && clipped != value; }

}  // namespace

double full_scale_count(int bits) {
  CORE_EXPECT(bits >= 1 && bits <= 64);
  return std::max(1.0, std::ldexp(1.0, bits - 1) - 1.0);
}

void Converter::convert(std::span<const std::complex<double>> volts, std::span<std::int64_t> counts,
                        ConversionTally& tally) const {
  CORE_EXPECT(counts.empty() || counts.size() == 2 * volts.size());
  CORE_EXPECT(counts.empty() || lsb_v > 0.0);
  // What the definition takes over at a time: at least a vector.
  constexpr std::size_t few = 8;
  const double highest = full_scale_count(bits) + 1.0;
  const double per_volt = 1.0 / lsb_v;
  if (highest > largest_simd_count || !std::isnormal(per_volt) || !std::isnormal(lsb_v))
    return convert_plainly(volts, counts, tally);
  double largest_power = 0.0;
  while (!volts.empty()) {
    const ConvertedPart part = convert_vectors(volts, per_volt, lowest_count(bits), highest, counts, tally);
    largest_power = std::max(largest_power, part.largest_power);
    const std::size_t done = std::min(volts.size(), part.done + few);
    const std::span<std::int64_t> rest =
        counts.empty() ? counts : counts.subspan(2 * part.done, 2 * (done - part.done));
    convert_plainly(volts.subspan(part.done, done - part.done), rest, tally);
    volts = volts.subspan(done);
    if (!counts.empty()) counts = counts.subspan(2 * done);
  }
  tally.maximum_v = std::max(tally.maximum_v, std::sqrt(largest_power));
}

void Converter::convert_plainly(std::span<const std::complex<double>> volts, std::span<std::int64_t> counts,
                                ConversionTally& tally) const {
  CORE_EXPECT(counts.empty() || counts.size() == 2 * volts.size());
  CORE_EXPECT(counts.empty() || lsb_v > 0.0);
  const double lowest = lowest_count(bits);
  const double highest = full_scale_count(bits) + 1.0;
  double largest_power = 0.0;
  for (std::size_t i = 0; i < volts.size(); ++i) {
    const double in_phase = rounded_half_up(volts[i].real() / lsb_v);
    const double quadrature = rounded_half_up(volts[i].imag() / lsb_v);
    double clipped_i = std::clamp(in_phase, lowest, highest);
    double clipped_q = std::clamp(quadrature, lowest, highest);
    if (clipped_i != in_phase || clipped_q != quadrature) {
      const bool saturated = is_clipped(in_phase, clipped_i) || is_clipped(quadrature, clipped_q);
      if (saturated) ++tally.saturated;
      if (std::isnan(in_phase) || std::isnan(quadrature)) ++tally.not_numbers;
      if (std::isnan(in_phase)) clipped_i = 0.0;
      if (std::isnan(quadrature)) clipped_q = 0.0;
    }
    if (clipped_i == 0.0 && clipped_q == 0.0) ++tally.zero;
    largest_power = std::max(largest_power, std::norm(volts[i]));
    if (!counts.empty()) {
      counts[2 * i] = to_count(clipped_i);
      counts[2 * i + 1] = to_count(clipped_q);
    }
  }
  // std::norm underflows below 1e-154 V; echoes that faint are not in any converter's reach.
  tally.maximum_v = std::max(tally.maximum_v, std::sqrt(largest_power));
}

double largest_magnitude(std::span<const std::complex<double>> volts) {
  ConversionTally tally;
  tally_volts(volts, tally);
  return tally.maximum_v;
}

}  // namespace sarsim::radar
