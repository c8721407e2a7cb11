#include "signal/row/row_kernels.hpp"

#include <algorithm>

#include "core/report/expect.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "signal/row/row_kernels.cpp"
#include <hwy/foreach_target.h>  // includes this file once per instruction set

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace sarsim::signal::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

#if HWY_HAVE_SCALABLE
using RowTag = hn::CappedTag<float, 4>;
#else
using RowTag = hn::CappedTag<float, 16>;
#endif
using RowVec = hn::Vec<RowTag>;

HWY_INLINE float* floats_of(std::complex<float>* values) { return reinterpret_cast<float*>(values); }
HWY_INLINE const float* floats_of(const std::complex<float>* values) { return reinterpret_cast<const float*>(values); }

// The first `count` values of a vector; the others are 0.
template <class D>
HWY_INLINE hn::Vec<D> load_some(D d, const hn::TFromD<D>* from, std::size_t count) {
  HWY_ALIGN hn::TFromD<D> copy[16] = {};
  std::copy_n(from, count, copy);
  return hn::Load(d, copy);
}

template <class D>
HWY_INLINE void store_some(hn::Vec<D> v, D d, hn::TFromD<D>* to, std::size_t count) {
  if (count >= hn::Lanes(d)) {
    hn::StoreU(v, d, to);
    return;
  }
  HWY_ALIGN hn::TFromD<D> copy[16] = {};
  hn::Store(v, d, copy);
  std::copy_n(copy, count, to);
}

// x (1 - x^2/3! + ...) and 1 - x^2/2! + ... on an eighth of a turn, exchanged and with signs for the others.
HWY_INLINE void cos_sin_turns(RowVec turns, RowVec& cosine, RowVec& sine) {
  const RowTag d;
  const hn::RebindToSigned<RowTag> di;
  const RowVec quarters = hn::Mul(turns, hn::Set(d, 4.0F));
  const RowVec whole = hn::Round(quarters);
  const RowVec x = hn::Mul(hn::Sub(quarters, whole), hn::Set(d, 1.57079632679489662F));
  const RowVec xx = hn::Mul(x, x);
  RowVec s = hn::MulAdd(xx, hn::Set(d, 1.0F / 362880), hn::Set(d, -1.0F / 5040));
  s = hn::MulAdd(s, xx, hn::Set(d, 1.0F / 120));
  s = hn::MulAdd(s, xx, hn::Set(d, -1.0F / 6));
  s = hn::MulAdd(hn::Mul(s, xx), x, x);
  RowVec c = hn::MulAdd(xx, hn::Set(d, -1.0F / 3628800), hn::Set(d, 1.0F / 40320));
  c = hn::MulAdd(c, xx, hn::Set(d, -1.0F / 720));
  c = hn::MulAdd(c, xx, hn::Set(d, 1.0F / 24));
  c = hn::MulAdd(c, xx, hn::Set(d, -0.5F));
  c = hn::MulAdd(c, xx, hn::Set(d, 1.0F));
  const auto quadrant = hn::ConvertTo(di, whole);
  const auto odd = hn::MaskFromVec(hn::BitCast(d, hn::Neg(hn::And(quadrant, hn::Set(di, 1)))));
  const auto minus_cosine = hn::ShiftLeft<30>(hn::And(hn::Add(quadrant, hn::Set(di, 1)), hn::Set(di, 2)));
  const auto minus_sine = hn::ShiftLeft<30>(hn::And(quadrant, hn::Set(di, 2)));
  cosine = hn::Xor(hn::IfThenElse(odd, s, c), hn::BitCast(d, minus_cosine));
  sine = hn::Xor(hn::IfThenElse(odd, c, s), hn::BitCast(d, minus_sine));
}

HWY_INLINE void turn_at(float* HWY_RESTRICT at, RowVec turns, RowVec factor) {
  const RowTag d;
  RowVec re, im, cosine, sine;
  hn::LoadInterleaved2(d, at, re, im);
  cos_sin_turns(turns, cosine, sine);
  cosine = hn::Mul(cosine, factor);
  sine = hn::Mul(sine, factor);
  const RowVec out_re = hn::NegMulAdd(im, sine, hn::Mul(re, cosine));
  const RowVec out_im = hn::MulAdd(re, sine, hn::Mul(im, cosine));
  hn::StoreInterleaved2(out_re, out_im, d, at);
}

