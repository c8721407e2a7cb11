// A tone in SIMD, alone or times a factor for each sample; included once per instruction set (Highway's
// foreach_target).

#if defined(SARSIM_TONE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SARSIM_TONE_INL
#undef SARSIM_TONE_INL
#else
#define SARSIM_TONE_INL
#endif

#include <algorithm>
#include <cmath>

#include "radar/echo/tone.hpp"
#include "radar/simd/math-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace sarsim::radar::HWY_NAMESPACE {

// Phasors of the middles of consecutive vectors of `lanes` samples, times the amplitude.
template <class T>
HWY_INLINE void vector_phasors(const Tone& tone, std::size_t lanes, std::size_t vectors, T* HWY_RESTRICT turn_re,
                               T* HWY_RESTRICT turn_im) {
  const hn::ScalableTag<double> dd;
  const hn::Rebind<T, hn::ScalableTag<double>> narrow;
  const double first = static_cast<double>(tone.begin) + 0.5 * static_cast<double>(lanes - 1) - tone.centre;
  const auto alpha = hn::Set(dd, tone.alpha);
  const auto beta = hn::Set(dd, tone.beta);
  const auto gamma = hn::Set(dd, tone.gamma);
  const auto step = hn::Set(dd, static_cast<double>(lanes));
  for (std::size_t v = 0; v < vectors; v += hn::Lanes(dd)) {
    const auto m = hn::MulAdd(hn::Iota(dd, static_cast<double>(v)), step, hn::Set(dd, first));
    const auto turns = fraction_of_turn(hn::MulAdd(hn::MulAdd(gamma, m, beta), m, alpha));
    if constexpr (sizeof(T) == 4)
      hn::StoreU(hn::DemoteTo(narrow, turns), narrow, turn_re + v);
    else
      hn::StoreU(turns, dd, turn_re + v);
  }
  const hn::ScalableTag<T> d;
  const auto amplitude = hn::Set(d, static_cast<T>(tone.amplitude));
  for (std::size_t v = 0; v < vectors; v += hn::Lanes(d)) {
    auto c = hn::Zero(d);
    auto s = hn::Zero(d);
    cos_sin_turns(d, hn::LoadU(d, turn_re + v), c, s);
    hn::StoreU(hn::Mul(c, amplitude), d, turn_re + v);
    hn::StoreU(hn::Mul(s, amplitude), d, turn_im + v);
  }
}

// Powers of the tone's step about the middle of a vector: exp(2 pi j (slope l + gamma l^2)), l = lane - middle.
template <class T>
HWY_INLINE void lane_phasors(double slope, double gamma, std::size_t lanes, T* HWY_RESTRICT re, T* HWY_RESTRICT im) {
  const hn::ScalableTag<double> dd;
  const double middle = 0.5 * static_cast<double>(lanes - 1);
  for (std::size_t l = 0; l < lanes; l += hn::Lanes(dd)) {
    const auto offset = hn::Sub(hn::Iota(dd, static_cast<double>(l)), hn::Set(dd, middle));
    const auto x = fraction_of_turn(hn::Mul(hn::MulAdd(hn::Set(dd, gamma), offset, hn::Set(dd, slope)), offset));
    auto c = hn::Zero(dd);
    auto s = hn::Zero(dd);
    cos_sin_turns(dd, x, c, s);
    if constexpr (sizeof(T) == 4) {
      const hn::Rebind<float, hn::ScalableTag<double>> half;
      hn::StoreU(hn::DemoteTo(half, c), half, re + l);
      hn::StoreU(hn::DemoteTo(half, s), half, im + l);
    } else {
      hn::StoreU(c, dd, re + l);
      hn::StoreU(s, dd, im + l);
    }
  }
}

/// Factors of the samples of a tone, the first one's first: none, a gain each, or a complex number each.
template <class T, int parts_>
struct ToneFactor {
  static constexpr int parts = parts_;
  const T* re = nullptr;
  const T* im = nullptr;
};

// sum += s z factor, all complex.
template <class D, class T, int parts, class V = hn::Vec<D>>
HWY_INLINE void multiply_add(D d, V s_re, V s_im, V z_re, V z_im, const ToneFactor<T, parts>& factor, std::size_t at,
                             V& sum_re, V& sum_im) {
  if constexpr (parts == 0) {
    sum_re = hn::NegMulAdd(s_im, z_im, hn::MulAdd(s_re, z_re, sum_re));
    sum_im = hn::MulAdd(s_im, z_re, hn::MulAdd(s_re, z_im, sum_im));
  } else {
    const V t_re = hn::NegMulAdd(s_im, z_im, hn::Mul(s_re, z_re));
    const V t_im = hn::MulAdd(s_im, z_re, hn::Mul(s_re, z_im));
    const V f_re = hn::LoadU(d, factor.re + at);
    sum_re = hn::MulAdd(t_re, f_re, sum_re);
    sum_im = hn::MulAdd(t_im, f_re, sum_im);
    if constexpr (parts == 2) {
      const V f_im = hn::LoadU(d, factor.im + at);
      sum_re = hn::NegMulAdd(t_im, f_im, sum_re);
      sum_im = hn::MulAdd(t_re, f_im, sum_im);
    }
  }
}

