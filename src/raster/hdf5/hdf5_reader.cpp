#include "raster/hdf5/hdf5_reader.hpp"

#include <algorithm>
#include <array>
#include <complex>
#include <new>
#include <optional>
#include <stdexcept>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "core/os/input_file.hpp"
#include "core/os/isolated.hpp"
#include "core/task/stop.hpp"
#include "core/text/number_text.hpp"
#include "raster/hdf5/hdf5_attributes.hpp"
#include "raster/hdf5/hdf5_dataset.hpp"
#include "raster/hdf5/hdf5_numbers.hpp"
#include "raster/table/axis_labels.hpp"
#include "raster/table/cf_attributes.hpp"
#include "raster/table/described_product.hpp"
#include "raster/table/file_problem.hpp"
#include "raster/table/pose_axes.hpp"

namespace sarsim::raster {

namespace {

constexpr hsize_t max_details = 1000;
constexpr std::size_t max_tried_samples = std::size_t{1} << 20U;  // at either end of a file
constexpr const char* good = "good";  // What a child process says of a file that it could read.

// The library could not get the memory that it wanted.
struct LacksMemory : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// How samples are transferred that take so many bytes in memory: the library clears the buffers in which it converts
// numbers, a megabyte each unless told otherwise, at every call, which is a hundred times the work of a short row.
Hdf5Handle transfer_of(std::uint64_t bytes) {
  constexpr std::uint64_t least = 4096;
  constexpr std::uint64_t most = std::uint64_t{1} << 20U;
  Hdf5Handle transfer(H5Pcreate(H5P_DATASET_XFER), H5Pclose);
  H5Pset_buffer(transfer.get(), std::clamp(bytes, least, most), nullptr, nullptr);
  return transfer;
}

// Reads leading indices [first, first + count). Throws LacksMemory or std::runtime_error; `what` names what is read.
void read_part(const Hdf5Dataset& dataset, hid_t type, std::uint64_t first, std::uint64_t count, void* out,
               const std::string& what) {
  const Hdf5Handle place(H5Dget_space(dataset.id.get()), H5Sclose);
  const std::uint64_t columns = dataset.shape.size() > 1 ? dataset.shape[1] : 1;
  const std::array<hsize_t, 2> start{first, 0};
  const std::array<hsize_t, 2> size{count, columns};
  const Hdf5Handle memory(H5Screate_simple(static_cast<int>(dataset.shape.size()), size.data(), nullptr), H5Sclose);
  const Hdf5Handle transfer = transfer_of(count * columns * sizeof(std::complex<double>));
  if (H5Sselect_hyperslab(place.get(), H5S_SELECT_SET, start.data(), nullptr, size.data(), nullptr) >= 0 &&
      H5Dread(dataset.id.get(), type, memory.get(), place.get(), transfer.get(), out) >= 0)
    return;
  // Now: closing the handles makes the library forget what went wrong.
  const std::string text = "cannot read " + what + ": HDF5: " + hdf5_error_text();
  if (hdf5_lacked_memory()) throw LacksMemory(text);
  throw std::runtime_error(text);
}

bool holds_real_numbers(const Hdf5Dataset& dataset) {
  const H5T_class_t kind = H5Tget_class(dataset.type.get());
  return kind == H5T_FLOAT || kind == H5T_INTEGER;
}

class Hdf5Raster final : public Raster {
 public:
  Hdf5Raster(RasterInfo info, std::string name, Hdf5Handle file, Hdf5Dataset samples, std::uint64_t file_bytes,
             bool old_layout)
      : Raster(std::move(info)),
        name_(std::move(name)),
        file_(std::move(file)),
        samples_(std::move(samples)),
        file_bytes_(file_bytes),
        numbers_(samples_.type.get()),
        old_layout_(old_layout) {}

  [[nodiscard]] std::size_t rows() const override { return static_cast<std::size_t>(samples_.shape[0]); }
  [[nodiscard]] double read_cost_s(const ImageWindow& window) const override {
    return static_cast<double>(window.rows) * (20e-6 + static_cast<double>(columns()) * 1e-9);
  }
  [[nodiscard]] std::optional<RasterAxes> axes() const override {
    if (old_layout_) return std::nullopt;
    const Hdf5Use use;
    return raster::read_axes(rows(), columns(), [this](const std::string& name, std::size_t length, std::size_t width) {
      return read_axis(name, length, width);
    });
  }