// Calls body(k) for each whole vector of a row and, for what is left, body on copies of whole vectors. So what becomes
// of a sample does not depend on where it stands.
template <class Whole, class Rest>
HWY_INLINE void each_vector(std::size_t count, const Whole& whole, const Rest& rest) {
  const std::size_t lanes = hn::Lanes(RowTag());
  std::size_t k = 0;
  for (; k + lanes <= count; k += lanes) whole(k);
  if (k < count) rest(k, count - k);
}

void turn_row_on_target(float* HWY_RESTRICT row, const float* HWY_RESTRICT turns, std::size_t count) {
  const RowTag d;
  const RowVec one = hn::Set(d, 1.0F);
  each_vector(
      count, [&](std::size_t k) { turn_at(row + 2 * k, hn::LoadU(d, turns + k), one); },
      [&](std::size_t k, std::size_t left) {
        HWY_ALIGN float copy[2 * 16] = {};
        std::copy_n(row + 2 * k, 2 * left, copy);
        turn_at(copy, load_some(d, turns + k, left), one);
        std::copy_n(copy, 2 * left, row + 2 * k);
      });
}

void multiply_row_on_target(float* HWY_RESTRICT row, const float* HWY_RESTRICT factors, std::size_t count) {
  const RowTag d;
  const auto multiply = [&](float* HWY_RESTRICT at, const float* HWY_RESTRICT by) {
    RowVec a, b, c, e;
    hn::LoadInterleaved2(d, at, a, b);
    hn::LoadInterleaved2(d, by, c, e);
    hn::StoreInterleaved2(hn::NegMulAdd(b, e, hn::Mul(a, c)), hn::MulAdd(a, e, hn::Mul(b, c)), d, at);
  };
  each_vector(
      count, [&](std::size_t k) { multiply(row + 2 * k, factors + 2 * k); },
      [&](std::size_t k, std::size_t left) {
        HWY_ALIGN float copy[2 * 16] = {};
        HWY_ALIGN float by[2 * 16] = {};
        std::copy_n(row + 2 * k, 2 * left, copy);
        std::copy_n(factors + 2 * k, 2 * left, by);
        multiply(copy, by);
        std::copy_n(copy, 2 * left, row + 2 * k);
      });
}

void scale_row_on_target(float* HWY_RESTRICT row, const float* HWY_RESTRICT factors, float scale, std::size_t count) {
  const RowTag d;
  const auto weigh = [&](float* HWY_RESTRICT at, RowVec factor) {
    RowVec re, im;
    hn::LoadInterleaved2(d, at, re, im);
    hn::StoreInterleaved2(hn::Mul(re, factor), hn::Mul(im, factor), d, at);
  };
  const RowVec all = hn::Set(d, scale);
  each_vector(
      count, [&](std::size_t k) { weigh(row + 2 * k, hn::Mul(all, hn::LoadU(d, factors + k))); },
      [&](std::size_t k, std::size_t left) {
        HWY_ALIGN float copy[2 * 16] = {};
        std::copy_n(row + 2 * k, 2 * left, copy);
        weigh(copy, hn::Mul(all, load_some(d, factors + k, left)));
        std::copy_n(copy, 2 * left, row + 2 * k);
      });
}

// sin^2(pi/2 x), x from 0 to 1, to 1e-7.
HWY_INLINE RowVec risen(RowVec x) {
  const RowTag d;
  const RowVec a = hn::Mul(x, hn::Set(d, 1.57079632679489662F));
  const RowVec aa = hn::Mul(a, a);
  RowVec s = hn::MulAdd(aa, hn::Set(d, -1.0F / 39916800), hn::Set(d, 1.0F / 362880));
  s = hn::MulAdd(s, aa, hn::Set(d, -1.0F / 5040));
  s = hn::MulAdd(s, aa, hn::Set(d, 1.0F / 120));
  s = hn::MulAdd(s, aa, hn::Set(d, -1.0F / 6));
  s = hn::MulAdd(hn::Mul(s, aa), a, a);
  return hn::Min(hn::Mul(s, s), hn::Set(d, 1.0F));
}

