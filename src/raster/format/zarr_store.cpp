#include "raster/format/zarr_store.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <system_error>
#include <utility>

#include "core/os/raw_file.hpp"
#include "raster/format/zarr_metadata.hpp"
#include "raster/table/described_product.hpp"
#include "scene/schema/option_words.hpp"

namespace sarsim::raster {

namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t max_chunk_bytes = std::uint64_t{8} << 20U;

void write_whole(const fs::path& path, std::span<const std::byte> bytes) {
  core::RawFile file(path, core::RawFile::Mode::write);
  file.resize(bytes.size());
  file.write_at(0, bytes);
}

void write_sizes(core::JsonWriter& json, const char* name, std::span<const std::uint64_t> sizes) {
  json.key(name).begin_array();
  for (const std::uint64_t size : sizes) json.value(size);
  json.end_array();
}

// The members of an object.
void write_attributes(core::JsonWriter& json, const Attributes& attributes) {
  for (const auto& attribute : attributes)
    std::visit([&](const auto& value) { json.member(attribute.first, value); }, attribute.second);
}

// One letter each, in the four bytes that NumPy gives it.
std::vector<std::byte> letters_of(const std::vector<std::string>& words) {
  std::vector<std::byte> bytes;
  for (const std::string& word : words) {
    bytes.push_back(static_cast<std::byte>(word.front()));
    bytes.resize(bytes.size() + 3);
  }
  return bytes;
}

// An array as its two files of JSON describe it.
struct ArrayText {
  std::string type;
  std::vector<std::uint64_t> shape;
  std::vector<std::uint64_t> chunks;
  std::vector<std::string> dimensions;
  Attributes attributes;
};

// Writes all of a store but its samples.
class StoreWriter {
 public:
  StoreWriter(const fs::path& folder, const Product& product, const Encoding& encoding)
      : folder_(folder),
        product_(product),
        encoding_(encoding),
        described_(describe(product, scene::option_words(product.options), encoding.counts)) {}

  void write(const RunReport& report) {
    for (auto& [name, value] : described_.root)
      if (name == "lsb_v") value = report.lsb_v;
    all_.begin_object().member("zarr_consolidated_format", 1).key("metadata").begin_object();
    put(".zgroup", [](core::JsonWriter& json) { json.member("zarr_format", 2); });
    put(".zattrs", [&](core::JsonWriter& json) { write_attributes(json, described_.root); });
    for (const DescribedArray& array : described_.arrays) put_array(array);
    if (encoding_.counts) put_array({.name = "iq", .dimensions = {"iq"}, .words = {"I", "Q"}});
    if (!described_.map.empty()) {
      describe_array(map_name, {"<i4", {}, {}, {}, described_.map});
      write_whole(folder_ / map_name / "0", std::array<std::byte, 4>{});
    }
    put_samples();
    all_.end_object().end_object();
    write_text(".zmetadata", all_.text());
  }

 private:
  void write_text(const std::string& name, const std::string& text) const {
    write_whole(folder_ / name, std::as_bytes(std::span(text)));
  }

  // A file of JSON, alone and among all of them.
  template <class Members>
  void put(const std::string& name, const Members& members) {
    core::JsonWriter alone;
    for (core::JsonWriter* const json : {&alone, &all_.key(name)}) {
      json->begin_object();
      members(*json);
      json->end_object();
    }
    write_text(name, alone.text());
  }

  void describe_array(const std::string& name, const ArrayText& array) {
    fs::create_directories(folder_ / name);
    put(name + "/.zarray",
        [&](core::JsonWriter& json) { write_zarr_array(json, array.type, array.shape, array.chunks); });
    put(name + "/.zattrs", [&](core::JsonWriter& json) {
      json.key("_ARRAY_DIMENSIONS").begin_array();
      for (const std::string& dimension : array.dimensions) json.value(dimension);
      json.end_array();
      write_attributes(json, array.attributes);
    });
  }

  void put_array(const DescribedArray& array) {
    if (!array.words.empty()) {
      const std::vector<std::uint64_t> size{array.words.size()};
      describe_array(array.name, {"<U1", size, size, array.dimensions, array.attributes});
      return write_whole(folder_ / array.name / "0", letters_of(array.words));
    }
    const std::size_t rows = array.along == Along::rows ? product_.rows : product_.columns;
    const std::size_t at_once = zarr_chunk_rows(rows, array.width * sizeof(double));
    ArrayText text{"<f8", {rows}, {at_once}, array.dimensions, array.attributes};
    std::string end;
    if (array.width > 1) {
      text.shape.push_back(array.width);
      text.chunks.push_back(array.width);
      end = ".0";
    }
    describe_array(array.name, text);
    std::vector<double> numbers(at_once * array.width);
    for (std::size_t chunk = 0; chunk * at_once < rows; ++chunk) {
      std::ranges::fill(numbers, 0.0);
      for (std::size_t i = 0; i < std::min(at_once, rows - chunk * at_once); ++i)
        array.values(chunk * at_once + i, std::span(numbers).subspan(i * array.width, array.width));
      write_whole(folder_ / array.name / (std::to_string(chunk) + end), std::as_bytes(std::span(numbers)));
    }
  }

