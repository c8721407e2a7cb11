#include "echo/spreading.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "echo/spreading.cpp"
#include <hwy/foreach_target.h>  // includes this file once per instruction set

#include "echo/simd_math-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace sarsim::HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR

// One lane holds no pair of a real and an imaginary part: plain loops.

template <class Real>
Real lane_value(const LanePolynomials<Real>& lanes, std::size_t lane, Real y) {
  Real sum = lanes.coefficients[lane];
  for (std::size_t p = 1; p <= lanes.degree; ++p) sum = sum * y + lanes.coefficients[p * lanes.lanes + lane];
  return sum;
}

template <class Real>
void spread_on_target(const LanePolynomials<Real>& taps, std::size_t width, std::span<const double> position,
                      std::span<const std::complex<Real>> strength, SpreadGrid<Real>& grid) {
  for (std::size_t k = 0; k < position.size(); ++k) {
    const double left = position[k] - 0.5 * static_cast<double>(width);
    const double cell = std::ceil(left);
    const auto y = static_cast<Real>(cell - left - 0.5);
    const auto at = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(cell) +
                                             static_cast<std::ptrdiff_t>(SpreadGrid<Real>::padding));
    for (std::size_t tap = 0; tap < width; ++tap) {
      const Real weight = lane_value(taps, 2 * tap, y);
      for (std::size_t r = 0; r < grid.term.size(); ++r)
        grid.term[r][at + tap] += weight * strength[r * position.size() + k];
    }
  }
}

template <class Real>
void add_edges_on_target(const EdgePiece<Real>& piece, std::span<const double> position,
                         std::span<const std::complex<Real>> strength, std::span<const double> doppler,
                         EdgeRow<Real>& row) {
  const std::size_t samples = piece.samples.lanes / 2;
  for (std::size_t k = 0; k < position.size(); ++k) {
    const double start = position[k] + piece.start;
    const double first = std::ceil(start - 1e-9);
    if (first <= -static_cast<double>(samples) || first >= static_cast<double>(row.count)) continue;
    const double fraction = std::max(0.0, first - start);
    const auto y = static_cast<Real>(fraction - 0.5);
    const auto at = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(first) +
                                             static_cast<std::ptrdiff_t>(EdgeRow<Real>::padding));
    for (std::size_t i = 0; i < samples; ++i) {
      std::complex<Real> z(lane_value(piece.samples, 2 * i, y), lane_value(piece.samples, 2 * i + 1, y));
      if (!doppler.empty()) {
        const double t = static_cast<double>(i) + fraction;
        const double turns = doppler[k] * (piece.doppler_offset + t * (piece.doppler_slope + t * piece.doppler_bend));
        z *= std::complex<Real>(std::polar(1.0, -6.283185307179586476925 * (turns - std::round(turns))));
      }
      row.samples[at + i] += strength[k] * z;
    }
  }
}

#else

// Even and odd powers by Horner's rule side by side, unrolled: half the chain of dependent operations. Degree 0 stands
// for one that is only known at run time.
template <std::size_t Degree, class D>
HWY_INLINE hn::Vec<D> polynomial(D d, const hn::TFromD<D>* HWY_RESTRICT coefficients, std::size_t stride,
                                 std::size_t degree, hn::Vec<D> y) {
  const std::size_t last = Degree > 0 ? Degree : degree;
  const auto y2 = hn::Mul(y, y);
  auto first = hn::LoadU(d, coefficients);
  auto second = hn::LoadU(d, coefficients + stride);
  std::size_t p = 2;
  for (; p + 1 <= last; p += 2) {
    first = hn::MulAdd(first, y2, hn::LoadU(d, coefficients + p * stride));
    second = hn::MulAdd(second, y2, hn::LoadU(d, coefficients + (p + 1) * stride));
  }
  if (p > last) return hn::MulAdd(first, y, second);
  return hn::MulAdd(second, y, hn::MulAdd(first, y2, hn::LoadU(d, coefficients + p * stride)));
}

#if HWY_HAVE_SCALABLE
#define SARSIM_HOLD_COEFFICIENTS 0  // vectors without a size known to the compiler cannot stand in arrays
#else
#define SARSIM_HOLD_COEFFICIENTS 1
#endif

