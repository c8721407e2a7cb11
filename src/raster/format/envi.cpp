#include "raster/format/envi.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <map>
#include <stdexcept>
#include <system_error>

#include <fmt/format.h>

#include "core/report/expect.hpp"
#include "core/text/letters.hpp"
#include "core/text/number_text.hpp"
#include "core/text/quoted_word.hpp"
#include "core/text/separated.hpp"
#include "raster/format/npy_header.hpp"
#include "raster/table/file_problem.hpp"
#include "raster/table/formats.hpp"

namespace sarsim::raster {

namespace {

std::string harmless(std::string text) {
  for (char& c : text) {
    if (c == '\n' || c == '\r') c = ' ';
    if (c == '{') c = '(';
    if (c == '}') c = ')';
  }
  return text;
}

using Fields = std::vector<std::pair<std::string, std::string>>;

// The field that a line of a header begins with, in lower case; empty for another line.
std::string field_of_line(std::string_view line) {
  const std::size_t equals = line.find('=');
  return equals == std::string_view::npos ? "" : core::lower_case(core::trimmed(line.substr(0, equals)));
}

// The first field of the layout within a value in braces, which has swallowed it; empty where there is none.
std::string swallowed_field(std::string_view value) {
  constexpr std::string_view layout[] = {"samples",   "lines",      "bands",      "header offset",
                                         "data type", "interleave", "byte order", "file type"};
  while (!value.empty()) {
    const std::size_t end = std::min(value.find('\n'), value.size());
    std::string field = field_of_line(value.substr(0, end));
    if (std::ranges::find(layout, field) != std::end(layout)) return field;
    value.remove_prefix(std::min(end + 1, value.size()));
  }
  return {};
}

// "name = value" lines; a value in braces may go over several lines.
// @param open  becomes the first field whose brace is not closed before the next field
Fields fields_of(std::string_view text, std::string& open) {
  Fields fields;
  while (!text.empty()) {
    const std::size_t line = std::min(text.find('\n'), text.size());
    const std::size_t equals = text.substr(0, line).find('=');
    if (equals == std::string_view::npos) {
      text.remove_prefix(std::min(line + 1, text.size()));
      continue;
    }
    const std::string name = core::lower_case(core::trimmed(text.substr(0, equals)));
    text = text.substr(equals + 1);
    const std::size_t brace = text.find_first_not_of(" \t");
    const bool braced = brace != std::string_view::npos && text[brace] == '{';
    const std::size_t end = text.find(braced ? '}' : '\n');
    std::string_view value =
        text.substr(braced ? brace + 1 : 0, end == std::string_view::npos ? end : end - (braced ? brace + 1 : 0));
    if (braced && open.empty() && (end == std::string_view::npos || !swallowed_field(value).empty())) open = name;
    fields.emplace_back(name, core::trimmed(value));
    text = end == std::string_view::npos ? std::string_view() : text.substr(end + 1);
  }
  return fields;
}

// Takes a field out of the list.
std::optional<std::string> take(Fields& fields, std::string_view name) {
  const auto found = std::ranges::find(fields, name, [](const auto& field) -> std::string_view { return field.first; });
  if (found == fields.end()) return std::nullopt;
  std::string value = std::move(found->second);
  fields.erase(found);
  return value;
}

// Reads the numbers of a header, keeping what is wrong with them.
class NumberTaker {
 public:
  NumberTaker(Fields& fields, const std::string& file, core::Problems& problems)
      : fields_(fields), file_(file), problems_(problems) {}

  std::size_t take_number(std::string_view name, std::optional<std::int64_t> missing) {
    const auto text = take(fields_, name);
    if (!text && missing) return static_cast<std::size_t>(*missing);
    const auto value = text ? core::parse_integer(*text) : std::nullopt;
    // What has to be there counts something.
    const std::int64_t least = missing ? 0 : 1;
    if (value && *value >= least) return static_cast<std::size_t>(*value);
    const char* expected = missing ? "a whole number" : "a whole number above 0";
    problems_.push_back(file_problem(
        file_,
        text ? fmt::format("'{}' is not {}", name, expected) : fmt::format("the header does not give '{}'", name),
        text ? core::quoted_word(*text) : std::string(), expected));
    return 0;
  }

  void expect(std::string_view name, std::size_t value, std::initializer_list<std::size_t> allowed,
              std::string_view expected) {
    if (std::ranges::find(allowed, value) != allowed.end()) return;
    problems_.push_back(file_problem(file_, fmt::format("'{}' of the image is not supported", name),
                                     std::to_string(value), std::string(expected)));
  }