  void put_samples() {
    const std::size_t component = array_component_bytes(encoding_);
    ArrayText text{encoding_.counts ? (component == 8 ? "<i8" : "<i4") : (component == 8 ? "<c16" : "<c8"),
                   {product_.rows, product_.columns},
                   {zarr_places(product_, encoding_).piece_rows(), std::max<std::size_t>(1, product_.columns)},
                   {described_.down, described_.across},
                   described_.samples};
    if (encoding_.counts) {
      text.shape.push_back(2);
      text.chunks.push_back(2);
      text.dimensions.emplace_back("iq");
    }
    describe_array("samples", text);
  }

  fs::path folder_;
  const Product& product_;
  const Encoding& encoding_;
  DescribedProduct described_;
  core::JsonWriter all_;
};

// "0", "12.0", "3.0.0": the file of a chunk.
bool names_chunk(const std::string& name) {
  bool digit = false;
  for (const char c : name) {
    if (c == '.' && !digit) return false;
    digit = c != '.';
    if (digit && std::isdigit(static_cast<unsigned char>(c)) == 0) return false;
  }
  return digit;
}

bool only_array_files(const fs::path& folder) {
  std::error_code failure;
  for (fs::directory_iterator entry(folder, failure), end; !failure && entry != end; entry.increment(failure)) {
    const std::string name = entry->path().filename().string();
    const bool known = name == ".zarray" || name == ".zattrs" || names_chunk(name);
    if (!known || !fs::is_regular_file(entry->symlink_status())) return false;
  }
  return !failure;
}

}  // namespace

void write_zarr_array(core::JsonWriter& json, const std::string& type, std::span<const std::uint64_t> shape,
                      std::span<const std::uint64_t> chunks) {
  json.member("zarr_format", 2).member("dtype", type).member("order", "C");
  write_sizes(json, "shape", shape);
  write_sizes(json, "chunks", chunks);
  json.key("compressor").null().key("fill_value").null().key("filters").null();
}

std::size_t zarr_chunk_rows(std::size_t rows, std::uint64_t row_bytes) {
  const std::size_t most =
      static_cast<std::size_t>(std::max<std::uint64_t>(1, max_chunk_bytes / std::max<std::uint64_t>(1, row_bytes)));
  const std::size_t chunks = std::max<std::size_t>(1, (rows + most - 1) / most);
  return std::max<std::size_t>(1, (rows + chunks - 1) / chunks);
}

RowPlaces zarr_places(const Product& product, const Encoding& encoding) {
  // A row without samples has a byte, so that there is something to divide by.
  const std::uint64_t row_bytes = std::max<std::uint64_t>(1, 2 * product.columns * array_component_bytes(encoding));
  return {.first_byte = 0,
          .row_bytes = row_bytes,
          .piece_bytes = zarr_chunk_rows(product.rows, row_bytes) * row_bytes,
          .piece_begin = "samples/",
          .piece_end = encoding.counts ? ".0.0" : ".0"};
}

void complete_zarr(const fs::path& folder, const Product& product, const Encoding& encoding, const RunReport& report) {
  StoreWriter(folder, product, encoding).write(report);
}

bool is_own_zarr_store(const fs::path& folder) {
  std::error_code failure;
  if (!fs::is_directory(folder, failure)) return false;
  const auto attributes = read_zarr_attributes(folder / ".zattrs");
  const auto* const read = std::get_if<ArrayAttributes>(&attributes);
  if (read == nullptr || attribute_of(read->known, "format_version").empty() ||
      attribute_of(read->known, "program_version").empty())
    return false;
  for (fs::directory_iterator entry(folder, failure), end; !failure && entry != end; entry.increment(failure)) {
    const std::string name = entry->path().filename().string();
    const fs::file_status status = entry->symlink_status();
    const bool text = name == ".zgroup" || name == ".zattrs" || name == ".zmetadata";
    if (text ? !fs::is_regular_file(status) : !fs::is_directory(status) || !only_array_files(entry->path()))
      return false;
  }
  return !failure;
}

bool looks_like_zarr(const fs::path& folder) {
  std::error_code ignored;
  return std::ranges::any_of(std::array{".zgroup", ".zarray", "zarr.json"},
                             [&](const char* name) { return fs::exists(folder / name, ignored); });
}

}  // namespace sarsim::raster