// The polynomials of one vector of lanes; where degree and stride are known, their coefficients stay in registers.
template <std::size_t Degree, class D>
struct Polynomials {
  using T = hn::TFromD<D>;
  using V = hn::Vec<D>;
  const T* HWY_RESTRICT coefficients;
  std::size_t stride;
  std::size_t degree;
#if SARSIM_HOLD_COEFFICIENTS
  V held[Degree + 1];
#endif

  HWY_INLINE Polynomials(D d, const LanePolynomials<T>& all, std::size_t lane)
      : coefficients(all.coefficients.data() + lane), stride(all.lanes), degree(all.degree) {
#if SARSIM_HOLD_COEFFICIENTS
    if constexpr (Degree > 0)
      for (std::size_t p = 0; p <= Degree; ++p) held[p] = hn::LoadU(d, coefficients + p * stride);
#else
    (void)d;
#endif
  }

  HWY_INLINE V operator()(D d, V y) const {
#if SARSIM_HOLD_COEFFICIENTS
    if constexpr (Degree > 1) {
      const auto y2 = hn::Mul(y, y);
      auto first = held[0];
      auto second = held[1];
      for (std::size_t p = 2; p + 1 <= Degree; p += 2) {
        first = hn::MulAdd(first, y2, held[p]);
        second = hn::MulAdd(second, y2, held[p + 1]);
      }
      if constexpr (Degree % 2 == 1) return hn::MulAdd(first, y, second);
      return hn::MulAdd(second, y, hn::MulAdd(first, y2, held[Degree]));
    }
#endif
    return polynomial<Degree>(d, coefficients, stride, degree, y);
  }
};

// Calls f with the degree as a compile-time constant where it is a usual one.
template <class F>
HWY_INLINE void with_degree(std::size_t degree, const F& f) {
  switch (degree) {
    case 6: return f(std::integral_constant<std::size_t, 6>());
    case 7: return f(std::integral_constant<std::size_t, 7>());
    case 8: return f(std::integral_constant<std::size_t, 8>());
    case 9: return f(std::integral_constant<std::size_t, 9>());
    case 10: return f(std::integral_constant<std::size_t, 10>());
    case 11: return f(std::integral_constant<std::size_t, 11>());
    case 12: return f(std::integral_constant<std::size_t, 12>());
    case 13: return f(std::integral_constant<std::size_t, 13>());
    case 14: return f(std::integral_constant<std::size_t, 14>());
    case 15: return f(std::integral_constant<std::size_t, 15>());
    case 16: return f(std::integral_constant<std::size_t, 16>());
    default: return f(std::integral_constant<std::size_t, 0>());
  }
}

template <class Real, std::size_t Degree, std::size_t Chunks>
HWY_INLINE void spread_loop(const LanePolynomials<Real>& taps, std::size_t width, std::span<const double> position,
                            std::span<const std::complex<Real>> strength, SpreadGrid<Real>& grid) {
  const hn::ScalableTag<Real> d;
  constexpr std::ptrdiff_t padding = SpreadGrid<Real>::padding;
  const std::size_t lanes = hn::Lanes(d);
  const std::size_t chunks = Chunks > 0 ? Chunks : (2 * width + lanes - 1) / lanes;
  const std::size_t count = position.size();
  const std::size_t terms = grid.term.size();
  const double half_width = 0.5 * static_cast<double>(width);
  const Polynomials<Chunks == 1 ? Degree : 0, hn::ScalableTag<Real>> only(d, taps, 0);
  for (std::size_t k = 0; k < count; ++k) {
    const double left = position[k] - half_width;
    const double cell = std::ceil(left);
    const auto y = hn::Set(d, static_cast<Real>(cell - left - 0.5));
    const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(cell) + padding;
    for (std::size_t chunk = 0; chunk < chunks; ++chunk) {
      const std::size_t lane = chunk * lanes;
      const auto weight =
          Chunks == 1 ? only(d, y) : polynomial<Degree>(d, taps.coefficients.data() + lane, taps.lanes, taps.degree, y);
      for (std::size_t r = 0; r < terms; ++r) {
        const std::complex<Real> s = strength[r * count + k];
        const auto pair = hn::OddEven(hn::Set(d, s.imag()), hn::Set(d, s.real()));
        Real* HWY_RESTRICT out = reinterpret_cast<Real*>(grid.term[r].data() + at) + lane;
        hn::StoreU(hn::MulAdd(weight, pair, hn::LoadU(d, out)), d, out);
      }
    }
  }
}

