#include <algorithm>
#include <array>
#include <atomic>
#include <cstring>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "raster/format/npy_header.hpp"
#include "workflow/input/cloud_table.hpp"

namespace sarsim::workflow {

namespace {

constexpr std::size_t min_columns = 3;
constexpr std::size_t max_columns = 5;  // x, y, z, cross-section, phase
constexpr std::size_t phase_column = 4;
constexpr std::size_t range_rows = std::size_t{1} << 15;
constexpr const char* wanted_shape = "an array of N rows and 3 or 4 columns: x, y, z and cross-section";

// Where the columns of a table of points are within what is stored for each point.
struct PointColumns {
  std::array<std::optional<std::size_t>, max_columns> offset;  // Bytes; nothing: the table has no such column.
  std::size_t stride = 0;                                      // From one point to the next.
};

// Names that fields of structures may have, for each column.
constexpr std::array<std::array<std::string_view, 6>, max_columns> field_names{{
    {"x", "x_m", "X", "", "", ""},
    {"y", "y_m", "Y", "", "", ""},
    {"z", "z_m", "Z", "", "", ""},
    {"rcs", "rcs_m2", "sigma", "cross_section", "RCS", "cross_section_m2"},
    {"phase", "phase_rad", "", "", "", ""},
}};

// The numbers of one file.
template <class Number>
class NpyPoints {
 public:
  NpyPoints(const core::InputFile& file, const raster::NpyHeader& header, const PointColumns& columns,
            PointTable& table)
      : file_(file), header_(header), table_(table), rows_(header.shape[0]), columns_(columns) {}

  std::optional<TableFault> read(const core::WorkControl& control) {
    resize(table_.arrays, rows_, control);
    table_.own_rcs = columns_.offset[min_columns].has_value();
    core::parallel_ranges(rows_, range_rows, control, [&](std::size_t begin, std::size_t end) {
      if (header_.fortran_order && header_.fields.empty())
        read_columns(begin, end);
      else
        read_rows(begin, end);
    });
    const std::size_t row = turned_row_.load();
    if (row == none) return std::nullopt;
    return fault_of_phase("row", row + 1, turned_by_.load());
  }

 private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  static Number number_at(const std::byte* bytes) {
    Number number;
    std::memcpy(&number, bytes, sizeof number);
    return number;
  }

  void read_rows(std::size_t begin, std::size_t end) {
    std::vector<std::byte> read((end - begin) * columns_.stride);
    file_.read_all_at(header_.data_offset + std::uint64_t{begin} * columns_.stride, read);
    for (std::size_t column = 0; column < max_columns; ++column)
      if (const auto offset = columns_.offset[column])
        take(column, begin, end, [&](std::size_t i) { return number_at(read.data() + i * columns_.stride + *offset); });
  }

  void read_columns(std::size_t begin, std::size_t end) {
    std::vector<std::byte> read((end - begin) * sizeof(Number));
    for (std::size_t column = 0; column < max_columns; ++column) {
      if (!columns_.offset[column]) continue;
      file_.read_all_at(header_.data_offset + (std::uint64_t{column} * rows_ + begin) * sizeof(Number), read);
      take(column, begin, end, [&](std::size_t i) { return number_at(read.data() + i * sizeof(Number)); });
    }
  }

  template <class At>
  void take(std::size_t column, std::size_t begin, std::size_t end, const At& at) {
    if (column == phase_column) return expect_zeros(begin, end, at);
    radar::PointArrays& arrays = table_.arrays;
    const std::array<double*, 4> into{arrays.x_m.data(), arrays.y_m.data(), arrays.z_m.data(),
                                      arrays.root_rcs_m.data()};
    double* const to = into[column] + begin;
    for (std::size_t i = 0; i < end - begin; ++i) to[i] = static_cast<double>(at(i));
  }

  template <class At>
  void expect_zeros(std::size_t begin, std::size_t end, const At& at) {
    for (std::size_t i = 0; i < end - begin; ++i) {
      if (at(i) == Number{0}) continue;
      std::size_t known = turned_row_.load();
      while (begin + i < known && !turned_row_.compare_exchange_weak(known, begin + i)) {
      }
      if (turned_row_.load() == begin + i) turned_by_ = static_cast<double>(at(i));
      return;
    }
  }

