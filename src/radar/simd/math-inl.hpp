// Vector functions shared by the fast kernels; included once per instruction set (Highway's foreach_target).

#if defined(SARSIM_SIMD_MATH_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SARSIM_SIMD_MATH_INL
#undef SARSIM_SIMD_MATH_INL
#else
#define SARSIM_SIMD_MATH_INL
#endif

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace sarsim::radar::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// cos and sin of theta in [-pi/4, pi/4] and so many quarter turns, -2 to 2, by Taylor series: within 4e-8 (float) or
/// 3e-16 (double) of the exact values.
template <class D, class V = hn::Vec<D>>
HWY_INLINE void cos_sin_of(D d, V quarter, V theta, V& cosine, V& sine) {
  using T = hn::TFromD<D>;
  const V t2 = hn::Mul(theta, theta);
  V c = hn::Set(d, T(1.0 / 40320.0));
  V s = hn::Set(d, T(1.0 / 362880.0));
  if constexpr (sizeof(T) == 8) {
    c = hn::Set(d, T(1.0 / 6402373705728000.0));
    c = hn::MulAdd(c, hn::Neg(t2), hn::Set(d, T(1.0 / 20922789888000.0)));
    c = hn::MulAdd(c, t2, hn::Set(d, T(-1.0 / 87178291200.0)));
    c = hn::MulAdd(c, t2, hn::Set(d, T(1.0 / 479001600.0)));
    c = hn::MulAdd(c, t2, hn::Set(d, T(-1.0 / 3628800.0)));
    c = hn::MulAdd(c, t2, hn::Set(d, T(1.0 / 40320.0)));
    s = hn::Set(d, T(1.0 / 355687428096000.0));
    s = hn::MulAdd(s, t2, hn::Set(d, T(-1.0 / 1307674368000.0)));
    s = hn::MulAdd(s, t2, hn::Set(d, T(1.0 / 6227020800.0)));
    s = hn::MulAdd(s, t2, hn::Set(d, T(-1.0 / 39916800.0)));
    s = hn::MulAdd(s, t2, hn::Set(d, T(1.0 / 362880.0)));
  }
  c = hn::MulAdd(c, t2, hn::Set(d, T(-1.0 / 720.0)));
  c = hn::MulAdd(c, t2, hn::Set(d, T(1.0 / 24.0)));
  c = hn::MulAdd(c, t2, hn::Set(d, T(-0.5)));
  c = hn::MulAdd(c, t2, hn::Set(d, T(1)));
  s = hn::MulAdd(s, t2, hn::Set(d, T(-1.0 / 5040.0)));
  s = hn::MulAdd(s, t2, hn::Set(d, T(1.0 / 120.0)));
  s = hn::MulAdd(s, t2, hn::Set(d, T(-1.0 / 6.0)));
  s = hn::MulAdd(hn::Mul(s, t2), theta, theta);

  // Quarter turns: +-1 swaps, 2 and -2 negate.
  const V magnitude = hn::Abs(quarter);
  const auto odd = hn::Eq(magnitude, hn::Set(d, T(1)));
  const auto half = hn::Eq(magnitude, hn::Set(d, T(2)));
  const V sign = hn::IfThenElse(half, hn::Set(d, T(-1)), hn::Set(d, T(1)));
  cosine = hn::IfThenElse(odd, hn::Neg(hn::Mul(quarter, s)), hn::Mul(sign, c));
  sine = hn::IfThenElse(odd, hn::Mul(quarter, c), hn::Mul(sign, s));
}

/// cos and sin of 2 pi x for |x| <= 1/2, to the same.
template <class D, class V = hn::Vec<D>>
HWY_INLINE void cos_sin_turns(D d, V x, V& cosine, V& sine) {
  using T = hn::TFromD<D>;
  const V quarter = hn::Round(hn::Mul(x, hn::Set(d, T(4))));
  const V theta = hn::Mul(hn::NegMulAdd(quarter, hn::Set(d, T(0.25)), x), hn::Set(d, T(6.283185307179586476925)));
  cos_sin_of(d, quarter, theta, cosine, sine);
}

/// The part of x in [-1/2, 1/2] that is left when whole turns are dropped.
template <class V>
HWY_INLINE V fraction_of_turn(V x) {
  return hn::Sub(x, hn::Round(x));
}

}  // namespace sarsim::radar::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