template <class Real>
HWY_INLINE void spread_on_target(const LanePolynomials<Real>& taps, std::size_t width, std::span<const double> position,
                                 std::span<const std::complex<Real>> strength, SpreadGrid<Real>& grid) {
  const std::size_t lanes = hn::Lanes(hn::ScalableTag<Real>());
  const std::size_t chunks = (2 * width + lanes - 1) / lanes;
  with_degree(taps.degree, [&](auto degree) {
    if (chunks == 1)
      spread_loop<Real, degree(), 1>(taps, width, position, strength, grid);
    else if (chunks == 2)
      spread_loop<Real, degree(), 2>(taps, width, position, strength, grid);
    else
      spread_loop<Real, degree(), 0>(taps, width, position, strength, grid);
  });
}

// Interleaved complex numbers times (re, im): re in both lanes of a pair, im with the sign that its lane takes.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V complex_product(D d, V pairs, V re, V signed_im) {
  return hn::MulAdd(pairs, re, hn::Mul(hn::Reverse2(d, pairs), signed_im));
}

// -1 in even lanes, +1 in odd ones.
template <class D>
HWY_INLINE hn::Vec<D> pair_signs(D d) {
  using T = hn::TFromD<D>;
  return hn::OddEven(hn::Set(d, T(1)), hn::Set(d, T(-1)));
}

// Number of the sample that each lane from `lane` on belongs to.
template <class D>
HWY_INLINE hn::Vec<D> sample_numbers(D d, std::size_t lane) {
  using T = hn::TFromD<D>;
  const auto twice = hn::Iota(d, static_cast<T>(lane));
  return hn::Mul(hn::OddEven(hn::Sub(twice, hn::Set(d, T(1))), twice), hn::Set(d, T(0.5)));
}

// The Doppler phasors of the samples of an edge piece of one echo.
template <class Real>
struct EdgeTurn {
  double turns = 0.0;
  Real slope = 0;
  Real bend = 0;

  EdgeTurn(const EdgePiece<Real>& piece, double doppler, double fraction) {
    turns = doppler * (piece.doppler_offset + fraction * (piece.doppler_slope + fraction * piece.doppler_bend));
    turns -= std::round(turns);
    slope = static_cast<Real>(doppler * (piece.doppler_slope + 2.0 * fraction * piece.doppler_bend));
    bend = static_cast<Real>(doppler * piece.doppler_bend);
  }

  template <class D, class V = hn::Vec<D>>
  HWY_INLINE V applied(D d, std::size_t lane, V pairs) const {
    const auto i = sample_numbers(d, lane);
    const auto rest = hn::Mul(i, hn::MulAdd(i, hn::Set(d, bend), hn::Set(d, slope)));
    const auto x = fraction_of_turn(hn::Neg(hn::Add(hn::Set(d, static_cast<Real>(turns)), rest)));
    auto c = hn::Zero(d);
    auto s = hn::Zero(d);
    cos_sin_turns(d, x, c, s);
    return complex_product(d, pairs, c, hn::Mul(s, pair_signs(d)));
  }
};

