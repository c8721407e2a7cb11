#include "raster/format/array_reader.hpp"

#include <algorithm>
#include <array>
#include <cstring>

#include <fmt/format.h>

#include "core/text/number_text.hpp"
#include "raster/format/npy_array.hpp"
#include "raster/table/count_range.hpp"

namespace sarsim::raster {

namespace {

constexpr std::size_t chunk_bytes = std::size_t{1} << 20;

// Rows of I/Q pairs of a fixed size, one after the other from some offset on.
template <class Decode>
class ArrayReader final : public SampleReader {
 public:
  ArrayReader(core::InputFile file, SampleFileInfo info, std::uint64_t offset, std::size_t component, Decode decode)
      : SampleReader(std::move(info)),
        file_(std::move(file)),
        offset_(offset),
        component_(component),
        decode_(decode) {}

  void read_rows(std::size_t first, std::size_t, std::span<std::complex<double>> out) const override {
    const std::size_t sample = 2 * component_;
    std::uint64_t place = offset_ + std::uint64_t{first} * info().columns * sample;
    std::vector<std::byte> bytes(std::min(out.size() * sample, chunk_bytes / sample * sample));
    while (!out.empty()) {
      const std::size_t samples = std::min(out.size(), bytes.size() / sample);
      file_.read_all_at(place, std::span(bytes).first(samples * sample));
      for (std::size_t i = 0; i < samples; ++i) {
        const std::byte* pair = bytes.data() + i * sample;
        out[i] = {decode_(pair), decode_(pair + component_)};
      }
      out = out.subspan(samples);
      place += samples * sample;
    }
  }

