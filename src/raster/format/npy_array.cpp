#include "raster/format/npy_array.hpp"

#include <algorithm>
#include <array>
#include <string>

#include <fmt/format.h>

#include "raster/format/raw_decode.hpp"

namespace sarsim::raster {

namespace {

template <class Number>
constexpr NpyType npy_type(std::string_view name, bool pair, bool counts, bool sample) {
  return {name, sizeof(Number), pair, counts, sample, raw_decoder<Number>};
}

// RawNumber, but also 64-bit integers and booleans.
constexpr std::array<NpyType, 13> npy_types{{
    npy_type<float>("c8", true, false, true),
    npy_type<double>("c16", true, false, true),
    npy_type<float>("f4", false, false, true),
    npy_type<double>("f8", false, false, true),
    npy_type<std::int8_t>("i1", false, true, false),
    npy_type<std::uint8_t>("u1", false, true, false),
    npy_type<std::uint8_t>("b1", false, true, false),
    npy_type<std::int16_t>("i2", false, true, true),
    npy_type<std::uint16_t>("u2", false, true, false),
    npy_type<std::int32_t>("i4", false, true, true),
    npy_type<std::uint32_t>("u4", false, true, false),
    npy_type<std::int64_t>("i8", false, true, true),
    npy_type<std::uint64_t>("u8", false, true, false),
}};

}  // namespace

const NpyType* npy_type_of(const NpyHeader& header) {
  const std::string_view type = header.type;
  if (type.substr(0, 1).find_first_of("<>|") != 0) return nullptr;
  const auto found = std::ranges::find(npy_types, type.substr(1), &NpyType::name);
  return found == npy_types.end() ? nullptr : &*found;
}

const NpyType* npy_sample_type_of(const NpyHeader& header) {
  const NpyType* const type = header.type.starts_with('<') ? npy_type_of(header) : nullptr;
  return type != nullptr && type->sample ? type : nullptr;
}

std::string npy_sample_types() {
  std::string names;
  for (const NpyType& type : npy_types)
    if (type.sample) names += fmt::format("{}<{}", names.empty() ? "" : ", ", type.name);
  return names;
}

std::optional<NpyPlane> npy_plane_of(const NpyHeader& header, const NpyType& type) {
  std::vector<std::uint64_t> sizes = header.shape;
  NpyPlane plane;
  if (type.pair) plane.value = ImageValue::complex;
  if (!type.pair && sizes.size() >= 2 && sizes.back() == 2) {
    plane.value = ImageValue::complex;
    plane.components = 2;
    sizes.pop_back();
  } else if (sizes.size() == 3 && sizes.back() == 3 && type.name == "u1") {
    plane.value = ImageValue::rgb;
    plane.components = 3;
    sizes.pop_back();
  }
  if (sizes.empty() || sizes.size() > 2) return std::nullopt;
  plane.columns = sizes.back();
  if (sizes.size() == 2) plane.rows = sizes.front();
  if (plane.rows == 0 || plane.columns == 0) return std::nullopt;
  if (header.fortran_order && plane.components != 1) return std::nullopt;
  return plane;
}

}  // namespace sarsim::raster
