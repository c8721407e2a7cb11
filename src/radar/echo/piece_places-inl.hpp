// Places of echoes on polynomials by pieces, and these polynomials, in SIMD; included once per instruction set
// (Highway's foreach_target).

#if defined(SARSIM_PIECE_PLACES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SARSIM_PIECE_PLACES_INL
#undef SARSIM_PIECE_PLACES_INL
#else
#define SARSIM_PIECE_PLACES_INL
#endif

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <type_traits>

#include "radar/echo/lane_polynomials.hpp"
#include "radar/simd/math-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace sarsim::radar::HWY_NAMESPACE {

// Where a block of echoes goes: for each the first sample or cell it touches, and what of the table of polynomials
// belongs to its fraction.
template <class Real>
struct Places {
  static constexpr std::size_t most = 64;
  HWY_ALIGN Real y[most];
  HWY_ALIGN Real fraction[most];  // of a sample, to that first sample
  HWY_ALIGN std::int32_t cell[most];
  HWY_ALIGN std::int32_t table[most];  // offset of the piece's coefficients
  HWY_ALIGN Real tilt[most];           // what the strength of the second of two terms is of that of the first
};

// Whole numbers as integers.
template <class D>
HWY_INLINE void store_integers([[maybe_unused]] D d, hn::Vec<D> whole, std::int32_t* HWY_RESTRICT out) {
  const hn::Rebind<std::int32_t, D> narrow;
  hn::StoreU(hn::DemoteTo(narrow, whole), narrow, out);
}

template <class Real, class D, class V = hn::Vec<D>>
HWY_INLINE void store_narrow([[maybe_unused]] D d, V x, Real* HWY_RESTRICT out) {
  if constexpr (sizeof(Real) == 4) {
    const hn::Rebind<float, D> narrow;
    hn::StoreU(hn::DemoteTo(narrow, x), narrow, out);
  } else {
    hn::Store(x, d, out);
  }
}

template <class Real, class D>
HWY_INLINE hn::Vec<D> load_wide(D d, const Real* HWY_RESTRICT from) {
  if constexpr (sizeof(Real) == 4) return hn::PromoteTo(d, hn::LoadU(hn::Rebind<float, D>(), from));
  if constexpr (sizeof(Real) == 8) return hn::Load(d, from);
}

// Whole numbers of at most 2^22 as integers.
template <class D>
HWY_INLINE hn::Vec<hn::RebindToSigned<D>> small_integers(D d, hn::Vec<D> whole) {
  const hn::RebindToSigned<D> integer;
  const auto magic = hn::Set(d, 12582912.0F);  // 3 2^22, whose last bit is that of 1
  return hn::Sub(hn::BitCast(integer, hn::Add(whole, magic)), hn::BitCast(integer, magic));
}

// For `fraction` in [0, 1) of a block: the pieces and the positions inside, from their middles.
template <class Real>
HWY_INLINE void place_on_pieces(const LanePolynomials<Real>& lanes, std::size_t count, Places<Real>& out) {
  const hn::ScalableTag<Real> d;
  const auto pieces = hn::Set(d, static_cast<Real>(lanes.pieces));
  const auto last = hn::Set(d, static_cast<Real>(lanes.pieces - 1));
  const auto stride = hn::Set(d, static_cast<Real>((lanes.degree + 1) * lanes.lanes));
  const auto half = hn::Set(d, Real(0.5));
  for (std::size_t k = 0; k < count; k += hn::Lanes(d)) {
    const auto along = hn::MulSub(hn::Load(d, out.fraction + k), pieces, half);
    const auto piece = hn::Max(hn::Zero(d), hn::Min(hn::Round(along), last));
    hn::Store(hn::Sub(along, piece), d, out.y + k);
    const auto table = hn::Mul(piece, stride);
    if constexpr (sizeof(Real) == 4)
      hn::Store(small_integers(d, table), hn::RebindToSigned<decltype(d)>(), out.table + k);
    if constexpr (sizeof(Real) == 8) store_integers(d, table, out.table + k);
  }
}

// The values [first, first + count): where they stand if they fill whole vectors, else a padded copy in `buffer`.
HWY_INLINE const double* whole_vectors(std::span<const double> values, std::size_t first, std::size_t count,
                                       double* HWY_RESTRICT buffer) {
  const std::size_t lanes = hn::Lanes(hn::ScalableTag<double>());
  const double* const from = values.data() + first;
  if (count % lanes == 0) return from;
  std::copy_n(from, count, buffer);
  for (; count % lanes != 0; ++count) buffer[count] = buffer[0];
  return buffer;
}

#if HWY_TARGET != HWY_SCALAR