 private:
  core::InputFile file_;
  std::uint64_t offset_;
  std::size_t component_;
  Decode decode_;
};

struct BinaryDecoder {
  CountRange range;
  double operator()(const std::byte* bytes) const {
    std::uint64_t stored = 0;
    std::memcpy(&stored, bytes, range.component_bytes());
    return static_cast<double>(range.without_offset(stored));
  }
};

template <class Decode>
std::unique_ptr<SampleReader> make_array_reader(core::InputFile file, SampleFileInfo info, std::uint64_t offset,
                                                std::size_t component, Decode decode) {
  return std::make_unique<ArrayReader<Decode>>(std::move(file), std::move(info), offset, component, decode);
}

std::optional<double> known(double value) { return value > 0.0 ? std::optional(value) : std::nullopt; }

// Values that the converter cannot give mean that the number of bits, or the format, is another one.
std::optional<core::Problem> strange_values(const core::InputFile& file, const CountRange& range) {
  std::array<std::byte, 4096> begin{};
  const std::size_t got = file.read_at(0, begin);
  const std::size_t size = range.component_bytes();
  const std::uint64_t highest = range.highest_stored();
  for (std::size_t at = 0; at + size <= got; at += size) {
    std::uint64_t stored = 0;
    std::memcpy(&stored, begin.data() + at, size);
    if (stored <= highest) continue;
    return with_severity(
        file_problem(file.path().string(), fmt::format("the file holds values that {} bits cannot have", range.bits),
                     fmt::format("{} at byte {}", stored, at), fmt::format("0 to {}", highest),
                     "check the number of bits and the format"),
        core::Severity::warning);
  }
  return std::nullopt;
}

core::Problems binary_hint_problems(const std::string& name, const SampleFileHints& hints) {
  core::Problems problems;
  const char* hint = "a BINARY file does not say its own shape; give both the samples of a row and the A/D bits";
  const char* unknown = hints.columns == 0 && hints.bits == 0
                            ? "neither the samples of a row nor the A/D bits are known"
                        : hints.columns == 0 ? "the number of samples of a row is not known"
                        : hints.bits == 0    ? "the number of A/D bits is not known"
                                             : nullptr;
  if (unknown != nullptr) problems.push_back(file_problem(name, unknown, {}, {}, hint));
  if (hints.bits < 0 || hints.bits > 64)
    problems.push_back(
        file_problem(name, "the number of A/D bits is out of range", fmt::format("{}", hints.bits), "1 to 64"));
  return problems;
}

core::Problem wrong_type(const std::string& name, const NpyHeader& header) {
  if (header.type.starts_with('>'))
    return file_problem(name, "the array is big-endian", header.type, npy_sample_types(),
                        "store it with array.astype(array.dtype.newbyteorder('<'))");
  return file_problem(name, "the array's type is not one of samples", header.type, npy_sample_types());
}

core::Problems rows_problem(const std::string& name, std::uint64_t rows, const SampleFileHints& hints) {
  if (hints.rows == 0 || hints.rows == rows) return {};
  return {file_problem(name, "the file has another number of rows", fmt::format("{}", rows),
                       fmt::format("{}", hints.rows))};
}

}  // namespace

OpenedReader open_binary(core::InputFile file, const SampleFileHints& hints) {
  const std::string name = file.path().string();
  OpenedReader result{nullptr, binary_hint_problems(name, hints)};
  if (core::has_errors(result.problems)) return result;
  const CountRange range{hints.bits};
  const auto row_bytes = checked_product(hints.columns, 2, range.component_bytes());
  if (file.size() == 0 || !row_bytes || file.size() % *row_bytes != 0) {
    result.problems.push_back(
        file_problem(name, file.size() == 0 ? "the file is empty" : "the file does not hold a whole number of rows",
                     fmt::format("{} bytes", file.size()),
                     fmt::format("a multiple of {} samples x 2 x {} bytes", hints.columns, range.component_bytes()),
                     "check the samples of a row and the A/D bits; the file may be cut off"));
    return result;
  }
  SampleFileInfo info;
  info.rows = static_cast<std::size_t>(file.size() / *row_bytes);
  info.columns = hints.columns;
  info.bits = hints.bits;
  info.lsb_v = known(hints.lsb_v);
  result.problems = rows_problem(name, info.rows, hints);
  if (core::has_errors(result.problems)) return result;
  if (auto strange = strange_values(file, range)) result.problems.push_back(std::move(*strange));
  result.reader = make_array_reader(std::move(file), info, 0, range.component_bytes(), BinaryDecoder{range});
  return result;
}

OpenedReader open_npy(core::InputFile file, const SampleFileHints& hints) {
  const std::string name = file.path().string();
  auto parsed = read_npy_header(file);
  if (auto* problem = std::get_if<core::Problem>(&parsed)) {
    problem->place.file = name;
    return {nullptr, {std::move(*problem)}};
  }
  const NpyHeader& header = std::get<NpyHeader>(parsed);
  if (header.fortran_order)
    return {nullptr,
            {file_problem(name, "the array is in Fortran order", "fortran_order: True", "fortran_order: False",
                          "store it with numpy.ascontiguousarray(array)")}};
  const NpyType* const type = npy_sample_type_of(header);
  if (type == nullptr) return {nullptr, {wrong_type(name, header)}};
  const auto shape = npy_plane_of(header, *type);
  const bool samples = shape && shape->value == ImageValue::complex;
  const auto bytes = samples ? checked_product(shape->rows, shape->columns, 2 * type->bytes) : std::nullopt;
  if (!bytes || *bytes == 0)
    return {nullptr,
            {file_problem(name, "the array's shape is not one of samples", shape_text(header.shape),
                          type->pair ? "(rows, columns)" : "(rows, columns, 2)")}};
  const std::uint64_t present = file.size() - std::min<std::uint64_t>(file.size(), header.data_offset);
  if (present < *bytes)
    return {nullptr,
            {file_problem(name, "the file ends within the array", fmt::format("{} bytes", present),
                          fmt::format("{} bytes for the shape {}", *bytes, shape_text(header.shape)),
                          "the file is cut off")}};
  OpenedReader result{nullptr, rows_problem(name, shape->rows, hints)};
  if (core::has_errors(result.problems)) return result;
  if (present > *bytes)
    result.problems.push_back(with_severity(
        file_problem(name, "what follows the array is not read", fmt::format("{} bytes more", present - *bytes)),
        core::Severity::warning));
  SampleFileInfo info;
  info.rows = static_cast<std::size_t>(shape->rows);
  info.columns = static_cast<std::size_t>(shape->columns);
  info.counts = type->counts;
  info.bits = type->counts ? std::max(hints.bits, 0) : 0;
  info.lsb_v = known(hints.lsb_v);
  info.attributes = {{"descr", header.type}};
  result.reader = make_array_reader(std::move(file), info, header.data_offset, type->bytes, type->component);
  return result;
}

}  // namespace sarsim::raster
