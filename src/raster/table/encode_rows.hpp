#pragma once

#include <complex>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "core/task/progress.hpp"
#include "core/task/stop.hpp"
#include "radar/echo/reference_kernel.hpp"
#include "radar/receiver/converter.hpp"
#include "raster/table/sink.hpp"

namespace sarsim::raster {

/// How a run is carried out; nothing here can change a byte of the result.
struct RunControl {
  unsigned threads = 0;                  ///< 0: one per core.
  const core::StopFlag* stop = nullptr;  ///< Asked now and then; a requested stop throws Interrupted.
  core::ProgressReport progress;         ///< May be empty.
};

/// The LSB that just holds a magnitude: maximum_v / (2^(bits-1) - 1), 1 V for silence.
[[nodiscard]] double lsb_of_maximum_v(double maximum_v, int bits);

/// Size of a recording and bits of its converter.
struct Recorded {
  std::size_t rows = 0;
  std::size_t columns = 0;
  int bits = 8;
};

/// Rows as their file holds them, and what their conversion met.
struct EncodedRows {
  RowRange rows;
  std::vector<std::byte> bytes;
  radar::ConversionTally tally;
};

/// Makes a row: fills `volts` and returns where it is not 0. `stale` is where the row before was not 0.
using RowFill = std::function<radar::SampleSpan(std::size_t row, std::span<std::complex<double>> volts,
                                                const radar::SampleSpan& stale)>;

/// How rows come to be: called once on each thread.
using RowSource = std::function<RowFill()>;

/// Makes, converts and encodes some rows on all threads and hands them over, a few at a time and in order, on the
/// calling thread. A sample that no file may hold throws std::overflow_error.
/// @param lsb_v    0: nothing is converted
/// @param encoder  only its `encode` and `wants_counts` are used; null: nothing is encoded
void encode_rows(const Recorded& recorded, RowRange rows, double lsb_v, const Sink* encoder, const RunControl& control,
                 const RowSource& source, const std::function<void(const EncodedRows&)>& take);

/// The same of all rows, which go to the sink; then finishes the sink.
RunReport encode_all(const Recorded& recorded, double lsb_v, Sink& sink, const RunControl& control,
                     const RowSource& source);

/// The report of a whole recording, from what the conversion of all its rows met.
/// @param lsb_v  that of the conversion; 0: the best one
[[nodiscard]] RunReport report_of(const Recorded& recorded, double lsb_v, const radar::ConversionTally& tally);

/// Reads the volts of a row that was computed before; each thread has its own.
using RowReader = std::function<void(std::size_t row, std::span<std::complex<double>> volts)>;

/// Converts and encodes rows that were computed before, hands them to the sink in order and
/// finishes it.
/// @param lsb_v        0 only for a sink that wants no counts
/// @param make_reader  called once on each thread
RunReport run_stored(const Recorded& recorded, const std::function<RowReader()>& make_reader, double lsb_v, Sink& sink,
                     const RunControl& control);

}  // namespace sarsim::raster