HWY_INLINE RowVec weight_of_rows(RowVec sine, RowVec weight, const DopplerWeights& w) {
  constexpr float min_edge = 1e-30F;
  const RowTag d;
  const RowVec above = hn::Mul(hn::Sub(sine, hn::Set(d, w.low)), hn::Set(d, 1.0F / std::max(w.low_edge, min_edge)));
  const RowVec below = hn::Mul(hn::Sub(hn::Set(d, w.high), sine), hn::Set(d, 1.0F / std::max(w.high_edge, min_edge)));
  const RowVec within = hn::Min(above, below);
  const RowVec x = hn::Min(hn::Max(within, hn::Zero(d)), hn::Set(d, 1.0F));
  const auto all = hn::Ge(within, hn::Set(d, 1.0F));
  const RowVec share = hn::IfThenElse(all, hn::Set(d, 1.0F), risen(x));
  return hn::Mul(share, hn::Mul(weight, hn::Set(d, w.scale)));
}

void weigh_column_on_target(float* HWY_RESTRICT column, const float* HWY_RESTRICT turns, const DopplerWeights& w,
                            std::size_t count) {
  const RowTag d;
  each_vector(
      count,
      [&](std::size_t k) {
        const RowVec factor = weight_of_rows(hn::LoadU(d, w.sine.data() + k), hn::LoadU(d, w.weight.data() + k), w);
        turn_at(column + 2 * k, hn::LoadU(d, turns + k), factor);
      },
      [&](std::size_t k, std::size_t left) {
        HWY_ALIGN float copy[2 * 16] = {};
        std::copy_n(column + 2 * k, 2 * left, copy);
        const RowVec factor =
            weight_of_rows(load_some(d, w.sine.data() + k, left), load_some(d, w.weight.data() + k, left), w);
        turn_at(copy, load_some(d, turns + k, left), factor);
        std::copy_n(copy, 2 * left, column + 2 * k);
      });
}

HWY_INLINE RowVec cubic_at(const Cubic& cubic, RowVec x) {
  const RowTag d;
  RowVec sum = hn::MulAdd(hn::Set(d, cubic.c3), x, hn::Set(d, cubic.c2));
  sum = hn::MulAdd(sum, x, hn::Set(d, cubic.c1));
  return hn::MulAdd(sum, x, hn::Set(d, cubic.c0));
}

void evaluate_cubics_on_target(const Cubic* HWY_RESTRICT cubics, float* HWY_RESTRICT out, std::size_t count) {
  const RowTag d;
  const std::size_t lanes = hn::Lanes(d);
  for (std::size_t begin = 0; begin < count; begin += cubic_samples, ++cubics)
    for (std::size_t k = 0; k < cubic_samples && begin + k < count; k += lanes) {
      const RowVec sum = cubic_at(*cubics, hn::Iota(d, static_cast<float>(k)));
      store_some(sum, d, out + begin + k, count - begin - k);
    }
}

void place_cubics_on_target(const Cubic* HWY_RESTRICT cubics, const std::int32_t* HWY_RESTRICT bases, float steps,
                            std::int32_t* HWY_RESTRICT whole, std::int32_t* HWY_RESTRICT step, std::size_t count) {
  const RowTag d;
  const hn::RebindToSigned<RowTag> di;
  const std::size_t lanes = hn::Lanes(d);
  for (std::size_t begin = 0; begin < count; begin += cubic_samples, ++cubics, ++bases)
    for (std::size_t k = 0; k < cubic_samples && begin + k < count; k += lanes) {
      const RowVec place = cubic_at(*cubics, hn::Iota(d, static_cast<float>(k)));
      const RowVec floor = hn::Floor(place);
      const auto at = hn::Add(hn::ConvertTo(di, floor), hn::Set(di, *bases));
      const auto part = hn::ConvertTo(di, hn::MulAdd(hn::Sub(place, floor), hn::Set(d, steps), hn::Set(d, 0.5F)));
      const std::size_t left = count - begin - k;
      store_some(at, di, whole + begin + k, left);
      store_some(part, di, step + begin + k, left);
    }
}

