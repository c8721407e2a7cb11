#include "raster/hdf5/hdf5_sink.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <functional>
#include <stdexcept>
#include <string>
#include <system_error>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "core/build/version.hpp"
#include "core/report/expect.hpp"
#include "raster/hdf5/hdf5_axes.hpp"
#include "raster/hdf5/hdf5_poses.hpp"
#include "raster/hdf5/hdf5_scales.hpp"
#include "raster/hdf5/hdf5_write.hpp"
#include "raster/table/product_attributes.hpp"

namespace sarsim::raster {

namespace {

constexpr std::int32_t format_version = 1;
constexpr std::size_t axis_chunk = 8192;  // Values of an axis that are computed and written at a time.
constexpr unsigned most_attributes_in_header = 64;
constexpr const char* map_name = "utm";

const char* name_of(scene::Processing processing) {
  switch (processing) {
    case scene::Processing::raw: return "raw";
    case scene::Processing::matched_filter: return "matched_filter";
    case scene::Processing::srp: return "srp";
  }
  return "raw";
}

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

bool write_poses(const std::array<Hdf5Handle, 3>& datasets, std::size_t first, std::size_t count,
                 const std::function<simulate::RowPose(std::size_t)>& pose) {
  if (!pose) return true;
  std::array<std::vector<double>, pose_axes.size()> values;
  for (std::size_t begin = first, done = 0; begin < first + count; begin += done) {
    done = std::min(axis_chunk, first + count - begin);
    for (auto& of_axis : values) of_axis.clear();
    for (std::size_t i = 0; i < done; ++i) {
      const simulate::RowPose at = pose(begin + i);
      for (std::size_t a = 0; a < pose_axes.size(); ++a) {
        const std::array<double, 3>& part = at.*pose_axes[a].part;
        values[a].insert(values[a].end(), part.begin(), part.end());
      }
    }
    for (std::size_t a = 0; a < pose_axes.size(); ++a)
      if (!write_part(datasets[a].get(), H5T_NATIVE_DOUBLE, begin, done, 3, values[a].data())) return false;
  }
  return true;
}

bool describe(const Hdf5Handle& dataset, const std::string& units, const std::string& long_name) {
  return write_attribute(dataset.get(), "units", units) && write_attribute(dataset.get(), "long_name", long_name);
}

bool write_facts(hid_t object, const simulate::Facts& facts) {
  return std::ranges::all_of(facts, [&](const auto& fact) {
    return std::visit([&](const auto& value) { return write_attribute(object, fact.first.c_str(), value); },
                      fact.second);
  });
}

bool write_axis(const Hdf5Handle& dataset, std::size_t first, std::size_t count,
                const std::function<double(std::size_t)>& value) {
  if (!value) return true;
  std::vector<double> values;
  for (std::size_t begin = first; begin < first + count; begin += values.size()) {
    values.resize(std::min(axis_chunk, first + count - begin));
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = value(begin + i);
    if (!write_part(dataset.get(), H5T_NATIVE_DOUBLE, begin, values.size(), 1, values.data())) return false;
  }
  return true;
}

}  // namespace

Hdf5Sink::Hdf5Sink(const std::filesystem::path& path, const simulate::Product& product, FileAttributes option_words,
                   const Encoding& encoding, bool replace)
    : product_(product),
      option_words_(std::move(option_words)),
      encoding_(encoding),
      file_(path, replace),
      order_(product.rows),
      output_(file_) {
  if (!file_.seekable())
    throw std::system_error(ESPIPE, std::generic_category(), "cannot write HDF5 into a pipe: " + path.string());
  const Hdf5Use use;
  create_file();
  write_attributes();
  create_sample_type();
  create_datasets();
  write_column_axis();
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
  H5Pset_attr_phase_change(creation.get(), most_attributes_in_header, 0);
  const Hdf5Handle access = output_.access_properties();
  hdf5_ = Hdf5Handle(H5Fcreate(file_.working_path().c_str(), H5F_ACC_TRUNC, creation.get(), access.get()), H5Fclose);
  expect(static_cast<bool>(hdf5_));
}

void Hdf5Sink::write_attributes() {
  const hid_t root = hdf5_.get();
  const scene::RunOptions& options = product_.options;
  const auto put = [&](const char* name, const auto&... value) {
    return !is_known(product_, name) || write_attribute(root, name, value...);
  };
  expect(write_attribute(root, "Conventions", std::string("CF-1.8")) &&
         write_attribute(root, "format_version", format_version) &&
         write_attribute(root, "program_version", std::string(core::program_version)) &&
         put("script", product_.script) && put("radar", product_.radar) &&
         put("processing", std::string(name_of(product_.processing))) &&
         std::ranges::all_of(option_words_,
                             [&](const auto& option) { return put(option.first.c_str(), option.second); }) &&
         put("seed", H5T_STD_U64LE, static_cast<const void*>(&options.seed)) && put("engine", product_.engine) &&
         put("tolerance", options.tolerance) && put("sample_rate_hz", product_.sample_rate_hz) &&
         put("bits", static_cast<std::int32_t>(product_.bits)) && put("lsb_v", product_.lsb_v) &&
         write_facts(root, product_.image.facts));
}

// With a name in the file, because older netCDF libraries leave out compound types that have none.
void Hdf5Sink::create_sample_type() {
  const Hdf5Handle creation(H5Pcreate(H5P_DATATYPE_CREATE), H5Pclose);
  H5Pset_obj_track_times(creation.get(), false);
  sample_type_ = complex_type(part_type(encoding_));
  expect(H5Tcommit2(hdf5_.get(), "complex", sample_type_.get(), H5P_DEFAULT, creation.get(), H5P_DEFAULT) >= 0);
}

void Hdf5Sink::create_datasets() {
  const std::array<hsize_t, 2> shape{product_.rows, product_.columns};
  const std::span<const hsize_t> rows = std::span(shape).first(1);
  const simulate::ImageAxes& image = product_.image;
  Hdf5Scales scales(hdf5_.get());
  create_axis(image.columns, product_.column_range_m, std::span(shape).last(1), slant_range_);
  create_axis(image.rows, image.row_m, rows, image_rows_);
  create_axis("pulse_time_s", product_.row_time_s, rows, pulse_time_);
  create_axis("carrier_hz", product_.row_carrier_hz, rows, carrier_);
  // Times name the rows of recordings and go with those of images.
  const std::string down = image.row_m ? add_scale(scales, image_rows_, image.rows, {}, 0)
                                       : add_scale(scales, pulse_time_, "pulse_time_s", "pulse", product_.rows);
  const std::string across = add_scale(scales, slant_range_, image.columns, "sample", product_.columns);
  std::string with_rows;
  const auto attach = [&](const Hdf5Handle& axis, const std::string& name) {
    if (!axis) return;
    expect(scales.attach(axis.get(), name, {down}));
    with_rows += (with_rows.empty() ? "" : " ") + name;
  };
  if (image.row_m) attach(pulse_time_, "pulse_time_s");
  attach(carrier_, "carrier_hz");
  create_poses(scales, down);
  // Of a recording; images and profiles have times of their own.
  if (product_.row_time_s && product_.processing != scene::Processing::srp && is_known(product_, "processing"))
    expect(write_attribute(pulse_time_.get(), "meaning", std::string("when the middle of the pulse leaves, s")));
  create_map();
  samples_ = create_dataset(hdf5_.get(), "samples", sample_type_.get(), shape);
  const std::string unit = encoding_.counts ? "count" : "V";
  expect(samples_ && write_attribute(samples_.get(), "unit", unit) && describe(samples_, unit, "complex envelope") &&
         (with_rows.empty() || write_attribute(samples_.get(), "coordinates", with_rows)) &&
         (image.map.empty() || write_attribute(samples_.get(), "grid_mapping", std::string(map_name))) &&
         scales.attach(samples_.get(), "samples", {down, across}) && scales.finish());
}

void Hdf5Sink::create_axis(const std::string& name, const std::function<double(std::size_t)>& axis,
                           std::span<const hsize_t> size, Hdf5Handle& dataset) {
  if (!axis) return;
  const AxisWords* const words = words_of_axis(name);
  CORE_EXPECT(words != nullptr);
  dataset = create_dataset(hdf5_.get(), words->name, H5T_IEEE_F64LE, size);
  expect(dataset && describe(dataset, words->units, words->long_name));
}

// The name of a dimension: that of its coordinates, or where there are none a word.
std::string Hdf5Sink::add_scale(Hdf5Scales& scales, const Hdf5Handle& axis, const std::string& name,
                                const std::string& word, std::size_t length) const {
  expect(axis ? scales.add(axis.get(), name) : scales.add_bare(word, length));
  return axis ? name : word;
}

// A dataset that only carries attributes, as CF has it.
void Hdf5Sink::create_map() {
  if (product_.image.map.empty()) return;
  const Hdf5Handle dataset = create_late_dataset(hdf5_.get(), map_name, H5T_STD_I32LE, {});
  expect(dataset && write_facts(dataset.get(), product_.image.map));
}

void Hdf5Sink::create_poses(Hdf5Scales& scales, const std::string& rows) {
  if (!product_.row_pose) return;
  expect(scales.add_words("world_axis", {"x", "y", "z"}));
  for (std::size_t a = 0; a < pose_axes.size(); ++a) {
    const char* name = pose_axes[a].name;
    pose_[a] = create_dataset(hdf5_.get(), name, H5T_IEEE_F64LE, std::array<hsize_t, 2>{product_.rows, 3});
    expect(pose_[a] && describe(pose_[a], pose_axes[a].units, pose_axes[a].long_name) &&
           write_attribute(pose_[a].get(), "meaning", std::string(pose_axes[a].meaning)) &&
           scales.attach(pose_[a].get(), name, {rows, "world_axis"}));
  }
}

void Hdf5Sink::write_column_axis() { expect(write_axis(slant_range_, 0, product_.columns, product_.column_range_m)); }

// In large pieces: a call of the library costs as much as a short row.
void Hdf5Sink::write_row_axes(std::size_t end, std::size_t least_rows) {
  const std::size_t first = axes_written_;
  const std::size_t rows = end - first;
  if (rows < least_rows) return;
  expect(write_axis(image_rows_, first, rows, product_.image.row_m) &&
         write_axis(pulse_time_, first, rows, product_.row_time_s) &&
         write_axis(carrier_, first, rows, product_.row_carrier_hz) &&
         write_poses(pose_, first, rows, product_.row_pose));
  axes_written_ = end;
}

void Hdf5Sink::append(std::span<const std::byte> bytes, std::size_t first_row, std::size_t rows) {
  order_.expect(first_row, rows);
  if (bytes.size() != rows * product_.columns * 2 * array_component_bytes(encoding_))
    throw std::logic_error("encoded rows of the wrong size");
  const Hdf5Use use;
  expect(write_part(samples_.get(), sample_type_.get(), first_row, rows, product_.columns, bytes.data()));
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

void Hdf5Sink::finish(const simulate::RunReport& report) {
  order_.expect_all();
  const Hdf5Use use;
  write_row_axes(product_.rows, 1);
  expect(!is_known(product_, "lsb_v") || replace_attribute(hdf5_.get(), "lsb_v", report.lsb_v));
  bool closed = true;
  for (Hdf5Handle* handle : {&slant_range_, &image_rows_, &pose_[0], &pose_[1], &pose_[2], &carrier_, &pulse_time_,
                             &samples_, &sample_type_, &hdf5_})
    closed = handle->close() && closed;
  expect(closed);
  file_.commit();
}

}  // namespace sarsim::raster
