#include "raster/format/zarr_metadata.hpp"

#include <algorithm>
#include <limits>
#include <span>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/os/input_file.hpp"
#include "core/text/number_text.hpp"
#include "core/text/quoted_word.hpp"
#include "raster/table/file_problem.hpp"
#include "raster/table/json_failure.hpp"
#include "raster/table/json_once.hpp"

namespace sarsim::raster {

namespace {

using Json = nlohmann::json;

constexpr std::uint64_t longest_array_text = std::uint64_t{1} << 20U;
constexpr std::uint64_t longest_attributes_text = std::uint64_t{1} << 30U;
constexpr std::size_t max_dimensions = 32;

core::Problem zarr_problem(std::string message, std::string found = {}, std::string expected = {},
                           std::string hint = {}) {
  return file_problem({}, std::move(message), std::move(found), std::move(expected), std::move(hint));
}

bool is_simple(const Json& value) { return !value.is_structured(); }

// A value as it stands in the file, shortened. Deep ones are not written: that takes a call for each level.
std::string found_text(const Json& value) {
  if (!is_simple(value) && !std::ranges::all_of(value, is_simple)) return value.is_array() ? "[ ... ]" : "{ ... }";
  return core::quoted_word(value.dump(-1, ' ', true, Json::error_handler_t::replace));
}

// An object, or why it is none.
std::variant<Json, core::Problem> object_in(std::string_view text) {
  try {
    std::string twice;
    Json tree = parse_json_once(text, twice);
    if (!twice.empty()) return zarr_problem(twice + " is there twice", {}, "one value", "remove one of them");
    if (!tree.is_object()) return zarr_problem("this is not a JSON object", found_text(tree), "{ ... }");
    return tree;
  } catch (const Json::exception& error) {
    return not_json({}, error);
  }
}

const Json& member_of(const Json& object, const char* name) {
  static const Json none;
  const auto found = object.find(name);
  return found == object.end() ? none : *found;
}

std::optional<std::vector<std::uint64_t>> sizes_of(const Json& list, std::uint64_t least) {
  constexpr std::uint64_t most = std::uint64_t{1} << 62U;
  if (!list.is_array() || list.size() > max_dimensions) return std::nullopt;
  std::vector<std::uint64_t> sizes;
  std::uint64_t product = 1;
  for (const Json& size : list) {
    if (!size.is_number_unsigned()) return std::nullopt;
    sizes.push_back(size.get<std::uint64_t>());
    if (sizes.back() < least || sizes.back() > most) return std::nullopt;
    if (__builtin_mul_overflow(product, sizes.back(), &product) || product > most) return std::nullopt;
  }
  return sizes;
}

// A number as NumPy's users of Zarr write it; nothing where it is none.
std::optional<double> fill_number(const Json& value) {
  if (value.is_number()) return value.get<double>();
  if (!value.is_string()) return std::nullopt;
  const std::string& word = value.get_ref<const std::string&>();
  if (word == "NaN") return std::numeric_limits<double>::quiet_NaN();
  if (word == "Infinity") return std::numeric_limits<double>::infinity();
  if (word == "-Infinity") return -std::numeric_limits<double>::infinity();
  return std::nullopt;
}

std::optional<std::complex<double>> fill_value(const Json& value) {
  if (!value.is_array()) {
    const auto number = fill_number(value);
    return number ? std::optional<std::complex<double>>(*number) : std::nullopt;
  }
  const auto real = value.size() == 2 ? fill_number(value[0]) : std::nullopt;
  const auto imaginary = value.size() == 2 ? fill_number(value[1]) : std::nullopt;
  return real && imaginary ? std::optional<std::complex<double>>({*real, *imaginary}) : std::nullopt;
}

std::optional<core::Problem> storage_problem(const Json& tree) {
  if (const Json& version = member_of(tree, "zarr_format"); version != 2)
    return zarr_problem("the array is of another version of Zarr", found_text(version), "2",
                        "store it with zarr_format=2");
  if (const Json& compressor = member_of(tree, "compressor"); !compressor.is_null()) {
    const Json& id = compressor.is_object() ? member_of(compressor, "id") : compressor;
    return zarr_problem("the array is compressed", found_text(id), "no compressor",
                        "store it with compressor=None: zarr.array(array, compressor=None)");
  }
  if (const Json& filters = member_of(tree, "filters"); !filters.is_null() && !filters.empty())
    return zarr_problem("the numbers of the array are filtered", found_text(filters), "no filters",
                        "store it with filters=None");
  if (const Json& order = member_of(tree, "order"); order != "C")
    return zarr_problem("the array is not in C order", found_text(order), "C", "store it with order='C'");
  return std::nullopt;
}

// Some numbers, or names of dimensions, separated by commas; nothing for other lists.
std::optional<std::string> list_text(const Json& list, bool names) {
  constexpr std::size_t max_listed = 16;
  if (list.empty() || list.size() > max_listed) return std::nullopt;
  std::string text;
  for (const Json& value : list) {
    if (!(names ? value.is_string() : value.is_number())) return std::nullopt;
    text += text.empty() ? "" : ", ";
    text += names ? value.get<std::string>() : core::format_number(value.get<double>());
  }
  return text;
}

// An attribute as text; nothing for one that is not read.
std::optional<std::string> attribute_text(const std::string& name, const Json& value, bool lists) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number_integer()) return value.dump();
  if (value.is_number_float()) return core::format_number(value.get<double>());
  return lists && value.is_array() ? list_text(value, name == "_ARRAY_DIMENSIONS") : std::nullopt;
}

