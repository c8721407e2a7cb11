#include "raster/format/npy_header.hpp"

#include <charconv>
#include <cstring>
#include <optional>

#include <fmt/format.h>

#include "core/report/expect.hpp"
#include "core/text/number_text.hpp"
#include "core/text/quoted_word.hpp"

namespace sarsim::raster {

namespace {

constexpr std::string_view signature = "\x93NUMPY";
constexpr std::size_t alignment = 64;

std::size_t prefix_size(unsigned major) { return major == 1 ? 10 : 12; }

core::Problem problem(std::string message, std::string found = {}, std::string expected = {}) {
  return core::error(std::move(message)).found(std::move(found)).expected(std::move(expected));
}

// A reader for the one Python literal that a header is: a dictionary of strings, booleans and tuples of integers.
class LiteralReader {
 public:
  explicit LiteralReader(std::string_view text) : rest_(text) {}

  void skip_blanks() {
    while (!rest_.empty() && (rest_.front() == ' ' || rest_.front() == '\n' || rest_.front() == '\t'))
      rest_.remove_prefix(1);
  }
  bool take(char c) {
    skip_blanks();
    if (rest_.empty() || rest_.front() != c) return false;
    rest_.remove_prefix(1);
    return true;
  }
  bool take_word(std::string_view word) {
    skip_blanks();
    if (!rest_.starts_with(word)) return false;
    rest_.remove_prefix(word.size());
    return true;
  }
  std::optional<std::string> take_string() {
    const char quote = take('\'') ? '\'' : (take('"') ? '"' : '\0');
    const std::size_t end = quote == '\0' ? std::string_view::npos : rest_.find(quote);
    if (end == std::string_view::npos) return std::nullopt;
    std::string text(rest_.substr(0, end));
    rest_.remove_prefix(end + 1);
    return text;
  }
  std::optional<std::uint64_t> take_size() {
    skip_blanks();
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
    if (error != std::errc{}) return std::nullopt;
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    take('L');  // Python 2 wrote long integers so.
    return value;
  }
  std::optional<std::vector<std::uint64_t>> take_tuple() {
    if (!take('(')) return std::nullopt;
    std::vector<std::uint64_t> values;
    while (!take(')')) {
      const auto value = take_size();
      if (!value) return std::nullopt;
      values.push_back(*value);
      if (!take(',') && (skip_blanks(), !rest_.starts_with(')'))) return std::nullopt;
    }
    return values;
  }
  [[nodiscard]] bool at_end() {
    skip_blanks();
    return rest_.empty();
  }