  // From here on rows are read from the file itself, where they stand in it as they are wanted: the library lets one
  // thread in at a time. Not where the library reads something else there.
  void read_past_the_library() {
    const Hdf5Use use;
    const Hdf5Handle properties(H5Dget_create_plist(samples_.id.get()), H5Pclose);
    if (!numbers_.as_stored() || H5Pget_layout(properties.get()) != H5D_CONTIGUOUS) return;
    if (columns() > max_tried_samples) return;
    auto opened = core::InputFile::open(info().path);
    if (!std::holds_alternative<core::InputFile>(opened)) return;
    std::vector<std::byte> row(2 * columns() * numbers_.bytes());
    read_part(samples_, numbers_.type(), 0, 1, row.data(), name_);
    std::vector<std::byte> same(row.size());
    const std::uint64_t offset = H5Dget_offset(samples_.id.get());
    const core::InputFile& bytes = std::get<core::InputFile>(opened);
    if (bytes.read_at(offset, same) == same.size() && same == row)
      plain_.emplace(PlainRows{std::move(std::get<core::InputFile>(opened)), offset});
  }

  // Reads the axes as `axes` does, in memory that does not grow with their length.
  void try_axes() const {
    if (old_layout_) return;
    const Hdf5Use use;
    for (const AxisLabels& axis : axis_words)
      try_axis(std::string("/") + axis.name, axis.of == AxisOf::columns ? columns() : rows());
    for (const PoseAxis& axis : pose_axes) try_axis(std::string("/") + axis.name, rows(), 3);
  }

 protected:
  // The library is asked for whole rows, which are what is stored in one piece.
  void read_samples(const ImageWindow& window, std::span<std::complex<float>> out,
                    const core::WorkControl& control) const override {
    const bool whole = window.cols == columns();
    const std::size_t at_once = window.row_step > 1 ? 1 : rows_at_once();
    std::vector<std::complex<float>> rows;
    for (std::size_t i = 0; i < window.rows; i += at_once) {
      if (control.stop != nullptr && control.stop->requested()) throw core::Interrupted();
      const std::size_t count = std::min(at_once, window.rows - i);
      const auto part = out.subspan(i * window.cols, count * window.cols);
      if (!whole) rows.resize(count * columns());
      read_stored(window.row(i), count, whole ? part : std::span(rows));
      for (std::size_t r = 0; !whole && r < count; ++r)
        for (std::size_t k = 0; k < window.cols; ++k)
          part[r * window.cols + k] = rows[r * columns() + window.column(k)];
    }
  }
  void read_whole_rows(std::size_t first, std::size_t count, std::span<std::complex<double>> out) const override {
    for (std::size_t i = 0; i < count; i += rows_at_once()) {
      const std::size_t rows = std::min(rows_at_once(), count - i);
      read_stored(first + i, rows, out.subspan(i * columns(), rows * columns()));
    }
  }

 private:
  // What is read in one call stays in the cache of a core until it is converted.
  [[nodiscard]] std::size_t rows_at_once() const {
    constexpr std::size_t most = std::size_t{1} << 16;
    return std::max<std::size_t>(1, most / columns());
  }

  template <class Number>
  void read_stored(std::size_t first, std::size_t count, std::span<std::complex<Number>> out) const {
    const std::span<Number> numbers(reinterpret_cast<Number*>(out.data()), 2 * out.size());
    std::vector<std::byte> stored(numbers.size() * numbers_.bytes());
    if (plain_) {
      plain_->file.read_all_at(plain_->offset + first * (stored.size() / count), stored);
    } else {
      const Hdf5Use use;
      read_part(samples_, numbers_.type(), first, count, stored.data(), name_);
    }
    numbers_.convert(stored, numbers);
  }

  // The axis, where it is there and of numbers, `width` of them for each of `length`.
  [[nodiscard]] std::optional<Hdf5Dataset> open_axis(const std::string& path, std::size_t length,
                                                     std::size_t width) const {
    auto opened = open_dataset(file_.get(), path, file_bytes_);
    auto* dataset = std::get_if<Hdf5Dataset>(&opened);
    const auto shape = width == 1 ? std::vector<std::uint64_t>{length} : std::vector<std::uint64_t>{length, width};
    if (dataset == nullptr || dataset->shape != shape) return std::nullopt;
    if (!holds_real_numbers(*dataset)) return std::nullopt;
    return std::move(*dataset);
  }

  void read_axis_part(const Hdf5Dataset& axis, const std::string& path, std::size_t first, std::size_t count,
                      std::span<double> out) const {
    read_part(axis, H5T_NATIVE_DOUBLE, first, count, out.data(), fmt::format("{} of {}", path, name_));
  }