// The whole of a file of text, or why not; nothing where it is missing.
std::variant<std::monostate, std::string, core::Problem> text_in(const std::filesystem::path& path,
                                                                 std::uint64_t longest) {
  std::error_code ignored;
  const auto status = std::filesystem::symlink_status(path, ignored);
  if (!std::filesystem::exists(status)) return {};
  auto opened = core::InputFile::open(path);
  if (auto* problem = std::get_if<core::Problem>(&opened)) return std::move(*problem);
  const auto& file = std::get<core::InputFile>(opened);
  if (file.size() > longest)
    return file_problem(path.string(), "the file is too long", core::bytes_text(static_cast<double>(file.size())),
                        fmt::format("at most {}", core::bytes_text(static_cast<double>(longest))));
  std::string text(static_cast<std::size_t>(file.size()), '\0');
  file.read_all_at(0, std::as_writable_bytes(std::span(text)));
  return text;
}

}  // namespace

std::variant<ZarrArray, core::Problem> parse_zarr_array(std::string_view text) {
  auto read = object_in(text);
  if (auto* problem = std::get_if<core::Problem>(&read)) return std::move(*problem);
  const Json& tree = std::get<Json>(read);
  if (auto problem = storage_problem(tree)) return std::move(*problem);
  ZarrArray array;
  const Json& type = member_of(tree, "dtype");
  if (!type.is_string()) return zarr_problem("the array holds structures", found_text(type), "numbers, such as <c8");
  array.type = type.get<std::string>();
  auto shape = sizes_of(member_of(tree, "shape"), 0);
  auto chunks = sizes_of(member_of(tree, "chunks"), 1);
  if (!shape) return zarr_problem("the array has no possible shape", found_text(member_of(tree, "shape")));
  if (!chunks || chunks->size() != shape->size())
    return zarr_problem("the array has no possible chunks", found_text(member_of(tree, "chunks")),
                        fmt::format("{} sizes from 1 on", shape->size()));
  array.shape = std::move(*shape);
  array.chunks = std::move(*chunks);
  const Json& separator = member_of(tree, "dimension_separator");
  if (!separator.is_null() && separator != "." && separator != "/")
    return zarr_problem("chunks are named in an unknown way", found_text(separator), R"("." or "/")");
  if (separator == "/") array.separator = '/';
  array.fill = fill_value(member_of(tree, "fill_value"));
  return array;
}

