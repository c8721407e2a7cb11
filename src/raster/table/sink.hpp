#pragma once

#include <complex>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "raster/table/product.hpp"

namespace sarsim::raster {

/// Consecutive rows of a recording.
struct RowRange {
  std::size_t first = 0;
  std::size_t count = 0;

  [[nodiscard]] std::size_t end() const { return first + count; }
  friend bool operator==(const RowRange&, const RowRange&) = default;
};

/// Some consecutive rows of a recording. I before Q, rows one after the other.
struct Block {
  std::size_t first_row = 0;
  std::size_t rows = 0;
  std::size_t columns = 0;
  std::span<const std::complex<double>> volts;  ///< rows * columns.
  std::span<const std::int64_t> counts;  ///< 2 * rows * columns signed counts, or empty where the sink wants none.
};

/// What the original printed after a run, in SI units.
struct RunReport {
  std::size_t rows = 0;
  std::size_t columns = 0;
  double seconds = 0.0;
  double maximum_v = 0.0;  ///< Largest magnitude.
  double lsb_v = 0.0;
  double best_lsb_v = 0.0;        ///< maximum_v / (2^(bits-1) - 1).
  double range_used = 0.0;        ///< maximum_v / (lsb_v (2^(bits-1) - 1)).
  std::uint64_t saturated = 0;    ///< Samples whose I or Q was clipped.
  std::uint64_t zero = 0;         ///< Samples whose counts are both 0.
  std::uint64_t not_numbers = 0;  ///< Samples of an input whose I or Q is no number (NaN) and became count 0.
};

/// Where the rows of a recording go. `encode` may run on many threads at once; `append` is called from one thread,
/// in row order; the product appears under its name only with `finish`. Destroyed before, a sink leaves nothing behind.
/// Failures of the disk are std::system_error or std::runtime_error with the file's name.
class Sink {
 public:
  Sink() = default;
  Sink(const Sink&) = delete;
  Sink& operator=(const Sink&) = delete;
  virtual ~Sink() = default;

  /// Whether blocks must carry counts (A/D converted) rather than volts.
  [[nodiscard]] virtual bool wants_counts() const = 0;
  /// The bytes of a block as the file will hold them.
  [[nodiscard]] virtual std::vector<std::byte> encode(const Block& block) const = 0;
  /// Takes the encoded rows [first_row, first_row + rows).
  virtual void append(std::span<const std::byte> bytes, std::size_t first_row, std::size_t rows) = 0;
  /// Completes the product with what is only known at the end.
  virtual void finish(const RunReport& report) = 0;
};

}  // namespace sarsim::raster