 private:
  Fields& fields_;
  const std::string& file_;
  core::Problems& problems_;
};

// A field that changes what pixels mean or where they are, unless all of its numbers are the one that does nothing.
struct ChangingField {
  std::string_view name;
  double neutral;
  const char* hint;
};

constexpr const char* multiply = "compute the pixels by it, and remove the field";
constexpr const char* without_frames = "store the pixels without the bytes between them: gdal_translate -of ENVI";
constexpr ChangingField changing_fields[] = {
    {"data gain values", 1.0, multiply},
    {"data offset values", 0.0, multiply},
    {"data reflectance gain values", 1.0, multiply},
    {"data reflectance offset values", 0.0, multiply},
    {"reflectance scale factor", 1.0, multiply},
    {"data ignore value", 0.0, "set such pixels to 0, and the field too"},
    {"minor frame offsets", 0.0, without_frames},
    {"major frame offsets", 0.0, without_frames},
    {"file compression", 0.0, "unpack the image: gunzip"},
};

// One value of a field that has only a few.
void expect_word(std::string_view name, const std::optional<std::string>& value,
                 std::initializer_list<std::string_view> allowed, const std::string& expected, const std::string& file,
                 core::Problems& problems) {
  if (!value) return;
  const auto same = [&](std::string_view word) { return core::equal_ignoring_case(*value, word); };
  if (std::ranges::any_of(allowed, same)) return;
  problems.push_back(
      file_problem(file, fmt::format("'{}' of the image is not supported", name), core::quoted_word(*value), expected));
}

// Fields that say something else than that pixels are the samples, one behind the other.
void refuse_changes(const Fields& fields, const std::string& file, core::Problems& problems) {
  for (const ChangingField& changing : changing_fields)
    for (const auto& [name, value] : fields) {
      if (name != changing.name) continue;
      const auto numbers = core::numbers_of_list(value);
      const bool nothing = core::equal_ignoring_case(value, "nan") ||
                           (numbers && std::ranges::all_of(*numbers, [&](double n) { return n == changing.neutral; }));
      if (nothing) continue;
      problems.push_back(file_problem(file, fmt::format("'{}' of the image is not supported", name),
                                      core::quoted_word(value), fmt::format("{:g}, or no such field", changing.neutral),
                                      changing.hint));
    }
}

// Our own fields say where pixels are; a part that another program cut out has the whole image's.
void refuse_cut_out(const Fields& fields, const std::string& file, core::Problems& problems) {
  const auto has = [&](std::string_view name) {
    return std::ranges::find(fields, name, [](const auto& f) -> std::string_view { return f.first; }) != fields.end();
  };
  for (const auto& [start, own] : {std::pair("x start", "range first m"), std::pair("y start", "azimuth first m")})
    for (const auto& [name, value] : fields) {
      if (name != start || !has(own)) continue;
      const auto number = core::parse_number(value);
      if (number && (*number == 0.0 || *number == 1.0)) continue;
      problems.push_back(
          file_problem(file, fmt::format("'{}' contradicts '{}'", start, own), core::quoted_word(value),
                       "1, as the first pixel is at that place",
                       fmt::format("correct '{}' by the pixels before it, and remove '{}'", own, start)));
    }
}

// The name of a field as messages have it: of those that are known all of it, of any other line a word.
std::string shown_name(std::string_view name) {
  constexpr std::string_view known[] = {"data type", "byte order", "header offset", "file type", "x start", "y start"};
  return std::ranges::find(known, name) != std::end(known) ? std::string(name) : core::quoted_word(name);
}

// Of fields of one name nothing tells which one counts.
void refuse_doubles(const Fields& fields, const std::string& file, core::Problems& problems) {
  std::map<std::string_view, std::string_view> known;
  for (const auto& [name, value] : fields) {
    const auto [first, is_new] = known.emplace(name, value);
    if (is_new || first->second == value) continue;
    problems.push_back(file_problem(
        file, fmt::format("the header gives '{}' twice", shown_name(name)),
        fmt::format("'{}' and '{}'", core::quoted_word(first->second), core::quoted_word(value)), "one value"));
    return;
  }
}

// As much as a header may have: of any other file no more is read.
std::string header_text(const std::filesystem::path& path) {
  constexpr std::size_t longest_header = std::size_t{1} << 20U;
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) return {};  // What a pipe says would be waited for.
  std::ifstream stream(path, std::ios::binary);
  std::string text(longest_header, '\0');
  if (!stream) throw std::system_error(errno, std::generic_category(), "cannot read '" + path.string() + "'");
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (stream.bad()) throw std::system_error(errno, std::generic_category(), "cannot read '" + path.string() + "'");
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return text;
}

// Others would be waited for, or cannot be read at any place.
std::optional<core::Problem> problem_of_kind(const std::filesystem::path& path) {
  std::error_code ignored;
  const std::filesystem::file_status status = std::filesystem::status(path, ignored);
  if (!std::filesystem::exists(status) || std::filesystem::is_regular_file(status)) return std::nullopt;
  return file_problem(path.string(), "this is not a regular file", "", "an image and its header, both of them files");
}

std::filesystem::path header_path(std::filesystem::path data) { return data.replace_extension(".hdr"); }

// What a NumPy array file says of itself; nothing for other files.
std::optional<NpyHeader> array_header(const std::filesystem::path& data) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(data, ignored)) return std::nullopt;
  std::ifstream stream(data, std::ios::binary);
  std::string bytes(12, '\0');
  if (!stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()))) return std::nullopt;
  constexpr std::uint64_t longest_header = std::uint64_t{1} << 20U;
  const std::uint64_t size = npy_header_size(std::as_bytes(std::span(bytes)));
  if (size == 0 || size > longest_header) return std::nullopt;
  bytes.resize(static_cast<std::size_t>(size));
  stream.seekg(0);
  if (!stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()))) return std::nullopt;
  auto parsed = parse_npy_header(std::as_bytes(std::span(bytes)));
  if (auto* header = std::get_if<NpyHeader>(&parsed)) return std::move(*header);
  return std::nullopt;
}

