// Look-up of tabulated curves in vectors; included once per instruction set (Highway's foreach_target).

#if defined(SARSIM_SIMD_CURVES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SARSIM_SIMD_CURVES_INL
#undef SARSIM_SIMD_CURVES_INL
#else
#define SARSIM_SIMD_CURVES_INL
#endif

#include <hwy/highway.h>

#include "echo/curve_tables.hpp"
#include "echo/simd_math-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace sarsim::HWY_NAMESPACE {

/// The curves' values, to the tables' tolerance.
/// @param first_cell  number of the table times `cells`
/// @param degrees     brought into 0 to 180
template <class D, class VI, class V = hn::Vec<D>>
HWY_INLINE V curve_value(D d, const CurveTables& tables, VI first_cell, V degrees) {
  const hn::RebindToSigned<D> di;
  const hn::Rebind<std::int32_t, D> short_int;
  const auto cells = static_cast<double>(tables.cells);
  const V x = hn::IfThenElseZero(hn::Gt(degrees, hn::Zero(d)), hn::Min(degrees, hn::Set(d, 180.0)));
  const V cell = hn::Min(hn::Mul(x, hn::Set(d, cells / 180.0)), hn::Set(d, cells - 1.0));
  const VI place = hn::Add(first_cell, hn::PromoteTo(di, hn::DemoteTo(short_int, cell)));
  VI record = hn::GatherIndex(di, tables.cell_record.data(), place);
  const double* const records = tables.records.data();
  for (std::size_t stride = tables.first_stride; stride > 0; stride /= 2) {
    const VI next = hn::Add(record, hn::Set(di, static_cast<std::int64_t>(stride * tables.record_size())));
    const auto reached = hn::Ge(x, hn::GatherIndex(d, records + CurveTables::left_end, next));
    record = hn::IfThenElse(hn::RebindMask(di, reached), next, record);
  }
  const V t = hn::Sub(x, hn::GatherIndex(d, records + CurveTables::centre, record));
  V sum = hn::GatherIndex(d, records + CurveTables::coefficients + tables.degree, record);
  for (std::size_t k = tables.degree; k-- > 0;)
    sum = hn::MulAdd(sum, t, hn::GatherIndex(d, records + CurveTables::coefficients + k, record));
  return sum;
}

}  // namespace sarsim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
