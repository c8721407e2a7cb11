#include "echo/spreading.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "echo/spreading.cpp"
#include <hwy/foreach_target.h>  // includes this file once per instruction set

#include "echo/simd_math-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace sarsim::HWY_NAMESPACE {

template <class D>
HWY_INLINE hn::Vec<D> horner(D d, const hn::TFromD<D>* HWY_RESTRICT coefficients, std::size_t stride,
                             std::size_t degree, hn::Vec<D> y) {
  auto sum = hn::LoadU(d, coefficients);
  for (std::size_t p = 1; p <= degree; ++p) sum = hn::MulAdd(sum, y, hn::LoadU(d, coefficients + p * stride));
  return sum;
}

template <class Real>
HWY_INLINE void spread_on_target(const LanePolynomials<Real>& taps, std::size_t width, std::span<const double> position,
                                 std::span<const std::complex<Real>> strength, SpreadGrid<Real>& grid) {
  const hn::ScalableTag<Real> d;
  const std::size_t lanes = hn::Lanes(d);
  const std::size_t used = (2 * width + lanes - 1) / lanes * lanes;
  const std::size_t count = position.size();
  const double half_width = 0.5 * static_cast<double>(width);
  for (std::size_t k = 0; k < count; ++k) {
    const double left = position[k] - half_width;
    const double cell = std::ceil(left);
    const auto y = hn::Set(d, static_cast<Real>(cell - left - 0.5));
    const auto at = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(cell) +
                                             static_cast<std::ptrdiff_t>(SpreadGrid<Real>::padding));
    for (std::size_t lane = 0; lane < used; lane += lanes) {
      const auto weight = horner(d, taps.coefficients.data() + lane, taps.lanes, taps.degree, y);
      for (std::size_t r = 0; r < grid.term.size(); ++r) {
        const std::complex<Real> s = strength[r * count + k];
        const auto re = hn::Set(d, s.real());
        const auto im = hn::Set(d, s.imag());
        const auto pair = hn::OddEven(im, re);
        Real* HWY_RESTRICT out = reinterpret_cast<Real*>(grid.term[r].data() + at) + lane;
        hn::StoreU(hn::MulAdd(weight, pair, hn::LoadU(d, out)), d, out);
      }
    }
  }
}

template <class Real>
HWY_INLINE void add_edges_on_target(const EdgePiece<Real>& piece, std::span<const double> position,
                                    std::span<const std::complex<Real>> strength, std::span<const double> doppler,
                                    EdgeRow<Real>& row) {
  const hn::ScalableTag<Real> d;
  const std::size_t lanes = hn::Lanes(d);
  const double first_useful = -static_cast<double>(piece.re.lanes);
  const auto last_useful = static_cast<double>(row.count);
  for (std::size_t k = 0; k < position.size(); ++k) {
    const double start = position[k] + piece.start;
    const double sample = std::ceil(start - 1e-9);
    if (sample <= first_useful || sample >= last_useful) continue;
    const double fraction = std::max(0.0, sample - start);
    const auto y = hn::Set(d, static_cast<Real>(fraction - 0.5));
    const auto at = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(sample) +
                                             static_cast<std::ptrdiff_t>(EdgeRow<Real>::padding));
    const auto s_re = hn::Set(d, strength[k].real());
    const auto s_im = hn::Set(d, strength[k].imag());
    for (std::size_t lane = 0; lane < piece.re.lanes; lane += lanes) {
      auto e_re = horner(d, piece.re.coefficients.data() + lane, piece.re.lanes, piece.re.degree, y);
      auto e_im = horner(d, piece.im.coefficients.data() + lane, piece.im.lanes, piece.im.degree, y);
      if (!doppler.empty()) {
        const double turns =
            doppler[k] * (piece.doppler_offset + fraction * (piece.doppler_slope + fraction * piece.doppler_bend));
        const double slope = doppler[k] * (piece.doppler_slope + 2.0 * fraction * piece.doppler_bend);
        const double bend = doppler[k] * piece.doppler_bend;
        const auto i = hn::Iota(d, static_cast<Real>(lane));
        const auto rest =
            hn::Mul(i, hn::MulAdd(i, hn::Set(d, static_cast<Real>(bend)), hn::Set(d, static_cast<Real>(slope))));
        const auto x =
            fraction_of_turn(hn::Neg(hn::Add(hn::Set(d, static_cast<Real>(turns - std::round(turns))), rest)));
        auto c = hn::Zero(d);
        auto s = hn::Zero(d);
        cos_sin_turns(d, x, c, s);
        const auto turned = hn::NegMulAdd(e_im, s, hn::Mul(e_re, c));
        e_im = hn::MulAdd(e_im, c, hn::Mul(e_re, s));
        e_re = turned;
      }
      Real* HWY_RESTRICT re = row.re.data() + at + lane;
      Real* HWY_RESTRICT im = row.im.data() + at + lane;
      hn::StoreU(hn::NegMulAdd(s_im, e_im, hn::MulAdd(s_re, e_re, hn::LoadU(d, re))), d, re);
      hn::StoreU(hn::MulAdd(s_im, e_re, hn::MulAdd(s_re, e_im, hn::LoadU(d, im))), d, im);
    }
  }
}

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
