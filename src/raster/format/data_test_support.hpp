#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>
#include <filesystem>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "raster/format/open_raster.hpp"
#include "raster/format/sinks.hpp"
#include "raster/table/count_range.hpp"
#include "support/test_folder.hpp"

namespace sarsim::raster::data_test {

namespace fs = std::filesystem;

using test::contents;
using test::put;
using test::SmallDisk;
using test::TestFolder;

inline std::string text_of(const std::vector<std::byte>& bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// A product with recognisable axes.
inline Product test_product(std::size_t rows, std::size_t columns, int bits) {
  Product product;
  product.radar = "Radar1";
  product.rows = rows;
  product.columns = columns;
  product.row_time_s = [](std::size_t row) { return 0.5 + 0.001 * static_cast<double>(row); };
  product.row_carrier_hz = [](std::size_t row) { return 1e9 + 1e6 * static_cast<double>(row); };
  product.row_pose = [](std::size_t row) {
    const auto x = static_cast<double>(row);
    return RowPose{{100.0 * x, -0.5, 3.0}, {100.0, 0.25, x}, {0.125, 0.0, -x}};
  };
  product.column_range_m = [](std::size_t column) { return 1000.0 + 1.5 * static_cast<double>(column); };
  product.sample_rate_hz = 100e6;
  product.bits = bits;
  product.options.seed = 18446744073709551615U;
  product.script = "$SIMULATION\nRadar1 ! Name of radar\n";
  return product;
}

/// Counts over the whole range of the converter, its ends and 0 first; fixed seed.
inline std::vector<std::int64_t> test_counts(std::size_t samples, int bits) {
  const CountRange range{bits};
  std::mt19937_64 random(static_cast<std::uint64_t>(bits));
  std::uniform_int_distribution<std::int64_t> any(range.lowest(), range.highest());
  std::vector<std::int64_t> counts{range.lowest(), range.highest(), 0, -1, 1, 0};
  while (counts.size() < 2 * samples) counts.push_back(any(random));
  counts.resize(2 * samples);
  return counts;
}

/// The same as volts that float32 holds exactly.
inline std::vector<std::complex<double>> test_volts(std::size_t samples) {
  std::vector<std::complex<double>> volts(samples);
  for (std::size_t i = 0; i < samples; ++i)
    volts[i] = {std::ldexp(static_cast<double>(i) - 3.0, -20), -std::ldexp(static_cast<double>(i % 17), -10)};
  return volts;
}

/// Writes rows in blocks of changing sizes, without finishing.
inline void append_all(Sink& sink, const Product& product, const std::vector<std::int64_t>& counts,
                       const std::vector<std::complex<double>>& volts) {
  std::size_t size = 1;
  for (std::size_t first = 0; first < product.rows; first += size, size = size % 3 + 1) {
    size = std::min(size, product.rows - first);
    Block block;
    block.first_row = first;
    block.rows = size;
    block.columns = product.columns;
    if (sink.wants_counts())
      block.counts = std::span(counts).subspan(2 * first * product.columns, 2 * size * product.columns);
    else
      block.volts = std::span(volts).subspan(first * product.columns, size * product.columns);
    sink.append(sink.encode(block), first, size);
  }
}

/// Writes a whole file of `test_counts` and `test_volts`.
inline void write_test_file(const fs::path& path, const Product& product, const SinkOptions& options) {
  const std::size_t samples = product.rows * product.columns;
  const auto sink = make_sink(path, product, options);
  append_all(*sink, product, test_counts(samples, product.bits), test_volts(samples));
  RunReport report;
  report.lsb_v = 2.5e-9;
  sink->finish(report);
}

/// All samples of a raster, as exactly as it has them.
inline std::vector<std::complex<double>> read_all_rows(const Raster& raster) {
  std::vector<std::complex<double>> samples(raster.rows() * raster.columns());
  raster.read_rows(0, raster.rows(), samples);
  return samples;
}

/// All messages of a list of problems, for failing tests and for looking into them.
inline std::string text_of(const core::Problems& problems) {
  std::string text;
  for (const core::Problem& problem : problems) text += core::to_string(problem) + "\n";
  return text;
}

}  // namespace sarsim::raster::data_test