// Polynomials of one degree by Horner's rule. Degree and Lanes, all those of a piece, are 0 where they are only known
// at run time.
template <class Real, std::size_t Degree, std::size_t Lanes>
struct Polynomials {
  const Real* HWY_RESTRICT coefficients;
  std::size_t lanes;
  std::size_t degree;

  HWY_INLINE explicit Polynomials(const LanePolynomials<Real>& all)
      : coefficients(all.coefficients.data()),
        lanes(Lanes > 0 ? Lanes : all.lanes),
        degree(Degree > 0 ? Degree : all.degree) {}

  // Of the lanes of a vector from `lane` on; `table` counts the coefficients before the piece's.
  template <class D>
  HWY_INLINE hn::Vec<D> at(D d, std::int32_t table, std::size_t lane, hn::Vec<D> y) const {
    const Real* HWY_RESTRICT from = coefficients + table + lane;
    const std::size_t last = Degree > 0 ? Degree : degree;
    const std::size_t stride = Lanes > 0 ? Lanes : lanes;
    auto sum = hn::Load(d, from);
    for (std::size_t p = 1; p <= last; ++p) sum = hn::MulAdd(sum, y, hn::Load(d, from + p * stride));
    return sum;
  }
};

#endif  // HWY_SCALAR

// Calls f with the degree and the number of lanes as compile-time constants where they are those of nearly all work: in
// single precision, kernels and edges for the tolerances that it is used for have 16 lanes and a low degree
// (SpectralSettings). Others cost compile time and are rare.
template <class Real, class F>
HWY_INLINE void with_shape(const LanePolynomials<Real>& lanes, const F& f) {
  constexpr std::integral_constant<std::size_t, 16> usual;
  using Any = std::integral_constant<std::size_t, 0>;
  if constexpr (sizeof(Real) == 4 && HWY_LANES(Real) > 1) {
    if (lanes.lanes == usual()) switch (lanes.degree) {
        case 3: return f(std::integral_constant<std::size_t, 3>(), usual);
        case 4: return f(std::integral_constant<std::size_t, 4>(), usual);
        case 5: return f(std::integral_constant<std::size_t, 5>(), usual);
        default: break;
      }
  }
  f(Any(), Any());
}

#if HWY_TARGET != HWY_SCALAR

// One complex number in all pairs of lanes.
template <class D>
HWY_INLINE hn::Vec<D> in_all_pairs(D d, const hn::TFromD<D>* at) {
  if constexpr (sizeof(hn::TFromD<D>) == 4) {
    double both;
    std::memcpy(&both, at, sizeof both);
    return hn::BitCast(d, hn::Set(hn::Repartition<double, D>(), both));
  } else {
    return hn::LoadDup128(d, at);
  }
}

// Calls f(lane, vector) with vectors that hold each lane of `weights` twice, for the real and the imaginary part that
// it weighs: one vector where there are twice as many lanes as those, or two.
template <class D, class F>
HWY_INLINE void each_twice(D d, hn::Vec<D> weights, const F& f) {
  using T = hn::TFromD<D>;
  using Index = hwy::MakeSigned<T>;
  constexpr std::size_t lanes = hn::MaxLanes(d);
  HWY_ALIGN static constexpr Index twice[] = {0, 0, 1, 1, 2,  2,  3,  3,  4,  4,  5,  5,  6,  6,  7,  7,
                                              8, 8, 9, 9, 10, 10, 11, 11, 12, 12, 13, 13, 14, 14, 15, 15};
  if constexpr (2 * lanes <= HWY_LANES(T)) {
    const hn::CappedTag<T, 2 * lanes> wide;
    f(0, hn::TableLookupLanes(hn::ZeroExtendVector(wide, weights), hn::SetTableIndices(wide, twice)));
  } else if constexpr (lanes * sizeof(T) > 16) {
    f(0, hn::TableLookupLanes(weights, hn::SetTableIndices(d, twice)));
    f(lanes, hn::TableLookupLanes(weights, hn::SetTableIndices(d, twice + lanes)));
  } else {
    f(0, hn::InterleaveLower(d, weights, weights));
    f(lanes, hn::InterleaveUpper(d, weights, weights));
  }
}

// Adds weights times a complex number, which is in all pairs of the lanes of the widest vectors, to complex numbers.
template <class D, class V>
HWY_INLINE void add_weighted(D d, hn::Vec<D> weights, V pair, hn::TFromD<D>* HWY_RESTRICT out) {
  const hn::CappedTag<hn::TFromD<D>, std::min<std::size_t>(2 * hn::MaxLanes(D()), HWY_LANES(hn::TFromD<D>))> wide;
  each_twice(d, weights, [&](std::size_t lane, auto each) {
    hn::StoreU(hn::MulAdd(each, pair, hn::LoadU(wide, out + lane)), wide, out + lane);
  });
}

#endif  // HWY_SCALAR

}  // namespace sarsim::radar::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
