#pragma once

#include <complex>
#include <span>

namespace sarsim::radar {

/// Sample-by-sample arithmetic on rows of complex numbers in SIMD. Both rows are of one length. Real is float or
/// double.

/// sum[i] += a[i] b[i].
template <class Real>
void add_products(std::span<std::complex<Real>> sum, std::span<const std::complex<Real>> a,
                  std::span<const std::complex<Real>> b);

/// row[i] *= b[i].
template <class Real>
void multiply_by(std::span<std::complex<Real>> row, std::span<const std::complex<Real>> b);

/// row[i] += a[i].
template <class Real>
void add_row(std::span<std::complex<double>> row, std::span<const std::complex<Real>> a);

}  // namespace sarsim::radar
