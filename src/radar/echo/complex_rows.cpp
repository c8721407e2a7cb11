#include "radar/echo/complex_rows.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "radar/echo/complex_rows.cpp"
#include <hwy/foreach_target.h>  // includes this file once per instruction set

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
#include "core/report/expect.hpp"

namespace sarsim::radar::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

template <class Real>
HWY_INLINE std::complex<Real> product(std::complex<Real> a, std::complex<Real> b) {
  return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

#if HWY_TARGET == HWY_SCALAR

template <class Real>
HWY_INLINE std::size_t product_vectors(const std::complex<Real>*, const std::complex<Real>*, std::complex<Real>*,
                                       std::size_t, bool) {
  return 0;
}

#else

// Whole vectors of out = a b, or out += a b; returns how many numbers they held.
template <class Real>
HWY_INLINE std::size_t product_vectors(const std::complex<Real>* a, const std::complex<Real>* b,
                                       std::complex<Real>* out, std::size_t count, bool sum) {
  const hn::ScalableTag<Real> d;
  const std::size_t numbers = hn::Lanes(d) / 2;
  const auto signs = hn::OddEven(hn::Zero(d), hn::Set(d, Real(-0.0)));
  std::size_t i = 0;
  for (; i + numbers <= count; i += numbers) {
    const auto x = hn::LoadU(d, reinterpret_cast<const Real*>(a + i));
    const auto y = hn::LoadU(d, reinterpret_cast<const Real*>(b + i));
    Real* to = reinterpret_cast<Real*>(out + i);
    const auto start = sum ? hn::LoadU(d, to) : hn::Zero(d);
    const auto crossed = hn::MulAdd(hn::Xor(hn::Reverse2(d, x), signs), hn::DupOdd(y), start);
    hn::StoreU(hn::MulAdd(x, hn::DupEven(y), crossed), d, to);
  }
  return i;
}

#endif

template <class Real>
HWY_INLINE void add_products_on_target(const std::complex<Real>* a, const std::complex<Real>* b,
                                       std::complex<Real>* sum, std::size_t count) {
  for (std::size_t i = product_vectors(a, b, sum, count, true); i < count; ++i) sum[i] += product(a[i], b[i]);
}

template <class Real>
HWY_INLINE void multiply_on_target(const std::complex<Real>* b, std::complex<Real>* row, std::size_t count) {
  for (std::size_t i = product_vectors(row, b, row, count, false); i < count; ++i) row[i] = product(row[i], b[i]);
}

void products_single(const std::complex<float>* a, const std::complex<float>* b, std::complex<float>* sum,
                     std::size_t count) {
  add_products_on_target(a, b, sum, count);
}
void products_double(const std::complex<double>* a, const std::complex<double>* b, std::complex<double>* sum,
                     std::size_t count) {
  add_products_on_target(a, b, sum, count);
}
void multiply_single(const std::complex<float>* b, std::complex<float>* row, std::size_t count) {
  multiply_on_target(b, row, count);
}
void multiply_double(const std::complex<double>* b, std::complex<double>* row, std::size_t count) {
  multiply_on_target(b, row, count);
}

void add_single(const std::complex<float>* a, std::complex<double>* row, std::size_t count) {
  const hn::ScalableTag<double> d;
  const hn::Rebind<float, hn::ScalableTag<double>> narrow;
  const auto* HWY_RESTRICT from = reinterpret_cast<const float*>(a);
  auto* HWY_RESTRICT to = reinterpret_cast<double*>(row);
  std::size_t i = 0;
  for (; i + hn::Lanes(d) <= 2 * count; i += hn::Lanes(d))
    hn::StoreU(hn::Add(hn::LoadU(d, to + i), hn::PromoteTo(d, hn::LoadU(narrow, from + i))), d, to + i);
  for (; i < 2 * count; ++i) to[i] += static_cast<double>(from[i]);
}

void add_double(const std::complex<double>* a, std::complex<double>* row, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) row[i] += a[i];
}

}  // namespace sarsim::radar::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace sarsim::radar {

HWY_EXPORT(products_single);
HWY_EXPORT(products_double);
HWY_EXPORT(multiply_single);
HWY_EXPORT(multiply_double);
HWY_EXPORT(add_single);
HWY_EXPORT(add_double);

template <>
void add_products(std::span<std::complex<float>> sum, std::span<const std::complex<float>> a,
                  std::span<const std::complex<float>> b) {
  CORE_EXPECT(a.size() == sum.size());
  CORE_EXPECT(b.size() == sum.size());
  HWY_DYNAMIC_DISPATCH(products_single)(a.data(), b.data(), sum.data(), sum.size());
}
template <>
void add_products(std::span<std::complex<double>> sum, std::span<const std::complex<double>> a,
                  std::span<const std::complex<double>> b) {
  CORE_EXPECT(a.size() == sum.size());
  CORE_EXPECT(b.size() == sum.size());
  HWY_DYNAMIC_DISPATCH(products_double)(a.data(), b.data(), sum.data(), sum.size());
}
template <>
void multiply_by(std::span<std::complex<float>> row, std::span<const std::complex<float>> b) {
  CORE_EXPECT(b.size() == row.size());
  HWY_DYNAMIC_DISPATCH(multiply_single)(b.data(), row.data(), row.size());
}
template <>
void multiply_by(std::span<std::complex<double>> row, std::span<const std::complex<double>> b) {
  CORE_EXPECT(b.size() == row.size());
  HWY_DYNAMIC_DISPATCH(multiply_double)(b.data(), row.data(), row.size());
}
template <>
void add_row(std::span<std::complex<double>> row, std::span<const std::complex<float>> a) {
  CORE_EXPECT(a.size() == row.size());
  HWY_DYNAMIC_DISPATCH(add_single)(a.data(), row.data(), row.size());
}
template <>
void add_row(std::span<std::complex<double>> row, std::span<const std::complex<double>> a) {
  CORE_EXPECT(a.size() == row.size());
  HWY_DYNAMIC_DISPATCH(add_double)(a.data(), row.data(), row.size());
}

}  // namespace sarsim::radar

#endif