  [[nodiscard]] std::optional<std::vector<double>> read_axis(const std::string& name, std::size_t length,
                                                             std::size_t width) const {
    const std::string path = "/" + name;
    const auto axis = open_axis(path, length, width);
    if (!axis) return std::nullopt;
    const auto said = meaning_of_axis(read_attributes(axis->id.get(), file_bytes_, true), path, units_of_axis(name),
                                      kind_of_numbers(axis->type.get()));
    const auto* const meaning = std::get_if<AxisMeaning>(&said);
    if (meaning == nullptr) return std::nullopt;  // InvalidRequest before.
    std::vector<double> values(length * width);
    read_axis_part(*axis, path, 0, length, values);
    if (meaning->factor != 1.0 || meaning->offset != 0.0)
      for (double& value : values) value = value * meaning->factor + meaning->offset;
    return values;
  }

  void try_axis(const std::string& path, std::size_t length, std::size_t width = 1) const {
    constexpr std::size_t at_once = std::size_t{1} << 20U;
    const auto axis = open_axis(path, length, width);
    if (!axis) return;
    std::vector<double> values(width * std::min(length, at_once));
    for (std::size_t first = 0; first < length; first += at_once) {
      const std::size_t count = std::min(at_once, length - first);
      read_axis_part(*axis, path, first, count, std::span(values).first(count * width));
    }
  }

  // Rows one behind the other.
  struct PlainRows {
    core::InputFile file;
    std::uint64_t offset;
  };

