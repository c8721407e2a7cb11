#pragma once

#include <complex>
#include <cstddef>
#include <memory>
#include <span>

namespace sarsim::core {

/// Discrete Fourier transforms of one length, without scaling (FFTW), in float or double. To another array they
/// are up to a tenth faster than in place; the last digits differ.
///
/// forward:  X[k] = sum over n of x[n] exp(-2 pi j k n/N);  inverse the same with +j.
/// Plans are estimated, never timed, so that the same input gives the same bytes in every run. Executing is safe from
/// many threads at once; making a plan takes a lock.
template <class Real>
class BasicFft {
 public:
  /// Plans transforms of a length of at least 1; takes a lock.
  explicit BasicFft(std::size_t size);
  ~BasicFft();
  BasicFft(BasicFft&&) noexcept;
  BasicFft& operator=(BasicFft&&) noexcept;

  [[nodiscard]] std::size_t size() const { return size_; }
  /// @param[in,out] data  `size()` values that begin at a multiple of 16 bytes, as those of a std::vector do: what the
  ///                      library's vector code needs; anything else is std::invalid_argument
  void forward(std::span<std::complex<Real>> data) const;
  /// The inverse without its factor 1/N; `data` as for `forward`.
  void inverse(std::span<std::complex<Real>> data) const;

  /// The transform to another array of as many values, which begins likewise and may not overlap `data`; these stay as
  /// they are. Plans at first use.
  void forward(std::span<std::complex<Real>> data, std::span<std::complex<Real>> out) const;

 private:
  struct Plans;
  std::size_t size_;
  std::unique_ptr<Plans> plans_;
};

using Fft = BasicFft<double>;

/// The smallest length at least `minimum` whose only prime factors are 2, 3 and 5: fast for FFTW.
[[nodiscard]] std::size_t good_fft_size(std::size_t minimum);

/// The smallest length at least `minimum` that is a multiple of 16 with at most one factor 3 and else only 2 and 5: up
/// to 20 % longer, but three times faster for each sample than lengths of small powers of 2.
[[nodiscard]] std::size_t fast_fft_size(std::size_t minimum);

}  // namespace sarsim::core
