#pragma once

#include <array>
#include <complex>
#include <cstddef>
#include <cstring>
#include <type_traits>

#include "raster/table/nearest_float.hpp"
#include "raster/table/stored_grid.hpp"

namespace sarsim::raster {

/// One number as it is stored.
template <class Number, bool BigEndian>
double raw_component(const std::byte* bytes) {
  Number value;
  if constexpr (BigEndian && sizeof(Number) > 1) {
    std::array<std::byte, sizeof(Number)> turned;
    for (std::size_t i = 0; i < sizeof(Number); ++i) turned[i] = bytes[sizeof(Number) - 1 - i];
    std::memcpy(&value, turned.data(), sizeof value);
  } else {
    std::memcpy(&value, bytes, sizeof value);
  }
  return static_cast<double>(value);
}

/// The nearest number of the wanted precision.
template <class Real>
Real nearest(double value) {
  if constexpr (std::is_same_v<Real, float>)
    return as_float(value);
  else
    return value;
}

/// Decodes samples of one or two components (StoredGrid::Decode).
template <class Real, class Number, bool BigEndian, bool Complex, bool QFirst>
void decode_raw(const StoredGrid& grid, const std::byte* first, std::size_t stride, std::size_t count,
                std::complex<Real>* out) {
  const double centre = grid.centre;
  for (std::size_t i = 0; i < count; ++i, first += stride) {
    const Real one = nearest<Real>(raw_component<Number, BigEndian>(first) - centre);
    if constexpr (Complex) {
      const Real other = nearest<Real>(raw_component<Number, BigEndian>(first + sizeof(Number)) - centre);
      out[i] = QFirst ? std::complex<Real>(other, one) : std::complex<Real>(one, other);
    } else {
      out[i] = {one, Real{}};
    }
  }
}

/// Both decoders of a type.
template <class Number, bool BigEndian, bool Complex, bool QFirst>
constexpr StoredGrid::Decoder raw_decoder_of{decode_raw<float, Number, BigEndian, Complex, QFirst>,
                                             decode_raw<double, Number, BigEndian, Complex, QFirst>};

/// The decoder of a type.
template <class Number>
StoredGrid::Decoder raw_decoder(bool complex, bool big_endian, bool q_first) {
  if (!complex)
    return big_endian ? raw_decoder_of<Number, true, false, false> : raw_decoder_of<Number, false, false, false>;
  if (q_first) return big_endian ? raw_decoder_of<Number, true, true, true> : raw_decoder_of<Number, false, true, true>;
  return big_endian ? raw_decoder_of<Number, true, true, false> : raw_decoder_of<Number, false, true, false>;
}

}  // namespace sarsim::raster
