#include "raster/hdf5/hdf5_arrays.hpp"

#include <cstddef>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "raster/hdf5/hdf5_attributes.hpp"
#include "raster/hdf5/hdf5_dataset.hpp"
#include "raster/hdf5/hdf5_numbers.hpp"
#include "raster/table/axis_labels.hpp"
#include "raster/table/cf_attributes.hpp"
#include "raster/table/file_problem.hpp"
#include "raster/table/pose_axes.hpp"

namespace sarsim::raster {

namespace {

core::Problem not_plain(const std::string& path, const char* why) {
  return file_problem({}, fmt::format("the dataset {} {}", path, why), {}, "numbers in one piece, not compressed",
                      "convert the file to a new .h5 or .npy, and refer to that");
}

// A number as NumPy writes it, and its size; none for other types.
std::optional<std::pair<std::string, std::size_t>> numpy_number(hid_t type) {
  const std::size_t bytes = H5Tget_size(type);
  const H5T_class_t kind = H5Tget_class(type);
  if (kind != H5T_FLOAT && kind != H5T_INTEGER) return std::nullopt;
  if (kind == H5T_FLOAT ? bytes != 4 && bytes != 8 : bytes != 1 && bytes != 2 && bytes != 4 && bytes != 8)
    return std::nullopt;
  const char letter = kind == H5T_FLOAT ? 'f' : H5Tget_sign(type) == H5T_SGN_NONE ? 'u' : 'i';
  const char order = bytes == 1 ? '|' : H5Tget_order(type) == H5T_ORDER_BE ? '>' : '<';
  return std::pair(fmt::format("{}{}{}", order, letter, bytes), bytes);
}

// Type and size of samples: complex numbers where both parts are floats and r comes first, otherwise pairs.
struct SampleType {
  std::string type;
  std::size_t item_bytes = 0;
  bool pairs = false;
};

std::optional<SampleType> sample_type(hid_t type) {
  if (H5Tget_class(type) != H5T_COMPOUND) {
    const auto number = numpy_number(type);  // Of 2015: I and Q as neighbours.
    return number ? std::optional(SampleType{number->first, number->second, true}) : std::nullopt;
  }
  const auto members = complex_members(type);
  if (!members) return std::nullopt;
  const auto& [real, imaginary] = *members;
  const Hdf5Handle part(H5Tget_member_type(type, real), H5Tclose);
  const auto number = numpy_number(part.get());
  if (!number || H5Tget_member_offset(type, real) != 0 || H5Tget_member_offset(type, imaginary) != number->second ||
      H5Tget_size(type) != 2 * number->second)
    return std::nullopt;
  if (H5Tget_class(part.get()) == H5T_INTEGER) return SampleType{number->first, number->second, true};
  const std::size_t bytes = 2 * number->second;
  return SampleType{fmt::format("{}c{}", number->first.front(), bytes), bytes, false};
}

class ArrayFinder {
 public:
  // @param dataset  path of the samples; empty: the usual one
  ArrayFinder(Hdf5Handle file, std::uint64_t file_bytes, std::string dataset)
      : file_(std::move(file)), file_bytes_(file_bytes), dataset_(std::move(dataset)) {}

  StoredArrays find() {
    const bool old_layout = dataset_.empty() && is_of_2015(file_.get());
    const std::string chosen = path_of_samples(file_.get(), dataset_);
    const char* const path = chosen.c_str();
    auto opened = open_dataset(file_.get(), path, file_bytes_);
    if (auto* problem = std::get_if<core::Problem>(&opened)) return std::move(*problem);
    const auto& dataset = std::get<Hdf5Dataset>(opened);
    const auto type = sample_type(dataset.type.get());
    if (!are_as_stored(dataset, path)) return not_plain(path, "is scaled, or has values for missing samples");
    const auto offset = place_of(dataset);
    if (!type || dataset.shape.size() != 2) return not_plain(path, "holds no numbers of a usual kind");
    if (!offset) return not_plain(path, "is compressed, or stored in chunks");
    rows_ = dataset.shape[0];
    columns_ = old_layout ? dataset.shape[1] / 2 : dataset.shape[1];
    StoredArray samples{"samples", type->type, type->item_bytes, {rows_, columns_}, {}, *offset, {}, {}};
    samples.facts = {{"units", type->pairs ? "count" : "V"}, {"long_name", "complex envelope"}};
    arrays_.push_back(std::move(samples));
    if (!old_layout) find_axes();
    name_dimensions(type->pairs);
    return std::move(arrays_);
  }

