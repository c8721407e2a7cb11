#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "core/task/progress.hpp"
#include "core/task/stop.hpp"
#include "radar/receiver/converter.hpp"
#include "simulate/plan/plan.hpp"
#include "simulate/plan/sink.hpp"
#include "simulate/run/memory_sink.hpp"

namespace sarsim::simulate {

/// How a run is carried out; nothing here can change a byte of the result.
struct RunControl {
  unsigned threads = 0;                  ///< 0: one per core.
  const core::StopFlag* stop = nullptr;  ///< Asked now and then; a requested stop throws Interrupted.
  core::ProgressReport progress;         ///< May be empty.
};

/// Least significant bit that the plan's converter uses: the one given, or, where that is 0, the largest magnitude of
/// the whole recording over 2^(bits-1) - 1, for which every row is computed once (decision 24). A silent recording
/// gives 1 V.
[[nodiscard]] double resolved_lsb_v(const Plan& plan, const RunControl& control);

/// The LSB that just holds a magnitude: maximum_v / (2^(bits-1) - 1), 1 V for silence.
[[nodiscard]] double lsb_of_maximum_v(double maximum_v, int bits);

/// Computes every row of a plan and hands it to the sink in order; then finishes the sink.
///
/// Blocks of rows are computed and encoded on all threads while the calling thread passes finished ones on. The bytes
/// do not depend on the number of threads, and memory does not grow with the number of rows.
///
/// @param lsb_v  what `resolved_lsb_v` gave; 0 only for a sink that wants no counts: then the report's LSB is the best
/// one.
RunReport run(const Plan& plan, double lsb_v, Sink& sink, const RunControl& control);

/// Size of a recording and bits of its converter.
struct Recorded {
  std::size_t rows = 0;
  std::size_t columns = 0;
  int bits = 8;
};

/// Consecutive rows of a recording.
struct RowRange {
  std::size_t first = 0;
  std::size_t count = 0;

  [[nodiscard]] std::size_t end() const { return first + count; }
  friend bool operator==(const RowRange&, const RowRange&) = default;
};

/// Rows as their file holds them, and what their conversion met.
struct EncodedRows {
  RowRange rows;
  std::vector<std::byte> bytes;
  radar::ConversionTally tally;
};

/// Computes some rows of a plan and hands them over, a few at a time and in order, on the calling thread. The bytes and
/// the sum of the tallies do not depend on how a recording is divided among calls, processes or machines.
///
/// @param rows     within [0, plan.acquisition.timing.rows)
/// @param lsb_v    see `run`; 0 for an encoder that wants no counts
/// @param encoder  only its `encode` and `wants_counts` are used
void run_rows(const Plan& plan, RowRange rows, double lsb_v, const Sink& encoder, const RunControl& control,
              const std::function<void(const EncodedRows&)>& take);

/// The report of a whole recording, from what the conversion of all its rows met.
/// @param lsb_v  see `run`
[[nodiscard]] RunReport report_of(const Recorded& recorded, double lsb_v, const radar::ConversionTally& tally);

/// Reads the volts of a row that was computed before; each thread has its own.
using RowReader = std::function<void(std::size_t row, std::span<std::complex<double>> volts)>;

/// The second half of `run`: converts and encodes rows that were computed before, hands them to the sink in order and
/// finishes it.
/// @param make_reader  called once on each thread
RunReport run_stored(const Recorded& recorded, const std::function<RowReader()>& make_reader, double lsb_v, Sink& sink,
                     const RunControl& control);

/// Runs a plan into memory, unconverted.
[[nodiscard]] Recording record(const Plan& plan, const RunControl& control = {});

}  // namespace sarsim::simulate
