#include "raster/hdf5/hdf5_attributes.hpp"

#include <algorithm>
#include <limits>
#include <new>

#include <fmt/format.h>

#include "core/text/number_text.hpp"

namespace sarsim::raster {

namespace {

constexpr hsize_t most_attributes = 1000;
constexpr std::size_t longest_attribute_name = 1024;

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

std::optional<std::string> read_text(hid_t attribute, std::uint64_t longest) {
  const Hdf5Handle space(H5Aget_space(attribute), H5Sclose);
  const Hdf5Handle type(H5Aget_type(attribute), H5Tclose);
  if (!space || !type || H5Sget_simple_extent_npoints(space.get()) != 1) return std::nullopt;
  const H5T_class_t kind = H5Tget_class(type.get());
  if (kind == H5T_STRING)
    return H5Tis_variable_str(type.get()) > 0 ? read_variable_string(attribute, type.get())
                                              : read_fixed_string(attribute, type.get(), longest);
  if (H5Tget_size(type.get()) > sizeof(double)) return std::nullopt;
  if (kind == H5T_INTEGER) return read_integer(attribute, type.get());
  if (kind == H5T_FLOAT) return read_float(attribute);
  return std::nullopt;
}

struct AttributeWalk {
  std::uint64_t longest;
  hsize_t met;
  AttributeTexts texts;
};

std::string name_of(hid_t attribute) {
  const ssize_t size = H5Aget_name(attribute, 0, nullptr);
  if (size <= 0 || static_cast<std::size_t>(size) > longest_attribute_name) return {};
  std::string name(static_cast<std::size_t>(size) + 1, '\0');
  H5Aget_name(attribute, name.size(), name.data());
  name.resize(static_cast<std::size_t>(size));
  return name;
}

// Of H5Aiterate2: 0 goes on, 1 ends the walk.
herr_t take_attribute(hid_t object, const char* name, const H5A_info_t* /*info*/, void* state) {
  auto& walk = *static_cast<AttributeWalk*>(state);
  if (walk.met++ == most_attributes) return 1;
  try {
    const Hdf5Handle attribute(H5Aopen(object, name, H5P_DEFAULT), H5Aclose);
    if (!attribute) return 1;
    if (auto value = read_text(attribute.get(), walk.longest))
      walk.texts.emplace_back(name_of(attribute.get()), std::move(*value));
    return 0;
  } catch (const std::bad_alloc&) {
    return 1;
  }
}

}  // namespace

AttributeTexts read_attributes(hid_t object, std::uint64_t longest) {
  // One walk over all of them: to open the one of a number, the library sorts them all.
  AttributeWalk walk{longest, 0, {}};
  hsize_t first = 0;
  H5Aiterate2(object, H5_INDEX_NAME, H5_ITER_INC, &first, take_attribute, &walk);  // A damaged list ends early.
  return std::move(walk.texts);
}

std::optional<std::string> find_attribute(const AttributeTexts& attributes, std::string_view name) {
  const auto found = std::ranges::find(attributes, name, &std::pair<std::string, std::string>::first);
  if (found == attributes.end()) return std::nullopt;
  return found->second;
}

}  // namespace sarsim::raster
