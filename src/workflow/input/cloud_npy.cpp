#include <algorithm>
#include <array>
#include <atomic>
#include <cstring>
#include <span>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "raster/format/npy_header.hpp"
#include "workflow/input/cloud_table.hpp"

namespace sarsim::workflow {

namespace {

constexpr std::size_t least_columns = 3;
constexpr std::size_t most_columns = 5;  // x, y, z, cross-section, phase
constexpr std::size_t phase_column = 4;
constexpr std::size_t range_rows = std::size_t{1} << 15;
constexpr const char* wanted_shape = "an array of N rows and 3 or 4 columns: x, y, z and cross-section";

// The numbers of one file.
template <class Number>
class NpyPoints {
 public:
  NpyPoints(const core::InputFile& file, const raster::NpyHeader& header, PointTable& table)
      : file_(file), header_(header), table_(table), rows_(header.shape[0]), columns_(header.shape[1]) {}

  std::optional<TableFault> read(const core::WorkControl& control) {
    resize(table_.arrays, rows_, control);
    table_.own_rcs = columns_ > least_columns;
    core::parallel_ranges(rows_, range_rows, control, [&](std::size_t begin, std::size_t end) {
      if (header_.fortran_order)
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

  [[nodiscard]] std::vector<Number> numbers(std::uint64_t first, std::size_t count) const {
    std::vector<Number> read(count);
    file_.read_all_at(header_.data_offset + first * sizeof(Number), std::as_writable_bytes(std::span(read)));
    return read;
  }

  void read_rows(std::size_t begin, std::size_t end) {
    const std::vector<Number> read = numbers(std::uint64_t{begin} * columns_, (end - begin) * columns_);
    for (std::size_t column = 0; column < columns_; ++column)
      take(column, begin, end, [&](std::size_t i) { return read[i * columns_ + column]; });
  }

  void read_columns(std::size_t begin, std::size_t end) {
    for (std::size_t column = 0; column < columns_; ++column) {
      const std::vector<Number> read = numbers(std::uint64_t{column} * rows_ + begin, end - begin);
      take(column, begin, end, [&](std::size_t i) { return read[i]; });
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
  std::size_t columns_;
  std::atomic<std::size_t> turned_row_{none};
  std::atomic<double> turned_by_{0.0};
};

}  // namespace

std::optional<TableFault> read_npy_points(const core::InputFile& file, PointTable& table,
                                          const core::WorkControl& control) {
  std::variant<raster::NpyHeader, core::Problem> read = raster::read_npy_header(file);
  if (auto* problem = std::get_if<core::Problem>(&read))
    return TableFault{problem->message, problem->found, problem->expected, problem->hint};
  const raster::NpyHeader& header = std::get<raster::NpyHeader>(read);
  const std::vector<std::uint64_t>& shape = header.shape;
  if (shape.size() != 2 || shape[0] == 0 || shape[1] < least_columns || shape[1] > most_columns)
    return TableFault{"the array is not a table of points", raster::shape_text(shape), wanted_shape, {}};
  const bool is_single = header.type == "<f4";
  if (!is_single && header.type != "<f8")
    return TableFault{"the numbers of the array are of a type that is not read", header.type,
                      "float32 or float64, least significant byte first (<f4, <f8)",
                      "Save it with numpy.save(file, points.astype('<f8'))."};
  const std::uint64_t number_bytes = is_single ? 4 : 8;
  const std::uint64_t there = file.size() - std::min<std::uint64_t>(file.size(), header.data_offset);
  if (shape[0] > there / (shape[1] * number_bytes))
    return TableFault{"the file is shorter than its array", fmt::format("{} bytes of data", there),
                      fmt::format("{} rows of {} bytes", shape[0], shape[1] * number_bytes),
                      "It was cut off; copy it again."};
  if (is_single) return NpyPoints<float>(file, header, table).read(control);
  return NpyPoints<double>(file, header, table).read(control);
}

}  // namespace sarsim::workflow