  const core::InputFile& file_;
  const raster::NpyHeader& header_;
  PointTable& table_;
  std::size_t rows_;
  PointColumns columns_;
  std::atomic<std::size_t> turned_row_{none};
  std::atomic<double> turned_by_{0.0};
};

// The columns of an array of numbers, as many as there are.
PointColumns columns_of_array(std::uint64_t columns, std::size_t number_bytes) {
  PointColumns found;
  for (std::size_t i = 0; i < columns; ++i) found.offset[i] = i * number_bytes;
  found.stride = static_cast<std::size_t>(columns) * number_bytes;
  return found;
}

// The columns of structures by the names of their fields, and the type of the numbers, which is one for all of them.
std::variant<PointColumns, TableFault> columns_of_fields(const raster::NpyHeader& header, std::string& type) {
  PointColumns found;
  found.stride = header.structure_bytes();
  std::string names;
  for (const raster::NpyField& field : header.fields) {
    names += (names.empty() ? "" : ", ") + field.name.substr(0, 20);
    for (std::size_t column = 0; column < max_columns; ++column) {
      if (std::ranges::find(field_names[column], field.name) == field_names[column].end() || field.name.empty())
        continue;
      if (field.count != 1 || (type != field.type && !type.empty()))
        return TableFault{fmt::format("the field '{}' of the array is not of the type of the others", field.name),
                          field.count == 1 ? field.type : fmt::format("{} numbers {}", field.count, field.type),
                          type.empty() ? std::string("one number") : type, "Store them as one type: '<f8'."};
      if (found.offset[column])
        return TableFault{fmt::format("two fields of the array mean the same: the second is '{}'", field.name),
                          {},
                          "x, y, z and a cross-section",
                          {}};
      type = field.type;
      found.offset[column] = field.offset;
    }
  }
  if (found.offset[0] && found.offset[1] && found.offset[2]) return found;
  return TableFault{"the fields of the array are not those of points", names.substr(0, 60), "x, y, z and perhaps rcs",
                    "Rename them: numpy.lib.recfunctions.rename_fields(points, {'east': 'x'})."};
}

}  // namespace

std::optional<TableFault> read_npy_points(const core::InputFile& file, PointTable& table,
                                          const core::WorkControl& control) {
  std::variant<raster::NpyHeader, core::Problem> read = raster::read_npy_header(file);
  if (auto* problem = std::get_if<core::Problem>(&read))
    return TableFault{problem->message, problem->found, problem->expected, problem->hint};
  const raster::NpyHeader& header = std::get<raster::NpyHeader>(read);
  const std::vector<std::uint64_t>& shape = header.shape;
  std::string type = header.type;
  const bool structures = !header.fields.empty();
  PointColumns columns;
  if (structures) {
    if (shape.size() != 1 || shape[0] == 0)
      return TableFault{"the array is not a list of points", raster::shape_text(shape), "N structures", {}};
    type.clear();
    auto found = columns_of_fields(header, type);
    if (auto* fault = std::get_if<TableFault>(&found)) return std::move(*fault);
    columns = std::get<PointColumns>(found);
  } else if (shape.size() != 2 || shape[0] == 0 || shape[1] < min_columns || shape[1] > max_columns) {
    return TableFault{"the array is not a table of points", raster::shape_text(shape), wanted_shape, {}};
  }
  const bool is_single = type == "<f4";
  if (!is_single && type != "<f8")
    return TableFault{"the numbers of the array are of a type that is not read", type,
                      "float32 or float64, least significant byte first (<f4, <f8)",
                      "Save it with numpy.save(file, points.astype('<f8'))."};
  if (!structures) columns = columns_of_array(shape[1], is_single ? 4 : 8);
  const std::uint64_t there = file.size() - std::min<std::uint64_t>(file.size(), header.data_offset);
  if (shape[0] > there / columns.stride)
    return TableFault{"the file is shorter than its array", fmt::format("{} bytes of data", there),
                      fmt::format("{} rows of {} bytes", shape[0], columns.stride), "It was cut off; copy it again."};
  if (const std::uint64_t left = there - shape[0] * columns.stride; left > 0)
    return TableFault{"the file is longer than its array", fmt::format("{} bytes behind it", left),
                      fmt::format("{} rows of {} bytes", shape[0], columns.stride),
                      "Store each array in a file of its own."};
  if (is_single) return NpyPoints<float>(file, header, columns, table).read(control);
  return NpyPoints<double>(file, header, columns, table).read(control);
}

}  // namespace sarsim::workflow
