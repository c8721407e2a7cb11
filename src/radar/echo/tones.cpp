#include "radar/echo/tones.hpp"

#include <algorithm>

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

}  // namespace sarsim::radar::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace sarsim::radar {

HWY_EXPORT(add_tones_on_target);

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

void add_tones(std::span<const Tone> tones, bool single_precision, SplitRow& row, ToneScratch& scratch) {
  scratch.make_room(row.re.size(), single_precision);
  HWY_DYNAMIC_DISPATCH(add_tones_on_target)(tones, single_precision, row, scratch);
}

}  // namespace sarsim::radar

#endif
