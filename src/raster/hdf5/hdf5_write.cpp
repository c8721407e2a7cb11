#include "raster/hdf5/hdf5_write.hpp"

namespace sarsim::raster {

namespace {

constexpr unsigned max_attributes_in_place = 64;  // More would go into a structure of their own.

Hdf5Handle dataset_of(hid_t file, const char* name, hid_t type, std::span<const hsize_t> sizes, bool with_bytes) {
  const Hdf5Handle space(H5Screate_simple(static_cast<int>(sizes.size()), sizes.data(), nullptr), H5Sclose);
  const Hdf5Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  H5Pset_obj_track_times(properties.get(), false);
  H5Pset_attr_phase_change(properties.get(), max_attributes_in_place, 0);
  H5Pset_layout(properties.get(), H5D_CONTIGUOUS);
  H5Pset_alloc_time(properties.get(), with_bytes ? H5D_ALLOC_TIME_EARLY : H5D_ALLOC_TIME_LATE);
  H5Pset_fill_time(properties.get(), with_bytes ? H5D_FILL_TIME_NEVER : H5D_FILL_TIME_IFSET);
  return {H5Dcreate2(file, name, type, space.get(), H5P_DEFAULT, properties.get(), H5P_DEFAULT), H5Dclose};
}

}  // namespace

bool write_attribute(hid_t object, const char* name, hid_t type, const void* value) {
  const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const Hdf5Handle attribute(H5Acreate2(object, name, type, space.get(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  return attribute && H5Awrite(attribute.get(), type, value) >= 0;
}

bool write_attribute(hid_t object, const char* name, const std::string& text) {
  const Hdf5Handle type = text_type();
  const char* pointer = text.c_str();
  return write_attribute(object, name, type.get(), static_cast<const void*>(&pointer));
}

bool write_attribute(hid_t object, const char* name, double value) {
  return write_attribute(object, name, H5T_IEEE_F64LE, &value);
}

bool write_attribute(hid_t object, const char* name, std::int32_t value) {
  return write_attribute(object, name, H5T_STD_I32LE, &value);
}

bool write_attribute(hid_t object, const char* name, std::uint64_t value) {
  return write_attribute(object, name, H5T_STD_U64LE, &value);
}

bool replace_attribute(hid_t object, const char* name, double value) {
  const Hdf5Handle attribute(H5Aopen(object, name, H5P_DEFAULT), H5Aclose);
  return attribute && H5Awrite(attribute.get(), H5T_IEEE_F64LE, &value) >= 0;
}

Hdf5Handle text_type() {
  Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type.get(), H5T_VARIABLE);
  H5Tset_cset(type.get(), H5T_CSET_UTF8);
  return type;
}

Hdf5Handle create_dataset(hid_t file, const char* name, hid_t type, std::span<const hsize_t> sizes) {
  return dataset_of(file, name, type, sizes, true);
}

Hdf5Handle create_late_dataset(hid_t file, const char* name, hid_t type, std::span<const hsize_t> sizes) {
  return dataset_of(file, name, type, sizes, false);
}

}  // namespace sarsim::raster
