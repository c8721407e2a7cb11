#include "radar/receiver/convert_row.hpp"

#include <algorithm>
#include <cmath>

#include "core/report/expect.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "radar/receiver/convert_row.cpp"
#include <hwy/foreach_target.h>  // includes this file once per instruction set

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace sarsim::radar::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Doubles = hn::ScalableTag<double>;
using Vector = hn::Vec<Doubles>;
using Lanes = hn::Mask<Doubles>;

// I or Q of some samples.
struct Component {
  Vector rounded;
  Lanes in_doubt;
};

// Nearest whole numbers, halves upwards.
HWY_INLINE Component round_half_up(Doubles d, Vector volts, double per_volt) {
  const Vector lsbs = hn::Mul(volts, hn::Set(d, per_volt));
  const Vector below = hn::Floor(lsbs);
  const Vector fraction = hn::Sub(lsbs, below);
  const Vector half = hn::Set(d, 0.5);
  const Vector doubt = hn::Mul(hn::Abs(lsbs), hn::Set(d, 0x1p-50));
  const Vector up = hn::IfThenElseZero(hn::Ge(fraction, half), hn::Set(d, 1.0));
  return {hn::Add(below, up), hn::Le(hn::Abs(hn::Sub(fraction, half)), doubt)};
}

// Whole numbers below 2^51 as integers: added to 1.5 x 2^52 they stand in the last digits.
HWY_INLINE hn::Vec<hn::RebindToSigned<Doubles>> integers(Doubles d, Vector whole) {
  const hn::RebindToSigned<Doubles> di;
  const Vector magic = hn::Set(d, 0x1.8p52);
  return hn::Sub(hn::BitCast(di, hn::Add(whole, magic)), hn::BitCast(di, magic));
}

HWY_INLINE Vector ones(Doubles d, Lanes where) { return hn::IfThenElseZero(where, hn::Set(d, 1.0)); }

HWY_INLINE std::uint64_t sum_of(Doubles d, Vector counts) {
  return static_cast<std::uint64_t>(hn::GetLane(hn::SumOfLanes(d, counts)));
}

ConvertedPart convert_on_target(std::span<const std::complex<double>> volts, double per_volt, double lowest,
                                double highest, std::span<std::int64_t> counts, ConversionTally& tally) {
  const Doubles d;
  const hn::RebindToSigned<Doubles> di;
  const std::size_t lanes = hn::Lanes(d);
  const double* const from = reinterpret_cast<const double*>(volts.data());
  const Vector least = hn::Set(d, lowest);
  const Vector most = hn::Set(d, highest);
  Vector zeros = hn::Zero(d);
  Vector saturated = hn::Zero(d);
  Vector power = hn::Zero(d);
  std::size_t i = 0;
  for (; i + lanes <= volts.size(); i += lanes) {
    Vector re = hn::Zero(d);
    Vector im = hn::Zero(d);
    hn::LoadInterleaved2(d, from + 2 * i, re, im);
    const Component in_phase = round_half_up(d, re, per_volt);
    const Component quadrature = round_half_up(d, im, per_volt);
    const Vector norm = hn::Add(hn::Mul(re, re), hn::Mul(im, im));
    const auto unsure = hn::Or(hn::Or(in_phase.in_doubt, quadrature.in_doubt), hn::IsNaN(norm));
    if (HWY_UNLIKELY(!hn::AllFalse(d, unsure))) break;
    const Vector clipped_i = hn::Min(hn::Max(in_phase.rounded, least), most);
    const Vector clipped_q = hn::Min(hn::Max(quadrature.rounded, least), most);
    const auto clips = hn::Or(hn::Ne(clipped_i, in_phase.rounded), hn::Ne(clipped_q, quadrature.rounded));
    saturated = hn::Add(saturated, ones(d, clips));
    zeros = hn::Add(zeros, ones(d, hn::And(hn::Eq(clipped_i, hn::Zero(d)), hn::Eq(clipped_q, hn::Zero(d)))));
    power = hn::Max(power, norm);
    if (!counts.empty())
      hn::StoreInterleaved2(integers(d, clipped_i), integers(d, clipped_q), di, counts.data() + 2 * i);
  }
  tally.zero += sum_of(d, zeros);
  tally.saturated += sum_of(d, saturated);
  return {i, hn::GetLane(hn::MaxOfLanes(d, power))};
}

double tally_volts_on_target(std::span<const std::complex<double>> volts, ConversionTally& tally) {
  const Doubles d;
  const std::size_t lanes = hn::Lanes(d);
  const double* const from = reinterpret_cast<const double*>(volts.data());
  Vector zeros = hn::Zero(d);
  Vector not_numbers = hn::Zero(d);
  Vector power = hn::Zero(d);
  std::size_t i = 0;
  for (; i + lanes <= volts.size(); i += lanes) {
    Vector re = hn::Zero(d);
    Vector im = hn::Zero(d);
    hn::LoadInterleaved2(d, from + 2 * i, re, im);
    const Vector norm = hn::Add(hn::Mul(re, re), hn::Mul(im, im));
    zeros = hn::Add(zeros, ones(d, hn::And(hn::Eq(re, hn::Zero(d)), hn::Eq(im, hn::Zero(d)))));
    not_numbers = hn::Add(not_numbers, ones(d, hn::IsNaN(norm)));
    power = hn::IfThenElse(hn::Gt(norm, power), norm, power);
  }
  tally.zero += sum_of(d, zeros);
  tally.not_numbers += sum_of(d, not_numbers);
  double largest = hn::GetLane(hn::MaxOfLanes(d, power));
  for (; i < volts.size(); ++i) {
    const double norm = std::norm(volts[i]);
    if (volts[i] == 0.0) ++tally.zero;
    if (std::isnan(norm)) ++tally.not_numbers;
    largest = std::max(largest, norm);
  }
  return largest;
}

}  // namespace sarsim::radar::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace sarsim::radar {

HWY_EXPORT(convert_on_target);
HWY_EXPORT(tally_volts_on_target);

void ConversionTally::add(const ConversionTally& other) {
  maximum_v = std::max(maximum_v, other.maximum_v);
  saturated += other.saturated;
  zero += other.zero;
  not_numbers += other.not_numbers;
}

ConvertedPart convert_vectors(std::span<const std::complex<double>> volts, double per_volt, double lowest,
                              double highest, std::span<std::int64_t> counts, ConversionTally& tally) {
  CORE_EXPECT(counts.empty() || counts.size() == 2 * volts.size());
  CORE_EXPECT(std::isnormal(per_volt) && std::isnormal(1.0 / per_volt));
  CORE_EXPECT(lowest >= -largest_simd_count && highest <= largest_simd_count);
  return HWY_DYNAMIC_DISPATCH(convert_on_target)(volts, per_volt, lowest, highest, counts, tally);
}

void tally_volts(std::span<const std::complex<double>> volts, ConversionTally& tally) {
  const double largest = HWY_DYNAMIC_DISPATCH(tally_volts_on_target)(volts, tally);
  tally.maximum_v = std::max(tally.maximum_v, std::sqrt(largest));
}

}  // namespace sarsim::radar

#endif