// Whether a header says of an array what that says of itself.
bool describes(const EnviHeader& header, const NpyHeader& array) {
  const char* type = header.pixel == EnviHeader::Pixel::real_float ? "<f4" : "<c8";
  const std::vector<std::uint64_t> shape{header.lines, header.samples};
  return array.type == type && !array.fortran_order && array.shape == shape &&
         array.data_offset == header.header_offset;
}

// Image and array of one stem share the name of the header, which can only be that of one of them.
std::optional<core::Problem> misfit_of_array(const std::filesystem::path& data, const EnviHeader& header) {
  const auto array = array_header(data);
  if (!array || describes(header, *array)) return std::nullopt;
  return file_problem(data.string(), "the header beside the array is that of another file",
                      envi_header_of(data).string(), "",
                      "keep files of one name in folders of their own; sarsim convert writes an image's header anew");
}

std::filesystem::path appended_header_path(const std::filesystem::path& data) { return data.string() + ".hdr"; }

// Whether a header can be that of a data file, as far as sizes tell and what an array says of itself.
bool can_belong(const std::filesystem::path& header_file, const std::filesystem::path& data) {
  std::error_code failure;
  for (const std::filesystem::path& file : {header_file, data})
    if (!std::filesystem::is_regular_file(file, failure)) return false;
  const EnviReading reading = read_envi_header(header_text(header_file), header_file.string());
  if (!reading.header) return false;
  const EnviHeader& header = *reading.header;
  if (const auto array = array_header(data)) return describes(header, *array);
  const auto bytes = checked_product(header.samples, header.lines, pixel_bytes(header.pixel));
  const std::uintmax_t size = std::filesystem::file_size(data, failure);
  return !failure && bytes && size >= *bytes + header.header_offset;
}

}  // namespace

std::optional<std::string> EnviHeader::field(std::string_view name) const {
  const auto found = std::ranges::find(fields, name, [](const auto& pair) -> std::string_view { return pair.first; });
  if (found == fields.end()) return std::nullopt;
  return found->second;
}

std::size_t pixel_bytes(EnviHeader::Pixel pixel) { return pixel == EnviHeader::Pixel::real_float ? 4 : 8; }

std::string to_text(const EnviHeader& header) {
  std::string text = fmt::format(
      "ENVI\ndescription = {{{}}}\nsamples = {}\nlines = {}\nbands = 1\nheader offset = {}\nfile type = ENVI Standard\n"
      "data type = {}\ninterleave = bsq\nbyte order = 0\n",
      harmless(header.description), header.samples, header.lines, header.header_offset, static_cast<int>(header.pixel));
  for (const auto& [name, value] : header.fields) text += fmt::format("{} = {{{}}}\n", name, harmless(value));
  return text;
}

