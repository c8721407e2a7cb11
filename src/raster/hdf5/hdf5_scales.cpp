#include "raster/hdf5/hdf5_scales.hpp"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <span>

#include <fmt/format.h>

#include "raster/hdf5/hdf5_write.hpp"

namespace sarsim::raster {

namespace {

// The specification wants texts of fixed length, with a zero at the end.
bool write_fixed_text(hid_t object, const char* name, const std::string& text) {
  const Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type.get(), text.size() + 1);
  return write_attribute(object, name, type.get(), static_cast<const void*>(text.c_str()));
}

bool write_list(hid_t object, const char* name, hid_t type, hsize_t count, const void* values) {
  const Hdf5Handle space(H5Screate_simple(1, &count, nullptr), H5Sclose);
  const Hdf5Handle attribute(H5Acreate2(object, name, type, space.get(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  return attribute && H5Awrite(attribute.get(), type, values) >= 0;
}

bool refer_to(hid_t file, const std::string& name, hobj_ref_t& place) {
  return H5Rcreate(&place, file, ("/" + name).c_str(), H5R_OBJECT, -1) >= 0;
}

}  // namespace

bool Hdf5Scales::add_named(hid_t dataset, const std::string& name, const std::string& label) {
  Scale scale{name, 0, {}};
  const bool done = refer_to(file_, name, scale.place) && write_fixed_text(dataset, "CLASS", "DIMENSION_SCALE") &&
                    write_fixed_text(dataset, "NAME", label);
  scales_.push_back(std::move(scale));
  return done;
}

bool Hdf5Scales::add(hid_t dataset, const std::string& name) { return add_named(dataset, name, name); }

bool Hdf5Scales::add_bare(const std::string& name, std::uint64_t length) {
  const hsize_t size = length;
  const Hdf5Handle dataset = create_late_dataset(file_, name.c_str(), H5T_IEEE_F32BE, std::span(&size, 1));
  // By these words netCDF-4 tells a dimension without coordinates; the length takes ten places.
  return dataset && add_named(dataset.get(), name,
                              fmt::format("This is a netCDF dimension but not a netCDF variable.{:10}", length));
}

bool Hdf5Scales::add_words(const std::string& name, const std::vector<const char*>& words) {
  const Hdf5Handle type = text_type();
  const hsize_t count = words.size();
  const Hdf5Handle dataset = create_late_dataset(file_, name.c_str(), type.get(), std::span(&count, 1));
  // The library clears the buffers in which it converts texts, two megabytes unless told otherwise.
  constexpr std::size_t buffer_bytes = 4096;
  const Hdf5Handle transfer(H5Pcreate(H5P_DATASET_XFER), H5Pclose);
  H5Pset_buffer(transfer.get(), buffer_bytes, nullptr, nullptr);
  return dataset && H5Dwrite(dataset.get(), type.get(), H5S_ALL, H5S_ALL, transfer.get(), words.data()) >= 0 &&
         add(dataset.get(), name);
}

bool Hdf5Scales::attach(hid_t dataset, const std::string& name, const std::vector<std::string>& scales) {
  hobj_ref_t self = 0;
  if (!refer_to(file_, name, self)) return false;
  std::vector<hvl_t> lists;
  for (const std::string& wanted : scales) {
    const auto scale = std::ranges::find(scales_, wanted, &Scale::name);
    if (scale == scales_.end()) return false;
    scale->uses.push_back({self, static_cast<std::int32_t>(lists.size())});
    lists.push_back({1, &scale->place});
  }
  const Hdf5Handle type(H5Tvlen_create(H5T_STD_REF_OBJ), H5Tclose);
  return write_list(dataset, "DIMENSION_LIST", type.get(), lists.size(), lists.data());
}

bool Hdf5Scales::finish() {
  constexpr std::size_t reference_bytes = sizeof(hobj_ref_t);
  constexpr std::size_t use_bytes = reference_bytes + sizeof(std::int32_t);
  const Hdf5Handle type(H5Tcreate(H5T_COMPOUND, use_bytes), H5Tclose);
  H5Tinsert(type.get(), "dataset", 0, H5T_STD_REF_OBJ);
  H5Tinsert(type.get(), "dimension", reference_bytes, H5T_STD_I32LE);
  for (const Scale& scale : scales_) {
    if (scale.uses.empty()) continue;
    std::vector<std::byte> list(use_bytes * scale.uses.size());
    for (std::size_t i = 0; i < scale.uses.size(); ++i) {
      std::memcpy(list.data() + i * use_bytes, &scale.uses[i].dataset, reference_bytes);
      std::memcpy(list.data() + i * use_bytes + reference_bytes, &scale.uses[i].dimension, sizeof(std::int32_t));
    }
    const Hdf5Handle dataset(H5Dopen2(file_, scale.name.c_str(), H5P_DEFAULT), H5Dclose);
    if (!dataset || !write_list(dataset.get(), "REFERENCE_LIST", type.get(), scale.uses.size(), list.data()))
      return false;
  }
  return true;
}

}  // namespace sarsim::raster
