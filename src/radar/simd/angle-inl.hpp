// Angles and decibels in vectors of doubles; included once per instruction set (Highway's foreach_target).

#if defined(SARSIM_SIMD_ANGLE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SARSIM_SIMD_ANGLE_INL
#undef SARSIM_SIMD_ANGLE_INL
#else
#define SARSIM_SIMD_ANGLE_INL
#endif

#include <hwy/highway.h>

#include <hwy/contrib/math/math-inl.h>

#include "radar/simd/math-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace sarsim::radar::HWY_NAMESPACE {

/// arctan t for |t| <= sqrt 2 - 1, by a polynomial in t^2 that is best in the sense of Chebyshev: to 6e-18 and
/// rounding.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V short_arctangent(D d, V t) {
  constexpr double coefficients[] = {-0.019176885636589051899, 0.039231657085083686644,  -0.050854496960392585335,
                                     0.058581489047951238442,  -0.066645114464602189808, 0.076921831907606508702,
                                     -0.090909045781210852,    0.11111111015256292406,   -0.14285714284666542061,
                                     0.19999999999995520674,   -0.3333333333333333016};
  const V z = hn::Mul(t, t);
  V sum = hn::Zero(d);
  for (const double c : coefficients) sum = hn::MulAdd(sum, z, hn::Set(d, c));
  return hn::MulAdd(hn::Mul(sum, z), t, t);
}

/// The angle of a right triangle's corner, [0, pi]: arctan of opposite over adjacent, as std::atan2 has it, within
/// 4 units in the last place. 0 where both are 0.
/// @param opposite  not negative
/// @param adjacent  negative for angles beyond a quarter turn
template <class D, class V = hn::Vec<D>>
HWY_INLINE V angle_between(D d, V opposite, V adjacent) {
  const V quarter = hn::Set(d, 1.5707963267948966192);
  const V length = hn::Abs(adjacent);
  const V low = hn::Min(opposite, length);
  const V high = hn::Max(opposite, length);
  // From 22.5 to 45 degrees: what is over 45 degrees, so that the polynomial is short.
  const auto steep = hn::Gt(low, hn::Mul(high, hn::Set(d, 0.41421356237309504880)));
  const V numerator = hn::IfThenElse(steep, hn::Sub(low, high), low);
  const V denominator = hn::IfThenElse(steep, hn::Add(low, high), high);
  const V t = hn::Div(numerator, hn::Max(denominator, hn::Set(d, 1e-300)));
  V angle = hn::Add(short_arctangent(d, t), hn::IfThenElseZero(steep, hn::Set(d, 0.78539816339744830962)));
  angle = hn::IfThenElse(hn::Gt(opposite, length), hn::Sub(quarter, angle), angle);
  return hn::IfThenElse(hn::Lt(adjacent, hn::Zero(d)), hn::Sub(hn::Add(quarter, quarter), angle), angle);
}

/// An angle in radians brought into half a turn either way, in degrees.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V wrapped_degrees(D d, V radians) {
  const V turns = hn::Round(hn::Mul(radians, hn::Set(d, 0.15915494309189533577)));
  const V rest = hn::NegMulAdd(turns, hn::Set(d, 6.283185307179586476925), radians);
  return hn::Mul(rest, hn::Set(d, 57.295779513082320877));
}

/// 10^(x/20), to 1e-15 and as exactly as x/20 can be represented; infinite from 6200 dB on.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V amplitude_of_decibels(D d, V x) {
  const V natural = hn::Mul(x, hn::Set(d, 0.11512925464970228420));
  return hn::Exp(d, hn::Min(natural, hn::Set(d, 715.0)));
}

}  // namespace sarsim::radar::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
