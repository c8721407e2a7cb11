#include "raster/hdf5/hdf5_numbers.hpp"

#include <cstdint>
#include <utility>

namespace sarsim::raster {

namespace {

template <class From, class To>
void convert_all(const std::byte* read, std::span<To> to) {
  const auto* from = reinterpret_cast<const From*>(read);
  for (std::size_t i = 0; i < to.size(); ++i) to[i] = static_cast<To>(from[i]);
}

// The type of a number, or of both numbers of a pair; none where r and i differ.
Hdf5Handle number_type(hid_t type) {
  if (H5Tget_class(type) != H5T_COMPOUND) return {H5Tcopy(type), H5Tclose};
  Hdf5Handle real(H5Tget_member_type(type, static_cast<unsigned>(H5Tget_member_index(type, "r"))), H5Tclose);
  const Hdf5Handle imaginary(H5Tget_member_type(type, static_cast<unsigned>(H5Tget_member_index(type, "i"))), H5Tclose);
  return H5Tequal(real.get(), imaginary.get()) > 0 ? std::move(real) : Hdf5Handle();
}

// Memory layout of std::complex: complex.array requires the real part first.
Hdf5Handle pair_of(hid_t number, std::size_t bytes) {
  Hdf5Handle pair(H5Tcreate(H5T_COMPOUND, 2 * bytes), H5Tclose);
  H5Tinsert(pair.get(), "r", 0, number);
  H5Tinsert(pair.get(), "i", bytes, number);
  return pair;
}

}  // namespace

Hdf5Numbers::Hdf5Numbers(hid_t type) {
  const Hdf5Handle stored = number_type(type);
  hid_t number = H5T_NATIVE_DOUBLE;
  const auto hand_over_as = [&]<class Number>(hid_t native, Number) {
    number = native;
    bytes_ = sizeof(Number);
    to_double_ = convert_all<Number, double>;
    to_float_ = convert_all<Number, float>;
  };
  const auto is = [&](hid_t other) { return stored && H5Tequal(stored.get(), other) > 0; };
  if (is(H5T_STD_I8LE))
    hand_over_as(H5T_NATIVE_INT8, std::int8_t{});
  else if (is(H5T_STD_U8LE))
    hand_over_as(H5T_NATIVE_UINT8, std::uint8_t{});
  else if (is(H5T_STD_I16LE))
    hand_over_as(H5T_NATIVE_INT16, std::int16_t{});
  else if (is(H5T_STD_I32LE))
    hand_over_as(H5T_NATIVE_INT32, std::int32_t{});
  else if (is(H5T_STD_I64LE))
    hand_over_as(H5T_NATIVE_INT64, std::int64_t{});
  else if (is(H5T_IEEE_F32LE))
    hand_over_as(H5T_NATIVE_FLOAT, float{});
  else
    hand_over_as(H5T_NATIVE_DOUBLE, double{});
  type_ = H5Tget_class(type) == H5T_COMPOUND ? pair_of(number, bytes_) : Hdf5Handle(H5Tcopy(number), H5Tclose);
  as_stored_ = H5Tequal(type, type_.get()) > 0;
}

}  // namespace sarsim::raster
