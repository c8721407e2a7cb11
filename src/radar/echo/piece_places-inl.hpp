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
#include <type_traits>

#include "radar/echo/spreading.hpp"
#include "radar/simd/math-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace sarsim::radar::HWY_NAMESPACE {

// Where a block of echoes goes: for each the first sample or cell it touches, and what of the table of polynomials
// belongs to its fraction.
template <class Real>
struct Places {
  static constexpr std::size_t most = 64;
  HWY_ALIGN Real y[most];
  HWY_ALIGN double fraction[most];  // of a sample, to that first sample
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

// `x` in [0, 1): the piece of it and the position inside.
template <class Real, class D, class V = hn::Vec<D>>
HWY_INLINE void place_on_pieces(D d, V x, const LanePolynomials<Real>& lanes, std::size_t k, Places<Real>& out) {
  const auto pieces = static_cast<double>(lanes.pieces);
  const auto scaled = hn::Mul(x, hn::Set(d, pieces));
  const auto piece = hn::Min(hn::Floor(scaled), hn::Set(d, pieces - 1.0));
  const auto y = hn::Sub(hn::Sub(scaled, piece), hn::Set(d, 0.5));
  store_integers(d, hn::Mul(piece, hn::Set(d, static_cast<double>((lanes.degree + 1) * lanes.lanes))), out.table + k);
  store_narrow(d, y, out.y + k);
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

// Polynomials of one degree by Horner's rule. Degree and Chunks, the vectors that the lanes fill, are 0 where they are
// only known at run time.
template <class Real, std::size_t Degree, std::size_t Chunks>
struct Polynomials {
  using D = hn::ScalableTag<Real>;
  const Real* HWY_RESTRICT coefficients;
  std::size_t lanes;
  std::size_t chunks;
  std::size_t degree;

  HWY_INLINE explicit Polynomials(const LanePolynomials<Real>& all)
      : coefficients(all.coefficients.data()),
        lanes(Chunks > 0 ? Chunks * hn::Lanes(D()) : all.lanes),
        chunks(Chunks > 0 ? Chunks : all.lanes / hn::Lanes(D())),
        degree(Degree > 0 ? Degree : all.degree) {}

  // Of the lanes of one vector; `table` counts the coefficients before the piece's.
  HWY_INLINE hn::Vec<D> at(std::int32_t table, std::size_t chunk, hn::Vec<D> y) const {
    const D d;
    const Real* HWY_RESTRICT from = coefficients + table + chunk * hn::Lanes(d);
    const std::size_t last = Degree > 0 ? Degree : degree;
    const std::size_t stride = Chunks > 0 ? Chunks * hn::Lanes(d) : lanes;
    auto sum = hn::LoadU(d, from);
    for (std::size_t p = 1; p <= last; ++p) sum = hn::MulAdd(sum, y, hn::LoadU(d, from + p * stride));
    return sum;
  }
};

#endif  // HWY_SCALAR

// Calls f with the degree and the number of vectors as compile-time constants where they are those of nearly all work:
// in single precision, kernels and edges for the tolerances that it is used for have 16 lanes and a low degree
// (SpectralSettings). Others cost compile time and are rare.
template <class Real, class F>
HWY_INLINE void with_shape(const LanePolynomials<Real>& lanes, const F& f) {
  constexpr std::size_t lane_count = HWY_LANES(Real);
  constexpr std::size_t usual_lanes = 16;
  using Any = std::integral_constant<std::size_t, 0>;
  if constexpr (sizeof(Real) == 4 && lane_count > 1) {
    constexpr std::integral_constant<std::size_t, usual_lanes / lane_count> chunks;
    if (lanes.lanes == usual_lanes) switch (lanes.degree) {
        case 3: return f(std::integral_constant<std::size_t, 3>(), chunks);
        case 4: return f(std::integral_constant<std::size_t, 4>(), chunks);
        case 5: return f(std::integral_constant<std::size_t, 5>(), chunks);
        default: break;
      }
  }
  f(Any(), Any());
}

}  // namespace sarsim::radar::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
