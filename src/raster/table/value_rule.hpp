#pragma once

#include <algorithm>
#include <complex>
#include <limits>
#include <span>
#include <type_traits>
#include <vector>

#include "raster/table/nearest_float.hpp"

namespace sarsim::raster {

/// How stored numbers become samples where a standard lets a file say so (CF: `scale_factor`, `_FillValue`,
/// `missing_value`, `valid_range`): sample = scale * number, for I and Q each. Numbers that mark a missing sample, and
/// those outside the valid range, become NaN.
struct ValueRule {
  double scale = 1.0;
  std::vector<double> missing = {};  ///< Stored numbers of I or Q that mark a missing sample.
  // Valid range of stored numbers.
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();

  /// Whether stored numbers are the samples.
  [[nodiscard]] bool is_plain() const {
    return scale == 1.0 && missing.empty() && least == -std::numeric_limits<double>::infinity() &&
           most == std::numeric_limits<double>::infinity();
  }

  /// Makes samples of stored numbers.
  template <class Real>
  void apply(std::span<std::complex<Real>> samples) const {
    for (std::complex<Real>& sample : samples) sample = {made<Real>(sample.real()), made<Real>(sample.imag())};
  }

 private:
  template <class Real>
  [[nodiscard]] Real made(Real stored) const {
    const auto is_stored = [stored](double value) { return stored == rounded<Real>(value); };
    const auto number = static_cast<double>(stored);
    if (number < least || number > most || std::ranges::any_of(missing, is_stored))
      return std::numeric_limits<Real>::quiet_NaN();
    return rounded<Real>(number * scale);
  }
  template <class Real>
  [[nodiscard]] static Real rounded(double value) {
    if constexpr (std::is_same_v<Real, float>)
      return as_float(value);
    else
      return value;
  }
};

}  // namespace sarsim::raster