/// How far the step of a tone changes along it: not at all, or to first or third order of the change.
enum class Bend { none, slight, strong };

// z = p times exp(j x), x = share times lane, as a series; q = j lane p.
template <Bend bend, class D, class V = hn::Vec<D>>
HWY_INLINE void bend_step(D d, V share, V lane, V p_re, V p_im, V q_re, V q_im, V& z_re, V& z_im) {
  using T = hn::TFromD<D>;
  V b_re = q_re;
  V b_im = q_im;
  if constexpr (bend == Bend::strong) {
    const V x = hn::Mul(share, lane);
    const V more_re = hn::Mul(x, hn::Set(d, T(0.5)));
    const V more_im = hn::Mul(hn::Mul(x, x), hn::Set(d, T(-1.0 / 6.0)));
    // q (1 + j x/2 - x^2/6)
    b_re = hn::NegMulAdd(q_im, more_re, hn::MulAdd(q_re, more_im, q_re));
    b_im = hn::MulAdd(q_re, more_re, hn::MulAdd(q_im, more_im, q_im));
  }
  z_re = hn::MulAdd(share, b_re, p_re);
  z_im = hn::MulAdd(share, b_im, p_im);
}

// Adds the samples of a tone, given the phasor of the middle of each vector and those of the lanes about it. `bent` is
// the change of the step from one vector to the next, radians per sample.
template <Bend bend, class T, int parts>
HWY_INLINE void add_vectors(const Tone& tone, double bent, const T* HWY_RESTRICT lane_re, const T* HWY_RESTRICT lane_im,
                            const T* HWY_RESTRICT turn_re, const T* HWY_RESTRICT turn_im,
                            const ToneFactor<T, parts>& factor, T* HWY_RESTRICT re, T* HWY_RESTRICT im) {
  const hn::ScalableTag<T> d;
  const std::size_t lanes = hn::Lanes(d);
  const std::size_t length = tone.end - tone.begin;
  const double middle = 0.5 * static_cast<double>((length - 1) / lanes);
  const auto p_re = hn::Load(d, lane_re);
  const auto p_im = hn::Load(d, lane_im);
  const auto lane = hn::Sub(hn::Iota(d, T(0)), hn::Set(d, T(0.5) * static_cast<T>(lanes - 1)));
  const auto q_re = hn::Neg(hn::Mul(lane, p_im));
  const auto q_im = hn::Mul(lane, p_re);
  auto z_re = p_re;
  auto z_im = p_im;
  std::size_t v = 0;
  for (std::size_t at = 0; at < length; at += lanes, ++v) {
    if constexpr (bend != Bend::none)
      bend_step<bend>(d, hn::Set(d, static_cast<T>(bent * (static_cast<double>(v) - middle))), lane, p_re, p_im, q_re,
                      q_im, z_re, z_im);
    const auto old_re = hn::LoadU(d, re + at);
    const auto old_im = hn::LoadU(d, im + at);
    auto sum_re = old_re;
    auto sum_im = old_im;
    multiply_add(d, hn::Set(d, turn_re[v]), hn::Set(d, turn_im[v]), z_re, z_im, factor, at, sum_re, sum_im);
    if (at + lanes > length) {
      const auto on = hn::FirstN(d, length - at);
      sum_re = hn::IfThenElse(on, sum_re, old_re);
      sum_im = hn::IfThenElse(on, sum_im, old_im);
    }
    hn::StoreU(sum_re, d, re + at);
    hn::StoreU(sum_im, d, im + at);
  }
}

// A tone of frequency 0: one phasor for all samples.
template <class T, int parts>
HWY_INLINE void add_constant(const Tone& tone, const ToneFactor<T, parts>& factor, T* HWY_RESTRICT re,
                             T* HWY_RESTRICT im) {
  const hn::ScalableTag<T> d;
  const hn::ScalableTag<double> dd;
  const std::size_t lanes = hn::Lanes(d);
  const std::size_t length = tone.end - tone.begin;
  auto c = hn::Zero(dd);
  auto s = hn::Zero(dd);
  cos_sin_turns(dd, fraction_of_turn(hn::Set(dd, tone.alpha)), c, s);
  const auto s_re = hn::Set(d, static_cast<T>(tone.amplitude * hn::GetLane(c)));
  const auto s_im = hn::Set(d, static_cast<T>(tone.amplitude * hn::GetLane(s)));
  const auto one = hn::Set(d, T(1));
  for (std::size_t at = 0; at < length; at += lanes) {
    const auto old_re = hn::LoadU(d, re + at);
    const auto old_im = hn::LoadU(d, im + at);
    auto sum_re = old_re;
    auto sum_im = old_im;
    multiply_add(d, s_re, s_im, one, hn::Zero(d), factor, at, sum_re, sum_im);
    if (at + lanes > length) {
      const auto on = hn::FirstN(d, length - at);
      sum_re = hn::IfThenElse(on, sum_re, old_re);
      sum_im = hn::IfThenElse(on, sum_im, old_im);
    }
    hn::StoreU(sum_re, d, re + at);
    hn::StoreU(sum_im, d, im + at);
  }
}

