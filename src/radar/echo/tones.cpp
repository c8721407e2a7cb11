#include "radar/echo/tones.hpp"

#include <algorithm>

#include "core/report/expect.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "radar/echo/tones.cpp"
#include <hwy/foreach_target.h>  // includes this file once per instruction set

#include "radar/echo/tone-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace sarsim::radar::HWY_NAMESPACE {

void add_tones_on_target(std::span<const Tone> tones, bool single_precision, SplitRow& row, ToneScratch& scratch) {
  if (!single_precision) {
    for (const Tone& tone : tones)
      add_tone(tone, ToneFactor<double, 0>{}, row.re.data(), row.im.data(), scratch.turn_re_double.data(),
               scratch.turn_im_double.data());
    return;
  }
  constexpr std::size_t group = ToneScratch::group;
  for (std::size_t first = 0; first < tones.size(); first += group) {
    std::size_t begin = row.re.size();
    std::size_t end = 0;
    for (const Tone& tone : tones.subspan(first, std::min(group, tones.size() - first))) {
      add_tone(tone, ToneFactor<float, 0>{}, scratch.re_single.data(), scratch.im_single.data(), scratch.turn_re.data(),
               scratch.turn_im.data());
      begin = std::min(begin, tone.begin);
      end = std::max(end, tone.end);
    }
    flush(begin, end, scratch, row);
  }
}

void drain_on_target(SplitRow& sums, std::size_t begin, std::size_t end, const SplitSpan& factor,
                     std::span<std::complex<double>> row) {
  const hn::ScalableTag<double> d;
  const std::size_t lanes = hn::Lanes(d);
  double* const out = reinterpret_cast<double*>(row.data());
  std::size_t i = begin;
  for (; i + lanes <= end; i += lanes) {
    auto re = hn::LoadU(d, sums.re.data() + i);
    auto im = hn::LoadU(d, sums.im.data() + i);
    hn::StoreU(hn::Zero(d), d, sums.re.data() + i);
    hn::StoreU(hn::Zero(d), d, sums.im.data() + i);
    if (!factor.re.empty()) {
      const auto c = hn::LoadU(d, factor.re.data() + (i - begin));
      const auto s = hn::LoadU(d, factor.im.data() + (i - begin));
      const auto turned = hn::Sub(hn::Mul(re, c), hn::Mul(im, s));
      im = hn::Add(hn::Mul(re, s), hn::Mul(im, c));
      re = turned;
    }
    auto to_re = hn::Zero(d);
    auto to_im = hn::Zero(d);
    hn::LoadInterleaved2(d, out + 2 * i, to_re, to_im);
    hn::StoreInterleaved2(hn::Add(to_re, re), hn::Add(to_im, im), d, out + 2 * i);
  }
  for (; i < end; ++i) {
    std::complex<double> sum(sums.re[i], sums.im[i]);
    sums.re[i] = sums.im[i] = 0.0;
    if (!factor.re.empty()) {
      const double c = factor.re[i - begin];
      const double s = factor.im[i - begin];
      sum = {sum.real() * c - sum.imag() * s, sum.real() * s + sum.imag() * c};
    }
    row[i] += sum;
  }
}

}  // namespace sarsim::radar::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace sarsim::radar {

HWY_EXPORT(add_tones_on_target);
HWY_EXPORT(drain_on_target);

void ToneScratch::make_room(std::size_t samples, bool single_precision) {
  const std::size_t room = samples + SplitRow::padding;
  if (single_precision && re_single.size() < room) {
    re_single.assign(room, 0.0F);
    im_single.assign(room, 0.0F);
    turn_re.resize(room);
    turn_im.resize(room);
  }
  if (!single_precision && turn_re_double.size() < room) {
    turn_re_double.resize(room);
    turn_im_double.resize(room);
  }
}

void drain(SplitRow& sums, std::size_t begin, std::size_t end, const SplitSpan& factor,
           std::span<std::complex<double>> row) {
  CORE_EXPECT(begin <= end && end <= row.size() && end <= sums.re.size());
  CORE_EXPECT(factor.re.size() == factor.im.size());
  CORE_EXPECT(factor.re.empty() || factor.re.size() >= end - begin);
  HWY_DYNAMIC_DISPATCH(drain_on_target)(sums, begin, end, factor, row);
}

void add_tones(std::span<const Tone> tones, bool single_precision, SplitRow& row, ToneScratch& scratch) {
  scratch.make_room(row.re.size(), single_precision);
  HWY_DYNAMIC_DISPATCH(add_tones_on_target)(tones, single_precision, row, scratch);
}

}  // namespace sarsim::radar

#endif
