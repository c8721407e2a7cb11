#pragma once

#include <cmath>
#include <complex>
#include <cstddef>

#include "core/maths/constants.hpp"
#include "core/maths/sinc.hpp"
#include "signal/sar/sar_image.hpp"

/// Values of images between their samples, for tests: nothing of what measures images in them.
namespace sarsim::signal::test {

/// A weight that falls from 1 in the middle to almost 0 at the ends of (-1, 1).
inline double taper(double x) {
  const double u = 0.5 * core::pi * x;
  return std::abs(x) < 1.0 ? 0.42 + 0.5 * std::cos(2.0 * u) + 0.08 * std::cos(4.0 * u) : 0.0;
}

/// The image at a place between its samples, about its spectral centre: a sinc of 64 samples to each side.
inline std::complex<double> value_at(const FocusedImage& image, const ImagePlace& place) {
  constexpr std::ptrdiff_t reach = 64;
  const auto weight_at = [](const ImageAxis& axis, double index, std::ptrdiff_t at) {
    const double from = static_cast<double>(at) - index;
    return std::polar(core::sinc(from) * taper(from / static_cast<double>(reach)),
                      -2.0 * core::pi * axis.spectrum_centre_per_m * axis.step_m * from);
  };
  const double row = image.azimuth.index_of(place.azimuth_m);
  const double column = image.range.index_of(place.range_m);
  std::complex<double> sum;
  for (auto r = static_cast<std::ptrdiff_t>(row) - reach; r <= static_cast<std::ptrdiff_t>(row) + reach; ++r)
    for (auto c = static_cast<std::ptrdiff_t>(column) - reach; c <= static_cast<std::ptrdiff_t>(column) + reach; ++c) {
      if (r < 0 || c < 0 || r >= static_cast<std::ptrdiff_t>(image.azimuth.count) ||
          c >= static_cast<std::ptrdiff_t>(image.range.count))
        continue;
      const auto at = static_cast<std::size_t>(r) * image.range.count + static_cast<std::size_t>(c);
      sum +=
          weight_at(image.azimuth, row, r) * weight_at(image.range, column, c) * std::complex<double>(image.values[at]);
    }
  return sum;
}

}  // namespace sarsim::signal::test
