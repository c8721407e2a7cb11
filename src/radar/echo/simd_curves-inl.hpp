// Look-up of tabulated curves in vectors; included once per instruction set (Highway's foreach_target).

#if defined(SARSIM_SIMD_CURVES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SARSIM_SIMD_CURVES_INL
#undef SARSIM_SIMD_CURVES_INL
#else
#define SARSIM_SIMD_CURVES_INL
#endif

#include <hwy/highway.h>

#include "radar/echo/curve_tables.hpp"
#include "radar/simd/math-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace sarsim::radar::HWY_NAMESPACE {

/// base[index] to base[index + 3] of every lane.
template <class D, class VI, class V = hn::Vec<D>>
HWY_INLINE void four_of(D d, const double* base, VI index, V (&out)[4]) {
#if HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX3_DL
  // Whole records and a transposition, which takes less time than four gathers.
  const hn::RebindToSigned<D> di;
  const hn::FixedTag<double, 4> four;
  HWY_ALIGN std::int64_t at[hn::MaxLanes(d)];
  hn::Store(index, di, at);
  const auto pair = [&](std::size_t i) {
#if HWY_TARGET == HWY_AVX2
    return hn::LoadU(four, base + at[i]);
#else
    return hn::Combine(d, hn::LoadU(four, base + at[i + 4]), hn::LoadU(four, base + at[i]));
#endif
  };
  const V a = pair(0);
  const V b = pair(1);
  const V c = pair(2);
  const V e = pair(3);
  const V even_ab = hn::InterleaveLower(d, a, b);  // numbers 0 and 2 of two lanes each
  const V odd_ab = hn::InterleaveUpper(d, a, b);   // numbers 1 and 3
  const V even_ce = hn::InterleaveLower(d, c, e);
  const V odd_ce = hn::InterleaveUpper(d, c, e);
  out[0] = hn::OddEvenBlocks(hn::SwapAdjacentBlocks(even_ce), even_ab);
  out[1] = hn::OddEvenBlocks(hn::SwapAdjacentBlocks(odd_ce), odd_ab);
  out[2] = hn::OddEvenBlocks(even_ce, hn::SwapAdjacentBlocks(even_ab));
  out[3] = hn::OddEvenBlocks(odd_ce, hn::SwapAdjacentBlocks(odd_ab));
#else
  for (std::size_t k = 0; k < 4; ++k) out[k] = hn::GatherIndex(d, base + k, index);
#endif
}

/// The curves' values, to the tables' tolerance.
/// @param first_cell  number of each lane's table times `cells`
/// @param degrees     brought into the angles of the tables
template <class D, class V = hn::Vec<D>>
HWY_NOINLINE V curve_value(D d, const CurveTables& tables, V first_cell, V degrees) {
  const hn::RebindToSigned<D> di;
  const hn::Rebind<std::int32_t, D> short_int;
  const auto cells = static_cast<double>(tables.cells);
  const V from = hn::Sub(degrees, hn::Set(d, tables.first_deg));
  const V x = hn::IfThenElseZero(hn::Gt(from, hn::Zero(d)), hn::Min(from, hn::Set(d, tables.span_deg)));
  const V cell = hn::Min(hn::Floor(hn::Mul(x, hn::Set(d, cells / tables.span_deg))), hn::Set(d, cells - 1.0));
  const V place = hn::Mul(hn::Add(first_cell, cell), hn::Set(d, static_cast<double>(tables.cell_stride())));
  auto record = hn::PromoteTo(di, hn::DemoteTo(short_int, place));
  if (tables.crowded) record = hn::GatherIndex(di, tables.cell_record.data(), record);
  const double* const records = tables.records.data();
  for (std::size_t stride = tables.first_stride; stride > 0; stride /= 2) {
    const auto next = hn::Add(record, hn::Set(di, static_cast<std::int64_t>(stride * tables.record_size())));
    const auto reached = hn::Ge(x, hn::GatherIndex(d, records + CurveTables::left_end, next));
    record = hn::IfThenElse(hn::RebindMask(di, reached), next, record);
  }
  static_assert(CurveTables::centre == 1 && CurveTables::coefficients == 2);
  const V zero = hn::Zero(d);
  V low[4] = {zero, zero, zero, zero};
  four_of(d, records, record, low);
  const V middle = hn::Mul(hn::Add(cell, hn::Set(d, 0.5)), hn::Set(d, tables.span_deg / cells));
  const V t = hn::Sub(x, tables.crowded ? low[1] : middle);
  if (tables.degree == 1) return hn::MulAdd(low[3], t, low[2]);
  V high[4] = {zero, zero, zero, zero};
  four_of(d, records + 4, record, high);
  V sum = hn::MulAdd(high[3], t, high[2]);
  sum = hn::MulAdd(sum, t, high[1]);
  sum = hn::MulAdd(sum, t, high[0]);
  sum = hn::MulAdd(sum, t, low[3]);
  return hn::MulAdd(sum, t, low[2]);
}

}  // namespace sarsim::radar::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