template <class Real, std::size_t Degree, bool OneVector>
HWY_INLINE void edge_loop(const EdgePiece<Real>& piece, std::span<const double> position,
                          std::span<const std::complex<Real>> strength, std::span<const double> doppler,
                          EdgeRow<Real>& row) {
  const hn::ScalableTag<Real> d;
  const std::size_t lanes = hn::Lanes(d);
  const Real* HWY_RESTRICT coefficients = piece.samples.coefficients.data();
  const std::size_t used = OneVector ? lanes : piece.samples.lanes;
  const Polynomials<OneVector ? Degree : 0, hn::ScalableTag<Real>> only(d, piece.samples, 0);
  const double first_useful = -0.5 * static_cast<double>(piece.samples.lanes);
  const auto last_useful = static_cast<double>(row.count);
  constexpr std::ptrdiff_t padding = EdgeRow<Real>::padding;
  const auto signs = pair_signs(d);
  for (std::size_t k = 0; k < position.size(); ++k) {
    const double start = position[k] + piece.start;
    const double sample = std::ceil(start - 1e-9);
    if (sample <= first_useful || sample >= last_useful) continue;
    const double fraction = std::max(0.0, sample - start);
    const auto y = hn::Set(d, static_cast<Real>(fraction - 0.5));
    const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(sample) + padding;
    const auto s_re = hn::Set(d, strength[k].real());
    const auto s_im = hn::Mul(hn::Set(d, strength[k].imag()), signs);
    Real* HWY_RESTRICT out = reinterpret_cast<Real*>(row.samples.data() + at);
    for (std::size_t lane = 0; lane < used; lane += lanes) {
      auto pairs = OneVector ? only(d, y)
                             : polynomial<Degree>(d, coefficients + lane, piece.samples.lanes, piece.samples.degree, y);
      if (!doppler.empty()) pairs = EdgeTurn<Real>(piece, doppler[k], fraction).applied(d, lane, pairs);
      hn::StoreU(hn::Add(hn::LoadU(d, out + lane), complex_product(d, pairs, s_re, s_im)), d, out + lane);
    }
  }
}

template <class Real>
HWY_INLINE void add_edges_on_target(const EdgePiece<Real>& piece, std::span<const double> position,
                                    std::span<const std::complex<Real>> strength, std::span<const double> doppler,
                                    EdgeRow<Real>& row) {
  const bool one_vector = hn::Lanes(hn::ScalableTag<Real>()) == piece.samples.lanes;
  with_degree(piece.samples.degree, [&](auto degree) {
    if (one_vector)
      edge_loop<Real, degree(), true>(piece, position, strength, doppler, row);
    else
      edge_loop<Real, degree(), false>(piece, position, strength, doppler, row);
  });
}

#endif  // HWY_SCALAR

void spread_single(const LanePolynomials<float>& taps, std::size_t width, std::span<const double> position,
                   std::span<const std::complex<float>> strength, SpreadGrid<float>& grid) {
  spread_on_target(taps, width, position, strength, grid);
}
void spread_double(const LanePolynomials<double>& taps, std::size_t width, std::span<const double> position,
                   std::span<const std::complex<double>> strength, SpreadGrid<double>& grid) {
  spread_on_target(taps, width, position, strength, grid);
}
void edges_single(const EdgePiece<float>& piece, std::span<const double> position,
                  std::span<const std::complex<float>> strength, std::span<const double> doppler, EdgeRow<float>& row) {
  add_edges_on_target(piece, position, strength, doppler, row);
}
void edges_double(const EdgePiece<double>& piece, std::span<const double> position,
                  std::span<const std::complex<double>> strength, std::span<const double> doppler,
                  EdgeRow<double>& row) {
  add_edges_on_target(piece, position, strength, doppler, row);
}

}  // namespace sarsim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace sarsim {

HWY_EXPORT(spread_single);
HWY_EXPORT(spread_double);
HWY_EXPORT(edges_single);
HWY_EXPORT(edges_double);

template <>
void spread(const LanePolynomials<float>& taps, std::size_t width, std::span<const double> position,
            std::span<const std::complex<float>> strength, SpreadGrid<float>& grid) {
  HWY_DYNAMIC_DISPATCH(spread_single)(taps, width, position, strength, grid);
}
template <>
void spread(const LanePolynomials<double>& taps, std::size_t width, std::span<const double> position,
            std::span<const std::complex<double>> strength, SpreadGrid<double>& grid) {
  HWY_DYNAMIC_DISPATCH(spread_double)(taps, width, position, strength, grid);
}
template <>
void add_edges(const EdgePiece<float>& piece, std::span<const double> position,
               std::span<const std::complex<float>> strength, std::span<const double> doppler, EdgeRow<float>& row) {
  HWY_DYNAMIC_DISPATCH(edges_single)(piece, position, strength, doppler, row);
}
template <>
void add_edges(const EdgePiece<double>& piece, std::span<const double> position,
               std::span<const std::complex<double>> strength, std::span<const double> doppler, EdgeRow<double>& row) {
  HWY_DYNAMIC_DISPATCH(edges_double)(piece, position, strength, doppler, row);
}

}  // namespace sarsim

#endif
