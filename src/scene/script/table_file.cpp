#include "scene/script/table_file.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <utility>

#include <fmt/format.h>

#include "core/text/letters.hpp"
#include "core/text/number_text.hpp"
#include "core/text/quoted_word.hpp"
#include "scene/model/limits.hpp"
#include "scene/schema/field_spec.hpp"
#include "scene/schema/table_text.hpp"
#include "scene/schema/unit_table.hpp"

namespace sarsim::scene {

namespace {

constexpr std::size_t max_table_problems = 20;

core::ProblemBuilder table_problem(const std::string& file, std::size_t line, std::string message) {
  return core::error(std::move(message)).in(file, line);
}

DataFileReading failed_table(const FunctionBlock& block, core::Problem problem) {
  DataFileReading reading;
  reading.functions.resize(block.count);
  reading.problems.push_back(std::move(problem));
  return reading;
}

std::string named_axis(const FunctionAxis& axis) {
  const auto units = units_of(quantity_of(axis));
  const std::string_view unit = units.empty() ? axis.unit : units.front();
  return unit.empty() ? std::string(axis.name) : fmt::format("{} [{}]", axis.name, unit);
}

// "angle off the beam [deg], gain in azimuth [dB], gain in elevation [dB]".
std::string columns_text(const FunctionBlock& block) {
  std::string text = block.x_ignored ? "" : named_axis(block.x);
  for (std::size_t i = 0; i < block.count; ++i) text += (text.empty() ? "" : ", ") + named_axis(block.y[i]);
  return text;
}

bool is_pulse(const FunctionBlock& block) { return &block == &function_blocks::pulse_iq; }
bool is_antenna(const FunctionBlock& block) {
  return &block == &function_blocks::transmit_gain || &block == &function_blocks::receive_gain;
}

bool suits(const FunctionBlock& block, std::size_t columns) {
  if (columns == block.count + 1) return true;
  if (block.x_ignored) return columns == 1;
  return (is_pulse(block) || is_antenna(block)) && columns == 2;
}

// Which axis a column has, of a table with so many.
const FunctionAxis& axis_of(const FunctionBlock& block, std::size_t column, std::size_t columns) {
  const std::size_t axis = usual_columns(block, columns)[column];
  return axis == 0 ? block.x : block.y[axis - 1];
}

// Where the first column of two is the place within the pulse rather than I.
bool has_pulse_places(const std::vector<double>& numbers) {
  for (std::size_t i = 2; i < numbers.size(); i += 2)
    if (!(numbers[i] > numbers[i - 2])) return false;
  return numbers.size() >= 4 && numbers[0] == 0.0 && numbers[numbers.size() - 2] == 1.0;
}

class TableFunctions {
 public:
  // @param pulse_has_x  of two columns of a pulse; nothing: the numbers tell
  TableFunctions(const std::vector<double>& numbers, std::size_t columns, const std::string& file,
                 const FunctionBlock& block, std::optional<bool> pulse_has_x)
      : numbers_(numbers),
        columns_(columns),
        rows_(numbers.size() / columns),
        file_(file),
        block_(block),
        pulse_has_x_(pulse_has_x) {
    reading_.functions.resize(block.count);
  }

  DataFileReading take() {
    if (columns_ == block_.count + 1)
      with_x();
    else if (block_.x_ignored)
      for (std::size_t row = 0; row < rows_; ++row) add(0, static_cast<double>(row), at(row, 0), row);
    else if (is_antenna(block_) || pulse_has_x_.value_or(has_pulse_places(numbers_)))
      one_value();
    else
      even_pulse();
    return std::move(reading_);
  }

 private:
  [[nodiscard]] double at(std::size_t row, std::size_t column) const { return numbers_[row * columns_ + column]; }

  void with_x() {
    for (std::size_t row = 0; row < rows_; ++row)
      for (std::size_t part = 0; part < block_.count; ++part)
        add(part, block_.x_ignored ? static_cast<double>(row) : at(row, 0), at(row, part + 1), row);
  }
  void one_value() {
    for (std::size_t row = 0; row < rows_; ++row)
      for (std::size_t part = 0; part < block_.count; ++part)
        add(part, at(row, 0), is_pulse(block_) && part == 1 ? 0.0 : at(row, 1), row);
  }
  void even_pulse() {
    const double steps = std::max(1.0, static_cast<double>(rows_) - 1.0);
    for (std::size_t row = 0; row < rows_; ++row)
      for (std::size_t part = 0; part < 2; ++part) add(part, static_cast<double>(row) / steps, at(row, part), row);
  }