EnviReading read_envi_header(std::string_view text, const std::string& file) {
  EnviReading reading;
  if (!core::trimmed(text.substr(0, text.find('\n'))).starts_with("ENVI")) {
    reading.problems.push_back(
        file_problem(file, "this is not the header of an ENVI image", "", "'ENVI' in the first line"));
    return reading;
  }
  std::string open;
  Fields fields = fields_of(text, open);
  if (!open.empty())
    reading.problems.push_back(file_problem(file, fmt::format("the brace of '{:.60}' is not closed", open), {},
                                            "{ ... }", "close it: what follows would count as its value"));
  refuse_doubles(fields, file, reading.problems);
  refuse_changes(fields, file, reading.problems);
  refuse_cut_out(fields, file, reading.problems);
  EnviHeader header;
  NumberTaker numbers(fields, file, reading.problems);
  header.samples = numbers.take_number("samples", std::nullopt);
  header.lines = numbers.take_number("lines", std::nullopt);
  header.header_offset = numbers.take_number("header offset", 0);
  const std::size_t type = numbers.take_number("data type", std::nullopt);
  numbers.expect("data type", type, {4, 6}, "4 (float) or 6 (complex float)");
  numbers.expect("bands", numbers.take_number("bands", 1), {1}, "1");
  numbers.expect("byte order", numbers.take_number("byte order", 0), {0}, "0 (least significant byte first)");
  header.pixel = type == 4 ? EnviHeader::Pixel::real_float : EnviHeader::Pixel::complex_float;
  header.description = take(fields, "description").value_or("");
  expect_word("file type", take(fields, "file type"), {"ENVI Standard", "ENVI", "Standard"}, "ENVI Standard", file,
              reading.problems);
  expect_word("interleave", take(fields, "interleave"), {"bsq", "bil", "bip"}, "bsq, bil or bip", file,
              reading.problems);
  header.fields = std::move(fields);
  if (!core::has_errors(reading.problems)) reading.header = std::move(header);
  return reading;
}

std::filesystem::path envi_header_of(const std::filesystem::path& data) {
  const std::filesystem::path replaced = header_path(data);
  const std::filesystem::path appended = appended_header_path(data);
  if (!std::filesystem::exists(appended)) return replaced;
  return std::filesystem::exists(replaced) && can_belong(replaced, data) ? replaced : appended;
}

std::vector<std::filesystem::path> images_of_header(const std::filesystem::path& header_file) {
  std::vector<std::filesystem::path> images;
  std::error_code failure;
  if (!std::filesystem::is_regular_file(header_file, failure)) return images;
  const EnviReading reading = read_envi_header(header_text(header_file), header_file.string());
  if (!reading.header) return images;
  const EnviHeader& header = *reading.header;
  const auto bytes = checked_product(header.samples, header.lines, pixel_bytes(header.pixel));
  const std::filesystem::path folder = header_file.has_parent_path() ? header_file.parent_path() : ".";
  for (std::filesystem::directory_iterator entry(folder, failure), end; !failure && entry != end;
       entry.increment(failure)) {
    const std::filesystem::path data = header_file.parent_path() / entry->path().filename();
    std::error_code ignored;
    if (data == header_file || data.stem() != header_file.stem() || !entry->is_regular_file(ignored)) continue;
    if (bytes && entry->file_size(ignored) == *bytes + header.header_offset && can_belong(header_file, data))
      images.push_back(data);
  }
  return images;
}

EnviWriter::EnviWriter(const std::filesystem::path& data, EnviHeader header, bool replace)
    : header_(std::move(header)), data_(data, replace), text_(header_path(data), replace) {
  CORE_EXPECT(header_.samples > 0);
  CORE_EXPECT(header_.lines > 0);
  if (data == header_path(data))
    throw std::invalid_argument("an image and its header cannot both be '" + data.string() + "'");
}

void EnviWriter::append(std::span<const std::complex<float>> row) {
  if (row.size() != header_.samples || rows_ >= header_.lines)
    throw std::logic_error("a row that does not belong to this image");
  ++rows_;
  if (header_.pixel == EnviHeader::Pixel::complex_float) {
    data_.write(std::as_bytes(row));
    return;
  }
  magnitudes_.resize(row.size());
  std::ranges::transform(row, magnitudes_.begin(), [](std::complex<float> value) { return std::abs(value); });
  data_.write(std::as_bytes(std::span(magnitudes_)));
}

