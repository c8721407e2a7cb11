#include <algorithm>
#include <complex>
#include <filesystem>
#include <limits>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "core/os/input_file.hpp"
#include "core/task/stop_points.hpp"
#include "raster/format/format_reader.hpp"
#include "raster/format/npy_array.hpp"
#include "raster/format/zarr_metadata.hpp"
#include "raster/table/axis_labels.hpp"
#include "raster/table/cf_attributes.hpp"
#include "raster/table/described_product.hpp"
#include "raster/table/file_problem.hpp"
#include "raster/table/pose_axes.hpp"

namespace sarsim::raster {

namespace fs = std::filesystem;

namespace {

// More files than anybody looks through.
constexpr std::uint64_t max_chunks = std::uint64_t{1} << 22U;
constexpr std::size_t max_arrays = 1000;
constexpr std::size_t chunks_at_once = 256;  // Looked for between two questions for a stop: a millisecond.

std::uint64_t pieces_in(std::uint64_t size, std::uint64_t piece) { return size / piece + (size % piece > 0 ? 1 : 0); }

// Some of the indices of a window along one dimension: [first, first + count).
struct Stretch {
  std::size_t first = 0;
  std::size_t count = 0;
};

// A table of numbers in chunks, each a file.
class ChunkTable {
 public:
  // Of an array whose type and shape are those of a table.
  ChunkTable(fs::path folder, const ZarrArray& array, const NpyType& type, const NpyPlane& plane)
      : folder_(std::move(folder)), separator_(array.separator), fill_(array.fill), plane_(plane) {
    const bool one_row = array.shape.size() == (plane.components > 1 ? 2U : 1U);
    levels_ = array.shape.size();
    down_ = one_row ? none : 0;
    across_ = one_row ? 0 : 1;
    chunk_rows_ = one_row ? 1 : std::min(array.chunks[0], plane.rows);
    chunk_columns_ = std::min(array.chunks[across_], plane.columns);
    stored_rows_ = one_row ? 1 : array.chunks[0];
    grid_.columns = static_cast<std::size_t>(array.chunks[across_]);
    grid_.sample_bytes = type.bytes * (type.pair ? 2U : 1U) * static_cast<std::size_t>(plane.components);
    // Each number of a pair has the value.
    if (plane.components > 1 && fill_) fill_ = {fill_->real(), fill_->real()};
    grid_.decode = type.decoder(plane.value == ImageValue::complex, false, false);
  }

  [[nodiscard]] std::uint64_t rows() const { return plane_.rows; }
  [[nodiscard]] std::uint64_t columns() const { return plane_.columns; }
  [[nodiscard]] const StoredGrid& grid() const { return grid_; }
  [[nodiscard]] const fs::path& folder() const { return folder_; }
  // Whether chunks are files of that folder, and of no others in it.
  [[nodiscard]] bool in_one_folder() const { return separator_ == '.'; }
  [[nodiscard]] bool has_fill() const { return fill_.has_value(); }
  [[nodiscard]] std::uint64_t chunks_down() const { return pieces_in(plane_.rows, chunk_rows_); }
  [[nodiscard]] std::uint64_t chunks_across() const { return pieces_in(plane_.columns, chunk_columns_); }
  // Of the file of a chunk; nothing where it has more than anything.
  [[nodiscard]] std::optional<std::uint64_t> chunk_bytes() const {
    return checked_product(stored_rows_, grid_.columns, grid_.sample_bytes);
  }

  [[nodiscard]] fs::path chunk_path(std::uint64_t down, std::uint64_t across) const {
    std::string name;
    for (std::size_t level = 0; level < levels_; ++level) {
      if (level > 0) name += separator_;
      name += std::to_string(level == down_ ? down : level == across_ ? across : 0);
    }
    return folder_ / name;
  }

  void read(const ImageWindow& window, std::span<std::complex<float>> out, const core::WorkControl& control) const {
    each_chunk(window, [&](const fs::path& path, const Stretch& rows, const Stretch& cols, std::uint64_t row0,
                           std::uint64_t col0) {
      const ImageWindow inside{window.row(rows.first) - row0,
                               rows.count,
                               window.column(cols.first) - col0,
                               cols.count,
                               window.row_step,
                               window.col_step};
      const auto part = [&](std::span<std::complex<float>> samples) {
        if (const auto file = open(path))
          read_grid(*file, grid_, inside, samples, control);
        else
          std::ranges::fill(samples, filled<float>());
      };
      place(out, window.cols, rows, cols, part);
    });
  }