#if HWY_TARGET == HWY_SCALAR
HWY_INLINE void sum_of_taps(const float* HWY_RESTRICT samples, const float* HWY_RESTRICT weights, float factor,
                            float* HWY_RESTRICT out) {
  float re = 0.0F;
  float im = 0.0F;
  for (std::size_t i = 0; i < 32; i += 2) {
    re += weights[i] * samples[i];
    im += weights[i] * samples[i + 1];
  }
  out[0] = factor * re;
  out[1] = factor * im;
}
#else
// The sum of the pairs in a vector.
template <class D>
HWY_INLINE auto sum_of_pairs(D d, hn::Vec<D> v) {
  if constexpr (hn::MaxLanes(D()) > 2) {
    const hn::Half<D> half;
    return sum_of_pairs(half, hn::Add(hn::LowerHalf(half, v), hn::UpperHalf(half, v)));
  } else {
    return v;
  }
}

HWY_INLINE void sum_of_taps(const float* HWY_RESTRICT samples, const float* HWY_RESTRICT weights, float factor,
                            float* HWY_RESTRICT out) {
  const RowTag d;
  const hn::CappedTag<float, 2> pair;
  constexpr std::size_t lanes = hn::MaxLanes(RowTag());
  RowVec sum = hn::Mul(hn::LoadU(d, samples), hn::LoadU(d, weights));
  for (std::size_t i = lanes; i < 32; i += lanes)
    sum = hn::MulAdd(hn::LoadU(d, samples + i), hn::LoadU(d, weights + i), sum);
  hn::StoreU(hn::Mul(sum_of_pairs(d, sum), hn::Set(pair, factor)), pair, out);
}
#endif

void interpolate_row_on_target(const Interpolation& from, const std::int32_t* HWY_RESTRICT whole,
                               const std::int32_t* HWY_RESTRICT step, const float* HWY_RESTRICT factors,
                               float* HWY_RESTRICT out, std::size_t count) {
  const float* const samples = floats_of(from.samples);
  for (std::size_t k = 0; k < count; ++k) {
    if (whole[k] >= from.first && whole[k] < from.last)
      sum_of_taps(samples + 2 * static_cast<std::ptrdiff_t>(whole[k]),
                  from.weights + 32 * static_cast<std::ptrdiff_t>(step[k]), factors[k], out + 2 * k);
    else
      out[2 * k] = out[2 * k + 1] = 0.0F;
  }
}

// Four by four samples, each as one double, which are only moved.
HWY_INLINE void transpose_block(const double* HWY_RESTRICT from, std::size_t from_stride, double* HWY_RESTRICT to,
                                std::size_t to_stride) {
#if HWY_TARGET != HWY_SCALAR && !HWY_HAVE_SCALABLE && HWY_HAVE_FLOAT64
  if constexpr (hn::MaxLanes(hn::CappedTag<double, 4>()) == 4) {
    const hn::CappedTag<double, 4> d;
    const auto a = hn::LoadU(d, from), b = hn::LoadU(d, from + from_stride);
    const auto c = hn::LoadU(d, from + 2 * from_stride), e = hn::LoadU(d, from + 3 * from_stride);
    const auto ab0 = hn::InterleaveLower(d, a, b), ab1 = hn::InterleaveUpper(d, a, b);
    const auto ce0 = hn::InterleaveLower(d, c, e), ce1 = hn::InterleaveUpper(d, c, e);
    hn::StoreU(hn::ConcatLowerLower(d, ce0, ab0), d, to);
    hn::StoreU(hn::ConcatLowerLower(d, ce1, ab1), d, to + to_stride);
    hn::StoreU(hn::ConcatUpperUpper(d, ce0, ab0), d, to + 2 * to_stride);
    hn::StoreU(hn::ConcatUpperUpper(d, ce1, ab1), d, to + 3 * to_stride);
    return;
  }
#endif
  for (std::size_t r = 0; r < 4; ++r)
    for (std::size_t c = 0; c < 4; ++c) to[c * to_stride + r] = from[r * from_stride + c];
}

