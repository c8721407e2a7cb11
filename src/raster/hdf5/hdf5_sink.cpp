#include "raster/hdf5/hdf5_sink.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <stdexcept>
#include <string>
#include <system_error>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "raster/hdf5/hdf5_scales.hpp"
#include "raster/hdf5/hdf5_write.hpp"

namespace sarsim::raster {

namespace {

constexpr std::size_t axis_chunk = 8192;  // Rows of an axis that are computed and written at a time.
constexpr unsigned max_attributes_in_header = 64;

// Complex numbers as h5py, MATLAB scripts and others expect them: a compound of r and i.
Hdf5Handle complex_type(hid_t part) {
  const std::size_t size = H5Tget_size(part);
  Hdf5Handle type(H5Tcreate(H5T_COMPOUND, 2 * size), H5Tclose);
  H5Tinsert(type.get(), "r", 0, part);
  H5Tinsert(type.get(), "i", size, part);
  return type;
}

hid_t part_type(const Encoding& encoding) {
  if (!encoding.counts) return encoding.doubles ? H5T_IEEE_F64LE : H5T_IEEE_F32LE;
  return array_component_bytes(encoding) == 8 ? H5T_STD_I64LE : H5T_STD_I32LE;
}

// Writes whole leading indices [first, first + count) of a dataset of one or two dimensions.
bool write_part(hid_t dataset, hid_t type, std::size_t first, std::size_t count, std::size_t columns,
                const void* data) {
  if (count == 0 || columns == 0) return true;
  const Hdf5Handle place(H5Dget_space(dataset), H5Sclose);
  const int rank = H5Sget_simple_extent_ndims(place.get());
  const std::array<hsize_t, 2> start{first, 0};
  const std::array<hsize_t, 2> size{count, columns};
  const Hdf5Handle memory(H5Screate_simple(rank, size.data(), nullptr), H5Sclose);
  return H5Sselect_hyperslab(place.get(), H5S_SELECT_SET, start.data(), nullptr, size.data(), nullptr) >= 0 &&
         H5Dwrite(dataset, type, memory.get(), place.get(), H5P_DEFAULT, data) >= 0;
}

// The numbers of an array for [first, first + count), in pieces.
bool write_values(hid_t dataset, const DescribedArray& array, std::size_t first, std::size_t count) {
  std::vector<double> values;
  for (std::size_t begin = first, done = 0; begin < first + count; begin += done) {
    done = std::min(axis_chunk, first + count - begin);
    values.resize(done * array.width);
    for (std::size_t i = 0; i < done; ++i)
      array.values(begin + i, std::span(values).subspan(i * array.width, array.width));
    if (!write_part(dataset, H5T_NATIVE_DOUBLE, begin, done, array.width, values.data())) return false;
  }
  return true;
}

bool write_attributes(hid_t object, const Attributes& attributes) {
  return std::ranges::all_of(attributes, [&](const auto& attribute) {
    return std::visit([&](const auto& value) { return write_attribute(object, attribute.first.c_str(), value); },
                      attribute.second);
  });
}

bool add_words(Hdf5Scales& scales, const DescribedArray& array) {
  std::vector<const char*> words;
  for (const std::string& word : array.words) words.push_back(word.c_str());
  return scales.add_words(array.name, words);
}

// Names a dimension: its coordinates do, or where there are none a scale without any.
bool add_scale(Hdf5Scales& scales, const std::vector<DescribedArray>& arrays, std::span<const Hdf5Handle> datasets,
               const std::string& dimension, std::size_t length) {
  for (std::size_t i = 0; i < arrays.size(); ++i)
    if (arrays[i].name == dimension) return scales.add(datasets[i].get(), dimension);
  return scales.add_bare(dimension, length);
}

}  // namespace

Hdf5Sink::Hdf5Sink(const std::filesystem::path& path, const Product& product, const FileAttributes& option_words,
                   const Encoding& encoding, bool replace)
    : rows_(product.rows),
      columns_(product.columns),
      described_(describe(product, option_words, encoding.counts)),
      encoding_(encoding),
      file_(path, replace),
      order_(product.rows),
      output_(file_) {
  if (!file_.seekable())
    throw std::system_error(ESPIPE, std::generic_category(), "cannot write HDF5 into a pipe: " + path.string());
  const Hdf5Use use;
  create_file();
  expect(write_attributes(hdf5_.get(), described_.root));
  create_sample_type();
  create_arrays();
  write_columns();
  output_.check();
}

Hdf5Sink::~Hdf5Sink() = default;

// A failure of the disk explains a failure of the library, so it is reported first.
void Hdf5Sink::expect(bool done) const {
  output_.check();
  if (!done)
    throw std::runtime_error(fmt::format("cannot write {}: HDF5: {}", file_.path().string(), hdf5_error_text()));
}

void Hdf5Sink::create_file() {
  const Hdf5Handle creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
  H5Pset_obj_track_times(creation.get(), false);
  H5Pset_attr_phase_change(creation.get(), max_attributes_in_header, 0);
  const Hdf5Handle access = output_.access_properties();
  hdf5_ = Hdf5Handle(H5Fcreate(file_.working_path().c_str(), H5F_ACC_TRUNC, creation.get(), access.get()), H5Fclose);
  expect(static_cast<bool>(hdf5_));
}

// With a name in the file, because older netCDF libraries leave out compound types that have none.
void Hdf5Sink::create_sample_type() {
  const Hdf5Handle creation(H5Pcreate(H5P_DATATYPE_CREATE), H5Pclose);
  H5Pset_obj_track_times(creation.get(), false);
  sample_type_ = complex_type(part_type(encoding_));
  expect(H5Tcommit2(hdf5_.get(), "complex", sample_type_.get(), H5P_DEFAULT, creation.get(), H5P_DEFAULT) >= 0);
}

void Hdf5Sink::create_arrays() {
  Hdf5Scales scales(hdf5_.get());
  for (const DescribedArray& array : described_.arrays) {
    const std::array<hsize_t, 2> sizes{array.along == Along::rows ? rows_ : columns_, array.width};
    Hdf5Handle& dataset = arrays_.emplace_back();
    if (array.along == Along::nothing) continue;
    dataset = create_dataset(hdf5_.get(), array.name.c_str(), H5T_IEEE_F64LE,
                             std::span(sizes).first(array.dimensions.size()));
    expect(dataset && write_attributes(dataset.get(), array.attributes));
  }
  expect(add_scale(scales, described_.arrays, arrays_, described_.down, rows_) &&
         add_scale(scales, described_.arrays, arrays_, described_.across, columns_));
  for (const DescribedArray& array : described_.arrays)
    if (!array.words.empty()) expect(add_words(scales, array));
  for (std::size_t i = 0; i < arrays_.size(); ++i)
    if (!described_.arrays[i].is_coordinate())
      expect(scales.attach(arrays_[i].get(), described_.arrays[i].name, described_.arrays[i].dimensions));
  if (!described_.map.empty()) {
    // A dataset that only carries attributes, as CF has it.
    const Hdf5Handle map = create_late_dataset(hdf5_.get(), map_name, H5T_STD_I32LE, {});
    expect(map && write_attributes(map.get(), described_.map));
  }
  samples_ = create_dataset(hdf5_.get(), "samples", sample_type_.get(), std::array<hsize_t, 2>{rows_, columns_});
  expect(samples_ && write_attributes(samples_.get(), described_.samples) &&
         scales.attach(samples_.get(), "samples", {described_.down, described_.across}) && scales.finish());
}

void Hdf5Sink::write_columns() {
  for (std::size_t i = 0; i < arrays_.size(); ++i)
    if (described_.arrays[i].along == Along::columns)
      expect(write_values(arrays_[i].get(), described_.arrays[i], 0, columns_));
}

// In large pieces: a call of the library costs as much as a short row.
void Hdf5Sink::write_row_axes(std::size_t end, std::size_t min_rows) {
  const std::size_t first = axes_written_;
  if (end - first < min_rows) return;
  for (std::size_t i = 0; i < arrays_.size(); ++i)
    if (described_.arrays[i].along == Along::rows)
      expect(write_values(arrays_[i].get(), described_.arrays[i], first, end - first));
  axes_written_ = end;
}

void Hdf5Sink::append(std::span<const std::byte> bytes, std::size_t first_row, std::size_t rows) {
  order_.expect(first_row, rows);
  if (bytes.size() != rows * columns_ * 2 * array_component_bytes(encoding_))
    throw std::logic_error("encoded rows of the wrong size");
  const Hdf5Use use;
  expect(write_part(samples_.get(), sample_type_.get(), first_row, rows, columns_, bytes.data()));
  write_row_axes(first_row + rows, axis_chunk);
  order_.take(rows);
}

void Hdf5Sink::append_axes(std::size_t first_row, std::size_t rows) {
  order_.expect(first_row, rows);
  const Hdf5Use use;
  write_row_axes(first_row + rows, axis_chunk);
  order_.take(rows);
}

std::uint64_t Hdf5Sink::samples_offset() const {
  const Hdf5Use use;
  const haddr_t offset = H5Dget_offset(samples_.get());
  expect(offset != HADDR_UNDEF);
  return offset;
}

void Hdf5Sink::finish(const RunReport& report) {
  order_.expect_all();
  const Hdf5Use use;
  write_row_axes(rows_, 1);
  const bool has_lsb = std::ranges::any_of(described_.root, [](const auto& one) { return one.first == "lsb_v"; });
  expect(!has_lsb || replace_attribute(hdf5_.get(), "lsb_v", report.lsb_v));
  bool closed = true;
  for (Hdf5Handle& array : arrays_) closed = array.close() && closed;
  for (Hdf5Handle* handle : {&samples_, &sample_type_, &hdf5_}) closed = handle->close() && closed;
  expect(closed);
  file_.commit();
}

}  // namespace sarsim::raster