  void read_rows(std::size_t first, std::size_t count, std::span<std::complex<double>> out) const {
    const ImageWindow window{first, count, 0, static_cast<std::size_t>(plane_.columns)};
    each_chunk(window, [&](const fs::path& path, const Stretch& rows, const Stretch& cols, std::uint64_t row0,
                           std::uint64_t) {
      const auto part = [&](std::span<std::complex<double>> samples) {
        if (const auto file = open(path))
          decode_rows(*file, static_cast<std::size_t>(window.row(rows.first) - row0), rows.count, cols.count, samples);
        else
          std::ranges::fill(samples, filled<double>());
      };
      place(out, window.cols, rows, cols, part);
    });
  }

 private:
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  template <class Real>
  [[nodiscard]] std::complex<Real> filled() const {
    return std::complex<Real>(fill_.value_or(0.0));
  }

  // Nothing where the chunk is not there, which was found to be allowed.
  static std::optional<core::InputFile> open(const fs::path& path) {
    std::error_code ignored;
    if (!fs::exists(path, ignored)) return std::nullopt;
    auto opened = core::InputFile::open(path);
    if (const auto* problem = std::get_if<core::Problem>(&opened))
      throw std::runtime_error(path.string() + ": " + problem->message);
    return std::move(std::get<core::InputFile>(opened));
  }

  // Whole rows of a chunk, of which the last ones may have more columns than the table.
  void decode_rows(const core::InputFile& file, std::size_t first, std::size_t count, std::size_t columns,
                   std::span<std::complex<double>> out) const {
    if (columns == grid_.columns) return read_grid_rows(file, grid_, first, out);
    StoredGrid row = grid_;
    for (std::size_t i = 0; i < count; ++i) {
      row.offset = (first + i) * grid_.row_bytes();
      read_grid_rows(file, row, 0, out.subspan(i * columns, columns));
    }
  }

  // The samples of a chunk where they belong: at once where they stand in one piece there.
  template <class Sample, class Part>
  static void place(std::span<Sample> out, std::size_t width, const Stretch& rows, const Stretch& cols,
                    const Part& part) {
    if (cols.count == width) return part(out.subspan(rows.first * width, rows.count * width));
    std::vector<Sample> samples(rows.count * cols.count);
    part(std::span(samples));
    for (std::size_t i = 0; i < rows.count; ++i)
      std::copy_n(samples.begin() + static_cast<std::ptrdiff_t>(i * cols.count), cols.count,
                  out.begin() + static_cast<std::ptrdiff_t>((rows.first + i) * width + cols.first));
  }

  // Calls use(path, rows, columns, first row and first column of the chunk) for each chunk that a window meets.
  template <class Use>
  void each_chunk(const ImageWindow& window, const Use& use) const {
    const auto stretch = [](std::size_t first, std::size_t count, std::size_t from, std::size_t step,
                            std::uint64_t piece) {
      const std::uint64_t at = from + std::uint64_t{first} * step;
      const std::uint64_t end = (at / piece + 1) * piece;
      return Stretch{first,
                     static_cast<std::size_t>(std::min<std::uint64_t>(count - first, (end - at - 1) / step + 1))};
    };
    for (Stretch rows; rows.first < window.rows; rows.first += rows.count) {
      rows = stretch(rows.first, window.rows, window.row0, window.row_step, chunk_rows_);
      const std::uint64_t down = window.row(rows.first) / chunk_rows_;
      for (Stretch cols; cols.first < window.cols; cols.first += cols.count) {
        cols = stretch(cols.first, window.cols, window.col0, window.col_step, chunk_columns_);
        const std::uint64_t across = window.column(cols.first) / chunk_columns_;
        use(chunk_path(down, across), rows, cols, down * chunk_rows_, across * chunk_columns_);
      }
    }
  }