void EnviWriter::finish() {
  if (rows_ != header_.lines) throw std::logic_error("rows of this image are missing");
  const std::string text = to_text(header_);
  text_.write(std::as_bytes(std::span(text)));
  data_.secure();
  text_.secure();
  data_.commit();
  text_.commit();
}

bool has_envi_header(const std::filesystem::path& data) {
  if (row_from_path(data) == &sicd_format()) return false;  // A header of that name is that of another image.
  const std::filesystem::path header_file = envi_header_of(data);
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(header_file, ignored)) return false;
  if (!array_header(data)) return true;
  const EnviReading reading = read_envi_header(header_text(header_file), header_file.string());
  return reading.header && !misfit_of_array(data, *reading.header);
}

EnviImage::EnviImage(EnviHeader header, std::filesystem::path data, core::InputFile file)
    : header_(std::move(header)),
      data_(std::move(data)),
      file_(std::make_shared<const core::InputFile>(std::move(file))) {}

// What to do with a file that is no image: a recording, as most formats are for, or a scene.
std::string remedy_without_header(const std::filesystem::path& data) {
  const std::string extension = core::lower_case(data.extension().string());
  if (extension == ".toml" || extension == ".scr" || extension == ".json")
    return "this is a scene: sarsim run records it, and sarsim focus makes an image of the recording";
  // NPY may be either.
  if (extension != ".npy" && format_from_path(data))
    return fmt::format("if this is a recording, sarsim focus {} makes an image of it", data.string());
  return "sarsim focus writes images with their headers as ENVI and NPY, and convert copies them";
}

std::pair<std::optional<EnviImage>, core::Problems> EnviImage::open(const std::filesystem::path& data) {
  const std::filesystem::path header_file = envi_header_of(data);
  if (core::equal_ignoring_case(data.extension().string(), ".hdr") && std::filesystem::exists(data))
    return {std::nullopt,
            {file_problem(data.string(), "this is the header of an image", "", "the image beside it",
                          "name the file of its samples, which ends with .img or .npy")}};
  if (!std::filesystem::exists(header_file))
    return {std::nullopt,
            {file_problem(data.string(), "the image has no header beside it", "",
                          fmt::format("{} or {}", header_file.string(), appended_header_path(data).string()),
                          remedy_without_header(data))}};
  for (const std::filesystem::path& file : {header_file, data})
    if (auto problem = problem_of_kind(file)) return {std::nullopt, {std::move(*problem)}};
  EnviReading reading = read_envi_header(header_text(header_file), header_file.string());
  if (!reading.header) return {std::nullopt, std::move(reading.problems)};
  const EnviHeader& header = *reading.header;
  if (auto misfit = misfit_of_array(data, header)) return {std::nullopt, {std::move(*misfit)}};
  auto opened = core::InputFile::open(data);
  if (auto* const problem = std::get_if<core::Problem>(&opened)) return {std::nullopt, {std::move(*problem)}};
  auto& file = std::get<core::InputFile>(opened);
  const std::uint64_t found = file.size();
  const auto bytes = checked_product(header.samples, header.lines, pixel_bytes(header.pixel));
  if (!bytes || found < *bytes + header.header_offset)
    return {std::nullopt,
            {file_problem(data.string(), "the file is shorter than its header says", std::to_string(found),
                          bytes ? fmt::format("{} bytes", *bytes + header.header_offset) : std::string())}};
  if (found > *bytes + header.header_offset)
    reading.problems.push_back(with_severity(
        file_problem(data.string(), "the file is longer than its header says", fmt::format("{} bytes", found),
                     fmt::format("{} bytes", *bytes + header.header_offset),
                     "'lines', 'samples' or 'header offset' may be those of another file"),
        core::Severity::warning));
  return {EnviImage(std::move(*reading.header), data, std::move(file)), std::move(reading.problems)};
}

void EnviImage::read(std::size_t line, std::size_t first, std::span<std::complex<float>> out) const {
  CORE_EXPECT(line < header_.lines);
  CORE_EXPECT(first + out.size() <= header_.samples);
  const std::size_t size = pixel_bytes(header_.pixel);
  std::vector<std::byte> bytes(out.size() * size);
  file_->read_all_at(header_.header_offset + (line * header_.samples + first) * size, bytes);
  for (std::size_t i = 0; i < out.size(); ++i) {
    float part[2] = {0.0F, 0.0F};
    std::memcpy(part, bytes.data() + i * size, size);
    out[i] = {part[0], part[1]};
  }
}

}  // namespace sarsim::raster
