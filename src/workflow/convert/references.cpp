#include "workflow/convert/references.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <system_error>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "core/os/input_file.hpp"
#include "core/os/output_file.hpp"
#include "core/report/invalid_request.hpp"
#include "core/text/json.hpp"
#include "core/text/number_text.hpp"
#include "raster/format/zarr_store.hpp"
#include "raster/table/formats.hpp"
#include "raster/table/stored_array.hpp"
#include "simulate/plan/product.hpp"
#include "workflow/input/output_names.hpp"

namespace sarsim::workflow {

namespace {

constexpr std::uint64_t mebibyte = std::uint64_t{1} << 20U;

// JSON within a string: without the line feeds and blanks that make it readable.
std::string compact(const core::JsonWriter& json) {
  std::string text;
  bool at_begin = false;
  for (const char c : json.text()) {
    if (c == '\n') at_begin = true;
    if (c == '\n' || (at_begin && c == ' ')) continue;
    at_begin = false;
    text += c;
  }
  return text;
}

std::string base64(std::span<const std::byte> bytes) {
  constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t three = 0;
    for (std::size_t k = 0; k < 3; ++k)
      three = three << 8U | (i + k < bytes.size() ? std::to_integer<std::uint32_t>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k) text += i + k > bytes.size() ? '=' : letters[three >> (18U - 6U * k) & 63U];
  }
  return text;
}

std::uint64_t row_bytes_of(const raster::StoredArray& array) {
  std::uint64_t bytes = array.item_bytes;
  for (std::size_t i = 1; i < array.shape.size(); ++i) bytes *= array.shape[i];
  return bytes;
}

template <class Number>
void put_sizes(core::JsonWriter& json, const char* name, const std::vector<Number>& sizes) {
  json.key(name).begin_array();
  for (const Number& size : sizes) json.value(size);
  json.end_array();
}

void put_fact(core::JsonWriter& json, const std::string& name, const raster::FactValue& value) {
  std::visit([&](const auto& v) { json.member(name, v); }, value);
}

// Writes the references of one file.
class ReferenceWriter {
 public:
  ReferenceWriter(const raster::Raster& file, const core::InputFile& bytes) : file_(file), bytes_(bytes) {}

  std::string text(const std::vector<raster::StoredArray>& arrays) {
    json_.begin_object().member("version", 1);
    json_.key("templates").begin_object().member("file", address()).end_object();
    json_.key("refs").begin_object();
    core::JsonWriter group;
    group.begin_object().member("zarr_format", 2).end_object();
    json_.member(".zgroup", compact(group)).member(".zattrs", attributes_of_file());
    for (const raster::StoredArray& array : arrays) put(array);
    json_.end_object().end_object();
    return json_.text();
  }

 private:
  // Readers replace it where the file is elsewhere for them.
  [[nodiscard]] std::string address() const {
    std::error_code ignored;
    const auto absolute = std::filesystem::absolute(bytes_.path(), ignored).lexically_normal();
    return absolute.empty() ? bytes_.path().string() : absolute.string();
  }

  [[nodiscard]] std::string attributes_of_file() const {
    static constexpr std::array numbers{"bits", "format_version", "lsb_v", "sample_rate_hz", "tolerance"};
    core::JsonWriter json;
    json.begin_object();
    for (const auto& [name, value] : file_.info().attributes) {
      const auto number = core::parse_number(value);
      const bool is_number = std::ranges::find(numbers, name) != numbers.end() || name.starts_with("geospatial_");
      if (is_number && number)
        json.member(name, *number);
      else
        json.member(name, value);
    }
    return compact(json.end_object());
  }

  void put(const raster::StoredArray& array) {
    const std::uint64_t row_bytes = row_bytes_of(array);
    const ArrayCut cut = array.is_here() ? ArrayCut{array.shape[0], 1, 0} : cut_of_array(array.shape[0], row_bytes);
    json_.member(array.name + "/.zarray", description(array, cut)).member(array.name + "/.zattrs", attributes(array));
    if (!array.words.empty()) return put_words(array);
    if (array.is_here())
      return static_cast<void>(
          json_.member(piece_name(array, 0), "base64:" + base64(std::as_bytes(std::span(array.numbers)))));
    const std::uint64_t piece_bytes = cut.rows * row_bytes;
    for (std::uint64_t i = 0; i < cut.whole; ++i) {
      json_.key(piece_name(array, i)).begin_array();
      json_.value("{{file}}").value(array.offset + i * piece_bytes).value(piece_bytes).end_array();
    }
    if (cut.rest > 0) put_rest(array, cut);
  }

  // Every piece of a Zarr array is full: what is missing of the last one is zeros, and it stands here itself.
  void put_rest(const raster::StoredArray& array, const ArrayCut& cut) {
    const std::uint64_t row_bytes = row_bytes_of(array);
    std::vector<std::byte> piece(static_cast<std::size_t>(cut.rows * row_bytes));
    bytes_.read_all_at(array.offset + cut.whole * cut.rows * row_bytes,
                       std::span(piece).first(static_cast<std::size_t>(cut.rest * row_bytes)));
    json_.member(piece_name(array, cut.whole), "base64:" + base64(piece));
  }

  // One letter each, in the four bytes that NumPy gives it.
  void put_words(const raster::StoredArray& array) {
    std::vector<std::byte> bytes;
    for (const std::string& word : array.words) {
      bytes.push_back(static_cast<std::byte>(word.front()));
      bytes.resize(bytes.size() + 3);
    }
    json_.member(piece_name(array, 0), "base64:" + base64(bytes));
  }