  fs::path folder_;
  char separator_;
  std::optional<std::complex<double>> fill_;
  NpyPlane plane_;
  std::size_t levels_ = 0;   // Numbers in the name of a chunk.
  std::size_t down_ = none;  // Which of them counts down, and which across.
  std::size_t across_ = 0;
  std::uint64_t chunk_rows_ = 1;
  std::uint64_t chunk_columns_ = 1;
  std::uint64_t stored_rows_ = 1;  // In the file of a chunk, which may have more than the table.
  StoredGrid grid_;
};

// A table, or what keeps the array from being one.
using TableReading = std::variant<ChunkTable, core::Problem>;

// @param samples  they must be complex; otherwise any numbers
TableReading table_of(const fs::path& folder, const ZarrArray& array, bool samples) {
  const std::string name = folder.string();
  const NpyHeader header{array.type, false, array.shape, 0};
  const NpyType* const type = npy_sample_type_of(header);
  if (type == nullptr)
    return array.type.starts_with('>')
               ? file_problem(name, "the array is big-endian", array.type, npy_sample_types(),
                              "store it with array.astype(array.dtype.newbyteorder('<'))")
               : file_problem(name, "the array's type is not one of samples", array.type, npy_sample_types());
  const auto plane = npy_plane_of(header, *type);
  if (!plane || plane->value == ImageValue::rgb || (samples && plane->value != ImageValue::complex))
    return file_problem(name, "the array's shape is not one of samples", shape_text(array.shape),
                        type->pair ? "(rows, columns)" : "(rows, columns, 2)");
  if (plane->components > 1 && array.chunks.back() != plane->components)
    return file_problem(name, "I and Q are in different chunks", shape_text(array.chunks), {},
                        "store the array in chunks of whole pairs");
  return ChunkTable(folder, array, *type, *plane);
}

// How much of a table is there.
struct Presence {
  std::uint64_t missing = 0;
  fs::path first_missing = {};
};

core::Problem nearly_all_missing(const std::string& name, std::uint64_t missing, std::uint64_t chunks) {
  return file_problem(name, "nearly all chunks of the array are missing", fmt::format("{} of {}", missing, chunks), {},
                      "copy the store anew");
}

// Files and folders in a folder, counted up to `most`.
std::uint64_t entries_in(const fs::path& folder, std::uint64_t most) {
  std::uint64_t count = 0;
  std::error_code failure;
  for (fs::directory_iterator entry(folder, failure), end; !failure && entry != end && count < most;
       entry.increment(failure))
    ++count;
  return count;
}

// Looks at every chunk; a problem where one has not its size.
std::variant<Presence, core::Problem> look_through(const ChunkTable& table, const std::string& name,
                                                   core::StopPoints stop) {
  const auto chunks = checked_product(table.chunks_down(), table.chunks_across());
  if (!chunks || *chunks > max_chunks)
    return file_problem(name, "the array has more chunks than are read", {}, fmt::format("at most {}", max_chunks),
                        "store it in larger chunks");
  // An array may claim any size where nothing of it is there.
  constexpr std::uint64_t max_absent = 1032;
  const std::uint64_t least = *chunks / (max_absent + 1);
  if (table.in_one_folder() && entries_in(table.folder(), least) < least)
    return nearly_all_missing(name, *chunks - entries_in(table.folder(), least), *chunks);
  const auto bytes = table.chunk_bytes();
  Presence presence;
  for (std::uint64_t i = 0; i < *chunks; ++i) {
    stop.pass();
    const fs::path path = table.chunk_path(i / table.chunks_across(), i % table.chunks_across());
    std::error_code failure;
    const fs::file_status status = fs::symlink_status(path, failure);
    if (status.type() == fs::file_type::not_found) {
      if (presence.missing++ == 0) presence.first_missing = path;
      continue;
    }
    if (!fs::is_regular_file(status))
      return file_problem(path.string(), "a chunk is not a regular file", {}, {},
                          "links are not followed: put the files themselves into the store");
    const std::uint64_t size = fs::file_size(path, failure);
    if (failure || !bytes || size != *bytes)
      return file_problem(path.string(), "a chunk has not the size of its array", fmt::format("{} bytes", size),
                          bytes ? fmt::format("{} bytes", *bytes) : "a size that a file can have",
                          "the file is cut off, or belongs to another array");
  }
  if (presence.missing == *chunks || *chunks - presence.missing < least)
    return nearly_all_missing(name, presence.missing, *chunks);
  return presence;
}

// An axis of a store, which is there as a whole.
struct ZarrAxis {
  ChunkTable table;
  AxisMeaning meaning;
  Presence presence;