// A tone of any bend, every vector with a step of its own.
template <class T, int parts>
HWY_INLINE void add_bent_vectors(const Tone& tone, const ToneFactor<T, parts>& factor, T* HWY_RESTRICT re,
                                 T* HWY_RESTRICT im, T* HWY_RESTRICT lane_re, T* HWY_RESTRICT lane_im,
                                 const T* HWY_RESTRICT turn_re, const T* HWY_RESTRICT turn_im) {
  const std::size_t lanes = hn::Lanes(hn::ScalableTag<T>());
  Tone part = tone;
  for (std::size_t v = 0; part.begin < tone.end; ++v, part.begin = part.end) {
    part.end = std::min(part.begin + lanes, tone.end);
    const double middle = static_cast<double>(part.begin) + 0.5 * static_cast<double>(lanes - 1) - tone.centre;
    lane_phasors<T>(tone.beta + 2.0 * tone.gamma * middle, tone.gamma, lanes, lane_re, lane_im);
    const std::size_t at = part.begin - tone.begin;
    ToneFactor<T, parts> rest;
    if constexpr (parts > 0) rest = {factor.re + at, factor.im + at};
    add_vectors<Bend::none>(part, 0.0, lane_re, lane_im, turn_re + v, turn_im + v, rest, re + at, im + at);
  }
}

/// Adds a tone times its factors to a row; turn_re and turn_im have room for a number per vector.
template <class T, int parts>
HWY_INLINE void add_tone(const Tone& tone, const ToneFactor<T, parts>& factor, T* HWY_RESTRICT row_re,
                         T* HWY_RESTRICT row_im, T* HWY_RESTRICT turn_re, T* HWY_RESTRICT turn_im) {
  const hn::ScalableTag<T> d;
  constexpr bool single = sizeof(T) == 4;
  const std::size_t lanes = hn::Lanes(d);
  const std::size_t vectors = (tone.end - tone.begin + lanes - 1) / lanes;
  T* const re = row_re + tone.begin;
  T* const im = row_im + tone.begin;
  if (tone.beta == 0.0 && tone.gamma == 0.0) {
    add_constant(tone, factor, re, im);
    return;
  }
  const double middle = static_cast<double>(tone.begin) + 0.5 * static_cast<double>(vectors * lanes - 1) - tone.centre;
  HWY_ALIGN T lane_re[hn::MaxLanes(d)];
  HWY_ALIGN T lane_im[hn::MaxLanes(d)];
  lane_phasors<T>(tone.beta + 2.0 * tone.gamma * middle, tone.gamma, lanes, lane_re, lane_im);
  vector_phasors<T>(tone, lanes, vectors, turn_re, turn_im);
  // The step changes slowly along the tone: exp(j x), x = 2 pi (change) (lane - middle), as a series in x of as many
  // terms as its largest value asks for.
  const double bent = 6.283185307179586476925 * 2.0 * tone.gamma * static_cast<double>(lanes);
  const double largest = 0.25 * std::abs(bent) * static_cast<double>((vectors - 1) * lanes);
  if (largest <= (single ? 1e-8 : 1e-17))
    add_vectors<Bend::none>(tone, bent, lane_re, lane_im, turn_re, turn_im, factor, re, im);
  else if (largest <= (single ? 2e-4 : 1e-8))
    add_vectors<Bend::slight>(tone, bent, lane_re, lane_im, turn_re, turn_im, factor, re, im);
  else if (largest <= (single ? 0.03 : 3e-3))
    add_vectors<Bend::strong>(tone, bent, lane_re, lane_im, turn_re, turn_im, factor, re, im);
  else
    add_bent_vectors(tone, factor, re, im, lane_re, lane_im, turn_re, turn_im);
}

/// Adds the single-precision sums of [begin, end) to the row and clears them.
HWY_INLINE void flush(std::size_t begin, std::size_t end, ToneScratch& scratch, SplitRow& row) {
  const hn::ScalableTag<double> dd;
  const hn::Rebind<float, hn::ScalableTag<double>> half;
  float* const from_re = scratch.re_single.data();
  float* const from_im = scratch.im_single.data();
  double* const to_re = row.re.data();
  double* const to_im = row.im.data();
  for (std::size_t i = begin; i < end; i += hn::Lanes(dd)) {
    hn::StoreU(hn::Add(hn::LoadU(dd, to_re + i), hn::PromoteTo(dd, hn::LoadU(half, from_re + i))), dd, to_re + i);
    hn::StoreU(hn::Add(hn::LoadU(dd, to_im + i), hn::PromoteTo(dd, hn::LoadU(half, from_im + i))), dd, to_im + i);
    hn::StoreU(hn::Zero(half), half, from_re + i);
    hn::StoreU(hn::Zero(half), half, from_im + i);
  }
}

}  // namespace sarsim::radar::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