  static std::string piece_name(const raster::StoredArray& array, std::uint64_t piece) {
    std::string name = fmt::format("{}/{}", array.name, piece);
    for (std::size_t i = 1; i < array.shape.size(); ++i) name += ".0";
    return name;
  }

  static std::string description(const raster::StoredArray& array, const ArrayCut& cut) {
    std::vector<std::uint64_t> chunks = array.shape;
    chunks.front() = cut.rows;
    core::JsonWriter json;
    raster::write_zarr_array(json.begin_object(), array.type, array.shape, chunks);
    return compact(json.end_object());
  }

  static std::string attributes(const raster::StoredArray& array) {
    core::JsonWriter json;
    json.begin_object();
    put_sizes(json, "_ARRAY_DIMENSIONS", array.dimensions);
    for (const auto& [name, value] : array.facts) put_fact(json, name, value);
    return compact(json.end_object());
  }

  const raster::Raster& file_;
  const core::InputFile& bytes_;
  core::JsonWriter json_;
};

core::InputFile opened(const std::string& path) {
  auto file = core::InputFile::open(path);
  if (auto* problem = std::get_if<core::Problem>(&file)) throw core::InvalidRequest({std::move(*problem)});
  return std::move(std::get<core::InputFile>(file));
}

// Times, carriers and ranges, which the file does not say, by the script that wrote it.
void add_axes(std::vector<raster::StoredArray>& arrays, const simulate::Acquisition& acquisition) {
  std::vector<double> times;
  std::vector<double> carriers;
  const raster::Product product = simulate::product_of(acquisition, {});
  for (std::size_t row = 0; row < acquisition.timing.rows; ++row) {
    times.push_back(product.row_time_s(row));
    carriers.push_back(product.row_carrier_hz(row));
  }
  raster::StoredArray& samples = arrays.front();
  samples.dimensions[0] = "pulse_time_s";
  samples.dimensions[1] = "slant_range_m";
  samples.facts.emplace_back("coordinates", "carrier_hz");
  arrays.push_back(raster::axis_here("pulse_time_s", std::move(times), "s", "send time"));
  arrays.push_back(
      raster::axis_here("slant_range_m", acquisition.reception.column_range_m, "m", "one-way slant range"));
  arrays.push_back(raster::axis_here("carrier_hz", std::move(carriers), "Hz", "carrier frequency"));
  arrays.back().dimensions = {"pulse_time_s"};
}

std::vector<raster::StoredArray> arrays_of(const raster::Raster& raster, const core::InputFile& file,
                                           const raster::RasterHints& hints) {
  const raster::Format& format = *raster.info().format;
  if (format.arrays == nullptr)
    throw core::InvalidRequest(
        fmt::format("--references: the numbers of '{}' ({}) are not stored in native binary form", file.path().string(),
                    raster::word_of(format)),
        "convert it to .h5, .npy or .zarr first");
  auto arrays = format.arrays(file, hints);
  if (auto* problem = std::get_if<core::Problem>(&arrays)) {
    problem->place.file = file.path().string();
    throw core::InvalidRequest({std::move(*problem)});
  }
  return std::move(std::get<std::vector<raster::StoredArray>>(arrays));
}

}  // namespace

ArrayCut cut_of_array(std::uint64_t rows, std::uint64_t row_bytes) {
  constexpr std::uint64_t usual_pieces = 4096;
  constexpr std::uint64_t leeway = 16;
  const std::uint64_t total = rows * row_bytes;
  const std::uint64_t wanted = std::clamp(total / usual_pieces, mebibyte, 64 * mebibyte);
  const std::uint64_t most = std::clamp<std::uint64_t>(2 * wanted / row_bytes, 1, rows);
  const std::uint64_t least = std::clamp<std::uint64_t>(wanted / leeway / row_bytes, 1, rows);
  for (std::uint64_t piece = most; piece >= least; --piece)
    if (rows % piece == 0) return {piece, rows / piece, 0};
  return {least, rows / least, rows % least};
}

void write_references(const ReferencesRequest& request, const core::Observer& observer) {
  const raster::RasterHints hints = hints_for(request.input, request.sample, observer);
  const std::shared_ptr<const raster::Raster> raster = open_samples(request.input, hints, observer).file;
  if (raster->info().format->folder)
    throw core::InvalidRequest(
        fmt::format("--references: '{}' is a Zarr store, which readers of Zarr open as it is", request.input),
        "name the store itself to them");
  // The last of several files has the samples.
  const core::InputFile file = opened(raster::files_of(raster->info().format, request.input).back().string());
  std::vector<raster::StoredArray> arrays = arrays_of(*raster, file, hints);
  const bool bare = arrays.front().dimensions.front() == "pulse";
  if (bare && !request.sample.script.empty()) {
    const simulate::Acquisition acquisition =
        acquisition_of_file(request.input, request.sample.script, {}, observer.stop);
    if (acquisition.timing.rows == raster->rows() && acquisition.reception.columns == raster->columns())
      add_axes(arrays, acquisition);
  }
  expect_free_outputs({request.output},
                      {InputList::named({request.input, request.sample.script}), request.force, "--references"});
  core::OutputFile output(request.output, request.force);
  const std::string text = ReferenceWriter(*raster, file).text(arrays);
  output.write(std::as_bytes(std::span(text)));
  output.commit();
}

}  // namespace sarsim::workflow