  // All its numbers, as they are stored.
  [[nodiscard]] std::vector<double> stored() const {
    std::vector<std::complex<double>> read(static_cast<std::size_t>(table.rows() * table.columns()));
    table.read_rows(0, static_cast<std::size_t>(table.rows()), read);
    std::vector<double> numbers(read.size());
    std::ranges::transform(read, numbers.begin(), [](const std::complex<double>& number) { return number.real(); });
    return numbers;
  }
};

std::variant<std::monostate, ZarrAxis, core::Problem> axis_in(const fs::path& group, const std::string& name,
                                                              const std::vector<std::uint64_t>& shape,
                                                              const core::StopFlag* stop);

std::vector<std::uint64_t> shape_of_axis(std::size_t length, std::size_t width) {
  return width == 1 ? std::vector<std::uint64_t>{length} : std::vector<std::uint64_t>{length, width};
}

class ZarrRaster final : public Raster {
 public:
  // @param group  folder of the arrays beside it; empty where there are none
  ZarrRaster(RasterInfo info, ChunkTable samples, fs::path group)
      : Raster(std::move(info)), samples_(std::move(samples)), group_(std::move(group)) {}

  [[nodiscard]] std::size_t rows() const override { return static_cast<std::size_t>(samples_.rows()); }
  [[nodiscard]] double read_cost_s(const ImageWindow& window) const override {
    return grid_cost_s(samples_.grid(), window);
  }
  [[nodiscard]] std::optional<RasterAxes> axes() const override {
    if (group_.empty()) return std::nullopt;
    return read_axes(rows(), columns(), [this](const std::string& name, std::size_t length, std::size_t width) {
      return read_numbers(group_, name, length, width);
    });
  }

 protected:
  void read_samples(const ImageWindow& window, std::span<std::complex<float>> out,
                    const core::WorkControl& control) const override {
    samples_.read(window, out, control);
  }
  void read_whole_rows(std::size_t first, std::size_t count, std::span<std::complex<double>> out) const override {
    samples_.read_rows(first, count, out);
  }

 private:
  // Nothing where there is none; what is wrong with one was refused when the store was opened.
  static std::optional<std::vector<double>> read_numbers(const fs::path& group, const std::string& name,
                                                         std::size_t length, std::size_t width) {
    const auto found = axis_in(group, name, shape_of_axis(length, width), nullptr);
    const auto* const axis = std::get_if<ZarrAxis>(&found);
    if (axis == nullptr || (axis->presence.missing > 0 && !axis->table.has_fill())) return std::nullopt;
    std::vector<double> values = axis->stored();
    for (double& value : values) value = value * axis->meaning.factor + axis->meaning.offset;
    return values;
  }