 private:
  // Where a dataset begins. Nothing where its bytes are not at that place of the file: compressed, in chunks, or
  // behind something that the library skips.
  [[nodiscard]] std::optional<std::uint64_t> place_of(const Hdf5Dataset& dataset) const {
    const Hdf5Handle properties(H5Dget_create_plist(dataset.id.get()), H5Pclose);
    const Hdf5Handle creation(H5Fget_create_plist(file_.get()), H5Pclose);
    hsize_t skipped = 0;
    H5Pget_userblock(creation.get(), &skipped);
    if (skipped != 0 || H5Pget_layout(properties.get()) != H5D_CONTIGUOUS) return std::nullopt;
    const haddr_t offset = H5Dget_offset(dataset.id.get());
    return offset == HADDR_UNDEF ? std::nullopt : std::optional<std::uint64_t>(offset);
  }

  // Whether the numbers are the samples: a reference has no place for a rule.
  [[nodiscard]] bool are_as_stored(const Hdf5Dataset& dataset, const char* path) const {
    const auto meaning = meaning_of_samples(read_attributes(dataset.id.get(), file_bytes_, true), path,
                                            kind_of_numbers(dataset.type.get()));
    const auto* const known = std::get_if<SampleMeaning>(&meaning);
    return known != nullptr && known->rule.is_plain();
  }

  // An axis as a stored array; false where it is not there, or not plain.
  bool add(const char* name, std::vector<std::uint64_t> shape, const char* units, const char* long_name) {
    auto opened = open_dataset(file_.get(), std::string("/") + name, file_bytes_);
    const auto* dataset = std::get_if<Hdf5Dataset>(&opened);
    if (dataset == nullptr || dataset->shape != shape) return false;
    const auto number = numpy_number(dataset->type.get());
    const auto offset = place_of(*dataset);
    if (!number || !offset) return false;
    const auto meaning = meaning_of_axis(read_attributes(dataset->id.get(), file_bytes_, true), name, units,
                                         kind_of_numbers(dataset->type.get()));
    const auto* const known = std::get_if<AxisMeaning>(&meaning);
    if (known == nullptr || known->factor != 1.0 || known->offset != 0.0) return false;
    arrays_.push_back({name, number->first, number->second, std::move(shape), {}, *offset, {}, {}});
    arrays_.back().facts = {{"units", units}, {"long_name", long_name}};
    return true;
  }

  void find_axes() {
    for (const AxisLabels& axis : axis_words) {
      const bool of_columns = axis.of == AxisOf::columns;
      std::string& dimension = of_columns ? across_ : down_;
      const bool first = axis.of != AxisOf::rows || std::string_view(axis.name) == "pulse_time_s";
      if (!add(axis.name, {of_columns ? columns_ : rows_}, axis.units, axis.long_name)) continue;
      if (first) dimension = axis.name;
    }
    bool poses = false;
    for (const PoseAxis& axis : pose_axes) poses = add(axis.name, {rows_, 3}, axis.units, axis.long_name) || poses;
    if (poses) arrays_.push_back({"world_axis", "<U1", 4, {3}, {"world_axis"}, 0, {}, {"x", "y", "z"}});
  }

  void name_dimensions(bool pairs) {
    std::string with_rows;
    for (StoredArray& array : arrays_) {
      if (!array.dimensions.empty()) continue;
      const AxisLabels* const axis = words_of_axis(array.name);
      const bool of_columns = axis != nullptr && axis->of == AxisOf::columns;
      array.dimensions = {of_columns ? across_ : down_};
      if (array.shape.size() > 1)
        array.dimensions.emplace_back(axis == nullptr && &array == arrays_.data() ? across_ : "world_axis");
      if (axis != nullptr && !of_columns && array.name != down_)
        with_rows += (with_rows.empty() ? "" : " ") + array.name;
    }
    StoredArray& samples = arrays_.front();
    if (!with_rows.empty()) samples.facts.emplace_back("coordinates", with_rows);
    if (!pairs) return;
    samples.shape.push_back(2);
    samples.dimensions.emplace_back("iq");
    arrays_.push_back(pair_names());
  }

  Hdf5Handle file_;
  std::uint64_t file_bytes_;
  std::string dataset_;
  std::uint64_t rows_ = 0;
  std::uint64_t columns_ = 0;
  std::string down_ = "pulse";
  std::string across_ = "sample";
  std::vector<StoredArray> arrays_;
};

}  // namespace

StoredArrays hdf5_arrays(const std::filesystem::path& path, std::uint64_t file_bytes, const std::string& dataset) {
  const Hdf5Use use;
  auto opened = open_hdf5_file(path);
  if (auto* problem = std::get_if<core::Problem>(&opened)) return std::move(*problem);
  return ArrayFinder(std::move(std::get<Hdf5Handle>(opened)), file_bytes, dataset).find();
}

}  // namespace sarsim::raster