  void add(std::size_t part, double x, double y, std::size_t row) {
    if (reading_.problems.size() >= max_table_problems) return;
    std::vector<core::Knot>& knots = reading_.functions[part];
    const auto fail = [&](std::string message, double found, std::string expected, std::string hint = {}) {
      reading_.problems.push_back(table_problem(file_, 0, fmt::format("row {}: {}", row + 1, message))
                                      .found(core::format_number(found))
                                      .expected(std::move(expected))
                                      .hint(std::move(hint)));
    };
    for (const double value : {x, y})
      if (!computable(value))
        return fail("a number cannot be computed with", value, fmt::format("a magnitude up to {:g}", largest_value));
    if (!range_of_y(block_).holds(y)) return fail(fmt::format("{} is out of range", block_.y[part].name), y, "above 0");
    if (!block_.x_ignored && part == 0 && !knots.empty() && !(x > knots.back().x))
      return fail(fmt::format("{} must ascend", block_.x.name), x,
                  fmt::format("above {}", core::format_number(knots.back().x)), "sort the rows");
    knots.push_back({x, y});
  }

  const std::vector<double>& numbers_;
  std::size_t columns_;
  std::size_t rows_;
  const std::string& file_;
  const FunctionBlock& block_;
  std::optional<bool> pulse_has_x_;
  DataFileReading reading_;
};

// Of a sound number of columns.
DataFileReading functions_of_rows(const std::vector<double>& numbers, std::size_t columns, const std::string& file_name,
                                  const FunctionBlock& block, std::optional<bool> pulse_has_x) {
  if (numbers.empty())
    return failed_table(block, table_problem(file_name, 0, "the table holds no numbers").expected(columns_text(block)));
  return TableFunctions(numbers, columns, file_name, block, pulse_has_x).take();
}

// The rows of a text, each cell in the unit of its axis.
class TextTable {
 public:
  TextTable(const std::vector<TableLine>& lines, const std::string& file, const FunctionBlock& block)
      : lines_(lines), file_(file), block_(block), named_(!lines.empty() && is_heading(lines.front())) {
    for (std::size_t i = named_ ? 1 : 0; i < lines.size(); ++i) {
      const std::size_t cells = lines[i].cells.size();
      even_ = even_ && (columns_ == 0 || cells == columns_);
      columns_ = columns_ == 0 ? cells : columns_;
    }
  }

  [[nodiscard]] bool named() const { return named_; }
  [[nodiscard]] bool is_table() const { return even_ && columns_ > 0 && suits(block_, columns_); }

  DataFileReading read() {
    if (!is_table()) return failed_table(block_, wrong_columns());
    read_names();
    std::vector<double> numbers;
    for (std::size_t i = named_ ? 1 : 0; i < lines_.size() && problems_.empty(); ++i) read_row(lines_[i], numbers);
    if (!problems_.empty()) return failed_table(block_, problems_.front());
    return functions_of_rows(numbers, columns_, file_, block_, columns_named_.pulse_has_x);
  }

 private:
  [[nodiscard]] core::Problem wrong_columns() const {
    for (std::size_t i = named_ ? 1 : 0; i < lines_.size(); ++i)
      if (!suits(block_, lines_[i].cells.size()) || lines_[i].cells.size() != columns_)
        return table_problem(file_, lines_[i].number, fmt::format("a table of {} has other columns", block_.words))
            .found(fmt::format("{} in this row", lines_[i].cells.size()))
            .expected(columns_text(block_));
    return table_problem(file_, 0, "the table holds no numbers").expected(columns_text(block_));
  }

  void read_names() {
    columns_named_ = named_columns(block_, named_ ? headings_of(lines_.front()) : std::vector<ColumnHeading>(),
                                   usual_columns(block_, columns_));
    if (auto& fault = columns_named_.fault) {
      problems_.push_back(table_problem(file_, lines_.front().number, std::move(fault->message))
                              .found(std::move(fault->found))
                              .expected(std::move(fault->expected))
                              .hint(std::move(fault->hint)));
      return;
    }
    for (std::size_t i = 0; i < columns_; ++i) {
      const FunctionAxis& axis = axis_of(block_, columns_named_.places[i], columns_);
      std::string& unit = columns_named_.units[i];
      if (unit.empty() || unit == axis.unit) {
        if (quantity_of(axis) == Quantity::number) unit.clear();
        continue;
      }
      if (units_of(quantity_of(axis)).empty() || !read_quantity("1 " + unit, quantity_of(axis)).value)
        problems_.push_back(table_problem(file_, lines_.front().number,
                                          fmt::format("the unit of column {} is not that of {}", i + 1, axis.name))
                                .found(core::quoted_word(unit))
                                .expected(units_listed(quantity_of(axis))));
    }
  }