  ChunkTable samples_;
  fs::path group_;
};

OpenedRaster refuse_store(const fs::path& folder, core::Problem problem) {
  if (problem.place.file.empty()) problem.place.file = folder.string();
  return {nullptr, {std::move(problem)}};
}

// Nothing of a store may be a link: what it leads to is not in the store.
std::optional<core::Problem> problem_of_link(const fs::path& path) {
  std::error_code ignored;
  if (!fs::is_symlink(fs::symlink_status(path, ignored))) return std::nullopt;
  return file_problem(path.string(), "a part of the store is a link", {}, "a folder or a file of the store",
                      "links are not followed: put the files themselves into the store");
}

// As NumPy writes types; those with a sign but for "u".
NumberKind kind_of_type(const std::string& type) {
  const char letter = type.size() > 1 ? type[1] : 'f';
  return {letter == 'i' || letter == 'u', letter != 'u'};
}

std::vector<std::string> dimensions_of(const ArrayAttributes& attributes) {
  std::vector<std::string> dimensions;
  const std::string names = attribute_of(attributes.known, "_ARRAY_DIMENSIONS");
  for (std::string_view rest = names; !rest.empty();) {
    const std::size_t comma = std::min(rest.find(", "), rest.size());
    dimensions.emplace_back(rest.substr(0, comma));
    rest.remove_prefix(std::min(comma + 2, rest.size()));
  }
  return dimensions;
}

// Each dimension of an array has a name, where any has one.
std::optional<core::Problem> problem_of_names(const ArrayAttributes& attributes, const ZarrArray& array,
                                              const std::string& what) {
  constexpr const char* key = "_ARRAY_DIMENSIONS";
  const auto unreadable = std::ranges::find(attributes.unreadable, key, &std::pair<std::string, std::string>::first);
  const std::size_t names = dimensions_of(attributes).size();
  const bool known = unreadable == attributes.unreadable.end();
  if (known && (names == 0 || names == array.shape.size())) return std::nullopt;
  return file_problem({}, fmt::format("{}: its attribute {} does not name its dimensions", what, key),
                      known ? fmt::format("{} names", names) : unreadable->second,
                      fmt::format("{} names", array.shape.size()), "correct it, or remove it");
}

// How numbers become samples, by the attributes of their array.
std::variant<SampleMeaning, core::Problem> meaning_in(const fs::path& folder, const ZarrArray& array) {
  const auto attributes = read_zarr_attributes(folder / ".zattrs", true);
  if (const auto* problem = std::get_if<core::Problem>(&attributes)) return *problem;
  const auto& known = std::get<ArrayAttributes>(attributes);
  const std::string what = "the array " + folder.filename().string();
  if (auto problem = problem_of_names(known, array, what)) return std::move(*problem);
  if (auto problem = problem_of_dimensions(dimensions_of(known), what)) return std::move(*problem);
  return meaning_of_samples(known, what, kind_of_type(array.type));
}

// An axis; nothing where the store has none of that name, and a problem where it has one that cannot be read: it has to
// fit the samples, its unit its name, and it has to be there as a whole.
std::variant<std::monostate, ZarrAxis, core::Problem> axis_in(const fs::path& group, const std::string& name,
                                                              const std::vector<std::uint64_t>& shape,
                                                              const core::StopFlag* stop) {
  std::error_code ignored;
  const fs::path folder = group / name;
  if (!fs::exists(fs::symlink_status(folder, ignored))) return {};
  for (const fs::path& part : {folder, folder / ".zarray", folder / ".zattrs"})
    if (auto problem = problem_of_link(part)) return std::move(*problem);
  auto read = read_zarr_array(folder / ".zarray");
  if (auto* problem = std::get_if<core::Problem>(&read)) return std::move(*problem);
  const auto& array = std::get<ZarrArray>(read);
  if (array.shape != shape)
    return file_problem(folder.string(), "the axis has not the length of the samples", shape_text(array.shape),
                        shape_text(shape), "correct it, or rename it");
  auto reading = table_of(folder, array, false);
  if (auto* problem = std::get_if<core::Problem>(&reading)) return std::move(*problem);
  auto& table = std::get<ChunkTable>(reading);
  auto presence = look_through(table, folder.string(), {stop, chunks_at_once});
  if (auto* problem = std::get_if<core::Problem>(&presence)) return std::move(*problem);
  const auto attributes = read_zarr_attributes(folder / ".zattrs", true);
  if (const auto* problem = std::get_if<core::Problem>(&attributes)) return *problem;
  const auto& known = std::get<ArrayAttributes>(attributes);
  const std::string what = "the axis " + name;
  if (auto problem = problem_of_names(known, array, what)) return std::move(*problem);
  const auto meaning = meaning_of_axis(known, what, units_of_axis(name), kind_of_type(array.type));
  if (const auto* problem = std::get_if<core::Problem>(&meaning)) return *problem;
  return ZarrAxis{std::move(table), std::get<AxisMeaning>(meaning), std::get<Presence>(presence)};
}

// What is missing of an array, as a problem.
core::Problem missing_chunks(const ChunkTable& array, const Presence& presence, bool own, bool whole) {
  const bool refused = whole && (own || !array.has_fill());
  core::Problem problem =
      file_problem(presence.first_missing.string(), "chunks of the array are missing",
                   fmt::format("{} of {}", presence.missing, array.chunks_down() * array.chunks_across()), {},
                   own || !array.has_fill() ? "copy the store anew" : "they are read as the fill value of the array");
  return refused ? problem : with_severity(std::move(problem), core::Severity::warning);
}

// What is wrong with the axes of a store: those that cannot be read, and warnings of those that are not whole.
core::Problems problems_of_zarr_axes(const fs::path& group, std::uint64_t rows, std::uint64_t columns, bool own,
                                     bool whole, const core::StopFlag* stop) {
  core::Problems problems;
  const auto keep = [&](core::Problem problem, const std::string& name) {
    if (problem.place.file.empty()) problem.place.file = (group / name).string();
    problems.push_back(std::move(problem));
  };
  const auto judge = [&](const std::string& name, const std::vector<std::uint64_t>& shape) {
    auto found = axis_in(group, name, shape, stop);
    if (auto* problem = std::get_if<core::Problem>(&found)) keep(std::move(*problem), name);
    const auto* const axis = std::get_if<ZarrAxis>(&found);
    if (axis == nullptr) return;
    if (axis->presence.missing > 0) keep(missing_chunks(axis->table, axis->presence, own, whole), name);
    if (axis->meaning.valid.is_plain()) return;
    if (auto problem = problem_of_missing(axis->meaning, "the axis " + name, axis->stored()))
      keep(std::move(*problem), name);
  };
  for (const AxisLabels& axis : axis_words) judge(axis.name, {axis.of == AxisOf::columns ? columns : rows});
  for (const PoseAxis& axis : pose_axes) judge(axis.name, {rows, 3});
  return problems;
}

// The folder of the store whose array was opened itself.
fs::path store_of_array(const fs::path& folder) {
  const fs::path whole = folder.has_filename() ? folder : folder.parent_path();
  return whole.has_parent_path() ? whole.parent_path() : fs::path(".");
}

// All files of a store that say what is read of it.
std::optional<core::Problem> problem_of_consolidated(const fs::path& folder, const fs::path& place, bool alone) {
  const fs::path array = (place.has_filename() ? place : place.parent_path()).filename();
  std::vector<fs::path> names{array / ".zarray", array / ".zattrs"};
  if (alone) return contradiction_of_zarr(store_of_array(folder), names);
  names.emplace_back(".zattrs");
  const auto add = [&](const fs::path& name) {
    names.push_back(name / ".zarray");
    names.push_back(name / ".zattrs");
  };
  for (const AxisLabels& axis : axis_words) add(axis.name);
  for (const PoseAxis& axis : pose_axes) add(axis.name);
  return contradiction_of_zarr(folder, names);
}

// The array of samples of a group: that of this name, or the only one that can be.
std::variant<fs::path, core::Problem> samples_in(const fs::path& group) {
  std::error_code failure;
  if (fs::exists(group / "samples" / ".zarray", failure)) return group / "samples";
  std::vector<fs::path> found;
  std::size_t looked_at = 0;
  for (fs::directory_iterator entry(group, failure), end; !failure && entry != end; entry.increment(failure)) {
    if (++looked_at > max_arrays) break;
    if (!fs::exists(entry->path() / ".zarray", failure)) continue;
    const auto array = read_zarr_array(entry->path() / ".zarray");
    const auto* const known = std::get_if<ZarrArray>(&array);
    const bool suits = known != nullptr && std::holds_alternative<ChunkTable>(table_of(entry->path(), *known, true));
    if (suits) found.push_back(entry->path());
  }
  std::ranges::sort(found);
  if (found.size() == 1) return found.front();
  if (found.empty())
    return file_problem(
        group.string(), "the store has no array of complex samples", {},
        "an array called samples, or one alone of the type <c8 or <c16 with two dimensions, not compressed",
        "name the array itself: STORE/ARRAY");
  std::string names;
  for (const fs::path& path : found) names += (names.empty() ? "" : ", ") + path.filename().string();
  return file_problem(group.string(), "several arrays of the store may hold samples", names, "one",
                      fmt::format("name one of them: {}", found.front().string()));
}

}  // namespace

OpenedRaster open_zarr(const fs::path& folder, const Format&, const RasterHints& hints, Integrity integrity,
                       const core::StopFlag* stop) {
  std::error_code ignored;
  if (fs::exists(folder / "zarr.json", ignored))
    return refuse_store(folder, file_problem({}, "the store is of version 3 of Zarr", "zarr.json", "version 2",
                                             "store it with zarr_format=2, not compressed"));
  const bool alone = fs::exists(folder / ".zarray", ignored);
  fs::path place = folder;
  if (!alone) {
    auto found = samples_in(folder);
    if (auto* problem = std::get_if<core::Problem>(&found)) return refuse_store(folder, std::move(*problem));
    place = std::get<fs::path>(found);
  }
  for (const fs::path& part : {folder / ".zattrs", place, place / ".zarray", place / ".zattrs"})
    if (part != folder)
      if (auto problem = problem_of_link(part)) return refuse_store(folder, std::move(*problem));
  if (auto problem = problem_of_consolidated(folder, place, alone)) return refuse_store(folder, std::move(*problem));
  auto read = read_zarr_array(place / ".zarray");
  if (auto* problem = std::get_if<core::Problem>(&read)) return refuse_store(folder, std::move(*problem));
  auto reading = table_of(place, std::get<ZarrArray>(read), true);
  if (auto* problem = std::get_if<core::Problem>(&reading)) return refuse_store(folder, std::move(*problem));
  auto& samples = std::get<ChunkTable>(reading);
  if (hints.rows > 0 && hints.rows != samples.rows())
    return refuse_store(folder, file_problem({}, "the array has another number of rows",
                                             fmt::format("{}", samples.rows()), fmt::format("{}", hints.rows)));
  auto presence = look_through(samples, place.string(), {stop, chunks_at_once});
  if (auto* problem = std::get_if<core::Problem>(&presence)) return refuse_store(folder, std::move(*problem));
  auto attributes = read_zarr_attributes(folder / ".zattrs");
  if (auto* problem = std::get_if<core::Problem>(&attributes)) return refuse_store(folder, std::move(*problem));
  RasterInfo info;
  info.path = folder;
  info.columns = static_cast<std::size_t>(samples.columns());
  auto& root = std::get<ArrayAttributes>(attributes);
  if (auto problem = problem_of_root(root)) return refuse_store(folder, std::move(*problem));
  info.attributes = std::move(root.known);
  take_known_attributes(info);
  if (info.bits == 0 && hints.bits > 0) info.bits = hints.bits;
  if (!info.lsb_v && hints.lsb_v > 0.0) info.lsb_v = hints.lsb_v;
  auto meaning = meaning_in(place, std::get<ZarrArray>(read));
  if (auto* problem = std::get_if<core::Problem>(&meaning)) return refuse_store(folder, std::move(*problem));
  info.counts = std::get<SampleMeaning>(meaning).counts;
  const bool own = !attribute_of(info.attributes, "program_version").empty();
  const bool whole = integrity == Integrity::whole;
  core::Problems problems;
  if (!alone) problems = problems_of_zarr_axes(folder, samples.rows(), samples.columns(), own, whole, stop);
  if (const Presence& there = std::get<Presence>(presence); there.missing > 0)
    problems.push_back(missing_chunks(samples, there, own, whole));
  if (core::has_errors(problems)) return {nullptr, std::move(problems)};
  auto raster = std::make_shared<ZarrRaster>(std::move(info), std::move(samples), alone ? fs::path() : folder);
  raster->set_value_rule(std::move(std::get<SampleMeaning>(meaning).rule));
  return {std::move(raster), std::move(problems)};
}

OpenedRaster open_zarr_file(core::InputFile file, const Format&, const RasterHints&, Integrity, const core::StopFlag*) {
  return {nullptr,
          {file_problem(file.path().string(), "a Zarr store is a folder, and this is a file", {},
                        "a folder with .zgroup or .zarray", "unpack the store, or name the folder")}};
}

}  // namespace sarsim::raster