 private:
  std::string_view rest_;
};

// Bytes of a type by its last digits: "<f8", "|u1", "<U4" of letters of 4 bytes; nothing for a type without a size.
std::optional<std::size_t> bytes_of_type(std::string_view type) {
  constexpr std::size_t most = std::size_t{1} << 20U;
  const std::size_t digits = type.find_first_of("0123456789");
  if (digits == std::string_view::npos || digits == 0) return std::nullopt;
  const auto bytes = core::parse_whole(type.substr(digits));
  if (!bytes || *bytes == 0 || *bytes > most) return std::nullopt;
  return static_cast<std::size_t>(type[digits - 1] == 'U' ? 4 * *bytes : *bytes);
}

// A list of fields behind its bracket: ('x', '<f8') or ('x', '<f8', (3,)). Structures within are not read.
bool take_fields(LiteralReader& reader, NpyHeader& header) {
  constexpr std::size_t max_fields = 1000;
  constexpr std::uint64_t max_count = std::uint64_t{1} << 20U;
  while (!reader.take(']')) {
    if (header.fields.size() >= max_fields || !reader.take('(')) return false;
    NpyField field;
    auto name = reader.take_string();
    if (!name && reader.take('(')) {  // With a title: (('title', 'name'), '<f8').
      if (!reader.take_string() || !reader.take(',')) return false;
      name = reader.take_string();
      if (!reader.take(')')) return false;
    }
    if (!name || !reader.take(',')) return false;
    const auto type = reader.take_string();
    if (!type) return false;
    if (reader.take(',')) {
      std::optional<std::vector<std::uint64_t>> shape = reader.take_tuple();
      if (!shape) {
        const auto size = reader.take_size();
        if (!size) return false;
        shape = {*size};
      }
      std::uint64_t count = 1;
      for (const std::uint64_t size : *shape)
        if (size > max_count || (count *= size) > max_count) return false;
      field.count = static_cast<std::size_t>(count);
    }
    const auto bytes = bytes_of_type(*type);
    if (!bytes || !reader.take(')')) return false;
    field.name = *name;
    field.type = *type;
    field.bytes = *bytes;
    field.offset = header.structure_bytes();
    header.fields.push_back(std::move(field));
    if (reader.take(',')) continue;
    return reader.take(']');
  }
  return !header.fields.empty();
}

// Takes the value of one key; false where it is not what the key asks for.
bool take_entry(LiteralReader& reader, const std::string& key, NpyHeader& header) {
  if (key == "descr") {
    auto type = reader.take_string();
    if (type) header.type = std::move(*type);
    return type.has_value();
  }
  if (key == "fortran_order") {
    header.fortran_order = reader.take_word("True");
    return header.fortran_order || reader.take_word("False");
  }
  if (key == "shape") {
    auto shape = reader.take_tuple();
    if (shape) header.shape = std::move(*shape);
    return shape.has_value();
  }
  return false;
}

std::variant<NpyHeader, core::Problem> parse_dictionary(std::string_view text) {
  const auto malformed = [&] {
    return problem("the header of the NumPy file is malformed", core::quoted_word(text),
                   "{'descr': type, 'fortran_order': False, 'shape': (rows, columns)}");
  };
  LiteralReader reader(text);
  NpyHeader header;
  int entries = 0;
  if (!reader.take('{')) return malformed();
  while (!reader.take('}')) {
    const auto key = reader.take_string();
    if (!key || !reader.take(':')) return malformed();
    if (*key == "descr" && reader.take('[')) {
      if (!take_fields(reader, header))
        return problem("arrays of structures of this kind are not read", core::quoted_word(text),
                       "fields of numbers: [('x', '<f8'), ...]");
      header.type = "V";
    } else if (!take_entry(reader, *key, header)) {
      return malformed();
    }
    ++entries;
    if (reader.take(',')) continue;
    if (!reader.take('}')) return malformed();
    break;
  }
  if (entries != 3 || header.type.empty() || !reader.at_end()) return malformed();
  return header;
}

}  // namespace

std::string npy_header_text(std::string_view type, std::span<const std::size_t> shape) {
  CORE_EXPECT(!type.empty());
  std::string sizes;
  for (const std::size_t size : shape) sizes += fmt::format("{}{}", sizes.empty() ? "" : ", ", size);
  if (shape.size() == 1) sizes += ',';
  std::string text = fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': ({}), }}", type, sizes);
  const std::size_t unpadded = prefix_size(1) + text.size() + 1;
  text.append((alignment - unpadded % alignment) % alignment, ' ');
  text += '\n';
  std::string header(signature);
  header += {'\x01', '\x00'};
  header += static_cast<char>(text.size() & 0xFFU);
  header += static_cast<char>(text.size() >> 8U);
  return header + text;
}

std::uint64_t npy_header_size(std::span<const std::byte> bytes) {
  if (bytes.size() < 12 || std::memcmp(bytes.data(), signature.data(), signature.size()) != 0) return 0;
  const auto byte = [&](std::size_t i) { return std::to_integer<std::uint64_t>(bytes[i]); };
  if (byte(6) == 1) return prefix_size(1) + (byte(8) | byte(9) << 8U);
  return prefix_size(2) + (byte(8) | byte(9) << 8U | byte(10) << 16U | byte(11) << 24U);
}

std::variant<NpyHeader, core::Problem> parse_npy_header(std::span<const std::byte> bytes) {
  const std::uint64_t size = npy_header_size(bytes);
  if (size == 0) return problem("this is not a NumPy array file");
  const unsigned major = std::to_integer<unsigned>(bytes[6]);
  const unsigned minor = std::to_integer<unsigned>(bytes[7]);
  if (major < 1 || major > 3 || minor != 0)
    return problem("the version of the NumPy file is not known", fmt::format("{}.{}", major, minor), "1.0, 2.0 or 3.0");
  if (size > bytes.size())
    return problem("the NumPy file ends within its header", fmt::format("{} bytes", bytes.size()),
                   fmt::format("{} bytes", size));
  const std::size_t prefix = prefix_size(major);
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()) + prefix, size - prefix);
  auto header = parse_dictionary(text);
  if (auto* found = std::get_if<NpyHeader>(&header)) found->data_offset = static_cast<std::size_t>(size);
  return header;
}

std::variant<NpyHeader, core::Problem> read_npy_header(const core::InputFile& file) {
  constexpr std::uint64_t longest = std::uint64_t{1} << 20;  // Far above any header of numbers.
  std::vector<std::byte> bytes(12);
  bytes.resize(file.read_at(0, bytes));
  const std::uint64_t size = npy_header_size(bytes);
  if (size > longest) {
    return core::error("the header of the NumPy file is too long").found(fmt::format("{} bytes", size));
  }
  bytes.resize(static_cast<std::size_t>(size));
  bytes.resize(file.read_at(0, bytes));
  return parse_npy_header(bytes);
}

std::string shape_text(const std::vector<std::uint64_t>& shape) {
  std::string text;
  for (const std::uint64_t size : shape) text += fmt::format("{}{}", text.empty() ? "" : ", ", size);
  return "(" + text + ")";
}

}  // namespace sarsim::raster
