#include "echo/tones.hpp"

#include <algorithm>
#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "echo/tones.cpp"
#include <hwy/foreach_target.h>  // includes this file once per instruction set

#include "echo/simd_math-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace sarsim::HWY_NAMESPACE {

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

template <class T>
HWY_INLINE void add_tone(const Tone& tone, T* HWY_RESTRICT row_re, T* HWY_RESTRICT row_im, T* turn_re, T* turn_im) {
  const hn::ScalableTag<T> d;
  const std::size_t lanes = hn::Lanes(d);
  const std::size_t length = tone.end - tone.begin;
  const std::size_t vectors = (length + lanes - 1) / lanes;
  const double middle = static_cast<double>(tone.begin) + 0.5 * static_cast<double>(length - 1) - tone.centre;
  HWY_ALIGN T lane_re[hn::MaxLanes(d)];
  HWY_ALIGN T lane_im[hn::MaxLanes(d)];
  lane_phasors<T>(tone.beta + 2.0 * tone.gamma * middle, tone.gamma, lanes, lane_re, lane_im);
  vector_phasors<T>(tone, lanes, vectors, turn_re, turn_im);
  const auto p_re = hn::Load(d, lane_re);
  const auto p_im = hn::Load(d, lane_im);
  // The step changes slowly along the pulse: exp(j x), x = 2 pi (change) (lane - middle), as a series in x of as many
  // terms as its largest value asks for.
  const double bend = 6.283185307179586476925 * 2.0 * tone.gamma * static_cast<double>(lanes);
  const double largest = 0.25 * std::abs(bend) * static_cast<double>(vectors * lanes);
  const bool bends = largest > (sizeof(T) == 4 ? 1e-8 : 1e-17);
  const bool bends_much = largest > (sizeof(T) == 4 ? 2e-4 : 1e-8);
  const auto lane = hn::Sub(hn::Iota(d, T(0)), hn::Set(d, T(0.5) * static_cast<T>(lanes - 1)));
  const auto q_re = hn::Neg(hn::Mul(lane, p_im));
  const auto q_im = hn::Mul(lane, p_re);
  T* HWY_RESTRICT re = row_re + tone.begin;
  T* HWY_RESTRICT im = row_im + tone.begin;
  for (std::size_t v = 0; v < vectors; ++v) {
    const auto s_re = hn::Set(d, turn_re[v]);
    const auto s_im = hn::Set(d, turn_im[v]);
    auto z_re = p_re;
    auto z_im = p_im;
    if (bends) {
      const auto share =
          hn::Set(d, static_cast<T>(bend * (static_cast<double>(v) -
                                            0.5 * static_cast<double>(length) / static_cast<double>(lanes) + 0.5)));
      if (bends_much) {
        const auto x = hn::Mul(share, lane);
        const auto more_re = hn::Mul(x, hn::Set(d, T(0.5)));
        const auto more_im = hn::Mul(hn::Mul(x, x), hn::Set(d, T(-1.0 / 6.0)));
        // q (1 + j x/2 - x^2/6)
        const auto b_re = hn::NegMulAdd(q_im, more_re, hn::MulAdd(q_re, more_im, q_re));
        const auto b_im = hn::MulAdd(q_re, more_re, hn::MulAdd(q_im, more_im, q_im));
        z_re = hn::MulAdd(share, b_re, z_re);
        z_im = hn::MulAdd(share, b_im, z_im);
      } else {
        z_re = hn::MulAdd(share, q_re, z_re);
        z_im = hn::MulAdd(share, q_im, z_im);
      }
    }
    const std::size_t at = v * lanes;
    if (at + lanes <= length) {
      hn::StoreU(hn::NegMulAdd(s_im, z_im, hn::MulAdd(s_re, z_re, hn::LoadU(d, re + at))), d, re + at);
      hn::StoreU(hn::MulAdd(s_im, z_re, hn::MulAdd(s_re, z_im, hn::LoadU(d, im + at))), d, im + at);
    } else {
      const auto on = hn::FirstN(d, length - at);
      const auto add_re = hn::IfThenElseZero(on, hn::NegMulAdd(s_im, z_im, hn::Mul(s_re, z_re)));
      const auto add_im = hn::IfThenElseZero(on, hn::MulAdd(s_im, z_re, hn::Mul(s_re, z_im)));
      hn::StoreU(hn::Add(hn::LoadU(d, re + at), add_re), d, re + at);
      hn::StoreU(hn::Add(hn::LoadU(d, im + at), add_im), d, im + at);
    }
  }
}

// Adds the single-precision sums of [begin, end) to the row and clears them.
HWY_INLINE void flush(std::size_t begin, std::size_t end, ToneScratch& scratch, SplitRow& row) {
  const hn::ScalableTag<double> dd;
  const hn::Rebind<float, hn::ScalableTag<double>> half;
  for (std::size_t i = begin; i < end; i += hn::Lanes(dd)) {
    hn::StoreU(
        hn::Add(hn::LoadU(dd, row.re.data() + i), hn::PromoteTo(dd, hn::LoadU(half, scratch.re_single.data() + i))), dd,
        row.re.data() + i);
    hn::StoreU(
        hn::Add(hn::LoadU(dd, row.im.data() + i), hn::PromoteTo(dd, hn::LoadU(half, scratch.im_single.data() + i))), dd,
        row.im.data() + i);
    hn::StoreU(hn::Zero(half), half, scratch.re_single.data() + i);
    hn::StoreU(hn::Zero(half), half, scratch.im_single.data() + i);
  }
}

void add_tones_on_target(std::span<const Tone> tones, bool single_precision, SplitRow& row, ToneScratch& scratch) {
  if (!single_precision) {
    for (const Tone& tone : tones)
      add_tone<double>(tone, row.re.data(), row.im.data(), scratch.turn_re_double.data(),
                       scratch.turn_im_double.data());
    return;
  }
  constexpr std::size_t group = 64;
  for (std::size_t first = 0; first < tones.size(); first += group) {
    std::size_t begin = row.re.size();
    std::size_t end = 0;
    for (const Tone& tone : tones.subspan(first, std::min(group, tones.size() - first))) {
      add_tone<float>(tone, scratch.re_single.data(), scratch.im_single.data(), scratch.turn_re.data(),
                      scratch.turn_im.data());
      begin = std::min(begin, tone.begin);
      end = std::max(end, tone.end);
    }
    flush(begin, end, scratch, row);
  }
}

}  // namespace sarsim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace sarsim {

HWY_EXPORT(add_tones_on_target);

void add_tones(std::span<const Tone> tones, bool single_precision, SplitRow& row, ToneScratch& scratch) {
  const std::size_t size = row.re.size();
  const std::size_t room = size + SplitRow::padding;
  if (single_precision && scratch.re_single.size() < room) {
    scratch.re_single.assign(room, 0.0F);
    scratch.im_single.assign(room, 0.0F);
    scratch.turn_re.resize(room);
    scratch.turn_im.resize(room);
  }
  if (!single_precision && scratch.turn_re_double.size() < room) {
    scratch.turn_re_double.resize(room);
    scratch.turn_im_double.resize(room);
  }
  HWY_DYNAMIC_DISPATCH(add_tones_on_target)(tones, single_precision, row, scratch);
}

}  // namespace sarsim

#endif