  void read_row(const TableLine& line, std::vector<double>& numbers) {
    const std::size_t first = numbers.size();
    numbers.resize(first + columns_);
    for (std::size_t i = 0; i < columns_; ++i) {
      const std::size_t place = columns_named_.places[i];
      const FunctionAxis& axis = axis_of(block_, place, columns_);
      const QuantityReading cell = read_cell(line.cells[i], quantity_of(axis), columns_named_.units[i]);
      if (cell.value) {
        numbers[first + place] = *cell.value;
        continue;
      }
      problems_.push_back(table_problem(file_, line.number, fmt::format("{}: {}", axis.name, cell.failure)));
      return;
    }
  }

  const std::vector<TableLine>& lines_;
  const std::string& file_;
  const FunctionBlock& block_;
  bool named_;
  bool even_ = true;
  std::size_t columns_ = 0;
  NamedColumns columns_named_;
  core::Problems problems_;
};

// What the header of an array says, as far as tables need it.
struct ArrayHeader {
  std::string type;
  bool columns_first = false;
  std::vector<std::size_t> shape;
  std::size_t begin = 0;
};

// The text behind a key of the header: `'descr': '<f8'`.
std::string_view behind_key(std::string_view header, std::string_view key) {
  const std::size_t at = header.find(fmt::format("'{}'", key));
  if (at == std::string_view::npos) return {};
  return core::trimmed(header.substr(std::min(header.find(':', at), header.size() - 1) + 1));
}

std::optional<std::vector<std::size_t>> shape_of(std::string_view text) {
  std::vector<std::size_t> shape;
  const std::size_t close = text.find(')');
  if (!text.starts_with('(') || close == std::string_view::npos) return std::nullopt;
  text = text.substr(1, close - 1);
  while (!core::trimmed(text).empty()) {
    const std::size_t comma = std::min(text.find(','), text.size());
    const auto extent = core::parse_integer(core::trimmed(text.substr(0, comma)));
    if (!extent || *extent < 0) return std::nullopt;
    shape.push_back(static_cast<std::size_t>(*extent));
    text.remove_prefix(std::min(comma + 1, text.size()));
  }
  return shape;
}

std::optional<ArrayHeader> array_header(std::string_view bytes) {
  if (bytes.size() < 12) return std::nullopt;
  const auto byte_at = [&](std::size_t i) { return static_cast<std::size_t>(static_cast<unsigned char>(bytes[i])); };
  const bool is_long = byte_at(6) > 1;
  const std::size_t first = is_long ? 12 : 10;
  const std::size_t size =
      byte_at(8) + (byte_at(9) << 8U) + (is_long ? (byte_at(10) << 16U) + (byte_at(11) << 24U) : 0);
  if (size > bytes.size() - first) return std::nullopt;
  const std::string_view text = bytes.substr(first, size);
  for (const char* const key : {"'descr'", "'shape'", "'fortran_order'"})
    if (text.find(key) != text.rfind(key)) return std::nullopt;  // Twice: nothing tells which one counts.
  const std::string_view type = behind_key(text, "descr");
  auto shape = shape_of(behind_key(text, "shape"));
  if (type.size() < 2 || type.front() != '\'' || !shape) return std::nullopt;
  return ArrayHeader{std::string(type.substr(1, type.find('\'', 1) - 1)),
                     behind_key(text, "fortran_order").starts_with("True"), std::move(*shape), first + size};
}

template <class Number>
double number_at(std::string_view data, std::size_t i) {
  Number number;
  std::memcpy(&number, data.data() + i * sizeof(Number), sizeof(Number));
  return static_cast<double>(number);
}

// How numbers of a type are read; complex ones are two.
struct ArrayType {
  std::string_view name;
  std::size_t bytes;
  std::size_t parts;
  double (*at)(std::string_view data, std::size_t i);
};
constexpr std::array<ArrayType, 12> array_types{{{"<f8", 8, 1, number_at<double>},
                                                 {"<f4", 4, 1, number_at<float>},
                                                 {"<c16", 8, 2, number_at<double>},
                                                 {"<c8", 4, 2, number_at<float>},
                                                 {"<i8", 8, 1, number_at<std::int64_t>},
                                                 {"<i4", 4, 1, number_at<std::int32_t>},
                                                 {"<i2", 2, 1, number_at<std::int16_t>},
                                                 {"|i1", 1, 1, number_at<std::int8_t>},
                                                 {"<u8", 8, 1, number_at<std::uint64_t>},
                                                 {"<u4", 4, 1, number_at<std::uint32_t>},
                                                 {"<u2", 2, 1, number_at<std::uint16_t>},
                                                 {"|u1", 1, 1, number_at<std::uint8_t>}}};
static_assert(std::endian::native == std::endian::little);

std::string shape_words(const std::vector<std::size_t>& shape) { return fmt::format("({})", fmt::join(shape, ", ")); }

}  // namespace

bool is_hdf5(std::string_view bytes) { return bytes.starts_with("\x89HDF\r\n\x1a\n"); }

DataFileReading functions_of_table(const std::vector<double>& numbers, std::size_t columns,
                                   const std::string& file_name, const FunctionBlock& block) {
  if (!numbers.empty() && !suits(block, columns))
    return failed_table(block, table_problem(file_name, 0, fmt::format("a table of {} has other columns", block.words))
                                   .found(fmt::format("{} columns", columns))
                                   .expected(columns_text(block)));
  return functions_of_rows(numbers, columns, file_name, block, std::nullopt);
}

std::optional<DataFileReading> read_npy_table(std::string_view bytes, const std::string& file_name,
                                              const FunctionBlock& block) {
  if (!bytes.starts_with("\x93NUMPY")) return std::nullopt;
  const auto fail = [&](std::string message, std::string found, std::string expected, std::string hint = {}) {
    return failed_table(block, table_problem(file_name, 0, std::move(message))
                                   .found(std::move(found))
                                   .expected(std::move(expected))
                                   .hint(std::move(hint)));
  };
  const auto header = array_header(bytes);
  if (!header) return fail("the header of the array cannot be read", {}, "an array of numbers as numpy.save writes it");
  const auto type = std::ranges::find(array_types, header->type, &ArrayType::name);
  if (type == array_types.end())
    return fail("the numbers of the array are of a type that is not read", core::quoted_word(header->type),
                "floating-point, whole or complex numbers, least significant byte first",
                "save it with numpy.save(file, table.astype('<f8'))");
  const std::vector<std::size_t>& shape = header->shape;
  if (shape.empty() || shape.size() > 2 || (type->parts == 2 && shape.size() != 1))
    return fail("the array is not a table", shape_words(shape), "one or two dimensions; complex numbers one");
  const std::size_t rows = shape[0];
  const std::size_t wide = shape.size() == 2 ? shape[1] : type->parts;
  const std::string_view data = bytes.substr(header->begin);
  if (wide == 0 || rows > data.size() / type->bytes / wide)
    return fail("the file is shorter than its array", fmt::format("{} bytes of data", data.size()), shape_words(shape));
  if (const std::size_t wanted = rows * wide * type->bytes; data.size() > wanted)
    return fail("the file is longer than its array", fmt::format("{} bytes behind it", data.size() - wanted),
                shape_words(shape), "store each array in a file of its own");
  const bool by_columns = header->columns_first && shape.size() == 2;
  std::vector<double> numbers(rows * wide);
  for (std::size_t row = 0; row < rows; ++row)
    for (std::size_t column = 0; column < wide; ++column)
      numbers[row * wide + column] = type->at(data, by_columns ? column * rows + row : row * wide + column);
  return functions_of_table(numbers, wide, file_name, block);
}

std::optional<DataFileReading> read_text_table(std::string_view text, const std::string& file_name,
                                               const FunctionBlock& block, bool certainly) {
  const std::vector<TableLine> lines = table_lines(text);
  TextTable table(lines, file_name, block);
  const bool told = certainly || (table.named() && lines.size() > 1);
  if (told) return table.read();
  if (!table.is_table() || lines.size() < 2) return std::nullopt;
  DataFileReading reading = table.read();
  if (core::has_errors(reading.problems)) return std::nullopt;
  return reading;
}

}  // namespace sarsim::scene
