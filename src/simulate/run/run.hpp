#pragma once

#include <functional>

#include "raster/table/encode_rows.hpp"
#include "simulate/plan/plan.hpp"
#include "simulate/run/memory_sink.hpp"

namespace sarsim::simulate {

/// Least significant bit that the plan's converter uses: the one given, or, where that is 0, the largest magnitude of
/// the whole recording over 2^(bits-1) - 1, for which every row is computed once (decision 24). A silent recording
/// gives 1 V.
[[nodiscard]] double resolved_lsb_v(const Plan& plan, const raster::RunControl& control);

/// Computes every row of a plan and hands it to the sink in order; then finishes the sink.
///
/// Blocks of rows are computed and encoded on all threads while the calling thread passes finished ones on. The bytes
/// do not depend on the number of threads, and memory does not grow with the number of rows.
///
/// @param lsb_v  what `resolved_lsb_v` gave; 0 only for a sink that wants no counts: then the report's LSB is the best
/// one.
raster::RunReport run(const Plan& plan, double lsb_v, raster::Sink& sink, const raster::RunControl& control);

/// Computes some rows of a plan and hands them over, a few at a time and in order, on the calling thread. The bytes and
/// the sum of the tallies do not depend on how a recording is divided among calls, processes or machines.
///
/// @param rows     within [0, plan.acquisition.timing.rows)
/// @param lsb_v    see `run`; 0 for an encoder that wants no counts
/// @param encoder  only its `encode` and `wants_counts` are used
void run_rows(const Plan& plan, raster::RowRange rows, double lsb_v, const raster::Sink& encoder,
              const raster::RunControl& control, const std::function<void(const raster::EncodedRows&)>& take);

/// Runs a plan into memory, unconverted.
[[nodiscard]] Recording record(const Plan& plan, const raster::RunControl& control = {});

}  // namespace sarsim::simulate
