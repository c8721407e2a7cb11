#pragma once

#include "base/progress.hpp"
#include "base/stop.hpp"
#include "simulate/memory_sink.hpp"
#include "simulate/plan.hpp"
#include "simulate/sink.hpp"

namespace sarsim {

/// How a run is carried out; nothing here can change a byte of the result.
struct RunControl {
  unsigned threads = 0;            ///< 0: one per core.
  const StopFlag* stop = nullptr;  ///< Asked now and then; a requested stop throws Interrupted.
  ProgressReport progress;         ///< May be empty.
};

/// Least significant bit that the plan's converter uses: the one given, or, where that is 0, the largest magnitude of
/// the whole recording over 2^(bits-1) - 1, for which every row is computed once (decision 24). A silent recording
/// gives 1 V.
[[nodiscard]] double resolved_lsb_v(const Plan& plan, const RunControl& control);

/// Computes every row of a plan and hands it to the sink in order; then finishes the sink.
///
/// Blocks of rows are computed and encoded on all threads while the calling thread passes finished ones on. The bytes
/// do not depend on the number of threads, and memory does not grow with the number of rows.
///
/// @param lsb_v  what `resolved_lsb_v` gave; 0 only for a sink that wants no counts: then the report's LSB is the best
/// one.
RunReport run(const Plan& plan, double lsb_v, Sink& sink, const RunControl& control);

/// Runs a plan into memory, unconverted.
[[nodiscard]] Recording record(const Plan& plan, const RunControl& control = {});

}  // namespace sarsim