  std::string name_;
  Hdf5Handle file_;
  Hdf5Dataset samples_;
  std::optional<PlainRows> plain_;
  std::uint64_t file_bytes_;
  Hdf5Numbers numbers_;
  bool old_layout_;
};

// Numbers that a file says of itself, read from the text of an attribute, 10^shift times its unit.
std::optional<double> number_attribute(const AttributeTexts& attributes, std::string_view name, int shift = 0) {
  const auto text = find_attribute(attributes, name);
  return text ? core::parse_number(*text, shift) : std::nullopt;
}

constexpr const char* old_lsb = "SIMULATION/(mV)_Least_Significant_Bit_value";
constexpr const char* old_rate = "SIMULATION/(GHz)_Sample_frequency";

// The old program named its attributes after the comments of the script and kept the script's units.
void take_old_attributes(RasterInfo& info) {
  const auto bits = number_attribute(info.attributes, "SIMULATION/A/D_bit_accuracy");
  if (bits && *bits >= 1.0 && *bits <= 64.0) info.bits = static_cast<int>(*bits);
  info.lsb_v = number_attribute(info.attributes, old_lsb, -3);
  if (info.lsb_v && !(*info.lsb_v > 0.0)) info.lsb_v.reset();
  info.sample_rate_hz = number_attribute(info.attributes, old_rate, 9);
}

// Numbers of that program that are none, or below 0.
std::optional<core::Problem> problem_of_old_facts(const RasterInfo& info) {
  for (const auto& [name, shift] : {std::pair(old_lsb, -3), std::pair(old_rate, 9)}) {
    const auto text = find_attribute(info.attributes, name);
    if (!text) continue;
    const auto number = core::parse_number(*text, shift);
    if (number && *number >= 0.0) continue;
    return file_problem({}, fmt::format("{} of /Details cannot be", name), fmt::format("{:.40}", *text),
                        "a number from 0 on that is finite in SI units", "correct it");
  }
  return std::nullopt;
}

// Of H5Literate: 0 goes on, 1 ends the walk.
herr_t take_link_name(hid_t /*group*/, const char* name, const H5L_info_t* /*info*/, void* state) {
  auto& names = *static_cast<std::vector<std::string>*>(state);
  if (names.size() == max_details) return 1;
  try {
    names.emplace_back(name);
    return 0;
  } catch (const std::bad_alloc&) {
    return 1;
  }
}

// One walk over all of them: to name the one of a number, the library sorts them all.
std::vector<std::string> link_names(hid_t group) {
  std::vector<std::string> names;
  H5Literate(group, H5_INDEX_NAME, H5_ITER_INC, nullptr, take_link_name, &names);
  return names;
}

// Scripts with the line ends of DOS left a carriage return at the end of names.
std::string without_return(std::string name) {
  if (name.ends_with('\r')) name.pop_back();
  return name;
}

AttributeTexts read_details(hid_t file, std::uint64_t longest) {
  AttributeTexts result;
  if (!has_object(file, "/Details")) return result;
  const Hdf5Handle group(H5Gopen2(file, "/Details", H5P_DEFAULT), H5Gclose);
  if (!group) return result;
  for (const std::string& name : link_names(group.get())) {
    if (!has_object(group.get(), name)) continue;
    const Hdf5Handle object(H5Dopen2(group.get(), name.c_str(), H5P_DEFAULT), H5Dclose);
    if (!object) continue;
    for (auto& [key, value] : read_attributes(object.get(), longest, false).known)
      result.emplace_back(without_return(name) + "/" + without_return(key), std::move(value));
  }
  return result;
}

OpenedRaster refused(const std::string& name, core::Problem problem) {
  problem.place.file = name;
  return {nullptr, {std::move(problem)}};
}

std::string shape_of(const std::vector<std::uint64_t>& shape) {
  std::string text;
  for (const std::uint64_t size : shape) text += fmt::format("{}{}", text.empty() ? "" : " x ", size);
  return text;
}

// Takes the shape over, or says why it is none of samples. `per_sample` is the number of stored columns of a sample.
std::optional<core::Problem> take_shape(RasterInfo& info, const Hdf5Dataset& samples, const char* path,
                                        std::uint64_t per_sample) {
  const auto& shape = samples.shape;
  if (shape.size() != 2)
    return file_problem({}, fmt::format("the dataset {} has the wrong rank", path), fmt::format("{}", shape.size()),
                        "2");
  if (shape[0] == 0 || shape[1] == 0 || shape[1] % per_sample != 0)
    return file_problem({}, fmt::format("the dataset {} holds no whole rows", path),
                        fmt::format("{} x {}", shape[0], shape[1]));
  if (!checked_product(shape[0], shape[1], 2 * sizeof(double)))
    return file_problem({}, fmt::format("the dataset {} is too large", path));
  info.columns = static_cast<std::size_t>(shape[1] / per_sample);
  return std::nullopt;
}

// Takes over what the attributes of the samples say of their numbers.
std::optional<core::Problem> take_meaning(RasterInfo& info, ValueRule& rule, const Hdf5Dataset& samples,
                                          const std::string& path, NumberKind kind, std::uint64_t file_bytes) {
  auto meaning = meaning_of_samples(read_attributes(samples.id.get(), file_bytes, true), "the dataset " + path, kind);
  if (auto* problem = std::get_if<core::Problem>(&meaning)) return std::move(*problem);
  auto& known = std::get<SampleMeaning>(meaning);
  info.counts = known.counts;
  rule = std::move(known.rule);
  return problem_of_dimensions(dimension_names(samples.id.get()), "the dataset " + path);
}

std::optional<core::Problem> describe_samples(RasterInfo& info, ValueRule& rule, const Hdf5Dataset& samples,
                                              const std::string& path, std::uint64_t file_bytes) {
  if (!complex_members(samples.type.get()))
    return file_problem({}, fmt::format("the dataset {} does not hold complex numbers", path), {},
                        "a compound of r and i or of real and imag, both floating-point or both integer");
  if (auto problem = take_shape(info, samples, path.c_str(), 1)) return problem;
  return take_meaning(info, rule, samples, path, kind_of_numbers(samples.type.get()), file_bytes);
}

// The values of an axis some of which may stand for none.
std::optional<core::Problem> problem_of_places(const Hdf5Dataset& axis, const AxisMeaning& meaning,
                                               const std::string& what) {
  if (meaning.valid.is_plain()) return std::nullopt;
  constexpr std::uint64_t at_once = std::uint64_t{1} << 20U;
  const std::uint64_t width = axis.shape.size() > 1 ? axis.shape[1] : 1;
  std::vector<double> values;
  for (std::uint64_t first = 0; first < axis.shape[0]; first += at_once) {
    const std::uint64_t count = std::min(at_once, axis.shape[0] - first);
    values.resize(static_cast<std::size_t>(count * width));
    read_part(axis, H5T_NATIVE_DOUBLE, first, count, values.data(), what);
    if (auto problem = problem_of_missing(meaning, what, values, first * width)) return problem;
  }
  return std::nullopt;
}

// What axes say has to fit the samples: an axis of another length, or in another unit, is that of something else. One
// that cannot be read is none that is not there.
std::optional<core::Problem> problem_of_axis(hid_t file, const std::string& path,
                                             const std::vector<std::uint64_t>& shape, const char* units,
                                             std::uint64_t file_bytes) {
  if (!has_link(file, path)) return std::nullopt;
  const std::string what = "the axis " + path;
  if (!has_object(file, path))
    return file_problem({}, what + " is a link, which is not followed", {}, "a dataset of the file",
                        "put the numbers themselves into the file, or remove the link");
  auto opened = open_dataset(file, path, file_bytes);
  if (auto* problem = std::get_if<core::Problem>(&opened)) return std::move(*problem);
  const auto& axis = std::get<Hdf5Dataset>(opened);
  if (axis.shape != shape)
    return file_problem({}, what + " has not the length of the samples", shape_of(axis.shape), shape_of(shape),
                        "correct it, or rename it");
  if (!holds_real_numbers(axis))
    return file_problem({}, what + " does not hold numbers", {}, "floating-point or whole numbers",
                        "store them as such, or rename it");
  const auto meaning =
      meaning_of_axis(read_attributes(axis.id.get(), file_bytes, true), what, units, kind_of_numbers(axis.type.get()));
  if (const auto* problem = std::get_if<core::Problem>(&meaning)) return *problem;
  return problem_of_places(axis, std::get<AxisMeaning>(meaning), what);
}

std::optional<core::Problem> problem_of_axes(hid_t file, const RasterInfo& info, std::size_t rows,
                                             std::uint64_t file_bytes) {
  for (const AxisLabels& axis : axis_words) {
    const bool across = axis.of == AxisOf::columns;
    if (auto problem =
            problem_of_axis(file, std::string("/") + axis.name, {across ? info.columns : rows}, axis.units, file_bytes))
      return problem;
  }
  for (const PoseAxis& axis : pose_axes)
    if (auto problem = problem_of_axis(file, std::string("/") + axis.name, {rows, 3}, axis.units, file_bytes))
      return problem;
  return std::nullopt;
}

// Numbers of the layout of 2015 are counts, whatever their type.
std::optional<core::Problem> describe_old_samples(RasterInfo& info, ValueRule& rule, const Hdf5Dataset& samples,
                                                  std::uint64_t file_bytes) {
  if (!holds_real_numbers(samples))
    return file_problem({}, fmt::format("the dataset {} does not hold numbers", old_samples_path));
  if (auto problem = take_shape(info, samples, old_samples_path, 2)) return problem;
  NumberKind kind = kind_of_numbers(samples.type.get());
  kind.whole = true;
  if (auto problem = take_meaning(info, rule, samples, old_samples_path, kind, file_bytes)) return problem;
  if (info.counts) return std::nullopt;
  return file_problem({}, fmt::format("the dataset {} has a scale_factor or units, but holds counts", old_samples_path),
                      {}, "neither, or units = count", "remove them: the LSB is in /Details");
}

OpenedRaster open_here(const std::filesystem::path& path, std::uint64_t file_bytes, const RasterHints& hints) {
  const Hdf5Use use;
  const std::string name = path.string();
  auto opened_file = open_hdf5_file(path);
  if (auto* problem = std::get_if<core::Problem>(&opened_file)) return refused(name, std::move(*problem));
  Hdf5Handle file = std::move(std::get<Hdf5Handle>(opened_file));
  const bool old_layout = hints.dataset.empty() && is_of_2015(file.get());
  const std::string samples_are_at = path_of_samples(file.get(), hints.dataset);
  auto opened = open_dataset(file.get(), samples_are_at, file_bytes);
  if (auto* problem = std::get_if<core::Problem>(&opened)) {
    if (!has_object(file.get(), samples_are_at)) {
      problem->found = list_of_datasets(file.get());
      problem->expected = "complex samples";
      if (!problem->found.empty()) problem->hint = "name the dataset of the samples with --dataset NAME";
    }
    return refused(name, std::move(*problem));
  }
  auto& samples = std::get<Hdf5Dataset>(opened);
  RasterInfo info;
  info.path = path;
  ValueRule rule;
  if (auto problem = old_layout ? describe_old_samples(info, rule, samples, file_bytes)
                                : describe_samples(info, rule, samples, samples_are_at, file_bytes))
    return refused(name, std::move(*problem));
  const auto rows = static_cast<std::size_t>(samples.shape[0]);
  if (!old_layout)
    if (auto problem = problem_of_axes(file.get(), info, rows, file_bytes)) return refused(name, std::move(*problem));
  if (hints.rows > 0 && hints.rows != samples.shape[0])
    return refused(name, file_problem({}, "the file has another number of rows", fmt::format("{}", samples.shape[0]),
                                      fmt::format("{}", hints.rows)));
  ArrayAttributes root = read_attributes(file.get(), file_bytes, false);
  if (auto problem = problem_of_root(root)) return refused(name, std::move(*problem));
  info.attributes = old_layout ? read_details(file.get(), file_bytes) : std::move(root.known);
  old_layout ? take_old_attributes(info) : take_known_attributes(info);
  if (old_layout)
    if (auto problem = problem_of_old_facts(info)) return refused(name, std::move(*problem));
  if (info.bits == 0 && hints.bits > 0) info.bits = hints.bits;
  if (!info.lsb_v && hints.lsb_v > 0.0) info.lsb_v = hints.lsb_v;
  const auto raster =
      std::make_shared<Hdf5Raster>(info, name, std::move(file), std::move(samples), file_bytes, old_layout);
  raster->read_past_the_library();
  raster->set_value_rule(std::move(rule));
  return {raster, {}};
}

// Reads what a file claims to hold: all of a small one; of a large one the ends and the axes.
void read_through(const Hdf5Raster& raster) {
  raster.try_axes();
  if (raster.columns() > max_tried_samples) return;
  const std::size_t rows = std::min(raster.rows(), max_tried_samples / raster.columns());
  std::vector<std::complex<double>> samples(rows * raster.columns());
  raster.read_rows(0, rows, samples);
  raster.read_rows(raster.rows() - rows, rows, samples);
}

// A problem as text and back, for the way from one process to the other.
std::string packed(const core::Problem& problem) {
  return problem.message + '\0' + problem.found + '\0' + problem.expected + '\0' + problem.hint;
}

core::Problem unpacked(const std::string& text) {
  std::array<std::string, 4> part;
  std::size_t index = 0;
  for (const char c : text)
    if (c == '\0' && index + 1 < part.size())
      ++index;
    else
      part[index] += c;
  return core::error(part[0]).found(part[1]).expected(part[2]).hint(part[3]);
}

core::Problem lacks_memory(const std::string& what, std::uint64_t own_limit_bytes) {
  if (own_limit_bytes > 0)
    return file_problem({}, "the HDF5 library needs more memory for the file than this process may have", what,
                        fmt::format("at most {} MB, the limit of this process", own_limit_bytes >> 20U),
                        "raise the limit (ulimit -v)");
  return file_problem({}, "the HDF5 library needs more memory for the file than it is given", what,
                      fmt::format("at most {} MB more than the program has", core::isolated_bytes >> 20U),
                      "the file is damaged, or stored in very large chunks: h5repack makes them smaller");
}

// What the child process does: the word that all is well, or a packed problem.
// @param own_limit_bytes  that of the parent
std::string tried(const std::filesystem::path& path, std::uint64_t file_bytes, const RasterHints& hints,
                  std::uint64_t own_limit_bytes) {
  try {
    const OpenedRaster opened = open_here(path, file_bytes, hints);
    if (!opened.raster) return packed(opened.problems.front());
    read_through(static_cast<const Hdf5Raster&>(*opened.raster));
    return good;
  } catch (const LacksMemory& error) {
    return packed(lacks_memory(error.what(), own_limit_bytes));
  } catch (const std::bad_alloc&) {
    return packed(lacks_memory({}, own_limit_bytes));
  } catch (const std::exception& error) {
    return packed(file_problem({}, "the file is damaged: the HDF5 library cannot read all of it", error.what()));
  }
}

}  // namespace

OpenedRaster open_hdf5(const std::filesystem::path& path, std::uint64_t file_bytes, const RasterHints& hints,
                       const core::StopFlag* stop) {
  // libhdf5 trusts what a file says of itself; a damaged one can make it crash, hang or ask for any amount of memory.
  // So a child process goes first, and this one opens only what the child could read.
  const std::uint64_t own_limit_bytes = core::own_memory_limit_bytes();
  const core::IsolatedReport trial = hdf5_trial([&] { return tried(path, file_bytes, hints, own_limit_bytes); }, stop);
  if (trial.result == core::IsolatedResult::too_much_work) return refused(path.string(), too_much_hdf5_work());
  if (trial.result != core::IsolatedResult::passed)
    return refused(path.string(), file_problem({}, "the file is damaged: the HDF5 library crashes on it"));
  if (trial.text.empty())
    return refused(path.string(), file_problem({}, "the file is damaged: the HDF5 library cannot read all of it"));
  if (trial.text != good) return refused(path.string(), unpacked(trial.text));
  return open_here(path, file_bytes, hints);
}

}  // namespace sarsim::raster