void transpose_on_target(const std::complex<float>* from, std::size_t from_stride, std::size_t rows,
                         std::size_t columns, std::complex<float>* to, std::size_t to_stride) {
  const std::size_t whole_rows = rows / 4 * 4;
  const std::size_t whole_columns = columns / 4 * 4;
  for (std::size_t r = 0; r < whole_rows; r += 4)
    for (std::size_t c = 0; c < whole_columns; c += 4)
      transpose_block(reinterpret_cast<const double*>(from + r * from_stride + c), from_stride,
                      reinterpret_cast<double*>(to + c * to_stride + r), to_stride);
  for (std::size_t r = 0; r < rows; ++r)
    for (std::size_t c = r < whole_rows ? whole_columns : 0; c < columns; ++c)
      to[c * to_stride + r] = from[r * from_stride + c];
}

}  // namespace sarsim::signal::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace sarsim::signal {

HWY_EXPORT(turn_row_on_target);
HWY_EXPORT(multiply_row_on_target);
HWY_EXPORT(scale_row_on_target);
HWY_EXPORT(weigh_column_on_target);
HWY_EXPORT(evaluate_cubics_on_target);
HWY_EXPORT(place_cubics_on_target);
HWY_EXPORT(interpolate_row_on_target);
HWY_EXPORT(transpose_on_target);

namespace {

float* floats_in(std::span<std::complex<float>> row) { return reinterpret_cast<float*>(row.data()); }

}  // namespace

void turn_row(std::span<std::complex<float>> row, std::span<const float> turns) {
  CORE_EXPECT(turns.size() == row.size());
  HWY_DYNAMIC_DISPATCH(turn_row_on_target)(floats_in(row), turns.data(), row.size());
}

void multiply_row(std::span<std::complex<float>> row, std::span<const std::complex<float>> factors) {
  CORE_EXPECT(factors.size() == row.size());
  HWY_DYNAMIC_DISPATCH(multiply_row_on_target)
  (floats_in(row), reinterpret_cast<const float*>(factors.data()), row.size());
}

void scale_row(std::span<std::complex<float>> row, std::span<const float> factors, float scale) {
  CORE_EXPECT(factors.size() == row.size());
  HWY_DYNAMIC_DISPATCH(scale_row_on_target)(floats_in(row), factors.data(), scale, row.size());
}

void weigh_column(std::span<std::complex<float>> column, std::span<const float> turns, const DopplerWeights& weights) {
  CORE_EXPECT(turns.size() == column.size());
  CORE_EXPECT(weights.sine.size() == column.size());
  CORE_EXPECT(weights.weight.size() == column.size());
  HWY_DYNAMIC_DISPATCH(weigh_column_on_target)(floats_in(column), turns.data(), weights, column.size());
}

void evaluate_cubics(std::span<const Cubic> cubics, std::span<float> out) {
  CORE_EXPECT(cubics.size() * cubic_samples >= out.size());
  HWY_DYNAMIC_DISPATCH(evaluate_cubics_on_target)(cubics.data(), out.data(), out.size());
}

void place_cubics(std::span<const Cubic> cubics, std::span<const std::int32_t> bases, int steps,
                  const SamplePlaces& places) {
  CORE_EXPECT(cubics.size() * cubic_samples >= places.whole.size());
  CORE_EXPECT(bases.size() == cubics.size());
  CORE_EXPECT(places.step.size() == places.whole.size());
  HWY_DYNAMIC_DISPATCH(place_cubics_on_target)
  (cubics.data(), bases.data(), static_cast<float>(steps), places.whole.data(), places.step.data(),
   places.whole.size());
}

void interpolate_row(const Interpolation& from, std::span<const std::int32_t> whole, std::span<const std::int32_t> step,
                     std::span<const float> factors, std::span<std::complex<float>> out) {
  CORE_EXPECT(whole.size() == out.size());
  CORE_EXPECT(step.size() == out.size());
  CORE_EXPECT(factors.size() == out.size());
  HWY_DYNAMIC_DISPATCH(interpolate_row_on_target)
  (from, whole.data(), step.data(), factors.data(), floats_in(out), out.size());
}

void transpose(const std::complex<float>* from, std::size_t from_stride, std::size_t rows, std::size_t columns,
               std::complex<float>* to, std::size_t to_stride) {
  CORE_EXPECT(columns <= from_stride || rows <= 1);
  CORE_EXPECT(rows <= to_stride || columns <= 1);
  HWY_DYNAMIC_DISPATCH(transpose_on_target)(from, from_stride, rows, columns, to, to_stride);
}

}  // namespace sarsim::signal

#endif
