#pragma once

#include <complex>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "core/task/parallel.hpp"
#include "core/task/stop.hpp"
#include "simulate/plan/plan.hpp"
#include "simulate/plan/row_maker.hpp"

namespace sarsim::simulate {

/// Consecutive rows or columns of a recording: begin, ..., end - 1; at least one.
struct IndexSpan {
  std::size_t begin = 0;
  std::size_t end = 1;

  friend bool operator==(const IndexSpan&, const IndexSpan&) = default;
};

/// Which samples of a recording are wanted: element (i, k) of what comes of it stands for the samples of rows[i] times
/// columns[k] and is always one of them.
struct SampleSelection {
  enum class Pick {
    first,  ///< That of the first row and column.
    peak,   ///< The one of the largest magnitude; of equal ones the first.
  };
  std::vector<IndexSpan> rows;     ///< Of the plan's product.
  std::vector<IndexSpan> columns;  ///< Of the plan's product.
  Pick pick = Pick::first;

  friend bool operator==(const SampleSelection&, const SampleSelection&) = default;
};

/// Computes rows of a selection; each thread has its own. The samples are those that `RowMaker` gives for the same
/// plan, bit for bit.
class SampledRowMaker {
 public:
  /// Keeps references.
  /// @param stop  asked before every row of the recording; a requested stop throws Interrupted
  SampledRowMaker(const Plan& plan, const SampleSelection& selection, const core::StopFlag* stop = nullptr);

  /// @param[out] out  as many samples as the selection has columns, in volts
  void make_row(std::size_t row, std::span<std::complex<double>> out);

 private:
  void pick_firsts(std::span<std::complex<double>> out) const;
  void raise_to_peaks(std::span<std::complex<double>> out) const;

  const Plan* plan_;
  const SampleSelection* selection_;
  const core::StopFlag* stop_;
  RowMaker rows_;
  std::vector<std::complex<double>> row_;
};

/// 0 ... count - 1 in the order of their bits reversed: 0, the middle, the quarters ... Neighbours among the first n of
/// them are at most 4 count/n apart.
[[nodiscard]] std::vector<std::size_t> refinement_order(std::size_t count);

/// Computes rows of a selection in a given order on several threads of which the calling one is one.
/// @param out      all rows of the selection, one after the other; only those in `order` are written
/// @param on_row   told about each row when it is complete, on the thread that computed it; may be called from several
///                 at once
/// What a thread throws ends the others and is thrown to the caller; a requested stop throws Interrupted within the
/// time of one row of the recording.
void compute_sampled_rows(const Plan& plan, const SampleSelection& selection, std::span<const std::size_t> order,
                          const core::WorkControl& control, std::span<std::complex<double>> out,
                          const std::function<void(std::size_t row)>& on_row);

}  // namespace sarsim::simulate
