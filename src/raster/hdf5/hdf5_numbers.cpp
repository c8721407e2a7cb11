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

// The type of a number, or of both numbers of a pair; none where they differ.
Hdf5Handle number_type(hid_t type) {
  const auto members = complex_members(type);
  if (!members) return {H5Tcopy(type), H5Tclose};
  Hdf5Handle real(H5Tget_member_type(type, (*members)[0]), H5Tclose);
  const Hdf5Handle imaginary(H5Tget_member_type(type, (*members)[1]), H5Tclose);
  return H5Tequal(real.get(), imaginary.get()) > 0 ? std::move(real) : Hdf5Handle();
}

// Memory layout of std::complex: complex.array requires the real part first. The library finds members by their names.
Hdf5Handle pair_of(hid_t type, hid_t number, std::size_t bytes) {
  Hdf5Handle pair(H5Tcreate(H5T_COMPOUND, 2 * bytes), H5Tclose);
  std::size_t offset = 0;
  for (const unsigned member : complex_members(type).value_or(std::array<unsigned, 2>{0, 1})) {
    char* const name = H5Tget_member_name(type, member);
    H5Tinsert(pair.get(), name, offset, number);
    H5free_memory(name);
    offset += bytes;
  }
  return pair;
}

}  // namespace

std::optional<std::array<unsigned, 2>> complex_members(hid_t type) {
  if (H5Tget_class(type) != H5T_COMPOUND || H5Tget_nmembers(type) != 2) return std::nullopt;
  constexpr std::pair<const char*, const char*> names[] = {{"r", "i"},   {"real", "imag"}, {"re", "im"},
                                                           {"Re", "Im"}, {"Real", "Imag"}, {"real", "imaginary"}};
  for (const auto& [of_real, of_imaginary] : names) {
    const int real = H5Tget_member_index(type, of_real);
    const int imaginary = H5Tget_member_index(type, of_imaginary);
    if (real < 0 || imaginary < 0) continue;
    const std::array<unsigned, 2> members{static_cast<unsigned>(real), static_cast<unsigned>(imaginary)};
    const H5T_class_t kind = H5Tget_member_class(type, members[0]);
    const bool numbers = kind == H5T_FLOAT || kind == H5T_INTEGER;
    if (!numbers || kind != H5Tget_member_class(type, members[1])) return std::nullopt;
    return members;
  }
  return std::nullopt;
}

NumberKind kind_of_numbers(hid_t type) {
  const auto members = complex_members(type);
  const Hdf5Handle number(members ? H5Tget_member_type(type, (*members)[0]) : H5Tcopy(type), H5Tclose);
  const bool whole = number && H5Tget_class(number.get()) == H5T_INTEGER;
  return {whole, !whole || H5Tget_sign(number.get()) != H5T_SGN_NONE};
}

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
  type_ = H5Tget_class(type) == H5T_COMPOUND ? pair_of(type, number, bytes_) : Hdf5Handle(H5Tcopy(number), H5Tclose);
  as_stored_ = H5Tequal(type, type_.get()) > 0;
}

}  // namespace sarsim::raster