std::variant<ArrayAttributes, core::Problem> parse_zarr_attributes(std::string_view text, bool lists) {
  auto read = object_in(text);
  if (auto* problem = std::get_if<core::Problem>(&read)) return std::move(*problem);
  ArrayAttributes attributes;
  for (const auto& [name, value] : std::get<Json>(read).items())
    if (auto known = attribute_text(name, value, lists))
      attributes.known.emplace_back(name, std::move(*known));
    else
      attributes.unreadable.emplace_back(name, found_text(value));
  return attributes;
}

std::variant<ZarrArray, core::Problem> read_zarr_array(const std::filesystem::path& file) {
  auto text = text_in(file, longest_array_text);
  if (auto* problem = std::get_if<core::Problem>(&text)) return std::move(*problem);
  if (std::holds_alternative<std::monostate>(text))
    return file_problem(file.string(), "the file is missing that describes the array");
  auto array = parse_zarr_array(std::get<std::string>(text));
  if (auto* problem = std::get_if<core::Problem>(&array)) problem->place.file = file.string();
  return array;
}

std::variant<ArrayAttributes, core::Problem> read_zarr_attributes(const std::filesystem::path& file, bool lists) {
  auto text = text_in(file, longest_attributes_text);
  if (auto* problem = std::get_if<core::Problem>(&text)) return std::move(*problem);
  if (std::holds_alternative<std::monostate>(text)) return ArrayAttributes();
  auto attributes = parse_zarr_attributes(std::get<std::string>(text), lists);
  if (auto* problem = std::get_if<core::Problem>(&attributes)) problem->place.file = file.string();
  return attributes;
}

std::optional<core::Problem> contradiction_of_zarr(const std::filesystem::path& store,
                                                   const std::vector<std::filesystem::path>& names) {
  const auto place = [&](core::Problem problem) {
    problem.place.file = (store / ".zmetadata").string();
    return problem;
  };
  const std::string hint = "remove .zmetadata, or have it written anew: zarr.consolidate_metadata(store)";
  auto all = text_in(store / ".zmetadata", longest_attributes_text);
  if (std::holds_alternative<std::monostate>(all)) return std::nullopt;
  if (auto* problem = std::get_if<core::Problem>(&all)) return place(std::move(*problem));
  auto read = object_in(std::get<std::string>(all));
  if (auto* problem = std::get_if<core::Problem>(&read)) {
    problem->hint = hint;
    return place(std::move(*problem));
  }
  const Json& metadata = member_of(std::get<Json>(read), "metadata");
  if (!metadata.is_object()) return place(zarr_problem("it has no metadata", found_text(metadata), "{ ... }", hint));
  for (const std::filesystem::path& name : names) {
    const auto text = text_in(store / name, longest_attributes_text);
    auto own = Json(nullptr);
    if (const auto* const there = std::get_if<std::string>(&text)) {
      auto own_read = object_in(*there);
      if (auto* problem = std::get_if<core::Problem>(&own_read)) {
        problem->place.file = (store / name).string();
        return std::move(*problem);
      }
      own = std::move(std::get<Json>(own_read));
    }
    const Json& copy = member_of(metadata, name.generic_string().c_str());
    // An array beside the samples of which it knows nothing was put there later, and is the same for all who read it.
    const std::filesystem::path array = name.parent_path();
    const bool beside = !array.empty() && array != names.front().parent_path();
    if (beside && member_of(metadata, (array / ".zarray").generic_string().c_str()).is_null() && copy.is_null())
      continue;
    // No attributes are as good as an empty list of them.
    const bool none = name.filename() == ".zattrs" && own.empty() && copy.empty();
    if (none || copy == own) continue;
    const char* const what = copy.is_null()  ? "it does not have what a file of the store has"
                             : own.is_null() ? "it has what no file of the store has"
                                             : "it contradicts the file itself";
    return place(zarr_problem(what, name.generic_string(), "the same in both", hint));
  }
  return std::nullopt;
}

}  // namespace sarsim::raster
