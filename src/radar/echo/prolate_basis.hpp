#pragma once

#include <array>
#include <cstddef>

namespace sarsim::radar {

/// Eight functions f_k on [-1, 1] whose sums, sum over k of f_k(y) g_k(x), come as close to exp(j c x y), |x| <= 1, as
/// those of any eight functions do but for a factor of about 1: the span of the spherical Bessel functions j_n(c y), n
/// = 0 ... 7, which that of the prolate spheroidal functions is next to (Slepian, Pollak, Bell Syst. Tech. J. 40
/// (1961) 43). Orthonormal; even and odd in turn; in the order in which they count.
class ProlateBasis {
 public:
  static constexpr std::size_t count = 8;

  /// @param c  0 to 8
  explicit ProlateBasis(double c);

  /// Function k at y.
  [[nodiscard]] double value(std::size_t k, double y) const;
  /// Its second derivative.
  [[nodiscard]] double second_derivative(std::size_t k, double y) const;

  /// How many of them make exp(j c x y) to a relative `error`, root mean square; at most one more than there are.
  [[nodiscard]] static std::size_t needed(double c, double error);

 private:
  static constexpr std::size_t terms = 20;
  std::array<std::array<double, terms>, count> powers_{};  // of y^2, lowest first; of odd functions times y
};

}  // namespace sarsim::radar
