// The random numbers of core/maths/random.hpp, a stream and counters of its own per lane; included once per instruction
// set (Highway's foreach_target).

#if defined(SARSIM_SIMD_NORMALS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SARSIM_SIMD_NORMALS_INL
#undef SARSIM_SIMD_NORMALS_INL
#else
#define SARSIM_SIMD_NORMALS_INL
#endif

#include <cstdint>

#include <hwy/highway.h>

#include <hwy/contrib/math/math-inl.h>

#include "radar/simd/math-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace sarsim::radar::HWY_NAMESPACE {

/// Four words of 32 bits per lane, each in the lower half of 64 bits; the upper halves hold anything.
template <class VU>
struct PhiloxWords {
  VU word[4];
};

/// Products of the lower halves of 64-bit lanes with a number of 32 bits.
template <class DU, class VU = hn::Vec<DU>>
HWY_INLINE VU product_of_halves(DU du, VU words, std::uint64_t factor) {
#if HWY_TARGET == HWY_SCALAR
  return hn::Set(du, (hn::GetLane(words) & 0xffffffffU) * factor);
#else
  const hn::Repartition<std::uint32_t, DU> half;
  return hn::MulEven(hn::BitCast(half, words), hn::BitCast(half, hn::Set(du, factor)));
#endif
}

/// Philox4x32-10 (Salmon, Moraes, Dror, Shaw: "Parallel random numbers: as easy as 1, 2, 3", SC 2011).
template <class DU, class VU = hn::Vec<DU>>
HWY_INLINE PhiloxWords<VU> philox(DU du, PhiloxWords<VU> counter, VU key) {
  constexpr int rounds = 10;
  VU key_low = key;
  VU key_high = hn::ShiftRight<32>(key);
  for (int round = 0; round < rounds; ++round) {
    const VU a = product_of_halves(du, counter.word[0], 0xd2511f53U);
    const VU b = product_of_halves(du, counter.word[2], 0xcd9e8d57U);
    counter.word[0] = hn::Xor(hn::Xor(hn::ShiftRight<32>(b), counter.word[1]), key_low);
    counter.word[2] = hn::Xor(hn::Xor(hn::ShiftRight<32>(a), counter.word[3]), key_high);
    counter.word[1] = b;
    counter.word[3] = a;
    key_low = hn::Add(key_low, hn::Set(du, std::uint64_t{0x9e3779b9U}));
    key_high = hn::Add(key_high, hn::Set(du, std::uint64_t{0xbb67ae85U}));
  }
  return counter;
}

/// Uniform in (0, 1]: (n + 1/2)/2^53 of the upper 53 bits of two words.
template <class D, class VU>
HWY_INLINE hn::Vec<D> unit_interval(D d, VU high, VU low) {
  const hn::RebindToUnsigned<D> du;
  const hn::RebindToSigned<D> di;
  const VU bits = hn::Or(hn::ShiftLeft<32>(high), hn::And(low, hn::Set(du, std::uint64_t{0xffffffffU})));
  const auto number = hn::ConvertTo(d, hn::BitCast(di, hn::ShiftRight<11>(bits)));
  return hn::Mul(hn::Add(number, hn::Set(d, 0.5)), hn::Set(d, 0x1p-53));
}

/// `RandomStream::normals(major, minor)` of the streams with these keys: the same bits, and so the same variates to
/// 2e-14, the rounding of logarithm, cosine and sine.
template <class D, class VU, class V = hn::Vec<D>>
HWY_NOINLINE void normal_pair(D d, VU keys, VU major, VU minor, V& first, V& second) {
  const hn::RebindToUnsigned<D> du;
  const PhiloxWords<VU> words =
      philox(du, PhiloxWords<VU>{{minor, hn::ShiftRight<32>(minor), major, hn::ShiftRight<32>(major)}}, keys);
  const V uniform = unit_interval(d, words.word[0], words.word[1]);
  const V radius = hn::Sqrt(hn::Mul(hn::Log(d, uniform), hn::Set(d, -2.0)));
  V cosine = hn::Zero(d);
  V sine = hn::Zero(d);
  cos_sin_turns(d, fraction_of_turn(unit_interval(d, words.word[2], words.word[3])), cosine, sine);
  first = hn::Mul(radius, cosine);
  second = hn::Mul(radius, sine);
}

/// The same for counters that all lanes share.
template <class D, class VU, class V = hn::Vec<D>>
HWY_INLINE void normal_pair(D d, VU keys, std::int64_t major, std::int64_t minor, V& first, V& second) {
  const hn::RebindToUnsigned<D> du;
  const VU majors = hn::Set(du, static_cast<std::uint64_t>(major));
  const VU minors = hn::Set(du, static_cast<std::uint64_t>(minor));
  normal_pair(d, keys, majors, minors, first, second);
}

}  // namespace sarsim::radar::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
