#include "echo/strengths.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "echo/strengths.cpp"
#include <hwy/foreach_target.h>  // includes this file once per instruction set

#include "echo/simd_math-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace sarsim::HWY_NAMESPACE {

// Positions and phasors of one vector of echoes.
template <class Real>
HWY_INLINE void strengths_at(const EchoBatch& echoes, const RowFrame& frame, std::size_t k,
                             double* HWY_RESTRICT position, Real* HWY_RESTRICT re, Real* HWY_RESTRICT im,
                             double* HWY_RESTRICT doppler) {
  const hn::ScalableTag<double> dd;
  const hn::Rebind<Real, hn::ScalableTag<double>> narrow;
  const auto delay = hn::LoadU(dd, echoes.delay_s.data() + k);
  const auto amplitude = hn::LoadU(dd, echoes.amplitude_sqrt_w.data() + k);
  hn::StoreU(hn::Mul(hn::Sub(delay, hn::Set(dd, frame.origin_s)), hn::Set(dd, 1.0 / frame.interval_s)), dd, position);
  hn::StoreU(hn::Mul(hn::LoadU(dd, echoes.speed_mps.data() + k), hn::Set(dd, 2.0 / frame.light_speed_mps)), dd,
             doppler);
  const auto turns = fraction_of_turn(hn::Mul(delay, hn::Set(dd, -frame.carrier_hz)));
  auto c = hn::Zero(dd);
  auto s = hn::Zero(dd);
  cos_sin_turns(dd, turns, c, s);
  if constexpr (sizeof(Real) == 4) {
    hn::StoreU(hn::DemoteTo(narrow, hn::Mul(c, amplitude)), narrow, re);
    hn::StoreU(hn::DemoteTo(narrow, hn::Mul(s, amplitude)), narrow, im);
  } else {
    hn::StoreU(hn::Mul(c, amplitude), dd, re);
    hn::StoreU(hn::Mul(s, amplitude), dd, im);
  }
}

template <class Real>
HWY_INLINE void gather_on_target(const EchoBatch& echoes, const RowFrame& frame, Strengths<Real>& out) {
  const hn::ScalableTag<double> dd;
  const std::size_t lanes = hn::Lanes(dd);
  const std::size_t count = echoes.size();
  out.position.resize(count);
  out.strength.resize(count);
  out.doppler.resize(count);
  HWY_ALIGN double position[hn::MaxLanes(dd)];
  HWY_ALIGN double doppler[hn::MaxLanes(dd)];
  HWY_ALIGN Real re[hn::MaxLanes(dd)];
  HWY_ALIGN Real im[hn::MaxLanes(dd)];
  std::size_t kept = 0;
  bool moving = false;
  EchoBatch rest;
  for (std::size_t k = 0; k < count; k += lanes) {
    const std::size_t here = count - k < lanes ? count - k : lanes;
    if (here == lanes) {
      strengths_at<Real>(echoes, frame, k, position, re, im, doppler);
    } else {
      for (std::size_t i = 0; i < lanes; ++i) {
        const std::size_t source = i < here ? k + i : k;
        rest.add(echoes.delay_s[source], echoes.amplitude_sqrt_w[source], echoes.speed_mps[source]);
      }
      strengths_at<Real>(rest, frame, 0, position, re, im, doppler);
    }
    for (std::size_t i = 0; i < here; ++i) {
      out.position[kept] = position[i];
      out.strength[kept] = {re[i], im[i]};
      out.doppler[kept] = doppler[i];
      const bool touches = position[i] > frame.from && position[i] < frame.to;
      moving = moving || (touches && doppler[i] != 0.0);
      kept += touches ? 1 : 0;
    }
  }
  out.position.resize(kept);
  out.strength.resize(kept);
  out.doppler.resize(kept);
  out.moving = moving;
}

void gather_single(const EchoBatch& echoes, const RowFrame& frame, Strengths<float>& out) {
  gather_on_target(echoes, frame, out);
}
void gather_double(const EchoBatch& echoes, const RowFrame& frame, Strengths<double>& out) {
  gather_on_target(echoes, frame, out);
}

}  // namespace sarsim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace sarsim {

HWY_EXPORT(gather_single);
HWY_EXPORT(gather_double);

template <>
void gather_strengths(const EchoBatch& echoes, const RowFrame& frame, Strengths<float>& out) {
  HWY_DYNAMIC_DISPATCH(gather_single)(echoes, frame, out);
}
template <>
void gather_strengths(const EchoBatch& echoes, const RowFrame& frame, Strengths<double>& out) {
  HWY_DYNAMIC_DISPATCH(gather_double)(echoes, frame, out);
}

}  // namespace sarsim

#endif
