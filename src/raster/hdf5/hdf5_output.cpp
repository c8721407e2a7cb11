#include "raster/hdf5/hdf5_output.hpp"

#include <H5FDpublic.h>
#if H5_VERSION_GE(1, 13, 0)
#include <H5FDdevelop.h>
#endif

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <new>
#include <span>
#include <stdexcept>

namespace sarsim::raster {

namespace {

constexpr haddr_t last_address = haddr_t{1} << 62;
constexpr hsize_t structure_block_bytes = 512;  // The library reserves space for its own data in such steps.
// Where large datasets begin: bytes that stand across the lines of a cache take longer to copy.
constexpr hsize_t alignment_bytes = 64;
constexpr hsize_t min_aligned_bytes = 4096;

// What the library holds of an open file; it asks that its own part comes first.
struct DriverFile {
  H5FD_t base;
  Hdf5Output* output;
  haddr_t end_of_allocation;
  haddr_t end_of_file;
};

struct DriverInfo {
  Hdf5Output* output;
};

DriverFile* own(H5FD_t* file) { return reinterpret_cast<DriverFile*>(file); }
const DriverFile* own(const H5FD_t* file) { return reinterpret_cast<const DriverFile*>(file); }

H5FD_t* open_file(const char*, unsigned flags, hid_t properties, haddr_t) {
  const auto* info = static_cast<const DriverInfo*>(H5Pget_driver_info(properties));
  if (info == nullptr) return nullptr;
  // A first, tentative call without H5F_ACC_CREAT asks whether the file exists; it always begins empty.
  if ((flags & H5F_ACC_TRUNC) != 0) info->output->attempt([](core::OutputFile& file) { file.resize(0); });
  auto* file = new (std::nothrow) DriverFile{};
  if (file != nullptr) file->output = info->output;
  return file == nullptr ? nullptr : &file->base;
}

herr_t close_file(H5FD_t* file) {
  delete own(file);
  return 0;
}

herr_t query(const H5FD_t*, unsigned long* flags) {
  if (flags != nullptr)
    *flags = H5FD_FEAT_AGGREGATE_METADATA | H5FD_FEAT_ACCUMULATE_METADATA | H5FD_FEAT_DATA_SIEVE |
             H5FD_FEAT_AGGREGATE_SMALLDATA;
  return 0;
}

haddr_t end_of_allocation(const H5FD_t* file, H5FD_mem_t) { return own(file)->end_of_allocation; }

herr_t set_end_of_allocation(H5FD_t* file, H5FD_mem_t, haddr_t address) {
  own(file)->end_of_allocation = address;
  return 0;
}

haddr_t end_of_file(const H5FD_t* file, H5FD_mem_t) { return own(file)->end_of_file; }

herr_t read_bytes(H5FD_t* file, H5FD_mem_t, hid_t, haddr_t address, std::size_t size, void* buffer) {
  std::memset(buffer, 0, size);
  own(file)->output->attempt(
      [=](core::OutputFile& output) { output.read_at(address, std::span(static_cast<std::byte*>(buffer), size)); });
  return 0;
}

herr_t write_bytes(H5FD_t* file, H5FD_mem_t, hid_t, haddr_t address, std::size_t size, const void* buffer) {
  own(file)->output->attempt([=](core::OutputFile& output) {
    output.write_at(address, std::span(static_cast<const std::byte*>(buffer), size));
  });
  own(file)->end_of_file = std::max<haddr_t>(own(file)->end_of_file, address + size);
  return 0;
}

herr_t truncate(H5FD_t* file, hid_t, hbool_t) {
  const haddr_t size = own(file)->end_of_allocation;
  if (size == own(file)->end_of_file) return 0;
  own(file)->output->attempt([=](core::OutputFile& output) { output.resize(size); });
  own(file)->end_of_file = size;
  return 0;
}

H5FD_class_t driver_class() {
  H5FD_class_t driver{};
#if H5_VERSION_GE(1, 13, 0)
  driver.version = H5FD_CLASS_VERSION;
  driver.value = static_cast<H5FD_class_value_t>(300);  // From the values that HDF5 leaves for tests and private use.
#endif
  driver.name = "sarsim_output";
  driver.maxaddr = last_address;
  driver.fc_degree = H5F_CLOSE_STRONG;
  driver.fapl_size = sizeof(DriverInfo);
  driver.open = open_file;
  driver.close = close_file;
  driver.query = query;
  driver.get_eoa = end_of_allocation;
  driver.set_eoa = set_end_of_allocation;
  driver.get_eof = end_of_file;
  driver.read = read_bytes;
  driver.write = write_bytes;
  driver.truncate = truncate;
  constexpr H5FD_mem_t map[H5FD_MEM_NTYPES] = H5FD_FLMAP_DICHOTOMY;
  std::ranges::copy(map, driver.fl_map);
  return driver;
}

}  // namespace

Hdf5Output::Hdf5Output(core::OutputFile& file) : file_(file) {
  const Hdf5Use use;
  const H5FD_class_t driver = driver_class();
  driver_ = Hdf5Handle(H5FDregister(&driver), H5FDunregister);
  if (!driver_) throw std::runtime_error("cannot write " + file.path().string() + ": HDF5: " + hdf5_error_text());
}

Hdf5Output::~Hdf5Output() = default;

Hdf5Handle Hdf5Output::access_properties() {
  Hdf5Handle properties(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  const DriverInfo info{this};
  H5Pset_driver(properties.get(), driver_.get(), &info);
  H5Pset_libver_bounds(properties.get(), H5F_LIBVER_V18, H5F_LIBVER_V18);
  H5Pset_fclose_degree(properties.get(), H5F_CLOSE_STRONG);
  H5Pset_alignment(properties.get(), min_aligned_bytes, alignment_bytes);
  H5Pset_meta_block_size(properties.get(), structure_block_bytes);
  H5Pset_small_data_block_size(properties.get(), structure_block_bytes);
  return properties;
}

}  // namespace sarsim::raster
