#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include <fmt/format.h>

#include "raster/format/format_reader.hpp"
#include "raster/format/grid_raster.hpp"
#include "raster/table/count_range.hpp"
#include "raster/table/file_problem.hpp"

namespace sarsim::raster {

namespace {

template <class Real, std::size_t Bytes>
void decode_counts(const StoredGrid& grid, const std::byte* first, std::size_t stride, std::size_t count,
                   std::complex<Real>* out) {
  const auto value = [&](const std::byte* bytes) {
    std::uint64_t stored = 0;
    std::memcpy(&stored, bytes, Bytes);
    return static_cast<Real>(std::bit_cast<std::int64_t>(stored - grid.count_offset));
  };
  for (std::size_t i = 0; i < count; ++i, first += stride) out[i] = {value(first), value(first + Bytes)};
}

template <std::size_t Bytes>
constexpr StoredGrid::Decoder count_decoder{decode_counts<float, Bytes>, decode_counts<double, Bytes>};

constexpr std::array<StoredGrid::Decoder, 8> count_decoders{count_decoder<1>, count_decoder<2>, count_decoder<3>,
                                                            count_decoder<4>, count_decoder<5>, count_decoder<6>,
                                                            count_decoder<7>, count_decoder<8>};

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

core::Problems binary_hint_problems(const std::string& name, const RasterHints& hints) {
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

// What is wrong with a whole file.
core::Problems whole_problems(const core::InputFile& file, const RasterHints& hints) {
  const std::string name = file.path().string();
  core::Problems problems = binary_hint_problems(name, hints);
  if (core::has_errors(problems)) return problems;
  const CountRange range{hints.bits};
  const auto row_bytes = checked_product(hints.columns, 2, range.component_bytes());
  if (!row_bytes || file.size() % *row_bytes != 0)
    return {file_problem(name, "the file does not hold a whole number of rows", fmt::format("{} bytes", file.size()),
                         fmt::format("a multiple of {} samples x 2 x {} bytes", hints.columns, range.component_bytes()),
                         "check the samples of a row and the A/D bits; the file may be cut off")};
  if (const std::uint64_t rows = file.size() / *row_bytes; hints.rows > 0 && hints.rows != rows)
    return {file_problem(name, "the file has another number of rows", fmt::format("{}", rows),
                         fmt::format("{}", hints.rows))};
  if (auto strange = strange_values(file, range)) problems.push_back(std::move(*strange));
  return problems;
}

// What is wrong with a file that may be cut off or still growing.
core::Problems partial_problems(const core::InputFile& file, const RasterHints& hints) {
  const std::string name = file.path().string();
  if (hints.columns == 0 || hints.bits < 1 || hints.bits > 64)
    return {file_problem(name, "a BINARY file does not say its own shape",
                         fmt::format("{} samples of a row, {} A/D bits", hints.columns, hints.bits),
                         "the samples of a row and 1 to 64 A/D bits",
                         "name the script that made it, or describe it as a custom file")};
  const std::size_t component = CountRange{hints.bits}.component_bytes();
  const auto row = checked_product(hints.columns, 2, component);
  if (!row || *row > file.size())
    return {file_problem(name, "the file does not hold a single row", fmt::format("{} bytes", file.size()),
                         fmt::format("{} samples x 2 x {} bytes", hints.columns, component),
                         "check the samples of a row and the A/D bits")};
  core::Problems problems;
  if (file.size() % *row != 0)
    problems.push_back(with_severity(
        file_problem(name, "the file does not hold a whole number of rows", fmt::format("{} bytes", file.size()),
                     fmt::format("a multiple of {} bytes", *row),
                     "check the samples of a row and the A/D bits; the file may be cut off or still growing"),
        core::Severity::warning));
  if (hints.rows > 0 && file.size() / *row != hints.rows)
    problems.push_back(with_severity(file_problem(name, "the file has another number of rows",
                                                  fmt::format("{}", file.size() / *row), fmt::format("{}", hints.rows)),
                                     core::Severity::warning));
  return problems;
}

}  // namespace

OpenedRaster open_binary(core::InputFile file, const Format&, const RasterHints& hints, Integrity integrity,
                         const core::StopFlag*) {
  core::Problems problems = integrity == Integrity::whole ? whole_problems(file, hints) : partial_problems(file, hints);
  if (core::has_errors(problems)) return {nullptr, std::move(problems)};
  const CountRange range{hints.bits};
  StoredGrid grid;
  grid.columns = hints.columns;
  grid.sample_bytes = 2 * range.component_bytes();
  grid.decode = count_decoders[range.component_bytes() - 1];
  grid.count_offset = range.offset();
  RasterInfo info = info_of(file, hints.columns, hints);
  info.counts = true;
  info.bits = hints.bits;
  return {make_grid_raster(std::move(info), std::move(file), grid, any_rows), std::move(problems)};
}

StoredArrays arrays_of_binary(const core::InputFile& file, const RasterHints& hints) {
  const CountRange range{hints.bits};
  const std::size_t bytes = range.component_bytes();
  if (!std::has_single_bit(bytes))
    return file_problem({}, "counts of this width are no numbers that programs have in memory",
                        fmt::format("{} bits in {} bytes", hints.bits, bytes), "1, 2, 4 or 8 bytes",
                        "convert the file to .npy, .h5 or .zarr");
  StoredArray samples{.name = "samples",
                      .type = bytes == 1 ? std::string("|u1") : fmt::format("<u{}", bytes),
                      .item_bytes = bytes,
                      .shape = {file.size() / (2 * hints.columns * bytes), hints.columns, 2},
                      .dimensions = {"pulse", "sample", "iq"}};
  samples.facts = {{"units", "count"},
                   {"long_name", "complex envelope"},
                   {"scale_factor", 1.0},
                   {"add_offset", -static_cast<double>(range.offset())}};
  return std::vector{std::move(samples), pair_names()};
}

}  // namespace sarsim::raster
