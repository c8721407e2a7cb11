#include "raster/hdf5/hdf5_attributes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <new>

#include <fmt/format.h>

#include "core/text/number_text.hpp"
#include "raster/hdf5/hdf5_numbers.hpp"

namespace sarsim::raster {

namespace {

constexpr hsize_t max_attributes = 1000;
constexpr std::size_t longest_attribute_name = 1024;
constexpr hssize_t max_in_a_list = 16;

std::optional<std::string> read_fixed_string(hid_t attribute, hid_t type, std::uint64_t longest) {
  const std::size_t size = H5Tget_size(type);
  if (size == 0 || size > longest) return std::nullopt;
  std::string text(size, '\0');
  if (H5Aread(attribute, type, text.data()) < 0) return std::nullopt;
  text.resize(std::min(text.find('\0'), text.size()));
  return text;
}

std::optional<std::string> read_variable_string(hid_t attribute, hid_t type) {
  char* text = nullptr;
  const Hdf5Handle memory(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(memory.get(), H5T_VARIABLE);
  H5Tset_cset(memory.get(), H5Tget_cset(type));
  if (H5Aread(attribute, memory.get(), static_cast<void*>(&text)) < 0 || text == nullptr) return std::nullopt;
  std::string result(text);
  H5free_memory(text);
  return result;
}

std::optional<std::string> read_integer(hid_t attribute, hid_t type) {
  if (H5Tget_sign(type) == H5T_SGN_NONE) {
    std::uint64_t value = 0;
    if (H5Aread(attribute, H5T_NATIVE_UINT64, &value) < 0) return std::nullopt;
    return fmt::format("{}", value);
  }
  std::int64_t value = 0;
  if (H5Aread(attribute, H5T_NATIVE_INT64, &value) < 0) return std::nullopt;
  return fmt::format("{}", value);
}

std::optional<std::string> read_float(hid_t attribute) {
  double value = 0.0;
  if (H5Aread(attribute, H5T_NATIVE_DOUBLE, &value) < 0) return std::nullopt;
  return core::format_number(value);
}

// Some numbers, separated by commas.
std::optional<std::string> read_list(hid_t attribute, hssize_t count) {
  std::array<double, max_in_a_list> values{};
  if (H5Aread(attribute, H5T_NATIVE_DOUBLE, values.data()) < 0) return std::nullopt;
  std::string text;
  for (hssize_t i = 0; i < count; ++i)
    text += (i > 0 ? ", " : "") + core::format_number(values[static_cast<std::size_t>(i)]);
  return text;
}

// A complex number that is none, as xarray writes it for missing samples; nothing for others, which are not read.
std::optional<std::string> read_no_number(hid_t attribute, hid_t type) {
  const auto members = complex_members(type);
  if (!members) return std::nullopt;
  const Hdf5Handle pair(H5Tcreate(H5T_COMPOUND, 2 * sizeof(double)), H5Tclose);
  for (std::size_t i = 0; i < 2; ++i) {
    char* const name = H5Tget_member_name(type, (*members)[i]);
    H5Tinsert(pair.get(), name, i * sizeof(double), H5T_NATIVE_DOUBLE);
    H5free_memory(name);
  }
  std::array<double, 2> value{};
  if (H5Aread(attribute, pair.get(), value.data()) < 0) return std::nullopt;
  return std::isnan(value[0]) || std::isnan(value[1]) ? std::optional<std::string>("nan") : std::nullopt;
}

// What an attribute is that is not read.
std::string words_for_kind(hid_t type, hssize_t count) {
  const char* const many = count == 1 ? "" : "s";
  const std::string number = count == 1 ? "a" : fmt::format("{}", count);
  switch (H5Tget_class(type)) {
    case H5T_STRING: return fmt::format("{} text{}", number, many);
    case H5T_COMPOUND: return fmt::format("{} structure{}", number, many);
    case H5T_REFERENCE: return fmt::format("{} reference{}", number, many);
    case H5T_ENUM: return count == 1 ? "an enumeration" : fmt::format("{} enumerations", count);
    case H5T_INTEGER:
    case H5T_FLOAT:
      if (count > max_in_a_list) return fmt::format("{} numbers", count);
      return fmt::format("{} number{} of {} bytes", number, many, H5Tget_size(type));
    default: return fmt::format("{} value{} of another kind", number, many);
  }
}

// The text of an attribute, where it is one that is read.
std::optional<std::string> read_text(hid_t attribute, hid_t type, hssize_t count, std::uint64_t longest, bool lists) {
  const H5T_class_t kind = H5Tget_class(type);
  const bool number = (kind == H5T_INTEGER || kind == H5T_FLOAT) && H5Tget_size(type) <= sizeof(double);
  // So netCDF writes an empty text.
  if (count == 0 && kind == H5T_STRING) return "";
  if (lists && number && count > 1 && count <= max_in_a_list) return read_list(attribute, count);
  if (count != 1) return std::nullopt;
  if (kind == H5T_STRING)
    return H5Tis_variable_str(type) > 0 ? read_variable_string(attribute, type)
                                        : read_fixed_string(attribute, type, longest);
  if (kind == H5T_COMPOUND) return read_no_number(attribute, type);
  if (!number) return std::nullopt;
  return kind == H5T_INTEGER ? read_integer(attribute, type) : read_float(attribute);
}

struct AttributeWalk {
  std::uint64_t longest;
  bool lists;
  hsize_t met;
  ArrayAttributes found;
};

std::string name_of(hid_t attribute) {
  const ssize_t size = H5Aget_name(attribute, 0, nullptr);
  if (size <= 0 || static_cast<std::size_t>(size) > longest_attribute_name) return {};
  std::string name(static_cast<std::size_t>(size) + 1, '\0');
  H5Aget_name(attribute, name.size(), name.data());
  name.resize(static_cast<std::size_t>(size));
  return name;
}

void take_value(hid_t attribute, AttributeWalk& walk) {
  const Hdf5Handle space(H5Aget_space(attribute), H5Sclose);
  const Hdf5Handle type(H5Aget_type(attribute), H5Tclose);
  if (!space || !type) {
    walk.found.unreadable.emplace_back(name_of(attribute), "a damaged value");
    return;
  }
  const hssize_t count = H5Sget_simple_extent_npoints(space.get());
  if (auto value = read_text(attribute, type.get(), count, walk.longest, walk.lists))
    walk.found.known.emplace_back(name_of(attribute), std::move(*value));
  else
    walk.found.unreadable.emplace_back(name_of(attribute), words_for_kind(type.get(), count));
}

// Of H5Aiterate2: 0 goes on, 1 ends the walk.
herr_t take_attribute(hid_t object, const char* name, const H5A_info_t* /*info*/, void* state) {
  auto& walk = *static_cast<AttributeWalk*>(state);
  walk.found.complete = false;
  if (walk.met++ == max_attributes) return 1;
  try {
    const Hdf5Handle attribute(H5Aopen(object, name, H5P_DEFAULT), H5Aclose);
    if (!attribute) return 1;
    take_value(attribute.get(), walk);
    walk.found.complete = true;
    return 0;
  } catch (const std::bad_alloc&) {
    return 1;
  }
}

}  // namespace

ArrayAttributes read_attributes(hid_t object, std::uint64_t longest, bool lists) {
  // One walk over all of them: to open the one of a number, the library sorts them all.
  AttributeWalk walk{longest, lists, 0, {}};
  hsize_t first = 0;
  if (H5Aiterate2(object, H5_INDEX_NAME, H5_ITER_INC, &first, take_attribute, &walk) < 0) walk.found.complete = false;
  return std::move(walk.found);
}

std::vector<std::string> dimension_names(hid_t dataset) {
  constexpr hssize_t max_dimensions = 32;
  if (H5Aexists(dataset, "DIMENSION_LIST") <= 0) return {};
  const Hdf5Handle attribute(H5Aopen(dataset, "DIMENSION_LIST", H5P_DEFAULT), H5Aclose);
  const Hdf5Handle space(H5Aget_space(attribute.get()), H5Sclose);
  const Hdf5Handle stored(H5Aget_type(attribute.get()), H5Tclose);
  const Hdf5Handle type(H5Tvlen_create(H5T_STD_REF_OBJ), H5Tclose);
  const hssize_t count = H5Sget_simple_extent_npoints(space.get());
  if (count < 1 || count > max_dimensions || H5Tequal(stored.get(), type.get()) <= 0) return {};
  std::vector<hvl_t> lists(static_cast<std::size_t>(count));
  if (H5Aread(attribute.get(), type.get(), lists.data()) < 0) return {};
  std::vector<std::string> names(lists.size());
  for (std::size_t i = 0; i < lists.size(); ++i) {
    if (lists[i].len == 0) continue;
    const Hdf5Handle scale(H5Rdereference2(dataset, H5P_DEFAULT, H5R_OBJECT, lists[i].p), H5Oclose);
    std::array<char, 256> name{};
    if (scale && H5Iget_name(scale.get(), name.data(), name.size()) > 1) names[i] = name.data() + 1;
  }
  H5Dvlen_reclaim(type.get(), space.get(), H5P_DEFAULT, lists.data());
  return names;
}

std::optional<std::string> find_attribute(const AttributeTexts& attributes, std::string_view name) {
  const auto found = std::ranges::find(attributes, name, &std::pair<std::string, std::string>::first);
  if (found == attributes.end()) return std::nullopt;
  return found->second;
}

}  // namespace sarsim::raster
